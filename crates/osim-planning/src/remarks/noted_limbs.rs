//! A remark on stance limbs that the note remembers.

use osim_model::Model;
use osim_model::messages::{Input, Phrase, phrase, readable};
use osim_requests::options::CountOptions;

/// How many limbs carry the body, where the note in `model` says so and the caller did not.
pub(crate) fn noted_limbs(counts: &CountOptions, model: &Model) -> Option<Phrase> {
    let noted = model.noted_stance_limbs()?;
    let is_said = counts.stance_limbs.is_some() || counts.spheres.is_some();
    let text = format!("{} limbs share the weight, as the note in the model says: ", readable(noted));
    (!is_said).then(|| phrase![text, Input::StanceLimbs, " says another number"])
}
