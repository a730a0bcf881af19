//! Command lines that mend a finding, to be copied as they are.

use std::fmt::Write as _;

use contact_scaling::limits;
use osim_patch::{Property, shortest};

use crate::args::ViewArgs;
use crate::look::{Inspection, SphereFigures};
use crate::report::{number, quoted};

const PROGRAM: &str = "osim-contact-scale";

/// What all commands for one model share.
pub(super) struct Mend<'m> {
    /// The model, quoted where it has to be; `None` for standard input, which cannot be read twice, for a model that
    /// is not changed as it is, and where something else has to be done first.
    model: Option<String>,
    /// Options that say what the model weighs.
    mass: String,
    /// Options that say how many spheres share the weight.
    counts: String,
    /// Options that choose forces and name further files.
    choice: String,
    /// Some force gives spheres of different size or material one modulus, so that no design serves all of them; all numbers
    /// are multiplied then.
    joined: bool,
    /// How many spheres share the weight is the same for all limbs.
    counted: bool,
    /// The gravity is the model's own.
    weighed: bool,
    args: &'m ViewArgs,
}

impl<'m> Mend<'m> {
    pub(super) fn new(seen: &Inspection, joined: bool, changes: bool, args: &'m ViewArgs) -> Self {
        let mut mass = String::new();
        // What the bodies do not say has to be said again.
        if let Some(kg) = args.masses.mass.or(seen.figures.mass_kg.filter(|_| seen.mass_kg.is_none())) {
            option(&mut mass, "--mass", &shortest(kg));
        }
        // A gravity that the model's own file does not say, because its contacts are scaled to it first.
        let other_gravity =
            seen.figures.gravity_m_s2.filter(|_| seen.figures.gravity_m_s2 != seen.gravity_m_s2);
        if let Some(gravity) = other_gravity {
            option(&mut mass, "--gravity", &shortest(gravity));
        }
        for glob in &args.masses.exclude_body {
            option(&mut mass, "--exclude-body", &quoted(glob.glob()));
        }
        let mut counts = String::new();
        if let Some(spheres) = args.stance.spheres {
            option(&mut counts, "--spheres", &shortest(spheres));
        }
        if args.stance.stance_limbs != 1.0 {
            option(&mut counts, "--stance-limbs", &shortest(args.stance.stance_limbs));
        }
        let mut choice = String::new();
        for glob in &args.choice.select {
            option(&mut choice, "--select", &quoted(glob.glob()));
        }
        for glob in &args.choice.exclude {
            option(&mut choice, "--exclude", &quoted(glob.glob()));
        }
        if args.choice.skip_disabled {
            choice.push_str(" --skip-disabled");
        }
        for (name, path) in [("--geometry", &args.parts.geometry), ("--model", &args.parts.model)] {
            if let Some(path) = path {
                option(&mut choice, name, &quoted(&path.display().to_string()));
            }
        }
        let weighed = other_gravity.is_none();
        let model = Some(seen.model.as_str()).filter(|model| *model != "-" && changes).map(quoted);
        let counted = seen.spheres_per_limb.is_some() || args.stance.spheres.is_some();
        Self { model, mass, counts, choice, joined, counted, weighed, args }
    }

    /// Without commands: something else has to be done first, after which they would be wrong.
    pub(super) fn unsettled(self) -> Self {
        Self { model: None, ..self }
    }

    fn design(&self, wanted: &str, with_load: bool) -> Option<String> {
        let load = if with_load { format!("{}{}", self.mass, self.counts) } else { String::new() };
        Some(format!("{PROGRAM} design {} {wanted}{load}{}", self.model.as_ref()?, self.choice))
    }

    fn set(&self, what: &str) -> Option<String> {
        Some(format!("{PROGRAM} set {} {what}{}", self.model.as_ref()?, self.choice))
    }

    /// Brings x̂ down to the limit under `body_weights`; where the law is smoothed, its constant indentation with it.
    pub(super) fn indentation(&self, spheres: &[&SphereFigures], body_weights: f64) -> Option<String> {
        let limit = limits::HERTZ_RELATIVE_INDENTATION;
        if self.joined || !self.counted {
            // The sphere that sinks in most decides. x̂ follows E*^(-2/3) (11).
            let hertz = |sphere: &&SphereFigures| sphere.load(body_weights).and_then(|load| load.hertz);
            let deepest = spheres.iter().filter_map(hertz).fold(0.0, f64::max);
            let factor = (deepest / limit).powf(1.5);
            return self.set(&format!("stiffness=x{}", shortest((factor * 1e3).ceil() / 1e3)));
        }
        let mut wanted = format!("--indentation {limit}");
        if body_weights != 1.0 {
            option(&mut wanted, "--body-weights", &shortest(body_weights));
        }
        if spheres.iter().any(|sphere| sphere.constant_indentation.is_some()) {
            // x̂ at body weight once it is at the limit under the load asked for.
            let x_hat = limit / body_weights.powf(2.0 / 3.0);
            option(&mut wanted, "--constant-indentation", &shortest(constant_indentation_below(x_hat)));
        }
        self.design(&wanted, true)
    }

    /// Brings the restitution up to the limit, from the largest dissipation that is there.
    pub(super) fn restitution(&self, impact_speed_m_s: f64, dissipation_s_m: f64) -> Option<String> {
        let limit = limits::HUNT_CROSSLEY_RESTITUTION;
        if self.joined {
            let factor = (1.0 - limit) / impact_speed_m_s / dissipation_s_m;
            return self.set(&format!("dissipation=x{}", shortest(two_digits_below(factor))));
        }
        let speed = shortest((impact_speed_m_s * 1e4).ceil() / 1e4);
        self.design(&format!("--restitution {limit} --impact-speed {speed}"), false)
    }

    pub(super) fn constant_indentation(&self, constant_indentation: f64) -> Option<String> {
        self.design(&format!("--constant-indentation {}", shortest(constant_indentation)), false)
    }

    pub(super) fn transition(&self) -> Option<String> {
        self.design("--state-width 0.3", false)
    }

    /// Brings the force just touching down to a tenth of the share of the weight.
    pub(super) fn touching(&self, spheres: &[&SphereFigures]) -> Option<String> {
        let hertz = |sphere: &&SphereFigures| sphere.load(1.0).and_then(|load| load.hertz);
        let least = spheres.iter().filter_map(hertz).reduce(f64::min)?;
        self.constant_indentation(constant_indentation_below(least))
    }

    /// Scales contacts that were made for another body to this one.
    pub(super) fn rescale(&self, contacts_kg: f64, target_kg: f64) -> Option<String> {
        let mut masses = String::new();
        option(&mut masses, "--contacts-mass", &number(contacts_kg));
        option(&mut masses, "--target-mass", &number(target_kg));
        Some(format!("{PROGRAM} {}{masses}{}", self.model.as_ref()?, self.choice))
    }

    /// Contacts of a published model.
    pub(super) fn preset(&self) -> Option<String> {
        let model = self.model.as_ref().filter(|_| self.weighed)?;
        Some(format!(
            "{PROGRAM} transfer {model} --from falisse2022{}{}{}",
            self.mass, self.counts, self.choice
        ))
    }

    /// Writes values into one force.
    pub(super) fn copy(&self, force: &str, values: &[(Property, f64)]) -> Option<String> {
        if !self.args.choice.select.is_empty() || force.contains(['*', '?', '[', ']', '{', '}', '\\', '!']) {
            return None;
        }
        let mut what = String::new();
        for (property, value) in values {
            let _ = write!(what, "{property}={} ", shortest(*value));
        }
        self.set(&format!("{what}--select {}", quoted(force)))
    }
}

/// √cf/R with which a sphere that rests at x̂ carries a tenth of its load while just touching, rounded down.
///
/// ½ (x̂_c/x̂)^(3/2) ≤ 0.1, from (C.3) at x = 0 over (3).
fn constant_indentation_below(x_hat: f64) -> f64 {
    let most = x_hat * (2.0 * limits::TOUCHING_SHARE).powf(2.0 / 3.0);
    let most = most.min(limits::CONSTANT_INDENTATION);
    two_digits_below(most)
}

/// At most `value`, in two digits, without the dust of binary fractions.
fn two_digits_below(value: f64) -> f64 {
    let digit = 10_f64.powf(value.log10().floor() - 1.0);
    // A value that has two digits is itself, whatever its last bit.
    let text = format!("{:.1e}", (value / digit + 1e-9).floor() * digit);
    text.parse().unwrap_or(value)
}

fn option(text: &mut String, name: &str, value: &str) {
    let _ = write!(text, " {name} {value}");
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_tenth_of_the_load_is_not_passed() {
        for x_hat in [0.0009, 0.05, 0.1, 0.16, 0.2] {
            let constant = constant_indentation_below(x_hat);
            let share = 0.5 * (constant / x_hat).powf(1.5);
            assert!(share <= 0.1 && share > 0.08, "{x_hat}: {constant} gives {share}");
        }
        assert_eq!(constant_indentation_below(5.0), 0.1);
    }
}
