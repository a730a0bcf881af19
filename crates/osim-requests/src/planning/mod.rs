//! What each changing verb plans for a model.

mod adding;
pub(crate) mod any;
mod asking;
mod convert;
mod design;
mod following;
mod note;
mod operation;
mod reference;
mod remove;
mod rescale;
mod set;
mod transfer;
mod transferring;
mod useless;
