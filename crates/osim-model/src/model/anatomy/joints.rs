//! The joints of a model: their places on both bodies, and the relative placement of the bodies at the default pose.

use std::sync::OnceLock;

use foldhash::HashSet;
use glam::DVec3;

use crate::model::anatomy::coordinate_function::finite_numbers;
use crate::model::anatomy::joint_motion::{JointMotion, Speeds};
use crate::model::components::{ComponentId, Components, MOST_FRAMES_IN_CHAIN};
use crate::model::{Document, FileId, MovingPlacement, Placement};
use crate::xml::ElementId;

/// A joint between two bodies, with its places on both, m.
#[derive(Debug, Clone, PartialEq)]
pub struct AnatomyJoint {
    pub name: String,
    pub parent: String,
    pub child: String,
    pub in_parent_m: DVec3,
    pub in_child_m: DVec3,
    /// Whether the joint is a WeldJoint, which makes one bone of both bodies.
    pub is_weld: bool,
    /// The child frame of the joint in the parent body at the default pose; `None` if a function of the joint is not supported.
    placement: Option<Placement>,
}

impl AnatomyJoint {
    /// Converts a point of the child body to the frame of the parent body at the default pose, m.
    pub(crate) fn point_in_parent(&self, point_m: DVec3) -> Option<DVec3> {
        Some(self.placement?.point(point_m))
    }
}

/// A joint between two bodies, or between a body and ground. It can compute the placement of its child.
#[derive(Debug, Clone, PartialEq)]
pub struct ModelJoint {
    pub name: String,
    /// Class of the joint, such as `CustomJoint`.
    pub class: String,
    /// Parent body of the joint; `None` is ground.
    pub parent: Option<String>,
    /// Child body of the joint; `None` is ground.
    pub child: Option<String>,
    pub file: FileId,
    pub coordinates: Vec<JointCoordinate>,
    pub element: ElementId,
    in_parent: Placement,
    pub in_child: Placement,
    /// Whether the joint's element is inside its child body, as in documents before version 4.
    in_body: bool,
    /// Whether the joint's child moves the parent, an option of joints before version 4.
    reversed: bool,
    /// How the coordinates move the joint, read at first use; `None` inside if the joint is not supported.
    motion: OnceLock<Option<JointMotion>>,
}

/// A coordinate of a joint, with its default value and its range.
#[derive(Debug, Clone, PartialEq)]
pub struct JointCoordinate {
    pub name: String,
    /// Element of the coordinate in the joint's file. It is the joint's element if the file leaves the coordinate to OpenSim.
    pub element: ElementId,
    /// `default_value`, rad or m; `None` if it is not a number.
    pub default: Option<f64>,
    /// `range`, rad or m: the least and the largest value; `None` if the file has no such numbers.
    pub range: Option<[f64; 2]>,
    /// Whether OpenSim holds the value within the range (`clamped`). It refuses a default value outside.
    pub clamped: bool,
}

impl ModelJoint {
    /// Place of the joint on its parent body or in ground, m.
    pub fn in_parent_m(&self) -> DVec3 {
        self.in_parent.translation_m
    }

    pub(crate) fn placement_at(&self, components: &Components, values: &[f64]) -> Option<Placement> {
        let motion = self.motion(components)?.placement(values);
        let motion = if self.reversed { motion.inverse() } else { motion };
        Some(self.in_parent.then(&motion).then(&self.in_child.inverse()))
    }

    pub(crate) fn placement_and_velocity_at(
        &self,
        components: &Components,
        values: &[f64],
        speeds: Speeds<'_>,
    ) -> Option<MovingPlacement> {
        let motion = self.motion(components)?.placement_and_velocity(values, speeds);
        let motion = if self.reversed { motion.inverse() } else { motion };
        let still = MovingPlacement::at_rest;
        Some(still(self.in_parent).then(&motion).then(&still(self.in_child.inverse())))
    }

    pub(crate) fn motion(&self, components: &Components) -> Option<&JointMotion> {
        let read = || {
            let names: Vec<&str> = self.coordinates.iter().map(|one| one.name.as_str()).collect();
            JointMotion::read(components.document(self.file), self.element, &names)
        };
        self.motion.get_or_init(read).as_ref()
    }

    /// The joint after OpenSim's conversion of old documents: frames of joints before version 4 are rounded to six digits.
    pub(crate) fn converted(mut self) -> Self {
        if self.in_body {
            self.in_parent = self.in_parent.in_six_digits();
            self.in_child = self.in_child.in_six_digits();
        }
        self
    }
}

/// The joints of a model, read at first use.
#[derive(Debug, Default)]
pub(crate) struct Joints {
    all: OnceLock<Vec<ModelJoint>>,
    converted: OnceLock<Vec<ModelJoint>>,
    between_bodies: OnceLock<Vec<AnatomyJoint>>,
}

impl Joints {
    /// All joints in the files. A joint whose frames refer to no body is left out; limbs beyond it are then unknown.
    pub(crate) fn read(&self, components: &Components) -> &[ModelJoint] {
        let joints = components.tree.iter().filter(|(id, _)| components.tag(*id).ends_with("Joint"));
        self.all.get_or_init(|| joints.filter_map(|(id, _)| read_joint(components, id)).collect())
    }

    /// All joints except the `ignored` ones, with their frames as OpenSim converts them.
    pub(crate) fn converted(&self, components: &Components, ignored: &[ComponentId]) -> &[ModelJoint] {
        let all = self.read(components);
        // Documents of version 4 need no conversion.
        if ignored.is_empty() && !all.iter().any(|joint| joint.in_body) {
            return all;
        }
        self.converted.get_or_init(|| {
            let ignored: HashSet<&ComponentId> = ignored.iter().collect();
            let counts = |joint: &&ModelJoint| {
                let id = components.at(joint.file, joint.element);
                !id.is_some_and(|id| ignored.contains(&id))
            };
            all.iter().filter(counts).map(|joint| joint.clone().converted()).collect()
        })
    }

    pub(crate) fn places_on_bodies(&self, components: &Components) -> impl Iterator<Item = (&str, DVec3)> {
        self.read(components).iter().flat_map(|joint| {
            let parent = joint.parent.as_deref().map(|body| (body, joint.in_parent.translation_m));
            let child = joint.child.as_deref().map(|body| (body, joint.in_child.translation_m));
            parent.into_iter().chain(child)
        })
    }

    pub(crate) fn between_bodies(&self, components: &Components) -> &[AnatomyJoint] {
        let all = self.read(components).iter();
        self.between_bodies
            .get_or_init(|| all.filter_map(|joint| between_bodies(components, joint)).collect())
    }
}

fn between_bodies(components: &Components, joint: &ModelJoint) -> Option<AnatomyJoint> {
    let defaults: Option<Vec<f64>> = joint.coordinates.iter().map(|coordinate| coordinate.default).collect();
    Some(AnatomyJoint {
        name: joint.name.clone(),
        parent: joint.parent.clone()?,
        child: joint.child.clone()?,
        placement: defaults.and_then(|values| joint.placement_at(components, &values)),
        in_parent_m: joint.in_parent.translation_m,
        in_child_m: joint.in_child.translation_m,
        is_weld: joint.class == "WeldJoint",
    })
}

fn read_joint(components: &Components, joint: ComponentId) -> Option<ModelJoint> {
    let element = components.element(joint);
    let document = components.document_of(joint);
    let old = components.tree.get(joint)?.parent.filter(|&id| components.tag(id) == "Body");
    let (parent, child) = match old {
        // A document of version 3: the joint is in its child and holds both places.
        Some(child) => {
            let (body, on_body) = joint_end(components, joint, "parent_frame", &["parent_body"])?;
            let there = own_placement(components, joint, "location_in_parent", "orientation_in_parent");
            let tag = |tags| place_tag(document, element, tags);
            let place = tag(["location", "location_in_child"]);
            let here = own_placement(components, joint, place, tag(["orientation", "orientation_in_child"]));
            ((body, on_body.then(&there)), (Some(components.name(child).into_owned()), here))
        }
        None => (
            joint_end(components, joint, "parent_frame", &["parent_body"])?,
            joint_end(components, joint, "child_frame", &["child_body"])?,
        ),
    };
    Some(ModelJoint {
        name: components.name(joint).into_owned(),
        class: components.tag(joint).to_owned(),
        parent: parent.0,
        child: child.0,
        file: components.file_of(joint),
        coordinates: coordinates(document, element).unwrap_or_else(|| default_coordinates(components, joint)),
        element,
        in_parent: parent.1,
        in_child: child.1,
        in_body: old.is_some(),
        reversed: old.is_some() && matches!(document.flag(element, "reverse"), Ok(Some(true))),
        motion: OnceLock::new(),
    })
}

/// The last document version whose joints have their place on the child in `location`.
const LAST_VERSION_WITH_LOCATION: u32 = 30499;

/// The tag of a joint's place on its child: the later one from 30500 on. In older documents the first of both counts.
fn place_tag(document: &Document, joint: ElementId, [old, later]: [&'static str; 2]) -> &'static str {
    let tree = document.tree();
    let first = tree.children(joint).map(|child| tree.name(child)).find(|tag| [old, later].contains(tag));
    let is_later = document.version() > LAST_VERSION_WITH_LOCATION || first == Some(later);
    if is_later { later } else { old }
}

/// The coordinates that OpenSim itself makes for a joint without coordinates in the file: all are 0, named before the joint has its name.
fn default_coordinates(components: &Components, joint: ComponentId) -> Vec<JointCoordinate> {
    let count = match components.tag(joint) {
        "PinJoint" | "SliderJoint" => 1,
        "UniversalJoint" => 2,
        "GimbalJoint" | "BallJoint" | "EllipsoidJoint" | "PlanarJoint" => 3,
        "FreeJoint" => 6,
        _ => 0,
    };
    let element = components.element(joint);
    let coordinate = |number| JointCoordinate {
        name: format!("_coord_{number}"),
        element,
        default: Some(0.0),
        range: None,
        clamped: false,
    };
    (0..count).map(coordinate).collect()
}

/// The coordinates that the file lists for a joint; `None` if the file has no list.
fn coordinates(document: &Document, joint: ElementId) -> Option<Vec<JointCoordinate>> {
    let tree = document.tree();
    let old = || tree.child(tree.child(joint, "CoordinateSet")?, "objects");
    let list = tree.child(joint, "coordinates").or_else(old)?;
    let coordinates = tree.children(list).filter(|&id| tree.name(id) == "Coordinate");
    let coordinates = coordinates
        .map(|element| {
            let name = tree.attribute(element, "name").unwrap_or_default().into_owned();
            let default = match tree.child(element, "default_value") {
                Some(_) => finite_numbers(document, element, "default_value")
                    .and_then(|values| values.first().copied()),
                None => Some(0.0),
            };
            let range = finite_numbers(document, element, "range").and_then(|values| values.try_into().ok());
            let clamped = matches!(document.flag(element, "clamped"), Ok(Some(true)));
            JointCoordinate { name, element, default, range, clamped }
        })
        .collect();
    Some(coordinates)
}

/// The body at one end of a joint (`None` is ground), and the joint's frame on this body.
fn joint_end(
    components: &Components,
    joint: ComponentId,
    socket: &str,
    legacy: &[&str],
) -> Option<(Option<String>, Placement)> {
    let frame = components.frame_at(joint, socket, legacy)?.component;
    let (body, placement) = placement_on_base(components, frame)?;
    Some((body.map(|body| components.name(body).into_owned()), placement))
}

/// The body that carries a frame (`None` is ground), and the placement of the frame on it; outer `None` if the frame refers to no body.
pub(crate) fn placement_on_base(
    components: &Components,
    frame: Option<ComponentId>,
) -> Option<(Option<ComponentId>, Placement)> {
    let (mut at, mut placement) = (frame, Placement::IDENTITY);
    for _ in 0..=MOST_FRAMES_IN_CHAIN {
        let Some(frame) = at else { return Some((None, placement)) };
        match components.tag(frame) {
            "Body" => return Some(((!components.is_ground(frame)).then_some(frame), placement)),
            "Ground" => return Some((None, placement)),
            _ => {}
        }
        let (own, parent) = components.on_parent(frame)?;
        (placement, at) = (own.then(&placement), parent);
    }
    None
}

fn own_placement(
    components: &Components,
    owner: ComponentId,
    translation: &str,
    orientation: &str,
) -> Placement {
    let triple =
        |tag| components.document_of(owner).triple(components.element(owner), tag).unwrap_or([0.0; 3]);
    Placement::from_triples(triple(orientation), triple(translation))
}
