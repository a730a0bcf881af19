//! Holds the structure of a Cargo workspace by a test, so that nobody has to untangle it later.
//!
//! ```no_run
//! use std::path::Path;
//!
//! use house_rules::{Limits, Workspace};
//!
//! # fn main() -> Result<(), house_rules::Error> {
//! let workspace = Workspace::read(Path::new("../.."))?;
//! let circles = workspace.circles();
//! let upwards = workspace.arrows(&[&["equations"], &["files", "figures"], &["command"]]);
//! let too_large = workspace.too_large(&Limits::default());
//! let options = workspace.options_named(&["equations", "files"])?;
//! for circle in &circles {
//!     // Every finding says its file and line.
//!     let _ = format!("{circle}");
//! }
//! # let _ = (upwards, too_large, options);
//! # Ok(())
//! # }
//! ```
//!
//! # No circle between the modules of a crate
//!
//! A module uses another one if it names what the other one *defines*: by `use`, and by paths in expressions, types,
//! patterns, bounds, attributes and the tokens of macros. Who names what a facade passes on (`pub use tree::Tree`) uses
//! the module that defines it, however long the chain, and not the facade. The facade uses what it passes on. So
//!
//! - a `mod.rs` that only declares modules and passes on what is in them is never part of a circle;
//! - a `mod.rs` that defines what its children use, and uses or passes on those children, is one with them;
//! - `mod child;` alone uses nothing, nor does `pub(in crate::a)`, nor a link in documentation;
//! - a module that is imported (`use crate::a;`) is used where a path goes on from it (`a::f()`), so that a sibling can
//!   be reached through the parent;
//! - `use a::*` uses `a` if there is anything of its own to be seen, the traits in it, and each name where it stands;
//! - test code may use everything; code for another system counts as much as code for this one.
//!
//! The library and each program of a package are trees of their own, as they are to the compiler.
//!
//! # Between crates
//!
//! [`Workspace::arrows`] holds dependencies to layers, [`Workspace::banned`] keeps other crates and parts of the standard
//! library out of a crate, [`Workspace::options_named`] keeps options of the command line out of the texts of libraries.
//!
//! # Sizes
//!
//! [`Workspace::too_large`]: lines as an editor counts them. Of crates and folders, test code does not count.
//!
//! # Words
//!
//! [`Words`] is a list of words that texts must not use, each with what to write instead:
//! [`Workspace::forbidden`] looks for them in texts and doc comments, [`Words::in_prose`] in any text and
//! [`Words::in_schema`] in JSON Schemas.
//!
//! # What it cannot see
//!
//! It reads the source and expands nothing, so
//!
//! - a method that is called on a value names no module, nor does an implementation that is found by its trait. Fields
//!   and types that the compiler infers name nothing either;
//! - nothing is seen of what a macro of another crate makes, or a file that `include!` brings in. If a name is not found
//!   in the module that a path leads to, a macro is taken to have made it there;
//! - a `super::` in `macro_rules!` is looked up where the macro is defined, not where it is called;
//! - in the tokens of a macro, a lone name is only taken for an item if it begins with a capital or is called, and
//!   `"{NAME}"` in a text for none;
//! - in attributes, only texts with a key of serde are paths, and those that begin with `crate::`, `self::` or `super::`;
//! - what another crate defines makes no arrow, even where a module of this one passes it on;
//! - a `mod` in the call of a macro is not looked for, and the files of `build.rs`, tests, benchmarks and
//!   examples are not read.

mod error;
mod manifest;
mod package;
mod resolve;
mod rules;
mod syntax;
mod tree;
mod uses;
mod workspace;

pub use error::Error;
pub use rules::{
    Arrow, Ban, Banned, Circle, Example, Forbidden, LayerFault, Limits, Measured, OptionNamed, Size,
    TooLarge, Words,
};
pub use workspace::Workspace;
