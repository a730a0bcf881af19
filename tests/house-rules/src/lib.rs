//! Rules for the structure of this project, which `tests/project.rs` applies to the code.
//!
//! - [`circles`]: no circle between the modules of a crate. A module uses another module if it names an item that the other module
//!   *defines*. Naming an item that a facade only passes on (`pub use tree::Tree`) is not a use of the facade.
//! - [`floors`]: the one table of crates from low to high; a crate depends only on crates on lower floors.
//! - [`texts`]: no option's name (`--mass`) and no file, process or stream of the system where they do not belong.
//! - [`words`]: the words that messages, doc comments and docs must not use.
//!
//! [`source`] reads the code. Printing, unsafe code, panics and opening files elsewhere than in `file_access` are left to clippy (`Cargo.toml`, `clippy.toml`),
//! links of documentation to rustdoc, licences and sources to cargo-deny, sizes to `dev/sizes.py`.

pub mod circles;
pub mod floors;
pub mod source;
pub mod texts;
pub mod words;
