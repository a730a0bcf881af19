//! `transfer --from`: contacts of another model or of a preset.

use std::path::PathBuf;

use anyhow::{Result, bail};
use osim_patch::{
    Anatomy, Factors, Fault, FaultKind, Follow, FollowRequest, MassRequest, Model, Plan, Property,
    RadiusRule, Reference, ScalingRule, Selected, Selection, Transfer, Warning, moving_spheres, transfer,
};

use super::reference::{Generic, preset, reference_from_file};
use super::{operation, refuse_again, sphere_count};
use crate::args::{RuleArg, StanceArgs, TransferArgs, ViewArgs};
use crate::failure::Failure;
use crate::run::{Planner, Verb};

/// `transfer --from`.
struct Transferring {
    args: TransferArgs,
    selection: Selection,
    masses: MassRequest,
    reference: Reference,
    /// The generic model's bones and the Scale Tool's factors, where spheres follow their bodies.
    generic: Option<Generic>,
    again: bool,
    options: String,
}

/// Reads the reference once, for all models.
///
/// # Errors
/// The reference is no preset and no file (wrong usage), or a model that cannot be a reference.
pub(crate) fn verb(args: TransferArgs) -> Result<Result<Verb, Failure>> {
    if args.masses.contacts_mass.is_some() {
        bail!(
            "--contacts-mass says nothing here: the reference's mass is --reference-mass, this model's --mass"
        );
    }
    let selection = args.choice.selection()?;
    let masses = args.masses.request()?;
    if args.scaling.level && !args.follow.follow_bodies {
        bail!("--level in a transfer needs --follow-bodies: without it neither radii nor soles change");
    }
    if args.scaling.radius.is_some() && args.follow.follow_bodies {
        bail!(
            "--radius says nothing with --follow-bodies: radii follow the bodies (--radius-axis), or stay with \
                 --keep radius"
        );
    }
    let reference = match preset(&args)? {
        Some(_) if args.follow.follow_bodies => {
            bail!("--follow-bodies needs the generic model as --from, a preset has no bodies")
        }
        Some(reference) => Ok((reference, None)),
        None => reference_from_file(&args),
    };
    Ok(reference.map(|(mut reference, generic)| {
        reference.gravity_m_s2 = args.reference.reference_gravity.or(reference.gravity_m_s2);
        let (models, output, parts) = (args.models.clone(), args.output.clone(), args.parts.clone());
        let again = output.force || !output.in_place;
        let options = options(&args);
        let planner = Transferring { args, selection, masses, reference, generic, again, options };
        Verb { models, output, parts, planner: Box::new(planner) }
    }))
}

/// The reference is told by its contents; a preset by its name, which stands for the same numbers in one version.
fn options(args: &TransferArgs) -> String {
    let TransferArgs { from, counts, reference, follow, masses, scaling, choice, .. } = args;
    let preset = if from.exists() { None } else { Some(from) };
    format!("transfer {preset:?} {counts:?} {reference:?} {follow:?} {masses:?} {scaling:?} {choice:?}")
}

impl Planner for Transferring {
    fn name(&self) -> &'static str {
        "transfer"
    }

    fn view(&self) -> ViewArgs {
        let TransferArgs { counts, masses, choice, .. } = &self.args;
        ViewArgs {
            stance: StanceArgs {
                spheres: counts.spheres,
                stance_limbs: counts.stance_limbs,
                impact_speed: None,
            },
            masses: masses.clone(),
            choice: choice.clone(),
            ..ViewArgs::default()
        }
    }

    fn target_gravity_m_s2(&self) -> Option<f64> {
        self.args.scaling.target_gravity
    }

    fn options(&self) -> String {
        self.options.clone()
    }

    fn reads(&self) -> Vec<PathBuf> {
        let args = &self.args;
        let from = Some(&args.from).filter(|from| from.exists());
        from.into_iter().chain(&args.presets).chain(&args.follow.body_scale_file).cloned().collect()
    }

    fn plan(&self, model: &Model) -> Result<Plan, Fault> {
        let selected = self.selection.apply(model)?;
        let scaling = &self.args.scaling;
        let mut warnings = Vec::new();
        let follow = match &self.generic {
            Some(generic) => Some(self.follow(model, &selected, generic, &mut warnings)?),
            None => None,
        };
        let sphere_count = match self.args.counts.spheres {
            Some(count) => count,
            None => sphere_count(model, self.args.counts.stance_limbs, "--spheres")?,
        };
        let operation = operation("transfer", scaling.radius);
        if matches!(scaling.radius, Some(RadiusRule::Factor(_))) {
            refuse_again(model, &operation, self.again)?;
        }
        let mass = self.masses.of_model(model)?;
        self.masses.compare(model, &mass, &mut warnings);
        let rule = self.rule(follow.as_ref())?;
        let mut plan = transfer(
            model,
            &selected,
            &Transfer {
                reference: self.reference.clone(),
                reference_sphere: self.args.reference.reference_sphere.clone(),
                mass,
                sphere_count,
                radius: scaling.radius.unwrap_or(RadiusRule::Keep),
                properties: scaling.properties(),
                dissipation_by: scaling.dissipation(),
                target_gravity_m_s2: scaling.target_gravity,
                follow,
                rule,
                strict: self.args.follow.strict,
            },
        )?;
        plan.name_operation(&operation);
        plan.warnings.append(&mut warnings);
        Ok(plan)
    }
}

impl Transferring {
    fn follow(
        &self,
        model: &Model,
        selected: &Selected,
        generic: &Generic,
        warnings: &mut Vec<Warning>,
    ) -> Result<Follow, Fault> {
        let args = &self.args.follow;
        let scaled = Anatomy::of(model)?;
        let factors = Factors::find(&scaled, &generic.anatomy, generic.file.as_ref(), &args.given())?;
        warnings.extend(factors.warnings.iter().cloned());
        let request = FollowRequest {
            radius_axis: args.radius_axis(),
            level: self.args.scaling.level_axis(model.gravity_m_s2),
            moved: args.moved(),
            keep_radii: !self.args.scaling.properties().contains(Property::Radius),
        };
        Follow::refuse_missing(&scaled, self.reference.contacts.iter().flat_map(|contact| &contact.spheres))?;
        let spheres = moving_spheres(model, &selected.forces);
        let follow = Follow::find(model, &spheres, &scaled, &generic.anatomy, &factors, &request)?;
        match &generic.count_unknown {
            Some(fault) => Err(fault.clone()),
            None => Ok(follow),
        }
    }

    fn rule(&self, follow: Option<&Follow>) -> Result<ScalingRule, Fault> {
        if self.args.follow.rule == RuleArg::Paper {
            return Ok(ScalingRule::Paper);
        }
        let ratio = self.args.follow.height_ratio.or(follow.map(|follow| follow.size_ratio));
        let Some(height_ratio) = ratio else {
            return Err(Fault::new(FaultKind::Refused(
                "--rule predsim needs the ratio of heights: say --height-ratio RATIO, or --follow-bodies"
                    .to_owned(),
            )));
        };
        Ok(ScalingRule::PredSim { height_ratio })
    }
}
