//! The verb `transfer`: gives a model the contacts of another model or of a preset.

use std::path::Path;

use contact_scaling::Ratios;
use osim_inspect::{LoadSharing, SignsOfScaling};
use osim_model::compare::{Factors, Follow, FollowRequest, OwnRadii, SpherePlacements};
use osim_model::files::{Failure, Files};
use osim_model::messages::{Input, Verb, phrase};
use osim_model::{
    Anatomy, CountedSpheres, Fault, GravityFor, MassRequest, MissingFact, Model, Property, RadiusRule,
    Selected, Selection, Suspicion, YesQuestion, implausible_mass, moving_spheres,
};
use osim_patch::{OPERATION_FOLLOWING_BODIES, Plan, Reference, ScalingRule, Transfer, transfer};
use osim_requests::options::{
    AnswerOptions, CountOptions, FollowOptions, InspectionOptions, RuleChoice, ScalingOptions,
};
use osim_requests::{Acceleration, Kilograms, Positive, Radius, RequestFault, Result, TransferRequest};

use super::reference::{
    GenericModel, MassOfPublished, reference_from_file, reference_of_opened, reference_of_preset,
};
use crate::opening::NamedSource;
use crate::prepared_change::{Planner, PreparedChange};
use crate::remarks::{level_axis, operation_with_radius, refuse_repetition, remark_on_limbs, up_axis};

/// Checks the request and reads the reference once for all models.
///
/// # Errors
/// The reference is neither a preset nor a file, or a model that cannot be a reference; or options have no effect.
pub(super) fn prepare(mut request: TransferRequest, files: &dyn Files) -> Result<PreparedChange> {
    refuse_useless_options(&request)?;
    let keeps_bottoms = choose_default_radii(&mut request);
    let from = request.from.clone().ok_or(RequestFault::Missing { field: "from" })?;
    let named = NamedSource::find(&from, Some(Input::From), request.presets.as_deref(), files)?;
    let is_file = matches!(named, NamedSource::File);
    if !is_file && request.follow.follow_bodies {
        let message = phrase![
            "{} needs the generic model as {}, a preset has no bodies";
            Input::FollowBodies, Input::From
        ];
        return Err(RequestFault::refused(Input::FollowBodies, message).into());
    }
    let (reference, state, generic) = match named {
        NamedSource::Preset(preset) => {
            // A preset has no bodies to compare its mass with.
            let given_mass = request.reference.reference_mass.map(Kilograms::get);
            let doubt = given_mass.and_then(|kg| implausible_mass(Input::ReferenceMass, kg, None));
            let asked = request.answers.require_yes(doubt);
            asked.map_err(|kind| Failure::outside(from.as_path(), kind.code(), kind.phrase()))?;
            let (reference, state) = reference_of_preset(&request, &preset);
            (reference, state, None)
        }
        NamedSource::PlacedPreset(open) => {
            reference_of_opened(&request, &from, &open, MassOfPublished::AskCaller, files)?
        }
        NamedSource::File => reference_from_file(&request, &from, files)?,
    };
    let file_of_reference = request.from.iter().filter(|_| is_file);
    let extra_files =
        file_of_reference.chain(&request.presets).chain(&request.follow.body_scale_file).cloned().collect();
    let TransferRequest { models, output, masses, choice, set_files, answers, .. } = request.clone();
    let stance = request.counts.stance_options(None, None);
    let inspection = InspectionOptions { stance, masses, choice, set_files, answers };
    let target_gravity_m_s2 = request.scaling.target_gravity.map(Acceleration::get);
    let original = generic.as_ref().filter(|_| is_file).map(|generic| generic.anatomy.clone());
    let planner = TransferPlanner { keeps_bottoms, original, ..planner(request, reference, generic) };
    Ok(PreparedChange {
        reference: Some(state),
        target_gravity_m_s2,
        extra_files,
        ..PreparedChange::new(Verb::Transfer, models, output, inspection, planner)
    })
}

/// Chooses radii by mass for spheres that follow their bodies, if the request names no other rule. Returns whether the radii are by mass,
/// so that the lowest point of each sphere stays on the scaled sole.
fn choose_default_radii(request: &mut TransferRequest) -> bool {
    let TransferRequest { follow, scaling, .. } = request;
    let can_change = follow.follow_bodies && scaling.properties().contains(Property::Radius);
    if !can_change || follow.rule != RuleChoice::Paper || follow.radius_axis.is_some() {
        return false;
    }
    let radius = scaling.radius.get_or_insert(Radius::from(RadiusRule::Isometric));
    radius.rule() == Some(RadiusRule::Isometric)
}

/// Makes the planner of a transfer from a reference that was read.
pub(super) fn planner(
    request: TransferRequest,
    mut reference: Reference,
    generic: Option<GenericModel>,
) -> TransferPlanner {
    let gravity = request.reference.reference_gravity.map(Acceleration::get);
    reference.gravity_m_s2 = gravity.or(reference.gravity_m_s2);
    let follows = request.follow.follow_bodies;
    TransferPlanner {
        counts: request.counts,
        follow: request.follow,
        scaling: request.scaling,
        reference_sphere: request.reference.reference_sphere,
        selection: request.choice.selection(),
        masses: request.masses.request(),
        reference,
        has_reference_spheres: request.reference.reference_spheres.is_some(),
        has_reference_gravity: gravity.is_some(),
        generic: generic.filter(|_| follows),
        original: None,
        answers: request.answers,
        keeps_bottoms: false,
        may_repeat: request.output.may_repeat(),
    }
}

/// Whether a path means standard input.
fn is_standard_input(path: &Path) -> bool {
    path == Path::new("-")
}

/// Refuses options that have no effect in this request.
fn refuse_useless_options(request: &TransferRequest) -> Result<(), RequestFault> {
    if request.from.as_deref().is_some_and(is_standard_input)
        && request.models.iter().any(|path| is_standard_input(path))
    {
        let message =
            "standard input cannot be both the model and the reference: name a file for one of them";
        return Err(RequestFault::refused(Input::From, message));
    }
    if request.masses.contacts_mass.is_some() {
        let message = phrase![
            "{} has no effect here: the reference's mass is {}, this model's {}";
            Input::ContactsMass, Input::ReferenceMass, Input::Mass
        ];
        return Err(RequestFault::refused(Input::ContactsMass, message));
    }
    if request.scaling.contacts_gravity.is_some() {
        let message = phrase![
            "{} has no effect here: the reference's gravity is {}, the one to scale to {}";
            Input::ContactsGravity, Input::ReferenceGravity, Input::TargetGravity
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
                "{} has no effect with {}, which has no gravity";
                input, Input::Rule.with_value("predsim")
            ];
            return Err(RequestFault::refused(input, message));
        }
    }
    refuse_senseless_radii(request)
}

/// Refuses combinations of options for radii and places that make no sense.
fn refuse_senseless_radii(request: &TransferRequest) -> Result<(), RequestFault> {
    let (scaling, follow) = (&request.scaling, &request.follow);
    if !follow.follow_bodies {
        scaling.refuse_radii_of_bodies()?;
    }
    let rule = scaling.radius();
    let stays =
        !scaling.properties().contains(Property::Radius) || matches!(rule, None | Some(RadiusRule::Keep));
    if scaling.level && !follow.follow_bodies && stays {
        let message = phrase![
            "{} has no effect here: radii stay, and the lowest points with them; give other radii with {} (or \
            metres, or a factor), or move spheres with their bodies by {}";
            Input::Level, Input::Radius.with_value("isometric"), Input::FollowBodies
        ];
        return Err(RequestFault::refused(Input::Level, message));
    }
    if !follow.follow_bodies || rule.is_none() {
        return Ok(());
    }
    if matches!(rule, Some(RadiusRule::Factor(_))) {
        let message = phrase![
            "a factor of {} has no effect with {}: radii follow the bodies, by {}, or are isometric, metres or kept";
            Input::Radius, Input::FollowBodies, Input::RadiusAxis
        ];
        return Err(RequestFault::refused(Input::Radius, message));
    }
    if follow.radius_axis.is_some() {
        let message = phrase![
            "{} has no effect with {}: radii follow either from the factors of bodies or from that rule";
            Input::RadiusAxis, Input::Radius
        ];
        return Err(RequestFault::refused(Input::RadiusAxis, message));
    }
    Ok(())
}

/// Whether spheres of `model` are where the `original` has them, although its bodies have another size.
fn are_left_behind(model: &Model, original: &Anatomy) -> bool {
    SpherePlacements::compare(model, Path::new(""), None, original, None, None).was_left_behind()
}

/// Plans the contacts of a reference, scaled to the size of the model.
pub(super) struct TransferPlanner {
    pub(super) counts: CountOptions,
    pub(super) follow: FollowOptions,
    pub(super) scaling: ScalingOptions,
    pub(super) reference_sphere: Option<String>,
    pub(super) selection: Selection,
    pub(super) masses: MassRequest,
    pub(super) reference: Reference,
    /// Whether the caller gave the number of spheres that share the weight in the reference.
    has_reference_spheres: bool,
    /// Whether the caller gave the gravity of the reference.
    has_reference_gravity: bool,
    /// The generic model, if spheres follow their bodies.
    pub(super) generic: Option<GenericModel>,
    /// The skeleton of the reference, if it is a file.
    original: Option<Anatomy>,
    answers: AnswerOptions,
    /// Whether the lowest points of round spheres stay on the scaled soles although the caller did not ask for it.
    keeps_bottoms: bool,
    pub(super) may_repeat: bool,
}

impl Planner for TransferPlanner {
    fn plan(&self, model: &Model) -> Result<Plan, Fault> {
        let selected = self.selection.apply(model)?;
        self.plan_with_reference(model, &selected, &self.reference, self.generic.as_ref())
    }
}

impl TransferPlanner {
    /// Plans the contacts of `reference` for the forces `selected` of `model`. If `generic` is given, the spheres follow their bodies from
    /// their places in the generic model.
    ///
    /// # Errors
    /// Those of [`transfer`], and questions that only the caller can answer.
    pub(super) fn plan_with_reference(
        &self,
        model: &Model,
        selected: &Selected,
        reference: &Reference,
        generic: Option<&GenericModel>,
    ) -> Result<Plan, Fault> {
        let why = |other: &GenericModel| SignsOfScaling::of(model, &self.masses).why_exchanged(other.signs);
        let exchanged = self.original.as_ref().and(generic).and_then(why);
        let original = self.original.as_ref().filter(|_| generic.is_none() || exchanged.is_some());
        let stayed = original.is_some_and(|original| are_left_behind(model, original));
        if let Some(why) = exchanged.filter(|_| stayed) {
            let doubt = Suspicion::Other { question: YesQuestion::WrongAfterwards, text: why.into() };
            self.answers.require_yes(Some(doubt)).map_err(Fault::new)?;
        }
        let followed = |generic| self.followed_spheres(model, selected, reference, generic);
        let (follow, factors) = generic.map(followed).transpose()?.unzip();
        let Factors { mut findings, mut remarks, .. } = factors.unwrap_or_default();
        let (in_model, in_reference, only_ratio_known) =
            self.sphere_counts(model, selected, reference, generic)?;
        let radius = self.scaling.radius();
        let verb = if follow.is_some() { OPERATION_FOLLOWING_BODIES } else { "transfer" };
        let operation = operation_with_radius(verb, radius);
        if matches!(radius, Some(RadiusRule::Factor(_))) {
            refuse_repetition(model, &operation, self.may_repeat)?;
        }
        let target_mass = self.masses.model_mass(model)?;
        let mut wanted = Transfer::new(reference.clone(), target_mass, in_model);
        wanted.reference.sphere_count = in_reference;
        wanted.counts_cancel = only_ratio_known;
        wanted.reference_sphere.clone_from(&self.reference_sphere);
        wanted.radius = radius.unwrap_or(RadiusRule::Keep);
        wanted.properties = self.scaling.properties();
        wanted.dissipation_by = self.scaling.dissipation();
        wanted.target_gravity_m_s2 = self.target_gravity(model)?;
        wanted.rule = self.scaling_rule(follow.as_ref())?;
        wanted.level = level_axis(&self.scaling, model)?;
        wanted.follow = follow;
        let lengths = generic.and_then(|generic| model.joint_distances().ratio_to(&generic.bones));
        wanted.length_ratio = lengths.map(|(ratio, _)| ratio);
        wanted.strict = self.follow.strict;
        let mut plan = transfer(model, selected, &wanted)?;
        plan.name_operation(&operation);
        plan.findings.append(&mut findings);
        plan.remarks.append(&mut remarks);
        let forces = generic.is_none().then_some(selected.forces.as_slice());
        plan.remarks.extend(remark_on_limbs(&self.counts, model, forces));
        if stayed && generic.is_none() {
            plan.remarks.push(phrase![
                "the spheres are where the reference has them, and the bones have another size: if this model was \
                scaled from the reference, move the spheres with {} and {}";
                Input::FollowBodies, Input::Level
            ]);
        }
        Ok(plan)
    }

    /// The places and radii of spheres that follow their bodies from the generic model, and the scale factors.
    fn followed_spheres(
        &self,
        model: &Model,
        selected: &Selected,
        reference: &Reference,
        generic: &GenericModel,
    ) -> Result<(Follow, Factors), Fault> {
        let scaled = Anatomy::of(model)?;
        let factors =
            Factors::find(&scaled, &generic.anatomy, generic.file.as_ref(), &self.follow.factors())?;
        let asked = level_axis(&self.scaling, model)?;
        let kept = (asked.is_none() && self.keeps_bottoms).then(|| up_axis(model)).transpose()?;
        let mut wanted = FollowRequest {
            radius_axis: self.follow.radius_axis(),
            level: asked.or(kept),
            spares_ellipsoids: asked.is_none(),
            moved: self.follow.rule_for_moved_spheres(),
            ..FollowRequest::default()
        };
        let rule = self.scaling.radius();
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

    /// The numbers of spheres that share the weight, in the model and in the reference, and whether only their ratio is known. If the
    /// spheres of model and reference have the same names, one number gives the other; if both numbers are unknown, their ratio is known.
    fn sphere_counts(
        &self,
        model: &Model,
        selected: &Selected,
        reference: &Reference,
        generic: Option<&GenericModel>,
    ) -> Result<(f64, f64, bool), Fault> {
        let limbs = self.counts.stance_limbs(model.noted_stance_limbs());
        let sharing = LoadSharing::of(model, &selected.forces);
        let in_model = sharing.count(self.counts.spheres(), limbs, CountedSpheres::Model);
        let in_reference = generic.map_or(Ok(reference.sphere_count), |generic| generic.sphere_count.clone());
        let no_counts_given = self.counts.spheres.is_none() && !self.has_reference_spheres;
        let alike =
            no_counts_given && generic.is_some_and(|generic| generic.has_same_standing_spheres(model));
        match (in_model, in_reference) {
            (Ok(in_model), Ok(in_reference)) => Ok((in_model, in_reference, false)),
            (Ok(in_model), Err(_)) if alike => Ok((in_model, in_model / limbs, false)),
            (Err(_), Ok(in_reference)) if alike => Ok((in_reference * limbs, in_reference, false)),
            (Err(_), Err(_)) if alike => Ok((limbs, 1.0, true)),
            (Err(fault), _) | (_, Err(fault)) => Err(fault),
        }
    }

    /// The gravity to which the contacts are scaled. If the caller gave the gravity of the reference, the default is the gravity of the
    /// model.
    fn target_gravity(&self, model: &Model) -> Result<Option<f64>, Fault> {
        let asked = self.has_reference_gravity && self.follow.rule == RuleChoice::Paper;
        let target = self.scaling.target_gravity.map(Acceleration::get);
        match (target, model.gravity().filter(|&gravity| gravity > 0.0)) {
            (None, None) if asked => Err(Fault::new(MissingFact::Gravity { purpose: GravityFor::Target })),
            (None, file_of_reference) if asked => Ok(file_of_reference),
            (target, _) => Ok(target),
        }
    }

    /// The rule by which the contacts of the reference are scaled.
    fn scaling_rule(&self, follow: Option<&Follow>) -> Result<ScalingRule, Fault> {
        if self.follow.rule == RuleChoice::Paper {
            return Ok(ScalingRule::Paper);
        }
        let given = self.follow.height_ratio.map(Positive::get);
        let height_ratio = given.or(follow.map(|follow| follow.size_ratio));
        let height_ratio = height_ratio.ok_or_else(|| Fault::new(MissingFact::HeightRatio))?;
        Ok(ScalingRule::PredSim { height_ratio })
    }
}
