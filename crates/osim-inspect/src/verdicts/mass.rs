//! Whether the contacts fit the mass of the body.

use osim_messages::{Phrase, four_significant, readable};

use super::known::Known;
use crate::figures::Figure;

/// What the contacts are made for, and how deep the deepest sphere is under the body.
pub(super) fn right(known: &Known<'_>) -> Result<Phrase, Phrase> {
    let deepest = known.most(Figure::Indentation).ok_or_else(|| known.why_no_figures())?;
    let weighs = known.inspected.figures.mass_kg.map(readable).unwrap_or_default();
    let made_for = match &known.inspected.contacts_mass_kg {
        Some(mass) if mass.recorded => format!("made for {} kg ({})", readable(mass.value), mass.description),
        _ => "no note says what they were made for".to_owned(),
    };
    let x_hat = four_significant(deepest);
    Ok(format!("{made_for}; under {weighs} kg on one limb the deepest sphere has x/R = {x_hat}").into())
}
