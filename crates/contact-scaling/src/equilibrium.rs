//! Where a body rests on its spheres, by the Hertz law and by the law of the file.
//!
//! Spheres stand on one plane: with their bottoms level, so that all have the same indentation x, whatever their radii; or each at
//! its own height ([`Raised`]).

use crate::Spheres;
use crate::error::{DomainError, positive, within};
use crate::hertz::depth;
use crate::rest::{bisect_near, first_rest, refined};

pub use crate::rest::Raised;

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
/// # use contact_scaling::{Law, Spheres, equilibrium, falisse2022};
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
/// # use contact_scaling::{Law, Spheres, equilibrium, falisse2022};
/// let human = [Spheres::new(Law::of(&falisse2022().contact, 0.032)?, 6.0)?];
/// assert!((equilibrium::indentation(&human, 62.0 * 9.81)? / 0.032 - 0.3396).abs() < 5e-5);
/// # Ok::<(), contact_scaling::DomainError>(())
/// ```
pub fn indentation(spheres: &[Spheres], load_n: f64) -> Result<f64, DomainError> {
    let hertz = hertz_indentation(spheres, load_n)?;
    let level: Vec<Raised> = spheres.iter().map(|&spheres| Raised { spheres, height_m: 0.0 }).collect();
    first_rest(&level, load_n, hertz)
}

/// Indentation x of the lowest sphere at rest by the Hertz law, Σ 4/3 E*_i √R_i max(0, x − h_i)^(3/2) = F, in m.
///
/// Load F in N, above 0; h_i in m. The indentation of another sphere is x − h_i; below 0 it does not touch.
///
/// Source: (1) summed over the spheres, each at its own height, solved for x.
///
/// # Errors
/// [`DomainError`] unless F is finite and above 0 and there is a sphere.
///
/// ```
/// # use contact_scaling::{Law, Spheres, falisse2022};
/// # use contact_scaling::equilibrium::{Raised, self};
/// // Falisse's six spheres, two of them 2 mm lower than the others.
/// let law = Law::of(&falisse2022().contact, 0.032)?;
/// let foot = [Raised::new(Spheres::new(law, 2.0)?, 0.0)?, Raised::new(Spheres::new(law, 4.0)?, 0.002)?];
/// let x = equilibrium::hertz_indentation_of_lowest(&foot, 62.0 * 9.81)?;
/// // The low ones are deeper than the 0.3533 R of a level foot, the others 2 mm less deep.
/// let force = |x: f64, count: f64| count * 4.0 / 3.0 * 353553.39 * 0.032_f64.sqrt() * x.powf(1.5);
/// assert!((force(x, 2.0) + force(x - 0.002, 4.0) - 62.0 * 9.81).abs() < 1e-4);
/// # Ok::<(), contact_scaling::DomainError>(())
/// ```
pub fn hertz_indentation_of_lowest(spheres: &[Raised], load_n: f64) -> Result<f64, DomainError> {
    let load = positive("load", load_n)?;
    let force = |x: f64| -> f64 {
        let one = |s: &Raised| {
            s.spheres.count() * s.spheres.law().hertz().coefficient() * (x - s.height_m).max(0.0).powf(1.5)
        };
        spheres.iter().map(one).sum()
    };
    // As deep as if all were as high as the highest.
    let sum: f64 = spheres.iter().map(|s| s.spheres.count() * s.spheres.law().hertz().coefficient()).sum();
    let deepest = highest(spheres) + depth(load, positive("sum of force coefficients", sum)?);
    within(deepest.is_finite(), "load", load_n, "a load that the spheres can carry")?;
    // For a guess, which needs no last bit, a root is quicker than a power. From the deep side Newton's steps stay there: the force
    // rises ever more.
    let power = |x: f64, of: fn(f64) -> f64| -> f64 {
        let one = |s: &Raised| {
            s.spheres.count() * s.spheres.law().hertz().coefficient() * of((x - s.height_m).max(0.0))
        };
        spheres.iter().map(one).sum()
    };
    let guess = refined(deepest, |x| power(x, |x| x * x.sqrt()) - load, |x| power(x, |x| 1.5 * x.sqrt()));
    Ok(bisect_near(guess, 0.0, deepest, |x| force(x) >= load))
}

/// Indentation x of the lowest sphere at rest by the laws themselves, Σ F_i(x − h_i, 0) = F, in m.
///
/// Load F in N, above 0. Where the laws carry the load at several x, it is the first that a body lowered onto its spheres meets,
/// and below 0 where they hold it above the ground.
///
/// Source: (C.9) at ẋ = 0 summed over the spheres, each at its own height, solved for x.
///
/// # Errors
/// [`DomainError`] unless F is finite and above 0, there is a sphere, and an indentation carries F.
///
/// ```
/// # use contact_scaling::{Law, Spheres, falisse2022};
/// # use contact_scaling::equilibrium::{Raised, self};
/// let law = Law::of(&falisse2022().contact, 0.032)?;
/// // All at one height is a level foot.
/// let level = [Raised::new(Spheres::new(law, 6.0)?, 0.0)?];
/// assert!((equilibrium::indentation_of_lowest(&level, 62.0 * 9.81)? / 0.032 - 0.3396).abs() < 5e-5);
/// # Ok::<(), contact_scaling::DomainError>(())
/// ```
pub fn indentation_of_lowest(spheres: &[Raised], load_n: f64) -> Result<f64, DomainError> {
    first_rest(spheres, load_n, hertz_indentation_of_lowest(spheres, load_n)?)
}

fn highest(spheres: &[Raised]) -> f64 {
    spheres.iter().map(|s| s.height_m).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Contact, ContactValues, Law, SmoothingValues, falisse2022};
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
