//! Whether sizes and places of spheres are believable.

use osim_model::messages::{Phrase, three_significant};

use super::known::{Known, range};
use crate::figures::Figure;

/// The radii, and how large they are for the body.
pub(super) fn right(known: &Known<'_>) -> Result<Phrase, Phrase> {
    let radii = known.least(Figure::Radius).zip(known.most(Figure::Radius));
    let (least, most) = radii.ok_or_else(|| known.why_no_figures())?;
    let of = |scale: f64| range(&three_significant(least * scale), &three_significant(most * scale));
    let radii = format!("radii of {} mm", of(1000.0));
    Ok(match known.inspected.figures.mass_kg {
        Some(mass) => format!("{radii}, {} m/kg^(1/3) of the mass", of(mass.cbrt().recip())),
        None => radii,
    }
    .into())
}
