//! Contact spheres as typed values over the tree.

use std::ops::Range;

use super::ids::SphereId;
use super::slot::Slot;
use crate::model::class::Class;
use crate::model::components::{Base, ComponentId};
use crate::model::fault::{Fault, FileId};
use crate::model::value::Value;
use crate::xml::ElementId;

/// A `ContactSphere` (or, in Moco 0.1 to 0.3 models, the sphere a force keeps inside itself).
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Sphere {
    /// Its handle in the model.
    pub id: SphereId,
    /// Name as in the file.
    pub name: String,
    /// Component path.
    pub path: String,
    /// Effective radius, m, as OpenSim reads it; [`Sphere::radius_m`] checks it.
    pub radius: Value,
    /// Location of the centre in `frame`, m.
    pub location_m: [f64; 3],
    /// Path of the frame it is attached to.
    pub frame: String,
    /// Name of the body that carries the frame; `None` is ground or a body in a file that was not given.
    pub body: Option<String>,
    /// Whether it is on ground or on a body welded to ground: scenery, which counts nowhere and is never changed.
    pub fixed: bool,
    /// Line of its element, from 1.
    pub line: usize,
    /// The file it is in.
    pub file: FileId,
    pub(crate) element: ElementId,
    /// First byte of its element.
    pub(super) start: usize,
    pub(crate) base: Base,
    pub(super) spelling: SphereSpelling,
    /// The frame itself; `None` is ground or a frame in a file that was not given.
    pub(crate) frame_component: Option<ComponentId>,
    /// The bytes of the location, where the sphere has one of its own.
    pub(super) location_span: Option<Range<usize>>,
}

impl Sphere {
    /// The radius in m, if it is one plain number above 0.
    ///
    /// # Errors
    /// A text that is not a plain number, or a number outside its domain, with its place.
    pub fn radius_m(&self) -> Result<f64, Fault> {
        self.radius.checked().map_err(|fault| fault.of(self.path.clone()).in_file(self.file))
    }

    /// Its element in its [`file`](Self::file).
    #[must_use]
    pub const fn element(&self) -> ElementId {
        self.element
    }

    /// Whether the sphere is inside its force, as in Moco 0.1 to 0.3.
    #[must_use]
    pub fn is_inside_force(&self) -> bool {
        self.spelling == SphereSpelling::InsideForce
    }

    /// Where its radius is in the file.
    #[must_use]
    pub fn radius_slot(&self) -> Slot {
        self.slot(self.spelling.radius_tag(), self.radius.span.clone(), self.radius.offset)
    }

    /// Where its location is in the file.
    #[must_use]
    pub fn location_slot(&self) -> Slot {
        let offset = self.location_span.as_ref().map_or(self.start, |span| span.start);
        self.slot(self.spelling.location_tag(), self.location_span.clone(), offset)
    }

    fn slot(&self, tag: &'static str, span: Option<Range<usize>>, offset: usize) -> Slot {
        Slot { file: self.file, object: self.element, class: self.spelling.class(), tag, span, offset }
    }
}

/// How a sphere is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum SphereSpelling {
    /// A `ContactSphere` with a `radius`.
    ContactSphere,
    /// Moco 0.1 to 0.3: `contact_sphere_radius` inside the force.
    InsideForce,
}

impl SphereSpelling {
    pub(super) const fn class(self) -> Class {
        match self {
            Self::ContactSphere => Class::ContactSphere,
            Self::InsideForce => Class::SmoothSphereHalfSpaceForce,
        }
    }

    pub(super) const fn location_tag(self) -> &'static str {
        match self {
            Self::ContactSphere => "location",
            Self::InsideForce => "contact_sphere_location",
        }
    }

    pub(super) const fn radius_tag(self) -> &'static str {
        match self {
            Self::ContactSphere => "radius",
            Self::InsideForce => "contact_sphere_radius",
        }
    }
}
