//! Remarks about where new spheres are over the floor.

use std::collections::HashSet;

use osim_inspect::StandingBody;
use osim_model::Model;
use osim_model::messages::{Phrase, shown};
use osim_patch::Plan;

use crate::afterwards::standing_bodies;

/// How far the spheres that `plan` adds are from the floor of `built`, the model that it makes, at the default pose, and which
/// coordinate puts the body on them. `None` if they press on no floor.
pub(crate) fn standing(plan: &Plan, built: &Model) -> Option<Phrase> {
    let bodies = match standing_bodies(built) {
        Ok((bodies, _)) => bodies,
        Err(fault) => {
            return Some(format!("how far the spheres are from the floor is not known: {fault}").into());
        }
    };
    let new = plan.new_spheres();
    let new: HashSet<&str> = new.iter().map(|sphere| sphere.name).collect();
    let is_new = |body: &StandingBody| body.bottoms.iter().any(|one| new.contains(one.sphere.as_str()));
    bodies.into_iter().find(is_new).and_then(|body| said(&body))
}

fn said(body: &StandingBody) -> Option<Phrase> {
    let (lowest, place, way) = (body.lowest()?, body.place()?, body.way_to_stand());
    let lowest = shown(&lowest.sphere);
    Some(format!("at the default pose {lowest}, the lowest sphere, is {place}; {way}").into())
}
