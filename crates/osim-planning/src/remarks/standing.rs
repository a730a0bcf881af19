//! Remarks about where new spheres are over the floor.

use osim_feet::{PlacedSphere, Standing};
use osim_messages::{Phrase, readable};
use osim_model::Model;
use osim_patch::Plan;

/// Bottoms this close to the floor are on it, m.
const ON_FLOOR_M: f64 = 1e-4;

/// How far the spheres that `plan` adds are from the floor of `built`, the model with them, at the default pose, and which
/// coordinate puts the lowest on it. `None` if there are several floors.
pub(crate) fn standing(plan: &Plan, built: &Model) -> Option<Phrase> {
    let spheres: Vec<PlacedSphere<'_>> = plan
        .new_spheres()
        .into_iter()
        .map(|new| PlacedSphere {
            name: new.name,
            body: new.body,
            centre_m: new.centre_m,
            radius_m: new.radius_m,
        })
        .collect();
    match Standing::of(built, &spheres) {
        Ok(standing) => standing.map(|standing| said(&standing).into()),
        Err(fault) => Some(format!("how far the spheres are from the floor is not known: {fault}").into()),
    }
}

fn said(standing: &Standing) -> String {
    let Standing { lowest, gap_m, coordinate, .. } = standing;
    let gap_mm = readable((gap_m.abs() * 1e4).round() / 10.0);
    if gap_m.abs() <= ON_FLOOR_M {
        return format!("at the default pose {lowest}, the lowest sphere, touches the floor");
    }
    let place = if *gap_m > 0.0 { "above" } else { "below" };
    let mut text = format!(
        "at the default pose the bottom of {lowest}, the lowest sphere, is {gap_mm} mm {place} the floor"
    );
    if let Some(coordinate) = coordinate {
        text.push_str(&format!(
            "; it touches the floor with {} = {} m (now {} m)",
            coordinate.name,
            readable((coordinate.touching_m * 1e6).round() / 1e6),
            readable(coordinate.default_m),
        ));
    }
    text
}
