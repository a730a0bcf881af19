//! Plans of contacts that come from a reference.

use std::path::PathBuf;

use contact_scaling::Ratios;
use osim_inspect::{LoadSharing, ReferenceState};
use osim_model::compare::{Factors, Follow, FollowRequest, OwnRadii};
use osim_model::{
    Anatomy, CountOf, Fault, GravityFor, MassRequest, Model, Needed, Property, RadiusRule, Selected,
    Selection, moving_spheres,
};
use osim_patch::{Plan, Reference, ScalingRule, TRANSFER_FOLLOWING, Transfer, transfer};
use osim_requests::options::{CountOptions, FollowOptions, InspectionOptions, RuleChoice, ScalingOptions};
use osim_requests::{Acceleration, Positive, Radius};

use super::operation::{operation, refuse_again};
use super::reference::Generic;
use crate::planner::Planner;
use crate::remarks::noted_limbs;

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
    /// The same as reports show it.
    pub(super) state: ReferenceState,
    pub(super) reference_said: ReferenceSaid,
    /// The generic model's bones and the Scale Tool's factors, where spheres follow their bodies.
    pub(super) generic: Option<Generic>,
    pub(super) may_repeat: bool,
    pub(super) reads: Vec<PathBuf>,
    pub(super) inspection: InspectionOptions,
    pub(super) settings: String,
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
        let target_mass = self.masses.of_model(model)?;
        warnings.extend(self.masses.disagreements_of_weight(model, &target_mass));
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
                let ratio = self.masses.of_model(model)?.kg / reference.mass.kg;
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
        let here =
            LoadSharing::of(model, &selected.forces).count(self.counts.spheres(), limbs, CountOf::Model);
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
