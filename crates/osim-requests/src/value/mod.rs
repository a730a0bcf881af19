//! Values of options: read strictly, from words and from JSON alike.

mod assignment;
pub(crate) mod axis;
pub(crate) mod body_scale;
pub(crate) mod choice;
pub(crate) mod grid;
mod height;
mod onset;
pub(crate) mod path;
pub(crate) mod property_list;
mod quantity;
mod radius;
pub(crate) mod serial;
mod shard;
mod whole;

pub use assignment::{Assignments, assignment};
pub use axis::{Axis, AxisName, GridValue};
pub use body_scale::BodyScale;
pub use grid::Grid;
pub use height::Height;
pub use onset::ContactOnset;
pub use quantity::{
    Acceleration, ConstantIndentation, Count, Kilograms, NotNegative, PoissonRatio, Positive,
    RelativeIndentation, RestitutionCoefficient, Threshold,
};
pub use radius::Radius;
pub use shard::Shard;
pub use whole::{Dpi, Samples};
