//! The ratio of gravities, where contacts are scaled to another one.

use osim_model::wording::Input;
use osim_model::{Fault, FaultKind, Needed};

/// γ = g_b/g_a where a target is given, else 1.
pub(crate) fn gravity_ratio(now: Option<f64>, target: Option<f64>) -> Result<f64, Fault> {
    let Some(target) = target else { return Ok(1.0) };
    if !(target.is_finite() && target > 0.0) {
        return Err(Fault::new(FaultKind::BadInput {
            input: Input::TargetGravity,
            value: target,
            expected: "an acceleration in m/s2 above 0",
        }));
    }
    match now {
        Some(now) if now.is_finite() && now > 0.0 => Ok(target / now),
        _ => Err(Fault::new(Needed::GravityNow)),
    }
}
