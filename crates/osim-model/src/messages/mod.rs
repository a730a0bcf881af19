//! Messages that name inputs and calls as data, without the words of any front end.
//!
//! A message often ends in a way out: "say what the model weighs with …". Then follows `--mass KG` on the command
//! line, `mass=` in Python and a field on a page. So a [`Phrase`] keeps the [`Input`] as data, and each front end spells
//! it by its own [`Dialect`].
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
mod phrase;
mod printable;

pub use crate::phrase;
pub use input::{Call, Example, Input, Part, Verb};
pub use phrase::{Dialect, FieldNames, IntoParts, Phrase};
pub use printable::{
    Shown, counted, four_significant, is_visible, listed, one_line, readable, shortest, shown, shown_path,
    shown_whole, terminal_safe, three_significant,
};
