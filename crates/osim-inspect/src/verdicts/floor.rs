//! Whether the floor is one.

use osim_messages::Phrase;

use super::known::Known;

/// How many planes the spheres meet, and that these are level.
pub(super) fn right(known: &Known<'_>) -> Result<Phrase, Phrase> {
    let forces = known.model.forces().iter().filter(|force| force.applies);
    if !forces.into_iter().any(|force| known.model.meets_half_space(force)) {
        return Err("no moving sphere meets a half-space".into());
    }
    Ok("it is level".into())
}
