//! A sphere that is far from the body that carries it.

use osim_messages::{shown, three_significant};

use crate::body_shapes::BodyShape;
use crate::contacts::Sphere;
use crate::finding::{Example, Finding, FindingCode, Repair, Rule, Seen, Severity, VerdictOn};
use crate::model::Model;
use crate::side::Side;
use crate::sides::{BothSides, distance};

/// Published spheres are at most 0.353 of the limb's longest bone from the nearest joint of their body.
const OF_BONE: f64 = 0.6;
/// On a body without a side, such as the last link of a pendulum, which may be a long one: only another unit is seen.
const OF_BONE_WITHOUT_SIDE: f64 = 10.0;
/// And at most 2.7 radii of gyration from its centre of mass.
const OF_GYRATION: f64 = 4.0;

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::OddPlace,
    severity: Severity::Warn,
    seen: Seen::Model,
    verdict: Some(VerdictOn::Sizes),
    what: "A sphere is far from the body that carries it.",
    why: "Spheres of published feet are at most 0.353 of the limb's longest bone from the nearest joint of their body, and at most 2.7 of its radii of gyration from its centre of mass. Much more is a place in millimetres, or one in another frame.",
    advice: "Look at `plot feet`; write places in metres, in the frame of the body",
    repair: Repair::NotPossible("only you know the place that is meant"),
    example: Example::Piece {
        model: "table1/human_62kg_smooth_sphere.osim",
        good: "<location>-0.029760000000000002 -0.037199999999999997 -0.048000000000000001</location>",
        bad: "<location>-29.76 -37.2 -48</location>",
    },
};

/// One finding, about the sphere that is farthest away.
pub(super) fn find(model: &Model, sides: &BothSides<'_>) -> Option<Finding> {
    let shapes = model.body_shapes();
    let far = |(sphere, body, place_m): (_, &str, _)| {
        far(sphere, place_m, shapes.get(body)?, sides.longest_of_limb_m(body)?)
    };
    let mut all: Vec<Far<'_>> = sides.spheres().filter_map(far).collect();
    all.sort_by(|a, b| b.of_bone.total_cmp(&a.of_bone));
    let worst = all.first()?;
    let sphere = worst.sphere;
    let finding = Finding::at(&RULE, sphere.line, text(worst, all.len())).about(&sphere.path);
    Some(finding.of_spheres(all.iter().map(|far| far.sphere.name.clone()).collect()))
}

struct Far<'m> {
    sphere: &'m Sphere,
    from_joint_m: f64,
    of_bone: f64,
    bone_m: f64,
}

fn far<'m>(sphere: &'m Sphere, place_m: [f64; 3], body: &BodyShape, bone_m: f64) -> Option<Far<'m>> {
    let from_joints = body.joints_m.iter().map(|&joint_m| distance(joint_m, place_m));
    let from_joint_m = from_joints.fold(f64::INFINITY, f64::min);
    let from_centre = distance(body.centre_m, place_m);
    let is_near = body.gyration_m.is_some_and(|gyration_m| from_centre <= OF_GYRATION * gyration_m);
    let of_bone = from_joint_m / bone_m;
    (from_joint_m.is_finite() && of_bone > most(sphere) && !is_near).then_some(Far {
        sphere,
        from_joint_m,
        of_bone,
        bone_m,
    })
}

/// How far it may be, as a part of the limb's longest bone.
fn most(sphere: &Sphere) -> f64 {
    let side = sphere.body.as_deref().and_then(Side::of_name);
    if side.is_some() { OF_BONE } else { OF_BONE_WITHOUT_SIDE }
}

fn text(worst: &Far<'_>, count: usize) -> String {
    let more = match count {
        1 => String::new(),
        2 => "; another sphere, too".to_owned(),
        count => format!("; {} other spheres, too", count - 1),
    };
    format!(
        "{} is {} m from the nearest joint of {}, {} of the limb's longest bone ({} m), expected at most {}{more}",
        shown(&worst.sphere.name),
        three_significant(worst.from_joint_m),
        shown(worst.sphere.body.as_deref().unwrap_or_default()),
        three_significant(worst.of_bone),
        three_significant(worst.bone_m),
        most(worst.sphere)
    )
}
