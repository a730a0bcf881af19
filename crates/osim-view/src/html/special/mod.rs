//! What is special about the models of a library: the numbers that say it, and the models that a page draws for it.

mod chosen;
mod facts;

pub(crate) use chosen::{Chosen, Drawn, MOST};
pub(crate) use facts::{Facts, Indentation, deepest, is_too_deep};
