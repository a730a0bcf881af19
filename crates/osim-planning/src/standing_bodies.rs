//! The bodies of a model over their floors, by all of its forces.

use osim_inspect::{LoadSharing, Stance, StandingBody};
use osim_model::Model;
use osim_model::feet::{PoseFault, Standing};

/// Each joint tree with spheres over a floor, one limb carrying it alone, and its limbs.
///
/// # Errors
/// It is not known where a body is at the default pose.
pub(crate) fn standing_bodies(model: &Model) -> Result<(Vec<StandingBody>, LoadSharing), PoseFault> {
    let forces = model.force_ids();
    let standing = Standing::all(model, &forces)?;
    let sharing = LoadSharing::of(model, &forces);
    Ok((StandingBody::all(model, &standing, sharing.limbs(), Stance::default().limbs_of(model)), sharing))
}
