//! Everything that is known of a model, as one struct.

mod build;
mod changed_since;
mod data;
mod note_story;
mod standing;
mod standing_words;

pub use data::{
    ContactsMass, Dimensionless, FactorsBySource, InspectedBody, InspectedFactors, InspectedForce,
    InspectedLimb, InspectedSphere, Inspection, Origins, Parameters,
};
pub(crate) use note_story::step_in_words;
pub use note_story::{NoteStep, NoteStory};
pub use standing::{Bottom, OnFeet, StandingBody, StandingSphere};
