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
            let sizes = [
                ("a force of", state.normal_force_n, "N"),
                ("x/R of", depth, ""),
                ("a speed of", state.slip_speed_m_s(), "m/s"),
                ("a centre at", state.centre_m.into_iter().fold(0.0, |a: f64, b| a + b.abs()), "m"),
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

/// A force of the plates that is beyond all measure, if there is one, N.
pub(super) fn of_plates(measured: &Measured) -> Option<f64> {
    let forces = measured.total.iter().flatten().flat_map(|total| total.force_n);
    forces.into_iter().find(|force| !is_measurable(*force))
}

fn is_measurable(value: f64) -> bool {
    value.abs() <= LARGEST
}
