//! Drop tests: a body falls on its contacts. Has the register of the figures of a drop.

use std::path::{Path, PathBuf};

use contact_scaling::drop_test::{
    Difference, DropError, DropReport, DropTest, DropValues, LiftOff, Sample, compare,
};
use contact_scaling::{Contact, ContactValues, Law, Preset, Spheres};
use osim_inspect::series::standing_spheres;
use osim_inspect::{
    ContactsOrigin, LoadSharing, MassMismatch, Quantity, Stance, unexplained_mass, weight_share_on_floor,
};
use osim_model::files::{Failure, FileName, Files, OpenModel};
use osim_model::messages::{Input, Phrase, phrase, readable};
use osim_model::{CountedSpheres, Fault, GravityFor, MassRequest, MissingFact};
use osim_requests::{Count, DropTestRequest, Kilograms, NotNegative, Positive, RequestFault, Result};

use self::DropRow::{InOrder, Last, Nowhere};
use self::FigureValue::{Always, Sometimes};
use crate::calculator::{STANDARD_GRAVITY_M_S2, domain_fault};
use crate::opening::ModelOrPreset;

/// Result of a drop test.
#[derive(Debug, Clone)]
pub struct DropResult {
    /// The name of the model or preset, or a text that the drop was given by numbers.
    pub name: FileName,
    pub values: DropValues,
    /// Number n of spheres that share the weight.
    pub sphere_count: f64,
    pub report: DropReport,
    /// Whether only the foot of the body falls.
    pub is_of_foot: bool,
    /// Comparison with another drop, if the request names one.
    pub compared: Option<ComparedDrop>,
    /// The bodies whose mass differs from the mass that their contacts were made for, by name.
    pub mismatches: Vec<(String, MassMismatch)>,
}

/// The fall of another body, with which a drop test is compared.
#[derive(Debug, Clone)]
pub struct ComparedDrop {
    pub name: FileName,
    /// Dimensionless differences of the two drops.
    pub difference: Difference,
}

/// A body with its contacts, ready to fall.
struct PreparedDrop {
    name: FileName,
    test: DropTest,
    sphere_count: f64,
    mismatch: Option<MassMismatch>,
}

/// The options for one of the two bodies. Options for the first body do not apply to the body that it is compared with.
struct BodyOptions {
    mass_kg: Option<f64>,
    spheres: Option<f64>,
    stance_limbs: Option<f64>,
    gravity_m_s2: Option<f64>,
    foot_kg: Option<f64>,
    count_of: CountedSpheres,
}

/// Lets the body of the request fall on its contacts.
///
/// # Errors
/// Numbers that are missing or contradict a model, a model that cannot be read, or a drop that cannot be followed.
pub fn run_drop_test(request: &DropTestRequest, files: &dyn Files) -> Result<DropResult> {
    let prepared_drop = drop_of_subject(request, files)?;
    let named = |path: &PathBuf| drop_of_named(request, path, &options_for_compared(request), files);
    let other = request.compare.as_ref().map(named).transpose()?;
    let failed = |error: DropError| Failure::outside(&prepared_drop.name, "drop-test", error.to_string());
    let report = prepared_drop.test.run().map_err(failed)?;
    let is_finite = |sample| DropColumn::ALL.iter().all(|column| column.value(&report, sample).is_finite());
    if !report.series.iter().all(is_finite) {
        let why = "the series of this drop is not finite, expected a shorter duration, or masses, radii and gravity of a real body";
        return Err(Failure::outside(&prepared_drop.name, "drop-test", why).into());
    }
    let compared = |other: &PreparedDrop| {
        let difference = compare(&prepared_drop.test, &other.test)?;
        Ok(ComparedDrop { name: other.name.clone(), difference })
    };
    let compared = other.as_ref().map(compared).transpose().map_err(failed)?;
    let values = prepared_drop.test.values();
    let both = [Some(&prepared_drop), other.as_ref()].into_iter().flatten();
    let mismatches = both.filter_map(|one| Some((one.name.to_string(), one.mismatch.clone()?))).collect();
    let (name, sphere_count) = (prepared_drop.name.clone(), prepared_drop.sphere_count);
    let is_of_foot = request.foot_mass.is_some();
    Ok(DropResult { name, values, sphere_count, report, is_of_foot, compared, mismatches })
}

/// The options of the body that the request lets fall.
fn options_for_subject(request: &DropTestRequest) -> BodyOptions {
    BodyOptions {
        mass_kg: request.masses.mass.map(Kilograms::get),
        spheres: request.counts.spheres(),
        stance_limbs: request.counts.stance_limbs.map(Count::get),
        gravity_m_s2: request.numbers.gravity(),
        foot_kg: request.foot_mass.map(Kilograms::get),
        count_of: CountedSpheres::Model,
    }
}

/// The options of the body that it is compared with.
fn options_for_compared(request: &DropTestRequest) -> BodyOptions {
    BodyOptions {
        mass_kg: None,
        spheres: request.compare_spheres.map(Count::get),
        stance_limbs: None,
        gravity_m_s2: None,
        foot_kg: None,
        count_of: CountedSpheres::Compared,
    }
}

/// Prepares the body that the request names: a model, a preset, or a body given by numbers.
fn drop_of_subject(request: &DropTestRequest, files: &dyn Files) -> Result<PreparedDrop> {
    let Some(path) = &request.subject else { return Ok(drop_of_numbers(request)?) };
    let given = request.numbers.given_inputs();
    if !given.is_empty() {
        let message = phrase!["a model or preset has its own numbers: leave out ", &listed_inputs(given)];
        return Err(RequestFault::general(message).into());
    }
    drop_of_named(request, path, &options_for_subject(request), files)
}

/// Prepares the model or preset of this name.
fn drop_of_named(
    request: &DropTestRequest,
    path: &Path,
    own: &BodyOptions,
    files: &dyn Files,
) -> Result<PreparedDrop> {
    match ModelOrPreset::find(path, request.presets.as_deref(), &request.set_files, files)? {
        ModelOrPreset::Preset(preset) => Ok(drop_of_preset(request, &preset, own)?),
        ModelOrPreset::Model(open) => {
            Ok(drop_of_model(request, &open, own).map_err(|fault| open.failure(fault))?)
        }
    }
}

/// Prepares a model that was opened.
fn drop_of_model(
    request: &DropTestRequest,
    open: &OpenModel,
    own: &BodyOptions,
) -> Result<PreparedDrop, Fault> {
    let model = &open.model;
    let masses = MassRequest { model_kg: own.mass_kg, ..request.masses.request() };
    let suspicion = unexplained_mass(&masses, model, &request.choice.selection());
    request.answers.require_yes(suspicion).map_err(Fault::new)?;
    let selected = request.choice.selection().apply(model)?;
    let mass = masses.model_mass(model)?;
    let stance = Stance { spheres: own.spheres, limbs: own.stance_limbs, ..Stance::default() };
    let sharing = LoadSharing::of(model, &selected.forces);
    let count = sharing.count(own.spheres, stance.limb_count(model), own.count_of)?;
    let spheres = standing_spheres(model, &selected.forces, count)?;
    let gravity = own.gravity_m_s2.or(model.gravity().filter(|&gravity| gravity > 0.0));
    let Some(gravity) = gravity else {
        // The option `gravity` applies to the first body alone.
        let purpose = match own.count_of {
            CountedSpheres::Compared => GravityFor::Compared,
            _ => GravityFor::Weight,
        };
        return Err(Fault::new(MissingFact::Gravity { purpose }));
    };
    // The body falls along the normal of its floor.
    let along_normal = gravity * weight_share_on_floor(model, &sharing.forces);
    let mass_kg = falling_kg(own.foot_kg, mass.kg).map_err(Fault::refused)?;
    let weight = Weight { mass_kg, gravity_m_s2: along_normal, sphere_count: count };
    let prepared_drop = prepare_drop(request, open.name(), spheres, &weight)
        .map_err(|error| Fault::refused(error.to_string()))?;
    let origin = ContactsOrigin::find(model, &selected.forces, &masses, &stance).ok();
    let mismatch = MassMismatch::find(model, &masses, origin.as_ref().map(|origin| &origin.mass));
    Ok(PreparedDrop { mismatch, ..prepared_drop })
}

/// Prepares a body on the contacts of a preset.
fn drop_of_preset(
    request: &DropTestRequest,
    preset: &Preset,
    own: &BodyOptions,
) -> Result<PreparedDrop, RequestFault> {
    let scale = &preset.scale;
    let on_limbs = scale.sphere_count() * own.stance_limbs.unwrap_or(1.0);
    let count = own.spheres.unwrap_or(on_limbs);
    let weight = Weight {
        mass_kg: falling_kg(own.foot_kg, own.mass_kg.unwrap_or(scale.mass_kg())).map_err(domain_fault)?,
        gravity_m_s2: own.gravity_m_s2.unwrap_or(scale.gravity_m_s2()),
        sphere_count: count,
    };
    let spheres = Law::of(&preset.contact, scale.radius_m()).and_then(|law| Spheres::new(law, count));
    let spheres = vec![spheres.map_err(domain_fault)?];
    prepare_drop(request, &*preset.name, spheres, &weight).map_err(domain_fault)
}

/// Prepares a body whose contact the request gives by its numbers.
fn drop_of_numbers(request: &DropTestRequest) -> Result<PreparedDrop, RequestFault> {
    let numbers = &request.numbers;
    let needed = [
        (Input::Mass, request.masses.mass.map(Kilograms::get)),
        (Input::Spheres, request.counts.spheres()),
        (Input::Radius, numbers.radius.map(Positive::get)),
        (Input::Stiffness, numbers.stiffness.map(Positive::get)),
        (Input::Dissipation, numbers.dissipation.map(NotNegative::get)),
    ];
    let missing: Vec<Input> =
        needed.iter().filter(|(_, value)| value.is_none()).map(|(input, _)| *input).collect();
    let [Some(mass), Some(count), Some(radius), Some(plane_strain_modulus), Some(dissipation)] =
        needed.map(|(_, value)| value)
    else {
        let message = phrase![
            "nothing to drop: name a model or a preset, or give the numbers; missing: ",
            &listed_inputs(missing),
        ];
        return Err(RequestFault::general(message));
    };
    let values = ContactValues { plane_strain_modulus, dissipation, smoothing: numbers.smoothing()? };
    let law = Contact::new(values).and_then(|contact| Law::of(&contact, radius));
    let spheres = vec![law.and_then(|law| Spheres::new(law, count)).map_err(domain_fault)?];
    let gravity_m_s2 = numbers.gravity().unwrap_or(STANDARD_GRAVITY_M_S2);
    let mass_kg = falling_kg(request.foot_mass.map(Kilograms::get), mass).map_err(domain_fault)?;
    let weight = Weight { mass_kg, gravity_m_s2, sphere_count: count };
    prepare_drop(request, "the numbers given", spheres, &weight).map_err(domain_fault)
}

/// The mass that falls, kg: that of the foot, if it is given.
///
/// # Errors
/// The foot is heavier than the body.
fn falling_kg(foot_kg: Option<f64>, body_kg: f64) -> Result<f64, String> {
    let falling_kg = foot_kg.unwrap_or(body_kg);
    let [foot, body] = [falling_kg, body_kg].map(readable);
    let why = format!("the foot ({foot} kg) is heavier than its body ({body} kg)");
    if falling_kg > body_kg { Err(why) } else { Ok(falling_kg) }
}

/// The mass that falls, its gravity, and the number of spheres that share its weight.
struct Weight {
    mass_kg: f64,
    gravity_m_s2: f64,
    sphere_count: f64,
}

/// A body with its contacts and its weight, ready to fall.
fn prepare_drop(
    request: &DropTestRequest,
    name: impl Into<FileName>,
    spheres: Vec<Spheres>,
    weight: &Weight,
) -> Result<PreparedDrop, DropError> {
    let values = DropValues {
        mass_kg: weight.mass_kg,
        gravity_m_s2: weight.gravity_m_s2,
        height_m: 0.0,
        duration_s: request.duration.get(),
        samples: request.samples.get() as usize,
    };
    let on_ground = DropTest::new(spheres, values)?;
    let height_m = request.height.metres(on_ground.reference_radius_m());
    let test = DropTest::new(on_ground.spheres().to_vec(), DropValues { height_m, ..values })?;
    Ok(PreparedDrop { name: name.into(), test, sphere_count: weight.sphere_count, mismatch: None })
}

fn listed_inputs(inputs: Vec<Input>) -> Phrase {
    Phrase::joined(inputs.into_iter().map(Phrase::from), ", ").unwrap_or_default()
}

// The one register of the figures of a drop, and of the columns of its series. A new one is a new entry here, and a test.

/// An entry of the register of drop figures: where the table shows the figure, and how its value is computed.
type DropFigureEntry = (DropRow, FigureValue);

/// The function that computes a number of a drop.
enum FigureValue {
    Always(fn(&DropResult) -> f64),
    /// The function of a number that only some drops have, for example drops after which the body lifts off again.
    Sometimes(fn(&DropResult) -> Option<f64>),
}

/// The part of the table that shows a number. JSON has all numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DropRow {
    /// The figure is not in the table. It may be in the line above the table.
    Nowhere,
    /// The figure is in the order of the register.
    InOrder,
    /// The figure comes after all others.
    Last,
}

osim_inspect::quantities! {
    /// A figure of a drop, see [`Quantity`]; in the order of the JSON.
    DropFigure: DropFigureEntry {
        Mass = "Mass M of the body.", Quantity::new("mass_kg", "mass", "kg") => (Nowhere, Always(|drop| drop.values.mass_kg));
        SphereCount = "Spheres n that share the weight.",
            Quantity::new("sphere_count", "spheres", "") => (Nowhere, Always(|drop| drop.sphere_count));
        Gravity = "Gravity g.", Quantity::new("gravity_m_s2", "gravity", "m/s2") => (Nowhere, Always(|drop| drop.values.gravity_m_s2));
        Height = "Height of the sphere bottoms at the start.",
            Quantity::new("height_m", "height", "m") => (Nowhere, Always(|drop| drop.values.height_m));
        Duration = "How long the body was followed.",
            Quantity::new("duration_s", "duration", "s") => (Nowhere, Always(|drop| drop.values.duration_s));
        ReferenceRadius = "R = √(Σ R_i²/n): what lengths are divided by.", Quantity::new("reference_radius_m", "radius", "m")
            => (Nowhere, Always(|drop| drop.report.reference_radius_m));
        ReferenceTime = "√(R/g): what to divide times by before animals of different size are compared.",
            Quantity::new("reference_time_s", "time unit sqrt(R/g)", "s")
            => (Last, Always(|drop| drop.report.reference_time_s));
        FinalIndentation = "x̂ at the end of the series.", Quantity::new("final_relative_indentation", "indentation/radius at the end", "")
            => (InOrder, Always(|drop| drop.report.final_indentation_m / drop.report.reference_radius_m));
        IndentationHertz = "x̂ that the Hertz law (1) gives under body weight: the x̂ of the paper, of `design` and of scaling.",
            Quantity::INDENTATION_HERTZ.labelled("  at rest, Hertz law")
            => (InOrder, Always(|drop| drop.report.hertz_indentation_m / drop.report.reference_radius_m));
        IndentationModelLaw = "x̂ where the force by the model's law at speed 0, (C.9) for a smoothed one, equals body weight.",
            Quantity::INDENTATION_MODEL_LAW.labelled("  at rest, the model's law").by_equation("")
            => (InOrder, Always(|drop| drop.report.equilibrium_indentation_m / drop.report.reference_radius_m));
        PeakForce = "The largest force of all spheres together.",
            Quantity::new("peak_force_n", "peak force", "N") => (InOrder, Always(|drop| drop.report.peak_force_n));
        PeakForceBw = "The largest force over body weight.", Quantity::new("peak_force_bw", "peak force/body weight", "")
            => (InOrder, Always(|drop| drop.report.peak_force_bw()));
        EquilibriumStiffness = "Slope of the force of one sphere where it rests, by the model's law; the mean of spheres that differ.",
            Quantity::new("equilibrium_stiffness_n_m", "stiffness of one sphere at rest, model's law", "N/m")
            => (InOrder, Always(|drop| drop.report.equilibrium_stiffness_n_m));
        HertzStiffness = "Slope of the Hertz force of one sphere where it rests: the k of Table 1.",
            Quantity::new("hertz_stiffness_n_m", "stiffness of one sphere at rest, Hertz", "N/m").by_equation("B.1")
            => (InOrder, Always(|drop| drop.report.hertz_stiffness_n_m));
        ImpactSpeed = "Speed at height 0: smoothed forces brake before, so it is a little below √(2gh). Absent where the ground is not reached.",
            Quantity::IMPACT_SPEED
            => (InOrder, Sometimes(|drop| Some(drop.report.first_contact?.impact_speed_m_s)));
        RestitutionExact = "Restitution of an impact at this speed by (12), if there were no gravity.",
            Quantity::RESTITUTION_EXACT.labelled("restitution without gravity, exact")
            => (InOrder, Sometimes(|drop| Some(drop.report.first_contact?.restitution_exact)));
        RestitutionApproximate = "Restitution of an impact at this speed by (13), 1 − α ẋ. Absent if it is below 0.",
            Quantity::RESTITUTION_APPROXIMATE
            => (InOrder, Sometimes(|drop| drop.report.first_contact?.restitution_approximate));
        ContactTime = "Time from touch-down to lift-off. Absent where the body does not leave the ground again.",
            Quantity::new("contact_time_s", "contact time", "s")
            => (InOrder, Sometimes(|drop| Some(lift_off(drop)?.contact_time_s)));
        ReboundSpeed = "Speed at lift-off. Absent where the body does not leave the ground again.",
            Quantity::new("rebound_speed_m_s", "rebound speed", "m/s")
            => (InOrder, Sometimes(|drop| Some(lift_off(drop)?.rebound_speed_m_s)));
    }
}

impl DropFigure {
    pub const fn row(self) -> DropRow {
        self.entry().0
    }

    /// Whether every drop has this figure. If not, the figure may be absent.
    pub const fn is_always_known(self) -> bool {
        matches!(self.entry().1, Always(_))
    }

    /// The value of this figure for a drop; `None` if the drop does not have it.
    pub fn value(self, drop: &DropResult) -> Option<f64> {
        match self.entry().1 {
            Always(value) => Some(value(drop)),
            Sometimes(value) => value(drop),
        }
    }
}

/// The end of the first contact, if the body leaves the ground.
fn lift_off(drop: &DropResult) -> Option<LiftOff> {
    drop.report.first_contact?.end
}

/// A function that gives the value of a column at one moment of a drop.
type ColumnAtMoment = fn(&DropReport, &Sample) -> f64;

osim_inspect::quantities! {
    /// A column of the series of a drop, see [`Quantity`].
    DropColumn: ColumnAtMoment {
        Time = "Time.", Quantity::new("time_s", "time", "s") => |_, sample| sample.time_s;
        Height = "Height of the sphere bottoms; below 0 they are in the ground.",
            Quantity::new("height_m", "height", "m") => |_, sample| sample.height_m;
        Speed = "Speed, upwards.", Quantity::new("speed_m_s", "speed", "m/s") => |_, sample| sample.speed_m_s;
        Force = "Force of all spheres.", Quantity::new("force_n", "force", "N") => |_, sample| sample.force_n;
        ForceBw = "Force of all spheres over body weight.", Quantity::new("force_bw", "force/body weight", "")
            => |report, sample| sample.force_n / report.body_weight_n;
        DimensionlessTime = "Time over √(R/g).", Quantity::new("dimensionless_time", "time/sqrt(R/g)", "")
            => |report, sample| sample.time_s / report.reference_time_s;
    }
}

impl DropColumn {
    /// The value of this column at one moment of a drop.
    pub fn value(self, report: &DropReport, sample: &Sample) -> f64 {
        (self.entry())(report, sample)
    }
}
