//! Remarks, questions and refusals for changes that add, convert, remove or scale contacts. Those about forces that a change makes or
//! removes are here: smoothing, friction, names that other objects use, contacts between spheres.

mod feet;

use std::collections::HashMap;

use contact_scaling::{Ratios, SmoothingValues};
use osim_inspect::find_gravity_not_down;
use osim_model::feet::{DefaultPose, PairsOfForce};
use osim_model::messages::{Input, Phrase, listed, phrase, readable, shortest, three_significant};
use osim_model::{
    Class, Fault, FaultKind, Force, ForceKind, LevelAxis, MissingFact, Model, Property, RadiusRule, Selected,
    SphereId,
};
use osim_patch::{DanglingReference, ObjectAction, ObjectChange, Plan, RebuiltModel, dangling_references};
use osim_requests::RequestFault;
use osim_requests::options::{OutputOptions, ScalingOptions};

pub(crate) use feet::{
    JointPositions, question_about_pad, question_about_scale, remark_on_leaning_planes, remark_on_limbs,
    remark_on_other_planes, remark_on_standing, remarks_on_parts_of_feet,
};

/// Refuses to apply a factor to the same file once more, if the note says that it was applied already and `may_repeat` is false.
///
/// # Errors
/// The question whether it should be applied again.
pub(crate) fn refuse_repetition(model: &Model, operation: &str, may_repeat: bool) -> Result<(), Fault> {
    let done = model.note.as_ref().is_some_and(|note| note.operation() == operation);
    if !done || may_repeat {
        return Ok(());
    }
    Err(Fault::new(MissingFact::Repetition { operation: operation.to_owned() }))
}

/// The axis of `model` that points up, along which lowest points of spheres stay where they are.
///
/// # Errors
/// Gravity does not point into the floor.
pub(crate) fn up_axis(model: &Model) -> Result<LevelAxis, Fault> {
    match find_gravity_not_down(model) {
        None => Ok(LevelAxis::of_gravity(model.gravity_m_s2)),
        Some(finding) => Err(Fault::refused(format!(
            "{}. Lowest points stay where they are along gravity: correct it first, or give the axis that points up",
            finding.message
        ))),
    }
}

/// The axis up, if the caller wants lowest points to stay.
///
/// # Errors
/// Those of [`up_axis`], if the caller gives no axis.
pub(crate) fn level_axis(scaling: &ScalingOptions, model: &Model) -> Result<Option<LevelAxis>, Fault> {
    let axis = || scaling.level_axis.map_or_else(|| up_axis(model), |choice| Ok(choice.axis()));
    scaling.level.then(axis).transpose()
}

/// The name of an operation for notes: the verb, and the factor of the radius if one is given.
pub(crate) fn operation_with_radius(verb: &str, radius: Option<RadiusRule>) -> String {
    match radius {
        Some(RadiusRule::Factor(factor)) => format!("{verb} radius=x{}", shortest(factor)),
        _ => verb.to_owned(),
    }
}

/// Refuses an output file for a geometry set, because verbs that change whole objects only change whole models.
///
/// # Errors
/// The request names such a file.
pub(crate) fn refuse_geometry_output(output: &OutputOptions) -> Result<(), RequestFault> {
    if output.geometry_output.is_none() {
        return Ok(());
    }
    let why = phrase![
        Input::GeometryOutput,
        " is for a ForceSet without its model: this verb needs a whole model, which has its geometry in the same file"
    ];
    Err(RequestFault::refused(Input::GeometryOutput, why))
}

/// The largest number of sets of smoothing values that a remark lists.
const NUMBERS_LISTED: usize = 3;
/// The parameters of smoothing, in the order in which remarks list them.
const SMOOTHING_PARAMETERS: [Property; 3] =
    [Property::ConstantContactForce, Property::HertzSmoothing, Property::HuntCrossleySmoothing];

/// Remarks on the smoothing values of new forces and on their effects. `given` says that the caller gave all these values.
pub(crate) fn remarks_on_smoothing(objects: &[ObjectChange], given: bool) -> Vec<Phrase> {
    let mut groups: Vec<([f64; 3], usize)> = Vec::new();
    let mut index_of: HashMap<[u64; 3], usize> = HashMap::new();
    for values in
        objects.iter().filter(|object| object.action == ObjectAction::Added).filter_map(smoothing_values)
    {
        let index = *index_of.entry(values.map(f64::to_bits)).or_insert(groups.len());
        match groups.get_mut(index) {
            Some((_, count)) => *count += 1,
            None => groups.push((values, 1)),
        }
    }
    let mut remarks: Vec<Phrase> = groups
        .iter()
        .take(NUMBERS_LISTED)
        .map(|(values, count)| smoothing_sentence(values, *count))
        .collect();
    if let Some(more) = groups.len().checked_sub(NUMBERS_LISTED).filter(|more| *more > 0) {
        remarks.push(format!("{more} more smoothings, at other radii, are in the JSON of this run").into());
    }
    if !given {
        let text = "smoothing that is not given is that of Falisse et al. (2022), scaled to the radius of each sphere: \
                    (C.2), (C.5), (C.10)";
        remarks.push(text.into());
    }
    let default = SmoothingValues::OPENSIM_DEFAULT;
    let default = [default.constant_contact_force, default.hertz_smoothing, default.hunt_crossley_smoothing];
    let as_by_default = groups.iter().all(|(values, _)| *values == default);
    let how_much = if as_by_default {
        ": with these numbers, about 90 times the force of a HuntCrossleyForce at 0.1 mm, 2.9 times at 1 mm, 7 % more at 10 mm"
    } else {
        ""
    };
    remarks.push(
        format!("a smoothed force presses a little also where nothing touches, and more where a sphere hardly sinks in{how_much}")
            .into(),
    );
    remarks.push("columns of results are named after the sphere, such as force.Sphere.force.X".into());
    remarks
}

/// The smoothing parameters of a new smoothed force.
fn smoothing_values(object: &ObjectChange) -> Option<[f64; 3]> {
    let value = |wanted: Property| {
        object.parameters.iter().find(|(property, _)| *property == wanted).map(|(_, value)| *value)
    };
    let [force, hertz, hunt_crossley] = SMOOTHING_PARAMETERS.map(value);
    (object.class == ForceKind::SmoothSphereHalfSpace.as_str()).then_some([force?, hertz?, hunt_crossley?])
}

/// A sentence with the smoothing parameters that `count` new forces have.
fn smoothing_sentence(values: &[f64; 3], count: usize) -> Phrase {
    let one = |(property, value): (Property, &f64)| {
        format!("{} {} {}", property.as_str(), readable(*value), property.unit())
    };
    let all: Vec<String> = SMOOTHING_PARAMETERS.into_iter().zip(values).map(one).collect();
    let forces = if count == 1 { "force" } else { "forces" };
    format!("smoothing of {count} {forces}: {}", all.join(", ")).into()
}

/// If the transition velocities of friction differ by less than this (relative), as for masses within 1.8 times, the difference has little
/// effect.
const SIMILAR_SPEED_TOLERANCE: f64 = 0.1;

/// A remark on transition velocities of friction that stay those of the reference. `None` if the body is about as large as the reference,
/// or has no friction. The slip speed at which friction is full follows √R (isometric: M^(1/6)), like all speeds of a body.
pub(crate) fn remark_on_kept_friction(plan: &Plan, built: &Model) -> Option<Phrase> {
    let masses = plan.masses.as_ref()?;
    let ratios = Ratios::isometric(masses.target_mass_kg / masses.contacts_mass.kg).ok()?;
    let factor = ratios.transition_velocity();
    if (factor - 1.0).abs() <= SIMILAR_SPEED_TOLERANCE || !built.forces().iter().any(has_friction) {
        return None;
    }
    let text = format!(
        "transition_velocity and viscous_friction stay the reference's, but speeds of this body are {} times as high: in trials from a \
         mouse to a giraffe, feet that were pushed then slid 0.6 to 3.8 times as far (docs/studies/falls.md); scale them too with ",
        three_significant(factor)
    );
    Some(phrase![text, Input::Friction])
}

/// Whether a coefficient of friction of the force is above 0.
fn has_friction(force: &Force) -> bool {
    const FRICTION_PROPERTIES: [Property; 3] =
        [Property::StaticFriction, Property::DynamicFriction, Property::ViscousFriction];
    let value = |set, property| force.checked(set, property).ok().flatten();
    force
        .sets
        .iter()
        .any(|set| FRICTION_PROPERTIES.iter().any(|&one| value(set.id, one).is_some_and(|value| value > 0.0)))
}

/// The version number of the first documents of OpenSim 4; OpenSim 1 to 3 wrote smaller numbers.
const FIRST_VERSION_OF_OPENSIM_4: u32 = 40_000;

/// A remark on smooth forces that `rebuilt` adds to a document of OpenSim 3 or older. OpenSim has had these forces since 4.1 (its list of
/// changes), which also reads such documents.
pub(crate) fn remark_on_old_document(rebuilt: &RebuiltModel) -> Option<Phrase> {
    let smooth = ForceKind::SmoothSphereHalfSpace.as_str();
    let is_new = |object: &ObjectChange| object.action == ObjectAction::Added && object.class == smooth;
    let is_old = rebuilt.model().document().version() < FIRST_VERSION_OF_OPENSIM_4;
    (is_old && rebuilt.objects.iter().any(is_new)).then(|| {
        let text = format!(
            "the document is of an OpenSim before 4, and {smooth} came with OpenSim 4.1, which reads it; for older programs the \
             forces have to be of the class {}",
            Class::HuntCrossleyForce.as_str()
        );
        text.into()
    })
}

/// The largest number of objects, and of names, that a remark lists.
const NAMES_LISTED: usize = 3;

/// Remarks on objects of `rebuilt` that use the names of objects which the change removed.
pub(crate) fn remarks_on_missing_names(rebuilt: &RebuiltModel) -> Vec<Phrase> {
    let objects_with_missing_names = dangling_references(rebuilt);
    let remark = |leftover: &DanglingReference| {
        let names = listed(&leftover.names, NAMES_LISTED);
        Phrase::from(format!(
            "{} still names {names}, gone from this model: change that in OpenSim",
            leftover.object
        ))
    };
    let mut remarks: Vec<Phrase> = objects_with_missing_names.iter().take(NAMES_LISTED).map(remark).collect();
    if let Some(more) = objects_with_missing_names.len().checked_sub(NAMES_LISTED).filter(|more| *more > 0) {
        remarks.push(format!("and so do {more} more").into());
    }
    remarks
}

/// The largest number of pairs of spheres that a remark lists.
const PAIRS_LISTED: usize = 3;

/// Remarks on contacts between two spheres of one force. These contacts end when the force is divided into forces of one sphere each.
///
/// # Errors
/// Two spheres touch at the default pose, or it is not known whether they do: the force that keeps them apart would be gone.
pub(crate) fn remarks_on_dropped_pairs(model: &Model, selected: &Selected) -> Result<Vec<Phrase>, Fault> {
    let pose = DefaultPose::of(model);
    let mut remarks = Vec::new();
    for force in selected.forces.iter().filter_map(|&id| model.force(id)) {
        let pairs = PairsOfForce::find(model, &pose, force, PAIRS_LISTED);
        if let Some((pair, why)) = &pairs.not_apart {
            return Err(refuse_pair(model, force, *pair, why.as_deref()));
        }
        if pairs.count == 0 {
            continue;
        }
        let more = pairs.count - pairs.first.len();
        let more = if more == 0 { String::new() } else { format!(", and {more} more") };
        let named: Vec<String> =
            pairs.first.iter().map(|pair| names_of(model, *pair).join(" and ")).collect();
        let named = named.join("; ");
        remarks.push(
            format!(
                "{} acts between spheres of different bodies, too, and the new forces do not: {named}{more}",
                force.path
            )
            .into(),
        );
    }
    Ok(remarks)
}

fn names_of(model: &Model, pair: [SphereId; 2]) -> [&str; 2] {
    pair.map(|id| model.sphere(id).map_or("", |sphere| sphere.name.as_str()))
}

/// The error about two spheres that touch each other, or of which is not known whether they do: `why`.
fn refuse_pair(model: &Model, force: &Force, pair: [SphereId; 2], why: Option<&str>) -> Fault {
    let [one, other] = names_of(model, pair);
    let path = &force.path;
    let (text, otherwise) = match why {
        Some(why) => (
            format!(
                "{path} also lets {one} and {other} touch each other, which forces of one sphere do not, and whether they touch is not \
                 known ({why})"
            ),
            "",
        ),
        None => (
            format!(
                "in {path}, {one} and {other} touch each other at the default pose, which forces of one sphere do not"
            ),
            "take one of them out of it in OpenSim",
        ),
    };
    let kind = FaultKind::ForceCannotChange { text, force: force.name.clone(), otherwise };
    Fault::new(kind).at_element(path.clone())
}
