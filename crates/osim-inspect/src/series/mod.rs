//! The points of every plot: bodies, and what their contacts do.

mod body;
mod curves;
mod heat;
mod units;

pub use body::{Body, SphereKind, Weight, standing_spheres};
pub use curves::{
    DropSeries, ForceSeries, LoopSeries, StateSeries, depth, dropped, duration, elastic, fall, force,
    hysteresis, impact_speed, kinds, name_of, state, thresholds,
};
pub use heat::{HeatQuantity, HeatRequest, HeatSeries, heat};
pub use units::{ForceUnit, IndentationUnit, Point, Units};
