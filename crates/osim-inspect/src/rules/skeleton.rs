//! Rules about the skeleton: bodies that hang on the wrong side, limbs that are not mirror images, spheres of feet on ground, and roots that
//! cannot fall.

use std::cell::LazyCell;
use std::collections::{BTreeMap, BTreeSet};

use foldhash::{HashMap, HashMapExt};
use osim_model::feet::{DefaultPose, Movements, held_roots, placement_at_default_pose};
use osim_model::messages::{shown, three_significant};
use osim_model::{
    DVec3, Example, Finding, Force, Model, ModelJoint, Repair, Rule, Side, Sphere, SphereId, has_word,
    without_side,
};

use crate::body_bones::is_named_after_foot;
use crate::rules::misread::find_misread_texts;
use crate::rules::spheres::{finding_about_spheres, other_cases_in_words};
use osim_model::rule;

rule! { pub(super) ODD_PARENT: OddParent, Warning, Sides;
    what: "A body of one side hangs on a body of the other side, on another part of the trunk than its counterpart, or on ground apart from its limb.",
    why: "A joint that was copied keeps the parent of its original. OpenSim loads such a model: a shank then moves with the other thigh, a foot on ground stays where it is, and the contacts press at the wrong place.",
    advice: "Correct the parent frame of the joint",
    repair: Repair::NotPossible("only you know where the body belongs"),
    example: Example::Models { good: "check/known_contacts.osim", bad: "check/odd_parent.osim" },
}

/// Joints or bones of a limb that differ from their mirror image by more than this part of the limb's longest bone are reported.
const UNLIKE_PART_OF_BONE: f64 = 0.25;

rule! { pub(super) LEFT_RIGHT_BONES: LeftRightBones, Warning, Sides;
    what: "The bones of one limb are not the mirror image of those of the other limb: a joint is at another place, or a bone is missing.",
    why: "A place that was mistyped, or a bone that was lost, lets one foot hang in the air or in the floor while the other one stands. Two legs of one body never differ by more than 25 % of their longest bone.",
    advice: "Compare the joints of both limbs, and correct the frames of the one that is wrong",
    repair: Repair::NotPossible("only you know which side is right"),
    example: Example::Models { good: "check/known_contacts.osim", bad: "check/left_right_bones.osim" },
}

/// A joint is beside the middle of a body if its place is farther than this from 0 along each axis, m: one axis leads sideways, and joints
/// of both sides are at one place in planar models.
const BESIDE_MIDDLE_M: f64 = 1e-3;

/// The largest number of bodies from a foot to ground; joints can be in a loop.
const MOST_BONES: usize = 32;

/// Finds a body on the wrong side, else limbs that are not mirror images: one finding, because the second follows from the first.
pub(super) fn find_wrong_side_or_unlike_limbs(model: &Model) -> Vec<Finding> {
    let mut limbs = LimbsFromFeet { model, above: HashMap::new(), by_name: BTreeMap::new() };
    for joint in model.joints() {
        if let Some(child) = &joint.child {
            limbs.above.entry(child.as_str()).or_insert(joint);
        }
    }
    for body in model.bodies() {
        if let Some(side) = Side::of_name(&body.name) {
            limbs.by_name.insert((without_side(&body.name), side), body.name.as_str());
        }
    }
    let unlike = || limbs.find_copied_joint().or_else(|| limbs.find_unlike_bones());
    limbs.find_odd_parent().or_else(unlike).into_iter().collect()
}

/// The joints from each body up to the trunk, and the bodies of both sides, by which left and right limbs are compared.
struct LimbsFromFeet<'m> {
    model: &'m Model,
    /// For each body, the joint that connects it to its parent body.
    above: HashMap<&'m str, &'m ModelJoint>,
    /// The bodies with a side, by their names without it.
    by_name: BTreeMap<(String, Side), &'m str>,
}

impl<'m> LimbsFromFeet<'m> {
    /// The body on the other side with the same name.
    fn counterpart(&self, body: &str) -> Option<&'m str> {
        self.by_name.get(&(without_side(body), Side::of_name(body)?.other())).copied()
    }

    /// The body that carries `body` by a joint; `None` for ground.
    fn parent(&self, body: &str) -> Option<&'m str> {
        self.above.get(body)?.parent.as_deref()
    }

    /// `body` and the bodies above it, up to ground.
    fn path(&self, body: &'m str) -> impl Iterator<Item = &'m str> {
        std::iter::successors(Some(body), |body| self.parent(body)).take(MOST_BONES)
    }

    /// A finding of `rule` at the joint above `body`.
    fn finding(&self, rule: &'static Rule, body: &str, text: String) -> Option<Finding> {
        // Where the ends of a joint were exchanged, the body is above it.
        let below = || self.model.joints().iter().find(|joint| joint.parent.as_deref() == Some(body));
        let joint = self.above.get(body).copied().or_else(below)?;
        let components = self.model.components();
        let id = components.at(joint.file, joint.element)?;
        Some(Finding::at(rule, components.position_of(id), text).with_place(&components.tree.path(id)))
    }

    /// One finding for all bodies that hang on the other side or on ground.
    fn find_odd_parent(&self) -> Option<Finding> {
        let movements = LazyCell::new(|| Movements::of(self.model));
        let odd: Vec<&str> = self
            .by_name
            .values()
            .copied()
            .filter(|body| self.is_odd(body, &movements) == Some(true))
            .collect();
        let body = *odd.first()?;
        let (parent, counterpart) = (self.parent(body).unwrap_or("ground"), self.counterpart(body)?);
        let text = if self.parent(counterpart).is_none() && self.parent(body).is_none() {
            format!(
                "{} and {} hang on ground, apart from the rest of their limbs",
                shown(body),
                shown(counterpart)
            )
        } else {
            let apart = self.describe_distance(body).unwrap_or_default();
            let more = other_cases_in_words(odd.len(), "another body, too", "other bodies, too");
            format!("{} hangs on {}, unlike its counterpart{apart}{more}", shown(body), shown(parent))
        };
        self.finding(&ODD_PARENT, body, text)
    }

    /// Whether `body` hangs on the other side, on a part of the trunk further from ground than its counterpart, or on ground apart from its
    /// counterpart or from the rest of its limb; `None` without a counterpart.
    fn is_odd(
        &self,
        body: &str,
        movements: &LazyCell<Movements, impl FnOnce() -> Movements>,
    ) -> Option<bool> {
        let counterpart = self.counterpart(body)?;
        // A foot can be the root of the whole model.
        let is_root = || movements.top(counterpart) == body;
        let Some(joint) = self.above.get(body) else {
            let carries = |joint: &ModelJoint| joint.parent.as_deref() == Some(body);
            let has_parent = self.parent(counterpart).is_some();
            return Some(!is_root() && has_parent && self.model.joints().iter().any(carries));
        };
        if self.parent(body).is_none() && self.parent(counterpart).is_none() {
            // Other things of two sides, such as pedals, have no contacts.
            let top =
                |sphere: &Sphere| sphere.body.as_deref().is_some_and(|foot| movements.top(foot) == body);
            let hangs_on_trunk = |((_, side), other): (&(String, Side), &&str)| {
                Some(*side) == Side::of_name(body) && Side::of_name(movements.top(other)).is_none()
            };
            return Some(self.model.spheres().iter().any(top) && self.by_name.iter().any(hangs_on_trunk));
        }
        let of_counterpart = self.parent(counterpart)?;
        let carries_foot = || {
            let feet = self.model.spheres().iter().filter_map(|sphere| sphere.body.as_deref());
            feet.flat_map(|foot| self.path(foot)).any(|above| above == body)
        };
        Some(match self.parent(body) {
            // The halves of a pelvis or of a crank can be welded.
            Some(parent) if parent == counterpart => joint.class != "WeldJoint",
            Some(parent) if Side::of_name(parent).or(Side::of_name(of_counterpart)).is_none() => {
                self.path(parent).count() > self.path(of_counterpart).count() && carries_foot()
            }
            Some(parent) => Side::of_name(parent) == Side::of_name(counterpart),
            None => !is_root(),
        })
    }

    /// How far the foot of the limb of `body` is from the mirror image of the other foot at the default pose, seen from the trunk.
    fn describe_distance(&self, body: &str) -> Option<String> {
        let below = self.by_name.values().filter(|foot| self.path(foot).any(|above| above == body));
        let foot = *below.max_by_key(|foot| self.path(foot).count())?;
        let (other, pose) = (self.counterpart(foot)?, DefaultPose::of(self.model));
        let trunk = self.path(other).find(|body| Side::of_name(body).is_none())?;
        let from_trunk = pose.placement(trunk).ok()?.inverse();
        let place = |body| Some(from_trunk.point(pose.placement(body).ok()?.translation_m));
        let apart_m = (DVec3::new(1.0, 1.0, -1.0) * place(other)?).distance(place(foot)?);
        // Two feet that are exchanged are where they should be at this pose.
        let apart_mm = (apart_m > 1e-3).then(|| three_significant(1e3 * apart_m))?;
        Some(format!("; {} is {apart_mm} mm from the mirror image of {}", shown(foot), shown(other)))
    }

    /// The bodies of the left side that have a counterpart, and it, of limbs with feet or spheres. Others, such as arms, may be unlike.
    fn pairs_that_carry_feet(&self) -> Vec<[&'m str; 2]> {
        let spheres = self.model.spheres().iter();
        let with_spheres: BTreeSet<&str> = spheres.filter_map(|sphere| sphere.body.as_deref()).collect();
        let is_foot = |body: &&str| is_named_after_foot(body) || with_spheres.contains(body);
        let feet = self.by_name.values().copied().filter(is_foot);
        let carriers: BTreeSet<&str> = feet.flat_map(|foot| self.path(foot)).collect();
        let left = self.by_name.iter().filter(|((_, side), _)| *side == Side::Left);
        let pairs = left.filter_map(|(_, &body)| Some([body, self.counterpart(body)?]));
        pairs.filter(|pair| pair.iter().any(|bone| carriers.contains(bone))).collect()
    }

    /// The finding that two limbs are joined to one place beside the middle of a body: the joint of one was copied from the other side.
    fn find_copied_joint(&self) -> Option<Finding> {
        let is_beside = |place_m: DVec3| place_m.to_array().into_iter().all(|at| at.abs() > BESIDE_MIDDLE_M);
        let (body, other, parent) = self.pairs_that_carry_feet().into_iter().find_map(|[body, other]| {
            let parent = self.parent(body).filter(|parent| self.parent(other) == Some(*parent))?;
            let own_m = self.above.get(body)?.in_parent_m();
            let is_copied = own_m == self.above.get(other)?.in_parent_m() && is_beside(own_m);
            is_copied.then_some((body, other, parent))
        })?;
        let (left, right) = (shown(body), shown(other));
        let text = format!("{left} and {right} are joined to the same place of {}", shown(parent));
        self.finding(&LEFT_RIGHT_BONES, body, text)
    }

    /// The finding about the two limbs that differ most.
    fn find_unlike_bones(&self) -> Option<Finding> {
        let distances = self.model.joint_distances();
        let differences = self.pairs_that_carry_feet().into_iter().filter_map(|[body, other]| {
            let longest_m = [body, other].into_iter().filter_map(|body| distances.longest_in_limb(body));
            let (bone_m, apart_m) = (longest_m.reduce(f64::max)?, self.difference_m(body, other)?);
            (apart_m > UNLIKE_PART_OF_BONE * bone_m).then_some((apart_m, bone_m, body, other))
        });
        let worst = differences.reduce(|a, b| if b.0 / b.1 > a.0 / a.1 { b } else { a });
        // A place that OpenSim cannot read is the cause, and has a finding of its own.
        let (apart_m, bone_m, body, other) = worst
            .filter(|(.., body, other)| !self.has_misread_joint(body) && !self.has_misread_joint(other))?;
        let text = format!(
            "the joints above {} and {} are {} mm from being mirror images, {} % of the limb's longest bone ({} mm), expected at most {} %",
            shown(body),
            shown(other),
            three_significant(1e3 * apart_m),
            three_significant(100.0 * apart_m / bone_m),
            three_significant(1e3 * bone_m),
            100.0 * UNLIKE_PART_OF_BONE
        );
        Some(self.finding(&LEFT_RIGHT_BONES, body, text)?.with_measure(apart_m / bone_m, ""))
    }

    /// Whether OpenSim reads other numbers than are written in a joint above `body`, or in a frame of it.
    fn has_misread_joint(&self, body: &'m str) -> bool {
        let components = self.model.components();
        let joints = self.path(body).filter_map(|body| self.above.get(body));
        let joint_path =
            |joint: &&ModelJoint| Some(components.tree.path(components.at(joint.file, joint.element)?));
        let paths: Vec<String> = joints.filter_map(joint_path).collect();
        let is_in_joint = |place: &str| paths.iter().any(|path| place.starts_with(path));
        find_misread_texts(self.model).iter().any(|found| found.place.as_deref().is_some_and(is_in_joint))
    }

    /// How far the joints above two bodies are from being mirror images, m. Distances do not depend on the directions of the axes of bodies,
    /// which differ in some models.
    fn difference_m(&self, body: &'m str, other: &'m str) -> Option<f64> {
        let [one, two] = [self.place_m(body)?, self.place_m(other)?];
        let centre_m =
            |body: &str| self.model.body_shapes().get(body).map_or(DVec3::ZERO, |shape| shape.centre_m);
        let in_child_m = |body: &str| self.above.get(body).map(|joint| joint.in_child.translation_m);
        let [own_m, others_m] = [in_child_m(body)?, in_child_m(other)?];
        let of_origins_m = (own_m.length() - others_m.length()).abs();
        // The origin of a body may be anywhere, for example that of a scanner, on one side alone.
        let of_centres_m = own_m.distance(centre_m(body)) - others_m.distance(centre_m(other));
        let on_bodies_m = of_origins_m.min(of_centres_m.abs());
        let [parent, of_other] = [self.parent(body)?, self.parent(other)?];
        if parent == of_other {
            // The origin of the trunk can be on one side.
            let places = [DVec3::ZERO, centre_m(parent)].into_iter();
            let planes = places.flat_map(|at| DVec3::AXES.map(|axis| (at, axis)));
            let image = |(at, axis): (DVec3, DVec3)| one - 2.0 * (one - at).dot(axis) * axis;
            let apart_m = planes.map(|plane| image(plane).distance(two)).reduce(f64::min);
            return apart_m.map(|apart_m| apart_m.max(on_bodies_m));
        }
        let [(one_m, trunk), (two_m, of_other_trunk)] = [self.length_m(body)?, self.length_m(other)?];
        let mut apart_m = (one_m - two_m).abs().max(on_bodies_m);
        if without_side(parent) == without_side(of_other) {
            let [one_m, two_m] = [one.distance(centre_m(parent)), two.distance(centre_m(of_other))];
            apart_m = apart_m.max((one_m - two_m).abs());
        }
        (trunk == of_other_trunk).then_some(apart_m)
    }

    /// The place of the joint above `body` on the parent at the default pose, m: some joints shift their child by functions.
    fn place_m(&self, body: &str) -> Option<DVec3> {
        let joint = self.above.get(body)?;
        let placement = placement_at_default_pose(self.model, joint)?;
        Some(placement.point(joint.in_child.translation_m))
    }

    /// The length of the bones from the trunk to `body`, m, and the body of the trunk.
    fn length_m(&self, body: &'m str) -> Option<(f64, &'m str)> {
        let path: Vec<&str> = self.path(body).collect();
        let trunk = path.iter().position(|above| Side::of_name(above) != Side::of_name(body))?;
        let lengths = path.get(..trunk)?.windows(2).map(|bones| {
            let [bone, above] = bones else { return None };
            Some(self.place_m(bone)?.distance(self.above.get(above)?.in_child.translation_m))
        });
        Some((lengths.sum::<Option<f64>>()?, path.get(trunk)?))
    }
}

rule! { pub(super) FOOT_SPHERE_ON_GROUND: FootSphereOnGround, Warning, Sides;
    what: "A sphere is on ground or welded to it, and seems to be of a foot: its name says so, spheres named like it are on moving bodies, or no other moves.",
    why: "OpenSim takes ground if the frame of a sphere says so. The sphere then stays in place while the foot walks away, and the foot falls through the floor. Only scenery, such as a stone, belongs on ground.",
    advice: "Write the body of the foot as the frame of the sphere",
    repair: Repair::NotPossible("only numbers are changed, and the sphere needs another frame"),
    example: Example::Models { good: "check/known_contacts.osim", bad: "check/foot_sphere_on_ground.osim" },
}

/// Words in the names of spheres of feet.
pub(super) const FOOT_WORDS: [&str; 6] = ["heel", "toe", "foot", "calc", "hallux", "metatars"];
/// Words in the names of scenery and of marks on a floor.
const SCENERY_WORDS: [&str; 11] =
    ["plate", "rest", "stool", "step", "form", "mark", "stone", "rock", "boulder", "obstacle", "terrain"];

/// The name of a sphere without its side and its number: the spheres of both feet often have one such name.
pub(super) fn series_of(name: &str) -> String {
    without_side(name).replace(|letter: char| letter.is_ascii_digit(), "")
}

/// Spheres that are on ground or welded to it, belong to a foot, and are in forces with a half-space, in the order of their numbers. Scenery
/// on which feet stand is in forces of spheres alone.
pub(super) fn foot_spheres_on_ground(model: &Model) -> Vec<&Sphere> {
    let spheres = |needs_floor: bool| {
        let forces = model.forces().iter();
        let forces =
            forces.filter(move |force| !needs_floor || force.sets.iter().any(|set| set.half_spaces > 0));
        let used: BTreeSet<SphereId> = forces.flat_map(Force::spheres).copied().collect();
        used.into_iter().filter_map(|id| model.sphere(id))
    };
    let fixed: Vec<&Sphere> = spheres(true).filter(|sphere| sphere.fixed).collect();
    if fixed.is_empty() {
        return fixed;
    }
    let moving = spheres(false).filter(|sphere| !sphere.fixed).map(|sphere| series_of(&sphere.name));
    let moving: BTreeSet<String> = moving.collect();
    let is_of_foot = |sphere: &&Sphere| {
        let has = |words: &[&str]| words.iter().any(|word| has_word(&sphere.name, word));
        let is_named_so = has(&FOOT_WORDS) || moving.is_empty() || moving.contains(&series_of(&sphere.name));
        is_named_so && !has(&SCENERY_WORDS)
    };
    fixed.into_iter().filter(is_of_foot).collect()
}

/// One finding for all spheres of feet that are on ground.
pub(super) fn find_foot_sphere_on_ground(model: &Model) -> Vec<Finding> {
    let on_ground = foot_spheres_on_ground(model);
    let Some(first) = on_ground.first() else { return Vec::new() };
    let more = other_cases_in_words(on_ground.len(), "another sphere, too", "other spheres, too");
    let place = match &first.body {
        Some(body) => format!("on {}, which is welded to ground", shown(body)),
        None => "on ground".to_owned(),
    };
    let text = format!("{} belongs to a foot, and is {place}{more}", shown(&first.name));
    finding_about_spheres(&FOOT_SPHERE_ON_GROUND, text, on_ground.iter().copied()).into_iter().collect()
}

rule! { pub(super) ROOT_HELD: RootHeld, Remark, Standing;
    what: "The root of the model is held: nothing lets it move along gravity.",
    why: "What holds the root carries the body, so that the contacts carry nothing in a forward simulation: no change of theirs is seen there. Inverse analyses and test stands hold the root on purpose.",
    advice: "Nothing, if this is intended; else free the coordinate, or take the constraint out",
    repair: Repair::NotPossible("nothing is wrong"),
    example: Example::Models { good: "check/known_contacts.osim", bad: "check/root_held.osim" },
}

/// One finding for all roots that are held.
pub(super) fn find_root_held(model: &Model) -> Vec<Finding> {
    let spheres = model.loaded_spheres(&model.force_ids());
    let held = held_roots(model, spheres.iter().filter_map(|&id| model.sphere(id)?.body.as_deref()));
    let Some((root, why)) = held.first() else { return Vec::new() };
    let more = other_cases_in_words(held.len(), "another root, too", "other roots, too");
    let text =
        format!("{} is held: {why}; contacts carry nothing in a forward simulation{more}", shown(root));
    vec![Finding::new(&ROOT_HELD, text)]
}
