//! Contacts of a reference, given the dimensions of another body.

mod choice;
mod plan;
mod predsim;
mod reference;
mod request;
mod several_sets;
mod similarity;

pub use plan::transfer;
pub use reference::{reference_of_layout, reference_of_model};
pub use request::{Reference, ReferenceContact, ScalingRule, Transfer};
