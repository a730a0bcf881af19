//! Half-spaces, such as the floor, and their orientations in the files.

use glam::DVec3;

use crate::model::components::{Carrier, ComponentId, Components};
use crate::model::contacts::force::Slot;
use crate::model::fault::FileId;
use crate::model::placement::Rotation;
use crate::model::property::Class;
use crate::xml::{ElementId, TextPosition};

/// Components of a unit vector below this are rounding errors.
const ROUNDING_OF_NORMAL: f64 = 1e-12;

/// A `ContactHalfSpace`, on whose surface spheres press, with its place and normal.
#[derive(Debug, Clone)]
pub struct HalfSpace {
    pub name: String,
    pub path: String,
    /// Component path of the frame on which the half-space is.
    pub frame_path: String,
    /// Location of the half-space in its frame, m; `None` if a number cannot be read.
    pub location_m: Option<[f64; 3]>,
    /// Whether the half-space's frame is ground, or offset frames fix it to ground.
    pub on_ground: bool,
    /// Name of the body that carries the half-space; `None` is ground or a body in a file that was not given.
    pub body: Option<String>,
    /// Outward normal in the frame of ground or of the body that carries the half-space; `None` if a number cannot be read.
    pub normal: Option<DVec3>,
    /// A point of the plane in the frame of ground or of that body, m; `None` if a number cannot be read.
    pub point_m: Option<DVec3>,
    /// Rotation of the half-space's frame in ground or in the body that carries it; `None` if the frame refers to no body.
    pub frame_rotation: Option<Rotation>,
    /// The orientations that turn the half-space: its own, then those of the offset frames between it and ground or its body.
    pub orientations: Vec<Orientation>,
    /// The property that names the half-space's frame.
    pub frame: FrameProperty,
    pub file: FileId,
    /// Line of the half-space's element, from 1.
    pub position: TextPosition,
    pub element: ElementId,
    /// The place of the half-space's location in its file.
    pub location_slot: Slot,
    component: ComponentId,
}

/// The XML element that says on which frame a half-space is.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FrameProperty {
    /// Name of the XML element, such as `socket_frame`.
    pub tag: String,
    /// Line of the element, from 1.
    pub position: TextPosition,
    /// The text that the element needs for a half-space on ground.
    pub ground: &'static str,
}

impl HalfSpace {
    /// Reads the half-space that the component `id` is or contains. The names are the tags of its socket, its location and its orientation.
    /// Without an orientation, `default_angles` (rad) count.
    pub(super) fn read(
        components: &Components,
        id: ComponentId,
        (socket, legacy): (&str, &[&str]),
        (location, orientation, default_angles): (&'static str, &'static str, [f64; 3]),
    ) -> Option<Self> {
        let (document, element) = (components.document_of(id), components.element(id));
        let connectee = components.connectee(id, socket, legacy)?;
        let frame = components.frame_of(id, &connectee)?.component;
        let base = components.base(frame).ok()?;
        let place = match document.property_element(element, location) {
            Some(_) => document.triple(element, location),
            None => Some([0.0; 3]),
        };
        let own_orientation = Orientation::read(components, id, orientation, default_angles);
        let frame_rotation = components.rotation_to_base(frame);
        // The solid is where x is above 0 in the half-space's own frame.
        let normal = own_orientation.angles_rad.zip(frame_rotation).map(|(angles, turned)| {
            turned.after(&Rotation::body_fixed_xyz(angles)).to_body([-1.0, 0.0, 0.0])
        });
        let offsets = components.offset_frames(frame).into_iter();
        let above = offsets.map(|frame| Orientation::read(components, frame, "orientation", [0.0; 3]));
        let tag = document.tree().name(connectee.element).to_owned();
        let frame_property = FrameProperty {
            position: document.position_of(connectee.element),
            ground: if connectee.legacy { "ground" } else { "/ground" },
            tag,
        };
        Some(HalfSpace {
            name: components.name(id).into_owned(),
            path: components.tree.path(id),
            frame_path: frame.map_or_else(|| "/ground".to_owned(), |frame| components.tree.path(frame)),
            location_m: place,
            on_ground: base == Carrier::Ground,
            body: match base {
                Carrier::Body(body) => Some(components.name(body).into_owned()),
                Carrier::Ground | Carrier::Unknown => None,
            },
            normal: normal.filter(|normal| normal.is_finite()),
            point_m: place.and_then(|point| components.point_in_body(frame, point)),
            frame_rotation,
            orientations: std::iter::once(own_orientation).chain(above).collect(),
            frame: frame_property,
            file: components.file_of(id),
            position: components.position_of(id),
            element,
            location_slot: location_slot(components, id, location),
            component: id,
        })
    }

    /// The half-space's location in its frame, m, after a move by `up_m` along its normal; `None` if the location cannot be read.
    pub fn location_moved_up(&self, up_m: f64) -> Option<[f64; 3]> {
        let (place, normal) = (self.location_m?, self.normal?);
        let in_frame = self.frame_rotation?.inverse().to_body(normal);
        // What rounding left of a turned normal moves nothing.
        Some((DVec3::from(place) + up_m * in_frame.map(without_rounding)).to_array())
    }

    /// The orientation of the half-space, rad, that gives its normal this `direction` in ground or in the body that carries it.
    pub(crate) fn orientation_facing(&self, direction: DVec3) -> Option<[f64; 3]> {
        let in_frame = self.frame_rotation?.inverse().to_body(direction);
        // What rounding left would turn it about y by any angle.
        Some(Orientation::facing(in_frame.map(without_rounding).to_array()))
    }
}

fn without_rounding(part: f64) -> f64 {
    if part.abs() < ROUNDING_OF_NORMAL { 0.0 } else { part }
}

/// The place in the file of a half-space's location. Without such an element, the object that would get it: the half-space, or the force
/// that contains it.
fn location_slot(components: &Components, id: ComponentId, tag: &'static str) -> Slot {
    let (document, object) = (components.document_of(id), components.element(id));
    let tree = document.tree();
    let span = tree.child(object, tag).map(|element| document.span_of_value(element));
    let class = match components.tag(id) {
        "ContactHalfSpace" => Class::ContactHalfSpace,
        _ => Class::SmoothSphereHalfSpaceForce,
    };
    let offset = span.as_ref().map_or(tree.span(object).start, |span| span.start);
    Slot { file: components.file_of(id), object, class, tag, span, offset }
}

impl PartialEq for HalfSpace {
    /// Whether both are the same half-space of one model.
    fn eq(&self, other: &Self) -> bool {
        self.component == other.component
    }
}

// The orientations of half-spaces and frames, as files have them.

/// The angles of a half-space or of an offset frame, as the file has them.
#[derive(Debug, Clone, PartialEq)]
pub struct Orientation {
    /// Component path of the half-space or frame that has this orientation.
    pub path: String,
    pub tag: &'static str,
    /// Place of the orientation's element; without such an element, of its object.
    pub position: TextPosition,
    pub file: FileId,
    /// Body-fixed angles about x, y and z, rad; `None` if a number cannot be read.
    pub angles_rad: Option<[f64; 3]>,
}

/// An angle larger than this, rad, is probably in degrees. OpenSim itself writes no angle beyond π.
const LARGEST_ANGLE_RAD: f64 = std::f64::consts::TAU + 0.01;

impl Orientation {
    /// Whether the angles are probably degrees: one is larger than a whole turn in radians.
    pub fn is_in_degrees(&self) -> bool {
        are_in_degrees(self.angles_rad)
    }

    /// The angles of a half-space whose surface faces `direction` (of length 1) in its frame: a rotation about y, then one about z. The
    /// solid side of a half-space is the +x side of its own frame, so R x̂ = (cos β cos γ, sin γ, −sin β cos γ) must be −`direction`.
    pub fn facing([x, y, z]: [f64; 3]) -> [f64; 3] {
        let level = libm::sqrt(x * x + z * z);
        let about_y = if level > 0.0 { libm::atan2(z, -x) } else { 0.0 };
        // No -0, which would only raise questions.
        [0.0, about_y + 0.0, libm::atan2(-y, level) + 0.0]
    }

    /// The orientations of half-spaces, offset frames and, in documents before version 4, ends of joints that are probably in degrees.
    pub fn all_in_degrees(components: &Components) -> impl Iterator<Item = Self> {
        let tags = move |id| -> &'static [&'static str] {
            match components.tag(id) {
                "ContactHalfSpace" | "PhysicalOffsetFrame" => &["orientation"],
                "SmoothSphereHalfSpaceForce" => &["contact_half_space_orientation"],
                tag if tag.ends_with("Joint") => &["orientation_in_parent", "orientation"],
                _ => &[],
            }
        };
        let of_component = move |id| {
            let in_degrees = move |tag: &&&str| are_in_degrees(angles_rad(components, id, tag, [0.0; 3]));
            let tags = tags(id).iter().filter(in_degrees);
            tags.map(move |&tag| Self::read(components, id, tag, [0.0; 3]))
        };
        components.tree.iter().flat_map(move |(id, _)| of_component(id))
    }

    /// Reads the orientation in the element `tag` of a component; without this element, the angles are `otherwise`, rad.
    pub(super) fn read(
        components: &Components,
        id: ComponentId,
        tag: &'static str,
        otherwise: [f64; 3],
    ) -> Self {
        let (document, element) = (components.document_of(id), components.element(id));
        let property = document.property_element(element, tag);
        let at = property.map_or_else(|| components.position_of(id), |own| document.position_of(own));
        let angles_rad = angles_rad(components, id, tag, otherwise);
        Self { path: components.tree.path(id), tag, position: at, file: components.file_of(id), angles_rad }
    }
}

/// The angles in the element `tag` of a component, rad; `None` if a number cannot be read.
fn angles_rad(components: &Components, id: ComponentId, tag: &str, otherwise: [f64; 3]) -> Option<[f64; 3]> {
    let (document, element) = (components.document_of(id), components.element(id));
    match document.property_element(element, tag) {
        Some(_) => document.triple(element, tag),
        None => Some(otherwise),
    }
}

fn are_in_degrees(angles_rad: Option<[f64; 3]>) -> bool {
    angles_rad.is_some_and(|angles| angles.iter().any(|angle| angle.abs() > LARGEST_ANGLE_RAD))
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{FRAC_PI_2, PI};

    use super::*;
    use crate::model::placement::Rotation;

    #[test]
    fn the_solid_side_of_a_facing_orientation_is_below() {
        assert_eq!(Orientation::facing([0.0, 1.0, 0.0]), [0.0, 0.0, -FRAC_PI_2]);
        assert_eq!(Orientation::facing([-0.0, 1.0, -0.0]), [0.0, 0.0, -FRAC_PI_2]);
        assert_eq!(Orientation::facing([0.0, 0.0, 1.0]), [0.0, FRAC_PI_2, 0.0]);
        assert_eq!(Orientation::facing([1.0, 0.0, 0.0]), [0.0, PI, 0.0]);
        // 2/7, 3/7 and 6/7 make a vector of length 1.
        for up in [[2.0, 3.0, 6.0], [-6.0, 2.0, 3.0], [-3.0, -6.0, -2.0], [0.0, -7.0, 0.0]] {
            let up = up.map(|value: f64| value / 7.0);
            let solid = Rotation::body_fixed_xyz(Orientation::facing(up)).to_body([1.0, 0.0, 0.0]);
            for (solid, up) in solid.to_array().into_iter().zip(up) {
                assert!((solid + up).abs() < 1e-15, "{up:?}: {solid:?}");
            }
        }
    }

    #[test]
    fn an_angle_beyond_a_whole_turn_is_in_degrees() {
        let turned_about_z = |z: f64| Orientation {
            path: "/contactgeometryset/floor".to_owned(),
            tag: "orientation",
            position: TextPosition { offset: 0, line: 1, column: 1 },
            file: FileId::MAIN,
            angles_rad: Some([0.0, 0.0, z]),
        };
        // A quarter turn, three of them, and a whole one, also rounded up.
        for radians in [-FRAC_PI_2, 3.0 * FRAC_PI_2, 2.0 * PI, -2.0 * PI - 1e-5] {
            assert!(!turned_about_z(radians).is_in_degrees(), "{radians}");
        }
        for degrees in [-90.0, 90.0, 180.0, -10.0] {
            assert!(turned_about_z(degrees).is_in_degrees(), "{degrees}");
        }
        let unread = Orientation { angles_rad: None, ..turned_about_z(0.0) };
        assert!(!unread.is_in_degrees());
    }
}
