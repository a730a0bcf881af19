//! `design` without a model: from what is known, every figure that follows, with its equation and limit.

use anyhow::{Result, bail};
use contact_scaling::sizing::{Known, Sizing, SizingError};
use contact_scaling::{
    Hertz, SharedLoad, SmoothSphere, SmoothingValues, limits, modulus, patch, restitution, smoothing,
    stiffness,
};
use osim_patch::{Property, RadiusRule};
use serde::Serialize;

use crate::args::DesignArgs;
use crate::drop::STANDARD_GRAVITY;
use crate::report::{json, number, right, table};
use crate::terminal::{Exit, Terminal};

/// One figure of the sheet.
#[derive(Serialize)]
struct Figure {
    name: &'static str,
    value: f64,
    unit: &'static str,
    equation: &'static str,
    given: bool,
    limit: Option<Limit>,
}

#[derive(Serialize)]
struct Limit {
    text: &'static str,
    holds: bool,
}

#[derive(Serialize)]
struct Sheet {
    schema_version: u32,
    figures: Vec<Figure>,
    notes: Vec<String>,
}

/// Calculates and prints.
///
/// # Errors
/// Too little is known, or it contradicts itself.
pub(crate) fn run(args: &DesignArgs, terminal: &mut Terminal) -> Result<Exit> {
    if let Some(option) = without_meaning(args) {
        bail!("{option} needs a model to work on: name one, or leave it out");
    }
    let sheet = sheet(args)?;
    let text = if args.run.is_json() { json::line(&sheet) } else { text(&sheet) };
    terminal.print(&text)?;
    Ok(Exit::Done)
}

/// An option that only makes sense with a model.
fn without_meaning(args: &DesignArgs) -> Option<&'static str> {
    let output = &args.output;
    let given = [
        ("--output", output.output.is_some()),
        ("--output-dir", output.output_dir.is_some()),
        ("--in-place", output.in_place),
        ("--dry-run", args.run.dry_run),
        ("--diff", args.run.diff),
        ("--summary", args.run.summary.is_some()),
        ("--shard", args.run.shard.is_some()),
        ("--force", output.force),
        ("--no-note", output.no_note),
        ("--select", !args.choice.select.is_empty()),
        ("--exclude", !args.choice.exclude.is_empty()),
        ("--skip-disabled", args.choice.skip_disabled),
        ("--exclude-body", !args.masses.exclude_body.is_empty()),
        ("--contacts-mass", args.masses.contacts_mass.is_some()),
        ("--geometry", args.parts.geometry.is_some()),
        ("--model", args.parts.model.is_some()),
    ];
    given.into_iter().find(|(_, given)| *given).map(|(option, _)| option)
}

/// What the options say, before anything is derived.
struct Inputs {
    mass_kg: Option<f64>,
    spheres: Option<f64>,
    gravity_m_s2: f64,
    load_n: Option<f64>,
    radius_m: Option<f64>,
    composite_modulus: Option<f64>,
    modulus: ModulusFrom,
    /// The load is what the spheres carry at rest.
    is_body_weight: bool,
}

/// Where the composite modulus comes from.
#[derive(Clone, Copy, PartialEq)]
enum ModulusFrom {
    Young,
    Stiffness,
    Sizing,
}

impl ModulusFrom {
    fn equation(self) -> &'static str {
        match self {
            Self::Young => "A.1, A.5",
            Self::Stiffness => "A.4",
            Self::Sizing => "11",
        }
    }
}

impl Inputs {
    fn of(args: &DesignArgs) -> Result<Self> {
        let wanted = &args.wanted;
        let radius_m = match wanted.radius {
            None => None,
            Some(RadiusRule::Metres(metres)) => Some(metres),
            Some(_) => bail!(
                "--radius needs metres here: there is no model whose radius could be kept or multiplied"
            ),
        };
        let gravity_m_s2 = args.load.gravity.unwrap_or(STANDARD_GRAVITY);
        let mass_kg = args.masses.mass;
        if args.load.body_weights.is_some() && mass_kg.is_none() {
            bail!("--body-weights needs --mass KG");
        }
        let weight = mass_kg.map(|kg| kg * gravity_m_s2 * args.load.body_weights.unwrap_or(1.0));
        let (composite_modulus, modulus) = match (wanted.young.zip(wanted.poisson), wanted.stiffness) {
            // A soft body on rigid ground (A.5): E* is the body's own plane strain modulus.
            (Some((young, poisson)), _) => (Some(modulus::plane_strain(young, poisson)?), ModulusFrom::Young),
            (None, Some(surface)) => {
                let composite = modulus::composite_of_equal(surface, modulus::MixingRule::Sherman)?;
                (Some(composite), ModulusFrom::Stiffness)
            }
            (None, None) => (None, ModulusFrom::Sizing),
        };
        let load_n = args.load.load.or(weight);
        let is_body_weight = args.load.load.is_none() && args.load.body_weights.unwrap_or(1.0) == 1.0;
        let spheres = args.counts.spheres;
        Ok(Self {
            mass_kg,
            spheres,
            gravity_m_s2,
            load_n,
            radius_m,
            composite_modulus,
            modulus,
            is_body_weight,
        })
    }

    fn shared_load(&self) -> Result<Option<SharedLoad>> {
        Ok(match (self.load_n, self.spheres) {
            (Some(load), Some(spheres)) => Some(SharedLoad::new(load, spheres)?),
            _ => None,
        })
    }
}

fn sheet(args: &DesignArgs) -> Result<Sheet> {
    let inputs = Inputs::of(args)?;
    let load = inputs.shared_load()?;
    let wanted = &args.wanted;
    let known = Known {
        load_per_sphere_n: load.map(|load| load.per_sphere_n()),
        radius_m: inputs.radius_m,
        relative_indentation: wanted.indentation,
        composite_modulus_n_m2: inputs.composite_modulus,
        stiffness_n_m: wanted.contact_stiffness,
    };
    let mut sheet = Sheet { schema_version: 1, figures: vec![], notes: vec![] };
    let sizing = match known.solve() {
        Ok(sizing) => Some(sizing),
        // Some figures need no sizing; whether anything is left to say is seen at the end.
        Err(SizingError::Insufficient { .. }) => None,
        Err(SizingError::Contradictory { quantity, given, follows }) => {
            bail!("{}", contradiction(quantity, given, follows, &inputs)?)
        }
        Err(error) => bail!("{error}"),
    };
    match &sizing {
        Some(sizing) => sized(&mut sheet, sizing, &known, &inputs, load.as_ref())?,
        None => {
            if wanted.indentation.is_some() || wanted.contact_stiffness.is_some() {
                bail!("{}", missing(&inputs, args));
            }
            if let Some(composite) = inputs.composite_modulus {
                moduli(&mut sheet, composite, inputs.modulus)?;
            }
        }
    }
    let radius = sizing.map(|sizing| sizing.radius_m).or(inputs.radius_m);
    let composite = sizing.map(|sizing| sizing.composite_modulus_n_m2).or(inputs.composite_modulus);
    dissipation(&mut sheet, args, radius, inputs.gravity_m_s2)?;
    smoothed(&mut sheet, args, radius, composite)?;
    if sheet.figures.is_empty() {
        bail!("{}", missing(&inputs, args));
    }
    Ok(sheet)
}

/// What to add, by the names of the options.
fn missing(inputs: &Inputs, args: &DesignArgs) -> String {
    let wanted = &args.wanted;
    let load = inputs.load_n.is_some() && inputs.spheres.is_some();
    let have = [
        (load, "load per sphere", "--mass KG (or --load N) with --spheres N"),
        (inputs.radius_m.is_some(), "radius", "--radius METRES"),
        (wanted.indentation.is_some(), "indentation", "--indentation X"),
        (inputs.composite_modulus.is_some(), "modulus", "--stiffness E1 (or --young E --poisson NU)"),
        (wanted.contact_stiffness.is_some(), "contact stiffness", "--contact-stiffness N/M"),
    ];
    let known: Vec<_> = have.iter().filter(|(have, ..)| *have).map(|(_, name, _)| *name).collect();
    let options: Vec<_> = have.iter().filter(|(have, ..)| !have).map(|(.., option)| *option).collect();
    let half = match (inputs.load_n.is_some(), inputs.spheres.is_some()) {
        (true, false) => "; the load needs --spheres N too",
        (false, true) => "; --spheres needs --mass KG or --load N too",
        _ => "",
    };
    let known = if known.is_empty() { "nothing".to_owned() } else { known.join(", ") };
    format!(
        "too little is known: three quantities give the rest, known: {known}{half}; add of: {}",
        options.join("; ")
    )
}

/// What disagrees, by the name and in the unit of the option.
fn contradiction(quantity: &str, given: f64, follows: f64, inputs: &Inputs) -> Result<String> {
    let surface = |composite| modulus::of_equal_surfaces(composite, modulus::MixingRule::Sherman);
    let (option, given, follows) = match (quantity, inputs.modulus) {
        ("load", _) => ("the load on each sphere, N,", given, follows),
        ("radius", _) => ("--radius", given, follows),
        ("indentation", _) => ("--indentation", given, follows),
        ("modulus", ModulusFrom::Stiffness) => ("--stiffness", surface(given)?, surface(follows)?),
        ("modulus", _) => ("--young and --poisson: the composite modulus, N/m2,", given, follows),
        _ => ("--contact-stiffness", given, follows),
    };
    Ok(format!(
        "{option} is given as {}, but {} follows from the other quantities: leave one out",
        number(given),
        number(follows)
    ))
}

impl Sheet {
    fn add(
        &mut self,
        name: &'static str,
        value: f64,
        unit: &'static str,
        equation: &'static str,
        given: bool,
    ) {
        self.figures.push(Figure { name, value, unit, equation, given, limit: None });
    }

    fn limited(&mut self, text: &'static str, holds: bool) {
        if let Some(figure) = self.figures.last_mut() {
            figure.limit = Some(Limit { text, holds });
        }
    }
}

fn moduli(sheet: &mut Sheet, composite: f64, from: ModulusFrom) -> Result<()> {
    sheet.add("composite_modulus_n_m2", composite, "N/m^2", from.equation(), false);
    let surface = modulus::of_equal_surfaces(composite, modulus::MixingRule::Sherman)?;
    sheet.add("stiffness", surface, "N/m^2", "A.4", from == ModulusFrom::Stiffness);
    Ok(())
}

fn sized(
    sheet: &mut Sheet,
    sizing: &Sizing,
    known: &Known,
    inputs: &Inputs,
    load: Option<&SharedLoad>,
) -> Result<()> {
    let (radius, x) = (sizing.radius_m, sizing.relative_indentation);
    sheet.add("load_per_sphere_n", sizing.load_per_sphere_n, "N", "3", known.load_per_sphere_n.is_some());
    sheet.add("radius_m", radius, "m", "11, B.2", known.radius_m.is_some());
    sheet.add("relative_indentation", x, "", "2, 11", known.relative_indentation.is_some());
    sheet.limited("at most 0.16 (Hertz)", limits::hertz_holds(x));
    sheet.add("indentation_m", x * radius, "m", "2", false);
    let composite = sizing.composite_modulus_n_m2;
    moduli(sheet, composite, inputs.modulus)?;
    let given = known.stiffness_n_m.is_some();
    sheet.add("contact_stiffness_n_m", sizing.stiffness_n_m, "N/m", "B.2", given);
    let one = SharedLoad::new(sizing.load_per_sphere_n, 1.0)?;
    let pure = stiffness::dimensionless(sizing.stiffness_n_m, radius, &one)?;
    sheet.add("dimensionless_stiffness", pure, "", "B.3", false);
    let stress = patch::mean_stress(sizing.load_per_sphere_n, radius, x)?;
    sheet.add("mean_contact_stress_n_m2", stress, "N/m^2", "15", false);
    sheet.add("contact_patch_diameter_m", patch::diameter(x * radius, radius)?, "m", "15", false);
    if let (Some(mass), Some(load), true) = (inputs.mass_kg, load, inputs.is_body_weight) {
        let on_sphere = mass / load.sphere_count();
        let frequency = stiffness::natural_frequency(sizing.stiffness_n_m, on_sphere)?;
        sheet.add("natural_frequency_hz", frequency, "Hz", "B.4", false);
        let frequency = stiffness::equilibrium_frequency(x, radius, inputs.gravity_m_s2)?;
        sheet.add("equilibrium_frequency_hz", frequency, "Hz", "B.5", false);
    }
    if x > 1.0 {
        sheet
            .notes
            .push("a relative indentation above 1: the sphere is softer than its load allows".to_owned());
    }
    Ok(())
}

fn dissipation(sheet: &mut Sheet, args: &DesignArgs, radius: Option<f64>, gravity: f64) -> Result<()> {
    let wanted = &args.wanted;
    let Some(target) = wanted.restitution else { return Ok(()) };
    let speed = match (wanted.impact_speed, radius) {
        (Some(speed), _) => speed,
        (None, Some(radius)) => {
            let text = "the impact speed is that of a fall from a quarter of the radius, sqrt(gR/2)";
            sheet.notes.push(text.to_owned());
            restitution::drop_speed(gravity, radius)?
        }
        (None, None) => bail!("--restitution needs --impact-speed M/S, or a radius to take sqrt(gR/2) from"),
    };
    sheet.add("impact_speed_m_s", speed, "m/s", "13", wanted.impact_speed.is_some());
    let alpha = restitution::dissipation(target, speed)?;
    sheet.add("restitution", target, "", "13", true);
    sheet.limited("at least 0.8 (Hunt-Crossley)", limits::hunt_crossley_holds(target));
    sheet.add("dissipation", alpha, "s/m", "13", false);
    let exact = restitution::exact(alpha, speed)?;
    sheet.add("restitution_exact_at_this_dissipation", exact, "", "exact", false);
    if target > 0.0 {
        let exact = restitution::exact_dissipation(target, speed)?;
        sheet.add("dissipation_for_exact_restitution", exact, "s/m", "exact", false);
    }
    Ok(())
}

fn smoothed(sheet: &mut Sheet, args: &DesignArgs, radius: Option<f64>, composite: Option<f64>) -> Result<()> {
    let wanted = &args.wanted;
    let need = |option: &str| -> Result<f64> {
        match radius {
            Some(radius) => Ok(radius),
            None => bail!("{option} needs a radius: say --radius METRES"),
        }
    };
    let t = wanted.threshold;
    let mut cf = None;
    let mut bd = None;
    if let Some(x) = wanted.constant_indentation {
        let value = smoothing::constant_contact_force(x, need("--constant-indentation")?)?;
        sheet.add("constant_contact_force", value, "m^2", "C.2", false);
        cf = Some(value);
    }
    if let Some(width) = wanted.state_width {
        let value = smoothing::hertz_smoothing_for_width(t, width, need("--state-width")?)?;
        sheet.add("hertz_smoothing", value, "1/m", "C.8", false);
        bd = Some(value);
    }
    if let Some(width) = wanted.speed_width {
        let value = smoothing::hunt_crossley_smoothing_for_speed_width(t, width)?;
        sheet.add("hunt_crossley_smoothing", value, "s/m", "C.10", false);
    }
    if let (Some(constant_contact_force), Some(hertz_smoothing), Some(radius), Some(composite)) =
        (cf, bd, radius, composite)
    {
        let values = SmoothingValues {
            constant_contact_force,
            hertz_smoothing,
            hunt_crossley_smoothing: SmoothingValues::OPENSIM_DEFAULT.hunt_crossley_smoothing,
        };
        let law = SmoothSphere::new(Hertz::sphere(composite, radius)?, 0.0, values)?;
        sheet.add("force_just_touching_n", law.elastic_force(0.0), "N", "C.3", false);
    }
    Ok(())
}

/// `contact_patch_diameter_m` is contact patch diameter; OpenSim's own names stay as OpenSim spells them.
fn name_for_people(name: &str) -> String {
    if Property::ALL.iter().any(|property| property.name() == name) {
        return name.to_owned();
    }
    let unit = ["_n_m2", "_n_m", "_m_s", "_hz", "_n", "_m"].iter().find_map(|unit| name.strip_suffix(unit));
    unit.unwrap_or(name).replace('_', " ")
}

fn text(sheet: &Sheet) -> String {
    let mut table = table(&["quantity", "value", "unit", "equation", ""]);
    for figure in &sheet.figures {
        let limit = figure
            .limit
            .as_ref()
            .map(|limit| format!("{} {}", if limit.holds { "ok:" } else { "outside:" }, limit.text));
        let given = figure.given.then(|| "given".to_owned());
        let mark = given.into_iter().chain(limit).collect::<Vec<_>>().join("; ");
        let name = name_for_people(figure.name);
        let equation = if figure.equation == "exact" {
            "exact law".to_owned()
        } else {
            format!("({})", figure.equation)
        };
        table.add_row(vec![name, number(figure.value), figure.unit.to_owned(), equation, mark]);
    }
    right(&mut table, &[1]);
    let mut text = format!("{}\n", table.trim_fmt());
    for note in &sheet.notes {
        text.push_str(&format!("note: {note}\n"));
    }
    if sheet.figures.iter().any(|figure| figure.name == "stiffness") {
        text.push_str(
            "note: 'stiffness' (E1*) is what to type into OpenSim, 2^(3/2) times the composite modulus E*\n",
        );
    }
    text
}
