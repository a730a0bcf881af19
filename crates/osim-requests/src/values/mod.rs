//! Values that users give: read strictly, and in the same way from texts and from JSON.
//!
//! # What it will not do
//!
//! This module knows no options, no files and no terminal; the caller adds the name of the option to a message.

pub mod assignment;
pub mod bodies;
pub mod grid;
mod lengths;
pub mod path;
mod quantity;
pub mod serial;
pub(crate) mod shard;
pub mod typed_numbers;

pub use assignment::{Assignments, assignment};
pub use bodies::{BodyMap, BodyScale};
pub use grid::{Axis, AxisName, Grid, GridValue, Span};
pub use lengths::{ContactOnset, DropHeight, NewRadius, Radius, UsualErrors};
pub use quantity::{
    Acceleration, ConstantIndentation, Count, Dpi, FigureWidth, FontSize, Jobs, Kilograms, Metres,
    NotNegative, PoissonRatio, Positive, RelativeIndentation, RestitutionCoefficient, Samples, Signed,
    SpheresOfFoot, Steps, Threshold,
};
pub use shard::Shard;
