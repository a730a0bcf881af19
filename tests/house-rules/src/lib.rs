//! The structure of this project: what its tests (`tests/project.rs`) hold the code to.
//!
//! - [`circles`]: no circle between the modules of a crate. A module uses another one if it names what the other *defines*;
//!   a facade (`pub use tree::Tree`) is not used by those who name what it passes on.
//! - [`floors`]: the one table of crates from low to high; a crate depends only on crates on lower floors.
//! - [`texts`]: no option's name (`--mass`) and no file, process or stream of the system where they do not belong.
//! - [`words`]: the words that messages, doc comments and docs must not use.
//! - [`book`]: how long the sentences of a page are.
//! - [`sizes`]: what has grown large, as places to look; nothing fails.
//!
//! The code is read as tokens ([`tokens`], [`module`]), not parsed: nothing is expanded, a method that is called on a value names no
//! module, `use a::*` uses all that `a` passes on, and code that only tests compile is not looked at. Printing, unsafe code, panics and reading past the door are
//! left to clippy (`Cargo.toml`, `clippy.toml`), links of documentation to rustdoc, licences and sources to cargo-deny.

pub mod book;
pub mod circles;
pub mod floors;
pub mod module;
pub mod project;
pub mod sizes;
pub mod texts;
pub mod tokens;
pub mod words;
