//! What the rules about floors share that are turned wrongly.

use osim_model::messages::{readable, shown, three_significant};
use osim_model::{Finding, Rule};

use crate::floors::{Floors, JudgedPlane, PlaneKind};

/// A floor that leans by more than this, degrees, is nearer to upside down than to upright.
pub(super) const UPSIDE_DOWN_DEGREES: f64 = 135.0;

/// The floors that lean as `is_so` (degrees) says, with what to write instead.
pub(super) fn turned(floors: &Floors, rule: &'static Rule, is_so: impl Fn(f64) -> bool) -> Vec<Finding> {
    let of_plane = |judged: &JudgedPlane| match judged.kind {
        PlaneKind::Steep(degrees) if is_so(degrees) => of_plane(judged, rule, degrees),
        _ => None,
    };
    floors.iter().filter_map(of_plane).collect()
}

fn of_plane(judged: &JudgedPlane, rule: &'static Rule, degrees: f64) -> Option<Finding> {
    let plane = &judged.plane;
    let (own, surface) = plane.orientations.first().zip(plane.surface)?;
    let tag = own.tag;
    let text = format!(
        "the surface of {} faces {} degrees away from up, expected less than 45, and its spheres have no other floor; to make it \
         level write <{tag}>{}</{tag}>",
        shown(&plane.name),
        three_significant(degrees),
        surface.level_orientation.map(readable).join(" "),
    );
    Some(Finding::at(rule, own.line, text).about(&plane.path))
}
