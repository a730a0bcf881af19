//! Animals of Table 1.

use std::fmt::Display;

use contact_scaling::table1::{self, Animal};
use osim_model::files::Failure;

/// The animal of Table 1 that is called `taxon` and stands on the most spheres.
pub(super) fn animal(taxon: &str) -> Result<Animal, Failure> {
    let spheres = |animal: &Animal| animal.scale().sphere_count();
    let most = table1::called(taxon).max_by(|a, b| spheres(a).total_cmp(&spheres(b)));
    most.ok_or_else(|| failure(format!("there is no {taxon}")))
}

/// Something that went wrong with numbers of the table.
pub(super) fn failure(error: impl Display) -> Failure {
    Failure::outside("Table 1", "plot", error.to_string())
}
