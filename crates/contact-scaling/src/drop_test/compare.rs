//! Two drops side by side, in dimensionless form.

use super::error::DropError;
use super::falling::DropTest;
use super::report::DropReport;
use super::values::DropValues;

/// How far two drops lie apart, each in its own dimensionless form.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Difference {
    /// Largest difference of height / R.
    pub height: f64,
    /// Largest difference of force / (M g).
    pub force: f64,
    /// The dimensionless time t / √(R/g) to which both were followed.
    pub until: f64,
}

/// The largest differences of two drops at equal dimensionless times, up to the end of the shorter one.
///
/// Both are run again on common dimensionless times, with the larger number of samples.
///
/// # Errors
/// As [`DropTest::run`].
pub fn compare(a: &DropTest, b: &DropTest) -> Result<Difference, DropError> {
    let until = dimensionless_duration(a).min(dimensionless_duration(b));
    let samples = a.values().samples.max(b.values().samples);
    let (a, b) = (run_until(a, until, samples)?, run_until(b, until, samples)?);
    let mut difference = Difference { height: 0.0, force: 0.0, until };
    for (p, q) in a.series.iter().zip(&b.series) {
        let height = p.height_m / a.reference_radius_m - q.height_m / b.reference_radius_m;
        let force = p.force_n / a.body_weight_n - q.force_n / b.body_weight_n;
        difference.height = difference.height.max(height.abs());
        difference.force = difference.force.max(force.abs());
    }
    Ok(difference)
}

fn dimensionless_duration(test: &DropTest) -> f64 {
    test.values().duration_s / test.body().time_s
}

fn run_until(test: &DropTest, until: f64, samples: usize) -> Result<DropReport, DropError> {
    let duration_s = until * test.body().time_s;
    let values = DropValues { duration_s, samples, ..test.values() };
    test.under(values).run()
}
