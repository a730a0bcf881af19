//! Inputs that groups of options bring along, and that would do nothing.

use osim_model::messages::{Input, phrase};
use osim_requests::RequestFault;
use osim_requests::options::OutputOptions;

/// Verbs that change whole objects do so in models: no geometry set is written beside them.
///
/// # Errors
/// A file for one is named.
pub(super) fn refuse_geometry_output(output: &OutputOptions) -> Result<(), RequestFault> {
    if output.geometry_output.is_none() {
        return Ok(());
    }
    let why = phrase![
        Input::GeometryOutput,
        " is for force sets that stand alone: whole objects are changed in whole models, whose geometry is in the same file"
    ];
    Err(RequestFault::refused(Input::GeometryOutput, why))
}
