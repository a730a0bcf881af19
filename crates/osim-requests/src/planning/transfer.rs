//! Contacts of another model or of a preset.

use std::path::{Path, PathBuf};

use contact_scaling::Ratios;
use osim_inspect::{LoadSharing, ReferenceState};
use osim_model::files::{Failure, Files};
use osim_model::wording::{Input, phrase};
use osim_model::{
    Anatomy, CountOf, Fault, GravityFor, MassRequest, Model, Needed, Property, Selected, Selection, mass_slip,
};
use osim_patch::{
    Factors, Follow, FollowRequest, OwnRadii, Plan, RadiusAxis, RadiusRule, Reference, ScalingRule,
    TRANSFER_FOLLOWING, Transfer, moving_spheres, transfer,
};
use osim_values::{Acceleration, Kilograms, Positive, Radius};
use serde_json::json;

use super::asking::Asking;
use super::operation::{operation, refuse_again};
use super::reference::{Generic, preset, reference_from_file};
use crate::fault::{RequestError, RequestFault};
use crate::options::{
    CountOptions, FollowOptions, InspectionOptions, RuleChoice, ScalingOptions, StanceOptions,
};
use crate::planner::{Change, Planner};
use crate::request::TransferRequest;

/// What was said of the reference, so that it counts for more than what its file says.
struct ReferenceSaid {
    spheres: bool,
    gravity: bool,
}

/// Spheres that share the weight, here and in the reference.
struct SphereCounts {
    here: f64,
    there: f64,
    /// Neither is known, only their ratio.
    cancel: bool,
}

struct Transferring {
    counts: CountOptions,
    follow: FollowOptions,
    scaling: ScalingOptions,
    reference_sphere: Option<String>,
    selection: Selection,
    masses: MassRequest,
    reference: Reference,
    /// The same as reports show it.
    state: ReferenceState,
    reference_said: ReferenceSaid,
    /// The generic model's bones and the Scale Tool's factors, where spheres follow their bodies.
    generic: Option<Generic>,
    may_repeat: bool,
    reads: Vec<PathBuf>,
    inspection: InspectionOptions,
    settings: String,
}

impl TransferRequest {
    /// Checks the request and reads the reference once, for all models.
    ///
    /// # Errors
    /// The reference is neither a preset nor a file, or a model that cannot be a reference; or options that say nothing.
    pub fn prepare(self, files: &dyn Files) -> Result<Change, RequestError> {
        check(&self)?;
        let Some(from) = self.from.clone() else {
            return Err(RequestFault::Missing { field: "from" }.into());
        };
        let named = preset(&self, &from, files)?;
        let is_file = named.is_none();
        let (mut reference, state, generic) = match named {
            Some(_) if self.follow.follow_bodies => {
                let message = phrase![
                    Input::FollowBodies,
                    " needs the generic model as ",
                    Input::From,
                    ", a preset has no bodies",
                ];
                return Err(RequestFault::refused(Input::FollowBodies, message).into());
            }
            Some((reference, state)) => {
                // A preset has no bodies to compare its mass with.
                let said = self.reference.reference_mass.map(Kilograms::get);
                let asks = said.and_then(|kg| mass_slip(Input::ReferenceMass, kg, None));
                let asked = self.answers.ask(asks);
                asked.map_err(|kind| Failure::outside(from.as_path(), kind.code(), kind.phrase()))?;
                (reference, state, None)
            }
            None => reference_from_file(&self, &from, files)?,
        };
        let gravity = self.reference.reference_gravity.map(Acceleration::get);
        reference.gravity_m_s2 = gravity.or(reference.gravity_m_s2);
        let settings = self.settings(is_file);
        let own = Some(from).filter(|_| is_file);
        let reads = own.into_iter().chain(self.presets).chain(self.follow.body_scale_file.clone()).collect();
        let stance = StanceOptions {
            spheres: self.counts.spheres,
            stance_limbs: self.counts.stance_limbs,
            impact_speed: None,
            gravity: None,
        };
        let planner = Transferring {
            counts: self.counts,
            follow: self.follow,
            scaling: self.scaling,
            reference_sphere: self.reference.reference_sphere,
            selection: self.choice.selection(),
            masses: self.masses.request(),
            reference,
            state,
            reference_said: ReferenceSaid {
                spheres: self.reference.reference_spheres.is_some(),
                gravity: gravity.is_some(),
            },
            generic,
            may_repeat: self.output.may_repeat(),
            reads,
            inspection: InspectionOptions::new(stance, self.masses, self.choice, self.set_files.clone()),
            settings,
        };
        let asking = Asking { masses: planner.masses.clone(), answers: self.answers, planner };
        Ok(Change::new(self.models, self.output, self.set_files, asking))
    }

    /// The reference is identified by its contents; a preset by its name, which means the same numbers in one version.
    fn settings(&self, is_file: bool) -> String {
        let Self { from, counts, reference, follow, masses, scaling, choice, .. } = self;
        let preset = from.as_ref().filter(|_| !is_file).map(|from| from.to_string_lossy());
        json!(["transfer", preset, counts, reference, follow, masses, scaling, choice]).to_string()
    }
}

fn is_standard_input(path: &Path) -> bool {
    path == Path::new("-")
}

fn check(request: &TransferRequest) -> Result<(), RequestFault> {
    if request.from.as_deref().is_some_and(is_standard_input)
        && request.models.iter().any(|path| is_standard_input(path))
    {
        let message =
            "standard input cannot be both the model and the reference: name a file for one of them";
        return Err(RequestFault::refused(Input::From, message));
    }
    if request.masses.contacts_mass.is_some() {
        let message = phrase![
            Input::ContactsMass,
            " says nothing here: the reference's mass is ",
            Input::ReferenceMass,
            ", this model's ",
            Input::Mass,
        ];
        return Err(RequestFault::refused(Input::ContactsMass, message));
    }
    if request.scaling.contacts_gravity.is_some() {
        let message = phrase![
            Input::ContactsGravity,
            " says nothing here: the reference's gravity is ",
            Input::ReferenceGravity,
            ", the one to scale to ",
            Input::TargetGravity,
        ];
        return Err(RequestFault::refused(Input::ContactsGravity, message));
    }
    if request.follow.rule == RuleChoice::Predsim {
        let gravities = [
            (Input::TargetGravity, request.scaling.target_gravity.is_some()),
            (Input::ReferenceGravity, request.reference.reference_gravity.is_some()),
        ];
        if let Some((input, _)) = gravities.into_iter().find(|(_, given)| *given) {
            let message =
                phrase![input, " says nothing with ", Input::Rule.being("predsim"), ", which has no gravity"];
            return Err(RequestFault::refused(input, message));
        }
    }
    check_radii(request)
}

/// Combinations of radii and places that say nothing.
fn check_radii(request: &TransferRequest) -> Result<(), RequestFault> {
    let (scaling, follow) = (&request.scaling, &request.follow);
    let rule = scaling.radius.map(Radius::rule);
    let stays =
        !scaling.properties().contains(Property::Radius) || matches!(rule, None | Some(RadiusRule::Keep));
    if scaling.level && !follow.follow_bodies && stays {
        let message = phrase![
            Input::Level,
            " says nothing here: radii stay, and bottoms with them; say other radii with ",
            Input::Radius.being("isometric"),
            " (or metres, or a factor), or move spheres with their bodies by ",
            Input::FollowBodies,
        ];
        return Err(RequestFault::refused(Input::Level, message));
    }
    if !follow.follow_bodies || rule.is_none() {
        return Ok(());
    }
    if matches!(rule, Some(RadiusRule::Factor(_))) {
        let message = phrase![
            "a factor of ",
            Input::Radius,
            " says nothing with ",
            Input::FollowBodies,
            ": radii follow the bodies, by ",
            Input::RadiusAxis,
            ", or are isometric, metres or kept",
        ];
        return Err(RequestFault::refused(Input::Radius, message));
    }
    if follow.radius_axis() != RadiusAxis::default() {
        let message = phrase![
            Input::RadiusAxis,
            " says nothing with ",
            Input::Radius,
            ": radii follow either from the factors of bodies or from that rule",
        ];
        return Err(RequestFault::refused(Input::RadiusAxis, message));
    }
    Ok(())
}

impl Planner for Transferring {
    fn name(&self) -> &'static str {
        "transfer"
    }

    fn inspection(&self) -> InspectionOptions {
        self.inspection.clone()
    }

    fn target_gravity_m_s2(&self) -> Option<f64> {
        self.scaling.target_gravity.map(Acceleration::get)
    }

    fn reference(&self) -> Option<&ReferenceState> {
        Some(&self.state)
    }

    fn settings(&self) -> String {
        self.settings.clone()
    }

    fn reads(&self) -> Vec<PathBuf> {
        self.reads.clone()
    }

    fn plan(&self, model: &Model) -> Result<Plan, Fault> {
        let selected = self.selection.apply(model)?;
        let (follow, mut warnings, mut remarks) = match &self.generic {
            Some(generic) => {
                let (follow, factors) = self.follow(model, &selected, generic)?;
                (Some(follow), factors.warnings, factors.remarks)
            }
            None => (None, Vec::new(), Vec::new()),
        };
        let counts = self.sphere_counts(model, &selected)?;
        let radius = self.scaling.radius.map(Radius::rule);
        let verb = if follow.is_some() { TRANSFER_FOLLOWING } else { "transfer" };
        let operation = operation(verb, radius);
        if matches!(radius, Some(RadiusRule::Factor(_))) {
            refuse_again(model, &operation, self.may_repeat)?;
        }
        let mass = self.masses.of_model(model)?;
        warnings.extend(self.masses.disagreements_of_weight(model, &mass));
        let mut wanted = Transfer::new(self.reference.clone(), mass, counts.here);
        wanted.reference.sphere_count = counts.there;
        wanted.counts_cancel = counts.cancel;
        wanted.reference_sphere.clone_from(&self.reference_sphere);
        wanted.radius = radius.unwrap_or(RadiusRule::Keep);
        wanted.properties = self.scaling.properties();
        wanted.dissipation_by = self.scaling.dissipation();
        wanted.target_gravity_m_s2 = self.target_gravity(model)?;
        wanted.rule = self.rule(follow.as_ref())?;
        wanted.level = self.scaling.level_axis(model.gravity_m_s2);
        wanted.follow = follow;
        wanted.strict = self.follow.strict;
        let mut plan = transfer(model, &selected, &wanted)?;
        plan.name_operation(&operation);
        plan.warnings.append(&mut warnings);
        plan.remarks.append(&mut remarks);
        Ok(plan)
    }
}

impl Transferring {
    fn follow(
        &self,
        model: &Model,
        selected: &Selected,
        generic: &Generic,
    ) -> Result<(Follow, Factors), Fault> {
        let scaled = Anatomy::of(model)?;
        let factors = Factors::find(&scaled, &generic.anatomy, generic.file.as_ref(), &self.follow.given())?;
        let mut wanted = FollowRequest::default();
        wanted.radius_axis = self.follow.radius_axis();
        wanted.level = self.scaling.level_axis(model.gravity_m_s2);
        wanted.moved = self.follow.moved();
        let rule = self.scaling.radius.map(Radius::rule);
        wanted.keep_radii =
            !self.scaling.properties().contains(Property::Radius) || rule == Some(RadiusRule::Keep);
        wanted.own_radii = match rule {
            Some(RadiusRule::Metres(metres)) => Some(OwnRadii::Metres(metres)),
            Some(RadiusRule::Isometric) => {
                let ratio = self.masses.of_model(model)?.kg / self.reference.mass.kg;
                Some(OwnRadii::Isometric(Ratios::isometric(ratio).map_err(Fault::new)?.radius()))
            }
            _ => None,
        };
        Follow::refuse_missing(&scaled, self.reference.contacts.iter().flat_map(|contact| &contact.spheres))?;
        let spheres = moving_spheres(model, &selected.forces);
        let follow = Follow::find(model, &spheres, &scaled, &generic.anatomy, &factors, &wanted)?;
        Ok((follow, factors))
    }

    /// Spheres that share the weight, here and in the reference. Where each sphere has its own there, one of the two counts says
    /// the other, and without either they cancel.
    fn sphere_counts(&self, model: &Model, selected: &Selected) -> Result<SphereCounts, Fault> {
        let limbs = self.counts.stance_limbs();
        let here =
            LoadSharing::of(model, &selected.forces).count(self.counts.spheres(), limbs, CountOf::Model);
        let there = match &self.generic {
            Some(generic) => generic.sphere_count.clone(),
            None => Ok(self.reference.sphere_count),
        };
        let nothing_said = self.counts.spheres.is_none() && !self.reference_said.spheres;
        let alike = nothing_said && self.generic.as_ref().is_some_and(|generic| generic.stands_like(model));
        match (here, there) {
            (Ok(here), Ok(there)) => Ok(SphereCounts { here, there, cancel: false }),
            (Ok(here), Err(_)) if alike => Ok(SphereCounts { here, there: here / limbs, cancel: false }),
            (Err(_), Ok(there)) if alike => Ok(SphereCounts { here: there * limbs, there, cancel: false }),
            (Err(_), Err(_)) if alike => Ok(SphereCounts { here: limbs, there: 1.0, cancel: true }),
            (Err(fault), _) | (_, Err(fault)) => Err(fault),
        }
    }

    /// Gravity that the contacts are scaled to. Naming the reference's asks for the model's own, where no other is named.
    fn target_gravity(&self, model: &Model) -> Result<Option<f64>, Fault> {
        let asked = self.reference_said.gravity && self.follow.rule == RuleChoice::Paper;
        match (self.target_gravity_m_s2(), model.gravity().filter(|&gravity| gravity > 0.0)) {
            (None, None) if asked => Err(Fault::new(Needed::Gravity { purpose: GravityFor::Target })),
            (None, own) if asked => Ok(own),
            (target, _) => Ok(target),
        }
    }

    fn rule(&self, follow: Option<&Follow>) -> Result<ScalingRule, Fault> {
        if self.follow.rule == RuleChoice::Paper {
            return Ok(ScalingRule::Paper);
        }
        let given = self.follow.height_ratio.map(Positive::get);
        match given.or(follow.map(|follow| follow.size_ratio)) {
            Some(height_ratio) => Ok(ScalingRule::PredSim { height_ratio }),
            None => Err(Fault::new(Needed::HeightRatio)),
        }
    }
}
