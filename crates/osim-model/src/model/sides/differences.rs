//! What differs between the contacts of two spheres that are counterparts.

use std::cell::OnceCell;

use crate::messages::{readable, shown};
use contact_scaling::{RatioValues, Ratios};
use foldhash::HashMap;

use super::bones::{Bones, close};
use super::pairs::SpherePair;
use crate::model::contacts::{Force, ParameterSet, Sphere};
use crate::model::property::Property;
use crate::model::side::Side;
use crate::model::typed_model::Model;
use crate::model::value::Value;

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
pub(crate) fn of_radii(pair: &SpherePair<'_>, bones: &Bones<'_>, usual: &Usual<'_>) -> Option<Difference> {
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
