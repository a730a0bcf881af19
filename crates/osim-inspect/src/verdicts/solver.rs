//! Whether a solver can live with the contacts.

use osim_model::messages::{Phrase, three_significant};

use super::known::Known;
use crate::figures::Figure;

/// How fast the contacts change, and what an impact leaves.
pub(super) fn right(known: &Known<'_>) -> Result<Phrase, Phrase> {
    let least = known.least(Figure::RestitutionExact).ok_or_else(|| known.why_no_figures())?;
    let mut text = match known.most(Figure::TransitionWidth) {
        Some(width) => format!("contact sets in over {} R", three_significant(width)),
        None => "contact sets in at once, without smoothing".to_owned(),
    };
    if let Some(speed) = known.inspected.figures.impact_speed_m_s {
        let (least, speed) = (three_significant(least), three_significant(speed));
        text.push_str(&format!("; a sphere keeps {least} of an impact speed of {speed} m/s"));
    }
    if let Some(frequency) = known.most(Figure::NaturalFrequency) {
        text.push_str(&format!("; it swings at {} Hz", three_significant(frequency)));
    }
    Ok(text.into())
}
