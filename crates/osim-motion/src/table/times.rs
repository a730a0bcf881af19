//! Times of rows.

use crate::fault::MotionFault;

/// Checks that times are finite and rise.
pub(super) fn rising(time_s: &[f64], lines: &[usize]) -> Result<(), MotionFault> {
    if let Some((time, line)) = time_s.iter().zip(lines).find(|(time, _)| !time.is_finite()) {
        return Err(MotionFault::at(*line, format!("its time is {time}, expected a finite number")));
    }
    for (pair, lines) in time_s.windows(2).zip(lines.windows(2)) {
        let ([before, now], [_, line]) = (pair, lines) else { continue };
        if now > before {
            continue;
        }
        return Err(MotionFault::at(
            *line,
            format!("its time is {now} s, after {before} s: times must rise"),
        ));
    }
    Ok(())
}
