//! What a drop showed.

use contact_scaling::drop_test::{Difference, DropReport, DropValues};
use osim_inspect::MassMismatch;
use osim_model::files::FileName;

/// What a drop showed.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct DropResult {
    /// The model, the preset, or that it was given by numbers.
    pub name: FileName,
    /// The conditions.
    pub values: DropValues,
    /// n, spheres that share the weight.
    pub sphere_count: f64,
    /// Motion and force.
    pub report: DropReport,
    /// How far it is from another drop, where one was asked for.
    pub compared: Option<ComparedDrop>,
    /// Bodies that weigh something else than their contacts were made for, by their names.
    pub mismatches: Vec<(String, MassMismatch)>,
}

/// A drop compared with another.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct ComparedDrop {
    /// The other body.
    pub name: FileName,
    /// How far apart they are without dimensions.
    pub difference: Difference,
}
