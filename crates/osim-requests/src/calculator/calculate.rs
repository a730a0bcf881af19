//! Figures that follow from what is known.

use contact_scaling::sizing::{Known, Sizing};
use contact_scaling::{
    Hertz, SharedLoad, SmoothSphere, SmoothingValues, limits, modulus, patch, restitution, smoothing,
    stiffness,
};
use osim_model::wording::{Input, phrase};

use super::at_rest::{self, AtRest};
use super::given::{Given, ModulusFrom, refused};
use super::sheet::DesignSheet;
use crate::fault::RequestFault;
use crate::options::WantedOptions;
use crate::request::DesignRequest;
use crate::value::{ConstantIndentation, Positive, RestitutionCoefficient};

impl DesignRequest {
    /// Calculates a design that names no model.
    ///
    /// # Errors
    /// Too little is known, or it contradicts itself; or something is said that only makes sense with a model.
    pub fn calculate(&self) -> Result<DesignSheet, RequestFault> {
        if let Some(input) = without_meaning(self) {
            let message = phrase![input, " needs a model to work on: name one, or leave it out"];
            return Err(RequestFault::refused(input, message));
        }
        let given = Given::new(self)?;
        let load = given.shared_load().map_err(refused)?;
        let known = given.known(load.as_ref());
        let mut sheet = DesignSheet::new();
        let (sizing, at_rest) = at_rest::solve(&known, &given, &self.wanted)?;
        match &sizing {
            Some(sizing) => sized(&mut sheet, sizing, &known, &given, load.as_ref(), at_rest)?,
            None if given.needs_sizing() => return Err(given.missing()),
            None => {
                if let Some(composite) = given.composite_modulus {
                    moduli(&mut sheet, composite, given.modulus.equation(), given.modulus)?;
                }
            }
        }
        let radius = sizing.map(|sizing| sizing.radius_m).or(given.radius_m);
        let composite = sizing.map(|sizing| sizing.composite_modulus_n_m2).or(given.composite_modulus);
        dissipation(&mut sheet, &self.wanted, radius, given.gravity_m_s2)?;
        smoothed(&mut sheet, &self.wanted, radius, composite, at_rest)?;
        if sheet.figures.is_empty() {
            return Err(given.missing());
        }
        Ok(sheet)
    }
}

/// Something that only makes sense with a model.
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
    equation: &'static str,
    from: ModulusFrom,
) -> Result<(), RequestFault> {
    sheet.add("composite_modulus_n_m2", composite, "N/m^2", equation, false);
    let surface = modulus::of_equal_surfaces(composite, modulus::MixingRule::Sherman).map_err(refused)?;
    sheet.add("stiffness", surface, "N/m^2", "A.4", from == ModulusFrom::Stiffness);
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
    let by = |hertz, smoothed| if at_rest.is_some_and(AtRest::matters) { smoothed } else { hertz };
    let load_given = known.load_per_sphere_n.is_some();
    sheet.add("load_per_sphere_n", sizing.load_per_sphere_n, "N", by("3", "3, C.9"), load_given);
    sheet.add("radius_m", radius, "m", "11, B.2", known.radius_m.is_some());
    sheet.add("relative_indentation", x, "", by("2, 11", "2, 11, C.9"), known.relative_indentation.is_some());
    sheet.limited(&limits::INDENTATION);
    sheet.add("indentation_m", x * radius, "m", "2", false);
    let modulus_by = match given.modulus {
        ModulusFrom::Sizing => by("11", "11, C.9"),
        known => known.equation(),
    };
    moduli(sheet, sizing.composite_modulus_n_m2, modulus_by, given.modulus)?;
    let stiffness_given = known.stiffness_n_m.is_some();
    sheet.add("contact_stiffness_n_m", sizing.stiffness_n_m, "N/m", by("B.2", "B.2, C.9"), stiffness_given);
    let one = SharedLoad::new(sizing.load_per_sphere_n, 1.0).map_err(refused)?;
    let pure = stiffness::dimensionless(sizing.stiffness_n_m, radius, &one).map_err(refused)?;
    sheet.add("dimensionless_stiffness", pure, "", "B.3", false);
    let stress = patch::mean_stress(sizing.load_per_sphere_n, radius, x).map_err(refused)?;
    sheet.add("mean_contact_stress_n_m2", stress, "N/m^2", "15", false);
    let diameter = patch::diameter(x * radius, radius).map_err(refused)?;
    sheet.add("contact_patch_diameter_m", diameter, "m", "15", false);
    if let (Some(mass), Some(load), true) = (given.mass_kg, load, given.is_body_weight) {
        let on_sphere = mass / load.sphere_count();
        let frequency = stiffness::natural_frequency(sizing.stiffness_n_m, on_sphere).map_err(refused)?;
        sheet.add("natural_frequency_hz", frequency, "Hz", "B.4", false);
        let frequency = stiffness::equilibrium_frequency(x, radius, given.gravity_m_s2).map_err(refused)?;
        sheet.add("equilibrium_frequency_hz", frequency, "Hz", "B.5", false);
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
    sheet.add("impact_speed_m_s", speed, "m/s", "13", wanted.impact_speed.is_some());
    let alpha = restitution::dissipation(target, speed).map_err(refused)?;
    sheet.add("restitution", target, "", "13", true);
    sheet.limited(&limits::RESTITUTION);
    sheet.add("dissipation", alpha, "s/m", "13", false);
    let exact = restitution::exact(alpha, speed).map_err(refused)?;
    sheet.add("restitution_exact_at_this_dissipation", exact, "", "exact", false);
    if target > 0.0 {
        let exact = restitution::exact_dissipation(target, speed).map_err(refused)?;
        sheet.add("dissipation_for_exact_restitution", exact, "s/m", "exact", false);
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
        sheet.add("constant_contact_force", value, "m^2", "C.2", false);
        cf = Some(value);
    }
    if let Some(width) = wanted.state_width.map(Positive::get) {
        let radius = need(Input::StateWidth)?;
        let value = smoothing::hertz_smoothing_for_width(t, width, radius).map_err(refused)?;
        sheet.add("hertz_smoothing", value, "1/m", "C.8", false);
        bd = Some(value);
    }
    if let Some(width) = wanted.speed_width.map(Positive::get) {
        let value = smoothing::hunt_crossley_smoothing_for_speed_width(t, width).map_err(refused)?;
        sheet.add("hunt_crossley_smoothing", value, "s/m", "C.10", false);
    }
    if let (Some(constant_contact_force), Some(hertz_smoothing), Some(radius), Some(composite)) =
        (cf, bd, radius, composite)
    {
        let values =
            SmoothingValues { constant_contact_force, hertz_smoothing, ..SmoothingValues::OPENSIM_DEFAULT };
        let hertz = Hertz::sphere(composite, radius).map_err(refused)?;
        let elastic = SmoothSphere::new(hertz, 0.0, values).map_err(refused)?.elastic_force(0.0);
        let (share, equation) = at_rest.map_or((1.0, "C.3"), |known| (known.speed_state, "C.9"));
        sheet.add("force_just_touching_n", elastic * share, "N", equation, false);
    }
    Ok(())
}
