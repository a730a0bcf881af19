//! Changes that put a finding right, as data: the command prints them, other front ends apply them.

use std::path::PathBuf;

use contact_scaling::limits;
use osim_model::files::FileName;
use osim_model::wording::Dialect;
use osim_model::{Pattern, Property, Selection, readable};
use osim_patch::Assignment;

use crate::figures::SphereFigures;
use crate::inspection::Inspection;
use crate::options::InspectOptions;

/// The preset whose contacts are proposed where a model's own make no sense.
const PROPOSED_PRESET: &str = "falisse2022";

/// A change that puts a finding right.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Remedy {
    /// The model, as it was named.
    pub model: FileName,
    /// What is done with it.
    pub change: RemedyChange,
    /// Whose weight is carried, where that matters.
    pub load: Option<RemedyLoad>,
    /// Which forces.
    pub selection: Selection,
    /// The geometry set of a force set that stands alone.
    pub geometry: Option<PathBuf>,
    /// The model of a force set that stands alone.
    pub set_model: Option<PathBuf>,
}

/// What a remedy does.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum RemedyChange {
    /// Contacts that were made for one mass, scaled to another.
    Rescale {
        /// The mass they were made for, kg.
        contacts_mass_kg: f64,
        /// The mass of the body, kg.
        target_mass_kg: f64,
    },
    /// Contacts of a preset.
    Transfer {
        /// Its name.
        from: &'static str,
    },
    /// Parameters from what is wanted.
    Design(RemedyDesign),
    /// Values, or factors.
    Set {
        /// Properties and what becomes of them.
        assignments: Vec<(Property, Assignment)>,
    },
}

/// What is wanted of a contact; `None` is left as it is.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[non_exhaustive]
pub struct RemedyDesign {
    /// x̂ under the load (11).
    pub indentation: Option<f64>,
    /// The load, in body weights, where it is not one.
    pub body_weights: Option<f64>,
    /// c_r (13).
    pub restitution: Option<f64>,
    /// Speed of the impact that it is about, m/s.
    pub impact_speed_m_s: Option<f64>,
    /// x̂_c (C.2).
    pub constant_indentation: Option<f64>,
    /// Δx̂ (C.8).
    pub state_width: Option<f64>,
}

/// Whose weight is carried, and by how many spheres: what was said of it is said again.
#[derive(Debug, Clone, PartialEq, Default)]
#[non_exhaustive]
pub struct RemedyLoad {
    /// What the model weighs, kg.
    pub mass_kg: Option<f64>,
    /// Gravity that the model's own file does not say, m/s².
    pub gravity_m_s2: Option<f64>,
    /// Bodies that do not count.
    pub exclude_bodies: Vec<Pattern>,
    /// Spheres that share the weight.
    pub spheres: Option<f64>,
    /// Limbs that share the weight, where it is not one.
    pub stance_limbs: Option<f64>,
}

/// The words of a front end, for remedies too.
pub trait RemedyDialect: Dialect {
    /// A remedy, as the reader types it.
    fn remedy(&self, remedy: &Remedy) -> String;
}

/// What all remedies for one model share.
pub(super) struct Remedies<'m> {
    /// `None` for standard input, which cannot be read twice, for a model that is not changed as it is, and where something
    /// else has to be done first.
    model: Option<FileName>,
    load: RemedyLoad,
    options: &'m InspectOptions,
    /// Some force gives spheres of different size or material one modulus, so that no design serves all of them; all numbers
    /// are multiplied then.
    joined: bool,
    /// How many spheres share the weight is the same for all limbs.
    counted: bool,
}

impl<'m> Remedies<'m> {
    pub(super) fn new(
        inspected: &Inspection,
        joined: bool,
        changes: bool,
        options: &'m InspectOptions,
    ) -> Self {
        let (figures, stance) = (&inspected.figures, &options.stance);
        // What the bodies do not say has to be said again; likewise a gravity that the model's own file does not say,
        // because its contacts are scaled to it first.
        let of_figures = figures.mass_kg.filter(|_| inspected.mass_kg.is_none());
        let load = RemedyLoad {
            mass_kg: options.masses.model_kg.or(of_figures),
            gravity_m_s2: figures.gravity_m_s2.filter(|_| figures.gravity_m_s2 != inspected.gravity_m_s2),
            exclude_bodies: options.masses.exclude_bodies.clone(),
            spheres: stance.spheres,
            stance_limbs: Some(stance.limbs).filter(|&limbs| limbs != 1.0),
        };
        let model = (inspected.model != "-" && changes)
            .then(|| FileName::from_parts(inspected.model.clone(), inspected.model_bytes.clone()));
        let counted = inspected.spheres_per_limb.is_some() || stance.spheres.is_some();
        Self { model, load, options, joined, counted }
    }

    /// Without remedies: something else has to be done first, after which they would be wrong.
    pub(super) fn unsettled(self) -> Self {
        Self { model: None, ..self }
    }

    fn remedy(&self, change: RemedyChange, with_load: bool) -> Option<Remedy> {
        Some(Remedy {
            model: self.model.clone()?,
            change,
            load: with_load.then(|| self.load.clone()),
            selection: self.options.selection.clone(),
            geometry: self.options.geometry.clone(),
            set_model: self.options.model.clone(),
        })
    }

    fn design(&self, wanted: RemedyDesign, with_load: bool) -> Option<Remedy> {
        self.remedy(RemedyChange::Design(wanted), with_load)
    }

    fn factor(&self, property: Property, factor: f64) -> Option<Remedy> {
        let assignments = vec![(property, Assignment::Factor(factor))];
        self.remedy(RemedyChange::Set { assignments }, false)
    }

    /// Brings x̂ down to the limit under `body_weights`; where the law is smoothed, its constant indentation with it.
    pub(super) fn indentation(&self, spheres: &[&SphereFigures], body_weights: f64) -> Option<Remedy> {
        let limit = limits::HERTZ_RELATIVE_INDENTATION;
        if self.joined || !self.counted {
            // The sphere that sinks in most decides. x̂ follows E*^(-2/3) (11).
            let hertz = |sphere: &&SphereFigures| sphere.load(body_weights).and_then(|load| load.hertz);
            let deepest = spheres.iter().filter_map(hertz).fold(0.0, f64::max);
            let factor = (deepest / limit).powf(1.5);
            return self.factor(Property::Stiffness, (factor * 1e3).ceil() / 1e3);
        }
        let smooth = spheres.iter().any(|sphere| sphere.constant_indentation.is_some());
        // x̂ at body weight once it is at the limit under the load asked for.
        let x_hat = limit / body_weights.powf(2.0 / 3.0);
        let wanted = RemedyDesign {
            indentation: Some(limit),
            body_weights: Some(body_weights).filter(|&weights| weights != 1.0),
            constant_indentation: smooth.then(|| constant_indentation_below(x_hat)),
            ..RemedyDesign::default()
        };
        self.design(wanted, true)
    }

    /// Brings the restitution up to the limit, from the largest dissipation that is there.
    pub(super) fn restitution(&self, impact_speed_m_s: f64, dissipation_s_m: f64) -> Option<Remedy> {
        let limit = limits::HUNT_CROSSLEY_RESTITUTION;
        if self.joined {
            let factor = (1.0 - limit) / impact_speed_m_s / dissipation_s_m;
            return self.factor(Property::Dissipation, two_digits_below(factor));
        }
        let wanted = RemedyDesign {
            restitution: Some(limit),
            impact_speed_m_s: Some((impact_speed_m_s * 1e4).ceil() / 1e4),
            ..RemedyDesign::default()
        };
        self.design(wanted, false)
    }

    pub(super) fn constant_indentation(&self, constant_indentation: f64) -> Option<Remedy> {
        let constant_indentation = Some(constant_indentation);
        self.design(RemedyDesign { constant_indentation, ..RemedyDesign::default() }, false)
    }

    pub(super) fn transition(&self) -> Option<Remedy> {
        self.design(RemedyDesign { state_width: Some(0.3), ..RemedyDesign::default() }, false)
    }

    /// Brings the force just touching down to a tenth of the share of the weight.
    pub(super) fn touching(&self, spheres: &[&SphereFigures]) -> Option<Remedy> {
        let hertz = |sphere: &&SphereFigures| sphere.load(1.0).and_then(|load| load.hertz);
        let least = spheres.iter().filter_map(hertz).reduce(f64::min)?;
        self.constant_indentation(constant_indentation_below(least))
    }

    /// Scales contacts that were made for another body to this one.
    pub(super) fn rescale(&self, contacts_kg: f64, target_mass_kg: f64) -> Option<Remedy> {
        let change = RemedyChange::Rescale {
            contacts_mass_kg: rounded(contacts_kg),
            target_mass_kg: rounded(target_mass_kg),
        };
        self.remedy(change, false)
    }

    /// Contacts of a published model.
    pub(super) fn preset(&self) -> Option<Remedy> {
        // A transfer takes the model's own gravity.
        let own_gravity = self.load.gravity_m_s2.is_none();
        own_gravity.then(|| self.remedy(RemedyChange::Transfer { from: PROPOSED_PRESET }, true)).flatten()
    }

    /// Writes values into one force.
    pub(super) fn copy(&self, force: &str, values: &[(Property, f64)]) -> Option<Remedy> {
        let selection = &self.options.selection;
        if !selection.select.is_empty() || force.contains(['*', '?', '[', ']', '{', '}', '\\', '!']) {
            return None;
        }
        let assignments = values.iter().map(|(property, value)| (*property, Assignment::Value(*value)));
        let remedy = self.remedy(RemedyChange::Set { assignments: assignments.collect() }, false)?;
        let select = vec![force.parse().ok()?];
        Some(Remedy { selection: Selection { select, ..selection.clone() }, ..remedy })
    }
}

/// In as many digits as people read.
fn rounded(kg: f64) -> f64 {
    readable(kg).parse().unwrap_or(kg)
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
