//! What each changing verb plans for a model.

pub(crate) mod any;
mod asking;
mod design;
mod following;
mod note;
mod operation;
mod reference;
mod rescale;
mod set;
mod transfer;
