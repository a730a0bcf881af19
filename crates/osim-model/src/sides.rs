//! Forces of the left and the right side, to be compared.

use std::collections::{BTreeMap, HashMap};

use contact_scaling::{RatioValues, Ratios};

use crate::anatomy::meshes;
use crate::contacts::{Force, Sphere};
use crate::model::Model;
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
pub(crate) fn right_forces(model: &Model) -> HashMap<String, &Force> {
    let mut right = HashMap::new();
    for force in model.forces().iter().filter(|force| Side::of_name(&force.name) == Some(Side::Right)) {
        right.entry(without_side(&force.name)).or_insert(force);
    }
    right
}

pub(crate) fn spheres<'m>(model: &'m Model, force: &Force) -> Vec<&'m Sphere> {
    force.spheres().into_iter().filter_map(|id| model.sphere(id)).collect()
}

pub(crate) fn close(value: f64, expected: f64) -> bool {
    (value - expected).abs() <= SAME * expected.abs()
}

/// The meshes of each body with their factors.
#[derive(Debug)]
pub(crate) struct Bones(HashMap<String, BTreeMap<String, [f64; 3]>>);

impl Bones {
    pub(crate) fn of(model: &Model) -> Self {
        let components = model.components();
        let bodies = components.tree.iter().map(|(id, _)| id).filter(|&id| components.tag(id) == "Body");
        Self(bodies.map(|id| (components.name(id), meshes(components, id))).collect())
    }

    /// The ratios of the radii of two forces, left over right, where the bones under their spheres differ in the same way; `None`
    /// where they do not.
    pub(crate) fn explain_radii(&self, model: &Model, left: &Force, right: &Force) -> Option<Ratios> {
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
