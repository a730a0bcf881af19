//! Findings from the model itself: what reading it showed, and what only matters once it is asked.

use std::cell::LazyCell;

use osim_model::{BothSides, Finding, FindingCode, ForceId, Model};
use osim_requests::Request;

use super::found::Found;
use super::remedy::Remedies;
use crate::floors::Floors;
use crate::inspection::Inspection;
use crate::known::{KnownSide, odd_side};
use crate::rules::{
    default_stiffness, left_right_differ, moco_dialect, no_gravity, of_floors, sphere_count_unknown,
    zero_constant_contact_force,
};

/// Which findings are asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Asked {
    All,
    /// Those that numbers of contacts decide: models that differ in nothing else have the others alike.
    OfNumbers,
}

/// Everything that the model shows apart from its figures; what floors and gravity show alone only where it is `asked` for.
pub(super) fn findings(
    model: &Model,
    inspected: &Inspection,
    remedies: &Remedies<'_>,
    asked: Asked,
) -> Vec<Found> {
    let floors = LazyCell::new(|| Floors::of(model));
    let sides = LazyCell::new(|| model.both_sides());
    let known = LazyCell::new(|| KnownSide::of(model, &sides, inspected));
    let with_remedy = |finding: &Finding| {
        if finding.code() == FindingCode::LeftRightDiffer {
            return of_sides(model, &sides, known.as_ref(), finding, remedies);
        }
        Found::new(finding.clone(), remedy(model, finding, remedies))
    };
    let mut found: Vec<Found> = inspected.warnings.iter().map(with_remedy).collect();
    found.extend(model.remarks_on(&meeting_half_space(model)).into_iter().map(Found::from));
    if asked == Asked::All {
        found.extend(of_floors(model, &floors).into_iter().map(Found::from));
    }
    let unknown =
        [no_gravity::find(model, inspected, || floors.are_any()), sphere_count_unknown::find(inspected)];
    found.extend(unknown.into_iter().flatten().map(Found::from));
    found
}

/// Forces that a change takes by default.
fn meeting_half_space(model: &Model) -> Vec<ForceId> {
    let forces = model.forces().iter().filter(|force| model.meets_half_space(force));
    forces.map(|force| force.id).collect()
}

/// A difference of the sides, with the side that is the slip, if it is known.
fn of_sides(
    model: &Model,
    sides: &BothSides<'_>,
    known: Option<&KnownSide>,
    finding: &Finding,
    remedies: &Remedies<'_>,
) -> Found {
    let remedy = left_right_differ::remedy(remedies, model, sides, known, finding);
    let mut named = finding.clone();
    name_the_odd_side(&mut named, sides, known);
    Found::new(named, remedy)
}

/// Says which side is the slip, and why, if it is known. A majority is in the message already.
fn name_the_odd_side(finding: &mut Finding, sides: &BothSides<'_>, known: Option<&KnownSide>) {
    let left = finding.place.as_deref().and_then(|path| sides.force(path));
    let Some(odd) = left.and_then(|left| odd_side(known, sides, left)) else { return };
    finding.message.push(format!("; the one on the {} is the odd one", odd.as_str()));
    if let Some(known) = known {
        let (side, title) = (known.side.as_str(), &known.title);
        finding.message.push(format!(", since the contacts on the {side} are those of {title}"));
    }
}

fn remedy(model: &Model, finding: &Finding, remedies: &Remedies<'_>) -> Option<Request> {
    match finding.code() {
        FindingCode::DefaultStiffness => default_stiffness::remedy(remedies),
        FindingCode::ZeroConstantContactForce => zero_constant_contact_force::remedy(remedies),
        FindingCode::MocoDialect => moco_dialect::remedy(remedies, model, finding),
        _ => None,
    }
}
