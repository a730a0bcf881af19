//! Figures that follow from what is known.

use contact_scaling::sizing::{Known, Sizing};
use contact_scaling::{
    Hertz, SharedLoad, SmoothSphere, SmoothingValues, modulus, patch, restitution, smoothing, stiffness,
};
use osim_model::messages::{Input, phrase};
use osim_requests::options::WantedOptions;
use osim_requests::{ConstantIndentation, DesignRequest, Positive, RequestFault, RestitutionCoefficient};

use super::at_rest::{self, AtRest};
use super::given::{Given, ModulusFrom, refused};
use super::register::DesignQuantity;
use super::sheet::DesignSheet;

/// Calculates a design that names no model.
///
/// # Errors
/// Too little is known, or it contradicts itself; or something is given that only makes sense with a model.
pub fn design_sheet(request: &DesignRequest) -> Result<DesignSheet, RequestFault> {
    if let Some(input) = without_meaning(request) {
        let message = phrase![input, " needs a model to work on: name one, or leave it out"];
        return Err(RequestFault::refused(input, message));
    }
    let given = Given::new(request)?;
    let load = given.shared_load().map_err(refused)?;
    let known = given.known(load.as_ref());
    let mut sheet = DesignSheet::new();
    let (sizing, at_rest) = at_rest::solve(&known, &given, &request.wanted)?;
    match &sizing {
        Some(sizing) => sized(&mut sheet, sizing, &known, &given, load.as_ref(), at_rest)?,
        None if given.needs_sizing() => return Err(given.missing()),
        None => {
            if let Some(composite) = given.composite_modulus {
                moduli(&mut sheet, composite, given.modulus, false)?;
            }
        }
    }
    let radius = sizing.map(|sizing| sizing.radius_m).or(given.radius_m);
    let composite = sizing.map(|sizing| sizing.composite_modulus_n_m2).or(given.composite_modulus);
    dissipation(&mut sheet, &request.wanted, radius, given.gravity_m_s2)?;
    smoothed(&mut sheet, &request.wanted, radius, composite, at_rest)?;
    if sheet.figures.is_empty() {
        return Err(given.missing());
    }
    Ok(sheet)
}

/// The first input that only makes sense with a model.
fn without_meaning(request: &DesignRequest) -> Option<Input> {
    let output = &request.output;
    let given = [
        (Input::Output, output.output.is_some()),
        (Input::OutputDir, output.output_dir.is_some()),
        (Input::InPlace, output.in_place),
        (Input::DryRun, request.run.dry_run),
        (Input::Diff, request.run.diff),
        (Input::Summary, request.run.summary.is_some()),
        (Input::Shard, request.run.shard.is_some()),
        (Input::Force, output.force),
        (Input::NoNote, output.no_note),
        (Input::Select, !request.choice.select.is_empty()),
        (Input::Exclude, !request.choice.exclude.is_empty()),
        (Input::SkipDisabled, request.choice.skip_disabled),
        (Input::ExcludeBody, !request.masses.exclude_body.is_empty()),
        (Input::ContactsMass, request.masses.contacts_mass.is_some()),
        (Input::Geometry, request.set_files.geometry.is_some()),
        (Input::Model, request.set_files.model.is_some()),
    ];
    given.into_iter().find(|(_, given)| *given).map(|(input, _)| input)
}

fn moduli(
    sheet: &mut DesignSheet,
    composite: f64,
    from: ModulusFrom,
    smoothed: bool,
) -> Result<(), RequestFault> {
    match from.equation() {
        Some(equation) => sheet.add_by(equation, DesignQuantity::CompositeModulus, composite, false),
        None => sheet.add_at_rest(smoothed, DesignQuantity::CompositeModulus, composite, false),
    }
    let surface = modulus::of_equal_surfaces(composite, modulus::MixingRule::Sherman).map_err(refused)?;
    sheet.add(DesignQuantity::Stiffness, surface, from == ModulusFrom::Stiffness);
    Ok(())
}

fn sized(
    sheet: &mut DesignSheet,
    sizing: &Sizing,
    known: &Known,
    given: &Given,
    load: Option<&SharedLoad>,
    at_rest: Option<AtRest>,
) -> Result<(), RequestFault> {
    let (radius, x) = (sizing.radius_m, sizing.relative_indentation);
    let (load_n, k) = (sizing.load_per_sphere_n, sizing.stiffness_n_m);
    let smoothed = at_rest.is_some_and(AtRest::matters);
    sheet.add_at_rest(smoothed, DesignQuantity::LoadPerSphere, load_n, known.load_per_sphere_n.is_some());
    sheet.add(DesignQuantity::Radius, radius, known.radius_m.is_some());
    let x_given = known.relative_indentation.is_some();
    sheet.add_at_rest(smoothed, DesignQuantity::RelativeIndentation, x, x_given);
    sheet.add(DesignQuantity::Indentation, x * radius, false);
    moduli(sheet, sizing.composite_modulus_n_m2, given.modulus, smoothed)?;
    sheet.add_at_rest(smoothed, DesignQuantity::ContactStiffness, k, known.stiffness_n_m.is_some());
    let one = SharedLoad::new(load_n, 1.0).map_err(refused)?;
    let pure = stiffness::dimensionless(k, radius, &one).map_err(refused)?;
    sheet.add(DesignQuantity::DimensionlessStiffness, pure, false);
    let stress = patch::mean_stress(load_n, radius, x).map_err(refused)?;
    sheet.add(DesignQuantity::MeanContactStress, stress, false);
    let diameter = patch::diameter(x * radius, radius).map_err(refused)?;
    sheet.add(DesignQuantity::ContactPatchDiameter, diameter, false);
    if let (Some(mass), Some(load), true) = (given.mass_kg, load, given.is_body_weight) {
        let on_sphere = mass / load.sphere_count();
        let frequency = stiffness::natural_frequency(k, on_sphere).map_err(refused)?;
        sheet.add(DesignQuantity::NaturalFrequency, frequency, false);
        let frequency = stiffness::equilibrium_frequency(x, radius, given.gravity_m_s2).map_err(refused)?;
        sheet.add(DesignQuantity::EquilibriumFrequency, frequency, false);
    }
    sheet.notes.extend(at_rest.and_then(AtRest::note));
    if x > 1.0 {
        let note = "a relative indentation above 1: the sphere is softer than its load allows";
        sheet.notes.push(note.to_owned());
    }
    Ok(())
}

fn dissipation(
    sheet: &mut DesignSheet,
    wanted: &WantedOptions,
    radius: Option<f64>,
    gravity: f64,
) -> Result<(), RequestFault> {
    let Some(target) = wanted.restitution.map(RestitutionCoefficient::get) else { return Ok(()) };
    let speed = match (wanted.impact_speed.map(Positive::get), radius) {
        (Some(speed), _) => speed,
        (None, Some(radius)) => {
            let text = "the impact speed is that of a fall from a quarter of the radius, sqrt(gR/2)";
            sheet.notes.push(text.to_owned());
            restitution::drop_speed(gravity, radius).map_err(refused)?
        }
        (None, None) => {
            let message = phrase![
                Input::Restitution,
                " needs ",
                Input::ImpactSpeed.like("M/S"),
                ", or a radius to take sqrt(gR/2) from",
            ];
            return Err(RequestFault::refused(Input::Restitution, message));
        }
    };
    sheet.add(DesignQuantity::ImpactSpeed, speed, wanted.impact_speed.is_some());
    let alpha = restitution::dissipation(target, speed).map_err(refused)?;
    sheet.add(DesignQuantity::Restitution, target, true);
    sheet.add(DesignQuantity::Dissipation, alpha, false);
    let exact = restitution::exact(alpha, speed).map_err(refused)?;
    sheet.add(DesignQuantity::RestitutionExact, exact, false);
    if target > 0.0 {
        let exact = restitution::exact_dissipation(target, speed).map_err(refused)?;
        sheet.add(DesignQuantity::DissipationExact, exact, false);
    }
    Ok(())
}

fn smoothed(
    sheet: &mut DesignSheet,
    wanted: &WantedOptions,
    radius: Option<f64>,
    composite: Option<f64>,
    at_rest: Option<AtRest>,
) -> Result<(), RequestFault> {
    let need = |input: Input| {
        radius.ok_or_else(|| {
            let message = phrase![input, " needs a radius: say ", Input::Radius.like("METRES")];
            RequestFault::refused(input, message)
        })
    };
    let t = wanted.threshold.get();
    let mut cf = None;
    let mut bd = None;
    if let Some(x) = wanted.constant_indentation.map(ConstantIndentation::get) {
        let radius = need(Input::ConstantIndentation)?;
        let value = smoothing::constant_contact_force(x, radius).map_err(refused)?;
        sheet.add(DesignQuantity::ConstantContactForce, value, false);
        cf = Some(value);
    }
    if let Some(width) = wanted.state_width.map(Positive::get) {
        let radius = need(Input::StateWidth)?;
        let value = smoothing::hertz_smoothing_for_width(t, width, radius).map_err(refused)?;
        sheet.add(DesignQuantity::HertzSmoothing, value, false);
        bd = Some(value);
    }
    if let Some(width) = wanted.speed_width.map(Positive::get) {
        let value = smoothing::hunt_crossley_smoothing_for_speed_width(t, width).map_err(refused)?;
        sheet.add(DesignQuantity::HuntCrossleySmoothing, value, false);
    }
    if let (Some(constant_contact_force), Some(hertz_smoothing), Some(radius), Some(composite)) =
        (cf, bd, radius, composite)
    {
        let values =
            SmoothingValues { constant_contact_force, hertz_smoothing, ..SmoothingValues::OPENSIM_DEFAULT };
        let hertz = Hertz::sphere(composite, radius).map_err(refused)?;
        let elastic = SmoothSphere::new(hertz, 0.0, values).map_err(refused)?.elastic_force(0.0);
        match at_rest {
            Some(known) => sheet.add(DesignQuantity::ForceJustTouching, elastic * known.speed_state, false),
            None => sheet.add_by("C.3", DesignQuantity::ForceJustTouching, elastic, false),
        }
    }
    Ok(())
}
