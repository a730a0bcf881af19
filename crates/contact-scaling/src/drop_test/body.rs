//! The body of a drop test and the units its motion is computed in.

use crate::{Law, Spheres};

/// A body on its spheres, with the length, time and force that make its motion dimensionless.
#[derive(Debug, Clone, Copy)]
pub(super) struct Body<'a> {
    pub(super) spheres: &'a [Spheres],
    /// M g, in N.
    pub(super) weight_n: f64,
    /// L = √(Σ R_i² / n), in m.
    pub(super) length_m: f64,
    /// √(L / g), in s.
    pub(super) time_s: f64,
}

impl<'a> Body<'a> {
    pub(super) fn new(spheres: &'a [Spheres], mass_kg: f64, gravity_m_s2: f64) -> Self {
        let weigh = |f: fn(&Spheres) -> f64| spheres.iter().map(|s| s.count() * f(s)).sum::<f64>();
        let square = weigh(|s| s.law().hertz().radius_m() * s.law().hertz().radius_m());
        let length_m = (square / weigh(|_| 1.0)).sqrt();
        Self { spheres, weight_n: mass_kg * gravity_m_s2, length_m, time_s: (length_m / gravity_m_s2).sqrt() }
    }

    /// √(g L), in m/s.
    pub(super) fn speed_m_s(&self) -> f64 {
        self.length_m / self.time_s
    }

    /// Normal force of all spheres, in N.
    pub(super) fn force_n(&self, indentation_m: f64, speed_m_s: f64) -> f64 {
        self.spheres.iter().map(|s| s.force(indentation_m, speed_m_s)).sum()
    }

    /// Normal force over body weight, from the dimensionless state.
    pub(super) fn force(&self, state: [f64; 2]) -> f64 {
        self.force_n(state[0] * self.length_m, state[1] * self.speed_m_s()) / self.weight_n
    }

    /// The same of the smoothed laws alone, which act before contact too.
    pub(super) fn flight_force(&self, state: [f64; 2]) -> f64 {
        let smooth = self.spheres.iter().filter(|s| matches!(s.law(), Law::Smooth(_)));
        let (x, rate) = (state[0] * self.length_m, state[1] * self.speed_m_s());
        smooth.map(|s| s.force(x, rate)).sum::<f64>() / self.weight_n
    }

    /// Mean of a figure over the spheres.
    pub(super) fn mean(&self, figure: impl Fn(&Spheres) -> f64) -> f64 {
        let count: f64 = self.spheres.iter().map(Spheres::count).sum();
        self.spheres.iter().map(|s| s.count() * figure(s)).sum::<f64>() / count
    }

    /// The α of all spheres together: at one x their forces add up to one Hunt–Crossley law with the mean of
    /// α_i weighted by √R_i E*_i, as long as none is held at 0.
    pub(super) fn dissipation(&self) -> f64 {
        let strength = |s: &Spheres| s.count() * s.law().hertz().coefficient();
        let all: f64 = self.spheres.iter().map(strength).sum();
        self.spheres.iter().map(|s| strength(s) / all * s.law().dissipation()).sum()
    }
}
