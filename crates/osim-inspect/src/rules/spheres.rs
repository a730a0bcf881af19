//! Rules about places and radii of spheres on their bodies.

use std::collections::{BTreeMap, BTreeSet};

use foldhash::{HashMap, HashMapExt};
use osim_model::messages::{four_significant, shown, three_significant};
use osim_model::{
    Body, BodyShape, DVec3, Example, Finding, MassRequest, Model, Repair, Rule, Side, Sphere, without_side,
};

use crate::body_bones::BodyBones;
use crate::sides::{BothSides, place_key};
use osim_model::rule;

/// A finding about all of `spheres`, placed at the first sphere; `None` if `spheres` is empty.
pub(super) fn finding_about_spheres<'s>(
    rule: &'static Rule,
    text: String,
    spheres: impl Iterator<Item = &'s Sphere> + Clone,
) -> Option<Finding> {
    let first = spheres.clone().next()?;
    let (places, names) = spheres.map(|sphere| (sphere.path.clone(), sphere.name.clone())).unzip();
    let finding = Finding::at(rule, first.position, text).with_place(&first.path).with_spheres(names);
    Some(Finding { places, ..finding })
}

/// The end of a message about the first of `count` cases: empty for one case, `one` for two cases; for more, the number of the other cases
/// and `several`.
pub(super) fn other_cases_in_words(count: usize, one: &str, several: &str) -> String {
    match count {
        0 | 1 => String::new(),
        2 => format!("; {one}"),
        count => format!("; {} {several}", count - 1),
    }
}

/// A sphere is too far from the nearest joint of its body if the distance exceeds this part of the limb's longest bone. Published spheres
/// are at most 0.353 away.
const LARGEST_DISTANCE_OVER_BONE: f64 = 0.6;
/// Like [`LARGEST_DISTANCE_OVER_BONE`], for a body without a side. This only finds another unit, because such a body, for example the last link of a
/// pendulum, can be long.
const LARGEST_DISTANCE_OVER_BONE_WITHOUT_SIDE: f64 = 10.0;
/// A sphere within this many radii of gyration of the centre of mass of its body is not too far. Published spheres are at most 2.7 away.
const NEAR_DISTANCE_IN_GYRATION_RADII: f64 = 4.0;
/// Like [`LARGEST_DISTANCE_OVER_BONE`], for the distance sideways. In the 13 models of the corpus with two sides it is at most 0.149 (the outer toes of
/// Falisse et al.), because a foot is longer than wide.
const LARGEST_SIDEWAYS_DISTANCE_OVER_BONE: f64 = 0.25;
/// Like [`NEAR_DISTANCE_IN_GYRATION_RADII`], for the distance sideways. In the corpus it is at most 2.8, for spheres at 0.149 of the bone; a foot without
/// a limb has spheres at 0.38 of its own bone and less than 2 radii of gyration.
const NEAR_SIDEWAYS_DISTANCE_IN_GYRATION_RADII: f64 = 2.0;

rule! { pub(super) ODD_PLACE: OddPlace, Warning, Sizes;
    what: "A sphere is far from the body that carries it.",
    why: "Spheres of published feet are at most 0.353 of the limb's longest bone from the nearest joint of their body, and at most 2.7 of its radii of gyration from its centre of mass; sideways at most 0.149 of that bone. Much more is a place in millimetres, or one in another frame.",
    advice: "Look at `plot MODEL output=FILE.svg kind=feet`; write places in metres, in the frame of the body",
    repair: Repair::NotPossible("only you know the right place"),
    example: Example::Piece { model: "table1/human_62kg_smooth_sphere.osim",
        good: "<location>-0.029760000000000002 -0.037199999999999997 -0.048000000000000001</location>",
        bad: "<location>-29.76 -37.2 -48</location>" },
}

/// One finding for all spheres that are too far from their bodies; it is about the farthest.
pub(super) fn find_odd_place(sides: &BothSides<'_>) -> Option<Finding> {
    let shapes = sides.model.body_shapes();
    let mut bodies: HashMap<&str, Option<BodyExtent<'_>>> = HashMap::new();
    let mut far: Vec<FarSphere<'_>> = Vec::new();
    for (sphere, body, place_m) in sides.spheres() {
        let extent = bodies.entry(body).or_insert_with(|| BodyExtent::of(body, shapes.get(body)?, sides));
        far.extend(extent.as_ref().and_then(|extent| extent.find_far_sphere(sphere, place_m)));
    }
    far.sort_by(|a, b| b.times_limit().total_cmp(&a.times_limit()));
    let worst = far.first()?;
    let text = describe_far(worst, far.len());
    let finding = finding_about_spheres(&ODD_PLACE, text, far.iter().map(|far| far.sphere))?;
    Some(finding.with_measure(worst.times_limit(), ""))
}

/// The size of a body, with which the distances of its spheres are compared.
struct BodyExtent<'m> {
    shape: &'m BodyShape,
    /// The limb's longest bone, m.
    bone_m: f64,
    /// The largest distance of a sphere from the nearest joint, as a part of `bone_m`.
    limit: f64,
    /// The axis of the body's frame that leads sideways.
    sideways: Option<usize>,
}

/// A sphere and its distance from the nearest joint of its body.
struct FarSphere<'m> {
    sphere: &'m Sphere,
    from_joint_m: f64,
    bone_m: f64,
    limit: f64,
    is_sideways: bool,
}

impl<'m> BodyExtent<'m> {
    /// The size of `body`, and how far its spheres may be; `None` if no bone of its limb has a length.
    fn of(body: &str, shape: &'m BodyShape, sides: &BothSides<'_>) -> Option<Self> {
        let has_side = Side::of_name(body).is_some();
        let limit =
            if has_side { LARGEST_DISTANCE_OVER_BONE } else { LARGEST_DISTANCE_OVER_BONE_WITHOUT_SIDE };
        let sideways = sides.sideways_axis(body).filter(|_| has_side);
        Some(Self { shape, bone_m: sides.longest_bone_of_limb_m(body)?, limit, sideways })
    }

    /// The distance of `sphere` from the nearest joint, if it is too large in any direction, or else sideways.
    fn find_far_sphere<'s>(&self, sphere: &'s Sphere, place_m: DVec3) -> Option<FarSphere<'s>> {
        let far = |from_joint_m, limit, is_sideways| FarSphere {
            sphere,
            from_joint_m,
            bone_m: self.bone_m,
            limit,
            is_sideways,
        };
        let in_all_axes = far(self.nearest_joint_m(|joint_m| joint_m.distance(place_m)), self.limit, false);
        let from_centre_m = self.shape.centre_m.distance(place_m);
        if in_all_axes.is_too_far() && !self.is_near(from_centre_m, NEAR_DISTANCE_IN_GYRATION_RADII) {
            return Some(in_all_axes);
        }
        let axis = self.sideways?;
        let apart = |other: DVec3| (other[axis] - place_m[axis]).abs();
        let sideways = far(self.nearest_joint_m(apart), LARGEST_SIDEWAYS_DISTANCE_OVER_BONE, true);
        let is_near = self.is_near(apart(self.shape.centre_m), NEAR_SIDEWAYS_DISTANCE_IN_GYRATION_RADII);
        (sideways.is_too_far() && !is_near).then_some(sideways)
    }

    /// The distance to the nearest joint, m; infinite without joints.
    fn nearest_joint_m(&self, apart: impl Fn(DVec3) -> f64) -> f64 {
        self.shape.joints_m.iter().map(|&joint_m| apart(joint_m)).fold(f64::INFINITY, f64::min)
    }

    /// Whether a distance from the centre of mass is at most `radii` radii of gyration.
    fn is_near(&self, from_centre_m: f64, radii: f64) -> bool {
        self.shape.gyration_m.is_some_and(|gyration_m| from_centre_m <= radii * gyration_m)
    }
}

impl FarSphere<'_> {
    /// The distance from the joint as a part of the limb's longest bone.
    fn part_of_bone(&self) -> f64 {
        self.from_joint_m / self.bone_m
    }

    /// The distance divided by the largest allowed distance.
    fn times_limit(&self) -> f64 {
        self.part_of_bone() / self.limit
    }

    /// Whether the distance exceeds the largest allowed one.
    fn is_too_far(&self) -> bool {
        self.times_limit().is_finite() && self.times_limit() > 1.0
    }
}

/// The message about the farthest of `count` spheres that are too far from their bodies.
fn describe_far(worst: &FarSphere<'_>, count: usize) -> String {
    let more = other_cases_in_words(count, "another sphere, too", "other spheres, too");
    format!(
        "{} is {} m{} from the nearest joint of {}, {} of the limb's longest bone ({} m), expected at most {}{more}",
        shown(&worst.sphere.name),
        three_significant(worst.from_joint_m),
        if worst.is_sideways { " sideways" } else { "" },
        shown(worst.sphere.body.as_deref().unwrap_or_default()),
        three_significant(worst.part_of_bone()),
        three_significant(worst.bone_m),
        worst.limit
    )
}

/// Plausible radii as parts of the limb's longest bone. Published radii are 0.011 to 0.2.
const RADIUS_OF_BONE: std::ops::RangeInclusive<f64> = 0.005..=0.3;
/// A radius above this part of the longest bone is larger than the foot is high. It is odd if the spheres of the foot are also close
/// together for it.
const LARGE_RADIUS_OF_BONE: f64 = 0.15;
/// A radius above this, m/kg^(1/3), is that of a model in another unit. Published radii on limbs are at most 0.07.
const LARGEST_RADIUS_OF_MASS: f64 = 0.15;
/// A radius above this part of the extent of the foot's sphere centres is large for them. Published radii are at most 0.3 if a foot has
/// several spheres and no radius is above 0.15 of the bone.
const LARGE_RADIUS_OF_EXTENT: f64 = 0.36;

rule! { pub(super) ODD_RADIUS: OddRadius, Warning, Sizes;
    what: "The radius of a sphere does not fit the length of its limb.",
    why: "Radii of published feet are 0.011 to 0.2 of the limb's longest bone, and in 95 % of them 0.2 to 29 mm times the cube root of the body mass in kg. Much more or less is another unit, mostly millimetres, or another animal's sphere.",
    advice: "Write radii in metres; contacts of a model of another size need radii that follow it",
    repair: Repair::NotPossible("only you know the right size"),
    example: Example::Piece { model: "table1/human_62kg_smooth_sphere.osim",
        good: "<radius>0.032000000000000001</radius>", bad: "<radius>32</radius>" },
}

/// One finding for all odd radii; it is about the radius that is farthest outside the range.
pub(super) fn find_odd_radius(sides: &BothSides<'_>) -> Option<Finding> {
    let extents = FootExtents::of(sides);
    let find = |(sphere, body, _): (_, &str, _)| {
        let bone_m = sides.longest_bone_of_limb_m(body)?;
        let is_foot = extents.bones.is_some_and(|bones| bones.is_foot(body));
        if is_foot || Side::of_name(body).is_some() {
            return find_odd_radius_of_sphere(sphere, bone_m, extents.extent_m(body));
        }
        // A trunk is as large as the bones around it.
        let around_m = sides.model.joint_distances().longest_around_body(body);
        find_odd_radius_of_sphere(sphere, around_m.map_or(bone_m, |around_m| around_m.max(bone_m)), None)
    };
    let mut odd: Vec<OddRadius<'_>> = sides.spheres().filter_map(find).collect();
    odd.sort_by(|a, b| b.times_limit().total_cmp(&a.times_limit()));
    let Some(worst) = odd.first() else { return find_large_against_mass(sides) };
    let text = describe_odd_radius(worst, odd.len());
    let finding = finding_about_spheres(&ODD_RADIUS, text, odd.iter().map(|odd| odd.sphere))?;
    Some(finding.with_measure(worst.times_limit(), ""))
}

/// One finding for all radii on limbs that are too large against the mass, though not against the bones: all lengths are in another unit.
fn find_large_against_mass(sides: &BothSides<'_>) -> Option<Finding> {
    let kg = MassRequest::default().bodies_kg(sides.model).filter(|kg| *kg > 0.0)?;
    let largest_m = LARGEST_RADIUS_OF_MASS * libm::cbrt(kg);
    let on_limbs = sides.spheres().filter(|(_, body, _)| sides.longest_bone_of_limb_m(body).is_some());
    let large = on_limbs.map(|(sphere, _, _)| sphere).filter(|one| one.radius.number > largest_m);
    let large: Vec<&Sphere> = large.collect();
    let first = large.first()?;
    let text = format!(
        "radius of {} is {} m, expected at most {} m for a body of {} kg{}",
        shown(&first.name),
        four_significant(first.radius.number),
        three_significant(largest_m),
        four_significant(kg),
        other_cases_in_words(large.len(), "another radius, too", "other radii, too")
    );
    let times = large.iter().map(|one| one.radius.number / largest_m).fold(1.0, f64::max);
    Some(finding_about_spheres(&ODD_RADIUS, text, large.iter().copied())?.with_measure(times, ""))
}

/// A sphere whose radius is too large or too small for its limb.
struct OddRadius<'m> {
    sphere: &'m Sphere,
    bone_m: f64,
    part_of_bone: f64,
}

impl OddRadius<'_> {
    /// How many times the radius is too large or too small.
    fn times_limit(&self) -> f64 {
        (self.part_of_bone / RADIUS_OF_BONE.end()).max(RADIUS_OF_BONE.start() / self.part_of_bone)
    }
}

/// The sphere, if its radius is too large or too small for the limb.
fn find_odd_radius_of_sphere(sphere: &Sphere, bone_m: f64, extent_m: Option<f64>) -> Option<OddRadius<'_>> {
    let radius_m = sphere.radius_m().ok()?;
    let part_of_bone = radius_m / bone_m;
    let is_large = part_of_bone > LARGE_RADIUS_OF_BONE
        && extent_m.is_some_and(|extent_m| radius_m > LARGE_RADIUS_OF_EXTENT * extent_m);
    let is_odd = is_large || !RADIUS_OF_BONE.contains(&part_of_bone);
    is_odd.then_some(OddRadius { sphere, bone_m, part_of_bone })
}

/// How far the sphere centres of each foot extend.
struct FootExtents<'m> {
    bones: Option<&'m BodyBones>,
    places: BTreeMap<&'m str, Vec<DVec3>>,
}

impl<'m> FootExtents<'m> {
    /// The sphere centres of each foot of a model.
    fn of(sides: &BothSides<'m>) -> Self {
        let bodies: BTreeSet<&str> = sides.spheres().map(|(_, body, _)| body).collect();
        let mut extents = Self { bones: BodyBones::of(sides.model), places: BTreeMap::new() };
        for (_, body, place_m) in sides.spheres() {
            let (hind, origin_m) =
                extents.hind_part(body).filter(|(hind, _)| bodies.contains(hind)).unwrap_or_default();
            let hind = if hind.is_empty() { body } else { hind };
            extents.places.entry(hind).or_default().push(place_m + origin_m);
        }
        extents
    }

    /// The body that carries `body` by a joint, and the origin of `body` in it, m, if their frames are parallel.
    fn hind_part(&self, body: &str) -> Option<(&'m str, DVec3)> {
        let joint = self.bones?.joint_above(body)?;
        Some((joint.parent.as_str(), joint.in_parent_m - joint.in_child_m))
    }

    /// The largest extent of the sphere centres on `body`, together with the bodies that it carries or that carry it, along an axis, m;
    /// `None` if there is only one sphere.
    fn extent_m(&self, body: &str) -> Option<f64> {
        let hind = self.hind_part(body).map(|(hind, _)| hind);
        let places =
            self.places.get(body).or_else(|| self.places.get(hind?)).filter(|places| places.len() > 1)?;
        let least = places.iter().copied().fold(DVec3::INFINITY, DVec3::min);
        Some((places.iter().copied().fold(DVec3::NEG_INFINITY, DVec3::max) - least).max_element())
    }
}

/// The message about the oddest of `count` radii.
fn describe_odd_radius(worst: &OddRadius<'_>, count: usize) -> String {
    let is_large = RADIUS_OF_BONE.contains(&worst.part_of_bone);
    let more = other_cases_in_words(count, "another radius, too", "other radii, too");
    format!(
        "radius of {} is {} m, {} of the limb's longest bone ({} m), expected {} to {}{more}",
        shown(&worst.sphere.name),
        four_significant(worst.sphere.radius.number),
        three_significant(worst.part_of_bone),
        three_significant(worst.bone_m),
        RADIUS_OF_BONE.start(),
        if is_large { LARGE_RADIUS_OF_BONE } else { *RADIUS_OF_BONE.end() }
    )
}

/// The number of bodies of a limb above its foot among which the heaviest one is found.
const MOST_BODIES_ABOVE: usize = 8;

rule! { pub(super) HEAVY_FOOT: HeavyFoot, Warning, Mass;
    what: "A body with spheres weighs more than each body of its limb above it, or a body of a limb weighs more than a fifth of the whole body and more than three times its counterpart.",
    why: "A foot is lighter than the thigh: in published models it weighs 1 to 2 % of the body. A heavier one mostly has the mass of another body, or a decimal point in the wrong place, and swings as no foot does.",
    advice: "Write the mass of the body in kg",
    repair: Repair::NotPossible("only you know what the body weighs"),
    example: Example::Piece { model: "table1/human_62kg_smooth_sphere.osim", good: "<mass>0.7734375</mass>",
        bad: "<mass>7.734375</mass>" },
}

/// A body of a limb weighs less than this part of the whole body, and less than so many times its counterpart.
const MOST_OF_WHOLE_BODY: f64 = 0.2;
const MOST_TIMES_COUNTERPART: f64 = 3.0;

/// The first body that is too heavy against the whole body and its counterpart: its name and mass, and the counterpart's mass and name.
fn find_heavier_than_counterpart(
    model: &Model,
    kg: impl Fn(&str) -> Option<f64>,
) -> Option<(&str, f64, (f64, &str))> {
    let names = || model.bodies().iter().map(|body| body.name.as_str());
    let whole_kg: f64 = names().filter_map(&kg).sum();
    names().find_map(|body| {
        let (side, body_kg) = (Side::of_name(body)?, kg(body)?);
        let is_counterpart = |other: &&str| {
            Side::of_name(other) == Some(side.other()) && without_side(other) == without_side(body)
        };
        let other = names().filter(|_| body_kg > MOST_OF_WHOLE_BODY * whole_kg).find(is_counterpart)?;
        let is_lighter = |other_kg: &f64| *other_kg > 0.0 && body_kg > MOST_TIMES_COUNTERPART * other_kg;
        let other_kg = kg(other).filter(is_lighter)?;
        Some((body, body_kg, (other_kg, other)))
    })
}

/// One finding for all bodies with spheres that are heavier than the rest of their limb, if the limb has at least two bodies above.
pub(super) fn find_heavy_foot(sides: &BothSides<'_>) -> Option<Finding> {
    let bones = BodyBones::of(sides.model)?;
    let all: HashMap<&str, &Body> =
        sides.model.bodies().iter().map(|body| (body.name.as_str(), body)).collect();
    let kg = |name: &str| all.get(name)?.mass_kg().ok().filter(|kg| *kg > 0.0);
    let bodies: BTreeSet<&str> = sides.spheres().map(|(_, body, _)| body).collect();
    let mut heavy = Vec::new();
    for foot in bodies {
        let (Some(side), Some(foot_kg)) = (Side::of_name(foot), kg(foot)) else { continue };
        let parent = |body: &&str| Some(bones.joint_above(body)?.parent.as_str());
        let above = std::iter::successors(parent(&foot), parent).take(MOST_BODIES_ABOVE);
        let above = above.filter(|body| Side::of_name(body) == Some(side));
        let above: Vec<(f64, &str)> = above.filter_map(|body| Some((kg(body)?, body))).collect();
        let heaviest = above.iter().copied().max_by(|(a, _), (b, _)| a.total_cmp(b));
        heavy.extend(
            heaviest.filter(|(kg, _)| above.len() > 1 && foot_kg > *kg).map(|most| (foot, foot_kg, most)),
        );
    }
    let more = other_cases_in_words(heavy.len(), "another foot, too", "other feet, too");
    let heavier = heavy.first().copied().or_else(|| find_heavier_than_counterpart(sides.model, kg));
    let (heavy_body, heavy_kg, (kg, other)) = heavier?;
    let [heavy, light] = [heavy_kg, kg].map(three_significant);
    let text =
        format!("{} weighs {heavy} kg, more than {} ({light} kg){more}", shown(heavy_body), shown(other));
    let body = all.get(heavy_body)?;
    let position = sides.model.file(body.file).position(body.mass.offset);
    Some(Finding::at(&HEAVY_FOOT, position, text).with_place(&body.path).with_measure(heavy_kg / kg, ""))
}

/// Spheres of one body are crowded if they extend over less than this part of the limb's longest bone. In the corpus they extend over 0.077
/// (the forefoot of D'Hondt et al.) to 0.9.
const CROWD_DISTANCE_OVER_BONE: f64 = 0.02;
/// Spheres of one body are only crowded if they also extend over less than this part of the smallest radius. In the corpus two spheres are
/// at least 1.36 radii apart.
const CROWD_DISTANCE_OVER_RADIUS: f64 = 0.5;

rule! { pub(super) CROWDED_SPHERES: CrowdedSpheres, Warning, Sizes;
    what: "All spheres of a body are in nearly the same place.",
    why: "The spheres of a published foot extend over at least 0.077 of the limb's longest bone, and no two are closer than 1.36 radii. Spheres that nearly coincide carry like one that is several times as stiff. Usually their places were in metres, and were divided by 1000 as if they were millimetres.",
    advice: "Look at `plot MODEL output=FILE.svg kind=feet`; write places in metres, in the frame of the body",
    repair: Repair::NotPossible("only you know the right places"),
    example: Example::Models { good: "check/known_contacts.osim", bad: "check/crowded_spheres.osim" },
}

/// One finding for all crowded spheres, about the body whose spheres are the most crowded.
pub(super) fn find_crowded_spheres(sides: &BothSides<'_>) -> Option<Finding> {
    let mut by_body: BTreeMap<&str, Vec<(&Sphere, DVec3)>> = BTreeMap::new();
    for (sphere, body, place_m) in sides.spheres().filter(|(_, body, _)| Side::of_name(body).is_some()) {
        by_body.entry(body).or_default().push((sphere, place_m));
    }
    let crowds =
        by_body.iter().filter_map(|(body, spheres)| find_crowd(spheres, sides.longest_bone_of_limb_m(body)?));
    let mut crowds: Vec<Crowd<'_>> = crowds.collect();
    let on_sides = || by_body.values().flatten();
    if by_body.len() > 1 && on_sides().all(|(_, place_m)| *place_m == DVec3::ZERO) {
        let text = format!("all {} spheres are at the origins of their bodies", on_sides().count());
        let finding = finding_about_spheres(&CROWDED_SPHERES, text, on_sides().map(|(sphere, _)| *sphere))?;
        return Some(finding.with_measure(0.0, ""));
    }
    crowds.sort_by(|a, b| a.part_of_bone().total_cmp(&b.part_of_bone()));
    let worst = crowds.first()?;
    let text = describe_crowd(worst, crowds.len())?;
    let spheres = crowds.iter().flat_map(|crowd| &crowd.spheres).copied();
    // The smallest crowd is the worst.
    Some(finding_about_spheres(&CROWDED_SPHERES, text, spheres)?.with_measure(-worst.part_of_bone(), ""))
}

/// Spheres of one body that are nearly in one place.
struct Crowd<'m> {
    spheres: Vec<&'m Sphere>,
    extent_m: f64,
    bone_m: f64,
}

impl Crowd<'_> {
    /// The extent of the spheres as a part of the limb's longest bone.
    fn part_of_bone(&self) -> f64 {
        self.extent_m / self.bone_m
    }
}

/// The spheres, if they are crowded. `None` also if all spheres are at exactly one place: they are doubled, which is another finding.
fn find_crowd<'m>(spheres: &[(&'m Sphere, DVec3)], bone_m: f64) -> Option<Crowd<'m>> {
    let places: BTreeSet<[i64; 3]> = spheres.iter().map(|(_, place_m)| place_key(*place_m)).collect();
    let smallest_radius_m =
        spheres.iter().map(|(sphere, _)| sphere.radius.number).fold(f64::INFINITY, f64::min);
    let crowd = Crowd {
        spheres: spheres.iter().map(|(sphere, _)| *sphere).collect(),
        extent_m: extent_m(spheres),
        bone_m,
    };
    let is_crowd = crowd.part_of_bone() < CROWD_DISTANCE_OVER_BONE
        && crowd.extent_m < CROWD_DISTANCE_OVER_RADIUS * smallest_radius_m;
    (places.len() > 1 && is_crowd).then_some(crowd)
}

/// The diagonal of the box around the centres of the spheres, m.
fn extent_m(spheres: &[(&Sphere, DVec3)]) -> f64 {
    let places = || spheres.iter().map(|(_, place_m)| *place_m);
    places().fold(DVec3::INFINITY, DVec3::min).distance(places().fold(DVec3::NEG_INFINITY, DVec3::max))
}

/// The message about the most crowded of `count` bodies.
fn describe_crowd(worst: &Crowd<'_>, count: usize) -> Option<String> {
    let more = match count {
        1 => String::new(),
        2 => "; those of another body, too".to_owned(),
        count => format!("; those of {} other bodies, too", count - 1),
    };
    let first = worst.spheres.first()?;
    Some(format!(
        "the {} spheres of {} are within {} m, {} of the limb's longest bone ({} m), expected at least {CROWD_DISTANCE_OVER_BONE}{more}",
        worst.spheres.len(),
        shown(first.body.as_deref().unwrap_or_default()),
        three_significant(worst.extent_m),
        three_significant(worst.part_of_bone()),
        three_significant(worst.bone_m),
    ))
}

rule! { pub(super) DOUBLED_SPHERES: DoubledSpheres, Error, Sides;
    what: "Two spheres are at the same place of the same body.",
    why: "Both carry weight: the contact is twice as stiff as it looks, and the weight is shared among too many spheres. None of 200 published models has such spheres; they appear when a sphere is copied under another name.",
    advice: "Remove one of the two, and its force, from the file",
    repair: Repair::NotPossible("only you know which of the two is right"),
    example: Example::Piece { model: "format/v40000.osim", good: "<location>0.01 -0.02 0</location>",
        bad: "<location>0.18 -0.02 0</location>" },
}

/// One finding for all spheres at the same place as an earlier sphere.
pub(super) fn find_doubled_spheres(sides: &BothSides<'_>) -> Option<Finding> {
    let mut first_at: HashMap<(&str, [i64; 3]), &Sphere> = HashMap::new();
    let mut doubled: Vec<[&Sphere; 2]> = Vec::new();
    for (sphere, body, place_m) in sides.spheres().filter(|(sphere, _, _)| sides.applies(sphere)) {
        let first = *first_at.entry((body, place_key(place_m))).or_insert(sphere);
        if first.id != sphere.id {
            doubled.push([first, sphere]);
        }
    }
    let [first, second] = *doubled.first()?;
    let more = other_cases_in_words(doubled.len(), "another pair, too", "other pairs, too");
    let body = second.body.as_deref().unwrap_or_default();
    let text = format!(
        "{} and {} are at the same place of {}{more}",
        shown(&first.name),
        shown(&second.name),
        shown(body)
    );
    finding_about_spheres(&DOUBLED_SPHERES, text, doubled.iter().map(|[_, second]| *second))
}
