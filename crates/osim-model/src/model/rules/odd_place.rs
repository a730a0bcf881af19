//! A sphere that is far from the body that carries it.

use crate::messages::{shown, three_significant};
use foldhash::{HashMap, HashMapExt};

use crate::model::body_shapes::BodyShape;
use crate::model::contacts::Sphere;
use crate::model::finding::{Example, Finding, FindingCode, Repair, Rule, Seen, Severity, VerdictOn};
use crate::model::side::Side;
use crate::model::sides::{BothSides, distance};
use crate::model::typed_model::Model;

/// Published spheres are at most 0.353 of the limb's longest bone from the nearest joint of their body.
const OF_BONE: f64 = 0.6;
/// On a body without a side, such as the last link of a pendulum, which may be a long one: only another unit is seen.
const OF_BONE_WITHOUT_SIDE: f64 = 10.0;
/// And at most 2.7 radii of gyration from its centre of mass.
const OF_GYRATION: f64 = 4.0;
/// Sideways, the spheres of the 13 models of the corpus that have a left and a right side are at most 0.149 of that bone from the nearest
/// joint (the outer toes of Falisse et al.): a foot is longer than wide.
const OF_BONE_SIDEWAYS: f64 = 0.25;
/// And at most 2.8 radii of gyration from its centre of mass, where they are at 0.149; a foot without a limb, whose longest bone is its
/// own, has them at 0.38 and less than 2.
const OF_GYRATION_SIDEWAYS: f64 = 2.0;

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::OddPlace,
    severity: Severity::Warn,
    seen: Seen::Model,
    verdict: Some(VerdictOn::Sizes),
    what: "A sphere is far from the body that carries it.",
    why: "Spheres of published feet are at most 0.353 of the limb's longest bone from the nearest joint of their body, and at most 2.7 of its radii of gyration from its centre of mass; sideways at most 0.149 of that bone. Much more is a place in millimetres, or one in another frame.",
    advice: "Look at `plot MODEL output=FILE.svg kind=feet`; write places in metres, in the frame of the body",
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
    let mut bodies: HashMap<&str, Option<OnBody<'_>>> = HashMap::new();
    let mut all: Vec<Far<'_>> = Vec::new();
    for (sphere, body, place_m) in sides.spheres() {
        let on_body = bodies.entry(body).or_insert_with(|| OnBody::of(body, shapes.get(body)?, sides));
        all.extend(on_body.as_ref().and_then(|on_body| on_body.far(sphere, place_m)));
    }
    all.sort_by(|a, b| b.times().total_cmp(&a.times()));
    let worst = all.first()?;
    let sphere = worst.sphere;
    let finding = Finding::at(&RULE, sphere.line, text(worst, all.len())).about(&sphere.path);
    Some(finding.of_spheres(all.iter().map(|far| far.sphere.name.clone()).collect()))
}

/// A body by whose size places are judged.
struct OnBody<'m> {
    shape: &'m BodyShape,
    /// The limb's longest bone, m.
    bone_m: f64,
    /// How far a sphere may be, as a part of that bone.
    most: f64,
    /// The axis that leads sideways.
    sideways: Option<usize>,
}

struct Far<'m> {
    sphere: &'m Sphere,
    from_joint_m: f64,
    bone_m: f64,
    most: f64,
    sideways: bool,
}

impl<'m> OnBody<'m> {
    fn of(body: &str, shape: &'m BodyShape, sides: &BothSides<'_>) -> Option<Self> {
        let has_side = Side::of_name(body).is_some();
        let most = if has_side { OF_BONE } else { OF_BONE_WITHOUT_SIDE };
        let sideways = sides.sideways_axis(body).filter(|_| has_side);
        Some(Self { shape, bone_m: sides.longest_of_limb_m(body)?, most, sideways })
    }

    fn far<'s>(&self, sphere: &'s Sphere, place_m: [f64; 3]) -> Option<Far<'s>> {
        let far =
            |from_joint_m, most, sideways| Far { sphere, from_joint_m, bone_m: self.bone_m, most, sideways };
        let altogether = far(self.nearest_joint_m(|joint_m| distance(joint_m, place_m)), self.most, false);
        if altogether.is_too_far() && !self.is_near(distance(self.shape.centre_m, place_m), OF_GYRATION) {
            return Some(altogether);
        }
        let axis = self.sideways?;
        let apart = |other: [f64; 3]| (other[axis] - place_m[axis]).abs();
        let aside = far(self.nearest_joint_m(apart), OF_BONE_SIDEWAYS, true);
        let is_near = self.is_near(apart(self.shape.centre_m), OF_GYRATION_SIDEWAYS);
        (aside.is_too_far() && !is_near).then_some(aside)
    }

    /// How far it is to the nearest joint, m; infinite without joints.
    fn nearest_joint_m(&self, apart: impl Fn([f64; 3]) -> f64) -> f64 {
        self.shape.joints_m.iter().map(|&joint_m| apart(joint_m)).fold(f64::INFINITY, f64::min)
    }

    /// Whether the centre of mass is within so many radii of gyration.
    fn is_near(&self, from_centre_m: f64, radii: f64) -> bool {
        self.shape.gyration_m.is_some_and(|gyration_m| from_centre_m <= radii * gyration_m)
    }
}

impl Far<'_> {
    fn of_bone(&self) -> f64 {
        self.from_joint_m / self.bone_m
    }

    /// How many times as far as it may be.
    fn times(&self) -> f64 {
        self.of_bone() / self.most
    }

    fn is_too_far(&self) -> bool {
        self.times().is_finite() && self.times() > 1.0
    }
}

fn text(worst: &Far<'_>, count: usize) -> String {
    let more = match count {
        1 => String::new(),
        2 => "; another sphere, too".to_owned(),
        count => format!("; {} other spheres, too", count - 1),
    };
    format!(
        "{} is {} m{} from the nearest joint of {}, {} of the limb's longest bone ({} m), expected at most {}{more}",
        shown(&worst.sphere.name),
        three_significant(worst.from_joint_m),
        if worst.sideways { " sideways" } else { "" },
        shown(worst.sphere.body.as_deref().unwrap_or_default()),
        three_significant(worst.of_bone()),
        three_significant(worst.bone_m),
        worst.most
    )
}
