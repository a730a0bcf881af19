//! Variants of one model: the points of a grid, or the steps of a ladder.

mod grid;
mod ladder;
mod manifest;
mod part;
mod plan;
mod stages;
mod variant;

pub use plan::{SweepPlan, VariantMade};
