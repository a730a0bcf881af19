//! The planes of contacts (half-spaces and floors), and the placement of sphere frames on their bodies.

use std::collections::BTreeMap;
use std::sync::Arc;

use glam::DVec3;

use crate::model::anatomy::joints::placement_on_base;
use crate::model::components::{
    Carrier, ComponentId, Components, MOST_FRAMES_IN_CHAIN, STATION_DEFINED_FRAME,
};
use crate::model::contacts::force::{Force, ParameterSet};
use crate::model::contacts::half_space::HalfSpace;
use crate::model::contacts::read::OLD_CONSTANT_TAG;
use crate::model::contacts::{Sphere, SphereId};
use crate::model::fault::Result;
use crate::model::placement::{LevelAxis, Placement, Rotation};
use crate::model::typed_model::Model;
use crate::xml::opensim_text::trimmed;

/// The orientation, rad, of a half-space inside a force without such an element: a level floor. The first version of the class, with
/// another name for `constant_contact_force`, has zeros instead.
const DEFAULT_INSIDE_ORIENTATION: [f64; 3] = [0.0, 0.0, -std::f64::consts::FRAC_PI_2];

impl Model {
    /// All half-spaces whose frame can be found, in file order.
    pub fn half_spaces(&self) -> Vec<HalfSpace> {
        self.planes().values().map(|plane| HalfSpace::clone(plane)).collect()
    }

    /// All half-spaces by their component. Read only once, because many forces use one floor.
    fn planes(&self) -> &BTreeMap<ComponentId, Arc<HalfSpace>> {
        self.half_spaces.get_or_init(|| {
            let components = self.components();
            let planes = components.tree.iter().filter(|(id, _)| components.tag(*id) == "ContactHalfSpace");
            planes.filter_map(|(id, _)| Some((id, Arc::new(read_half_space(components, id)?)))).collect()
        })
    }

    /// The half-spaces on which `force` presses its spheres, each once: those among its surfaces, or the one inside a force of Moco 0.1 to
    /// 0.3.
    pub fn planes_of(&self, force: &Force) -> Vec<Arc<HalfSpace>> {
        let mut planes: Vec<Arc<HalfSpace>> = Vec::new();
        for set in &force.sets {
            for plane in self.shared_planes_of_set(set) {
                if !planes.contains(&plane) {
                    planes.push(plane);
                }
            }
        }
        planes
    }

    /// The half-spaces among the surfaces of a parameter set, in file order, and the one inside its force.
    pub fn planes_of_set(&self, set: &ParameterSet) -> Vec<HalfSpace> {
        self.shared_planes_of_set(set).map(|plane| HalfSpace::clone(&plane)).collect()
    }

    fn shared_planes_of_set(&self, set: &ParameterSet) -> impl Iterator<Item = Arc<HalfSpace>> {
        let listed = set.half_space_components.iter().filter_map(|id| self.planes().get(id).cloned());
        let inside = set.half_space_inside.and_then(|id| half_space_inside(self.components(), id));
        listed.chain(inside.map(Arc::new))
    }

    /// The half-spaces inside forces of Moco 0.1 to 0.3, in file order.
    pub fn half_spaces_inside(&self) -> impl Iterator<Item = HalfSpace> + '_ {
        let sets = self.forces().iter().flat_map(|force| &force.sets);
        sets.filter_map(|set| half_space_inside(self.components(), set.half_space_inside?))
    }

    /// The half-spaces among the surfaces of a parameter set, in file order; without one inside its force.
    pub fn half_spaces_of(&self, set: &ParameterSet) -> Vec<HalfSpace> {
        let planes = set.half_space_components.iter().filter_map(|id| self.planes().get(id));
        planes.map(|plane| HalfSpace::clone(plane)).collect()
    }
}

fn read_half_space(components: &Components, id: ComponentId) -> Option<HalfSpace> {
    HalfSpace::read(components, id, ("frame", &["body_name"]), ("location", "orientation", [0.0; 3]))
}

/// The half-space inside a force of Moco 0.1 to 0.3.
fn half_space_inside(components: &Components, force: ComponentId) -> Option<HalfSpace> {
    let tree = components.document_of(force).tree();
    let is_first = tree.child(components.element(force), OLD_CONSTANT_TAG).is_some();
    let turned = if is_first { [0.0; 3] } else { DEFAULT_INSIDE_ORIENTATION };
    let place = ("contact_half_space_location", "contact_half_space_orientation", turned);
    HalfSpace::read(components, force, ("half_space_frame", &[]), place)
}

// Half-spaces on ground: which of them is the floor.

/// Largest difference between the normal of a floor and the direction up, as the length of the difference of unit vectors.
const LEVEL_TOLERANCE: f64 = 1e-6;

/// A half-space that is fixed to ground.
#[derive(Debug, Clone, PartialEq)]
pub struct GroundPlane {
    /// Name of the plane. In Moco 0.1 to 0.3, the name of the force that contains the plane.
    pub name: String,
    /// A point of the plane's surface in ground, m.
    pub point_m: DVec3,
    /// Outward normal of the plane in ground, away from the solid side: −x of the half-space's own frame.
    pub normal: DVec3,
}

impl Model {
    /// The half-spaces that are fixed to ground, in file order.
    pub fn ground_planes(&self) -> Vec<GroundPlane> {
        let all = self.half_spaces().into_iter().chain(self.half_spaces_inside());
        let planes = all.filter(|plane| plane.on_ground);
        planes
            .filter_map(|plane| {
                Some(GroundPlane { name: plane.name, point_m: plane.point_m?, normal: plane.normal? })
            })
            .collect()
    }

    /// The floors: half-spaces on ground with a normal that points up, opposite to gravity.
    pub fn floors(&self) -> Vec<GroundPlane> {
        let up = self.up();
        let is_level =
            |plane: &GroundPlane| plane.normal.distance_squared(up) <= LEVEL_TOLERANCE * LEVEL_TOLERANCE;
        self.ground_planes().into_iter().filter(is_level).collect()
    }

    /// The direction opposite to gravity in ground, of length 1; y if there is no gravity.
    pub fn up(&self) -> DVec3 {
        let gravity = DVec3::from(self.gravity_m_s2.unwrap_or_default());
        self.gravity().filter(|&length| length > 0.0).map_or(DVec3::Y, |length| -gravity / length)
    }

    /// Rotation of a sphere's frame in the body that carries it, through all offset frames between them.
    pub fn rotation_of(&self, sphere: &Sphere) -> Result<Rotation> {
        let components = self.components();
        if !matches!(components.base(sphere.frame_component)?, Carrier::Body(_)) {
            return Ok(Rotation::IDENTITY);
        }
        Ok(components.rotation_to_base(sphere.frame_component).unwrap_or(Rotation::IDENTITY))
    }

    /// The lowest point of a sphere in the frame of its body (or ground), m: the centre minus the radius along the body's axis that is
    /// nearest to up. This is exact if the body is upright.
    ///
    /// `None` if the frame is in a file that was not given, a number is not finite, or the radius is not above 0;
    /// or the sphere is an ellipsoid.
    pub fn lowest_point_m(&self, sphere: SphereId) -> Option<DVec3> {
        let radius = &self.sphere(sphere).filter(|sphere| sphere.radii_m.is_none())?.radius;
        let mut point = self.centre_m(sphere).filter(|_| radius.property.allows(radius.number))?;
        let up = LevelAxis::of_gravity(self.gravity_m_s2);
        point[up.axis.index()] += if up.down { radius.number } else { -radius.number };
        Some(point)
    }

    /// The centre of a sphere in the frame of its body (or ground), m.
    ///
    /// `None` if the frame is in a file that was not given, or a number is not finite.
    pub fn centre_m(&self, sphere: SphereId) -> Option<DVec3> {
        let sphere = self.sphere(sphere).filter(|sphere| !matches!(sphere.base, Carrier::Unknown))?;
        let point = self.components().point_in_body(sphere.frame_component, sphere.location_m)?;
        point.is_finite().then_some(point)
    }
}

impl Components {
    /// The placement of `frame` in the frame that it is fixed to, and that frame (`None` inside is ground); `None` if it is fixed to none.
    pub(crate) fn on_parent(&self, frame: ComponentId) -> Option<(Placement, Option<ComponentId>)> {
        if self.tag(frame) == STATION_DEFINED_FRAME {
            return self.on_body_of_stations(frame);
        }
        let (document, element) = (self.document_of(frame), self.element(frame));
        let triple = |tag| document.triple(element, tag).unwrap_or_default();
        let placement = Placement::from_triples(triple("orientation"), triple("translation"));
        Some((placement, self.frame_at(frame, "parent", &["parent_frame"])?.component))
    }

    /// The frame that `frame` is fixed to, as [`on_parent`](Self::on_parent) has it.
    pub(crate) fn parent_of_frame(&self, frame: ComponentId) -> Option<Option<ComponentId>> {
        if self.tag(frame) == STATION_DEFINED_FRAME {
            return Some(self.on_body_of_stations(frame)?.1);
        }
        Some(self.frame_at(frame, "parent", &["parent_frame"])?.component)
    }

    /// As [`on_parent`](Self::on_parent), for a StationDefinedFrame: its first axis points from station a to b, its second one along the
    /// normal of a, b and c. `None` unless all stations are on one body and none is on another such frame.
    fn on_body_of_stations(&self, frame: ComponentId) -> Option<(Placement, Option<ComponentId>)> {
        let station = |socket| {
            let text = self.connectee(frame, socket, &[])?.text;
            let id = self.tree.at_path(frame, &text);
            let id = id.filter(|&id| ["Station", "Marker"].contains(&self.tag(id)))?;
            let on = self.frame_at(id, "parent_frame", &[])?.component;
            // Frames at stations can be on each other in a circle.
            if self.offset_frames(on).iter().any(|&above| self.tag(above) == STATION_DEFINED_FRAME) {
                return None;
            }
            let place = self.document_of(id).triple(self.element(id), "location")?;
            Some((placement_on_base(self, on)?.0, self.point_in_body(on, place)?))
        };
        let ((base, a), (of_b, b)) = (station("point_a")?, station("point_b")?);
        let ((of_c, c), (of_origin, translation_m)) = (station("point_c")?, station("origin_point")?);
        let along = (b - a).try_normalize()?;
        let normal = along.cross(c - a).try_normalize()?;
        let rotation = Rotation::with_axes([
            (self.axis(frame, "ab_axis", DVec3::X)?, along),
            (self.axis(frame, "ab_x_ac_axis", DVec3::Y)?, normal),
        ]);
        let is_of_one_body = [of_b, of_c, of_origin].iter().all(|other| *other == base);
        is_of_one_body.then_some((Placement { rotation, translation_m }, base))
    }

    /// The signed axis of a frame that a property names, such as `-y`.
    fn axis(&self, frame: ComponentId, tag: &str, default: DVec3) -> Option<DVec3> {
        let tree = self.document_of(frame).tree();
        let Some(element) = tree.child(self.element(frame), tag) else { return Some(default) };
        let text = tree.text_of(element);
        let text = trimmed(&text);
        let (sign, letter) = text.strip_prefix('-').map_or((1.0, text), |rest| (-1.0, rest));
        let mut axes = ["x", "y", "z"].into_iter().zip(DVec3::AXES);
        Some(sign * axes.find(|(name, _)| *name == letter.trim_start_matches('+'))?.1)
    }

    /// The offset frames from `frame` to the body (or ground) that carries it, in this order.
    pub(crate) fn offset_frames(&self, frame: Option<ComponentId>) -> Vec<ComponentId> {
        let mut frames = Vec::new();
        let mut at = frame;
        while let Some(id) = at.filter(|&id| self.tag(id) != "Body" && self.tag(id) != "Ground")
            && frames.len() <= MOST_FRAMES_IN_CHAIN
        {
            frames.push(id);
            at = self.frame_at(id, "parent", &["parent_frame"]).and_then(|found| found.component);
        }
        frames
    }

    /// Rotation of a frame in the body (or ground) that carries it, through all offset frames.
    pub(crate) fn rotation_to_base(&self, frame: Option<ComponentId>) -> Option<Rotation> {
        Some(placement_on_base(self, frame)?.1.rotation)
    }

    /// Converts a point of a frame to the body (or ground) that carries the frame, through all offset frames.
    pub(crate) fn point_in_body(&self, frame: Option<ComponentId>, point: [f64; 3]) -> Option<DVec3> {
        let (mut point, mut at) = (DVec3::from(point), frame);
        // Chains that close on themselves were refused when the model was read.
        for _ in 0..=MOST_FRAMES_IN_CHAIN {
            let Some(id) = at.filter(|&id| self.tag(id) != "Body" && self.tag(id) != "Ground") else {
                return Some(point);
            };
            let (placement, parent) = self.on_parent(id)?;
            (point, at) = (placement.point(point), parent);
        }
        None
    }
}
