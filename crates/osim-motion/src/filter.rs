//! The low-pass filter of movement analysis.

use butterworth::{Cutoff, Filter};

use crate::fault::MotionFault;
use crate::table::Table;

/// Forward and back again, so that nothing is delayed: an order of 2 becomes one of 4.
const ORDER: usize = 2;

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
            "it has {} rows a second: a cutoff is above 0 and below half of that, {} Hz, and not {cutoff_hz} Hz",
            three_decimals(rate_hz),
            three_decimals(rate_hz / 2.0)
        )));
    }
    let filter = Filter::new(ORDER, rate_hz, Cutoff::LowPass(cutoff_hz));
    let filtered = filter.and_then(|filter| filter.bidirectional(&values.to_vec()));
    filtered.map_err(|_| MotionFault::new(format!("its {} rows are too few for a filter", values.len())))
}

/// For sentences: the times of a file are rounded, too.
fn three_decimals(value: f64) -> f64 {
    (value * 1e3).round() / 1e3
}
