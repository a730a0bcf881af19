//! Numbers so large or small that what follows from them is not finite.

use osim_model::Fault;
use osim_motion::{ContactStates, Measured};

/// Nothing of a body is larger than this, in SI units: squares of what is larger, such as of errors, are not finite.
const LARGEST: f64 = 1e100;

/// # Errors
/// A sphere whose force, place or speed is beyond all measure, or a weight that is.
pub(super) fn refuse_states(states: &ContactStates, weight_n: f64) -> Result<(), Fault> {
    if !(1.0 / LARGEST..=LARGEST).contains(&weight_n) {
        return Err(Fault::refused(format!(
            "the body weight is {weight_n:e} N: forces cannot be compared with that, correct mass and gravity of the model"
        )));
    }
    for (index, pair) in states.pairs.iter().enumerate() {
        for (state, time_s) in states.pair(index).zip(&states.time_s) {
            let depth = state.indentation_m / pair.radius_m;
            let sum = |parts: [f64; 3]| parts.into_iter().fold(0.0, |sum: f64, part| sum + part.abs());
            let sizes = [
                ("a force of", sum(state.force_n), "N"),
                ("x/R of", depth, ""),
                ("a speed of", state.slip_speed_m_s(), "m/s"),
                ("a centre at", sum(state.centre_m), "m"),
            ];
            if let Some((what, value, unit)) = sizes.into_iter().find(|(_, value, _)| !is_measurable(*value))
            {
                let fault = format!(
                    "at {time_s} s a sphere of radius {:e} m has {what} {value:e} {unit}: correct what the model says of it",
                    pair.radius_m
                );
                return Err(Fault::refused(fault));
            }
        }
    }
    Ok(())
}

/// A force or a moment of the plates that is beyond all measure, if there is one, in words: of all plates, or of those of one foot.
pub(super) fn of_plates(measured: &Measured) -> Option<String> {
    let mut all = measured.total.iter().chain(measured.feet.iter().flatten()).flatten();
    all.find_map(|wrench| {
        let beyond = |values: [f64; 3]| values.into_iter().find(|value| !is_measurable(*value));
        let force = beyond(wrench.force_n).map(|force| format!("a force of {force:e} N"));
        force.or_else(|| Some(format!("a moment of {:e} N m about ground", beyond(wrench.moment_n_m)?)))
    })
}

fn is_measurable(value: f64) -> bool {
    value.abs() <= LARGEST
}
