//! Which half-space is the floor, and how a new one is turned.

use osim_model::{Fault, HalfSpace, Model};

/// The floor of `model`: the one half-space on ground that faces straight up; `None` where there is none.
///
/// # Errors
/// Several could be it: their names.
pub(super) fn floor(model: &Model) -> Result<Option<HalfSpace>, Fault> {
    let mut floors = model.floors().into_iter();
    let Some(first) = floors.next() else { return Ok(None) };
    let others: Vec<String> = floors.map(|plane| plane.name).collect();
    if others.is_empty() {
        return Ok(model.half_spaces().into_iter().find(|plane| plane.name == first.name));
    }
    Err(Fault::refused(format!(
        "{} and {} both could be the floor (on ground, facing up): remove or turn all but one in OpenSim, then do this again",
        first.name,
        others.join(", ")
    )))
}

/// The `orientation` of a half-space whose surface faces `up` (of length 1): a turn about y, then one about z. Its solid side is
/// the +x of its own frame, and R x̂ = (cos β cos γ, sin γ, −sin β cos γ) is to be −`up`.
pub(super) fn facing([x, y, z]: [f64; 3]) -> [f64; 3] {
    let level = libm::sqrt(x * x + z * z);
    let about_y = if level > 0.0 { libm::atan2(z, -x) } else { 0.0 };
    // A minus before a zero would only raise questions.
    [0.0, about_y + 0.0, libm::atan2(-y, level) + 0.0]
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{FRAC_PI_2, PI};

    use osim_model::Rotation;

    use super::*;

    #[test]
    fn the_solid_side_is_below() {
        assert_eq!(facing([0.0, 1.0, 0.0]), [0.0, 0.0, -FRAC_PI_2]);
        assert_eq!(facing([-0.0, 1.0, -0.0]), [0.0, 0.0, -FRAC_PI_2]);
        assert_eq!(facing([0.0, 0.0, 1.0]), [0.0, FRAC_PI_2, 0.0]);
        assert_eq!(facing([1.0, 0.0, 0.0]), [0.0, PI, 0.0]);
        // 2/7, 3/7 and 6/7 make a vector of length 1.
        for up in [[2.0, 3.0, 6.0], [-6.0, 2.0, 3.0], [-3.0, -6.0, -2.0], [0.0, -7.0, 0.0]] {
            let up = up.map(|value: f64| value / 7.0);
            let solid = Rotation::body_fixed_xyz(facing(up)).to_body([1.0, 0.0, 0.0]);
            for (solid, up) in solid.into_iter().zip(up) {
                assert!((solid + up).abs() < 1e-15, "{up:?}: {solid:?}");
            }
        }
    }
}
