//! The model of a fit and its solutions: in closed form, or by Levenberg–Marquardt if the onset of contact is not known.

use rmpfit::{MPConfig, MPFitter, MPPar, MPResult, MPSide, MPSuccess};

use super::measurement::{FitError, Parameter, Point, Result};

/// The choice of fitted parameters, and the factor K = n 4/3 √R (`gain`).
#[derive(Debug, Clone, Copy)]
pub(super) struct FitModel {
    pub(super) gain: f64,
    pub(super) with_dissipation: bool,
    pub(super) with_onset: bool,
}

/// Values of the parameters. It has the product E* α instead of α, because the force is linear in E* and E* α.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Parameters {
    pub(super) modulus: f64,
    modulus_dissipation: f64,
    pub(super) onset: f64,
}

impl Parameters {
    /// α = (E* α) / E*, in s/m.
    pub(super) fn dissipation(&self) -> f64 {
        self.modulus_dissipation / self.modulus
    }
}

impl FitModel {
    pub(super) fn names(&self) -> Vec<Parameter> {
        let mut names = vec![Parameter::CompositeModulus];
        names.extend(self.with_dissipation.then_some(Parameter::Dissipation));
        names.extend(self.with_onset.then_some(Parameter::Onset));
        names
    }

    /// K u^(3/2), the factor of E* in the force; u is the indentation from the onset.
    pub(super) fn elastic_factor(&self, point: &Point, onset: f64) -> f64 {
        let u = (point.indentation - onset).max(0.0);
        self.gain * (u * u.sqrt())
    }

    /// K 3/2 u^(3/2) ẋ, the factor of E* α in the force; u is the indentation from the onset.
    pub(super) fn dissipative_factor(&self, point: &Point, onset: f64) -> f64 {
        self.elastic_factor(point, onset) * (1.5 * point.speed)
    }

    /// Derivative of the force by the onset, ∂F/∂x₀ = −3/2 K √u (E* + E* α 3/2 ẋ).
    fn force_slope_by_onset(&self, p: &Parameters, point: &Point) -> f64 {
        let u = (point.indentation - p.onset).max(0.0);
        -1.5 * self.gain * u.sqrt() * (p.modulus + p.modulus_dissipation * (1.5 * point.speed))
    }

    /// Force of the law at a measured point, N.
    pub(super) fn force(&self, p: &Parameters, point: &Point) -> f64 {
        p.modulus * self.elastic_factor(point, p.onset)
            + p.modulus_dissipation * self.dissipative_factor(point, p.onset)
    }

    /// Derivatives of the force by each fitted parameter: E*, α, x₀.
    pub(super) fn force_gradient(&self, p: &Parameters, point: &Point) -> Vec<f64> {
        let alpha = p.dissipation();
        let (elastic, dissipative) =
            (self.elastic_factor(point, p.onset), self.dissipative_factor(point, p.onset));
        let mut row = vec![elastic + alpha * dissipative];
        row.extend(self.with_dissipation.then_some(p.modulus * dissipative));
        row.extend(self.with_onset.then(|| self.force_slope_by_onset(p, point)));
        row
    }
}

// The closed form where the onset is known: F is linear in E* and E* α.

/// Smallest sine of the angle between the elastic and the dissipative column for which E* and α can be distinguished.
const SMALLEST_SINE_BETWEEN_COLUMNS: f64 = 1e-6;

/// The least-squares parameters for a known onset.
pub(super) fn solve_with_known_onset(model: &FitModel, points: &[Point], onset: f64) -> Result<Parameters> {
    let needed = model.names().len() + 1;
    let found = points.iter().filter(|p| p.indentation > onset).count();
    if found < needed {
        return Err(FitError::TooFewPoints { found, needed });
    }
    let (a, f): (Vec<f64>, Vec<f64>) =
        points.iter().map(|p| (model.elastic_factor(p, onset), p.force)).unzip();
    let aa = dot_product(&a, &a);
    if !model.with_dissipation {
        return Ok(Parameters { modulus: dot_product(&a, &f) / aa, modulus_dissipation: 0.0, onset });
    }
    // Gram–Schmidt: c is what b has besides a.
    let b: Vec<f64> = points.iter().map(|p| model.dissipative_factor(p, onset)).collect();
    let share = dot_product(&a, &b) / aa;
    let c: Vec<f64> = a.iter().zip(&b).map(|(a, b)| b - share * a).collect();
    let (bb, cc) = (dot_product(&b, &b), dot_product(&c, &c));
    if cc <= SMALLEST_SINE_BETWEEN_COLUMNS * SMALLEST_SINE_BETWEEN_COLUMNS * bb {
        return Err(FitError::Undetermined { parameter: "dissipation" });
    }
    let modulus_dissipation = dot_product(&c, &f) / cc;
    Ok(Parameters {
        modulus: dot_product(&a, &f) / aa - share * modulus_dissipation,
        modulus_dissipation,
        onset,
    })
}

fn dot_product(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

// The search where the onset is not known: a coarse scan, then Levenberg–Marquardt on all parameters.

/// Number of onsets that are tried before the search, over the range of the indentation.
const SCANNED_ONSETS: u32 = 64;

/// The least-squares parameters with a fitted onset.
pub(super) fn solve_with_onset(model: &FitModel, points: &[Point]) -> Result<Parameters> {
    let (low, high) = value_range(points.iter().map(|p| p.indentation));
    let start = best_of_tried_onsets(model, points, low, high)?;
    let force = points.iter().fold(0.0, |most: f64, p| most.max(p.force.abs()));
    let length = high - low;
    let sum = |p: &Parameters| points.iter().map(|at| (at.force - model.force(p, at)).powi(2)).sum::<f64>();
    if sum(&start).sqrt() <= 1e-14 * force {
        return Ok(start);
    }
    let mut search = OnsetSearch::new(model, points, &start, force, length);
    let mut unknowns = search.to_unknowns(&start);
    let status = search.mpfit(&mut unknowns).map_err(|_| FitError::NotConverged)?;
    if matches!(status.success, MPSuccess::NotDone | MPSuccess::MaxIter) {
        return Err(FitError::NotConverged);
    }
    let onset = search.to_parameters(&unknowns).onset;
    // Both linear parameters once more, in closed form: exact for this onset.
    solve_with_known_onset(model, points, onset)
}

/// The best of some onsets, each with its closed-form parameters.
fn best_of_tried_onsets(model: &FitModel, points: &[Point], low: f64, high: f64) -> Result<Parameters> {
    let needed = model.names().len() + 1;
    if points.len() < needed {
        return Err(FitError::TooFewPoints { found: points.len(), needed });
    }
    if high <= low {
        return Err(FitError::OneIndentation { indentation_m: high });
    }
    // From half the range before the first row, since the whole measurement may be in contact.
    let onsets = (0..SCANNED_ONSETS)
        .map(|i| low + (high - low) * (1.5 * f64::from(i) / f64::from(SCANNED_ONSETS) - 0.5));
    let mut best: Result<(f64, Parameters)> = Err(FitError::NotConverged);
    for onset in onsets {
        match solve_with_known_onset(model, points, onset) {
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

/// The smallest and the largest of the values.
pub(super) fn value_range(values: impl Iterator<Item = f64>) -> (f64, f64) {
    values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)))
}

/// The problem in the form of the library `rmpfit`; the unknowns are scaled to be near 1.
struct OnsetSearch<'a> {
    model: &'a FitModel,
    points: &'a [Point],
    force: f64,
    modulus: f64,
    modulus_dissipation: f64,
    length: f64,
    config: MPConfig,
    settings: Vec<MPPar>,
}

impl<'a> OnsetSearch<'a> {
    /// The search that begins at `start`; the unknowns are scaled by a typical `force` and `length`.
    fn new(model: &'a FitModel, points: &'a [Point], start: &Parameters, force: f64, length: f64) -> Self {
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

impl MPFitter for OnsetSearch<'_> {
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
                    self.model.force_slope_by_onset(&p, point) * self.length
                } else if column == 0 {
                    self.model.elastic_factor(point, p.onset) * self.modulus
                } else {
                    self.model.dissipative_factor(point, p.onset) * self.modulus_dissipation
                };
                *value = -rate / self.force;
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn points(speed: impl Fn(f64) -> f64) -> Vec<Point> {
        let point = |row: usize| {
            let indentation = row as f64 * 1e-3;
            let speed = speed(indentation);
            let force = 500.0 * indentation.powf(1.5) * (1.0 + 1.5 * 0.4 * speed);
            Point { row, indentation, force, speed }
        };
        (0..10).map(point).collect()
    }

    const MODEL: FitModel = FitModel { gain: 2.0, with_dissipation: true, with_onset: false };

    #[test]
    fn exact_data_give_exact_parameters() {
        let fitted = solve_with_known_onset(&MODEL, &points(|x| 0.3 - 50.0 * x), 0.0).unwrap();
        assert!((fitted.modulus / 250.0 - 1.0).abs() < 1e-13);
        assert!((fitted.dissipation() / 0.4 - 1.0).abs() < 1e-12);
    }

    #[test]
    fn one_speed_does_not_distinguish_dissipation_from_stiffness() {
        let error = solve_with_known_onset(&MODEL, &points(|_| 0.2), 0.0).unwrap_err();
        assert_eq!(error, FitError::Undetermined { parameter: "dissipation" });
        assert!(solve_with_known_onset(&MODEL, &points(|_| 0.0), 0.0).is_err());
    }

    #[test]
    fn rows_before_contact_do_not_count() {
        let error = solve_with_known_onset(&MODEL, &points(|x| x), 0.0075).unwrap_err();
        assert_eq!(error, FitError::TooFewPoints { found: 2, needed: 3 });
    }
}
