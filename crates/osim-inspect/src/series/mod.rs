//! The points of every plot: forces, contact states and drops of bodies on their contacts.

mod body;
mod curves;
mod heat;

pub use body::{CarriedWeight, ContactBody, ReferenceState, SphereKind, standing_spheres};
pub use curves::{
    DropSeries, ForceSeries, ForceUnit, IndentationUnit, LoopSeries, PlotUnits, Point, bodies_and_kinds,
    contact_state, curve_name, default_duration, default_range, drop_force, force, force_at_rest, hysteresis,
    impact_speed, run_drop_test, thresholds,
};
pub use heat::{HeatParameter, HeatSeries, Profile, heat};
