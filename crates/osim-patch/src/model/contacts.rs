//! Contact spheres and contact forces as typed values over the tree.

use std::collections::HashSet;
use std::ops::Range;

use super::files::Base;
use super::objects::ObjectId;
use crate::document::Value;
use crate::property::{Class, Property};
use crate::xml::ElementId;

/// A `ContactSphere` (or, in Moco 0.1 to 0.3 models, the sphere a force keeps inside itself).
#[derive(Debug, Clone)]
pub struct Sphere {
    /// Name as in the file.
    pub name: String,
    /// Component path.
    pub path: String,
    /// Effective radius, m.
    pub radius: Value,
    /// Location of the centre in `frame`, m.
    pub location_m: [f64; 3],
    /// Path of the frame it is attached to.
    pub frame: String,
    /// Name of the body that carries the frame; `None` is ground or a body in a file that was not given.
    pub body: Option<String>,
    /// On ground or on a body welded to ground: terrain, never resized.
    pub fixed: bool,
    /// Line of its element.
    pub line: usize,
    pub(crate) file: usize,
    pub(crate) element: ElementId,
    pub(crate) base: Base,
    pub(crate) dialect: Dialect,
    /// The frame itself; `None` is ground or a frame in a file that was not given.
    pub(crate) frame_object: Option<ObjectId>,
    /// The bytes of the location, where the sphere has one of its own.
    pub(crate) location_span: Option<Range<usize>>,
}

/// How a sphere is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Dialect {
    /// A `ContactSphere` with a `radius`.
    ContactSphere,
    /// Moco 0.1 to 0.3: `contact_sphere_radius` inside the force.
    InsideForce,
}

impl Dialect {
    pub(crate) const fn class(self) -> Class {
        match self {
            Self::ContactSphere => Class::ContactSphere,
            Self::InsideForce => Class::SmoothSphereHalfSpaceForce,
        }
    }

    pub(crate) const fn location_tag(self) -> &'static str {
        match self {
            Self::ContactSphere => "location",
            Self::InsideForce => "contact_sphere_location",
        }
    }

    pub(crate) const fn radius_tag(self) -> &'static str {
        match self {
            Self::ContactSphere => "radius",
            Self::InsideForce => "contact_sphere_radius",
        }
    }
}

/// Which contact force class.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum ForceKind {
    /// `HuntCrossleyForce`
    HuntCrossley,
    /// `SmoothSphereHalfSpaceForce`
    SmoothSphereHalfSpace,
}

impl ForceKind {
    /// OpenSim's class name.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::HuntCrossley => "HuntCrossleyForce",
            Self::SmoothSphereHalfSpace => "SmoothSphereHalfSpaceForce",
        }
    }
}

/// One contact force.
#[derive(Debug, Clone)]
pub struct Force {
    /// Name as in the file.
    pub name: String,
    /// Component path.
    pub path: String,
    /// Class.
    pub kind: ForceKind,
    /// `false` when it is switched off (`appliesForce`, or `isDisabled` in old documents).
    pub applies: bool,
    /// One for a `SmoothSphereHalfSpaceForce`, one per `ContactParameters` for a `HuntCrossleyForce`.
    pub sets: Vec<ParameterSet>,
    /// The force's own `transition_velocity`.
    pub transition_velocity: Value,
    /// Line of its element.
    pub line: usize,
    pub(crate) file: usize,
    pub(crate) element: ElementId,
}

/// Parameters and the surfaces they belong to.
#[derive(Debug, Clone)]
pub struct ParameterSet {
    /// Number of the `ContactParameters`; `None` for a `SmoothSphereHalfSpaceForce`.
    pub index: Option<usize>,
    /// Indices into [`crate::Model::spheres`].
    pub spheres: Vec<usize>,
    /// Number of half-spaces among the surfaces.
    pub half_spaces: usize,
    /// Number of surfaces that are neither sphere nor half-space (meshes and others).
    pub other_surfaces: usize,
    /// Effective values, in OpenSim's order; `transition_velocity` among them for a `SmoothSphereHalfSpaceForce`.
    pub values: Vec<Value>,
    /// Line of its element.
    pub line: usize,
    pub(crate) element: ElementId,
    pub(crate) class: Class,
    pub(crate) half_space_bases: Vec<Base>,
    /// The whole set stands in `<defaults>`, where other forces find it too.
    pub(crate) inherited: bool,
}

impl ParameterSet {
    /// The value of `property`, if this class has it.
    #[must_use]
    pub fn value(&self, property: Property) -> Option<&Value> {
        self.values.iter().find(|value| value.property == property)
    }
}

impl Force {
    /// Indices of all spheres of the force, each once, in order.
    #[must_use]
    pub fn spheres(&self) -> Vec<usize> {
        let mut seen = HashSet::new();
        let all = self.sets.iter().flat_map(|set| &set.spheres);
        all.copied().filter(|&sphere| seen.insert(sphere)).collect()
    }

    /// The value of `property` in parameter set `set`, or of the force itself.
    #[must_use]
    pub fn value(&self, set: usize, property: Property) -> Option<&Value> {
        self.sets
            .get(set)
            .and_then(|set| set.value(property))
            .or_else(|| (self.transition_velocity.property == property).then_some(&self.transition_velocity))
    }

    pub(crate) fn half_space_bases(&self) -> impl Iterator<Item = Base> + '_ {
        self.sets.iter().flat_map(|set| set.half_space_bases.iter().copied())
    }
}
