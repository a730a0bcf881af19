//! Everything that is known of a model, as one struct.

mod build;
mod data;
mod standing;
mod standing_words;

pub use data::{
    ContactsMass, Dimensionless, FactorsBySource, InspectedBody, InspectedFactors, InspectedForce,
    InspectedLimb, InspectedSphere, Inspection, Origins, Parameters,
};
pub use standing::{Bottom, OnFeet, StandingBody, StandingSphere};
