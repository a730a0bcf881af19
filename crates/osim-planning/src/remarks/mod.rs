//! Remarks, questions and refusals when contacts are added, converted, removed or scaled.

mod feet;
mod forces;

use osim_model::messages::{Input, phrase, shortest};
use osim_model::{Fault, Model, Needed, RadiusRule};
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

/// Refuses to apply a factor once more in place, if the note says that it was applied already and `may_repeat` is false.
///
/// # Errors
/// The question whether it should be applied again.
pub(crate) fn refuse_repetition(model: &Model, operation: &str, may_repeat: bool) -> Result<(), Fault> {
    let done = model.note.as_ref().is_some_and(|note| note.operation() == operation);
    if !done || may_repeat {
        return Ok(());
    }
    Err(Fault::new(Needed::Repetition { operation: operation.to_owned() }))
}

/// An operation as notes name it: the verb, and the factor of the radius where one is given.
pub(crate) fn operation_with_radius(verb: &str, radius: Option<RadiusRule>) -> String {
    match radius {
        Some(RadiusRule::Factor(factor)) => format!("{verb} radius=x{}", shortest(factor)),
        _ => verb.to_owned(),
    }
}

/// Refuses an output file for a geometry set: verbs that change whole objects do so in whole models only.
///
/// # Errors
/// The request names such a file.
pub(crate) fn refuse_geometry_output(output: &OutputOptions) -> Result<(), RequestFault> {
    if output.geometry_output.is_none() {
        return Ok(());
    }
    let why = phrase![
        Input::GeometryOutput,
        " is for force sets that stand alone: whole objects are changed in whole models, whose geometry is in the same file"
    ];
    Err(RequestFault::refused(Input::GeometryOutput, why))
}
