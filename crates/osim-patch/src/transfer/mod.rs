//! Transfers the contacts of a reference to a model of another size.

mod contact_choice;
mod plan;
mod reference;

pub use plan::transfer;
pub use reference::{
    Reference, ReferenceContact, ScalingRule, Transfer, reference_of_layout, reference_of_model,
};
