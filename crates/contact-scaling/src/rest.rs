//! The first rest of a body that is lowered onto spheres, level or at several heights.

use crate::error::{DomainError, within};
use crate::{Law, Spheres};

/// Spheres whose bottoms are above the lowest of the limb.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Raised {
    /// The spheres.
    pub spheres: Spheres,
    /// How much higher their bottoms are than the lowest, m.
    pub height_m: f64,
}

impl Raised {
    /// Spheres at a height.
    ///
    /// # Errors
    /// [`DomainError`] unless the height is finite and not below 0.
    pub fn new(spheres: Spheres, height_m: f64) -> Result<Self, DomainError> {
        within(height_m.is_finite() && height_m >= 0.0, "height", height_m, "finite and not below 0")?;
        Ok(Self { spheres, height_m })
    }
}

/// The first rest that a body lowered onto its spheres meets; `hertz` is that of the Hertz law.
pub(crate) fn first_rest(spheres: &[Raised], load_n: f64, hertz: f64) -> Result<f64, DomainError> {
    let Some(step) = smallest_transition(spheres) else { return Ok(hertz) };
    let mut in_reach: Vec<(f64, &Raised)> = spheres.iter().map(|s| (reach(s), s)).collect();
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
        let most = |s: &Raised| {
            s.spheres.count() * s.spheres.law().rest_force_limit(from - s.height_m, to - s.height_m)
        };
        near(to).map(most).sum::<f64>() * (1.0 + 1e-9) < load_n
    };
    // How many steps in which nothing can carry the load are taken at once: fewer the nearer the load is.
    let mut unseen;
    // Short steps through the onset of each sphere, where its force can rise and fall; elsewhere forces only rise.
    for onset in onsets(spheres) {
        below = below.max(onset - 20.0 * step);
        unseen = 20;
        // A transition shorter than a number can say at this height is none.
        while below <= onset && below < below + 0.05 * step {
            if never_carried(below, below + 1.001 * 0.05 * f64::from(unseen) * step) {
                // The same steps, unseen.
                for _ in 0..unseen {
                    if below <= onset {
                        above = below;
                        below += 0.05 * step;
                    }
                }
                continue;
            }
            if unseen > 1 {
                unseen = if unseen > 5 { 5 } else { 1 };
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
    within(below.is_finite() && !carried(above), "load", load_n, "a load that the spheres can carry")?;
    let guess = refined(
        hertz.max(above).min(below),
        |x| sum(&|law, x| law.rest_force(x), x) - load_n,
        |x| sum(&|law, x| law.rest_stiffness(x), x),
    );
    // A body that floats is carried by a small difference of large numbers, which rounds so coarsely that bisections on other ways end
    // elsewhere.
    let guess = if guess > 0.0 { guess } else { f64::NAN };
    Ok(bisect_near(guess, above, below, carried))
}

/// Where `value` is 0, by Newton's method from `start`. It is a guess: nothing says that the steps end there.
pub(crate) fn refined(start: f64, value: impl Fn(f64) -> f64, slope: impl Fn(f64) -> f64) -> f64 {
    // Each step doubles the digits that are right.
    const STEPS: usize = 8;
    let mut x = start;
    for _ in 0..STEPS {
        let next = x - value(x) / slope(x);
        let is_there = (next - x).abs() <= 1e-14 * next.abs();
        x = next;
        if is_there || !x.is_finite() {
            break;
        }
    }
    x
}

/// The indentation of the lowest sphere up to which `sphere` carries nothing: a contact state is 0 in all digits 20 transitions
/// before contact.
fn reach(sphere: &Raised) -> f64 {
    match sphere.spheres.law() {
        Law::HuntCrossley(_) => sphere.height_m,
        Law::Smooth(law) => sphere.height_m - 20.0 / law.smoothing().hertz_smoothing,
    }
}

/// The heights at which spheres begin to touch, each once, the lowest first.
fn onsets(spheres: &[Raised]) -> Vec<f64> {
    let mut heights: Vec<f64> = spheres.iter().map(|s| s.height_m).collect();
    heights.sort_by(f64::total_cmp);
    heights.dedup();
    heights
}

/// The shortest 1/bd of the smoothed laws: the length over which the force can change.
fn smallest_transition(spheres: &[Raised]) -> Option<f64> {
    spheres.iter().fold(None, |shortest: Option<f64>, raised| match raised.spheres.law() {
        Law::HuntCrossley(_) => shortest,
        Law::Smooth(law) => {
            let length = 1.0 / law.smoothing().hertz_smoothing;
            Some(shortest.map_or(length, |known| known.min(length)))
        }
    })
}

/// What [`bisect`] finds where `guess` is close to it: the same, to the last bit, and sooner.
///
/// Where the laws do not hold a little before `guess` and hold a little after it, they need not be asked farther away: of the points that
/// [`bisect`] asks about, most are there. A bad guess costs two questions, none at all (NaN) nothing.
pub(crate) fn bisect_near(guess: f64, out: f64, within: f64, holds: impl Fn(f64) -> bool) -> f64 {
    // Far more than rounding moves the point, and far less than a guess is to be wrong.
    const NEAR: f64 = 1e-12;
    let near = NEAR * guess.abs().max(within - out);
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

/// The point between `out` and `within` where `holds` begins, to the last bit.
pub(crate) fn bisect(mut out: f64, mut within: f64, holds: impl Fn(f64) -> bool) -> f64 {
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
    use crate::equilibrium::{hertz_indentation_of_lowest, indentation_of_lowest};
    use crate::{Contact, ContactValues, SmoothingValues, falisse2022};
    use proptest::prelude::*;

    fn law(smoothing: Option<SmoothingValues>, radius: f64) -> Spheres {
        let values = ContactValues { smoothing, ..falisse2022().contact.values() };
        Spheres::new(Law::of(&Contact::new(values).unwrap(), radius).unwrap(), 1.0).unwrap()
    }

    fn smooth(cf: f64, bd: f64) -> Option<SmoothingValues> {
        let smoothing = SmoothingValues {
            constant_contact_force: cf,
            hertz_smoothing: bd,
            hunt_crossley_smoothing: 50.0,
        };
        Some(smoothing)
    }

    #[test]
    fn a_sphere_out_of_reach_carries_nothing() {
        let low = law(None, 0.03);
        let alone = crate::equilibrium::hertz_indentation(&[low], 500.0).unwrap();
        let both = [Raised::new(low, 0.0).unwrap(), Raised::new(law(None, 0.05), 2.0 * alone).unwrap()];
        let x = hertz_indentation_of_lowest(&both, 500.0).unwrap();
        assert!((x / alone - 1.0).abs() < 1e-14, "{x} {alone}");
    }

    #[test]
    fn heights_and_loads_have_domains() {
        assert_eq!(Raised::new(law(None, 0.03), -1e-3).unwrap_err().quantity(), "height");
        assert_eq!(
            hertz_indentation_of_lowest(&[], 1.0).unwrap_err().quantity(),
            "sum of force coefficients"
        );
    }

    #[test]
    fn a_transition_of_no_length_ends() {
        let foot = [
            Raised::new(law(smooth(1e-5, 1e18), 0.03), 0.0),
            Raised::new(law(smooth(1e-5, 1e18), 0.03), 0.5),
        ];
        let foot = foot.map(Result::unwrap);
        let x = indentation_of_lowest(&foot, 500.0).unwrap();
        assert!((x / hertz_indentation_of_lowest(&foot, 500.0).unwrap() - 1.0).abs() < 0.1, "{x}");
    }

    proptest! {
        /// The laws are summed here by hand, each at its own indentation.
        #[test]
        fn the_load_is_carried_there(
            load in 1.0..1e4, cf in 1e-9..1e-4, bd in 50.0..5e3, height in 0.0..0.05, r1 in 1e-2..0.1, r2 in 1e-2..0.1,
        ) {
            let (low, high) = (law(smooth(cf, bd), r1), law(smooth(cf, bd / 2.0), r2));
            let foot = [Raised::new(high, height).unwrap(), Raised::new(low, 0.0).unwrap()];
            let x = indentation_of_lowest(&foot, load).unwrap();
            let force = low.law().rest_force(x) + high.law().rest_force(x - height);
            prop_assert!((force / load - 1.0).abs() < 1e-9, "{x} {force} {load}");
        }
    }
}
