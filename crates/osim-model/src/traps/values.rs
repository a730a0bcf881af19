//! Numbers that OpenSim reads otherwise than they look, or computes nonsense from.

use crate::class::Class;
use crate::contacts::{ForceKind, SetId};
use crate::fault::FileId;
use crate::finding::{Finding, FindingCode};
use crate::model::Model;
use crate::property::Property;
use crate::value::{Origin, Value};
use osim_xml::ElementId;
use osim_xml::opensim_text::is_plain_triple;

pub(super) fn numbers(model: &Model) -> Vec<Finding> {
    let mut found = Vec::new();
    let parameters = model.forces().iter().flat_map(|force| {
        // For the older class, what is not in its sets.
        let beside = (force.kind == ForceKind::HuntCrossley).then_some(&force.transition_velocity);
        let own = force.sets.iter().flat_map(|set| &set.values);
        own.chain(beside).map(move |value| (force.path.as_str(), force.file, value))
    });
    let radii = model.spheres().iter().map(|sphere| (sphere.path.as_str(), sphere.file, &sphere.radius));
    let masses = model.bodies().iter().map(|body| (body.path.as_str(), body.file, &body.mass));
    for (path, file, value) in parameters.chain(radii).chain(masses) {
        let (code, text) = if value.fault.is_some() {
            (FindingCode::OddNumber, format!("is '{}', which OpenSim reads as {}", value.text, value.number))
        } else if !value.number.is_finite() {
            (FindingCode::NotFinite, format!("is {}", value.number))
        } else if !value.property.allows(value.number) && !is_default_stiffness(value) {
            let expected = value.property.domain();
            (FindingCode::OutOfDomain, format!("is {}, expected {expected}", value.number))
        } else {
            continue;
        };
        let line = model.file(file).line(value.offset);
        found.push(Finding::at(code, line, format!("{} of {path} {text}", value.property)).about(path));
    }
    found
}

/// Places of spheres, and gravity: a text that OpenSim cannot read is its default without a word.
pub(super) fn triples(model: &Model) -> Vec<Finding> {
    let locations = model.spheres().iter().filter_map(|sphere| {
        let at = (sphere.file, sphere.element, sphere.location_slot().tag);
        Some(triple(model, at, &sphere.path, sphere.location_m)?.about(&sphere.path))
    });
    let beside = model.companions().map(|(file, companion)| (file, &companion.document));
    let mut files = std::iter::once((FileId::MAIN, model.document())).chain(beside);
    let gravity = files.find(|(_, document)| document.is_model()).and_then(|(file, document)| {
        let object = document.data_root();
        let read = document.triple(object, "gravity").unwrap_or(Model::DEFAULT_GRAVITY);
        triple(model, (file, object, "gravity"), "the model", read)
    });
    locations.chain(gravity).collect()
}

/// What is odd about three numbers: the file, the object and the tag that they are in, whose they are, and how OpenSim reads them.
fn triple(
    model: &Model,
    (file, object, tag): (FileId, ElementId, &str),
    whose: &str,
    read: [f64; 3],
) -> Option<Finding> {
    let document = model.file(file);
    let element = document.property_element(object, tag)?;
    let text = document.tree().raw_text(element).text;
    let [x, y, z] = read;
    let (code, text) = if !is_plain_triple(&text) {
        // A blank that is not ASCII looks like one and does not count as one: show it.
        let text = if text.is_ascii() { text } else { text.escape_default().to_string() };
        (FindingCode::OddNumber, format!("is '{text}', which OpenSim reads as {x} {y} {z}"))
    } else if !read.iter().all(|value| value.is_finite()) {
        (FindingCode::NotFinite, format!("is {x} {y} {z}"))
    } else {
        return None;
    };
    let line = document.line(document.tree().span(element).start);
    Some(Finding::at(code, line, format!("{tag} of {whose} {text}")))
}

pub(super) fn dead_elements(model: &Model) -> Vec<Finding> {
    let mut found = Vec::new();
    for force in model.forces() {
        let document = model.file(force.file);
        if let Some(dead) = document.tree().child(force.element, "derivative_smoothing") {
            let line = document.line(document.tree().span(dead).start);
            let text = format!("{}: derivative_smoothing is ignored by OpenSim", force.path);
            found.push(Finding::at(FindingCode::DeadDerivativeSmoothing, line, text).about(&force.path));
        }
    }
    found
}

pub(super) fn default_stiffness(model: &Model) -> Vec<Finding> {
    let mut found = Vec::new();
    for force in model.forces() {
        for set in &force.sets {
            let default = set.value(Property::Stiffness).filter(|value| value.origin == Origin::ClassDefault);
            if let Some(value) = default {
                let text = format!("{}: stiffness is OpenSim's default, {} N/m2", force.path, value.number);
                found.push(Finding::at(FindingCode::DefaultStiffness, set.line, text).about(&force.path));
            }
        }
    }
    found
}

pub(super) fn zero_constant_contact_force(model: &Model) -> Vec<Finding> {
    let mut found = Vec::new();
    for force in model.forces() {
        let zero =
            force.value(SetId::FIRST, Property::ConstantContactForce).filter(|value| value.number == 0.0);
        if let Some(value) = zero {
            let line = model.file(force.file).line(value.offset);
            let text =
                format!("{}: constant_contact_force is 0: OpenSim computes NaN without slip", force.path);
            found.push(Finding::at(FindingCode::ZeroConstantContactForce, line, text).about(&force.path));
        }
    }
    found
}

pub(super) fn contact_defaults(model: &Model) -> Vec<Finding> {
    let mut found = Vec::new();
    let document = model.document();
    let tree = document.tree();
    let Some(defaults) = document.defaults() else { return found };
    let classes = [
        Class::SmoothSphereHalfSpaceForce,
        Class::HuntCrossleyForce,
        Class::ContactParameters,
        Class::ContactSphere,
    ];
    for class in classes {
        if let Some(default) = tree.child(defaults, class.tag()) {
            // OpenSim itself writes defaults without content; those carry nothing.
            if tree.children(default).next().is_none() {
                continue;
            }
            let line = document.line(tree.span(default).start);
            let text =
                format!("<defaults> holds a {}: OpenSim keeps it for models loaded later", class.tag());
            found.push(Finding::at(FindingCode::ContactDefaults, line, text));
        }
    }
    found
}

/// Whether it has the default stiffness, which has a warning of its own.
fn is_default_stiffness(value: &Value) -> bool {
    value.property == Property::Stiffness && value.origin == Origin::ClassDefault
}
