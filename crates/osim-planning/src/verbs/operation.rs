//! The operation as the note in a file records it.

use osim_model::messages::shortest;
use osim_model::{Fault, Model, Needed, RadiusRule};

/// A factor that the note says was applied already is not applied once more in place, unless that is wanted.
///
/// # Errors
/// The question whether it is.
pub(super) fn refuse_again(model: &Model, operation: &str, may_repeat: bool) -> Result<(), Fault> {
    let done = model.note.as_ref().is_some_and(|note| note.operation() == operation);
    if !done || may_repeat {
        return Ok(());
    }
    Err(Fault::new(Needed::Repetition { operation: operation.to_owned() }))
}

/// The verb, and the factor of the radius where one is given.
pub(super) fn operation(verb: &str, radius: Option<RadiusRule>) -> String {
    match radius {
        Some(RadiusRule::Factor(factor)) => format!("{verb} radius=x{}", shortest(factor)),
        _ => verb.to_owned(),
    }
}
