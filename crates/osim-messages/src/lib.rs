//! Sentences about things that a caller can say, without the words of any front end.
//!
//! A message often ends in a way out: "say what the model weighs with …". What stands there is `--mass KG` on the command
//! line, `mass=` in Python and a field on a page. So a [`Phrase`] keeps the [`Input`] as data, and each front end spells
//! it by its own [`Dialect`].

#![cfg_attr(not(test), deny(clippy::disallowed_methods))]

mod dialect;
mod input;
mod listed;
mod number;
mod part;
mod phrase;
mod shown;

pub use dialect::{Dialect, Plain};
pub use input::{Input, Verb};
pub use listed::listed;
pub use number::{counted, four_significant, readable, shortest, three_significant};
pub use part::{Call, Example, Part};
pub use phrase::{IntoParts, Phrase};
pub use shown::{SHOWN_LETTERS, Shown, harmless, is_seen, one_line, shown, shown_path, shown_whole};
