//! The numbers of a model. Several rules look at each.

use crate::xml::ElementId;

use super::{not_finite, odd_number, out_of_domain};
use crate::model::contacts::ForceKind;
use crate::model::fault::FileId;
use crate::model::finding::{Finding, Rule};
use crate::model::typed_model::Model;
use crate::model::value::Value;

/// A rule about one value: what is wrong, in words that follow the name of the value.
type OfValue = fn(&Value) -> Option<String>;

/// The first that applies makes the finding.
const OF_VALUES: [(&Rule, OfValue); 3] = [
    (&odd_number::RULE, odd_number::of_value),
    (&not_finite::RULE, not_finite::of_value),
    (&out_of_domain::RULE, out_of_domain::of_value),
];

pub(super) fn numbers(model: &Model) -> Vec<Finding> {
    let parameters = model.forces().iter().flat_map(|force| {
        // For the older class, what is not in its sets.
        let beside = (force.kind == ForceKind::HuntCrossley).then_some(&force.transition_velocity);
        let own = force.sets.iter().flat_map(|set| &set.values);
        own.chain(beside).map(move |value| (force.path.as_str(), force.file, value))
    });
    let radii = model.spheres().iter().map(|sphere| (sphere.path.as_str(), sphere.file, &sphere.radius));
    let masses = model.bodies().iter().map(|body| (body.path.as_str(), body.file, &body.mass));
    let finding = |(path, file, value): (&str, FileId, &Value)| {
        let (rule, text) = OF_VALUES.iter().find_map(|(rule, of)| Some((*rule, of(value)?)))?;
        let line = model.file(file).line(value.offset);
        Some(Finding::at(rule, line, format!("{} of {path} {text}", value.property)).about(path))
    };
    parameters.chain(radii).chain(masses).filter_map(finding).collect()
}

/// Places of spheres, and gravity: a text that OpenSim cannot read is its default without a word.
pub(super) fn triples(model: &Model) -> Vec<Finding> {
    let locations = model.spheres().iter().filter_map(|sphere| {
        let read = Triple {
            file: sphere.file,
            object: sphere.element,
            tag: sphere.location_slot().tag,
            read: sphere.location_m,
        };
        Some(read.finding(model, &sphere.path)?.about(&sphere.path))
    });
    let gravity = model.gravity_object().and_then(|(file, object)| {
        let read = model.file(file).triple(object, "gravity").unwrap_or(Model::DEFAULT_GRAVITY);
        Triple { file, object, tag: "gravity", read }.finding(model, "the model")
    });
    locations.chain(gravity).collect()
}

/// Three numbers of an object, and how OpenSim reads them.
struct Triple {
    file: FileId,
    object: ElementId,
    tag: &'static str,
    read: [f64; 3],
}

impl Triple {
    fn finding(&self, model: &Model, whose: &str) -> Option<Finding> {
        let document = model.file(self.file);
        let element = document.property_element(self.object, self.tag)?;
        let text = document.tree().raw_text(element).text;
        let odd = odd_number::of_triple(&text, self.read).map(|text| (&odd_number::RULE, text));
        let not_finite = || Some((&not_finite::RULE, not_finite::of_triple(self.read)?));
        let (rule, text) = odd.or_else(not_finite)?;
        let line = document.line(document.tree().span(element).start);
        Some(Finding::at(rule, line, format!("{} of {whose} {text}", self.tag)))
    }
}
