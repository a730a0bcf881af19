//! The search where the onset is not known: a coarse scan, then Levenberg–Marquardt on all parameters.

use rmpfit::{MPConfig, MPFitter, MPPar, MPResult, MPSide, MPSuccess};

use super::error::FitError;
use super::linear;
use super::model::{Model, Parameters};
use super::points::Point;

/// Onsets tried before the search, over the range of the indentation.
const SCAN: u32 = 64;

/// The parameters of least squares, the onset among them.
pub(super) fn solve(model: &Model, points: &[Point]) -> Result<Parameters, FitError> {
    let (low, high) = range(points, |p| p.indentation);
    let start = scan(model, points, low, high)?;
    let force = points.iter().fold(0.0, |most: f64, p| most.max(p.force.abs()));
    let length = high - low;
    let sum = |p: &Parameters| points.iter().map(|at| (at.force - model.force(p, at)).powi(2)).sum::<f64>();
    if sum(&start).sqrt() <= 1e-14 * force {
        return Ok(start);
    }
    let mut search = Search::new(model, points, &start, force, length);
    let mut unknowns = search.to_unknowns(&start);
    let status = search.mpfit(&mut unknowns).map_err(|_| FitError::NotConverged)?;
    if matches!(status.success, MPSuccess::NotDone | MPSuccess::MaxIter) {
        return Err(FitError::NotConverged);
    }
    let onset = search.to_parameters(&unknowns).onset;
    // Both linear parameters once more, in closed form: exact for this onset.
    linear::solve(model, points, onset)
}

/// The best of some onsets, each with its closed form.
fn scan(model: &Model, points: &[Point], low: f64, high: f64) -> Result<Parameters, FitError> {
    let needed = model.names().len() + 1;
    if points.len() < needed {
        return Err(FitError::TooFewPoints { found: points.len(), needed });
    }
    if high <= low {
        return Err(FitError::OneIndentation { indentation_m: high });
    }
    // From half the range before the first row, since the whole measurement may be in contact.
    let onsets = (0..SCAN).map(|i| low + (high - low) * (1.5 * f64::from(i) / f64::from(SCAN) - 0.5));
    let mut best: Result<(f64, Parameters), FitError> = Err(FitError::NotConverged);
    for onset in onsets {
        match linear::solve(model, points, onset) {
            Ok(fitted) if fitted.modulus > 0.0 => {
                let square: f64 = points.iter().map(|p| (p.force - model.force(&fitted, p)).powi(2)).sum();
                if best.as_ref().map_or(true, |(least, _)| square < *least) {
                    best = Ok((square, fitted));
                }
            }
            Ok(_) => {}
            Err(error) => best = best.or(Err(error)),
        }
    }
    best.map(|(_, fitted)| fitted)
}

fn range(points: &[Point], value: impl Fn(&Point) -> f64) -> (f64, f64) {
    points
        .iter()
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), p| (low.min(value(p)), high.max(value(p))))
}

/// The problem as rmpfit takes it; every unknown is near 1.
struct Search<'a> {
    model: &'a Model,
    points: &'a [Point],
    force: f64,
    modulus: f64,
    modulus_dissipation: f64,
    length: f64,
    config: MPConfig,
    settings: Vec<MPPar>,
}

impl<'a> Search<'a> {
    fn new(model: &'a Model, points: &'a [Point], start: &Parameters, force: f64, length: f64) -> Self {
        let speed = points.iter().fold(0.0, |most: f64, p| most.max(p.speed.abs()));
        let config = MPConfig { ftol: 1e-15, xtol: 1e-14, gtol: 1e-14, ..MPConfig::new() };
        let setting = || MPPar { side: MPSide::User, ..MPPar::new() };
        let settings = model.names().iter().map(|_| setting()).collect();
        let modulus_dissipation = if speed > 0.0 { start.modulus / speed } else { start.modulus };
        Self { model, points, force, modulus: start.modulus, modulus_dissipation, length, config, settings }
    }

    fn to_unknowns(&self, p: &Parameters) -> Vec<f64> {
        let mut unknowns = vec![p.modulus / self.modulus];
        unknowns
            .extend(self.model.with_dissipation.then_some(p.modulus_dissipation / self.modulus_dissipation));
        unknowns.push(p.onset / self.length);
        unknowns
    }

    fn to_parameters(&self, unknowns: &[f64]) -> Parameters {
        let modulus_dissipation =
            if self.model.with_dissipation { unknowns[1] * self.modulus_dissipation } else { 0.0 };
        Parameters {
            modulus: unknowns[0] * self.modulus,
            modulus_dissipation,
            onset: unknowns[unknowns.len() - 1] * self.length,
        }
    }
}

impl MPFitter for Search<'_> {
    fn eval(&mut self, unknowns: &[f64], deviates: &mut [f64]) -> MPResult<()> {
        let p = self.to_parameters(unknowns);
        for (deviate, point) in deviates.iter_mut().zip(self.points) {
            *deviate = (point.force - self.model.force(&p, point)) / self.force;
        }
        Ok(())
    }

    fn number_of_points(&self) -> usize {
        self.points.len()
    }

    fn config(&self) -> &MPConfig {
        &self.config
    }

    fn parameters(&self) -> &[MPPar] {
        &self.settings
    }

    fn jacobian(
        &mut self,
        unknowns: &[f64],
        deviates: &mut [f64],
        slopes: &mut [Option<Vec<f64>>],
    ) -> MPResult<()> {
        self.eval(unknowns, deviates)?;
        let p = self.to_parameters(unknowns);
        let last = slopes.len() - 1;
        for (column, slope) in slopes.iter_mut().enumerate() {
            let Some(slope) = slope else { continue };
            for (value, point) in slope.iter_mut().zip(self.points) {
                let rate = if column == last {
                    self.model.onset_slope(&p, point) * self.length
                } else if column == 0 {
                    self.model.elastic(point, p.onset) * self.modulus
                } else {
                    self.model.dissipative(point, p.onset) * self.modulus_dissipation
                };
                *value = -rate / self.force;
            }
        }
        Ok(())
    }
}
