//! A remedy as a request: what puts a finding right, ready to be run.

use std::path::PathBuf;

use osim_messages::Input;
use osim_model::{Remedy, RemedyChange, RemedyDesign, RemedyLoad};

use crate::fault::RequestFault;
use crate::options::{
    AnswerOptions, ClassChoice, CountOptions, FollowOptions, ForceOptions, LoadOptions, MassOptions,
    MovedChoice, ScalingOptions, SetFiles, WantedOptions,
};
use crate::request::{ConvertRequest, DesignRequest, Request, RescaleRequest, SetRequest, TransferRequest};
use crate::values::{
    Acceleration, Assignments, ConstantIndentation, Count, Kilograms, Positive, RelativeIndentation,
    RestitutionCoefficient,
};

/// Checks a number of a remedy.
fn checked<T>(
    input: Input,
    value: Option<f64>,
    new: impl FnOnce(f64) -> Result<T, String>,
) -> Result<Option<T>, RequestFault> {
    value.map(new).transpose().map_err(|why| RequestFault::refused(input, why))
}

impl TryFrom<&Remedy> for Request {
    type Error = RequestFault;

    /// # Errors
    /// A number outside its domain, which no finding has.
    fn try_from(remedy: &Remedy) -> Result<Self, RequestFault> {
        let models = vec![remedy.model.to_path()];
        let choice = choice(remedy);
        let mut set_files = SetFiles::default();
        (set_files.geometry, set_files.model) = (remedy.geometry.clone(), remedy.set_model.clone());
        let load = remedy.load.clone().unwrap_or_default();
        let answers = AnswerOptions::new(remedy.yes.clone());
        Ok(match &remedy.change {
            RemedyChange::Rescale { contacts_mass_kg, target_mass_kg } => {
                let contacts_mass = checked(Input::ContactsMass, Some(*contacts_mass_kg), Kilograms::new)?;
                let target_mass = checked(Input::TargetMass, Some(*target_mass_kg), Kilograms::new)?;
                let mut masses = masses(&load)?;
                masses.contacts_mass = contacts_mass;
                let rescale = RescaleRequest {
                    models,
                    target_mass,
                    masses,
                    choice,
                    set_files,
                    ..RescaleRequest::default()
                };
                RescaleRequest { answers, ..rescale }.into()
            }
            RemedyChange::Transfer { from } => TransferRequest {
                models,
                from: Some((*from).into()),
                masses: masses(&load)?,
                counts: counts(&load)?,
                choice,
                answers,
                set_files,
                ..TransferRequest::default()
            }
            .into(),
            RemedyChange::FollowNote { target_mass_kg, level } => RescaleRequest {
                models,
                target_mass: checked(Input::TargetMass, Some(*target_mass_kg), Kilograms::new)?,
                follow_bodies: true,
                scaling: levelling(*level),
                masses: masses(&load)?,
                choice,
                answers,
                set_files,
                ..RescaleRequest::default()
            }
            .into(),
            RemedyChange::Follow { from, body_scale_file, level, replace_moved } => TransferRequest {
                models,
                from: Some(from.clone()),
                follow: following(body_scale_file.clone(), *replace_moved),
                scaling: levelling(*level),
                masses: masses(&load)?,
                counts: counts(&load)?,
                choice,
                answers,
                set_files,
                ..TransferRequest::default()
            }
            .into(),
            RemedyChange::Convert { to } => {
                let to = ClassChoice::of(*to);
                ConvertRequest { models, to, choice, answers, ..ConvertRequest::default() }.into()
            }
            RemedyChange::Design(design) => DesignRequest {
                models,
                wanted: wanted(design)?,
                load: loaded(design, &load)?,
                masses: masses(&load)?,
                counts: counts(&load)?,
                choice,
                answers,
                set_files,
                ..DesignRequest::default()
            }
            .into(),
            RemedyChange::Set { assignments } => {
                let set: Assignments = assignments.iter().copied().collect();
                SetRequest { models, set, choice, answers, set_files, ..SetRequest::default() }.into()
            }
            _ => return Err(RequestFault::general("this remedy is not a request")),
        })
    }
}

fn choice(remedy: &Remedy) -> ForceOptions {
    let selection = &remedy.selection;
    let mut choice = ForceOptions::default();
    choice.select.clone_from(&selection.select);
    choice.exclude.clone_from(&selection.exclude);
    choice.skip_disabled = selection.skip_disabled;
    choice
}

fn levelling(level: bool) -> ScalingOptions {
    let mut scaling = ScalingOptions::default();
    scaling.level = level;
    scaling
}

fn following(body_scale_file: Option<PathBuf>, replace_moved: bool) -> FollowOptions {
    let mut follow = FollowOptions::default();
    follow.follow_bodies = true;
    follow.body_scale_file = body_scale_file;
    follow.moved_spheres = replace_moved.then_some(MovedChoice::Replace);
    follow
}

fn loaded(design: &RemedyDesign, load: &RemedyLoad) -> Result<LoadOptions, RequestFault> {
    let mut loaded = LoadOptions::default();
    loaded.body_weights = checked(Input::BodyWeights, design.body_weights, Positive::new)?;
    loaded.gravity = checked(Input::Gravity, load.gravity_m_s2, Acceleration::new)?;
    Ok(loaded)
}

fn masses(load: &RemedyLoad) -> Result<MassOptions, RequestFault> {
    let mut masses = MassOptions::default();
    masses.mass = checked(Input::Mass, load.mass_kg, Kilograms::new)?;
    masses.exclude_body.clone_from(&load.exclude_bodies);
    Ok(masses)
}

fn counts(load: &RemedyLoad) -> Result<CountOptions, RequestFault> {
    let limbs = checked(Input::StanceLimbs, load.stance_limbs, Count::new)?;
    let mut counts = CountOptions::default();
    counts.spheres = checked(Input::Spheres, load.spheres, Count::new)?;
    counts.stance_limbs = limbs.unwrap_or(Count::ONE);
    Ok(counts)
}

fn wanted(design: &RemedyDesign) -> Result<WantedOptions, RequestFault> {
    let mut wanted = WantedOptions::default();
    wanted.indentation = checked(Input::Indentation, design.indentation, RelativeIndentation::new)?;
    wanted.restitution = checked(Input::Restitution, design.restitution, RestitutionCoefficient::new)?;
    wanted.impact_speed = checked(Input::ImpactSpeed, design.impact_speed_m_s, Positive::new)?;
    let constant =
        checked(Input::ConstantIndentation, design.constant_indentation, ConstantIndentation::new)?;
    wanted.constant_indentation = constant;
    wanted.state_width = checked(Input::StateWidth, design.state_width, Positive::new)?;
    Ok(wanted)
}
