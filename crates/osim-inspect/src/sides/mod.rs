//! Contacts of the left and the right side, paired and compared.

mod mirror;
mod pairs;

use std::cell::OnceCell;
use std::collections::{BTreeMap, BTreeSet};

use contact_scaling::{RatioValues, Ratios};
use foldhash::{HashMap, HashMapExt};
use osim_model::messages::{readable, shown};
use osim_model::{DVec3, Force, ForceId, Model, ParameterSet, Property, SetId, Side, Sphere, Value};

use crate::sides::mirror::{BodyPairs, Bones, close};
use crate::sides::pairs::{Pairs, Users};
pub(crate) use pairs::{Alone, Placed, SAME_PLACE, SpherePair, place_key};

/// The contacts of both sides, paired by mirrored place: from [`BothSides::of`].
#[derive(Debug)]
pub struct BothSides<'m> {
    pub(crate) model: &'m Model,
    by_path: HashMap<&'m str, &'m Force>,
    users: Users<'m>,
    bones: Bones<'m>,
    bodies: &'m BodyPairs,
    usual: Usual<'m>,
    pub(crate) pairs: Vec<SpherePair<'m>>,
    /// Spheres without a counterpart, where both sides have spheres.
    pub(crate) alone: Vec<Alone<'m>>,
    /// The spheres of a model that has spheres on one side alone, although it has bodies on both.
    pub(crate) one_side: Vec<Placed<'m>>,
    /// In the order of the forces on the left.
    sets: Vec<SetPair<'m>>,
}

impl<'m> BothSides<'m> {
    /// The contacts of both sides, paired.
    pub fn of(model: &'m Model) -> Self {
        let users = Users::of(model);
        let bones = Bones::of(model);
        let spheres = users.on_sides(model);
        let has = |side| spheres.iter().any(|placed| placed.side == side);
        let bodies = model.derived_from_bodies(BodyPairs::of);
        let (mut found, mut one_side) = (Pairs::default(), Vec::new());
        match (has(Side::Right), has(Side::Left)) {
            (true, true) => found = Pairs::of(spheres, bodies, &bones),
            (true, false) if bodies.has(Side::Left) => one_side = spheres,
            (false, true) if bodies.has(Side::Right) => one_side = spheres,
            _ => {}
        }
        let sets = set_pairs(&found.pairs, &users);
        let mut by_path = HashMap::new();
        for force in model.forces() {
            by_path.entry(force.path.as_str()).or_insert(force);
        }
        let (usual, Pairs { pairs, alone }) = (Usual::of(model), found);
        Self { model, by_path, users, bones, bodies, usual, pairs, alone, one_side, sets }
    }

    pub fn force(&self, path: &str) -> Option<&'m Force> {
        self.by_path.get(path).copied()
    }

    /// The force on the right whose spheres are the mirror images of those of `left`.
    pub(crate) fn right_of(&self, left: &Force) -> Option<&'m Force> {
        self.sets_of(left).first().map(|pair| pair.right.0)
    }

    /// The forces of one side that have counterparts, in file order.
    pub(crate) fn forces_on(&self, side: Side) -> Vec<ForceId> {
        let of = |pair: &SetPair<'_>| if side == Side::Right { pair.right.0.id } else { pair.left.0.id };
        self.sets.iter().map(of).collect::<BTreeSet<ForceId>>().into_iter().collect()
    }

    /// Whether the bones under the spheres of `left` are of another size than those under `right`.
    pub(crate) fn bones_differ(&self, left: &Force, right: &Force) -> bool {
        let sets = self.sets_of(left).iter().filter(|pair| pair.right.0.id == right.id);
        let spheres = sets.flat_map(|pair| &pair.spheres);
        let mut pairs = spheres.filter_map(|&index| self.pairs.get(index));
        pairs.any(|pair| {
            let ratios = self.bones.ratios(pair.left.body, pair.right.body);
            ratios.is_some_and(|ratios| ratios.into_iter().any(|ratio| !close(ratio, 1.0)))
        })
    }

    /// The side whose numbers are unlike those of most other contacts of the model, where `left` and its counterpart differ;
    /// `None` if the majority does not show it.
    pub fn odd_side(&self, left: &Force) -> Option<Side> {
        let all = self.sets_of(left).iter().flat_map(|pair| self.differences_of(pair));
        let mut odd = all.filter(|difference| !difference.is_small).map(|difference| difference.odd);
        let first = odd.next()??;
        odd.all(|side| side == Some(first)).then_some(first)
    }

    /// The parameter sets of `left` that have counterparts.
    fn sets_of(&self, left: &Force) -> &[SetPair<'m>] {
        let start = self.sets.partition_point(|pair| pair.left.0.id < left.id);
        let end = self.sets.partition_point(|pair| pair.left.0.id <= left.id);
        self.sets.get(start..end).unwrap_or_default()
    }

    /// Forces that differ, the left one first, with what differs.
    pub(crate) fn differences(&self) -> Vec<(&'m Force, &'m Force, Vec<Difference>)> {
        let mut found: BTreeMap<(ForceId, ForceId), (&Force, &Force, Vec<Difference>)> = BTreeMap::new();
        for pair in &self.sets {
            let (left, right) = (pair.left.0, pair.right.0);
            let (_, _, all) = found.entry((left.id, right.id)).or_insert((left, right, Vec::new()));
            all.extend(self.differences_of(pair));
        }
        found.into_values().filter(|(_, _, differences)| !differences.is_empty()).collect()
    }

    fn differences_of(&self, pair: &SetPair<'_>) -> Vec<Difference> {
        let spheres = pair.spheres.iter().filter_map(|&index| self.pairs.get(index));
        let radii = spheres.filter_map(|spheres| of_radii(spheres, &self.bones, &self.usual));
        // Numbers may differ because radii do.
        radii.chain(pair.differing_values(self.model, &self.usual)).collect()
    }

    /// Whether a force by which `sphere` meets a floor is switched on.
    pub(crate) fn applies(&self, sphere: &Sphere) -> bool {
        self.users.applies(sphere.id)
    }

    /// All moving spheres that meet a floor, in file order, with their bodies and their places there, m.
    pub(crate) fn spheres(&self) -> impl Iterator<Item = (&'m Sphere, &'m str, DVec3)> {
        self.users.spheres(self.model)
    }

    /// The longest bone of the limb to which `body` belongs, m; `None` where no body of it has two joints.
    pub(crate) fn longest_of_limb_m(&self, body: &str) -> Option<f64> {
        self.bones.longest_of_limb_m(body)
    }

    /// The axis of its frame (0, 1 or 2) that leads from `body` sideways; `None` if no body of the other side is its mirror image in one
    /// axis.
    pub(crate) fn sideways_axis(&self, body: &str) -> Option<usize> {
        self.bodies.pair(body, &self.bones)?.reversed_axis()
    }
}

/// Parameter sets that are counterparts because their spheres are: those of the first sphere that they share.
fn set_pairs<'m>(pairs: &[SpherePair<'m>], users: &Users<'m>) -> Vec<SetPair<'m>> {
    let mut found: BTreeMap<(ForceId, SetId, ForceId, SetId), SetPair<'m>> = BTreeMap::new();
    for (index, pair) in pairs.iter().enumerate() {
        let of = |placed: &Placed<'_>| users.of_sphere(placed.sphere.id).iter().copied();
        for (left, right) in of(&pair.left).zip(of(&pair.right)) {
            let key = (left.0.id, left.1.id, right.0.id, right.1.id);
            let empty = || SetPair { right, left, spheres: Vec::new() };
            found.entry(key).or_insert_with(empty).spheres.push(index);
        }
    }
    found.into_values().collect()
}

// What differs between the contacts of two spheres that are counterparts.

/// Radii of published models differ by up to 5.7 % between the sides.
const RADII: f64 = 0.1;
/// A radius follows its bone if it is that close to the ratio of the bones.
const FOLLOWS: f64 = 0.01;
/// One published model has transition velocities that differ by 5 %; others that differ, by 200 times.
const VELOCITIES: f64 = 1.2;

/// A number that differs between the sides.
#[derive(Debug, Clone)]
pub(crate) struct Difference {
    /// In words that follow "differ: ".
    pub text: String,
    /// Published models differ as much.
    pub is_small: bool,
    /// The side that is unlike the rest of the model, if it is known.
    pub odd: Option<Side>,
}

/// How often each number is in the model: the majority shows which side is the slip.
#[derive(Debug)]
pub(crate) struct Usual<'m> {
    model: &'m Model,
    /// Counted when two numbers differ.
    numbers: OnceCell<Numbers>,
}

#[derive(Debug, Default)]
struct Numbers {
    counts: HashMap<(Property, u64), usize>,
    totals: HashMap<Property, usize>,
}

impl Numbers {
    /// Those of all forces that meet a floor, and of their spheres.
    fn of(model: &Model) -> Self {
        let mut usual = Self::default();
        for force in model.forces().iter().filter(|force| model.meets_half_space(force)) {
            for set in &force.sets {
                of_set(force, set).for_each(|value| usual.add(value));
                set.spheres
                    .iter()
                    .filter_map(|&id| model.sphere(id))
                    .for_each(|sphere| usual.add(&sphere.radius));
            }
        }
        usual
    }

    fn add(&mut self, value: &Value) {
        *self.counts.entry((value.property, value.number.to_bits())).or_default() += 1;
        *self.totals.entry(value.property).or_default() += 1;
    }
}

impl<'m> Usual<'m> {
    pub(crate) fn of(model: &'m Model) -> Self {
        Self { model, numbers: OnceCell::new() }
    }

    /// How many others have the number of `value`, if that is most of those that are not compared.
    fn majority(&self, value: &Value) -> Option<usize> {
        let numbers = self.numbers.get_or_init(|| Numbers::of(self.model));
        let count = numbers.counts.get(&(value.property, value.number.to_bits()))?.saturating_sub(1);
        let others = numbers.totals.get(&value.property)?.saturating_sub(2);
        (2 * count > others).then_some(count)
    }

    /// The difference of `left` and `right`, called `what`, with the side that is unlike the others.
    fn difference(&self, (left, right): (&Value, &Value), what: &str, is_small: bool) -> Difference {
        let of_right = self.majority(right).map(|count| (Side::Left, count, right.number));
        let of_left = || self.majority(left).map(|count| (Side::Right, count, left.number));
        let odd = of_right.or_else(of_left);
        let others = match odd {
            Some((_, 1, number)) => format!(" (1 other has {number})"),
            Some((_, count, number)) => format!(" ({count} others have {number})"),
            None => String::new(),
        };
        Difference { text: format!("{what}{others}"), is_small, odd: odd.map(|(side, _, _)| side) }
    }
}

/// The values of a set, and those of its force that are not in it.
fn of_set<'m>(force: &'m Force, set: &'m ParameterSet) -> impl Iterator<Item = &'m Value> {
    let beside = set.value(Property::TransitionVelocity).is_none().then_some(&force.transition_velocity);
    set.values.iter().chain(beside)
}

/// A parameter set on the right and its counterpart on the left.
#[derive(Debug)]
pub(crate) struct SetPair<'m> {
    pub right: (&'m Force, &'m ParameterSet),
    pub left: (&'m Force, &'m ParameterSet),
    /// The spheres that make them counterparts.
    pub spheres: Vec<usize>,
}

impl SetPair<'_> {
    /// Numbers of the left set that are neither those of the right one nor follow the radii.
    pub(crate) fn differing_values(&self, model: &Model, usual: &Usual<'_>) -> Vec<Difference> {
        let ratios = self.ratios(model);
        let right = |property: Property| of_set(self.right.0, self.right.1).find(|r| r.property == property);
        let both = of_set(self.left.0, self.left.1).filter_map(|l| Some((l, right(l.property)?)));
        let differing = both.filter(|(l, r)| {
            let follows =
                |ratios| factor(l.property, ratios).is_some_and(|by| close(l.number, by * r.number));
            !(l.number.is_nan() || close(l.number, r.number) || ratios.as_ref().is_some_and(follows))
        });
        let difference = |(l, r): (&Value, &Value)| {
            let what = format!("{} is {} and {}", l.property, l.number, r.number);
            let times = (l.number / r.number).max(r.number / l.number);
            usual.difference((l, r), &what, l.property == Property::TransitionVelocity && times <= VELOCITIES)
        };
        differing.map(difference).collect()
    }

    /// The ratios of the radii of both sets, left over right; `None` where they are equal, or cannot be divided.
    fn ratios(&self, model: &Model) -> Option<Ratios> {
        let mean_square = |set: &ParameterSet| -> f64 {
            let spheres =
                set.spheres.iter().filter_map(|&id| model.sphere(id)).filter(|sphere| !sphere.fixed);
            let squares: Vec<f64> = spheres.map(|sphere| sphere.radius.number.powi(2)).collect();
            #[expect(clippy::cast_precision_loss, reason = "sphere counts are small")]
            let count = squares.len() as f64;
            squares.iter().sum::<f64>() / count
        };
        let radius = (mean_square(self.left.1) / mean_square(self.right.1)).sqrt();
        let values = RatioValues { mass: 1.0, sphere_count: 1.0, radius, gravity: 1.0 };
        (!close(radius, 1.0)).then(|| Ratios::new(values).ok()).flatten()
    }
}

/// By what a parameter is multiplied where radii alone change.
fn factor(property: Property, ratios: &Ratios) -> Option<f64> {
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

/// How the radii of a pair differ, unless they are equal or differ as their bones do.
fn of_radii(pair: &SpherePair<'_>, bones: &Bones<'_>, usual: &Usual<'_>) -> Option<Difference> {
    let (left, right) = (pair.left.sphere, pair.right.sphere);
    let ratio = left.radius.number / right.radius.number;
    if !ratio.is_finite() || close(ratio, 1.0) {
        return None;
    }
    let of_bones = bones.ratios(pair.left.body, pair.right.body);
    let nearest = of_bones.map(|[x, y, z]| apart(ratio, &[libm::cbrt(x * y * z), x, y, z]));
    if nearest.is_some_and(|apart| apart <= FOLLOWS) {
        return None;
    }
    let is_small = nearest.unwrap_or(f64::INFINITY).min(apart(ratio, &[1.0])) <= RADII;
    let of = |sphere: &Sphere| format!("{} m for {}", readable(sphere.radius.number), shown(&sphere.name));
    let what = format!("radius is {} and {}", of(left), of(right));
    Some(usual.difference((&left.radius, &right.radius), &what, is_small))
}

/// How far `ratio` is from the nearest of `expected`, relatively.
fn apart(ratio: f64, expected: &[f64]) -> f64 {
    expected.iter().map(|expected| (ratio / expected - 1.0).abs()).fold(f64::INFINITY, f64::min)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_foot_has_no_counterpart() {
        let model =
            Model::parse(include_bytes!("../../../osim-model/tests/data/one_foot.osim").as_slice()).unwrap();
        assert!(BothSides::of(&model).right_of(&model.forces()[0]).is_none());
    }
}
