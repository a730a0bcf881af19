//! Frames of contact spheres, seen from the body that carries them.

use crate::model::components::{Base, ComponentId, Components, MAX_FRAME_CHAIN};
use crate::model::contacts::{Sphere, SphereId};
use crate::model::fault::Fault;
use crate::model::reference_frame::{LevelAxis, Rotation};
use crate::model::typed_model::Model;

impl Model {
    /// Rotation of a sphere's frame in the body that carries it: the product of those of its chain of offset frames.
    ///
    /// # Errors
    /// A frame that leads nowhere.
    pub fn rotation_of(&self, sphere: &Sphere) -> Result<Rotation, Fault> {
        let components = self.components();
        if !matches!(components.base(sphere.frame_component)?, Base::Body(_)) {
            return Ok(Rotation::IDENTITY);
        }
        Ok(components.rotation_to_base(sphere.frame_component).unwrap_or(Rotation::IDENTITY))
    }

    /// The lowest point of a sphere in the frame of the body that carries it (or of ground), m: its centre, less the radius
    /// along the body's axis that is nearest to −gravity, as when the body is not turned.
    ///
    /// `None` where the frame is in a file that was not given, a number is not finite or the radius not above 0.
    #[must_use]
    pub fn lowest_point_m(&self, sphere: SphereId) -> Option<[f64; 3]> {
        let radius = &self.sphere(sphere)?.radius;
        let mut point = self.centre_m(sphere).filter(|_| radius.property.allows(radius.number))?;
        let up = LevelAxis::of_gravity(self.gravity_m_s2);
        point[up.axis.index()] += if up.down { radius.number } else { -radius.number };
        Some(point)
    }

    /// The centre of a sphere in the frame of the body that carries it (or of ground), m.
    ///
    /// `None` where the frame is in a file that was not given, or a number is not finite.
    #[must_use]
    pub fn centre_m(&self, sphere: SphereId) -> Option<[f64; 3]> {
        let sphere = self.sphere(sphere).filter(|sphere| !matches!(sphere.base, Base::Unknown))?;
        let point = self.components().in_body(sphere.frame_component, sphere.location_m)?;
        point.iter().all(|value| value.is_finite()).then_some(point)
    }
}

impl Components {
    /// The offset frames from `frame` to the body (or ground) that carries it, in this order.
    pub(crate) fn offset_frames(&self, frame: Option<ComponentId>) -> Vec<ComponentId> {
        let mut found = Vec::new();
        let mut at = frame;
        while let Some(id) = at.filter(|&id| self.tag(id) != "Body" && self.tag(id) != "Ground")
            && found.len() <= MAX_FRAME_CHAIN
        {
            found.push(id);
            at = self.parent_frame(id);
        }
        found
    }

    /// The frame that an offset frame hangs on.
    fn parent_frame(&self, frame: ComponentId) -> Option<ComponentId> {
        let parent = self.connectee(frame, "parent", &["parent_frame"])?;
        self.frame(frame, &parent)?.component
    }

    /// Rotation of a frame in the body (or ground) at the end of its chain of offset frames.
    pub(crate) fn rotation_to_base(&self, frame: Option<ComponentId>) -> Option<Rotation> {
        let (mut rotation, mut at) = (Rotation::IDENTITY, frame);
        for _ in 0..=MAX_FRAME_CHAIN {
            let Some(id) = at.filter(|&id| self.tag(id) != "Body" && self.tag(id) != "Ground") else {
                return Some(rotation);
            };
            let angles = self.doc(id).triple(self.element(id), "orientation").unwrap_or([0.0; 3]);
            rotation = Rotation::body_fixed_xyz(angles).after(&rotation);
            at = self.parent_frame(id);
        }
        None
    }

    /// A point of a frame, seen from the body at the end of its chain of offset frames.
    pub(crate) fn in_body(&self, frame: Option<ComponentId>, point: [f64; 3]) -> Option<[f64; 3]> {
        let (mut point, mut at) = (point, frame);
        // Chains that close on themselves were refused when the model was read.
        for _ in 0..=MAX_FRAME_CHAIN {
            let Some(id) = at.filter(|&id| self.tag(id) != "Body" && self.tag(id) != "Ground") else {
                return Some(point);
            };
            let of = |tag| self.doc(id).triple(self.element(id), tag).unwrap_or([0.0; 3]);
            let turned = Rotation::body_fixed_xyz(of("orientation")).to_body(point);
            let translation = of("translation");
            point = std::array::from_fn(|i| translation[i] + turned[i]);
            at = self.parent_frame(id);
        }
        None
    }
}
