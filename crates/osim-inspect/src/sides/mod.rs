//! Pairs the contacts of the left side with those of the right side, and compares them.

mod mirror;
mod pairs;

use std::cell::OnceCell;
use std::collections::{BTreeMap, BTreeSet};

use contact_scaling::{RatioValues, Ratios};
use foldhash::{HashMap, HashMapExt};
use osim_model::messages::{four_significant_apart, shown};
use osim_model::{DVec3, Force, ForceId, Model, ParameterSet, Property, SetId, Side, Sphere, Value};

use crate::sides::mirror::{BodyPairs, bone_ratios, is_close};
use crate::sides::pairs::{SetsBySphere, SpherePairs, UnpairedSphere};
pub(crate) use pairs::{SAME_PLACE_OF_BONE, SideSphere, SpherePair, place_key};

/// The contacts of both sides of a model. Spheres at mirrored places are paired.
pub struct BothSides<'m> {
    pub(crate) model: &'m Model,
    forces_by_path: HashMap<&'m str, &'m Force>,
    sets_by_sphere: SetsBySphere<'m>,
    bodies: &'m BodyPairs,
    /// How often each number occurs in the contacts; they are counted when the first difference is found.
    counts: OnceCell<NumberCounts>,
    pub(crate) pairs: Vec<SpherePair<'m>>,
    /// Spheres without a counterpart, if both sides have spheres; else empty.
    pub(crate) unpaired: Vec<UnpairedSphere<'m>>,
    /// All spheres, if only one side has spheres although both sides have bodies; else empty.
    pub(crate) one_side: Vec<SideSphere<'m>>,
    /// Pairs of parameter sets, in the order of the forces on the left.
    set_pairs: Vec<SetPair<'m>>,
}

impl<'m> BothSides<'m> {
    /// Pairs the spheres and the parameter sets of both sides of `model`.
    pub fn of(model: &'m Model) -> Self {
        let sets_by_sphere = SetsBySphere::of(model);
        let spheres = sets_by_sphere.spheres_on_sides(model);
        let has_spheres_on = |side| spheres.iter().any(|sphere| sphere.side == side);
        let bodies = model.derived_from_bodies(BodyPairs::of);
        let (mut paired, mut one_side) = (SpherePairs::default(), Vec::new());
        match (has_spheres_on(Side::Right), has_spheres_on(Side::Left)) {
            (true, true) => paired = SpherePairs::of(spheres, bodies, model),
            (true, false) if bodies.has_side(Side::Left) => one_side = spheres,
            (false, true) if bodies.has_side(Side::Right) => one_side = spheres,
            _ => {}
        }
        let set_pairs = pair_sets(&paired.pairs, &sets_by_sphere);
        let mut forces_by_path = HashMap::new();
        for force in model.forces() {
            forces_by_path.entry(force.path.as_str()).or_insert(force);
        }
        let (SpherePairs { pairs, unpaired }, counts) = (paired, OnceCell::new());
        Self { model, forces_by_path, sets_by_sphere, bodies, counts, pairs, unpaired, one_side, set_pairs }
    }

    /// The force with this component path, if its spheres are on a side.
    pub fn force(&self, path: &str) -> Option<&'m Force> {
        self.forces_by_path.get(path).copied()
    }

    /// The force on the right side whose spheres are the mirror images of the spheres of `left`.
    pub(crate) fn right_counterpart(&self, left: &Force) -> Option<&'m Force> {
        self.set_pairs_of(left).first().map(|pair| pair.right.0)
    }

    /// The counterpart of the sphere with this name.
    pub(crate) fn counterpart(&self, name: &str) -> Option<&'m Sphere> {
        let pairs = self.pairs.iter().map(|pair| (pair.left.sphere, pair.right.sphere));
        let mut both_ways = pairs.flat_map(|(left, right)| [(left, right), (right, left)]);
        both_ways.find(|(one, _)| one.name == name).map(|(_, other)| other)
    }

    /// The forces of one side that have counterparts, in file order.
    pub(crate) fn forces_on(&self, side: Side) -> Vec<ForceId> {
        let force_on_side =
            |pair: &SetPair<'_>| if side == Side::Right { pair.right.0.id } else { pair.left.0.id };
        self.set_pairs.iter().map(force_on_side).collect::<BTreeSet<ForceId>>().into_iter().collect()
    }

    /// Whether the bones that carry the spheres of the force `left` have another size than the bones that carry their counterparts.
    pub(crate) fn bones_differ(&self, left: &str) -> bool {
        let sets = self.force(left).map(|left| self.set_pairs_of(left)).unwrap_or_default();
        let spheres = sets.iter().flat_map(|pair| &pair.spheres);
        let mut pairs = spheres.filter_map(|&index| self.pairs.get(index));
        pairs.any(|pair| {
            let ratios = bone_ratios(self.model, pair.left.body, pair.right.body);
            ratios.is_some_and(|ratios| ratios.into_iter().any(|ratio| !is_close(ratio, 1.0)))
        })
    }

    /// The side whose numbers are unlike most other contacts of the model, if `left` and its counterpart differ; `None` if no such majority
    /// exists.
    pub fn odd_side(&self, left: &Force) -> Option<Side> {
        let all = self.set_pairs_of(left).iter().flat_map(|pair| self.differences_of(pair));
        let mut odd = all.filter(|difference| !difference.is_small).map(|difference| difference.odd);
        let first = odd.next()??;
        odd.all(|side| side == Some(first)).then_some(first)
    }

    /// The wrong one of the force `left` and its counterpart, if they differ, and the other one: that on the side `odd`, or else the one
    /// unlike most other contacts of the model.
    pub(crate) fn odd_and_other(&self, left: &str, odd: Option<Side>) -> Option<(Side, [&'m Force; 2])> {
        let left = self.force(left)?;
        let both = [left, self.right_counterpart(left)?];
        match odd.or_else(|| self.odd_side(left))? {
            Side::Left => Some((Side::Left, both)),
            Side::Right => Some((Side::Right, [both[1], both[0]])),
        }
    }

    /// The parameter sets of `left`, each with its counterpart on the right.
    fn set_pairs_of(&self, left: &Force) -> &[SetPair<'m>] {
        let start = self.set_pairs.partition_point(|pair| pair.left.0.id < left.id);
        let end = self.set_pairs.partition_point(|pair| pair.left.0.id <= left.id);
        self.set_pairs.get(start..end).unwrap_or_default()
    }

    /// Pairs of forces that differ, the left one first, with their differences.
    pub(crate) fn differences(&self) -> Vec<(&'m Force, &'m Force, Vec<SideDifference>)> {
        let mut by_forces: BTreeMap<(ForceId, ForceId), (&Force, &Force, Vec<SideDifference>)> =
            BTreeMap::new();
        for pair in &self.set_pairs {
            let (left, right) = (pair.left.0, pair.right.0);
            let (_, _, all) = by_forces.entry((left.id, right.id)).or_insert((left, right, Vec::new()));
            all.extend(self.differences_of(pair));
        }
        by_forces.into_values().filter(|(_, _, differences)| !differences.is_empty()).collect()
    }

    /// The differences between the radii and parameters of two sets that are counterparts.
    fn differences_of(&self, pair: &SetPair<'_>) -> Vec<SideDifference> {
        let spheres = pair.spheres.iter().filter_map(|&index| self.pairs.get(index));
        let radii = spheres.filter_map(|spheres| radius_difference(spheres, self));
        // Radii come first, because other numbers may differ for that reason.
        radii.chain(pair.differing_values(self)).collect()
    }

    /// Whether a force that presses `sphere` on a floor is switched on.
    pub(crate) fn applies(&self, sphere: &Sphere) -> bool {
        self.sets_by_sphere.applies(sphere.id)
    }

    /// All moving spheres that meet a floor, in file order, each with its body and the centre in this body's frame, m.
    pub(crate) fn spheres(&self) -> impl Iterator<Item = (&'m Sphere, &'m str, DVec3)> {
        self.sets_by_sphere.spheres(self.model)
    }

    /// The length of the longest bone of the limb to which `body` belongs, m; `None` if no body of the limb has two joints.
    pub(crate) fn longest_bone_of_limb_m(&self, body: &str) -> Option<f64> {
        self.model.joint_distances().longest_in_limb(body)
    }

    /// The axis (0, 1 or 2) of the frame of `body` that leads sideways; `None` if no body of the other side is its mirror image in one axis.
    pub(crate) fn sideways_axis(&self, body: &str) -> Option<usize> {
        self.bodies.pair(body, self.model)?.reversed_axis()
    }

    /// The numbers that most contacts of the model have. They show which of two sides is wrong.
    fn usual(&self) -> &NumberCounts {
        self.counts.get_or_init(|| NumberCounts::of(self.model))
    }
}

/// Pairs the parameter sets whose spheres are counterparts.
fn pair_sets<'m>(pairs: &[SpherePair<'m>], sets_by_sphere: &SetsBySphere<'m>) -> Vec<SetPair<'m>> {
    let mut set_pairs: BTreeMap<(ForceId, SetId, ForceId, SetId), SetPair<'m>> = BTreeMap::new();
    for (index, pair) in pairs.iter().enumerate() {
        let sets = |sphere: &SideSphere<'_>| sets_by_sphere.get(sphere.sphere.id).iter().copied();
        for (left, right) in sets(&pair.left).zip(sets(&pair.right)) {
            let key = (left.0.id, left.1.id, right.0.id, right.1.id);
            let empty = || SetPair { right, left, spheres: Vec::new() };
            set_pairs.entry(key).or_insert_with(empty).spheres.push(index);
        }
    }
    set_pairs.into_values().collect()
}

// Differences between the contacts of two spheres that are counterparts.

/// The radii of a left and a right sphere differ little if they differ by at most this, relatively. Radii of published models differ by up
/// to 5.7 % between the sides.
const SMALL_RADIUS_DIFFERENCE: f64 = 0.1;
/// The radii of a left and a right sphere differ as their bones do if the two ratios differ by at most this, relatively.
const FOLLOWS_BONES_TOLERANCE: f64 = 0.01;
/// The transition velocities of both sides differ little if their ratio is at most this. The velocities differ by 5 % in one published
/// model, and by 200 times in models with a typing mistake.
const SMALL_VELOCITY_RATIO: f64 = 1.2;
/// Other numbers of both sides differ little if their ratio is at most this, as where those of one side were rounded.
const SMALL_RATIO: f64 = 1.01;

/// A number that differs between the sides.
#[derive(Debug, Clone)]
pub(crate) struct SideDifference {
    /// The difference in words that follow "differ: " in the finding.
    pub text: String,
    /// Whether the sides of published models differ by as much.
    pub is_small: bool,
    /// How many times the larger number is the smaller one.
    pub times: f64,
    /// The side that is unlike most other contacts of the model, if it is known.
    pub odd: Option<Side>,
}

/// How often each number, and each property, occurs in the contacts of a model.
#[derive(Debug, Default)]
struct NumberCounts {
    by_number: HashMap<(Property, u64), usize>,
    by_property: HashMap<Property, usize>,
}

impl NumberCounts {
    /// Counts the numbers of all forces that meet a floor, and of their spheres.
    fn of(model: &Model) -> Self {
        let mut counts = Self::default();
        for force in model.forces().iter().filter(|force| model.meets_half_space(force)) {
            for set in &force.sets {
                values_of_set(force, set).for_each(|value| counts.count_value(value));
                set.spheres
                    .iter()
                    .filter_map(|&id| model.sphere(id))
                    .for_each(|sphere| counts.count_value(&sphere.radius));
            }
        }
        counts
    }

    /// Counts one number of a contact.
    fn count_value(&mut self, value: &Value) {
        *self.by_number.entry((value.property, value.number.to_bits())).or_default() += 1;
        *self.by_property.entry(value.property).or_default() += 1;
    }

    /// How many other contacts have the number of `value`, if they are the majority of all contacts besides the two that are compared;
    /// else `None`. The other of the two is then the odd one.
    fn majority_with(&self, value: &Value) -> Option<usize> {
        let count = self.by_number.get(&(value.property, value.number.to_bits()))?.saturating_sub(1);
        let others = self.by_property.get(&value.property)?.saturating_sub(2);
        (2 * count > others).then_some(count)
    }

    /// The difference of `left` and `right`, in the words `what`, with the side that is unlike most other contacts.
    fn difference(&self, (left, right): (&Value, &Value), what: &str, is_small: bool) -> SideDifference {
        let [left_text, right_text] = four_significant_apart([left.number, right.number]);
        let with_right = self.majority_with(right).map(|count| (Side::Left, count, right_text));
        let with_left = || self.majority_with(left).map(|count| (Side::Right, count, left_text));
        let odd = with_right.or_else(with_left);
        let others = match &odd {
            Some((_, 1, number)) => format!(" (1 other has {number})"),
            Some((_, count, number)) => format!(" ({count} others have {number})"),
            None => String::new(),
        };
        let (text, odd) = (format!("{what}{others}"), odd.map(|(side, _, _)| side));
        SideDifference { text, is_small, times: times_apart(left, right), odd }
    }
}

/// How many times the larger of two numbers is the smaller one.
fn times_apart(left: &Value, right: &Value) -> f64 {
    (left.number / right.number).max(right.number / left.number)
}

/// The values of a parameter set, and the transition velocity of its force.
fn values_of_set<'m>(force: &'m Force, set: &'m ParameterSet) -> impl Iterator<Item = &'m Value> {
    let of_force = set.value(Property::TransitionVelocity).is_none().then_some(&force.transition_velocity);
    set.values.iter().chain(of_force)
}

/// A parameter set on the right and its counterpart on the left.
pub(crate) struct SetPair<'m> {
    pub right: (&'m Force, &'m ParameterSet),
    pub left: (&'m Force, &'m ParameterSet),
    /// Indices of the sphere pairs that make the sets counterparts.
    pub spheres: Vec<usize>,
}

impl SetPair<'_> {
    /// The numbers of the left set that are not equal to those of the right set, and do not follow from different radii.
    fn differing_values(&self, sides: &BothSides<'_>) -> Vec<SideDifference> {
        let ratios = self.radius_ratios(sides.model);
        let right =
            |property: Property| values_of_set(self.right.0, self.right.1).find(|r| r.property == property);
        let both = values_of_set(self.left.0, self.left.1).filter_map(|l| Some((l, right(l.property)?)));
        let differing = both.filter(|(l, r)| {
            let follows = |ratios| {
                radius_factor(l.property, ratios).is_some_and(|by| is_close(l.number, by * r.number))
            };
            !(l.number.is_nan() || is_close(l.number, r.number) || ratios.as_ref().is_some_and(follows))
        });
        let difference = |(l, r): (&Value, &Value)| {
            let [of_left, of_right] = four_significant_apart([l.number, r.number]);
            let what = format!("{} is {of_left} and {of_right}", l.property);
            let is_velocity = l.property == Property::TransitionVelocity;
            let most = if is_velocity { SMALL_VELOCITY_RATIO } else { SMALL_RATIO };
            sides.usual().difference((l, r), &what, (1.0..=most).contains(&times_apart(l, r)))
        };
        differing.map(difference).collect()
    }

    /// Scaling ratios from the right set to the left one, if their radii differ.
    fn radius_ratios(&self, model: &Model) -> Option<Ratios> {
        let mean_square = |set: &ParameterSet| -> f64 {
            let spheres =
                set.spheres.iter().filter_map(|&id| model.sphere(id)).filter(|sphere| !sphere.fixed);
            let squares: Vec<f64> = spheres.map(|sphere| sphere.radius.number.powi(2)).collect();
            let count = squares.len() as f64;
            squares.iter().sum::<f64>() / count
        };
        let radius = (mean_square(self.left.1) / mean_square(self.right.1)).sqrt();
        let values = RatioValues { mass: 1.0, sphere_count: 1.0, radius, gravity: 1.0 };
        (!is_close(radius, 1.0)).then(|| Ratios::new(values).ok()).flatten()
    }
}

/// The factor of a parameter if only the radius changes.
fn radius_factor(property: Property, ratios: &Ratios) -> Option<f64> {
    Some(match property {
        Property::Stiffness => ratios.plane_strain_modulus(),
        Property::Dissipation => ratios.dissipation(),
        Property::ConstantContactForce => ratios.constant_contact_force(),
        Property::HertzSmoothing => ratios.hertz_smoothing(),
        Property::HuntCrossleySmoothing => ratios.hunt_crossley_smoothing(),
        Property::TransitionVelocity => ratios.transition_velocity(),
        Property::ViscousFriction => ratios.viscous_friction(),
        _ => return None,
    })
}

/// The difference between the radii of a pair, unless the radii are equal or differ as the bones do.
fn radius_difference(pair: &SpherePair<'_>, sides: &BothSides<'_>) -> Option<SideDifference> {
    let (left, right) = (pair.left.sphere, pair.right.sphere);
    let ratio = left.radius.number / right.radius.number;
    let is_alike = left.radii_m.is_some() == right.radii_m.is_some();
    if !ratio.is_finite() || is_close(ratio, 1.0) || !is_alike {
        return None;
    }
    let ratios = bone_ratios(sides.model, pair.left.body, pair.right.body);
    let from_bones = ratios.map(|[x, y, z]| distance_from_nearest(ratio, &[libm::cbrt(x * y * z), x, y, z]));
    if from_bones.is_some_and(|apart| apart <= FOLLOWS_BONES_TOLERANCE) {
        return None;
    }
    let is_small = from_bones.unwrap_or(f64::INFINITY).min(distance_from_nearest(ratio, &[1.0]))
        <= SMALL_RADIUS_DIFFERENCE;
    let [left_m, right_m] = four_significant_apart([left.radius.number, right.radius.number]);
    let (left_name, right_name) = (shown(&left.name), shown(&right.name));
    let what = format!("radius is {left_m} m for {left_name} and {right_m} m for {right_name}");
    Some(sides.usual().difference((&left.radius, &right.radius), &what, is_small))
}

/// The relative distance of `ratio` from the nearest number in `expected`.
fn distance_from_nearest(ratio: f64, expected: &[f64]) -> f64 {
    expected.iter().map(|expected| (ratio / expected - 1.0).abs()).fold(f64::INFINITY, f64::min)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_foot_has_no_counterpart() {
        let model =
            Model::parse(include_bytes!("../../../osim-model/tests/data/one_foot.osim").as_slice()).unwrap();
        assert!(BothSides::of(&model).right_counterpart(&model.forces()[0]).is_none());
    }
}
