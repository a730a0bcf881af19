//! Whether the contacts fit the mass of the body.

use osim_model::messages::{Phrase, four_significant, phrase, readable};
use osim_model::{FindingCode, MassSource};

use super::known::Known;
use crate::figures::Figure;
use crate::inspection::step_in_words;

/// What the contacts are made for, and how deep the deepest sphere is under the body.
pub(super) fn right(known: &Known<'_>) -> Result<Phrase, Phrase> {
    let deepest = known.most(Figure::Indentation).ok_or_else(|| known.why_no_figures())?;
    let weighs = known.inspected.figures.mass_kg.map(readable).unwrap_or_default();
    let made_for = made_for(known).unwrap_or_else(|| "no note says what they were made for".into());
    let x_hat = four_significant(deepest);
    Ok(phrase![&made_for, format!("; under {weighs} kg on one limb the deepest sphere has x/R = {x_hat}")])
}

/// The same beside findings that say how deep spheres are, and not what they were made for.
pub(super) fn beside(known: &Known<'_>, worst: FindingCode) -> Option<Phrase> {
    let of_depth = [FindingCode::SunkIn, FindingCode::BeyondHertz, FindingCode::BeyondHertzAtTwo];
    made_for(known).filter(|_| of_depth.contains(&worst))
}

/// What somebody said that the contacts are made for: `made for 500 kg (note in the file, by rescale)`.
fn made_for(known: &Known<'_>) -> Option<Phrase> {
    let mass = known.inspected.contacts_mass_kg.as_ref().filter(|mass| mass.recorded)?;
    let note = known.model.note.as_ref().filter(|_| mass.source == MassSource::Note.as_str());
    let by = note.and_then(|note| note.steps.last()).map(|step| format!(", by {}", step_in_words(step)));
    Some(phrase![
        format!("made for {} kg (", readable(mass.value)),
        &mass.description,
        by.unwrap_or_default(),
        ")"
    ])
}
