//! A remedy as a request: what puts a finding right, ready to be run.

use osim_model::wording::Input;
use osim_model::{Remedy, RemedyChange, RemedyDesign, RemedyLoad};
use osim_values::{
    Acceleration, Assignments, ConstantIndentation, Count, Kilograms, Positive, RelativeIndentation,
    RestitutionCoefficient,
};

use crate::fault::RequestFault;
use crate::options::{
    AnswerOptions, CountOptions, FollowOptions, ForceOptions, LoadOptions, MassOptions, MovedChoice,
    ScalingOptions, SetFiles, WantedOptions,
};
use crate::request::{DesignRequest, Request, RescaleRequest, SetRequest, TransferRequest};

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
        let set_files = SetFiles { geometry: remedy.geometry.clone(), model: remedy.set_model.clone() };
        let load = remedy.load.clone().unwrap_or_default();
        let answers = AnswerOptions::new(remedy.yes.clone());
        Ok(match &remedy.change {
            RemedyChange::Rescale { contacts_mass_kg, target_mass_kg } => {
                let contacts_mass = checked(Input::ContactsMass, Some(*contacts_mass_kg), Kilograms::new)?;
                let target_mass = checked(Input::TargetMass, Some(*target_mass_kg), Kilograms::new)?;
                let masses = MassOptions { contacts_mass, ..masses(&load)? };
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
                scaling: ScalingOptions { level: *level, ..ScalingOptions::default() },
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
                follow: FollowOptions {
                    follow_bodies: true,
                    body_scale_file: body_scale_file.clone(),
                    moved_spheres: replace_moved.then_some(MovedChoice::Replace),
                    ..FollowOptions::default()
                },
                scaling: ScalingOptions { level: *level, ..ScalingOptions::default() },
                masses: masses(&load)?,
                counts: counts(&load)?,
                choice,
                answers,
                set_files,
                ..TransferRequest::default()
            }
            .into(),
            RemedyChange::Design(design) => DesignRequest {
                models,
                wanted: wanted(design)?,
                load: LoadOptions {
                    body_weights: checked(Input::BodyWeights, design.body_weights, Positive::new)?,
                    gravity: checked(Input::Gravity, load.gravity_m_s2, Acceleration::new)?,
                    ..LoadOptions::default()
                },
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
    ForceOptions {
        select: selection.select.clone(),
        exclude: selection.exclude.clone(),
        skip_disabled: selection.skip_disabled,
    }
}

fn masses(load: &RemedyLoad) -> Result<MassOptions, RequestFault> {
    Ok(MassOptions {
        mass: checked(Input::Mass, load.mass_kg, Kilograms::new)?,
        exclude_body: load.exclude_bodies.clone(),
        ..MassOptions::default()
    })
}

fn counts(load: &RemedyLoad) -> Result<CountOptions, RequestFault> {
    let limbs = checked(Input::StanceLimbs, load.stance_limbs, Count::new)?;
    Ok(CountOptions {
        spheres: checked(Input::Spheres, load.spheres, Count::new)?,
        stance_limbs: limbs.unwrap_or(Count::ONE),
    })
}

fn wanted(design: &RemedyDesign) -> Result<WantedOptions, RequestFault> {
    Ok(WantedOptions {
        indentation: checked(Input::Indentation, design.indentation, RelativeIndentation::new)?,
        restitution: checked(Input::Restitution, design.restitution, RestitutionCoefficient::new)?,
        impact_speed: checked(Input::ImpactSpeed, design.impact_speed_m_s, Positive::new)?,
        constant_indentation: checked(
            Input::ConstantIndentation,
            design.constant_indentation,
            ConstantIndentation::new,
        )?,
        state_width: checked(Input::StateWidth, design.state_width, Positive::new)?,
        ..WantedOptions::default()
    })
}
