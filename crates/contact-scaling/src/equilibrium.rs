//! Where a body rests on its spheres, by the Hertz law and by the law of the file.
//!
//! Spheres stand on one plane with their bottoms level, so that all have the same indentation x, whatever
//! their radii.

use crate::error::{DomainError, positive, within};
use crate::hertz::depth;
use crate::{Law, Spheres};

/// Indentation at rest by the Hertz law, x = (F / Σ 4/3 E*_i √R_i)^(2/3), in m.
///
/// Load F in N, above 0; E*_i in N/m² and R_i in m of each sphere. For a smoothed law it is where the law
/// would rest without its smoothing.
///
/// Source: (1) summed over the spheres, solved for x.
///
/// # Errors
/// [`DomainError`] unless F is finite and above 0 and there is a sphere.
///
/// ```
/// # use contact_scaling::{equilibrium, falisse2022, Law, Spheres};
/// let human = [Spheres::new(Law::of(&falisse2022().contact, 0.032)?, 6.0)?];
/// assert!((equilibrium::hertz_indentation(&human, 62.0 * 9.81)? / 0.032 - 0.3533).abs() < 5e-5);
/// # Ok::<(), contact_scaling::DomainError>(())
/// ```
pub fn hertz_indentation(spheres: &[Spheres], load_n: f64) -> Result<f64, DomainError> {
    let load = positive("load", load_n)?;
    let sum: f64 = spheres.iter().map(|s| s.count() * s.law().hertz().coefficient()).sum();
    Ok(depth(load, positive("sum of force coefficients", sum)?))
}

/// Indentation at rest by the laws themselves, Σ F_i(x, 0) = F, in m.
///
/// Load F in N, above 0. Where a smoothed law carries the load at several x, it is the first that a body
/// lowered onto its spheres meets, and below 0 when the spheres hold it above the ground.
///
/// Source: (C.9) at ẋ = 0 summed over the spheres, solved for x.
///
/// # Errors
/// [`DomainError`] unless F is finite and above 0, there is a sphere, and an indentation carries F.
///
/// ```
/// # use contact_scaling::{equilibrium, falisse2022, Law, Spheres};
/// let human = [Spheres::new(Law::of(&falisse2022().contact, 0.032)?, 6.0)?];
/// assert!((equilibrium::indentation(&human, 62.0 * 9.81)? / 0.032 - 0.3396).abs() < 5e-5);
/// # Ok::<(), contact_scaling::DomainError>(())
/// ```
pub fn indentation(spheres: &[Spheres], load_n: f64) -> Result<f64, DomainError> {
    let hertz = hertz_indentation(spheres, load_n)?;
    let Some(step) = smallest_transition(spheres) else { return Ok(hertz) };
    let force = |x: f64| spheres.iter().map(|s| s.count() * s.law().rest_force(x)).sum::<f64>();
    let carried = |x: f64| force(x) >= load_n;
    let (mut above, mut below) = (-20.0 * step, -20.0 * step);
    for _ in 0..60 {
        if !carried(above) {
            break;
        }
        above *= 2.0;
    }
    // Short steps through the onset, where the force can rise and fall; past x = 0 it only rises.
    let falls = |x: f64| spheres.iter().map(|s| s.count() * s.law().rest_stiffness(x)).sum::<f64>() < 0.0;
    while below <= 0.0 && !carried(below) {
        above = below;
        below += 0.05 * step;
        if !falls(above) && falls(below) {
            let top = bisect(above, below, falls);
            below = if carried(top) { top } else { below };
        }
    }
    let mut stride = hertz.max(step);
    while !carried(below) && below.is_finite() {
        above = below;
        below += stride;
        stride *= 2.0;
    }
    within(below.is_finite() && !carried(above), "load", load_n, "a load that the spheres can carry")?;
    Ok(bisect(above, below, carried))
}

/// The shortest 1/bd of the smoothed laws: the length over which the force can change.
fn smallest_transition(spheres: &[Spheres]) -> Option<f64> {
    spheres.iter().fold(None, |shortest: Option<f64>, spheres| match spheres.law() {
        Law::HuntCrossley(_) => shortest,
        Law::Smooth(law) => {
            let length = 1.0 / law.smoothing().hertz_smoothing;
            Some(shortest.map_or(length, |known| known.min(length)))
        }
    })
}

/// The point between `out` and `within` where `holds` begins, to the last bit.
fn bisect(mut out: f64, mut within: f64, holds: impl Fn(f64) -> bool) -> f64 {
    for _ in 0..200 {
        let middle = 0.5 * (out + within);
        if middle == out || middle == within {
            break;
        }
        if holds(middle) { within = middle } else { out = middle }
    }
    within
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Contact, ContactValues, SmoothingValues, falisse2022};
    use proptest::prelude::*;

    fn smooth(cf: f64, bd: f64, radius: f64, count: f64) -> Spheres {
        damped(cf, bd, radius, count, (2.0, 50.0))
    }

    fn damped(cf: f64, bd: f64, radius: f64, count: f64, (alpha, bv): (f64, f64)) -> Spheres {
        let smoothing =
            SmoothingValues { constant_contact_force: cf, hertz_smoothing: bd, hunt_crossley_smoothing: bv };
        let values = ContactValues {
            smoothing: Some(smoothing),
            dissipation: alpha,
            ..falisse2022().contact.values()
        };
        Spheres::new(Law::of(&Contact::new(values).unwrap(), radius).unwrap(), count).unwrap()
    }

    #[test]
    fn without_smoothing_both_are_the_same() {
        let values = ContactValues { smoothing: None, ..falisse2022().contact.values() };
        let law = Law::of(&Contact::new(values).unwrap(), 0.032).unwrap();
        let law = [Spheres::new(law, 3.0).unwrap()];
        assert_eq!(indentation(&law, 300.0), hertz_indentation(&law, 300.0));
        let sharp = [smooth(0.0, 1e9, 0.032, 3.0)];
        let ratio = indentation(&sharp, 300.0).unwrap() / hertz_indentation(&sharp, 300.0).unwrap();
        assert!((ratio - 1.0).abs() < 1e-14);
    }

    #[test]
    fn an_unscaled_mouse_floats() {
        // Section C.1: with the default cf the mouse rests above the ground.
        let mouse = [smooth(1e-5, 300.0, 0.002, 2.0)];
        let x = indentation(&mouse, 0.0209 * 9.81).unwrap();
        assert!(x < 0.0, "{x}");
    }

    #[test]
    fn a_body_rests_where_opensim_leaves_it() {
        // Drops in OpenSim 4.6, followed until they rest; Falisse's contact with this α and bv.
        const RESTS: [(f64, f64, f64); 4] = [
            (2.0, 50.0, 0.339_559_726),
            (20.0, 50.0, 0.348_203_091),
            (50.0, 50.0, 0.401_065_537),
            (50.0, 5.0, 0.528_091_387),
        ];
        for (alpha, bv, x_hat) in RESTS {
            let human = [damped(1e-5, 300.0, 0.032, 6.0, (alpha, bv))];
            let x = indentation(&human, 62.0 * 9.81).unwrap() / 0.032;
            assert!((x - x_hat).abs() < 1e-8, "{alpha} {bv}: {x} {x_hat}");
        }
    }

    #[test]
    fn of_several_rests_it_is_the_first_from_above() {
        // With next to no cf the smoothed force rises before contact and falls again towards it.
        let sphere = [smooth(1e-12, 300.0, 0.032, 1.0)];
        let force = |x: f64| sphere[0].law().force(x, 0.0);
        let points = (-20_000..0).map(|i| f64::from(i) * 1e-6);
        let (top, bump) =
            points.map(|x| (x, force(x))).fold((0.0, 0.0), |a, b| if b.1 > a.1 { b } else { a });
        assert!(top < -1e-3 && force(-1e-5) < 0.1 * bump);
        for share in [0.01, 0.5, 0.99, 0.9999] {
            let x = indentation(&sphere, share * bump).unwrap();
            assert!(x < top, "{share}: {x} {top}");
        }
        assert!(indentation(&sphere, 1.01 * bump).unwrap() > 0.0);
    }

    #[test]
    fn no_sphere_and_no_load_are_errors() {
        assert_eq!(hertz_indentation(&[], 1.0).unwrap_err().quantity(), "sum of force coefficients");
        assert_eq!(indentation(&[smooth(1e-5, 300.0, 0.03, 1.0)], 0.0).unwrap_err().quantity(), "load");
    }

    proptest! {
        #[test]
        fn the_load_is_carried_there(
            load in 1e-3..1e5, cf in 1e-9..1e-3, bd in 1.0..5e3, r1 in 1e-3..0.3, r2 in 1e-3..0.3,
            alpha in 0.0..100.0, bv in 0.1..500.0,
        ) {
            let spheres = [damped(cf, bd, r1, 1.0, (alpha, bv)), damped(cf * 2.0, bd / 3.0, r2, 2.5, (2.0, 50.0))];
            let x = indentation(&spheres, load).unwrap();
            let force: f64 = spheres.iter().map(|s| s.force(x, 0.0)).sum();
            prop_assert!((force / load - 1.0).abs() < 1e-10, "{x} {force} {load}");
            let slope: f64 = spheres.iter().map(|s| s.count() * s.law().rest_stiffness(x)).sum();
            prop_assert!(slope > 0.0);
        }
    }
}
