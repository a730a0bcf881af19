//! Everything that is known about a model, as one struct.

mod build;
mod inspected;
mod note;
mod standing;

pub use inspected::{
    ContactsMass, Dimensionless, InspectedBody, InspectedFactors, InspectedForce, InspectedLimb,
    InspectedSphere, Inspection,
};
pub(crate) use note::step_in_words;
pub use note::{NoteStep, NoteSummary};
pub use standing::{BodyAtRest, Bottom, StandingBody, StandingSphere};
