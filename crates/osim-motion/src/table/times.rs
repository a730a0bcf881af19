//! Times of rows.

use crate::fault::MotionFault;

/// Checks that times rise.
pub(super) fn rising(time_s: &[f64], lines: &[usize]) -> Result<(), MotionFault> {
    for (pair, lines) in time_s.windows(2).zip(lines.windows(2)) {
        let ([before, now], [_, line]) = (pair, lines) else { continue };
        // A time that is not a number does not rise, either.
        if now > before {
            continue;
        }
        return Err(MotionFault::at(
            *line,
            format!("its time is {now} s, after {before} s: times must rise"),
        ));
    }
    match time_s {
        [only] if !only.is_finite() => Err(MotionFault::new("its time is not a number")),
        _ => Ok(()),
    }
}
