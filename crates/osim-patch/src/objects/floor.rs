//! Which half-space is the floor.

use osim_model::{Fault, HalfSpace, Model};

/// The floor of `model`: the one half-space on ground that faces straight up; `None` where there is none.
///
/// # Errors
/// Several could be it: their names.
pub(super) fn floor(model: &Model) -> Result<Option<HalfSpace>, Fault> {
    let mut floors = model.floors().into_iter();
    let Some(first) = floors.next() else { return Ok(None) };
    let others: Vec<String> = floors.map(|plane| plane.name).collect();
    if others.is_empty() {
        return Ok(model.half_spaces().into_iter().find(|plane| plane.name == first.name));
    }
    Err(Fault::refused(format!(
        "{} and {} both could be the floor (on ground, facing up): remove or turn all but one in OpenSim, then do this again",
        first.name,
        others.join(", ")
    )))
}
