//! The points of every plot: bodies, and what their contacts do.

mod body;
mod curves;
mod heat;
mod sampling;

pub use body::{Body, ReferenceState, SphereKind, Weight, standing_spheres};
pub use curves::{
    DropSeries, ForceSeries, LoopSeries, dropped, duration, elastic, fall, force, hysteresis, impact_speed,
    kinds, name_of, reach, state, thresholds,
};
pub use heat::{HeatRequest, HeatSeries, Parameter, Profile, heat};
pub use sampling::{ForceUnit, IndentationUnit, Point, Units};
