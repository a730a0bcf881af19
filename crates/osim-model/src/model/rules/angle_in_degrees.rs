//! An angle of a half-space is in degrees.

use crate::messages::{readable, shown};

use crate::model::contacts::Orientation;
use crate::model::finding::{Example, Finding, FindingCode, Repair, Rule, Seen, Severity, VerdictOn};
use crate::model::typed_model::Model;

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::AngleInDegrees,
    severity: Severity::Error,
    seen: Seen::Model,
    verdict: Some(VerdictOn::Floor),
    what: "An angle of a half-space, or of a frame that carries it, is in degrees.",
    why: "OpenSim reads orientations in radians: -90 is 14 whole turns and a little more, which looks like a slope of 26.6 degrees.",
    advice: "Write the angles in radians: degrees × π/180",
    repair: Repair::NotPossible(
        "a floor is turned by hand; the finding names the line and what to write there",
    ),
    example: Example::Piece {
        model: "check/within_limits.osim",
        good: "<orientation>0 0 -1.5707963267948966</orientation>",
        bad: "<orientation>0 0 -90</orientation>",
    },
};

/// Half-spaces that are turned by an angle of more than a whole turn, each orientation once.
pub(super) fn find(model: &Model) -> Vec<Finding> {
    let mut found: Vec<Finding> = Vec::new();
    let planes = model.half_spaces().into_iter().chain(model.half_spaces_inside());
    for orientation in planes.flat_map(|plane| plane.orientations) {
        let is_known = found.iter().any(|known| known.place.as_deref() == Some(orientation.path.as_str()));
        found.extend(of_orientation(&orientation).filter(|_| !is_known));
    }
    found
}

fn of_orientation(orientation: &Orientation) -> Option<Finding> {
    let angles = orientation.angles_rad.filter(|_| orientation.is_in_degrees())?;
    let listed = |angles: [f64; 3]| angles.map(readable).join(" ");
    let Orientation { path, tag, line, .. } = orientation;
    let text = format!(
        "{tag} of {} is {} rad, more than a whole turn: expected radians; for these degrees write <{tag}>{}</{tag}>",
        shown(path),
        listed(angles),
        listed(angles.map(f64::to_radians)),
    );
    Some(Finding::at(&RULE, *line, text).about(path))
}
