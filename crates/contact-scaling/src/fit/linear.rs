//! The closed form where the onset is known: F is linear in E* and E* α.

use super::error::FitError;
use super::model::{Model, Parameters};
use super::points::Point;

/// How far from 1 the correlation of the two columns must be.
const SMALLEST_ANGLE: f64 = 1e-6;

/// The parameters of least squares for this onset.
pub(super) fn solve(model: &Model, points: &[Point], onset: f64) -> Result<Parameters, FitError> {
    let needed = model.names().len() + 1;
    let found = points.iter().filter(|p| p.indentation > onset).count();
    if found < needed {
        return Err(FitError::TooFewPoints { found, needed });
    }
    let (a, f): (Vec<f64>, Vec<f64>) = points.iter().map(|p| (model.elastic(p, onset), p.force)).unzip();
    let aa = dot(&a, &a);
    if !model.with_dissipation {
        return Ok(Parameters { modulus: dot(&a, &f) / aa, modulus_dissipation: 0.0, onset });
    }
    // Gram–Schmidt: c is what b has besides a.
    let b: Vec<f64> = points.iter().map(|p| model.dissipative(p, onset)).collect();
    let share = dot(&a, &b) / aa;
    let c: Vec<f64> = a.iter().zip(&b).map(|(a, b)| b - share * a).collect();
    let (bb, cc) = (dot(&b, &b), dot(&c, &c));
    if cc <= SMALLEST_ANGLE * SMALLEST_ANGLE * bb {
        return Err(FitError::Undetermined { parameter: "dissipation" });
    }
    let modulus_dissipation = dot(&c, &f) / cc;
    Ok(Parameters { modulus: dot(&a, &f) / aa - share * modulus_dissipation, modulus_dissipation, onset })
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
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

    const MODEL: Model = Model { gain: 2.0, with_dissipation: true, with_onset: false };

    #[test]
    fn exact_data_give_exact_parameters() {
        let fitted = solve(&MODEL, &points(|x| 0.3 - 50.0 * x), 0.0).unwrap();
        assert!((fitted.modulus / 250.0 - 1.0).abs() < 1e-13);
        assert!((fitted.dissipation() / 0.4 - 1.0).abs() < 1e-12);
    }

    #[test]
    fn one_speed_does_not_tell_dissipation_from_stiffness() {
        let error = solve(&MODEL, &points(|_| 0.2), 0.0).unwrap_err();
        assert_eq!(error, FitError::Undetermined { parameter: "dissipation" });
        assert!(solve(&MODEL, &points(|_| 0.0), 0.0).is_err());
    }

    #[test]
    fn rows_before_contact_do_not_count() {
        let error = solve(&MODEL, &points(|x| x), 0.0075).unwrap_err();
        assert_eq!(error, FitError::TooFewPoints { found: 2, needed: 3 });
    }
}
