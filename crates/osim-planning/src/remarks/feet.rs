//! Remarks about feet that get spheres: their parts, floors, planes and limbs; and questions about sizes and masses that look like a typing
//! mistake or another unit.

use std::collections::{BTreeSet, HashSet};

use osim_inspect::{LoadSharing, StandingBody};
use osim_model::feet::{Movements, Sole, angle_between};
use osim_model::messages::{Input, Phrase, four_significant, phrase, readable, shown};
use osim_model::{
    Anatomy, BoneLengths, DVec3, Force, ForceId, Model, Side, Suspicion, YesQuestion, advice_on_units,
    probable_units, without_side,
};
use osim_patch::{ObjectAction, Plan, RebuiltModel};
use osim_requests::BodyScale;
use osim_requests::options::CountOptions;

use crate::result_check::standing_bodies;

/// Remarks if only one side gets spheres, if parts of a foot get none, or if a foot does not bend.
pub(crate) fn remarks_on_parts_of_feet(model: &Model, soles: &[Sole]) -> Vec<Phrase> {
    let feet = FeetWithSpheres { model, soles };
    [
        feet.spheres_on_one_side_only(),
        feet.bodies_without_spheres(),
        feet.rigid_joints(),
        feet.single_body_feet(),
    ]
    .into_iter()
    .flatten()
    .collect()
}

/// A model and the soles that get spheres, for remarks on what gets none.
struct FeetWithSpheres<'f> {
    model: &'f Model,
    soles: &'f [Sole],
}

impl<'f> FeetWithSpheres<'f> {
    fn bodies(&self) -> impl Iterator<Item = &'f str> {
        self.soles.iter().flat_map(|sole| &sole.bodies).map(String::as_str)
    }

    /// All joints from a body of a foot to a body below it, by the names of the two bodies.
    fn joints_below(&self) -> impl Iterator<Item = (&'f str, &'f str)> {
        let model = self.model;
        self.bodies().flat_map(move |body| {
            let below = model.joints().iter().filter(move |joint| joint.parent.as_deref() == Some(body));
            below.filter_map(move |joint| Some((body, joint.child.as_deref()?)))
        })
    }

    /// Whether a body belongs to a foot that gets spheres.
    fn gets_spheres(&self, body: &str) -> bool {
        self.bodies().any(|own| own == body)
    }

    /// A remark if only one side gets spheres. It names the bodies of the other side.
    fn spheres_on_one_side_only(&self) -> Option<Phrase> {
        let other = |body: &&str| {
            let is_counterpart = |there: &str| {
                without_side(there) == without_side(body)
                    && Side::of_name(there).is_some_and(|side| Some(side) != Side::of_name(body))
            };
            let there = self.model.bodies().iter().map(|there| there.name.as_str());
            there.filter(|there| is_counterpart(there)).find(|there| !self.gets_spheres(there))
        };
        let missing: Vec<&str> = self.bodies().filter_map(|body| other(&body)).collect();
        about_bodies(&missing, |bodies| format!("one side alone gets spheres: the other side has {bodies}"))
    }

    /// A remark that names bodies which hang on a foot's bodies and get no spheres.
    fn bodies_without_spheres(&self) -> Option<Phrase> {
        let out: Vec<&str> =
            self.joints_below().map(|(_, child)| child).filter(|child| !self.gets_spheres(child)).collect();
        about_bodies(&out, |bodies| {
            format!("no spheres under {bodies}: part of the foot, but not among the bodies that were given")
        })
    }

    /// A remark that names bodies which cannot move against the rest of their foot.
    fn rigid_joints(&self) -> Option<Phrase> {
        let movements = Movements::of(self.model);
        let inside = self.joints_below().filter(|(_, child)| self.gets_spheres(child));
        let stiff = inside.filter(|(parent, child)| {
            movements.between(parent, child).is_some_and(|freedom| !freedom.is_any())
        });
        let welded: Vec<&str> = stiff.map(|(_, child)| child).collect();
        about_bodies(&welded, |bodies| {
            format!(
                "the foot does not bend: nothing is free in the joint of {bodies} (welded, locked or prescribed)"
            )
        })
    }

    /// A remark that names the feet which consist of a single body.
    fn single_body_feet(&self) -> Option<Phrase> {
        let single = self.soles.iter().filter_map(|sole| match sole.bodies.as_slice() {
            [only] => Some(only.as_str()),
            _ => None,
        });
        let single: Vec<&str> =
            single.filter(|body| !self.joints_below().any(|(parent, _)| parent == *body)).collect();
        about_bodies(&single, |bodies| format!("feet of one rigid piece: {bodies}"))
    }
}

/// A remark about bodies, made by `text` from their names; `None` if there are none.
fn about_bodies(bodies: &[&str], text: impl FnOnce(String) -> String) -> Option<Phrase> {
    let listed: Vec<String> = bodies.iter().map(|body| shown(body).to_string()).collect();
    (!listed.is_empty()).then(|| text(listed.join(", ")).into())
}

/// A remark about the default pose: how far the new spheres of `plan` are from the floor of `built`, the model after the change, and which
/// coordinate puts the body on its spheres. `None` if the spheres press on no floor.
pub(crate) fn remark_on_standing(plan: &Plan, built: &Model) -> Option<Phrase> {
    let bodies = match standing_bodies(built) {
        Ok((bodies, _)) => bodies,
        Err(fault) => {
            return Some(format!("how far the spheres are from the floor is not known: {fault}").into());
        }
    };
    let new = plan.new_spheres();
    let new: HashSet<&str> = new.iter().map(|sphere| sphere.name).collect();
    let is_new = |body: &StandingBody| body.bottoms.iter().any(|one| new.contains(one.sphere.as_str()));
    let body = bodies.into_iter().find(is_new)?;
    let (lowest, height, way) = (body.lowest()?, body.pose_in_words()?, body.describe_way_to_stand());
    let lowest = shown(&lowest.sphere);
    Some(format!("at the default pose {lowest}, the lowest sphere, is {height}; {way}").into())
}

/// A plane that leans by at most this, degrees, was probably intended to be level.
const LEVEL_TOLERANCE_DEG: f64 = 10.0;

/// A remark that names planes of `base` which are nearly level, if a level floor was added to the model.
pub(crate) fn remark_on_leaning_planes(base: &Model, rebuilt: &RebuiltModel) -> Option<Phrase> {
    let added = |object: &osim_patch::ObjectChange| object.action == ObjectAction::Added;
    let made = rebuilt.objects.iter().find(|object| added(object) && object.class == "ContactHalfSpace")?;
    let up = base.up();
    let planes: Vec<String> = base
        .ground_planes()
        .into_iter()
        .filter_map(|plane| {
            let degrees = angle_between(plane.normal, up).to_degrees();
            (degrees <= LEVEL_TOLERANCE_DEG)
                .then(|| format!("{} (by {} degrees)", plane.name, readable(degrees)))
        })
        .collect();
    if planes.is_empty() {
        return None;
    }
    let text = format!(
        "no half-space of the model is level: {} would be a floor, but it is tilted; the new forces meet {}, which is level",
        planes.join(", "),
        made.name
    );
    Some(text.into())
}

/// A remark that names planes which only the `removed` forces of `model` used, and no new force of `rebuilt` uses.
pub(crate) fn remark_on_other_planes(
    model: &Model,
    removed: &[ForceId],
    rebuilt: &RebuiltModel,
) -> Option<Phrase> {
    let met = |model: &Model, forces: &mut dyn Iterator<Item = &Force>| -> BTreeSet<String> {
        let sets = forces.flat_map(|force| &force.sets);
        sets.flat_map(|set| model.half_spaces_of(set)).map(|plane| plane.name).collect()
    };
    let before = met(model, &mut removed.iter().filter_map(|&id| model.force(id)));
    let built = rebuilt.model();
    let new: BTreeSet<&str> = rebuilt
        .objects
        .iter()
        .filter(|object| object.action == ObjectAction::Added)
        .map(|object| object.path.as_str())
        .collect();
    let mut new_forces = built.forces().iter().filter(|force| new.contains(force.path.as_str()));
    let after = met(built, &mut new_forces);
    let left: Vec<&str> = before.difference(&after).map(String::as_str).collect();
    if left.is_empty() || after.is_empty() {
        return None;
    }
    let after: Vec<&str> = after.iter().map(String::as_str).collect();
    let text = format!(
        "the forces that were taken out met {}, which is not a level floor on ground; the new ones meet {}",
        left.join(" and "),
        after.join(" and ")
    );
    Some(text.into())
}

/// If a sphere is farther from the joints of its body than this, the program asks whether that is intended. The unit is the longest
/// distance between joints around the body. Published spheres are closer than half of the limit; places in centimetres would be at some
/// tens.
const FAR_FROM_JOINTS_IN_BONES: f64 = 3.0;
/// A usual distance of a sphere from the joints, in the same unit as [`FAR_FROM_JOINTS_IN_BONES`]: from the ankle to the ball of a human
/// foot, over the length of the shank.
const USUAL_DISTANCE_IN_BONES: f64 = 0.4;
/// Length of a foot over the usual thickness of the pad below its bones: 0.26 m over 13 mm.
const FOOT_LENGTH_OVER_PAD: f64 = 20.0;
/// The program asks about scale factors of bones that are larger than this. The bones of a giraffe are 38 times as long as those of a
/// mouse: the cube root of 1190 kg over 0.0209 kg.
const LARGEST_UNIT_SCALE: f64 = 50.0;

/// Positions of the joints of a model on its bodies.
pub(crate) struct JointPositions {
    anatomy: Option<Anatomy>,
    distances: BoneLengths,
}

/// The distance of a place from the joints of its body.
pub(crate) struct DistanceFromJoints {
    from_joints_m: f64,
    longest_m: f64,
}

impl JointPositions {
    /// The joints of `model` and their distances.
    pub(crate) fn of(model: &Model) -> Self {
        Self { anatomy: Anatomy::of(model).ok(), distances: model.joint_distances().clone() }
    }

    /// The distance of a place from the nearest joint of `body`, or from its origin; `None` if the size of the bones is not known.
    pub(crate) fn distance(&self, body: &str, place_m: [f64; 3]) -> Option<DistanceFromJoints> {
        let longest_m = self.distances.longest_around_body(body)?;
        let anatomy = self.anatomy.as_ref()?;
        let above = anatomy.joint_above(body).map(|joint| joint.in_child_m);
        let below = anatomy.joints_below(body).map(|joint| joint.in_parent_m);
        let apart = |joint: DVec3| joint.distance(place_m.into());
        let from_joints_m = below.chain(above).chain([DVec3::ZERO]).map(apart).fold(f64::INFINITY, f64::min);
        Some(DistanceFromJoints { from_joints_m, longest_m })
    }
}

impl DistanceFromJoints {
    /// The distance divided by the longest distance between joints.
    pub(crate) fn relative(&self) -> f64 {
        self.from_joints_m / self.longest_m
    }

    /// The question about a place that is too far from the joints of the body; `at` names the table and the line.
    pub(crate) fn question_about_place(&self, at: &str, name: &str, body: &str) -> Option<Suspicion> {
        if self.relative() <= FAR_FROM_JOINTS_IN_BONES {
            return None;
        }
        let units = probable_units(self.relative() / USUAL_DISTANCE_IN_BONES);
        let units: Vec<String> = units
            .iter()
            .map(|(unit, per_metre)| format!("divide them by {per_metre} if they are in {unit}"))
            .collect();
        let text = format!(
            "{at}{} would be {} m from the nearest joint of {}, and the joints of its body and of those next to it are at most {} m \
             apart: places are in m{}{}",
            shown(name),
            four_significant(self.from_joints_m),
            shown(body),
            four_significant(self.longest_m),
            if units.is_empty() { "" } else { ", " },
            units.join(", or ")
        );
        Some(Suspicion::Other { question: YesQuestion::ImplausiblePlace, text: text.into() })
    }
}

/// The question about a pad that is thicker than the foot is long.
pub(crate) fn question_about_pad(sole: &Sole, pad_m: f64) -> Option<Suspicion> {
    let length_m = sole.footprint.length_m;
    if pad_m <= length_m {
        return None;
    }
    let write = advice_on_units(pad_m, pad_m * FOOT_LENGTH_OVER_PAD / length_m);
    let bodies: Vec<String> = sole.bodies.iter().map(|body| shown(body).to_string()).collect();
    let text = phrase![
        "{} is more than the length of the foot of {}, {} m: it is in m{}";
        Input::Pad.with_value(readable(pad_m)), bodies.join(", "), four_significant(length_m), write
    ];
    Some(Suspicion::Other { question: YesQuestion::ImplausiblePlace, text })
}

/// The question about a scale factor of bones that is larger than between any two animals.
pub(crate) fn question_about_scale(scales: &[BodyScale]) -> Option<Suspicion> {
    let usual = 1.0 / LARGEST_UNIT_SCALE..=LARGEST_UNIT_SCALE;
    let factors = scales.iter().flat_map(|scale| scale.factors.map(|factor| (scale, factor)));
    let (scale, factor) = factors.into_iter().find(|(_, factor)| !usual.contains(factor))?;
    let percent = match factor > LARGEST_UNIT_SCALE {
        true => format!("; if it is in percent, write {}", readable(factor / 100.0)),
        false => String::new(),
    };
    let text = phrase![
        "{} makes a bone {} times as long as the reference's: between a mouse and a giraffe it is 38 times{percent}";
        Input::BodyScale.with_value(scale.to_string()), readable(factor)
    ];
    Some(Suspicion::Other { question: YesQuestion::ImplausibleScale, text })
}

/// A remark with the number of limbs that share the weight, if the caller does not say it, and it is from the note in `model`, or one of
/// more than two limbs with `forces` carries all. Without `forces`, as for contacts of the same animal, the latter does not matter.
pub(crate) fn remark_on_limbs(
    counts: &CountOptions,
    model: &Model,
    forces: Option<&[ForceId]>,
) -> Option<Phrase> {
    if counts.stance_limbs.is_some() || counts.spheres.is_some() {
        return None;
    }
    if let Some(noted) = model.noted_stance_limbs() {
        let text = format!("{} limbs share the weight, as the note in the model says: ", readable(noted));
        return Some(phrase![text, Input::StanceLimbs, " says another number"]);
    }
    let limbs = LoadSharing::of(model, forces?).limbs.if_known()?.len();
    let text = format!("one of {limbs} limbs carries the body; if two share its weight, say ");
    (limbs > 2).then(|| phrase![text, Input::StanceLimbs.with_value("2")])
}
