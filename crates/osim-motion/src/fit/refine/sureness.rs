//! How sure the unknowns are, from how the cost answers to each while all others follow.

use super::layout::Layout;
use super::refining::{Refined, Refining};
use crate::fit::ranges::{NEARLY, NEARLY_BW};
use crate::fit::result::FittedParameter;
use crate::fit::search::independent;

/// What is known of the best unknowns.
pub(in crate::fit) struct Sureness {
    values: Vec<f64>,
    covariance: Vec<Vec<f64>>,
    limits: Vec<(f64, f64)>,
    held: Vec<bool>,
    /// Half of the slope of the cost by each unknown.
    slope: Vec<f64>,
    /// For each unknown that is at a bound, its variance if it were not.
    free: Vec<f64>,
    /// The variance of a residual, for standard errors.
    variance: f64,
    /// By how much the cost may grow in a fit that is nearly as good.
    allowed: f64,
}

impl Sureness {
    pub(in crate::fit) fn of(refining: &Refining<'_>, best: &Refined, layout: &Layout) -> Self {
        let residuals = refining.force_residuals(&best.shared, Some(&best.slack));
        let square: f64 = residuals.iter().map(|one| one * one).sum();
        let free = (independent(&residuals) - layout.size as f64).max(1.0);
        let rms_bw = (square / residuals.len().max(1) as f64).sqrt();
        let most_bw = (rms_bw * NEARLY).max(rms_bw + NEARLY_BW);
        let unheld = |place: usize| {
            let held = best.held.iter().enumerate().map(|(other, is_held)| other != place && *is_held);
            let covariance = best.normal.covariance(&held.collect::<Vec<bool>>())?;
            covariance.get(place)?.get(place).copied()
        };
        let each = best.held.iter().enumerate();
        Self {
            free: each
                .map(|(place, is_held)| is_held.then(|| unheld(place)).flatten().unwrap_or(f64::NAN))
                .collect(),
            slope: best.normal.slope.clone(),
            values: best.shared.clone(),
            covariance: best.normal.covariance(&best.held).unwrap_or_default(),
            limits: layout.limits(),
            held: best.held.clone(),
            variance: square / free,
            allowed: (most_bw * most_bw - rms_bw * rms_bw) * residuals.len() as f64,
        }
    }

    fn cell(&self, one: usize, other: usize) -> f64 {
        self.covariance.get(one).and_then(|row| row.get(other)).copied().unwrap_or(f64::NAN)
    }

    /// The correlation of two unknowns.
    pub(in crate::fit) fn correlation(&self, one: usize, other: usize) -> f64 {
        self.cell(one, other) / (self.cell(one, one) * self.cell(other, other)).sqrt()
    }

    /// The unknown at a place.
    pub(in crate::fit) fn parameter(&self, place: usize) -> FittedParameter {
        let value = self.values.get(place).copied().unwrap_or(f64::NAN);
        let (low, high) = self.limits.get(place).copied().unwrap_or((value, value));
        let at_bound = self.held.get(place).copied().unwrap_or(false);
        let reach = match at_bound {
            // From a bound the cost goes up in a slope and a parabola.
            true => {
                let variance = self.free.get(place).copied().unwrap_or(f64::NAN);
                let slope = self.slope.get(place).copied().unwrap_or_default().abs();
                variance * ((slope * slope + self.allowed / variance).sqrt() - slope)
            }
            false => (self.allowed * self.cell(place, place)).sqrt(),
        };
        let reach = if reach.is_finite() { reach } else { 0.0 };
        FittedParameter {
            value,
            standard_error: (self.variance * self.cell(place, place)).sqrt(),
            nearly_as_good: ((value - reach).max(low), (value + reach).min(high)),
            at_bound,
        }
    }

    /// The same of an unknown that is the logarithm of a factor.
    pub(in crate::fit) fn factor(&self, place: usize) -> FittedParameter {
        let log = self.parameter(place);
        let (low, high) = log.nearly_as_good;
        let value = log.value.exp();
        FittedParameter {
            value,
            standard_error: log.standard_error * value,
            nearly_as_good: (low.exp(), high.exp()),
            at_bound: log.at_bound,
        }
    }
}
