//! The force as a function of the parameters: F = K E* u^(3/2) + K E* α · 3/2 u^(3/2) ẋ with u = x − x₀.

use super::parameter::Parameter;
use super::points::Point;

/// What is fitted, and the factor K = n 4/3 √R.
#[derive(Debug, Clone, Copy)]
pub(super) struct Model {
    pub(super) gain: f64,
    pub(super) with_dissipation: bool,
    pub(super) with_onset: bool,
}

/// Values of the parameters; E* α instead of α, so that the force is linear in both.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Parameters {
    pub(super) modulus: f64,
    pub(super) modulus_dissipation: f64,
    pub(super) onset: f64,
}

impl Parameters {
    pub(super) fn dissipation(&self) -> f64 {
        self.modulus_dissipation / self.modulus
    }
}

impl Model {
    pub(super) fn names(&self) -> Vec<Parameter> {
        let mut names = vec![Parameter::CompositeModulus];
        names.extend(self.with_dissipation.then_some(Parameter::Dissipation));
        names.extend(self.with_onset.then_some(Parameter::Onset));
        names
    }

    /// K u^(3/2), by which E* is multiplied.
    pub(super) fn elastic(&self, point: &Point, onset: f64) -> f64 {
        let u = (point.indentation - onset).max(0.0);
        self.gain * (u * u.sqrt())
    }

    /// K 3/2 u^(3/2) ẋ, by which E* α is multiplied.
    pub(super) fn dissipative(&self, point: &Point, onset: f64) -> f64 {
        self.elastic(point, onset) * (1.5 * point.speed)
    }

    /// ∂F/∂x₀ = −3/2 K √u (E* + E* α 3/2 ẋ).
    pub(super) fn onset_slope(&self, p: &Parameters, point: &Point) -> f64 {
        let u = (point.indentation - p.onset).max(0.0);
        -1.5 * self.gain * u.sqrt() * (p.modulus + p.modulus_dissipation * (1.5 * point.speed))
    }

    pub(super) fn force(&self, p: &Parameters, point: &Point) -> f64 {
        p.modulus * self.elastic(point, p.onset) + p.modulus_dissipation * self.dissipative(point, p.onset)
    }

    /// ∂F by E*, α and x₀, those that are fitted.
    pub(super) fn gradient(&self, p: &Parameters, point: &Point) -> Vec<f64> {
        let alpha = p.dissipation();
        let (elastic, dissipative) = (self.elastic(point, p.onset), self.dissipative(point, p.onset));
        let mut row = vec![elastic + alpha * dissipative];
        row.extend(self.with_dissipation.then_some(p.modulus * dissipative));
        row.extend(self.with_onset.then(|| self.onset_slope(p, point)));
        row
    }
}
