//! Left and right contacts that differ.

use std::collections::{BTreeMap, HashMap};

use contact_scaling::{RatioValues, Ratios};

use crate::anatomy::meshes;
use crate::contacts::{Force, Sphere};
use crate::finding::{Finding, FindingCode};
use crate::model::Model;
use crate::property::Property;
use crate::side::{Side, without_side};

/// A ratio that differs by no more than this, relatively, is as it should be.
const SAME: f64 = 1e-6;

/// The forces of both sides, compared: from [`Model::both_sides`].
#[derive(Debug)]
pub struct BothSides<'m> {
    model: &'m Model,
    right: HashMap<String, &'m Force>,
    by_path: HashMap<&'m str, &'m Force>,
    bones: Bones,
}

impl Model {
    /// The forces of both sides, to be compared one after the other.
    #[must_use]
    pub fn both_sides(&self) -> BothSides<'_> {
        let mut by_path = HashMap::new();
        for force in self.forces() {
            by_path.entry(force.path.as_str()).or_insert(force);
        }
        BothSides { model: self, right: right_forces(self), by_path, bones: Bones::of(self) }
    }
}

impl<'m> BothSides<'m> {
    /// The force with this component path.
    #[must_use]
    pub fn force(&self, path: &str) -> Option<&'m Force> {
        self.by_path.get(path).copied()
    }

    /// The force on the right that has the name of `left` apart from the side.
    #[must_use]
    pub fn right_of(&self, left: &Force) -> Option<&'m Force> {
        self.right.get(&without_side(&left.name)).copied()
    }

    /// Whether the bones under the spheres of `left` are of another size than those under `right`, by their meshes.
    #[must_use]
    pub fn bones_differ(&self, left: &Force, right: &Force) -> bool {
        let pairs = spheres(self.model, left).into_iter().zip(spheres(self.model, right));
        pairs
            .filter_map(|(left, right)| self.bones.ratios(left, right))
            .any(|ratios| ratios.into_iter().any(|ratio| !close(ratio, 1.0)))
    }
}

/// The first force on the right of each name, names without their side.
fn right_forces(model: &Model) -> HashMap<String, &Force> {
    let mut right = HashMap::new();
    for force in model.forces().iter().filter(|force| Side::of_name(&force.name) == Some(Side::Right)) {
        right.entry(without_side(&force.name)).or_insert(force);
    }
    right
}

/// Forces whose names differ only in the side should have equal parameters, or such as follow bones that were scaled unlike.
pub(super) fn left_and_right(model: &Model) -> Vec<Finding> {
    let mut found = Vec::new();
    let right = right_forces(model);
    let mut bones: Option<Bones> = None;
    let side = |name: &str| Side::of_name(name);
    for force in model.forces().iter().filter(|force| side(&force.name) == Some(Side::Left)) {
        let Some(other) = right.get(&without_side(&force.name)).copied() else {
            continue;
        };
        let Some(what) = difference(model, force, other) else { continue };
        let what = match bones.get_or_insert_with(|| Bones::of(model)).explain_radii(model, force, other) {
            Some(ratios) => match unlike(force, other, &ratios) {
                Some(what) => what,
                None => continue,
            },
            None => what,
        };
        let text = format!("{} and {} differ: {what}", force.path, other.path);
        found.push(Finding::at(FindingCode::LeftRightDiffer, force.line, text).about(&force.path));
    }
    found
}

fn spheres<'m>(model: &'m Model, force: &Force) -> Vec<&'m Sphere> {
    force.spheres().into_iter().filter_map(|id| model.sphere(id)).collect()
}

/// The first difference between them, in words.
fn difference(model: &Model, left: &Force, right: &Force) -> Option<String> {
    let differing = left.sets.iter().zip(&right.sets).find_map(|(left, right)| {
        left.values.iter().zip(&right.values).find(|(l, r)| l.number != r.number && !l.number.is_nan())
    });
    let radii = |force: &Force| -> Vec<u64> {
        spheres(model, force).into_iter().map(|sphere| sphere.radius.number.to_bits()).collect()
    };
    match differing {
        Some((left, right)) => Some(format!("{} is {} and {}", left.property, left.number, right.number)),
        None => (radii(left) != radii(right)).then(|| "radii differ".to_owned()),
    }
}

/// The first parameter that does not follow the radii, in words. The modulus has to; of the others some stay as they are, as the
/// caller of a change wants it.
fn unlike(left: &Force, right: &Force, ratios: &Ratios) -> Option<String> {
    left.sets.iter().zip(&right.sets).find_map(|(left, right)| {
        let mut pairs = left.values.iter().zip(&right.values).filter(|(l, _)| !l.number.is_nan());
        let (l, r) = pairs.find(|(l, r)| {
            let follows = factor(l.property, ratios).is_some_and(|factor| close(l.number, factor * r.number));
            !follows && (l.number != r.number || l.property == Property::Stiffness)
        })?;
        Some(format!(
            "{} is {} and {}, which does not follow the radii of the two sides",
            l.property, l.number, r.number
        ))
    })
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

fn close(value: f64, expected: f64) -> bool {
    (value - expected).abs() <= SAME * expected.abs()
}

/// The meshes of each body with their factors.
#[derive(Debug)]
struct Bones(HashMap<String, BTreeMap<String, [f64; 3]>>);

impl Bones {
    fn of(model: &Model) -> Self {
        let components = model.components();
        let bodies = components.tree.iter().map(|(id, _)| id).filter(|&id| components.tag(id) == "Body");
        Self(bodies.map(|id| (components.name(id), meshes(components, id))).collect())
    }

    /// The ratios of the radii of two forces, left over right, where the bones under their spheres differ in the same way; `None`
    /// where they do not.
    fn explain_radii(&self, model: &Model, left: &Force, right: &Force) -> Option<Ratios> {
        let (left, right) = (spheres(model, left), spheres(model, right));
        let mut pairs = left.iter().zip(&right);
        if left.len() != right.len() || !pairs.all(|(left, right)| self.explain_radius(left, right)) {
            return None;
        }
        // The radius of a force is the root of the mean square of those of its spheres, whose number is the same.
        let squares =
            |spheres: &[&Sphere]| -> f64 { spheres.iter().map(|sphere| sphere.radius.number.powi(2)).sum() };
        let radius = (squares(&left) / squares(&right)).sqrt();
        (!close(radius, 1.0))
            .then(|| Ratios::new(RatioValues { mass: 1.0, sphere_count: 1.0, radius, gravity: 1.0 }).ok())
            .flatten()
    }

    /// Whether two radii are equal, or their ratio is the ratio of the bones, as it is taken from three factors.
    fn explain_radius(&self, left: &Sphere, right: &Sphere) -> bool {
        let ratio = left.radius.number / right.radius.number;
        let of_bones = || {
            let [x, y, z] = self.ratios(left, right)?;
            Some([libm::cbrt(x * y * z), x, y, z].into_iter().any(|of_bone| close(ratio, of_bone)))
        };
        close(ratio, 1.0) || of_bones() == Some(true)
    }

    /// By how much the bone under `left` is larger than that under `right`, along x, y and z; `None` where no mesh shows the same
    /// bone, or these do not agree.
    fn ratios(&self, left: &Sphere, right: &Sphere) -> Option<[f64; 3]> {
        let meshes = |sphere: &Sphere| self.0.get(sphere.body.as_ref()?);
        let (left, right) = (meshes(left)?, meshes(right)?);
        let same_bone = |file: &str| {
            right
                .iter()
                .find(|(other, _)| without_side(other) == without_side(file))
                .map(|(_, factors)| factors)
        };
        let named: Vec<_> = left.iter().filter_map(|(file, l)| Some((l, same_bone(file)?))).collect();
        let in_order = || left.values().zip(right.values()).collect();
        let pairs = if named.is_empty() && left.len() == right.len() { in_order() } else { named };
        let mut ratios = pairs.into_iter().map(|(l, r)| {
            // A mirrored mesh has a negative factor.
            std::array::from_fn::<f64, 3, _>(|axis| (l[axis] / r[axis]).abs())
        });
        let first =
            ratios.next().filter(|ratios| ratios.iter().all(|ratio| ratio.is_finite() && *ratio > 0.0))?;
        ratios.all(|other| other.into_iter().zip(first).all(|(a, b)| close(a, b))).then_some(first)
    }
}
