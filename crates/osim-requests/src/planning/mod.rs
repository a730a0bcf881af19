//! What each changing verb plans for a model.

mod design;
mod operation;
mod reference;
mod rescale;
mod set;
mod transfer;
