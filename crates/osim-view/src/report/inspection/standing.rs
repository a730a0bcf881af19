//! How deep spheres are where each is at its own height, as rows: the text and the page share them.

use osim_inspect::{Figure, Figures, LimbFigures};
use osim_model::messages::four_significant;

/// Spheres of a limb that are equally deep.
pub struct EquallyDeep<'f> {
    /// The limb.
    pub limb: &'f str,
    /// x/R by the Hertz law and by the model's.
    pub indentation: [String; 2],
    /// Names of its spheres.
    pub spheres: Vec<&'f str>,
}

/// What it is about, in words.
pub const CAPTION: &str =
    "The bottoms of a limb are not level at the default pose; x/R at 1 BW with each sphere at its own height";

/// The spheres of limbs that stand on all of their spheres, at different heights.
pub fn equally_deep(figures: &Figures) -> Vec<EquallyDeep<'_>> {
    let mut rows: Vec<EquallyDeep<'_>> = Vec::new();
    for limb in figures.limbs.iter().filter(|limb| stands_unevenly(limb)) {
        let first = rows.len();
        for sphere in &limb.spheres {
            let value = |figure| sphere.value(figure).map(four_significant).unwrap_or_default();
            let indentation = [Figure::StandingIndentation, Figure::StandingIndentationModelLaw].map(value);
            match rows.iter_mut().skip(first).find(|row| row.indentation == indentation) {
                Some(row) => row.spheres.push(&sphere.sphere),
                None => rows.push(EquallyDeep {
                    limb: limb.limb.as_deref().unwrap_or_default(),
                    indentation,
                    spheres: vec![&sphere.sphere],
                }),
            }
        }
    }
    rows
}

/// Whether depths differ by more than rounding, and no sphere hangs above the floor.
fn stands_unevenly(limb: &LimbFigures) -> bool {
    const ROUNDING: f64 = 1e-6;
    let differs = |sphere: &osim_inspect::SphereFigures| {
        let level = sphere.value(Figure::LevelIndentation).or(sphere.value(Figure::Indentation));
        let own = sphere.value(Figure::StandingIndentation);
        own.zip(level).is_some_and(|(own, level)| (own - level).abs() > ROUNDING)
    };
    let touches = |sphere: &osim_inspect::SphereFigures| {
        sphere.value(Figure::StandingIndentation).is_some_and(|own| own > 0.0)
    };
    limb.spheres.iter().all(touches) && limb.spheres.iter().any(differs)
}
