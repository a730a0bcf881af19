//! Frames of contact spheres, seen from the body that carries them.

use crate::components::{Base, ComponentId, Components, MAX_FRAME_CHAIN};
use crate::contacts::{Sphere, SphereId};
use crate::fault::Fault;
use crate::model::Model;
use crate::rotation::{LevelAxis, Rotation};

impl Model {
    /// Rotation of a sphere's frame in the body that carries it: the product of those of its chain of offset frames.
    ///
    /// # Errors
    /// A frame that leads nowhere.
    pub fn rotation_of(&self, sphere: &Sphere) -> Result<Rotation, Fault> {
        let components = self.components();
        let mut rotation = Rotation::IDENTITY;
        let mut at = sphere.frame_component;
        while let Some(id) = at {
            if !matches!(components.base(Some(id))?, Base::Body(_)) || components.tag(id) == "Body" {
                break;
            }
            let angles = components.doc(id).triple(components.element(id), "orientation").unwrap_or([0.0; 3]);
            rotation = Rotation::body_fixed_xyz(angles).after(&rotation);
            at = components.parent_frame(id);
        }
        Ok(rotation)
    }

    /// The lowest point of a sphere in the frame of the body that carries it (or of ground), m: its centre, less the radius
    /// along the body's axis that is nearest to −gravity, as when the body is not turned.
    ///
    /// `None` where the frame is in a file that was not given, a number is not finite or the radius not above 0.
    #[must_use]
    pub fn lowest_point_m(&self, sphere: SphereId) -> Option<[f64; 3]> {
        let sphere = self.sphere(sphere)?;
        if matches!(sphere.base, Base::Unknown) || !sphere.radius.property.allows(sphere.radius.number) {
            return None;
        }
        let mut point = self.components().in_body(sphere.frame_component, sphere.location_m)?;
        let up = LevelAxis::of_gravity(self.gravity_m_s2);
        point[up.axis.index()] += if up.down { sphere.radius.number } else { -sphere.radius.number };
        point.iter().all(|value| value.is_finite()).then_some(point)
    }
}

impl Components {
    /// The frame that an offset frame hangs on.
    fn parent_frame(&self, frame: ComponentId) -> Option<ComponentId> {
        let parent = self.connectee(frame, "parent", &["parent_frame"])?;
        self.frame(frame, &parent)?.component
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
