//! Everything that is known of a model, as one struct.

mod build;
mod data;

pub use data::{
    ContactsMass, Dimensionless, FactorsBySource, InspectedBody, InspectedFactors, InspectedForce,
    InspectedLimb, InspectedSphere, Inspection, Origins, Parameters,
};
