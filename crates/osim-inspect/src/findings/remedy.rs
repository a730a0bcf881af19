//! Which change puts a finding right.

use std::cell::OnceCell;
use std::collections::HashSet;
use std::path::PathBuf;

use contact_scaling::limits;
use osim_compare::{Placement, is_stretched};
use osim_feet::{DefaultPose, sphere_pairs};
use osim_messages::{Verb, readable};
use osim_model::files::FileName;
use osim_model::{
    Assignment, FileId, Force, ForceId, ForceKind, Model, Pattern, Property, Selection, Sphere,
};
use osim_requests::options::{
    ClassChoice, CountOptions, FollowOptions, ForceOptions, LoadOptions, MassOptions, MovedChoice,
    ScalingOptions, SetFiles, WantedOptions,
};
use osim_requests::{
    Acceleration, Assignments, ConstantIndentation, ConvertRequest, Count, DesignRequest, Kilograms,
    Positive, RelativeIndentation, Request, RescaleRequest, RestitutionCoefficient, SetRequest,
    TransferRequest,
};

use crate::figures::{Figure, SphereFigures};
use crate::inspection::Inspection;
use crate::options::InspectOptions;

/// The preset whose contacts are proposed where a model's own make no sense.
const PROPOSED_PRESET: &str = "falisse2022";

/// What all remedies for one model share. A remedy is a request: it is asked like any other.
pub(super) struct Remedies<'m> {
    /// `None` for standard input, which cannot be read twice, for a model that is not changed as it is, and where something
    /// else has to be done first.
    model: Option<PathBuf>,
    load: Load,
    options: &'m InspectOptions,
    /// Some force gives spheres of different size or material one modulus, so that no design serves all of them; all numbers
    /// are multiplied then.
    joined: bool,
    /// How many spheres share the weight is the same for all limbs.
    counted: bool,
    /// What the model weighs is known.
    weighed: bool,
    /// What the bodies weigh, kg.
    body_kg: Option<f64>,
    /// No other force needs a sphere as it is.
    radii_may_change: bool,
    /// Forces that can be made one for each sphere, once they are looked for.
    divisible: OnceCell<HashSet<ForceId>>,
}

/// Whose weight is carried, and by how many spheres: what was said of it is said again.
struct Load {
    masses: MassOptions,
    counts: CountOptions,
    /// Gravity that the model's own file does not say.
    gravity: Option<Acceleration>,
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
        let mass = options.masses.model_kg.or(of_figures);
        let gravity = figures.gravity_m_s2.filter(|_| figures.gravity_m_s2 != inspected.gravity_m_s2);
        let said = |number: Option<f64>| number.and_then(|number| Count::new(number).ok());
        let load = Load {
            masses: MassOptions {
                mass: mass.and_then(|kg| Kilograms::new(kg).ok()),
                exclude_body: options.masses.exclude_bodies.clone(),
                ..MassOptions::default()
            },
            counts: CountOptions {
                spheres: said(stance.spheres),
                stance_limbs: said(Some(stance.limbs)).unwrap_or(Count::ONE),
            },
            gravity: gravity.and_then(|gravity| Acceleration::new(gravity).ok()),
        };
        let name = || FileName::from_parts(inspected.model.clone(), inspected.model_bytes.clone()).to_path();
        let model = (inspected.model != "-" && changes).then(name);
        let counted = inspected.spheres_per_limb.is_some() || stance.spheres.is_some();
        let weighed = inspected.figures.mass_kg.is_some();
        let body_kg = inspected.mass_kg;
        Self {
            model,
            load,
            options,
            joined,
            counted,
            weighed,
            body_kg,
            radii_may_change: true,
            divisible: OnceCell::new(),
        }
    }

    /// Without such as change radii, unless these `may_change`.
    pub(super) fn changing_radii(self, may_change: bool) -> Self {
        Self { radii_may_change: may_change, ..self }
    }

    /// Without remedies: something else has to be done first, after which they would be wrong.
    pub(super) fn unsettled(self) -> Self {
        Self { model: None, ..self }
    }

    /// The model that a remedy changes; `changes_radii` says whether radii are among what it writes.
    fn models(&self, changes_radii: bool) -> Option<Vec<PathBuf>> {
        (!changes_radii || self.radii_may_change).then(|| self.model.clone().map(|model| vec![model]))?
    }

    /// The choice of forces that was made, again.
    fn choice(&self) -> ForceOptions {
        let Selection { select, exclude, skip_disabled, .. } = self.options.selection.clone();
        ForceOptions { select, exclude, skip_disabled }
    }

    fn set_files(&self) -> SetFiles {
        SetFiles { geometry: self.options.geometry.clone(), model: self.options.model.clone() }
    }

    /// A design of parameters, which needs no load.
    fn design(&self, wanted: WantedOptions) -> Option<DesignRequest> {
        let (choice, set_files) = (self.choice(), self.set_files());
        Some(DesignRequest {
            models: self.models(false)?,
            wanted,
            choice,
            set_files,
            ..DesignRequest::default()
        })
    }

    fn set(&self, assignments: Vec<(Property, Assignment)>) -> Option<SetRequest> {
        let changes_radii = assignments.iter().any(|(property, _)| *property == Property::Radius);
        Some(SetRequest {
            models: self.models(changes_radii)?,
            set: assignments.into_iter().collect::<Assignments>(),
            choice: self.choice(),
            set_files: self.set_files(),
            ..SetRequest::default()
        })
    }

    fn factor(&self, property: Property, factor: f64) -> Option<Request> {
        self.set(vec![(property, Assignment::Factor(factor))]).map(Request::from)
    }

    /// Brings x̂ down to the limit under `body_weights`; where the law is smoothed, its constant indentation with it.
    pub(super) fn indentation(&self, spheres: &[&SphereFigures], body_weights: f64) -> Option<Request> {
        let limit = limits::INDENTATION.value;
        if self.joined || !self.counted {
            // The sphere that sinks in most decides. x̂ follows E*^(-2/3) (11).
            let figure = if body_weights > 1.0 { Figure::IndentationAtTwo } else { Figure::Indentation };
            let deepest = spheres.iter().filter_map(|sphere| sphere.value(figure)).fold(0.0, f64::max);
            let factor = (deepest / limit).powf(1.5);
            return self.factor(Property::Stiffness, (factor * 1e3).ceil() / 1e3);
        }
        let smooth = spheres.iter().any(|sphere| sphere.value(Figure::ConstantIndentation).is_some());
        // x̂ at body weight once it is at the limit under the load asked for.
        let x_hat = limit / body_weights.powf(2.0 / 3.0);
        let constant = smooth.then(|| constant_indentation_below(x_hat));
        let wanted = WantedOptions {
            indentation: Some(RelativeIndentation::new(limit).ok()?),
            constant_indentation: constant.map(ConstantIndentation::new).transpose().ok()?,
            ..WantedOptions::default()
        };
        let body_weights = Some(body_weights).filter(|&weights| weights != 1.0);
        let load = LoadOptions {
            body_weights: body_weights.map(Positive::new).transpose().ok()?,
            gravity: self.load.gravity,
            ..LoadOptions::default()
        };
        let (masses, counts) = (self.load.masses.clone(), self.load.counts.clone());
        Some(DesignRequest { load, masses, counts, ..self.design(wanted)? }.into())
    }

    /// Brings the restitution up to the limit, from the largest dissipation that is there.
    pub(super) fn restitution(&self, impact_speed_m_s: f64, dissipation_s_m: f64) -> Option<Request> {
        let limit = limits::RESTITUTION.value;
        if self.joined {
            let factor = (1.0 - limit) / impact_speed_m_s / dissipation_s_m;
            return self.factor(Property::Dissipation, two_digits_below(factor));
        }
        let wanted = WantedOptions {
            restitution: Some(RestitutionCoefficient::new(limit).ok()?),
            impact_speed: Some(Positive::new((impact_speed_m_s * 1e4).ceil() / 1e4).ok()?),
            ..WantedOptions::default()
        };
        self.design(wanted).map(Request::from)
    }

    /// One force for each sphere of `force`; of all forces, where all can be divided and nobody chose among them.
    pub(super) fn one_sphere_each(&self, model: &Model, force: &Force) -> Option<Request> {
        let models = self.models(false)?;
        let divisible = self.divisible.get_or_init(|| divisible(model));
        if !divisible.contains(&force.id) {
            return None;
        }
        let all = self.options.selection == Selection::default() && divisible.len() == model.forces().len();
        let select = if all { Vec::new() } else { vec![exactly(&force.name)?] };
        let choice = ForceOptions { select, ..ForceOptions::default() };
        let to = ClassChoice::of(ForceKind::HuntCrossley);
        Some(ConvertRequest { models, to, choice, ..ConvertRequest::default() }.into())
    }

    pub(super) fn constant_indentation(&self, constant_indentation: f64) -> Option<Request> {
        let constant_indentation = Some(ConstantIndentation::new(constant_indentation).ok()?);
        self.design(WantedOptions { constant_indentation, ..WantedOptions::default() }).map(Request::from)
    }

    pub(super) fn transition(&self) -> Option<Request> {
        let state_width = Some(Positive::new(limits::SUGGESTED_TRANSITION_WIDTH).ok()?);
        self.design(WantedOptions { state_width, ..WantedOptions::default() }).map(Request::from)
    }

    /// Brings the force just touching down to a tenth of the share of the weight.
    pub(super) fn touching(&self, spheres: &[&SphereFigures]) -> Option<Request> {
        self.constant_indentation(touching_indentation(spheres)?)
    }

    /// Brings spheres that float to the floor. Where contact sets in over a long way that has to be shorter, too: far above
    /// the floor the force of (C.1) is large again.
    pub(super) fn floating(&self, spheres: &[&SphereFigures]) -> Option<Request> {
        let wide = spheres.iter().any(|sphere| sphere.is_within(Figure::TransitionWidth) == Some(false));
        let width = wide.then_some(limits::SUGGESTED_TRANSITION_WIDTH);
        let wanted = WantedOptions {
            constant_indentation: Some(ConstantIndentation::new(touching_indentation(spheres)?).ok()?),
            state_width: width.map(Positive::new).transpose().ok()?,
            ..WantedOptions::default()
        };
        self.design(wanted).map(Request::from)
    }

    /// Scales contacts that were made for another body to this one.
    pub(super) fn rescale(&self, contacts_mass_kg: f64, target_mass_kg: f64) -> Option<Request> {
        let contacts_mass = Some(Kilograms::new(rounded(contacts_mass_kg)).ok()?);
        Some(
            RescaleRequest {
                models: self.models(true)?,
                target_mass: Some(Kilograms::new(rounded(target_mass_kg)).ok()?),
                masses: MassOptions { contacts_mass, ..MassOptions::default() },
                choice: self.choice(),
                set_files: self.set_files(),
                ..RescaleRequest::default()
            }
            .into(),
        )
    }

    /// The model's own contacts at the mass of its body, on spheres that follow it by the sizes in the note.
    pub(super) fn follow_by_note(&self, model: &Model) -> Option<Request> {
        let since = model.scaled_since_note().filter(|_| model.doubt_about_note().is_none())?;
        if !since.has_all_carriers(model) {
            return None;
        }
        // What the model weighs otherwise is for the user to say.
        let target_mass_kg = rounded(self.body_kg.filter(|_| self.load.masses.mass.is_none())?);
        // A rescaling since then may have changed radii, and bottoms with them.
        let untouched = model.note.as_ref().is_some_and(|note| note.operation == Verb::Note.name());
        let level = untouched && !since.factors.values().any(|factors| is_stretched(*factors));
        Some(
            RescaleRequest {
                models: self.models(true)?,
                target_mass: Some(Kilograms::new(target_mass_kg).ok()?),
                follow_bodies: true,
                scaling: ScalingOptions { level, ..ScalingOptions::default() },
                masses: self.load.masses.clone(),
                choice: self.choice(),
                set_files: self.set_files(),
                ..RescaleRequest::default()
            }
            .into(),
        )
    }

    /// Contacts of another model or preset, under the load that was said.
    fn transfer(&self, from: PathBuf) -> Option<TransferRequest> {
        Some(TransferRequest {
            models: self.models(true)?,
            from: Some(from),
            masses: self.load.masses.clone(),
            counts: self.load.counts.clone(),
            choice: self.choice(),
            set_files: self.set_files(),
            ..TransferRequest::default()
        })
    }

    /// Contacts of the model that OpenSim scaled, on spheres that follow their bodies.
    pub(super) fn follow(&self, placement: &Placement) -> Option<Request> {
        if !placement.can_follow() {
            return None;
        }
        let follow = FollowOptions {
            follow_bodies: true,
            body_scale_file: placement.body_scale_file.clone(),
            moved_spheres: placement.has_resized().then_some(MovedChoice::Replace),
            ..FollowOptions::default()
        };
        let scaling = ScalingOptions { level: placement.suits_level, ..ScalingOptions::default() };
        Some(TransferRequest { follow, scaling, ..self.transfer(placement.from.clone())? }.into())
    }

    /// Contacts of a published model.
    pub(super) fn preset(&self) -> Option<Request> {
        // A transfer takes the model's own gravity.
        let own_gravity = self.load.gravity.is_none();
        let known = own_gravity && self.weighed && self.counted;
        known.then(|| self.transfer(PROPOSED_PRESET.into()).map(Request::from))?
    }

    /// Writes values into one force.
    pub(super) fn copy(&self, force: &str, values: &[(Property, f64)]) -> Option<Request> {
        let selection = &self.options.selection;
        // A value that nobody may set is no repair of the other side.
        let can_be_set = values.iter().all(|(property, value)| property.allows(*value));
        if !can_be_set || !selection.select.is_empty() {
            return None;
        }
        let assignments = values.iter().map(|(property, value)| (*property, Assignment::Value(*value)));
        let set = self.set(assignments.collect())?;
        let choice = ForceOptions { select: vec![exactly(force)?], ..self.choice() };
        Some(SetRequest { choice, ..set }.into())
    }
}

/// Spheres of one force that are compared with each other to propose a conversion.
const COMPARED: usize = 100;

/// The HuntCrossleyForces that `convert` makes one for each sphere of: in the model's own file, with one half-space, no sphere that
/// never meets it, and no spheres that touch each other.
fn divisible(model: &Model) -> HashSet<ForceId> {
    let document = model.document();
    if document.tree().name(document.data_root()) != "Model" {
        return HashSet::new();
    }
    let pose = DefaultPose::of(model);
    let can_be = |force: &&Force| {
        let planes: Vec<_> = force.sets.iter().flat_map(|set| model.half_spaces_of(set)).collect();
        let [plane] = planes.as_slice() else { return false };
        let mut spheres = force.spheres().into_iter().map(|id| model.sphere(id));
        let meets = |sphere: Option<&Sphere>| sphere.is_some_and(|one| !one.fixed && one.body != plane.body);
        force.kind == ForceKind::HuntCrossley
            && force.spheres().len() <= COMPARED
            && force.file == FileId::MAIN
            && spheres.all(meets)
            && sphere_pairs(model, &pose, force)
                .iter()
                .all(|pair| pair.gap_m.as_ref().is_ok_and(|gap| *gap > 0.0))
    };
    model.forces().iter().filter(can_be).map(|force| force.id).collect()
}

/// The pattern that only this name matches; `None` where its letters mean something in patterns.
fn exactly(name: &str) -> Option<Pattern> {
    let is_plain = !name.contains(['*', '?', '[', ']', '{', '}', '\\', '!']);
    if is_plain { name.parse().ok() } else { None }
}

/// In as many digits as people read.
fn rounded(kg: f64) -> f64 {
    readable(kg).parse().unwrap_or(kg)
}

/// √cf/R with which every sphere carries a tenth of its load while just touching.
fn touching_indentation(spheres: &[&SphereFigures]) -> Option<f64> {
    let least = spheres.iter().filter_map(|sphere| sphere.value(Figure::Indentation)).reduce(f64::min)?;
    Some(constant_indentation_below(least))
}

/// √cf/R with which a sphere that rests at x̂ carries a tenth of its load while just touching, rounded down.
///
/// ½ (x̂_c/x̂)^(3/2) ≤ 0.1, from (C.3) at x = 0 over (3).
fn constant_indentation_below(x_hat: f64) -> f64 {
    let most = x_hat * (2.0 * limits::TOUCHING_SHARE.value).powf(2.0 / 3.0);
    let most = most.min(limits::CONSTANT_INDENTATION.value);
    two_digits_below(most)
}

/// At most `value`, in two digits, without rounding error.
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

    #[test]
    fn two_digits_are_left_and_never_more_than_there_was() {
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
            assert_eq!(two_digits_below(value), expected, "{value}");
        }
    }

    #[test]
    fn a_constant_indentation_is_a_third_of_x_hat_as_the_tenth_wants_it() {
        // 0.2^(2/3) is 0.341995.
        assert_eq!(constant_indentation_below(0.16), 0.054);
        assert_eq!(constant_indentation_below(0.03), 0.01);
        // 0.3 · 0.341995 is 0.1026, above what the paper starts from.
        assert_eq!(constant_indentation_below(0.3), 0.1);
    }

    #[test]
    fn masses_are_rounded_to_what_people_read() {
        assert_eq!(rounded(90.123_456_789), 90.123_457);
        assert_eq!(rounded(0.0209), 0.0209);
    }
}
