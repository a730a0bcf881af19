//! Contacts of another model or of a preset: requests, and their plans.

use std::path::Path;

use contact_scaling::Ratios;
use osim_inspect::LoadSharing;
use osim_model::compare::{Factors, Follow, FollowRequest, OwnRadii};
use osim_model::files::{Failure, Files};
use osim_model::messages::{Input, Verb, phrase};
use osim_model::{
    Anatomy, CountedSpheres, Fault, GravityFor, MassRequest, Model, Needed, Property, RadiusAxis, RadiusRule,
    Selected, Selection, implausible_mass, moving_spheres,
};
use osim_patch::{Plan, Reference, ScalingRule, TRANSFER_FOLLOWING, Transfer, transfer};
use osim_requests::options::{CountOptions, FollowOptions, InspectionOptions, RuleChoice, ScalingOptions};
use osim_requests::{Acceleration, Kilograms, Positive, Radius, RequestError, RequestFault, TransferRequest};

use super::reference::{Generic, KnownMass, of_opened, of_preset, reference_from_file};
use crate::opening::Named;
use crate::planner::{Change, Planner};
use crate::remarks::{noted_limbs, operation, refuse_again};

/// Checks the request and reads the reference once, for all models.
///
/// # Errors
/// The reference is neither a preset nor a file, or a model that cannot be a reference; or options that say nothing.
pub(super) fn prepare(request: TransferRequest, files: &dyn Files) -> Result<Change, RequestError> {
    check(&request)?;
    let Some(from) = request.from.clone() else {
        return Err(RequestFault::Missing { field: "from" }.into());
    };
    let named = Named::find(&from, Some(Input::From), request.presets.as_deref(), files)?;
    let is_file = matches!(named, Named::File);
    if !is_file && request.follow.follow_bodies {
        let message = phrase![
            Input::FollowBodies,
            " needs the generic model as ",
            Input::From,
            ", a preset has no bodies"
        ];
        return Err(RequestFault::refused(Input::FollowBodies, message).into());
    }
    let (reference, state, generic) = match named {
        Named::Preset(preset) => {
            // A preset has no bodies to compare its mass with.
            let said = request.reference.reference_mass.map(Kilograms::get);
            let asks = said.and_then(|kg| implausible_mass(Input::ReferenceMass, kg, None));
            let asked = request.answers.ask(asks);
            asked.map_err(|kind| Failure::outside(from.as_path(), kind.code(), kind.phrase()))?;
            let (reference, state) = of_preset(&request, &preset);
            (reference, state, None)
        }
        Named::Placed(open) => of_opened(&request, &from, &open, KnownMass::Asked, files)?,
        Named::File => reference_from_file(&request, &from, files)?,
    };
    let own = request.from.iter().filter(|_| is_file);
    let reads = own.chain(&request.presets).chain(&request.follow.body_scale_file).cloned().collect();
    let TransferRequest { models, output, masses, choice, set_files, answers, .. } = request.clone();
    let stance = request.counts.stance_options(None, None);
    let inspection = InspectionOptions { stance, masses, choice, set_files, answers };
    Ok(Change {
        reference: Some(state),
        target_gravity_m_s2: request.scaling.target_gravity.map(Acceleration::get),
        reads,
        ..Change::new(Verb::Transfer, models, output, inspection, planner(request, reference, generic))
    })
}

/// What plans for each model, with a reference that was read: from a file, or a preset.
pub(super) fn planner(
    request: TransferRequest,
    mut reference: Reference,
    generic: Option<Generic>,
) -> Transferring {
    let gravity = request.reference.reference_gravity.map(Acceleration::get);
    reference.gravity_m_s2 = gravity.or(reference.gravity_m_s2);
    Transferring {
        counts: request.counts,
        follow: request.follow,
        scaling: request.scaling,
        reference_sphere: request.reference.reference_sphere,
        selection: request.choice.selection(),
        masses: request.masses.request(),
        reference,
        reference_said: ReferenceSaid {
            spheres: request.reference.reference_spheres.is_some(),
            gravity: gravity.is_some(),
        },
        generic,
        may_repeat: request.output.may_repeat(),
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
            let message = phrase![
                input,
                " says nothing with ",
                Input::Rule.with_value("predsim"),
                ", which has no gravity"
            ];
            return Err(RequestFault::refused(input, message));
        }
    }
    check_radii(request)
}

/// Combinations of radii and places that have no meaning.
fn check_radii(request: &TransferRequest) -> Result<(), RequestFault> {
    let (scaling, follow) = (&request.scaling, &request.follow);
    let rule = scaling.radius.map(Radius::rule);
    let stays =
        !scaling.properties().contains(Property::Radius) || matches!(rule, None | Some(RadiusRule::Keep));
    if scaling.level && !follow.follow_bodies && stays {
        let message = phrase![
            Input::Level,
            " says nothing here: radii stay, and bottoms with them; say other radii with ",
            Input::Radius.with_value("isometric"),
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

// Plans of contacts that come from a reference.

/// What the caller gave about the reference: it counts for more than what its file says.
pub(super) struct ReferenceSaid {
    pub(super) spheres: bool,
    pub(super) gravity: bool,
}

/// Spheres that share the weight, here and in the reference.
struct SphereCounts {
    here: f64,
    there: f64,
    /// Whether neither is known, only their ratio.
    cancel: bool,
}

/// Plans transfers whose reference was read once for all models.
pub(super) struct Transferring {
    pub(super) counts: CountOptions,
    pub(super) follow: FollowOptions,
    pub(super) scaling: ScalingOptions,
    pub(super) reference_sphere: Option<String>,
    pub(super) selection: Selection,
    pub(super) masses: MassRequest,
    pub(super) reference: Reference,
    reference_said: ReferenceSaid,
    /// The generic model's bones and the Scale Tool's factors, where spheres follow their bodies.
    pub(super) generic: Option<Generic>,
    pub(super) may_repeat: bool,
}

impl Planner for Transferring {
    fn plan(&self, model: &Model) -> Result<Plan, Fault> {
        let selected = self.selection.apply(model)?;
        self.plan_from(model, &selected, &self.reference, self.generic.as_ref())
    }
}

impl Transferring {
    /// Plans the contacts of `reference` for the forces `selected` of `model`, whose spheres follow their bodies from those of
    /// `generic` where there is one.
    ///
    /// # Errors
    /// Those of [`transfer`], and what only the caller can know.
    pub(super) fn plan_from(
        &self,
        model: &Model,
        selected: &Selected,
        reference: &Reference,
        generic: Option<&Generic>,
    ) -> Result<Plan, Fault> {
        let (follow, mut warnings, mut remarks) = match generic {
            Some(generic) => {
                let (follow, factors) = self.follow(model, selected, reference, generic)?;
                (Some(follow), factors.warnings, factors.remarks)
            }
            None => (None, Vec::new(), Vec::new()),
        };
        let counts = self.sphere_counts(model, selected, reference, generic)?;
        let radius = self.scaling.radius.map(Radius::rule);
        let verb = if follow.is_some() { TRANSFER_FOLLOWING } else { "transfer" };
        let operation = operation(verb, radius);
        if matches!(radius, Some(RadiusRule::Factor(_))) {
            refuse_again(model, &operation, self.may_repeat)?;
        }
        let target_mass = self.masses.model_mass(model)?;
        warnings.extend(self.masses.weight_disagreements(model, &target_mass));
        let mut wanted = Transfer::new(reference.clone(), target_mass, counts.here);
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
        let mut plan = transfer(model, selected, &wanted)?;
        plan.name_operation(&operation);
        plan.warnings.append(&mut warnings);
        plan.remarks.append(&mut remarks);
        plan.remarks.extend(noted_limbs(&self.counts, model));
        Ok(plan)
    }

    fn follow(
        &self,
        model: &Model,
        selected: &Selected,
        reference: &Reference,
        generic: &Generic,
    ) -> Result<(Follow, Factors), Fault> {
        let scaled = Anatomy::of(model)?;
        let factors = Factors::find(&scaled, &generic.anatomy, generic.file.as_ref(), &self.follow.given())?;
        let mut wanted = FollowRequest {
            radius_axis: self.follow.radius_axis(),
            level: self.scaling.level_axis(model.gravity_m_s2),
            moved: self.follow.moved(),
            ..FollowRequest::default()
        };
        let rule = self.scaling.radius.map(Radius::rule);
        wanted.keep_radii =
            !self.scaling.properties().contains(Property::Radius) || rule == Some(RadiusRule::Keep);
        wanted.own_radii = match rule {
            Some(RadiusRule::Metres(metres)) => Some(OwnRadii::Metres(metres)),
            Some(RadiusRule::Isometric) => {
                let ratio = self.masses.model_mass(model)?.kg / reference.mass.kg;
                Some(OwnRadii::Isometric(Ratios::isometric(ratio).map_err(Fault::new)?.radius()))
            }
            _ => None,
        };
        Follow::refuse_missing(&scaled, reference.contacts.iter().flat_map(|contact| &contact.spheres))?;
        let spheres = moving_spheres(model, &selected.forces);
        let follow = Follow::find(model, &spheres, &scaled, &generic.anatomy, &factors, &wanted)?;
        Ok((follow, factors))
    }

    /// Spheres that share the weight, here and in the reference. Where each sphere has its own there, one of the two counts says
    /// the other, and without either they cancel.
    fn sphere_counts(
        &self,
        model: &Model,
        selected: &Selected,
        reference: &Reference,
        generic: Option<&Generic>,
    ) -> Result<SphereCounts, Fault> {
        let limbs = self.counts.stance_limbs(model.noted_stance_limbs());
        let here = LoadSharing::of(model, &selected.forces).count(
            self.counts.spheres(),
            limbs,
            CountedSpheres::Model,
        );
        let there = match generic {
            Some(generic) => generic.sphere_count.clone(),
            None => Ok(reference.sphere_count),
        };
        let nothing_said = self.counts.spheres.is_none() && !self.reference_said.spheres;
        let alike = nothing_said && generic.is_some_and(|generic| generic.stands_like(model));
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
        let target = self.scaling.target_gravity.map(Acceleration::get);
        match (target, model.gravity().filter(|&gravity| gravity > 0.0)) {
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
