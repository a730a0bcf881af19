//! Remarks about forces: smoothed or of another class now, with friction of another size, still named, or of two spheres.

use contact_scaling::{Ratios, SmoothingValues};
use osim_inspect::{FindingWithRemedy, InspectOptions, check_model};
use osim_model::feet::{DefaultPose, SpherePair, sphere_pairs};
use osim_model::messages::{Input, Phrase, Verb, listed, phrase, readable, three_significant};
use osim_model::{
    Class, Fault, FaultKind, Finding, FindingCode, Force, ForceKind, Model, Property, Selected, SphereId,
};
use osim_patch::{Deed, Leftover, ObjectChange, Plan, Rebuilt, leftovers};
use osim_requests::{ConstantIndentation, Request};

use crate::planner;

/// Different numbers that are listed; more are counted.
const NUMBERS_LISTED: usize = 3;
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
        groups.iter().take(NUMBERS_LISTED).map(|(values, count)| numbers(values, *count)).collect();
    if let Some(more) = groups.len().checked_sub(NUMBERS_LISTED).filter(|more| *more > 0) {
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
fn with_way_out(found: FindingWithRemedy) -> Finding {
    let FindingWithRemedy { mut finding, remedy, .. } = found;
    finding.line = None;
    finding.message.push(": smooth less with ");
    finding.message.push(Input::ConstantContactForce.with_placeholder("M2"));
    let design = remedy.and_then(|remedy| match remedy {
        Request::Design(design) => design.wanted.constant_indentation.map(ConstantIndentation::get),
        _ => None,
    });
    if let Some(indentation) = design {
        finding.message.push(", or change the result with ");
        finding.message.push(
            Verb::Design.call_with_model().with_value(Input::ConstantIndentation, readable(indentation)),
        );
    }
    finding
}

/// A factor of speeds so close to 1 (masses within 1.8) changes little.
const SAME: f64 = 0.1;

/// What it costs that the contacts of `built` keep their reference's speeds of friction; `None` where the body is as large as the
/// reference, or has no friction. The slip speed at which friction is full goes with √R (isometric: M^(1/6)), as all speeds of a body do.
pub(crate) fn friction_stays(plan: &Plan, built: &Model) -> Option<Phrase> {
    let masses = plan.masses.as_ref()?;
    let ratios = Ratios::isometric(masses.target_mass_kg / masses.contacts_mass.kg).ok()?;
    let factor = ratios.transition_velocity();
    if (factor - 1.0).abs() <= SAME || !built.forces().iter().any(has_friction) {
        return None;
    }
    let text = format!(
        "transition_velocity and viscous_friction stay the reference's, but speeds of this body are {} times as high: in trials from a \
         mouse to a giraffe, feet that were pushed then slid 0.6 to 3.8 times as far (docs/studies/falls.md); scale them too with ",
        three_significant(factor)
    );
    Some(phrase![text, Input::Friction])
}

fn has_friction(force: &Force) -> bool {
    const FRICTION: [Property; 3] =
        [Property::StaticFriction, Property::DynamicFriction, Property::ViscousFriction];
    let value = |set, property| force.checked(set, property).ok().flatten();
    force
        .sets
        .iter()
        .any(|set| FRICTION.iter().any(|&one| value(set.id, one).is_some_and(|value| value > 0.0)))
}

/// Documents before this version are of OpenSim 1 to 3.
const OF_OPENSIM_4: u32 = 40_000;

/// What to know of smooth forces that `rebuilt` adds to a document of an OpenSim before 4: they came with OpenSim 4.1 (its list of
/// changes), which reads such documents too.
pub(crate) fn too_new(rebuilt: &Rebuilt) -> Option<Phrase> {
    let smooth = ForceKind::SmoothSphereHalfSpace.as_str();
    let is_new = |object: &ObjectChange| object.deed == Deed::Added && object.class == smooth;
    let is_old = rebuilt.model().document().version() < OF_OPENSIM_4;
    (is_old && rebuilt.objects.iter().any(is_new)).then(|| {
        let text = format!(
            "the document is of an OpenSim before 4, and {smooth} came with OpenSim 4.1, which reads it; for older programs the \
             forces have to be of the class {}",
            Class::HuntCrossleyForce.tag()
        );
        text.into()
    })
}

/// Objects and names that are listed; more are counted.
const NAMES_LISTED: usize = 3;

/// Which objects of `rebuilt` name others that it does not have any more, one sentence for each.
pub(crate) fn still_named(rebuilt: &Rebuilt) -> Vec<Phrase> {
    let left = leftovers(rebuilt);
    let one = |leftover: &Leftover| {
        let names = listed(&leftover.names, NAMES_LISTED);
        Phrase::from(format!(
            "{} still names {names}, gone from this model: change that in OpenSim",
            leftover.object
        ))
    };
    let mut said: Vec<Phrase> = left.iter().take(NAMES_LISTED).map(one).collect();
    if let Some(more) = left.len().checked_sub(NAMES_LISTED).filter(|more| *more > 0) {
        said.push(format!("and so do {more} more").into());
    }
    said
}

// Contacts between spheres, which end when a force is divided into forces of one sphere each.

/// Pairs that are named; more are counted.
const NAMED: usize = 3;

/// Remarks about contacts between spheres that end, one sentence for each force.
///
/// # Errors
/// Two spheres touch at the default pose, or it is not known whether they do: what keeps them apart now would be gone.
pub(crate) fn dropped_pairs(model: &Model, selected: &Selected) -> Result<Vec<Phrase>, Fault> {
    let pose = DefaultPose::of(model);
    let mut said = Vec::new();
    for force in selected.forces.iter().filter_map(|&id| model.force(id)) {
        let pairs = sphere_pairs(model, &pose, force);
        let names: Vec<String> =
            pairs.iter().map(|pair| apart(model, force, pair)).collect::<Result<_, _>>()?;
        if names.is_empty() {
            continue;
        }
        let more = names.len().saturating_sub(NAMED);
        let named: Vec<&str> = names.iter().take(NAMED).map(String::as_str).collect();
        let more = if more == 0 { String::new() } else { format!(", and {more} more") };
        let named = named.join("; ");
        said.push(
            format!(
                "{} acts between spheres of different bodies, too, and the new forces do not: {named}{more}",
                force.path
            )
            .into(),
        );
    }
    Ok(said)
}

/// The names of two spheres that do not touch.
fn apart(model: &Model, force: &Force, pair: &SpherePair) -> Result<String, Fault> {
    let name = |id: SphereId| model.sphere(id).map_or("", |sphere| sphere.name.as_str());
    let (one, other) = (name(pair.one), name(pair.other));
    let refused = |text: String, otherwise: &'static str| {
        let kind = FaultKind::ForceCannotChange { text, force: force.name.clone(), otherwise };
        Fault::new(kind).at_element(force.path.clone())
    };
    match &pair.gap_m {
        Err(why) => {
            let text = format!(
                "{} also lets {one} and {other} touch each other, which forces of one sphere do not, and whether they touch is not \
                 known ({why})",
                force.path
            );
            Err(refused(text, ""))
        }
        Ok(gap) if *gap > 0.0 => Ok(format!("{one} and {other}")),
        Ok(_) => {
            let text = format!(
                "in {}, {one} and {other} touch each other at the default pose, which forces of one sphere do not",
                force.path
            );
            Err(refused(text, "take one of them out of it in OpenSim"))
        }
    }
}
