//! Remarks when contacts are made, converted or removed, beside the numbers that change: remarks about the result,
//! questions about values that are probably in another unit, and what is refused.

mod feet;
mod forces;

use osim_model::messages::{Input, phrase, shortest};
use osim_model::{Fault, Model, Needed, RadiusRule};
use osim_requests::RequestFault;
use osim_requests::options::OutputOptions;

pub(crate) use feet::{
    Bones, leaning, noted_limbs, pad_slip, parts_of_feet, planes_left, refuse_known, scale_slip, standing,
};
pub(crate) use forces::{dropped_pairs, friction_stays, smoothed, still_named, too_new, too_smooth};

/// A factor that the note says was applied already is not applied once more in place, unless that is wanted.
///
/// # Errors
/// The question whether it is.
pub(crate) fn refuse_again(model: &Model, operation: &str, may_repeat: bool) -> Result<(), Fault> {
    let done = model.note.as_ref().is_some_and(|note| note.operation() == operation);
    if !done || may_repeat {
        return Ok(());
    }
    Err(Fault::new(Needed::Repetition { operation: operation.to_owned() }))
}

/// The verb, and the factor of the radius where one is given.
pub(crate) fn operation(verb: &str, radius: Option<RadiusRule>) -> String {
    match radius {
        Some(RadiusRule::Factor(factor)) => format!("{verb} radius=x{}", shortest(factor)),
        _ => verb.to_owned(),
    }
}

/// Verbs that change whole objects do so in models: no geometry set is written beside them.
///
/// # Errors
/// A file for one is named.
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
