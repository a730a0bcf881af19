//! The low-pass filter of movement analysis.

use butterworth::{Cutoff, Filter};

use crate::fault::MotionFault;
use crate::table::Table;

/// Forward and back again, so that nothing is delayed: an order of 2 becomes one of 4.
const ORDER: usize = 2;
/// At both ends, so many rows are mirrored; there must be one more.
const MIRRORED: usize = 3 * ORDER;

/// `values` of the rows of `table` through a zero-lag Butterworth low-pass filter of 4th order.
///
/// # Errors
/// Rows that are not equally far apart, or a cutoff that they are too far apart (or too few) for.
pub(crate) fn low_pass(table: &Table, values: &[f64], cutoff_hz: f64) -> Result<Vec<f64>, MotionFault> {
    let Some(step_s) = table.even_step_s() else {
        return Err(MotionFault::new("its times are not equally far apart: a filter needs rows that are"));
    };
    let rate_hz = 1.0 / step_s;
    if !(cutoff_hz > 0.0 && cutoff_hz < rate_hz / 2.0) {
        return Err(MotionFault::new(format!(
            "it has {} rows a second: a cutoff is above 0 and below half of that, {} Hz, and not {} Hz",
            three_decimals(rate_hz),
            three_decimals(rate_hz / 2.0),
            short(cutoff_hz)
        )));
    }
    let too_few = || MotionFault::new(format!("its {} rows are too few for a filter", values.len()));
    if values.len() <= MIRRORED {
        return Err(too_few());
    }
    let filter = Filter::new(ORDER, rate_hz, Cutoff::LowPass(cutoff_hz));
    let filtered = filter.and_then(|filter| filter.bidirectional(&values.to_vec()));
    let filtered = filtered.map_err(|_| too_few())?;
    if !filtered.iter().all(|value| value.is_finite()) {
        return Err(MotionFault::new(format!(
            "a cutoff of {} Hz is too low for its {} rows",
            short(cutoff_hz),
            values.len()
        )));
    }
    Ok(filtered)
}

/// Without hundreds of digits.
fn short(value: f64) -> String {
    if (1e-6..1e9).contains(&value) { value.to_string() } else { format!("{value:e}") }
}

/// For sentences: the times of a file are rounded, too.
fn three_decimals(value: f64) -> f64 {
    (value * 1e3).round() / 1e3
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::table::AngleUnit;

    fn table(rows: usize) -> Table {
        let times = (0..rows).map(|row| row as f64 / 100.0).collect();
        Table::of_columns(times, Vec::new(), AngleUnit::Radians).unwrap()
    }

    /// A cosine of 2 Hz passes a cutoff of 6 Hz, and one of 30 Hz does not.
    #[test]
    fn slow_movement_passes_and_fast_does_not() {
        let wave = |hertz: f64| -> Vec<f64> {
            (0..200).map(|row| (std::f64::consts::TAU * hertz * f64::from(row) / 100.0).cos()).collect()
        };
        let (slow, fast) = (
            low_pass(&table(200), &wave(2.0), 6.0).unwrap(),
            low_pass(&table(200), &wave(30.0), 6.0).unwrap(),
        );
        // Twice through |H|² = 1/(1 + (tan(π f/fs)/tan(π fc/fs))⁴), nothing delayed.
        let gain = |hertz: f64| {
            let tangent = |f: f64| (std::f64::consts::PI * f / 100.0).tan();
            1.0 / (1.0 + (tangent(hertz) / tangent(6.0)).powi(4))
        };
        assert!((slow[100] - gain(2.0) * wave(2.0)[100]).abs() < 1e-6, "{}", slow[100]);
        assert!((fast[100] - gain(30.0) * wave(30.0)[100]).abs() < 1e-6, "{}", fast[100]);
    }

    #[test]
    fn rows_must_be_even_and_enough() {
        assert!(low_pass(&table(6), &[0.0; 6], 6.0).is_err());
        assert!(low_pass(&table(7), &[0.0; 7], 6.0).is_ok());
        assert!(low_pass(&table(20), &[0.0; 20], 50.0).is_err());
        let uneven = Table::of_columns(vec![0.0, 0.1, 0.3], Vec::new(), AngleUnit::Radians).unwrap();
        assert!(low_pass(&uneven, &[0.0; 3], 1.0).is_err());
    }
}
