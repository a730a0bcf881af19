//! What each changing verb plans for a model.

mod any;
mod asking;
mod design;
mod operation;
mod reference;
mod rescale;
mod set;
mod transfer;
