//! Messages to the user. The inputs and calls in them are data, so that each front end can write them in its own way.
//!
//! Many messages end with advice, such as "give the mass of the model with …", followed by an input: `--mass KG` on the command line,
//! `mass=` in Python, a field on a web page. A [`Phrase`] therefore keeps the [`Input`] as data, and the [`Dialect`] of each front end
//! writes it.
//!
//! ```
//! use osim_model::messages::{Input, phrase, shown};
//!
//! fn main() {
//!     let name = "heel\u{1b}[2J";
//!     let message = phrase![format!("sphere {} has no radius, set one with ", shown(name)), Input::Radius.with_placeholder("METRES")];
//!     assert_eq!(message.to_string(), r"sphere heel\u{1b}[2J has no radius, set one with `radius`");
//! }
//! ```

mod input;
mod numbers;
mod phrase;
mod printable;

pub use crate::{named, phrase};
pub use input::{Call, Example, Input, PhrasePart, Verb};
pub use numbers::{counted, four_significant, four_significant_apart, readable, shortest, three_significant};
pub use phrase::{Dialect, FieldNames, IntoParts, PartInText, PartsInText, Phrase};
pub use printable::{Shown, is_visible, listed, one_line, shown, shown_path, shown_whole, terminal_safe};
