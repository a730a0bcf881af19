//! Remarks about forces that are smoothed and were not.

use contact_scaling::SmoothingValues;
use osim_inspect::{Found, InspectOptions, check_model};
use osim_model::messages::{Input, Phrase, Verb, readable};
use osim_model::{Finding, FindingCode, ForceKind, Model, Property};
use osim_patch::{Deed, ObjectChange};
use osim_requests::{ConstantIndentation, Request};

use crate::planner;

/// Different numbers that are listed; more are counted.
const SAID: usize = 3;
const PROPERTIES: [Property; 3] =
    [Property::ConstantContactForce, Property::HertzSmoothing, Property::HuntCrossleySmoothing];

/// The numbers that forces are smoothed with, and what that does; `given` says that all of them were.
pub(crate) fn smoothed(objects: &[ObjectChange], given: bool) -> Vec<Phrase> {
    let mut groups: Vec<([f64; 3], usize)> = Vec::new();
    for values in objects.iter().filter(|object| object.deed == Deed::Added).filter_map(values) {
        match groups.iter_mut().find(|(known, _)| *known == values) {
            Some((_, count)) => *count += 1,
            None => groups.push((values, 1)),
        }
    }
    let mut said: Vec<Phrase> =
        groups.iter().take(SAID).map(|(values, count)| numbers(values, *count)).collect();
    if let Some(more) = groups.len().checked_sub(SAID).filter(|more| *more > 0) {
        said.push(format!("{more} more smoothings, at other radii, are in the JSON of this run").into());
    }
    if !given {
        let text = "smoothing that is not given is that of Falisse et al. (2022) without dimensions, at the radius of each sphere: \
                    (C.2), (C.5), (C.10)";
        said.push(text.into());
    }
    let default = SmoothingValues::OPENSIM_DEFAULT;
    let default = [default.constant_contact_force, default.hertz_smoothing, default.hunt_crossley_smoothing];
    let as_by_default = groups.iter().all(|(values, _)| *values == default);
    let how_much = if as_by_default {
        ": with these numbers, about 90 times the force of a HuntCrossleyForce at 0.1 mm, 2.9 times at 1 mm, 7 % more at 10 mm"
    } else {
        ""
    };
    said.push(
        format!("a smoothed force presses a little also where nothing touches, and more where a sphere hardly sinks in{how_much}")
            .into(),
    );
    said.push("columns of results are named after the sphere, such as force.Sphere.force.X".into());
    said
}

fn values(object: &ObjectChange) -> Option<[f64; 3]> {
    let value = |wanted: Property| {
        object.parameters.iter().find(|(property, _)| *property == wanted).map(|(_, value)| *value)
    };
    let [force, hertz, hunt_crossley] = PROPERTIES.map(value);
    (object.class == ForceKind::SmoothSphereHalfSpace.as_str()).then_some([force?, hertz?, hunt_crossley?])
}

fn numbers(values: &[f64; 3], count: usize) -> Phrase {
    let one = |(property, value): (Property, &f64)| {
        format!("{} {} {}", property.name(), readable(*value), property.unit())
    };
    let all: Vec<String> = PROPERTIES.into_iter().zip(values).map(one).collect();
    let forces = if count == 1 { "force" } else { "forces" };
    format!("smoothing of {count} {forces}: {}", all.join(", ")).into()
}

/// What `check` finds of the smoothing of `model`: whether its body floats, or is carried before it touches.
pub(crate) fn too_smooth(model: &Model) -> Vec<Finding> {
    let options = InspectOptions::default();
    let inspection = options.inspect("", model, None);
    let found = check_model(&options, model, &inspection, &[], planner::with_numbers(&options, model, true))
        .findings
        .into_iter();
    found
        .filter(|finding| matches!(finding.code(), FindingCode::Floats | FindingCode::ForceBeforeContact))
        .map(with_way_out)
        .collect()
}

/// The finding about a model that is not written yet: lines are not known, and a remedy is about the result.
fn with_way_out(found: Found) -> Finding {
    let Found { mut finding, remedy, .. } = found;
    finding.line = None;
    finding.message.push(": smooth less with ");
    finding.message.push(Input::ConstantContactForce.like("M2"));
    let design = remedy.and_then(|remedy| match remedy {
        Request::Design(design) => design.wanted.constant_indentation.map(ConstantIndentation::get),
        _ => None,
    });
    if let Some(indentation) = design {
        finding.message.push(", or change the result with ");
        finding
            .message
            .push(Verb::Design.of_model().saying(Input::ConstantIndentation, readable(indentation)));
    }
    finding
}
