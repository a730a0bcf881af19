//! Remarks, questions and refusals for changes that add, convert, remove or scale contacts.

mod feet;
mod forces;

use osim_model::messages::{Input, phrase, shortest};
use osim_model::{Fault, MissingFact, Model, RadiusRule};
use osim_requests::RequestFault;
use osim_requests::options::OutputOptions;

pub(crate) use feet::{
    JointPositions, question_about_pad, question_about_scale, remark_on_leaning_planes,
    remark_on_noted_limbs, remark_on_other_planes, remark_on_standing, remarks_on_parts_of_feet,
};
pub(crate) use forces::{
    findings_on_smoothing, remark_on_kept_friction, remark_on_old_document, remarks_on_dropped_pairs,
    remarks_on_missing_names, remarks_on_smoothing,
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
