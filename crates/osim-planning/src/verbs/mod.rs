//! What each changing verb plans for a model.

mod adding;
pub(crate) mod any;
mod convert;
pub(crate) mod design;
mod fitted_words;
pub(crate) mod fitting;
mod note;
mod reference;
mod remove;
pub(crate) mod rescale;
pub(crate) mod set;
mod transfer;
