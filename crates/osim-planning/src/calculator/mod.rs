//! Computes a design without a model: all figures that follow from the given numbers, with equations and limits.

mod inputs;

use std::borrow::Cow;

use contact_scaling::sizing::{KnownQuantities, Sizing};
use contact_scaling::{
    Hertz, SharedLoad, SmoothSphere, SmoothingValues, limits, modulus, patch, restitution, smoothing,
    stiffness,
};
use osim_inspect::{Quantity, SCHEMA_VERSION, ways_within_hertz};
use osim_model::Property;
use osim_model::messages::{Input, phrase};
use osim_requests::options::WantedOptions;
use osim_requests::{ConstantIndentation, DesignRequest, Positive, RequestFault, RestitutionCoefficient};
use serde::Serialize;

use inputs::{DesignInputs, ModulusSource, RestingContact, solve_at_rest, speed_smoothing};
pub(crate) use inputs::{STANDARD_GRAVITY_M_S2, domain_fault, require_plausible_radius};

/// All figures that follow from the known ones. Serialised it is the JSON contract of `design` without a model; `docs/reference/json.md`
/// describes it.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(deny_unknown_fields))]
pub struct DesignSheet {
    /// Version of this JSON, which rises when a field changes its meaning or goes away.
    pub schema_version: u32,
    /// The figures, in the order in which they follow.
    pub figures: Vec<DesignFigure>,
    /// Sentences about how figures were calculated, and limits of that.
    pub remarks: Vec<String>,
}

/// A figure of a design.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(deny_unknown_fields))]
pub struct DesignFigure {
    /// The quantity of the register.
    #[serde(skip)]
    pub quantity: DesignQuantity,
    /// Name of the figure, with its unit.
    #[cfg_attr(feature = "schemas", schemars(schema_with = "figure_names"))]
    pub name: &'static str,
    /// Value of the figure.
    #[cfg_attr(feature = "schemas", schemars(with = "Option<f64>"))]
    pub value: f64,
    /// Unit of the figure, for people.
    pub unit: &'static str,
    /// Number of the equation in the paper, or a word where there is none.
    pub equation: Cow<'static, str>,
    /// Whether the figure was given; else it was calculated from other numbers.
    pub given: bool,
    /// Limit of the figure, where it has one.
    pub limit: Option<DesignLimit>,
}

/// The limit of a figure.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(deny_unknown_fields))]
pub struct DesignLimit {
    /// The limit in words.
    pub text: String,
    /// Whether the figure is within the limit.
    pub within_limit: bool,
}

impl DesignSheet {
    /// Adds a figure that was computed by the usual equation of its quantity.
    fn add(&mut self, quantity: DesignQuantity, value: f64, given: bool) {
        self.add_with_equation(quantity.info().equation, quantity, value, given);
    }

    /// Adds a figure that depends on the force at speed 0. If the contact is `smoothed`, its equations include (C.9).
    fn add_at_rest(&mut self, smoothed: bool, quantity: DesignQuantity, value: f64, given: bool) {
        let equation = quantity.info().equation;
        let equation = if smoothed { format!("{equation}, C.9").into() } else { Cow::from(equation) };
        self.add_with_equation(equation, quantity, value, given);
    }

    /// Adds a figure that was computed by another equation than the usual equation of its quantity.
    fn add_with_equation(
        &mut self,
        equation: impl Into<Cow<'static, str>>,
        quantity: DesignQuantity,
        value: f64,
        given: bool,
    ) {
        let info = quantity.info();
        let limit =
            info.limit.map(|limit| DesignLimit { text: limit.in_words(), within_limit: limit.admits(value) });
        let (name, unit, equation) = (info.name, info.unit, equation.into());
        self.figures.push(DesignFigure { quantity, name, value, unit, equation, given, limit });
    }
}

/// The schema of a figure's name: one of the names in the register.
#[cfg(feature = "schemas")]
fn figure_names(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
    let figure_names: Vec<&str> = DesignQuantity::ALL.iter().map(|quantity| quantity.info().name).collect();
    schemars::json_schema!({"type": "string", "enum": figure_names})
}

// The one register of the figures of a design without a model. A new quantity is a new entry here, a line in `design_sheet` that
// adds its value, and a test.

osim_inspect::quantities! {
    /// A quantity of a design, see [`Quantity`].
    DesignQuantity {
        LoadPerSphere = "Load F/n on each sphere.", Quantity::new("load_per_sphere_n", "load per sphere", "N").by_equation("3");
        Radius = "Radius R of the sphere.", Quantity::RADIUS.by_equation("11, B.2");
        RelativeIndentation = "Relative indentation x̂ under the load.", Quantity::new("relative_indentation", "relative indentation", "")
            .by_equation("2, 11").with_limit(&limits::INDENTATION);
        Indentation = "Indentation x under the load.", Quantity::new("indentation_m", "indentation", "m").by_equation("2");
        CompositeModulus = "Composite modulus E* of both surfaces; by (11), from `stiffness` or from `young`.",
            Quantity::COMPOSITE_MODULUS.by_equation("11");
        Stiffness = "Plane strain modulus E₁* of one of two equal surfaces: the number for OpenSim.",
            Quantity::property(Property::Stiffness).by_equation("A.4");
        FirstModulus = "Plane strain modulus E₁* of the first of two different surfaces.",
            Quantity::new("first_modulus_n_m2", "modulus of the first surface", "N/m2").by_equation("A.1");
        OtherModulus = "Plane strain modulus E₂* of the other surface.",
            Quantity::new("other_modulus_n_m2", "modulus of the other surface", "N/m2").by_equation("A.1");
        CompositeModulusOpenSim = "Composite modulus of the two surfaces in OpenSim; the composite modulus above is by Johnson's rule (A.2).",
            Quantity::new("composite_modulus_opensim_n_m2", "composite modulus in OpenSim", "N/m2").by_equation("A.3");
        OpenSimOverJohnson = "Composite modulus in OpenSim over that by Johnson's rule.",
            Quantity::new("opensim_over_johnson", "  over the one by Johnson", "").by_equation("A.2, A.3");
        ContactStiffness = "Stiffness k of one sphere under the load.", Quantity::CONTACT_STIFFNESS;
        DimensionlessStiffness = "k̂ = k R n / F under the load.", Quantity::DIMENSIONLESS_STIFFNESS;
        MeanContactStress = "Mean contact stress σ under the load.", Quantity::MEAN_CONTACT_STRESS;
        ContactPatchDiameter = "Diameter of the contact patch under the load.",
            Quantity::new("contact_patch_diameter_m", "contact patch diameter", "m").by_equation("15");
        NaturalFrequency = "Natural frequency f_n about the rest under one body weight, from k and the mass on the sphere, M/n.",
            Quantity::NATURAL_FREQUENCY;
        EquilibriumFrequency = "Frequency about the rest from gravity and the indentation at rest.",
            Quantity::new("equilibrium_frequency_hz", "equilibrium frequency", "Hz").by_equation("B.5");
        ImpactSpeed = "Speed before the impact.", Quantity::IMPACT_SPEED.by_equation("13");
        Restitution = "Coefficient of restitution c_r that is wanted.",
            Quantity::new("restitution", "restitution", "").by_equation("13").with_limit(&limits::RESTITUTION);
        Dissipation = "Dissipation α that gives it.", Quantity::property(Property::Dissipation).by_equation("13");
        RestitutionExact = "Restitution of the law itself with that dissipation.",
            Quantity::new("restitution_exact_at_this_dissipation", "restitution exact at this dissipation", "")
            .by_equation(DesignQuantity::EXACT_LAW);
        DissipationExact = "Dissipation with which the law itself has the restitution that is wanted; absent for a restitution of 0.",
            Quantity::new("dissipation_for_exact_restitution_s_m", "dissipation for exact restitution", "s/m")
            .by_equation(DesignQuantity::EXACT_LAW);
        ConstantContactForce = "cf, which gives the constant indentation √cf / R that is wanted.",
            Quantity::property(Property::ConstantContactForce).by_equation("C.2");
        HertzSmoothing = "bd, which gives the width of the contact transition that is wanted.",
            Quantity::property(Property::HertzSmoothing).by_equation("C.8");
        HuntCrossleySmoothing = "bv, which gives the width in speed that is wanted.",
            Quantity::property(Property::HuntCrossleySmoothing).by_equation("C.10");
        ForceJustTouching = "Force at rest while the sphere just touches, x = 0; by (C.3) where no dissipation is known.",
            Quantity::FORCE_JUST_TOUCHING;
    }
}

impl DesignQuantity {
    /// The text in the place of an equation, if a figure follows from the contact law itself, which has no number.
    pub const EXACT_LAW: &'static str = "exact";
}

/// Computes a design for a request that names no model.
///
/// # Errors
/// Too little is known, or it contradicts itself; or something is given that only makes sense with a model.
pub fn design_sheet(request: &DesignRequest) -> Result<DesignSheet, RequestFault> {
    if let Some(input) = input_that_needs_a_model(request) {
        let message = phrase![input, " needs a model to work on: name one, or leave it out"];
        return Err(RequestFault::refused(input, message));
    }
    let inputs = DesignInputs::new(request)?;
    let load = inputs.shared_load().map_err(domain_fault)?;
    let given_quantities = inputs.known_quantities(load.as_ref());
    let mut sheet = DesignSheet { schema_version: SCHEMA_VERSION, figures: Vec::new(), remarks: Vec::new() };
    let (sizing, at_rest) = solve_at_rest(&given_quantities, &inputs, request)?;
    match &sizing {
        Some(sizing) => add_sizing(&mut sheet, sizing, &given_quantities, &inputs, load.as_ref(), at_rest)?,
        None if inputs.needs_sizing() => return Err(inputs.missing_inputs()),
        None => {
            if let Some(composite) = inputs.composite_modulus {
                add_moduli(&mut sheet, composite, inputs.modulus, false)?;
            }
        }
    }
    let radius = sizing.map(|sizing| sizing.radius_m).or(inputs.radius_m);
    let composite = sizing.map(|sizing| sizing.composite_modulus_n_m2).or(inputs.composite_modulus);
    add_dissipation(&mut sheet, &request.wanted, radius, inputs.gravity_m_s2)?;
    add_smoothing(&mut sheet, request, radius, composite, at_rest)?;
    if sheet.figures.is_empty() { Err(inputs.missing_inputs()) } else { Ok(sheet) }
}

/// The first input that only makes sense with a model.
fn input_that_needs_a_model(request: &DesignRequest) -> Option<Input> {
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

/// Adds E* and the `stiffness` that OpenSim needs for it.
fn add_moduli(
    sheet: &mut DesignSheet,
    composite: f64,
    from: ModulusSource,
    smoothed: bool,
) -> Result<(), RequestFault> {
    match from.equation() {
        Some(equation) => {
            sheet.add_with_equation(equation, DesignQuantity::CompositeModulus, composite, false);
        }
        None => sheet.add_at_rest(smoothed, DesignQuantity::CompositeModulus, composite, false),
    }
    let surface =
        modulus::of_equal_surfaces(composite, modulus::MixingRule::Sherman).map_err(domain_fault)?;
    sheet.add(DesignQuantity::Stiffness, surface, from == ModulusSource::Stiffness);
    if let ModulusSource::TwoSurfaces([own, other]) = from {
        let opensim = modulus::composite_sherman(own, other).map_err(domain_fault)?;
        sheet.add(DesignQuantity::FirstModulus, own, false);
        sheet.add(DesignQuantity::OtherModulus, other, false);
        sheet.add(DesignQuantity::CompositeModulusOpenSim, opensim, false);
        sheet.add(DesignQuantity::OpenSimOverJohnson, opensim / composite, false);
        let text = "one 'stiffness' for both surfaces is 2^(3/2) E*, by whichever rule E* is; two ContactParameters take the moduli of their \
                    surfaces as they are, and OpenSim combines them by (A.3)";
        sheet.remarks.push(text.to_owned());
    }
    Ok(())
}

/// Adds the quantities of one sphere under its load.
fn add_sizing(
    sheet: &mut DesignSheet,
    sizing: &Sizing,
    known: &KnownQuantities,
    inputs: &DesignInputs,
    load: Option<&SharedLoad>,
    at_rest: Option<RestingContact>,
) -> Result<(), RequestFault> {
    let (radius, x) = (sizing.radius_m, sizing.relative_indentation);
    let (load_n, k) = (sizing.load_per_sphere_n, sizing.stiffness_n_m);
    let smoothed = at_rest.is_some_and(|at_rest| at_rest.speed_state != 1.0);
    sheet.add_at_rest(smoothed, DesignQuantity::LoadPerSphere, load_n, known.load_per_sphere_n.is_some());
    sheet.add(DesignQuantity::Radius, radius, known.radius_m.is_some());
    let x_given = known.relative_indentation.is_some() && inputs.depth == Input::Indentation;
    sheet.add_at_rest(smoothed, DesignQuantity::RelativeIndentation, x, x_given);
    sheet.add(DesignQuantity::Indentation, x * radius, false);
    add_moduli(sheet, sizing.composite_modulus_n_m2, inputs.modulus, smoothed)?;
    sheet.add_at_rest(smoothed, DesignQuantity::ContactStiffness, k, known.stiffness_n_m.is_some());
    let one = SharedLoad::new(load_n, 1.0).map_err(domain_fault)?;
    let dimensionless = stiffness::dimensionless(k, radius, &one).map_err(domain_fault)?;
    let is_given = inputs.depth == Input::DimensionlessStiffness;
    sheet.add(DesignQuantity::DimensionlessStiffness, dimensionless, is_given);
    let stress = patch::mean_stress(load_n, radius, x).map_err(domain_fault)?;
    sheet.add(DesignQuantity::MeanContactStress, stress, inputs.depth == Input::Stress);
    if inputs.depth == Input::Stress {
        let text =
            "the stress is the mean over the contact patch; at its middle it is 1.5 times that by Hertz";
        sheet.remarks.push(text.to_owned());
    }
    let diameter = patch::diameter(x * radius, radius).map_err(domain_fault)?;
    sheet.add(DesignQuantity::ContactPatchDiameter, diameter, false);
    if let (Some(mass), Some(load), true) = (inputs.mass_kg, load, inputs.is_body_weight) {
        let on_sphere = mass / load.sphere_count();
        let frequency = stiffness::natural_frequency(k, on_sphere).map_err(domain_fault)?;
        sheet.add(DesignQuantity::NaturalFrequency, frequency, false);
        let frequency =
            stiffness::equilibrium_frequency(x, radius, inputs.gravity_m_s2).map_err(domain_fault)?;
        sheet.add(DesignQuantity::EquilibriumFrequency, frequency, false);
    }
    sheet.remarks.extend(at_rest.and_then(RestingContact::remark));
    let ways = ways_within_hertz(x).map(|ways| format!("Hertz' law is not accurate at this x/R: {ways}"));
    sheet.remarks.extend(ways);
    if x > 1.0 {
        let text = "a relative indentation above 1: the sphere is softer than its load allows";
        sheet.remarks.push(text.to_owned());
    }
    Ok(())
}

/// Adds the dissipation for the wanted restitution.
fn add_dissipation(
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
            sheet.remarks.push(text.to_owned());
            restitution::drop_speed(gravity, radius).map_err(domain_fault)?
        }
        (None, None) => {
            let message = phrase![
                "{} needs {}, or a radius to take sqrt(gR/2) from";
                Input::Restitution, Input::ImpactSpeed.with_placeholder("M/S")
            ];
            return Err(RequestFault::refused(Input::Restitution, message));
        }
    };
    sheet.add(DesignQuantity::ImpactSpeed, speed, wanted.impact_speed.is_some());
    let alpha = restitution::dissipation(target, speed).map_err(domain_fault)?;
    sheet.add(DesignQuantity::Restitution, target, true);
    sheet.add(DesignQuantity::Dissipation, alpha, false);
    let exact = restitution::exact(alpha, speed).map_err(domain_fault)?;
    sheet.add(DesignQuantity::RestitutionExact, exact, false);
    if target > 0.0 {
        let exact = restitution::exact_dissipation(target, speed).map_err(domain_fault)?;
        sheet.add(DesignQuantity::DissipationExact, exact, false);
    }
    Ok(())
}

/// Adds the smoothing for the wanted transition.
fn add_smoothing(
    sheet: &mut DesignSheet,
    request: &DesignRequest,
    radius: Option<f64>,
    composite: Option<f64>,
    at_rest: Option<RestingContact>,
) -> Result<(), RequestFault> {
    let need = |input: Input| {
        radius.ok_or_else(|| {
            let message = phrase![input, " needs a radius: give ", Input::Radius.with_placeholder("METRES")];
            RequestFault::refused(input, message)
        })
    };
    let wanted = &request.wanted;
    let t = wanted.threshold.get();
    let (mut cf, mut bd) = (None, None);
    if let Some(x) = wanted.constant_indentation.map(ConstantIndentation::get) {
        let radius = need(Input::ConstantIndentation)?;
        let value = smoothing::constant_contact_force(x, radius).map_err(domain_fault)?;
        sheet.add(DesignQuantity::ConstantContactForce, value, false);
        cf = Some(value);
    }
    if let Some(width) = wanted.state_width.map(Positive::get) {
        let radius = need(Input::StateWidth)?;
        let value = smoothing::hertz_smoothing_for_width(t, width, radius).map_err(domain_fault)?;
        sheet.add(DesignQuantity::HertzSmoothing, value, false);
        bd = Some(value);
    } else if let Some(reduced) = request.state_smoothing {
        let radius = need(Input::StateSmoothing)?;
        let value = smoothing::hertz_smoothing(reduced.get(), radius).map_err(domain_fault)?;
        sheet.add_with_equation("C.5", DesignQuantity::HertzSmoothing, value, false);
        bd = Some(value);
    }
    if request.speed_smoothing.is_some() {
        need(Input::SpeedSmoothing)?;
    }
    if let Some(value) = speed_smoothing(request, radius)? {
        sheet.add(DesignQuantity::HuntCrossleySmoothing, value, false);
    }
    if let (Some(constant_contact_force), Some(hertz_smoothing), Some(radius), Some(composite)) =
        (cf, bd, radius, composite)
    {
        let values =
            SmoothingValues { constant_contact_force, hertz_smoothing, ..SmoothingValues::OPENSIM_DEFAULT };
        let hertz = Hertz::sphere(composite, radius).map_err(domain_fault)?;
        let elastic = SmoothSphere::new(hertz, 0.0, values).map_err(domain_fault)?.elastic_force(0.0);
        match at_rest {
            Some(known) => sheet.add(DesignQuantity::ForceJustTouching, elastic * known.speed_state, false),
            None => sheet.add_with_equation("C.3", DesignQuantity::ForceJustTouching, elastic, false),
        }
    }
    Ok(())
}
