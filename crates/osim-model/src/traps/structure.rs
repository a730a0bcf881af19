//! How contacts are put together: what is a problem for OpenSim, Simbody or a later change.

use std::collections::{HashMap, HashSet};

use crate::class::Class;
use crate::contacts::{ForceKind, SphereId};
use crate::fault::FileId;
use crate::finding::{Finding, FindingCode};
use crate::model::Model;

/// Joints of a loop that a text names.
const LOOP_JOINTS_NAMED: usize = 6;
const NOT_HERTZ: [&str; 3] = ["ElasticFoundationForce", "ExponentialContactForce", "MeyerFregly2016Force"];

/// Contacts that are in included files can be read but not changed.
pub(super) fn included_contacts(model: &Model) -> Vec<Finding> {
    let mut found = Vec::new();
    let forces = model.forces().iter().map(|force| (force.file, &force.path));
    let spheres = model.spheres().iter().map(|sphere| (sphere.file, &sphere.path));
    let mut said: HashSet<FileId> = HashSet::new();
    for (file, path) in forces.chain(spheres) {
        if let (Some(name), false) = (model.included_file(file), said.contains(&file)) {
            let text = format!("{path} and others are in the file '{name}' that the model includes");
            found.push(Finding::new(FindingCode::IncludedFile, text));
            said.insert(file);
        }
    }
    found
}

pub(super) fn several_spheres(model: &Model) -> Vec<Finding> {
    let mut found = Vec::new();
    for force in model.forces() {
        let moving =
            force.spheres().into_iter().filter(|&s| model.sphere(s).is_some_and(|s| !s.fixed)).count();
        if matches!(force.kind, ForceKind::HuntCrossley) && moving > 1 {
            let text = format!("{} holds {moving} spheres: Simbody can drop the force of some", force.path);
            found.push(Finding::at(FindingCode::SeveralSpheres, force.line, text).about(&force.path));
        }
    }
    found
}

pub(super) fn spheres_in_two_forces(model: &Model) -> Vec<Finding> {
    let mut found = Vec::new();
    let mut users: HashMap<SphereId, Vec<&str>> = HashMap::new();
    for force in model.forces().iter().filter(|force| force.applies && model.meets_half_space(force)) {
        for sphere in force.spheres() {
            users.entry(sphere).or_default().push(&force.path);
        }
    }
    let mut shared: Vec<_> = users.into_iter().filter(|(_, forces)| forces.len() > 1).collect();
    shared.sort_unstable();
    for (index, forces) in shared {
        let Some(sphere) = model.sphere(index) else { continue };
        let text = format!("sphere {} meets the ground through {}", sphere.path, forces.join(" and "));
        found.push(Finding::at(FindingCode::SphereInTwoForces, sphere.line, text).about(&sphere.path));
    }
    found
}

/// Bodies with more than one joint.
pub(super) fn loops_of_joints(model: &Model) -> Vec<Finding> {
    let (components, skeleton) = (model.components(), model.skeleton());
    let finding = |joint, text| Finding::at(FindingCode::LoopOfJoints, components.line(joint), text);
    let ignored = skeleton.ignored_joints.iter().map(|&joint| {
        let text =
            format!("{} is not the first joint of its body: OpenSim ignores it", components.tree.path(joint));
        finding(joint, text)
    });
    let loops = &skeleton.loops;
    let cut = loops.joints.first().map(|&first| {
        let joints: Vec<_> = loops.joints.iter().map(|&joint| components.name(joint)).collect();
        let named = joints.get(..LOOP_JOINTS_NAMED).map_or(joints.join(", "), |named| {
            format!("{} and {} more", named.join(", "), joints.len() - named.len())
        });
        let what = if loops.mass_is_in_doubt {
            "counts the mass of a body in it twice"
        } else {
            "divides a body in it, whose parts weigh together what the body weighs"
        };
        finding(first, format!("joints form a loop ({named}): OpenSim {what}"))
    });
    ignored.chain(cut).collect()
}

/// Traps that are seen from the component tree itself.
pub(super) fn special_components(model: &Model) -> Vec<Finding> {
    let mut found = Vec::new();
    for sphere in model.spheres().iter().filter(|sphere| sphere.is_inside_force()) {
        let text = format!("{} keeps its sphere inside: OpenSim 4.2 and later cannot read it", sphere.path);
        found.push(Finding::at(FindingCode::MocoDialect, sphere.line, text).about(&sphere.path));
    }
    let components = model.components();
    for &(file, element) in &components.tree.skipped {
        let document = components.document(file);
        let tree = document.tree();
        let inside = tree.slice(tree.span(element));
        if inside.contains("<HuntCrossleyForce ") || inside.contains("<SmoothSphereHalfSpaceForce ") {
            let line = document.line(tree.span(element).start);
            let text = format!(
                "contacts inside a <{}> are left alone: OpenSim does not know that class",
                tree.name(element)
            );
            found.push(Finding::at(FindingCode::UnknownClass, line, text));
        }
    }
    for (id, object) in components.tree.iter() {
        let tag = components.tag(id);
        let contact = tag.starts_with("Contact") || tag.ends_with("Force") || NOT_HERTZ.contains(&tag);
        if !contact {
            continue;
        }
        let path = components.tree.path(id);
        if NOT_HERTZ.contains(&tag) {
            let text = format!("{path} is a {tag}: left as it is");
            found.push(Finding::at(FindingCode::NotHertz, components.line(id), text).about(&path));
        }
        let name = components.name(id);
        let ours =
            tag.starts_with("Contact") || tag == "HuntCrossleyForce" || tag.starts_with("SmoothSphere");
        if ours && tag != Class::ContactParameters.tag() && object.segment != name && !name.is_empty() {
            let text = format!("'{name}' appears twice: OpenSim calls this one {path}");
            found.push(Finding::at(FindingCode::DuplicateNames, components.line(id), text).about(&path));
        }
    }
    found
}
