//! What verdicts are given from.

use osim_model::Model;
use osim_model::messages::Phrase;

use crate::figures::{Figure, SphereFigures};
use crate::inspection::Inspection;

/// A model and what its inspection shows.
pub(super) struct Known<'k> {
    pub(super) model: &'k Model,
    pub(super) inspected: &'k Inspection,
}

impl Known<'_> {
    /// The largest value of a figure among the chosen spheres.
    pub(super) fn most(&self, figure: Figure) -> Option<f64> {
        self.values(figure).reduce(f64::max)
    }

    /// The least value of a figure among the chosen spheres.
    pub(super) fn least(&self, figure: Figure) -> Option<f64> {
        self.values(figure).reduce(f64::min)
    }

    fn values(&self, figure: Figure) -> impl Iterator<Item = f64> {
        let spheres = self.inspected.figures.spheres();
        spheres.filter_map(move |sphere: &SphereFigures| sphere.value(figure))
    }

    /// Why figures under body weight are absent.
    pub(super) fn why_no_figures(&self) -> Phrase {
        let why = self.inspected.figures.why_no_body_weight.clone();
        why.unwrap_or_else(|| "no sphere of the chosen forces carries weight".into())
    }
}

/// Two numbers as a range, or as one number if they look the same.
pub(super) fn range(least: &str, most: &str) -> String {
    if least == most { least.to_owned() } else { format!("{least} to {most}") }
}
