//! Damage to joints and to frames of spheres, and edits of skeletons that do no harm.

use osim_model::{ElementId, ModelJoint, Side};

use super::damages::DamageKind;
use super::published::{Edited, FRAME, Published, SPHERE, is_any, is_heel, is_left};
use super::unread::{is_calcn_r, moved};

/// Kinds of damage that `kinds.md` does not list: `check` reports each as an error or a warning, the last one as a remark.
pub const SKELETON_DAMAGES: &[DamageKind] = &[
    ("left shank on the right thigh", "odd-parent", |m| {
        let thigh = m.body(&["femur", "thigh"], "x_r")?;
        with_parent(m, leg_joint(m, &["tibia", "shank"], Side::Left)?, &thigh)
    }),
    ("right thigh on the torso", "odd-parent", |m| {
        m.model.bodies().iter().find(|body| body.name == "torso")?;
        with_parent(m, leg_joint(m, &["femur", "thigh"], Side::Right)?, "torso")
    }),
    ("right ankle at the knee", "left-right-bones", |m| {
        let joint = leg_joint(m, &["talus", "calcn", "foot"], Side::Right)?;
        let place = parent_end(m, joint, &["location_in_parent"], &["translation"])?;
        joint.parent.as_ref()?.contains("tibia").then(|| with_text(m, place, "0 0 0"))
    }),
    ("left shank lost", "left-right-bones", |m| {
        let joint = leg_joint(m, &["talus", "calcn", "foot"], Side::Left)?;
        let shank = joint.parent.as_deref()?;
        let thigh =
            m.model.joints().iter().find(|one| one.child.as_deref() == Some(shank))?.parent.clone()?;
        with_parent(m, joint, &thigh)
    }),
    ("one left sphere on ground", "foot-sphere-on-ground", |m| {
        let left = m.model.spheres().iter().find(|sphere| is_left(&sphere.name))?.name.clone();
        m.edit(SPHERE, FRAME, |name, old| {
            (name == left).then(|| if old.contains('/') { "/ground" } else { "ground" }.to_owned())
        })
    }),
    ("all spheres on ground", "foot-sphere-on-ground", |m| {
        m.edit(SPHERE, FRAME, |_, old| Some(if old.contains('/') { "/ground" } else { "ground" }.to_owned()))
    }),
    ("spheres 0.1 m low", "spheres-misplaced", |m| moved_on_foot(m, is_any, |[x, y, z]| [x, y - 0.1, z])),
    ("spheres 0.1 m high", "spheres-misplaced", |m| moved_on_foot(m, is_any, |[x, y, z]| [x, y + 0.1, z])),
    ("heels 0.1 m behind", "spheres-misplaced", |m| moved_on_foot(m, is_heel, |[x, y, z]| [x - 0.1, y, z])),
    ("spheres 0.1 m beside the foot", "spheres-misplaced odd-place", |m| {
        moved_on_foot(m, is_any, |[x, y, z]| [x, y, z + 0.1_f64.copysign(z)])
    }),
    ("pelvis locked", "root-held", |m| with_locked_joints(m, |name| name.ends_with("_ty"))),
];

/// The text with other places of spheres, in a model with OpenSim's foot.
fn moved_on_foot(m: &Published, of: fn(&str) -> bool, place: fn([f64; 3]) -> [f64; 3]) -> Edited {
    m.text.contains("foot.vtp").then(|| m.places(of, place))?
}

/// The foot of the right leg on ground.
pub fn foot_on_ground(m: &Published) -> Edited {
    let joint = m.model.joints().iter().find(|joint| joint.child.as_deref().is_some_and(is_calcn_r))?;
    with_parent(m, joint, "ground")
}

/// The model whose hands have copies of its heels, and of their forces.
pub fn hands_on_the_floor(m: &Published) -> Edited {
    with_heels_on(m, "hand")
}

/// The model whose knees have copies of its heels, and of their forces. Models without hands have several spheres in one force.
pub fn knees_on_the_floor(m: &Published) -> Edited {
    m.body(&["hand"], "x_r").and_then(|_| with_heels_on(m, "tibia"))
}

/// The model whose bodies named `part` have copies of its heels, and of their forces.
fn with_heels_on(m: &Published, part: &str) -> Edited {
    let mut copies = Vec::new();
    for heel in m.model.spheres().iter().filter(|sphere| is_heel(&sphere.name)) {
        let body = heel.body.as_deref()?;
        let other = m.body(&[part], body)?;
        let force = m.model.forces().iter().find(|force| force.spheres().contains(&heel.id))?;
        for element in [heel.element, force.element] {
            let span = m.model.document().tree().span(element);
            let copy = m.text[span.clone()].replace(&force.name, &format!("of_{other}"));
            copies.push((span.end, copy.replace(&heel.name, &format!("on_{other}")).replace(body, &other)));
        }
    }
    copies.sort_by_key(|(end, _)| *end);
    (!copies.is_empty()).then(|| {
        copies.into_iter().rev().fold(m.text.clone(), |mut text, (end, copy)| {
            text.insert_str(end, &copy);
            text
        })
    })
}

/// The model whose root moves only up and down, as a hopper.
pub fn hopper(m: &Published) -> Edited {
    with_locked_joints(m, |name| name.starts_with("pelvis_") && !name.ends_with("_ty"))
}

/// The model without anything of the left side; its other bodies carry the mass of the left ones.
pub fn one_legged(m: &Published) -> Edited {
    let tree = m.model.document().tree();
    // Some forces have names without a side.
    let of_left = m.model.forces().iter().filter(|force| {
        let mut spheres = force.spheres().iter().filter_map(|&id| m.model.sphere(id));
        spheres.any(|sphere| is_left(&sphere.name))
    });
    let forces: Vec<ElementId> = of_left.map(|force| force.element).collect();
    // OpenSim refuses markers and muscles on a body that is gone.
    let hangs_on_left = |id: ElementId| {
        tree.children(id).any(|child| {
            let frame = tree.raw_text(child).text;
            tree.name(child).starts_with("socket_") && is_left(frame.rsplit('/').next().unwrap_or_default())
        })
    };
    let halved = without(m, |id| {
        let in_list = tree.parent(id).is_some_and(|list| tree.name(list) == "objects");
        let is_left = || tree.attribute(id, "name").is_some_and(|name| is_left(&name));
        forces.contains(&id) || in_list && (is_left() || hangs_on_left(id))
    })?;
    let halved = Published::parse(m.name, halved);
    let mass = |m: &Published| m.model.bodies().iter().filter_map(|body| body.mass_kg().ok()).sum::<f64>();
    let ratio = mass(m) / mass(&halved);
    halved.masses(is_any, |kg| kg * ratio)
}

/// The text without the elements for which `is_gone` is true.
fn without(m: &Published, is_gone: impl Fn(ElementId) -> bool) -> Edited {
    let tree = m.model.document().tree();
    let mut gone: Vec<ElementId> = Vec::new();
    // An element that is in another one goes with it.
    for id in tree.elements().filter(|&id| is_gone(id)) {
        if gone.last().is_none_or(|&last| tree.span(last).end <= tree.span(id).start) {
            gone.push(id);
        }
    }
    moved(m, &gone, |_| None, "")
}

/// The model with a left prosthesis in which the foot is part of the pylon: it has no talus.
pub fn prosthesis(m: &Published) -> Edited {
    let talus = leg_joint(m, &["talus"], Side::Left)?;
    let (talus_name, shank) = (talus.child.clone()?, talus.parent.as_ref()?);
    let foot = m.model.joints().iter().find(|joint| joint.parent.as_ref() == Some(&talus_name))?;
    let place = (talus.in_parent_m() - talus.in_child.translation_m + foot.in_parent_m()).to_array();
    let place = super::published::numbers_text(place);
    let element = parent_end(m, foot, &["location_in_parent"], &["translation"])?;
    let with_place = Published::parse(m.name, with_text(m, element, &place));
    let is_foot = |joint: &&ModelJoint| joint.name == foot.name;
    let with_parent = with_parent(&with_place, with_place.model.joints().iter().find(is_foot)?, shank)?;
    let hung = Published::parse(m.name, with_parent);
    let tree = hung.model.document().tree();
    without(&hung, |id| {
        let name = tree.attribute(id, "name").unwrap_or_default();
        // OpenSim refuses a force on a coordinate that is gone.
        let acts_on = tree.child(id, "coordinate").map(|element| tree.text_of(element)).unwrap_or_default();
        tree.name(id) == "Body" && name == talus_name.as_str()
            || tree.name(id).ends_with("Joint") && name == talus.name.as_str()
            || talus.coordinates.iter().any(|one| one.name == acts_on)
    })
}

/// The model with a body that is welded under each foot. Only documents of version 4 have joints in a set.
pub fn with_soles(m: &Published) -> Edited {
    let mut text = m.text.clone();
    for side in ["r", "l"] {
        let has_joint_set = m.model.document().version() >= 40000;
        let foot = m.body(&["calcn"], &format!("x_{side}")).filter(|_| has_joint_set)?;
        let sole = format!("<Body name=\"sole_{side}\"><mass>0.2</mass></Body>");
        let weld = format!(
            "<WeldJoint name=\"under_{side}\"><socket_parent_frame>/bodyset/{foot}</socket_parent_frame>\
             <socket_child_frame>/bodyset/sole_{side}</socket_child_frame></WeldJoint>"
        );
        for (set, object) in [("<BodySet", sole), ("<JointSet", weld)] {
            let start = text.find(set)?;
            let list = start + text[start..].find("<objects>")? + "<objects>".len();
            text.insert_str(list, &object);
        }
    }
    Some(text)
}

fn with_locked_joints(m: &Published, of: impl Fn(&str) -> bool) -> Edited {
    m.edit(&["Coordinate"], &["locked"], |name, _| of(name).then(|| "true".to_owned()))
}

/// The joint whose child is a body with one of these words in its name; the first one from the trunk.
fn leg_joint<'m>(m: &'m Published, words: &[&str], side: Side) -> Option<&'m ModelJoint> {
    let child = |joint: &&ModelJoint, word: &str| {
        joint.child.as_deref().is_some_and(|body| body.contains(word) && Side::of_name(body) == Some(side))
    };
    words.iter().find_map(|word| m.model.joints().iter().find(|joint| child(joint, word)))
}

/// The element with one of these tags that describes the parent's end of a joint: in the joint itself, in documents of version 3 (`old`), or
/// in the frame of the joint.
fn parent_end(m: &Published, joint: &ModelJoint, old: &[&str], new: &[&str]) -> Option<ElementId> {
    let tree = m.model.document().tree();
    let child = |owner, tags: &[&str]| tags.iter().find_map(|tag| tree.child(owner, tag));
    child(joint.element, old).or_else(|| {
        let socket = tree.text_of(tree.child(joint.element, "socket_parent_frame")?).into_owned();
        let mut frames = tree.children(tree.child(joint.element, "frames")?);
        let has_name = |&id: &ElementId| tree.attribute(id, "name").is_some_and(|name| name == socket.trim());
        child(frames.find(has_name)?, new)
    })
}

/// The text with another parent body of a joint.
fn with_parent(m: &Published, joint: &ModelJoint, parent: &str) -> Edited {
    let tree = m.model.document().tree();
    let element = parent_end(m, joint, &["parent_body"], &["socket_parent"])?;
    let path = match (tree.name(element), parent) {
        ("parent_body", _) => parent.to_owned(),
        (_, "ground") => "/ground".to_owned(),
        _ => format!("/bodyset/{parent}"),
    };
    Some(with_text(m, element, &path))
}

fn with_text(m: &Published, element: ElementId, new: &str) -> String {
    let tree = m.model.document().tree();
    let mut text = m.text.clone();
    text.replace_range(tree.open_span(element).end..tree.close_span(element).start, new);
    text
}
