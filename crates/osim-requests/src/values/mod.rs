//! Values that people give: read strictly, from words and from JSON alike.
//!
//! # What it will not do
//!
//! It knows no options, no files and no terminal: who asked for a value says so in its own words.

pub mod assignment;
pub mod bodies;
pub mod grid;
mod lengths;
pub mod path;
mod quantity;
pub mod serial;
pub(crate) mod shard;
pub mod typed;

pub use assignment::{Assignments, assignment};
pub use bodies::{BodyMap, BodyScale};
pub use grid::{Axis, AxisName, Grid, GridValue, Span};
pub use lengths::{ContactOnset, DropHeight, Height, NewRadius, Radius};
pub use quantity::{
    Acceleration, ConstantIndentation, Count, Dpi, FigureWidth, FontSize, Jobs, Kilograms, Metres,
    NotNegative, PoissonRatio, Positive, RelativeIndentation, RestitutionCoefficient, Samples, Speed,
    SpheresOfFoot, Steps, Threshold,
};
pub use shard::Shard;
