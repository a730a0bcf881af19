//! Values that people give: read strictly, from words and from JSON alike.
//!
//! # What it will not do
//!
//! It knows no options, no files and no terminal: who asked for a value says so in its own words.

mod assignment;
pub mod axis;
mod body_map;
pub mod body_scale;
mod drop_height;
pub mod grid;
mod height;
mod new_radius;
mod onset;
pub mod path;
pub(crate) mod point_number;
pub mod property_list;
mod quantity;
mod radius;
pub mod serial;
mod shard;
mod span;
pub mod typed;
mod whole;

pub use assignment::{Assignments, assignment};
pub use axis::{Axis, AxisName, GridValue};
pub use body_map::BodyMap;
pub use body_scale::BodyScale;
pub use drop_height::DropHeight;
pub use grid::Grid;
pub use height::Height;
pub use new_radius::NewRadius;
pub use onset::ContactOnset;
pub use quantity::{
    Acceleration, ConstantIndentation, Count, FigureWidth, FontSize, Kilograms, Metres, NotNegative,
    PoissonRatio, Positive, RelativeIndentation, RestitutionCoefficient, Speed, Threshold,
};
pub use radius::Radius;
pub use shard::Shard;
pub use span::Span;
pub use whole::{Dpi, Jobs, Samples, SpheresOfFoot, Steps};
