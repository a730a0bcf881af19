//! Findings from the model itself: what reading it showed, and what only matters once it is asked.

use std::cell::LazyCell;

use osim_model::{BothSides, Finding, FindingCode, ForceId, Model};
use osim_requests::Request;

use super::found::Found;
use super::remedy::Remedies;
use crate::floors::Floors;
use crate::inspection::Inspection;
use crate::rules::{
    default_stiffness, left_right_differ, no_gravity, of_floors, several_spheres_one_force,
    sphere_count_unknown, zero_constant_contact_force,
};

/// Everything that the model shows apart from its figures.
pub(super) fn findings(
    model: &Model,
    inspected: &Inspection,
    remedies: &Remedies<'_>,
    floors: &Floors,
) -> Vec<Found> {
    let sides = LazyCell::new(|| model.both_sides());
    let with_remedy =
        |finding: &Finding| Found::new(finding.clone(), remedy(model, &sides, finding, remedies));
    let mut found: Vec<Found> = inspected.warnings.iter().map(with_remedy).collect();
    found.extend(model.remarks_on(&meeting_half_space(model)).into_iter().map(Found::from));
    found.extend(of_floors(model, floors).into_iter().map(Found::from));
    let unknown = [no_gravity::find(model, inspected, floors), sphere_count_unknown::find(inspected)];
    found.extend(unknown.into_iter().flatten().map(Found::from));
    found
}

/// Forces that a change takes by default.
fn meeting_half_space(model: &Model) -> Vec<ForceId> {
    let forces = model.forces().iter().filter(|force| model.meets_half_space(force));
    forces.map(|force| force.id).collect()
}

fn remedy<'m>(
    model: &'m Model,
    sides: &LazyCell<BothSides<'m>, impl FnOnce() -> BothSides<'m>>,
    finding: &Finding,
    remedies: &Remedies<'_>,
) -> Option<Request> {
    match finding.code() {
        FindingCode::DefaultStiffness => default_stiffness::remedy(remedies),
        FindingCode::ZeroConstantContactForce => zero_constant_contact_force::remedy(remedies),
        FindingCode::SeveralSpheres => several_spheres_one_force::remedy(remedies, model, finding),
        FindingCode::LeftRightDiffer => left_right_differ::remedy(remedies, model, sides, finding),
        _ => None,
    }
}
