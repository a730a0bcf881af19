//! Feet whose bottoms are made level.

use osim_model::feet::{NotLevelled, levelled};
use osim_model::{Fault, ForceId, Model, SphereId};

/// Where spheres of `forces` have to be in `model` for the bottoms of each foot to be as low as its lowest one, in their own frames, m;
/// those that are right are left out.
///
/// # Errors
/// Limbs, floors or the default pose are not known; a foot leans.
pub(super) fn places(model: &Model, forces: &[ForceId]) -> Result<Vec<(SphereId, [f64; 3])>, Fault> {
    let found = levelled(model, forces).map_err(|fault| match fault {
        NotLevelled::Frame(fault) => *fault,
        other => Fault::refused(other.to_string()),
    })?;
    Ok(found.into_iter().map(|one| (one.sphere, one.location_m)).collect())
}
