//! The figures of spheres as rows of a table: the text and the page share them.

use osim_inspect::{Figure, Shown, SphereFigures};
use osim_model::messages::four_significant;

/// What the spheres of a table have in common.
#[derive(Clone, Copy)]
pub struct Spheres {
    /// Whether spheres of a limb differ.
    pub mixed: bool,
    /// Whether some follow the smoothed law.
    pub smooth: bool,
}

impl Spheres {
    /// What `spheres` have in common; `mixed` says that those of a limb differ.
    pub fn new<'s>(mixed: bool, mut spheres: impl Iterator<Item = &'s SphereFigures>) -> Self {
        let smooth = spheres.any(|sphere| sphere.value(Figure::ConstantIndentation).is_some());
        Self { mixed, smooth }
    }

    /// The figures that are shown for them, in their order.
    pub fn figures(self) -> impl Iterator<Item = Figure> {
        let shown = move |figure: &Figure| match figure.shown() {
            Shown::Always => true,
            Shown::Nowhere => false,
            Shown::Smooth => self.smooth,
            Shown::Mixed => self.mixed,
            Shown::MixedSmooth => self.mixed && self.smooth,
        };
        Figure::ALL.iter().copied().filter(shown)
    }
}

/// The first cell of a row; for restitution with the impact speed (m/s), if there is one.
pub fn heading(figure: Figure, impact_speed_m_s: Option<f64>) -> String {
    match (figure, impact_speed_m_s) {
        (Figure::RestitutionExact, Some(speed)) => format!("restitution at {} m/s", four_significant(speed)),
        _ => figure.info().heading(),
    }
}

/// The limit, in the second cell.
pub fn limit(figure: Figure) -> String {
    figure.info().limit.map(ToString::to_string).unwrap_or_default()
}

/// A figure as it is shown.
pub struct FigureText {
    /// Its value.
    pub text: String,
    /// Whether it is outside its limit.
    pub outside: bool,
}

/// The figure of a sphere as it is shown; `None` if it is not known.
pub fn value(figure: Figure, sphere: &SphereFigures) -> Option<FigureText> {
    let outside = sphere.is_within(figure) == Some(false);
    match sphere.value(figure) {
        Some(value) => Some(FigureText { text: four_significant(value), outside }),
        // (13) has no answer below 0, and that is outside.
        None => outside.then(|| FigureText { text: "below 0".to_owned(), outside }),
    }
}

/// The figures that are shown.
fn shown() -> impl Iterator<Item = Figure> {
    Figure::ALL.iter().copied().filter(|figure| figure.shown() != Shown::Nowhere)
}

/// What is shown of a sphere: spheres with the same figures share a column.
pub fn key(sphere: &SphereFigures) -> Vec<String> {
    shown().map(|figure| sphere.value(figure).map(four_significant).unwrap_or_default()).collect()
}

/// The same without a text, in all digits: if this is equal, so is the key.
pub fn exact_key(sphere: &SphereFigures) -> Vec<Option<u64>> {
    shown().map(|figure| sphere.value(figure).map(f64::to_bits)).collect()
}
