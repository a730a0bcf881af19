//! Contact spheres and contact forces as types, their handles, and the places of their properties in the files.

use std::ops::Range;

use crate::messages::named;
use crate::model::components::{Carrier, ComponentId};
use crate::model::fault::{Fault, FileId, Result};
use crate::model::property::{Class, Property, Value};
use crate::xml::{ElementId, TextPosition};

/// Handle of a contact sphere in its [`Model`](crate::model::Model), in file order.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct SphereId(pub(crate) usize);

/// Handle of a contact force in its [`Model`](crate::model::Model), in file order.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ForceId(pub(crate) usize);

/// Handle of a parameter set in its [`Force`], in file order.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct SetId(pub(crate) usize);

impl SphereId {
    /// Index of the sphere in the model, from 0.
    pub const fn index(self) -> usize {
        self.0
    }
}

impl ForceId {
    /// Index of the force in the model, from 0.
    pub const fn index(self) -> usize {
        self.0
    }
}

impl SetId {
    /// The first set of a force: the only one of a `SmoothSphereHalfSpaceForce`.
    pub const FIRST: Self = Self(0);

    /// Index of the parameter set in its force, from 0.
    pub const fn index(self) -> usize {
        self.0
    }
}

/// The place in a file of a property's text. If the text is missing, the object to which the property would be added.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Slot {
    pub file: FileId,
    /// The object of the file whose property this is.
    pub object: ElementId,
    /// Class of the object, which determines the order of its elements.
    pub class: Class,
    pub tag: &'static str,
    /// The bytes of the property's text; `None` if the object has no such element.
    pub span: Option<Range<usize>>,
    /// First byte of the place that an error shows, from 0: of the property's text; of the object, if the property has no text.
    pub offset: usize,
}

/// A contact sphere: a `ContactSphere`, or the sphere inside a force of Moco 0.1 to 0.3. A `ContactEllipsoid` is scaled as a sphere is.
#[derive(Debug, Clone)]
pub struct Sphere {
    pub id: SphereId,
    pub name: String,
    pub path: String,
    /// Effective radius, m, as OpenSim reads it; of an ellipsoid, the radius of a sphere of equal volume. [`Sphere::radius_m`] checks it.
    pub radius: Value,
    /// The three radii of an ellipsoid, m; `None` for a sphere.
    pub radii_m: Option<[f64; 3]>,
    /// Location of the sphere's centre in its `frame`, m.
    pub location_m: [f64; 3],
    pub frame: String,
    /// Name of the body that carries the sphere; `None` is ground or a body in a file that was not given.
    pub body: Option<String>,
    /// Whether the sphere is on ground or on a body welded to ground. Such a sphere is left out of all calculations and never changed.
    pub fixed: bool,
    /// Line of the sphere's element, from 1.
    pub position: TextPosition,
    pub file: FileId,
    pub element: ElementId,
    /// First byte of the sphere's element.
    pub(super) start: usize,
    pub(crate) base: Carrier,
    /// The class of the sphere's element: of a sphere, of an ellipsoid, or of the force with the sphere inside.
    pub class: Class,
    /// The component of the sphere's frame; `None` is ground or a frame in a file that was not given.
    pub(crate) frame_component: Option<ComponentId>,
    /// The bytes of the location's text; `None` if the sphere has no location of its own.
    pub(super) location_span: Option<Range<usize>>,
}

impl Sphere {
    /// The radius in m, if its text is one plain number above 0.
    ///
    /// # Errors
    /// The text is not a plain number, or the number is not above 0. The error has the place in the file.
    pub fn radius_m(&self) -> Result<f64> {
        self.radius.checked().map_err(|fault| fault.at_element(self.path.clone()).in_file(self.file))
    }

    /// [`Sphere::radius_m`], for laws and places that hold only for spheres.
    ///
    /// # Errors
    /// As of [`Sphere::radius_m`]; and the sphere is an ellipsoid.
    pub fn round_radius_m(&self) -> Result<f64> {
        if self.radii_m.is_none() {
            return self.radius_m();
        }
        let fault = Fault::refused(format!("this needs a sphere; {} is an ellipsoid", self.name));
        Err(fault.at_element(self.path.clone()).in_file(self.file))
    }

    /// Whether the sphere is inside its force, as in Moco 0.1 to 0.3.
    pub fn is_inside_force(&self) -> bool {
        self.class == Class::SmoothSphereHalfSpaceForce
    }

    pub fn radius_slot(&self) -> Slot {
        self.slot_of_property(radius_tag(self.class), self.radius.span.clone(), self.radius.offset)
    }

    pub fn location_slot(&self) -> Slot {
        let offset = self.location_span.as_ref().map_or(self.start, |span| span.start);
        self.slot_of_property(location_tag(self.class), self.location_span.clone(), offset)
    }

    fn slot_of_property(&self, tag: &'static str, span: Option<Range<usize>>, offset: usize) -> Slot {
        Slot { file: self.file, object: self.element, class: self.class, tag, span, offset }
    }
}

/// The tag of a sphere's location; `class` is that of the element with the sphere, which may be a force of Moco 0.1 to 0.3.
pub(super) const fn location_tag(class: Class) -> &'static str {
    match class {
        Class::ContactSphere | Class::ContactEllipsoid => "location",
        _ => "contact_sphere_location",
    }
}

/// The tag of a sphere's radius or radii, likewise.
pub(super) const fn radius_tag(class: Class) -> &'static str {
    match class {
        Class::ContactSphere => "radius",
        Class::ContactEllipsoid => "radii",
        _ => "contact_sphere_radius",
    }
}

named! {
    /// The class of a contact force that can be scaled.
    pub enum ForceKind {
        HuntCrossley = "HuntCrossleyForce",
        SmoothSphereHalfSpace = "SmoothSphereHalfSpaceForce",
    }
}

/// A contact force of a model, with its parameters and the spheres that it presses.
#[derive(Debug, Clone)]
pub struct Force {
    pub id: ForceId,
    pub name: String,
    pub path: String,
    pub kind: ForceKind,
    /// Whether the force is switched on (`appliesForce`, or `isDisabled` in old documents).
    pub applies: bool,
    /// Parameter sets: one for a `SmoothSphereHalfSpaceForce`, one per `ContactParameters` for a `HuntCrossleyForce`.
    pub sets: Vec<ParameterSet>,
    pub(super) spheres: Vec<SphereId>,
    /// The `transition_velocity` of the force itself, not of a parameter set.
    pub transition_velocity: Value,
    /// Line of the force's element, from 1.
    pub position: TextPosition,
    pub file: FileId,
    pub element: ElementId,
}

/// The numbers with which a force presses some of its spheres: one `ContactParameters`, or those of a whole
/// `SmoothSphereHalfSpaceForce`.
#[derive(Debug, Clone)]
pub struct ParameterSet {
    pub id: SetId,
    /// Index of the `ContactParameters` for reports, from 0; `None` for a `SmoothSphereHalfSpaceForce`, which has only one set.
    pub number: Option<usize>,
    pub spheres: Vec<SphereId>,
    /// Number of half-spaces among the surfaces of the set.
    pub half_spaces: usize,
    /// Surfaces of the set that are neither spheres, ellipsoids nor half-spaces, such as meshes.
    pub other_surfaces: Vec<ComponentId>,
    /// Effective values of the properties, in OpenSim's order. For a `SmoothSphereHalfSpaceForce`, `transition_velocity` is one of them.
    pub values: Vec<Value>,
    /// Whether the whole set is in `<defaults>`, so that several forces share it.
    pub inherited: bool,
    /// Line of the set's element, from 1.
    pub position: TextPosition,
    pub(crate) element: ElementId,
    pub(crate) class: Class,
    pub(crate) half_space_bases: Vec<Carrier>,
    pub(crate) half_space_components: Vec<ComponentId>,
    /// The force, if it contains its half-space (Moco 0.1 to 0.3).
    pub(crate) half_space_inside: Option<ComponentId>,
}

impl ParameterSet {
    /// The value of `property` in this set; `None` if the class has no such property.
    pub fn value(&self, property: Property) -> Option<&Value> {
        self.values.iter().find(|value| value.property == property)
    }
}

impl Force {
    /// All spheres of the force, each once, in file order.
    pub fn spheres(&self) -> &[SphereId] {
        &self.spheres
    }

    /// The parameter set `set`; `None` if the handle belongs to another force.
    pub fn set(&self, set: SetId) -> Option<&ParameterSet> {
        self.sets.get(set.0)
    }

    /// The value of `property` in parameter set `set`, or of the force itself; `None` if the class has no such property.
    pub fn value(&self, set: SetId, property: Property) -> Option<&Value> {
        self.set(set)
            .and_then(|set| set.value(property))
            .or_else(|| (self.transition_velocity.property == property).then_some(&self.transition_velocity))
    }

    /// The number of `property` in its own unit, if it can be scaled; `None` if the class has no such property.
    pub fn checked(&self, set: SetId, property: Property) -> Result<Option<f64>> {
        let Some(value) = self.value(set, property) else { return Ok(None) };
        value.checked().map(Some).map_err(|fault| fault.at_element(self.path.clone()).in_file(self.file))
    }

    /// The place in the file of `property` of parameter set `set`, or of the force itself; `None` if the class has no such property.
    pub fn slot_of_property(&self, set: SetId, property: Property) -> Option<Slot> {
        let in_set = self.set(set).and_then(|set| Some((set, set.value(property)?)));
        let (value, object, class) = match in_set {
            Some((set, value)) => (value, set.element, set.class),
            None if self.transition_velocity.property == property => {
                (&self.transition_velocity, self.element, Class::HuntCrossleyForce)
            }
            None => return None,
        };
        let (span, offset) = (value.span.clone(), value.offset);
        Some(Slot { file: self.file, object, class, tag: property.as_str(), span, offset })
    }

    pub(crate) fn half_space_bases(&self) -> impl Iterator<Item = Carrier> + '_ {
        self.sets.iter().flat_map(|set| set.half_space_bases.iter().copied())
    }
}
