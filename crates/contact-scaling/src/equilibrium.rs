//! The indentation at which spheres carry the body weight at speed 0, by the Hertz law and by the model's contact law.
//!
//! The spheres touch one plane. Either their bottoms are at one height, so that all have the same indentation x, whatever their
//! radii; or the bottoms are at different heights ([`RaisedSpheres`]).

use crate::error::{Result, require_positive, require_range};
use crate::hertz::depth;
use crate::{Law, Spheres};

/// Indentation at equilibrium by the Hertz law, x = (F / Σ 4/3 E*_i √R_i)^(2/3), in m.
///
/// Load F in N, above 0; E*_i in N/m² and R_i in m of each sphere. The smoothing of a smoothed law is left out.
///
/// Source: (1) summed over the spheres, solved for x.
///
/// # Errors
/// [`DomainError`](crate::DomainError) unless F is finite and above 0 and there is a sphere.
///
/// ```
/// # use contact_scaling::{Law, Spheres, equilibrium, falisse2022};
/// let human = [Spheres::new(Law::of(&falisse2022().contact, 0.032)?, 6.0)?];
/// assert!((equilibrium::hertz_indentation(&human, 62.0 * 9.81)? / 0.032 - 0.3533).abs() < 5e-5);
/// # Ok::<(), contact_scaling::DomainError>(())
/// ```
pub fn hertz_indentation(spheres: &[Spheres], load_n: f64) -> Result<f64> {
    let load = require_positive("load", load_n)?;
    let sum: f64 = spheres.iter().map(|s| s.count() * s.law().hertz().coefficient()).sum();
    Ok(depth(load, require_positive("sum of force coefficients", sum)?))
}

/// Indentation at equilibrium by the contact laws themselves, Σ F_i(x, 0) = F, in m.
///
/// Load F in N, above 0. If smoothed laws carry the load at several x, the result is the smallest of them: a body that is slowly
/// lowered comes to it first. It is below 0 if the spheres hold the body above the ground.
///
/// Source: (C.9) at ẋ = 0 summed over the spheres, solved for x.
///
/// # Errors
/// [`DomainError`](crate::DomainError) unless F is finite and above 0, there is a sphere, and an indentation carries F.
///
/// ```
/// # use contact_scaling::{Law, Spheres, equilibrium, falisse2022};
/// let human = [Spheres::new(Law::of(&falisse2022().contact, 0.032)?, 6.0)?];
/// assert!((equilibrium::indentation(&human, 62.0 * 9.81)? / 0.032 - 0.3396).abs() < 5e-5);
/// # Ok::<(), contact_scaling::DomainError>(())
/// ```
pub fn indentation(spheres: &[Spheres], load_n: f64) -> Result<f64> {
    let hertz = hertz_indentation(spheres, load_n)?;
    let level: Vec<RaisedSpheres> =
        spheres.iter().map(|&spheres| RaisedSpheres { spheres, height_m: 0.0 }).collect();
    first_equilibrium(&level, load_n, hertz)
}

/// Indentation x of the lowest sphere at equilibrium by the Hertz law, Σ 4/3 E*_i √R_i max(0, x − h_i)^(3/2) = F, in m.
///
/// Load F in N, above 0; height h_i in m. The indentation of sphere i is x − h_i; if it is below 0, the sphere does not touch.
///
/// Source: (1) summed over the spheres, each at its own height, solved for x.
///
/// # Errors
/// [`DomainError`](crate::DomainError) unless F is finite and above 0 and there is a sphere.
///
/// ```
/// # use contact_scaling::{Law, Spheres, falisse2022};
/// # use contact_scaling::equilibrium::{RaisedSpheres, self};
/// // Falisse's six spheres, two of them 2 mm lower than the others.
/// let law = Law::of(&falisse2022().contact, 0.032)?;
/// let foot = [RaisedSpheres::new(Spheres::new(law, 2.0)?, 0.0)?, RaisedSpheres::new(Spheres::new(law, 4.0)?, 0.002)?];
/// let x = equilibrium::hertz_indentation_of_lowest(&foot, 62.0 * 9.81)?;
/// // The low ones are deeper than the 0.3533 R of a level foot, the others 2 mm less deep.
/// let force = |x: f64, count: f64| count * 4.0 / 3.0 * 353553.39 * 0.032_f64.sqrt() * x.powf(1.5);
/// assert!((force(x, 2.0) + force(x - 0.002, 4.0) - 62.0 * 9.81).abs() < 1e-4);
/// # Ok::<(), contact_scaling::DomainError>(())
/// ```
pub fn hertz_indentation_of_lowest(spheres: &[RaisedSpheres], load_n: f64) -> Result<f64> {
    let load = require_positive("load", load_n)?;
    // As deep as if all were as high as the highest.
    let sum: f64 = spheres.iter().map(|s| s.spheres.count() * s.spheres.law().hertz().coefficient()).sum();
    let highest_m = spheres.iter().map(|s| s.height_m).fold(0.0, f64::max);
    let deepest = highest_m + depth(load, require_positive("sum of force coefficients", sum)?);
    require_range(deepest.is_finite(), "load", load_n, "a load that the spheres can carry")?;
    let summed = |x: f64, force_shape: fn(f64) -> f64| -> f64 {
        let one = |s: &RaisedSpheres| {
            s.spheres.count() * s.spheres.law().hertz().coefficient() * force_shape((x - s.height_m).max(0.0))
        };
        spheres.iter().map(one).sum()
    };
    // For a guess, which needs no last bit, a root is quicker than a power. From the deep side Newton's steps stay there: the force
    // rises ever more.
    let guess =
        newton_root(deepest, |x| summed(x, |x| x * x.sqrt()) - load, |x| summed(x, |x| 1.5 * x.sqrt()));
    Ok(bisect_near(guess, 0.0, deepest, |x| summed(x, |x| x.powf(1.5)) >= load))
}

/// Indentation x of the lowest sphere at equilibrium by the contact laws themselves, Σ F_i(x − h_i, 0) = F, in m.
///
/// Load F in N, above 0; height h_i in m. If the laws carry the load at several x, the result is the smallest of them: a body
/// that is slowly lowered comes to it first. It is below 0 if the spheres hold the body above the ground.
///
/// Source: (C.9) at ẋ = 0 summed over the spheres, each at its own height, solved for x.
///
/// # Errors
/// [`DomainError`](crate::DomainError) unless F is finite and above 0, there is a sphere, and an indentation carries F.
///
/// ```
/// # use contact_scaling::{Law, Spheres, falisse2022};
/// # use contact_scaling::equilibrium::{RaisedSpheres, self};
/// let law = Law::of(&falisse2022().contact, 0.032)?;
/// // All at one height is a level foot.
/// let level = [RaisedSpheres::new(Spheres::new(law, 6.0)?, 0.0)?];
/// assert!((equilibrium::indentation_of_lowest(&level, 62.0 * 9.81)? / 0.032 - 0.3396).abs() < 5e-5);
/// # Ok::<(), contact_scaling::DomainError>(())
/// ```
pub fn indentation_of_lowest(spheres: &[RaisedSpheres], load_n: f64) -> Result<f64> {
    first_equilibrium(spheres, load_n, hertz_indentation_of_lowest(spheres, load_n)?)
}

// The first rest of a body that is lowered onto spheres, level or at several heights.

/// Spheres whose bottoms are higher than the lowest sphere of the limb.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct RaisedSpheres {
    /// The spheres whose lowest points are at this height.
    pub spheres: Spheres,
    /// Height of their bottoms above the bottom of the lowest sphere, m.
    pub height_m: f64,
}

impl RaisedSpheres {
    /// `spheres` with their bottoms `height_m` (m) above the bottom of the lowest sphere.
    ///
    /// # Errors
    /// [`DomainError`](crate::DomainError) unless the height is finite and not below 0.
    pub fn new(spheres: Spheres, height_m: f64) -> Result<Self> {
        require_range(height_m.is_finite() && height_m >= 0.0, "height", height_m, "finite and not below 0")?;
        Ok(Self { spheres, height_m })
    }
}

/// The smallest indentation (m) at which the spheres carry the load at speed 0. `hertz` is the indentation by the Hertz law, m.
fn first_equilibrium(spheres: &[RaisedSpheres], load_n: f64, hertz: f64) -> Result<f64> {
    let Some(step) = smallest_transition(spheres) else { return Ok(hertz) };
    let mut in_reach: Vec<(f64, &RaisedSpheres)> = spheres.iter().map(|s| (force_free_depth(s), s)).collect();
    in_reach.sort_by(|a, b| a.0.total_cmp(&b.0));
    // Those above carry nothing, to the last bit.
    let near = |x: f64| in_reach.iter().take_while(move |(from, _)| *from <= x).map(|(_, s)| *s);
    let sum = |of: &dyn Fn(&Law, f64) -> f64, x: f64| -> f64 {
        near(x).map(|s| s.spheres.count() * of(s.spheres.law(), x - s.height_m)).sum()
    };
    let carried = |x: f64| sum(&|law, x| law.rest_force(x), x) >= load_n;
    let falls = |x: f64| sum(&|law, x| law.rest_stiffness(x), x) < 0.0;
    let (mut above, mut below) = (-20.0 * step, -20.0 * step);
    for _ in 0..60 {
        if !carried(above) {
            break;
        }
        above *= 2.0;
    }
    let never_carried = |from: f64, to: f64| {
        let most = |s: &RaisedSpheres| {
            s.spheres.count() * s.spheres.law().rest_force_limit(from - s.height_m, to - s.height_m)
        };
        near(to).map(most).sum::<f64>() * (1.0 + 1e-9) < load_n
    };
    // The heights at which spheres begin to touch, each once, from the lowest to the highest.
    let mut onsets: Vec<f64> = spheres.iter().map(|s| s.height_m).collect();
    onsets.sort_by(f64::total_cmp);
    onsets.dedup();
    // How many steps in which nothing can carry the load are taken at once: fewer the nearer the load is.
    let mut steps_at_once;
    // Short steps through the onset of each sphere, where its force can rise and fall; elsewhere forces only rise.
    for onset in onsets {
        below = below.max(onset - 20.0 * step);
        steps_at_once = 20;
        // A transition shorter than a number can say at this height is none.
        while below <= onset && below < below + 0.05 * step {
            if never_carried(below, below + 1.001 * 0.05 * f64::from(steps_at_once) * step) {
                // These steps one by one, so that rounding is as with the check of each.
                for _ in 0..steps_at_once {
                    if below <= onset {
                        above = below;
                        below += 0.05 * step;
                    }
                }
                continue;
            }
            if steps_at_once > 1 {
                steps_at_once = if steps_at_once > 5 { 5 } else { 1 };
                continue;
            }
            if carried(below) {
                break;
            }
            above = below;
            below += 0.05 * step;
            // Where it begins to fall within a step, its top is there.
            if falls(below) && !falls(above) {
                let top = bisect(above, below, falls);
                below = if carried(top) { top } else { below };
            }
        }
        if carried(below) {
            break;
        }
    }
    let mut stride = hertz.max(step);
    while !carried(below) && below.is_finite() {
        above = below;
        below += stride;
        stride *= 2.0;
    }
    require_range(below.is_finite() && !carried(above), "load", load_n, "a load that the spheres can carry")?;
    let guess = newton_root(
        hertz.max(above).min(below),
        |x| sum(&|law, x| law.rest_force(x), x) - load_n,
        |x| sum(&|law, x| law.rest_stiffness(x), x),
    );
    // A body that floats is carried by a small difference of large numbers, which rounds so coarsely that bisections on other ways end
    // elsewhere.
    let guess = if guess > 0.0 { guess } else { f64::NAN };
    Ok(bisect_near(guess, above, below, carried))
}

/// A root of `value` by Newton's method from `start`. The result is only a guess, because the steps may not converge.
fn newton_root(start: f64, value: impl Fn(f64) -> f64, slope: impl Fn(f64) -> f64) -> f64 {
    // Each step doubles the digits that are right.
    const MOST_NEWTON_STEPS: usize = 8;
    let mut x = start;
    for _ in 0..MOST_NEWTON_STEPS {
        let next = x - value(x) / slope(x);
        let is_there = (next - x).abs() <= 1e-14 * next.abs();
        x = next;
        if is_there || !x.is_finite() {
            break;
        }
    }
    x
}

/// The indentation (m) of the lowest sphere up to which the force of `sphere` is 0. A smoothed force is 0 in all digits at 20/bd
/// before contact.
fn force_free_depth(sphere: &RaisedSpheres) -> f64 {
    match sphere.spheres.law() {
        Law::HuntCrossley(_) => sphere.height_m,
        Law::Smooth(law) => sphere.height_m - 20.0 / law.smoothing().hertz_smoothing,
    }
}

/// The smallest 1/bd of the smoothed laws, in m: over this length the force can change; `None` without smoothed laws.
fn smallest_transition(spheres: &[RaisedSpheres]) -> Option<f64> {
    let length = |raised: &RaisedSpheres| match raised.spheres.law() {
        Law::HuntCrossley(_) => None,
        Law::Smooth(law) => Some(1.0 / law.smoothing().hertz_smoothing),
    };
    spheres.iter().filter_map(length).reduce(f64::min)
}

/// The same result as [`bisect`] to the last bit, but in less time if `guess` is close to it.
///
/// If `holds` is false a little before `guess` and true a little after it, it is not evaluated farther away, where most points of
/// [`bisect`] are. A bad guess costs two evaluations; the guess NaN costs none.
fn bisect_near(guess: f64, out: f64, within: f64, holds: impl Fn(f64) -> bool) -> f64 {
    // Far more than rounding moves the point, and far less than a guess is to be wrong.
    const ROOT_TOLERANCE: f64 = 1e-12;
    let near = ROOT_TOLERANCE * guess.abs().max(within - out);
    let (before, after) = (guess - near, guess + near);
    let is_close =
        guess.is_finite() && (before <= out || !holds(before)) && (within <= after || holds(after));
    bisect(out, within, |x| {
        if is_close && x <= before {
            false
        } else if is_close && x >= after {
            true
        } else {
            holds(x)
        }
    })
}

/// The point between `out` and `within` from which `holds` is true, to the last bit.
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
    use proptest::prelude::*;

    use super::*;
    use crate::{Contact, ContactValues, Law, SmoothingValues, falisse2022};

    fn smooth_spheres(cf: f64, bd: f64, radius: f64, count: f64) -> Spheres {
        damped_spheres(cf, bd, radius, count, (2.0, 50.0))
    }

    fn damped_spheres(cf: f64, bd: f64, radius: f64, count: f64, (alpha, bv): (f64, f64)) -> Spheres {
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
    fn without_smoothing_the_equilibrium_is_that_of_the_hertz_law() {
        let values = ContactValues { smoothing: None, ..falisse2022().contact.values() };
        let law = Law::of(&Contact::new(values).unwrap(), 0.032).unwrap();
        let law = [Spheres::new(law, 3.0).unwrap()];
        assert_eq!(indentation(&law, 300.0), hertz_indentation(&law, 300.0));
        let sharp = [smooth_spheres(0.0, 1e9, 0.032, 3.0)];
        let ratio = indentation(&sharp, 300.0).unwrap() / hertz_indentation(&sharp, 300.0).unwrap();
        assert!((ratio - 1.0).abs() < 1e-14);
    }

    #[test]
    fn unscaled_contacts_hold_a_mouse_above_the_floor() {
        // Section C.1: with the default cf the mouse rests above the ground.
        let mouse = [smooth_spheres(1e-5, 300.0, 0.002, 2.0)];
        let x = indentation(&mouse, 0.0209 * 9.81).unwrap();
        assert!(x < 0.0, "{x}");
    }

    #[test]
    fn the_equilibrium_is_that_of_drops_in_opensim() {
        // Drops in OpenSim 4.6, followed until they rest; Falisse's contact with this α and bv.
        const RESTS: [(f64, f64, f64); 4] = [
            (2.0, 50.0, 0.339_559_726),
            (20.0, 50.0, 0.348_203_091),
            (50.0, 50.0, 0.401_065_537),
            (50.0, 5.0, 0.528_091_387),
        ];
        for (alpha, bv, x_hat) in RESTS {
            let human = [damped_spheres(1e-5, 300.0, 0.032, 6.0, (alpha, bv))];
            let x = indentation(&human, 62.0 * 9.81).unwrap() / 0.032;
            assert!((x - x_hat).abs() < 1e-8, "{alpha} {bv}: {x} {x_hat}");
        }
    }

    #[test]
    fn the_smallest_indentation_that_carries_the_load_is_found() {
        // With next to no cf the smoothed force rises before contact and falls again towards it.
        let sphere = [smooth_spheres(1e-12, 300.0, 0.032, 1.0)];
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
        assert_eq!(
            indentation(&[smooth_spheres(1e-5, 300.0, 0.03, 1.0)], 0.0).unwrap_err().quantity(),
            "load"
        );
    }

    proptest! {
        #[test]
        fn the_load_is_carried_at_the_indentation_of_equilibrium(
            load in 1e-3..1e5, cf in 1e-9..1e-3, bd in 1.0..5e3, r1 in 1e-3..0.3, r2 in 1e-3..0.3,
            alpha in 0.0..100.0, bv in 0.1..500.0,
        ) {
            let spheres = [damped_spheres(cf, bd, r1, 1.0, (alpha, bv)), damped_spheres(cf * 2.0, bd / 3.0, r2, 2.5, (2.0, 50.0))];
            let x = indentation(&spheres, load).unwrap();
            let force: f64 = spheres.iter().map(|s| s.force(x, 0.0)).sum();
            prop_assert!((force / load - 1.0).abs() < 1e-10, "{x} {force} {load}");
            let slope: f64 = spheres.iter().map(|s| s.count() * s.law().rest_stiffness(x)).sum();
            prop_assert!(slope > 0.0);
        }
    }

    fn spheres_with_smoothing(smoothing: Option<SmoothingValues>, radius: f64) -> Spheres {
        let values = ContactValues { smoothing, ..falisse2022().contact.values() };
        Spheres::new(Law::of(&Contact::new(values).unwrap(), radius).unwrap(), 1.0).unwrap()
    }

    fn smoothing(cf: f64, bd: f64) -> Option<SmoothingValues> {
        let smoothing = SmoothingValues {
            constant_contact_force: cf,
            hertz_smoothing: bd,
            hunt_crossley_smoothing: 50.0,
        };
        Some(smoothing)
    }

    #[test]
    fn a_sphere_far_above_the_ground_has_no_force() {
        let low = spheres_with_smoothing(None, 0.03);
        let alone = hertz_indentation(&[low], 500.0).unwrap();
        let both = [
            RaisedSpheres::new(low, 0.0).unwrap(),
            RaisedSpheres::new(spheres_with_smoothing(None, 0.05), 2.0 * alone).unwrap(),
        ];
        let x = hertz_indentation_of_lowest(&both, 500.0).unwrap();
        assert!((x / alone - 1.0).abs() < 1e-14, "{x} {alone}");
    }

    #[test]
    fn heights_and_loads_out_of_their_domains_are_refused() {
        assert_eq!(
            RaisedSpheres::new(spheres_with_smoothing(None, 0.03), -1e-3).unwrap_err().quantity(),
            "height"
        );
        assert_eq!(
            hertz_indentation_of_lowest(&[], 1.0).unwrap_err().quantity(),
            "sum of force coefficients"
        );
    }

    #[test]
    fn a_transition_of_nearly_no_length_is_searched_in_finite_time() {
        let foot = [
            RaisedSpheres::new(spheres_with_smoothing(smoothing(1e-5, 1e18), 0.03), 0.0),
            RaisedSpheres::new(spheres_with_smoothing(smoothing(1e-5, 1e18), 0.03), 0.5),
        ];
        let foot = foot.map(Result::unwrap);
        let x = indentation_of_lowest(&foot, 500.0).unwrap();
        assert!((x / hertz_indentation_of_lowest(&foot, 500.0).unwrap() - 1.0).abs() < 0.1, "{x}");
    }

    proptest! {
        /// The forces are summed here without the tested functions, each at the indentation of its own sphere.
        #[test]
        fn the_load_is_carried_at_several_heights(
            load in 1.0..1e4, cf in 1e-9..1e-4, bd in 50.0..5e3, height in 0.0..0.05, r1 in 1e-2..0.1, r2 in 1e-2..0.1,
        ) {
            let (low, high) = (spheres_with_smoothing(smoothing(cf, bd), r1), spheres_with_smoothing(smoothing(cf, bd / 2.0), r2));
            let foot = [RaisedSpheres::new(high, height).unwrap(), RaisedSpheres::new(low, 0.0).unwrap()];
            let x = indentation_of_lowest(&foot, load).unwrap();
            let force = low.law().rest_force(x) + high.law().rest_force(x - height);
            prop_assert!((force / load - 1.0).abs() < 1e-9, "{x} {force} {load}");
        }
    }
}
