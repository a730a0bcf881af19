//! The verb `convert`: changes forces of one class into forces of the other class.

use osim_model::messages::{Input, Phrase, Verb, counted, listed, phrase};
use osim_model::{Fault, ForceKind, Model, Selection};
use osim_patch::{Convert, Converted, ObjectAction, ObjectChange, Plan, connect_sockets, convert, kept_note};
use osim_requests::options::InspectionOptions;
use osim_requests::{ConvertRequest, Positive, RequestFault};

use crate::prepared_change::PreparedChange;
use crate::remarks::{
    refuse_geometry_output, remark_on_old_document, remarks_on_dropped_pairs, remarks_on_missing_names,
    remarks_on_smoothing,
};

/// The remark that spheres and planes inside forces were moved to the geometry set.
const REMARK_GEOMETRY_TAKEN_OUT: &str = "spheres and planes that forces kept inside themselves, as in Moco 0.1 to 0.3, are in the ContactGeometrySet: OpenSim 4.2 and \
     later read the model now, and Moco 0.1 to 0.3 does not any more";

/// Plans new paths for sockets that lead nowhere.
fn plan_sockets(model: &Model) -> Result<Plan, Fault> {
    let rebuilt = connect_sockets(model)?;
    let summary = match rebuilt.objects.len() {
        0 => "no socket can be connected by the name in it".to_owned(),
        count => format!("{} the path that OpenSim finds; no other byte changes", sockets_get(count)),
    };
    Ok(Plan::from_objects(rebuilt, summary.into()))
}

/// The beginning of a sentence about sockets that get a path.
fn sockets_get(count: usize) -> String {
    if count == 1 { "1 socket gets".to_owned() } else { format!("{count} sockets get") }
}

/// Checks the request for all of its models.
///
/// # Errors
/// No model, or neither a class nor sockets.
pub(super) fn prepare(request: ConvertRequest) -> Result<PreparedChange, RequestFault> {
    if request.models.is_empty() {
        return Err(RequestFault::Missing { field: "models" });
    }
    refuse_geometry_output(&request.output)?;
    if request.sockets {
        let inspection = InspectionOptions { answers: request.answers, ..InspectionOptions::default() };
        let (models, output) = (request.models, request.output);
        return Ok(PreparedChange::new(Verb::Convert, models, output, inspection, plan_sockets));
    }
    let Some(to) = request.to else { return Err(RequestFault::Missing { field: "to" }) };
    refuse_smoothing(&request, to.kind())?;
    let mut wanted = Convert::new(to.kind());
    wanted.constant_contact_force = request.constant_contact_force.map(Positive::get);
    wanted.hertz_smoothing = request.hertz_smoothing.map(Positive::get);
    wanted.hunt_crossley_smoothing = request.hunt_crossley_smoothing.map(Positive::get);
    wanted.strict = request.strict;
    let selection = request.choice.selection();
    let planner = move |model: &Model| plan_conversion(model, &selection, &wanted);
    let inspection = InspectionOptions {
        choice: request.choice,
        answers: request.answers,
        ..InspectionOptions::default()
    };
    Ok(PreparedChange::new(Verb::Convert, request.models, request.output, inspection, planner))
}

/// Refuses smoothing values for a class of forces that has no smoothing.
fn refuse_smoothing(request: &ConvertRequest, to: ForceKind) -> Result<(), RequestFault> {
    let smoothing = [
        (Input::ConstantContactForce, request.constant_contact_force),
        (Input::HertzSmoothing, request.hertz_smoothing),
        (Input::HuntCrossleySmoothing, request.hunt_crossley_smoothing),
    ];
    let given = smoothing.into_iter().find_map(|(input, value)| value.map(|_| input));
    let Some(input) = given.filter(|_| to == ForceKind::HuntCrossley) else { return Ok(()) };
    let smooth = Input::To.with_value("smooth");
    let needs = phrase!["{} needs {}: a HuntCrossleyForce is not smoothed"; input, smooth];
    Err(RequestFault::refused(input, needs))
}

fn plan_conversion(model: &Model, selection: &Selection, wanted: &Convert) -> Result<Plan, Fault> {
    let selected = selection.apply_to_all(model)?;
    let dropped_pairs = remarks_on_dropped_pairs(model, &selected)?;
    let Converted { rebuilt, findings, renamed, without_sphere, dropped } =
        convert(model, &selected, wanted)?;
    // Spheres and planes that forces had inside themselves are new objects, too.
    let is_force = |object: &&ObjectChange| !object.class.starts_with("Contact");
    let forces_with = |action: ObjectAction| {
        rebuilt.objects.iter().filter(move |object| object.action == action).filter(is_force)
    };
    let (old, new) = (forces_with(ObjectAction::Removed).count(), forces_with(ObjectAction::Added).count());
    let class = wanted.to.as_str();
    let changes_class = forces_with(ObjectAction::Removed).any(|object| object.class != class);
    let summary = match old {
        0 if !without_sphere.is_empty() => "no force changes".to_owned(),
        0 if selected.forces.len() < model.forces().len() => {
            format!("every chosen force is a {class} for one sphere already")
        }
        0 => format!("every force is a {class} for one sphere already"),
        1 => format!("1 force becomes {}, one for each sphere", counted(new, class)),
        _ => format!("{old} forces become {}, one for each sphere", counted(new, class)),
    };
    let taken_out = rebuilt.objects.iter().any(|object| !is_force(&object));
    let missing_names = remarks_on_missing_names(&rebuilt);
    let old_document = remark_on_old_document(&rebuilt);
    let note = kept_note(model, &rebuilt, "convert");
    let mut plan = Plan::from_objects(rebuilt, summary.into()).with_note(note);
    plan.findings.extend(findings);
    plan.remarks.extend(remarks_on_renamed_forces(&renamed));
    plan.remarks.extend(taken_out.then(|| REMARK_GEOMETRY_TAKEN_OUT.into()));
    plan.remarks.extend(missing_names);
    plan.remarks.extend(old_document);
    if changes_class {
        plan.remarks.extend(remark_on_names_of_old_class(&plan, class));
        plan.remarks.extend(remarks_on_new_class(&plan, wanted));
    }
    plan.remarks.extend(dropped_pairs);
    let stays = |path: &String| format!("{path} holds no sphere that moves, and stays as it is").into();
    plan.remarks.extend(without_sphere.iter().map(stays));
    plan.remarks.extend(remarks_on_dropped_content(&dropped));
    Ok(plan)
}

/// Remarks on the new names of forces, which other files now have to use.
fn remarks_on_renamed_forces(renamed: &[(String, Vec<String>)]) -> Vec<Phrase> {
    let one = |(old, new): &(String, Vec<String>)| Phrase::from(format!("{old} is now {}", new.join(", ")));
    let mut remarks: Vec<Phrase> = renamed.iter().map(one).collect();
    if !renamed.is_empty() {
        let text = "other files that name these forces (analyses, goals, columns of results) have to name the new ones";
        remarks.push(text.into());
    }
    remarks
}

/// The largest number of names that a remark lists.
const NAMES_LISTED: usize = 3;

/// Remarks on comments and elements of forces that the new forces do not have.
fn remarks_on_dropped_content(dropped: &[(String, String)]) -> Vec<Phrase> {
    let one = |(path, what): &(String, String)| {
        Phrase::from(format!(
            "{path} contained {what}: not in what replaces it; keep the old model if it matters"
        ))
    };
    let mut remarks: Vec<Phrase> = dropped.iter().take(NAMES_LISTED).map(one).collect();
    if let Some(more) = dropped.len().checked_sub(NAMES_LISTED).filter(|more| *more > 0) {
        remarks.push(format!("so did {more} more forces").into());
    }
    remarks
}

/// A remark on names of forces which contain the name of the old class.
fn remark_on_names_of_old_class(plan: &Plan, class: &str) -> Option<Phrase> {
    let (hunt, smooth) = (ForceKind::HuntCrossley.as_str(), ForceKind::SmoothSphereHalfSpace.as_str());
    let other = if class == hunt { smooth } else { hunt };
    let new = plan.objects().iter().filter(|object| object.action == ObjectAction::Added);
    let names: Vec<String> =
        new.filter(|object| object.name.contains(other)).map(|object| object.name.clone()).collect();
    let text = format!(
        "names stay, also where they contain the name of the other class: {}",
        listed(&names, NAMES_LISTED)
    );
    (!names.is_empty()).then(|| text.into())
}

/// Remarks on the differences between the old class of the forces and the new one.
fn remarks_on_new_class(plan: &Plan, wanted: &Convert) -> Vec<Phrase> {
    match wanted.to {
        ForceKind::HuntCrossley => vec![
            "columns of results are named after bodies, such as force.calcn_r.force.X; MocoContactTrackingGoal takes smooth \
             forces only"
                .into(),
        ],
        _ => {
            let given = [wanted.constant_contact_force, wanted.hertz_smoothing, wanted.hunt_crossley_smoothing];
            remarks_on_smoothing(plan.objects(), given.iter().all(Option::is_some))
        }
    }
}
