//! Contacts of another model or of a preset.

use std::path::Path;

use osim_inspect::ReferenceState;
use osim_model::files::{Failure, Files};
use osim_model::messages::{Input, phrase};
use osim_model::{Property, RadiusAxis, RadiusRule, mass_slip};
use osim_patch::Reference;
use osim_requests::options::{InspectionOptions, RuleChoice};
use osim_requests::{Acceleration, Kilograms, Radius, RequestError, RequestFault, TransferRequest};
use serde_json::json;

use super::asking::Asking;
use super::reference::{Generic, KnownMass, of_opened, of_preset, reference_from_file};
use super::transferring::{ReferenceSaid, Transferring};
use crate::opening::Named;
use crate::planner::Change;

/// A reference, the same as reports show it, and its bones where spheres follow them.
pub(super) type Referenced = (Reference, ReferenceState, Option<Generic>);

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
    let referenced = match named {
        Named::Preset(preset) => {
            // A preset has no bodies to compare its mass with.
            let said = request.reference.reference_mass.map(Kilograms::get);
            let asks = said.and_then(|kg| mass_slip(Input::ReferenceMass, kg, None));
            let asked = request.answers.ask(asks);
            asked.map_err(|kind| Failure::outside(from.as_path(), kind.code(), kind.phrase()))?;
            let (reference, state) = of_preset(&request, &preset);
            (reference, state, None)
        }
        Named::Placed(open) => of_opened(&request, &from, &open, KnownMass::Asked, files)?,
        Named::File => reference_from_file(&request, &from, files)?,
    };
    Ok(change(request, referenced, is_file))
}

/// The change with a reference that was read.
fn change(request: TransferRequest, reference: Referenced, is_file: bool) -> Change {
    let (models, output, set_files) =
        (request.models.clone(), request.output.clone(), request.set_files.clone());
    let answers = request.answers.clone();
    let planner = planner(request, reference, is_file);
    Change::new(models, output, set_files, Asking { masses: planner.masses.clone(), answers, planner })
}

/// What plans for each model, with a reference that was read: from a file, or a preset.
pub(super) fn planner(
    request: TransferRequest,
    (mut reference, state, generic): Referenced,
    is_file: bool,
) -> Transferring {
    let gravity = request.reference.reference_gravity.map(Acceleration::get);
    reference.gravity_m_s2 = gravity.or(reference.gravity_m_s2);
    let settings = settings(&request, is_file);
    let own = request.from.filter(|_| is_file);
    let reads =
        own.into_iter().chain(request.presets).chain(request.follow.body_scale_file.clone()).collect();
    let stance = request.counts.stance_options(None, None);
    Transferring {
        counts: request.counts,
        follow: request.follow,
        scaling: request.scaling,
        reference_sphere: request.reference.reference_sphere,
        selection: request.choice.selection(),
        masses: request.masses.request(),
        reference,
        state,
        reference_said: ReferenceSaid {
            spheres: request.reference.reference_spheres.is_some(),
            gravity: gravity.is_some(),
        },
        generic,
        may_repeat: request.output.may_repeat(),
        reads,
        inspection: InspectionOptions::new(stance, request.masses, request.choice, request.set_files.clone()),
        settings,
    }
}

/// The reference is identified by its contents; a preset by its name, which means the same numbers in one version.
fn settings(request: &TransferRequest, is_file: bool) -> String {
    let TransferRequest { from, counts, reference, follow, masses, scaling, choice, .. } = request;
    let preset = from.as_ref().filter(|_| !is_file).map(|from| from.to_string_lossy());
    json!(["transfer", preset, counts, reference, follow, masses, scaling, choice]).to_string()
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
