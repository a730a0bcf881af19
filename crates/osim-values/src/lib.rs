//! Values that people give: read strictly, from words and from JSON alike.
//!
//! # What it will not do
//!
//! It knows no options, no files and no terminal: who asked for a value says so in its own words.

#![cfg_attr(not(test), deny(clippy::disallowed_methods))]

mod assignment;
pub mod axis;
mod body_map;
pub mod body_scale;
pub mod contact_table;
pub mod grid;
mod height;
mod new_radius;
mod onset;
pub mod path;
pub mod property_list;
mod quantity;
mod radius;
pub mod serial;
mod shard;
pub mod sheet;
mod span;
pub mod typed;
mod whole;

pub use assignment::{Assignments, assignment};
pub use axis::{Axis, AxisName, GridValue};
pub use body_map::BodyMap;
pub use body_scale::BodyScale;
pub use grid::Grid;
pub use height::Height;
pub use new_radius::NewRadius;
pub use onset::ContactOnset;
pub use quantity::{
    Acceleration, ConstantIndentation, Count, FigureWidth, FontSize, Kilograms, Metres, NotNegative,
    PoissonRatio, Positive, RelativeIndentation, RestitutionCoefficient, Threshold,
};
pub use radius::Radius;
pub use shard::Shard;
pub use span::Span;
pub use whole::{Dpi, Samples, SpheresOfFoot};

/// The example of the README compiles.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
