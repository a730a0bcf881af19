//! Makes the requests that correct findings.

use std::path::PathBuf;

use contact_scaling::limits;
use osim_model::files::FileName;
use osim_model::messages::readable;
use osim_model::{Assignment, Pattern, Property, Selection};
use osim_requests::options::{CountOptions, ForceOptions, LoadOptions, MassOptions, SetFiles, WantedOptions};
use osim_requests::{
    Acceleration, Assignments, ConstantIndentation, Count, DesignRequest, Kilograms, RelativeIndentation,
    Request, SetRequest, TransferRequest,
};

use crate::{Figure, InspectOptions, Inspection, SphereFigures};

/// Which values of a model can be changed, as trial plans show. A remedy that would be refused is not proposed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ChangeableValues {
    /// Whether stiffness, dissipation and the other numbers of the contacts can be changed.
    pub numbers: bool,
    /// Whether radii can be changed. They cannot if a force that the change leaves alone uses the same sphere.
    pub radii: bool,
}

impl ChangeableValues {
    /// Assumes, without a trial plan, that everything can be changed.
    pub const ASSUME_ALL: Self = Self { numbers: true, radii: true };
}

/// The preset whose contacts are proposed if the contacts of the model make no sense.
const PRESET_OF_REMEDIES: &str = "falisse2022";

/// Makes the remedies for one model. A remedy is the request that corrects a finding.
pub(crate) struct Remedies<'m> {
    /// The file of the model, also if something else has to be corrected first; `None` for standard input.
    pub(crate) file: Option<PathBuf>,
    /// The file of the model. `None` for standard input, which cannot be read twice, for a model that cannot be changed, and if something
    /// else has to be corrected first: then there are no remedies.
    model: Option<PathBuf>,
    // Options about masses, numbers of spheres and gravity, repeated from the call of the user.
    pub(crate) masses: MassOptions,
    counts: CountOptions,
    /// Without a gravity if it is that in the file of the model.
    load: LoadOptions,
    pub(crate) options: &'m InspectOptions,
    /// Whether one force has spheres of different size or material, and one modulus for all of them. No design suits all these spheres, so
    /// a remedy multiplies the numbers.
    one_modulus: bool,
    /// Whether the number of spheres that share the weight is known and equal for all limbs.
    pub(crate) is_counted: bool,
    knows_weight: bool,
    pub(crate) body_kg: Option<f64>,
    /// Whether radii can be changed: no force outside the change uses the spheres.
    radii_may_change: bool,
}

impl<'m> Remedies<'m> {
    /// The maker of remedies for an inspected model. Remedies repeat the masses, the load and the choice of forces in `options`.
    pub(crate) fn new(
        inspected: &Inspection,
        one_modulus: bool,
        changeable: ChangeableValues,
        options: &'m InspectOptions,
    ) -> Self {
        let (figures, stance) = (&inspected.figures, &options.stance);
        // A mass that the bodies do not have must be given to the remedy, too; also a gravity that is not that of the model's file.
        let figures_kg = figures.mass_kg.filter(|_| inspected.mass_kg.is_none());
        let mass = options.masses.model_kg.or(figures_kg);
        let gravity = figures.gravity_m_s2.filter(|_| figures.gravity_m_s2 != inspected.gravity_m_s2);
        let count = |number: Option<f64>| number.and_then(|number| Count::new(number).ok());
        let gravity = gravity.and_then(|gravity| Acceleration::new(gravity).ok());
        let name = || FileName::from_parts(inspected.model.clone(), inspected.model_bytes.clone()).to_path();
        let file = (inspected.model != "-").then(name);
        Self {
            model: file.clone().filter(|_| changeable.numbers),
            file,
            masses: MassOptions {
                mass: mass.and_then(|kg| Kilograms::new(kg).ok()),
                exclude_body: options.masses.exclude_bodies.clone(),
                ..MassOptions::default()
            },
            counts: CountOptions { spheres: count(stance.spheres), stance_limbs: count(stance.limbs) },
            load: LoadOptions { gravity, ..LoadOptions::default() },
            options,
            one_modulus,
            is_counted: inspected.spheres_per_limb.is_some() || stance.spheres.is_some(),
            knows_weight: figures.mass_kg.is_some(),
            body_kg: inspected.mass_kg,
            radii_may_change: !changeable.numbers || changeable.radii,
        }
    }

    /// Turns off all remedies, because another fault has to be corrected first, after which these remedies would be wrong.
    pub(crate) fn none_yet(self) -> Self {
        Self { model: None, ..self }
    }

    /// The model that a remedy changes; `None` if there is no remedy. `changes_radii` says whether the remedy writes radii.
    pub(crate) fn models(&self, changes_radii: bool) -> Option<Vec<PathBuf>> {
        (!changes_radii || self.radii_may_change).then(|| self.model.clone().map(|model| vec![model]))?
    }

    /// The options by which the caller chose forces; remedies choose the same forces.
    pub(crate) fn choice(&self) -> ForceOptions {
        let Selection { select, exclude, skip_disabled, .. } = self.options.selection.clone();
        ForceOptions { select, exclude, skip_disabled }
    }

    /// The files of a standalone set that the caller gave; remedies name them again.
    pub(crate) fn set_files(&self) -> SetFiles {
        SetFiles { geometry: self.options.geometry.clone(), model: self.options.model.clone() }
    }

    /// A remedy that designs parameters which do not depend on the load.
    pub(crate) fn design(&self, wanted: WantedOptions) -> Option<DesignRequest> {
        let (models, choice, set_files) = (self.models(false)?, self.choice(), self.set_files());
        Some(DesignRequest { models, wanted, choice, set_files, ..DesignRequest::default() })
    }

    /// A remedy that gives properties new values.
    pub(crate) fn set(&self, assignments: Vec<(Property, Assignment)>) -> Option<SetRequest> {
        let changes_radii = assignments.iter().any(|(property, _)| *property == Property::Radius);
        Some(SetRequest {
            models: self.models(changes_radii)?,
            set: assignments.into_iter().collect::<Assignments>(),
            choice: self.choice(),
            set_files: self.set_files(),
            ..SetRequest::default()
        })
    }

    /// A remedy that brings the bottoms of each foot to one height.
    pub(crate) fn level_feet(&self) -> Option<Request> {
        // A sphere that another force needs as it is can neither move nor change its radius.
        let models = self.models(true)?;
        Some(SetRequest { models, level: true, ..self.set(Vec::new())? }.into())
    }

    /// A remedy that reduces x̂ under body weight to its limit. If the law is smoothed, it reduces the constant indentation, too.
    pub(crate) fn reduce_indentation(&self, spheres: &[&SphereFigures]) -> Option<Request> {
        let limit = limits::INDENTATION.value;
        if self.one_modulus || !self.is_counted {
            // The sphere that sinks in most decides. x̂ follows E*^(-2/3) (11).
            let depths = spheres.iter().filter_map(|sphere| sphere.value(Figure::Indentation));
            let deepest = depths.fold(0.0, f64::max);
            let factor = (deepest / limit).powf(1.5);
            let factor = Assignment::Factor((factor * 1e3).ceil() / 1e3);
            return self.set(vec![(Property::Stiffness, factor)]).map(Request::from);
        }
        let smooth = spheres.iter().any(|sphere| sphere.value(Figure::ConstantIndentation).is_some());
        let constant = smooth.then(|| constant_indentation_below(limit));
        let wanted = WantedOptions {
            indentation: Some(RelativeIndentation::new(limit).ok()?),
            constant_indentation: constant.map(ConstantIndentation::new).transpose().ok()?,
            ..WantedOptions::default()
        };
        let (load, masses, counts) = (self.load.clone(), self.masses.clone(), self.counts.clone());
        Some(DesignRequest { load, masses, counts, ..self.design(wanted)? }.into())
    }

    /// A remedy that gives the smoothed law this √cf/R.
    pub(crate) fn design_constant_indentation(&self, constant_indentation: f64) -> Option<Request> {
        let constant_indentation = Some(ConstantIndentation::new(constant_indentation).ok()?);
        self.design(WantedOptions { constant_indentation, ..WantedOptions::default() }).map(Request::from)
    }

    /// A remedy that takes the contacts of a published model, for the load of the caller or for `stance_limbs` limbs.
    pub(crate) fn transfer_published(&self, stance_limbs: Option<f64>) -> Option<TransferRequest> {
        // A transfer takes the model's own gravity.
        let is_load_known = self.load.gravity.is_none() && self.knows_weight && self.is_counted;
        let mut request = is_load_known.then(|| self.transfer(PRESET_OF_REMEDIES.into()))??;
        if let Some(limbs) = stance_limbs {
            request.counts.stance_limbs = Some(Count::new(limbs).ok()?);
        }
        Some(request)
    }

    /// A remedy that takes the contacts of the model or preset `from`, for the load of the caller.
    pub(crate) fn transfer(&self, from: PathBuf) -> Option<TransferRequest> {
        Some(TransferRequest {
            models: self.models(true)?,
            from: Some(from),
            masses: self.masses.clone(),
            counts: self.counts.clone(),
            choice: self.choice(),
            set_files: self.set_files(),
            ..TransferRequest::default()
        })
    }
}

/// The pattern that only this name matches; `None` if the name has letters with a special meaning in patterns.
pub(crate) fn exact_pattern(name: &str) -> Option<Pattern> {
    let is_plain = !name.contains(['*', '?', '[', ']', '{', '}', '\\', '!']);
    if is_plain { name.parse().ok() } else { None }
}

/// A mass rounded to as many digits as messages show.
pub(crate) fn rounded_mass(kg: f64) -> f64 {
    readable(kg).parse().unwrap_or(kg)
}

/// The largest √cf/R with which every sphere carries at most a tenth of its load while it just touches the floor.
pub(crate) fn constant_indentation_for_touching(spheres: &[&SphereFigures]) -> Option<f64> {
    let least = spheres.iter().filter_map(|sphere| sphere.value(Figure::Indentation)).reduce(f64::min)?;
    Some(constant_indentation_below(least))
}

/// The transition width, over R, with which every sphere carries at most the part `share` of its load above the floor.
///
/// With bd in (C.7), (C.1) lets through ½ (1 − tanh u) of (u/(bd R x̂))^(3/2) of the load, u = −bd x. That is largest at u = 0.8792, where it
/// is 0.12118/(bd R x̂)^(3/2); from that and (C.8), the width is 2 artanh(1 − 2t) (share/0.12118)^(2/3) x̂.
pub(crate) fn transition_width_for(spheres: &[&SphereFigures], share: f64) -> Option<f64> {
    let least = spheres.iter().filter_map(|sphere| sphere.value(Figure::Indentation)).reduce(f64::min)?;
    let full = 2.0 * (1.0 - 2.0 * limits::TRANSITION_SHARE).atanh();
    Some(round_down_to_two_digits(full * (share / 0.121_18).powf(2.0 / 3.0) * least))
        .filter(|&width| width > 0.0)
}

/// The √cf/R with which a sphere in equilibrium at x̂ carries a tenth of its load while it just touches the floor, rounded down.
///
/// ½ (x̂_c/x̂)^(3/2) ≤ 0.1, from (C.3) at x = 0 over (3).
fn constant_indentation_below(x_hat: f64) -> f64 {
    let most = x_hat * (2.0 * limits::TOUCHING_SHARE.value).powf(2.0 / 3.0);
    let most = most.min(limits::CONSTANT_INDENTATION.value);
    round_down_to_two_digits(most)
}

/// `value` rounded down to two digits.
fn round_down_to_two_digits(value: f64) -> f64 {
    let digit = 10_f64.powf(value.log10().floor() - 1.0);
    // A value of two digits stays as it is, whatever its last bit.
    let text = format!("{:.1e}", (value / digit + 1e-9).floor() * digit);
    text.parse().unwrap_or(value)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn just_touching_carries_at_most_a_tenth_of_the_load() {
        for x_hat in [0.0009, 0.05, 0.1, 0.16, 0.2] {
            let constant = constant_indentation_below(x_hat);
            let share = 0.5 * (constant / x_hat).powf(1.5);
            assert!(share <= 0.1 && share > 0.08, "{x_hat}: {constant} gives {share}");
        }
        assert_eq!(constant_indentation_below(5.0), 0.1);
    }

    #[test]
    fn numbers_are_rounded_down_to_two_digits() {
        for (value, expected) in [
            (0.054_72, 0.054),
            (0.034_47, 0.034),
            (0.999, 0.99),
            (12.7, 12.0),
            (1999.0, 1900.0),
            (0.1, 0.1),
            (1.0, 1.0),
            // 0.29 / 0.01 is 28.999999999999996.
            (0.29, 0.29),
            (0.000_57, 0.000_57),
        ] {
            assert_eq!(round_down_to_two_digits(value), expected, "{value}");
        }
    }

    #[test]
    fn a_constant_indentation_is_about_a_third_of_x_hat() {
        // 0.2^(2/3) is 0.341995.
        assert_eq!(constant_indentation_below(0.16), 0.054);
        assert_eq!(constant_indentation_below(0.03), 0.01);
        // 0.3 · 0.341995 is 0.1026, above what the paper starts from.
        assert_eq!(constant_indentation_below(0.3), 0.1);
    }

    #[test]
    fn masses_have_as_many_digits_as_messages_show() {
        assert_eq!(rounded_mass(90.123_456_789), 90.123_457);
        assert_eq!(rounded_mass(0.0209), 0.0209);
    }
}
