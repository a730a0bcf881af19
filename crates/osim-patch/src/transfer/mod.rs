//! Contacts of a reference, given the dimensions of another body.

mod choice;
mod plan;
mod reference;

pub use plan::transfer;
pub use reference::{
    Reference, ReferenceContact, ScalingRule, Transfer, reference_of_layout, reference_of_model,
};
