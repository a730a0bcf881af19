//! `drop-test`: what contacts do when their body falls on them.

use std::io::IsTerminal;
use std::path::Path;

use anyhow::{Result, anyhow, bail};
use contact_scaling::drop_test::{Difference, DropReport, DropTest, DropValues, compare};
use contact_scaling::{Contact, ContactValues, Law, Preset, SmoothingValues, Spheres};
use osim_patch::{Fault, MassRequest, Model, loaded_spheres};
use serde::Serialize;

use crate::args::{DropArgs, DropNumbers, Length, SeriesFormat};
use crate::failure::Failure;
use crate::load::Loaded;
use crate::presets;
use crate::report::{json, number, right, table};
use crate::sources::Source;
use crate::terminal::{Exit, Terminal};
use crate::verbs::sphere_count;
use crate::weighed::Weighed;

/// OpenSim's gravity where nobody says another.
pub(crate) const STANDARD_GRAVITY: f64 = 9.80665;

/// Curves closer than this (in radii and body weights) differ by the rounding of the integration.
const ROUNDING: f64 = 1e-9;

/// A drop and what it was made from.
struct Drop {
    name: String,
    test: DropTest,
    sphere_count: f64,
    /// What to say aloud beside its figures.
    warning: Option<String>,
}

/// Runs the drop test.
///
/// # Errors
/// Wrong usage: numbers that are missing or contradict a model.
pub(crate) fn run(args: &DropArgs, terminal: &mut Terminal) -> Result<Exit> {
    let drop = match subject(args)? {
        Ok(drop) => drop,
        Err(failure) => return fail(&failure, args, terminal),
    };
    let other = match &args.compare {
        Some(path) => match named(path, args, &Own::of_other(args))? {
            Ok(other) => Some(other),
            Err(failure) => return fail(&failure, args, terminal),
        },
        None => None,
    };
    let failure = |error| Failure::outside(&drop.name, "drop-test", &anyhow!("{error}"));
    let result = drop.test.run().and_then(|report| {
        let difference = other.as_ref().map(|other| compare(&drop.test, &other.test)).transpose()?;
        Ok((report, difference))
    });
    match result {
        Ok((report, difference)) => {
            let compared = difference.as_ref().zip(other.as_ref().map(|other| other.name.as_str()));
            let text = match args.format {
                SeriesFormat::Table => text(&drop, &report, compared),
                SeriesFormat::Json => json_text(&drop, &report, compared),
                SeriesFormat::Csv => csv_text(&report)?,
            };
            terminal.print(&text)?;
            for warning in
                [Some(&drop), other.as_ref()].into_iter().flatten().filter_map(|one| one.warning.as_ref())
            {
                terminal.note(warning)?;
            }
            Ok(Exit::Done)
        }
        Err(error) => fail(&failure(error), args, terminal),
    }
}

fn fail(failure: &Failure, args: &DropArgs, terminal: &mut Terminal) -> Result<Exit> {
    if args.format == SeriesFormat::Json {
        terminal.print(&failure.json())?;
    }
    terminal.error(&failure.text());
    Ok(Exit::Failed)
}

/// What the options say of one of the two bodies; those about the first say nothing about the other.
struct Own {
    mass_kg: Option<f64>,
    spheres: Option<f64>,
    stance_limbs: f64,
    gravity: Option<f64>,
    spheres_option: &'static str,
}

impl Own {
    fn of_subject(args: &DropArgs) -> Self {
        Self {
            mass_kg: args.mass_kg(),
            spheres: args.counts.spheres,
            stance_limbs: args.counts.stance_limbs,
            gravity: args.numbers.gravity,
            spheres_option: "--spheres",
        }
    }

    fn of_other(args: &DropArgs) -> Self {
        let spheres = args.compare_spheres;
        Self { mass_kg: None, spheres, stance_limbs: 1.0, gravity: None, spheres_option: "--compare-spheres" }
    }
}

/// The model, preset or numbers to drop.
fn subject(args: &DropArgs) -> Result<Result<Drop, Failure>> {
    let numbers = &args.numbers;
    match &args.subject {
        Some(path) => {
            let own = [
                ("--radius", numbers.radius),
                ("--stiffness", numbers.stiffness),
                ("--dissipation", numbers.dissipation),
                ("--constant-contact-force", numbers.constant_contact_force),
                ("--hertz-smoothing", numbers.hertz_smoothing),
                ("--hunt-crossley-smoothing", numbers.hunt_crossley_smoothing),
            ];
            let given: Vec<_> =
                own.iter().filter(|(_, value)| value.is_some()).map(|(name, _)| *name).collect();
            if !given.is_empty() {
                bail!("a model or preset has its own numbers: leave out {}", given.join(", "));
            }
            named(path, args, &Own::of_subject(args))
        }
        None => of_numbers(numbers, args).map(Ok),
    }
}

fn named(path: &Path, args: &DropArgs, own: &Own) -> Result<Result<Drop, Failure>> {
    if let Some(preset) = presets::find(path, args.presets.as_deref())? {
        return of_preset(&preset, args, own).map(Ok);
    }
    let may_be_file = path.exists() || path.as_os_str() == "-" || path.components().count() > 1;
    if !may_be_file && path.extension().is_none() {
        let names = presets::names(args.presets.as_deref());
        bail!(
            "'{}': there is no such file and no such preset, expected a model or one of: {names}",
            path.display()
        );
    }
    let source = Source { path: path.to_owned(), folder: None };
    let loaded = match Loaded::read(&source, &args.parts) {
        Ok(loaded) => loaded,
        Err(failure) => return Ok(Err(failure)),
    };
    let masses = MassRequest { model_kg: own.mass_kg, ..args.masses.request()? };
    let selection = args.choice.selection()?;
    Ok(loaded.with_model(|model| {
        let of_model = || -> Result<Drop, Fault> {
            let selected = selection.apply(model)?;
            let mass = masses.of_model(model)?;
            let count = match own.spheres {
                Some(count) => count,
                None => sphere_count(model, own.stance_limbs, own.spheres_option)?,
            };
            let spheres = weighted(model, &selected.forces, count)?;
            let gravity = match own.gravity.or(model.gravity().filter(|&gravity| gravity > 0.0)) {
                Some(gravity) => gravity,
                None => {
                    return Err(Fault::new(osim_patch::FaultKind::Refused(
                        "the model has no gravity: say it with --gravity G".to_owned(),
                    )));
                }
            };
            let warning = Weighed::otherwise(model, &masses).map(|weighed| weighed.warning(&loaded.shown));
            make(loaded.shown.clone(), spheres, mass.kg, gravity, count, args)
                .map(|drop| Drop { warning, ..drop })
                .map_err(|error| Fault::new(osim_patch::FaultKind::Refused(error.to_string())))
        };
        of_model().map_err(|fault| loaded.failure(fault))
    }))
}

/// The spheres of all limbs, each with its share of the n that stand: 1/2 where one of two limbs does.
pub(crate) fn weighted(model: &Model, forces: &[usize], count: f64) -> Result<Vec<Spheres>, Fault> {
    let loaded = loaded_spheres(model, forces)?;
    #[expect(clippy::cast_precision_loss, reason = "sphere counts are small")]
    let found = model.loaded_spheres(&(0..model.forces.len()).collect::<Vec<_>>()).len() as f64;
    let mut spheres = Vec::new();
    for one in loaded {
        let law = Law::of(&one.contact, one.radius_m).map_err(Fault::new)?;
        spheres.push(Spheres::new(law, count / found).map_err(Fault::new)?);
    }
    Ok(spheres)
}

fn of_preset(preset: &Preset, args: &DropArgs, own: &Own) -> Result<Drop> {
    let law = Law::of(&preset.contact, preset.scale.radius_m())?;
    let mass = own.mass_kg.unwrap_or(preset.scale.mass_kg());
    let count = own.spheres.unwrap_or(preset.scale.sphere_count());
    let gravity = own.gravity.unwrap_or(preset.scale.gravity_m_s2());
    make(preset.name.to_string(), vec![Spheres::new(law, count)?], mass, gravity, count, args)
}

fn of_numbers(numbers: &DropNumbers, args: &DropArgs) -> Result<Drop> {
    let needed = [
        ("--mass", args.mass_kg()),
        ("--spheres", args.counts.spheres),
        ("--radius", numbers.radius),
        ("--stiffness", numbers.stiffness),
        ("--dissipation", numbers.dissipation),
    ];
    let missing: Vec<_> = needed.iter().filter(|(_, value)| value.is_none()).map(|(name, _)| *name).collect();
    let [Some(mass), Some(count), Some(radius), Some(stiffness), Some(dissipation)] =
        needed.map(|(_, value)| value)
    else {
        bail!(
            "nothing to drop: name a model or a preset, or give the numbers; missing: {}",
            missing.join(", ")
        );
    };
    let smoothing = match (
        numbers.constant_contact_force,
        numbers.hertz_smoothing,
        numbers.hunt_crossley_smoothing,
    ) {
        (None, None, None) => None,
        (Some(constant_contact_force), Some(hertz_smoothing), Some(hunt_crossley_smoothing)) => {
            Some(SmoothingValues { constant_contact_force, hertz_smoothing, hunt_crossley_smoothing })
        }
        _ => bail!(
            "the smoothed law needs all of --constant-contact-force, --hertz-smoothing, --hunt-crossley-smoothing"
        ),
    };
    let contact = Contact::new(ContactValues { plane_strain_modulus: stiffness, dissipation, smoothing })?;
    let law = Law::of(&contact, radius)?;
    let gravity = numbers.gravity.unwrap_or(STANDARD_GRAVITY);
    make("the numbers given".to_owned(), vec![Spheres::new(law, count)?], mass, gravity, count, args)
}

fn make(
    name: String,
    spheres: Vec<Spheres>,
    mass_kg: f64,
    gravity_m_s2: f64,
    sphere_count: f64,
    args: &DropArgs,
) -> Result<Drop> {
    let values = DropValues {
        mass_kg,
        gravity_m_s2,
        height_m: 0.0,
        duration_s: args.duration,
        samples: args.samples as usize,
    };
    let on_ground = DropTest::new(spheres, values)?;
    let height_m = match args.height {
        Length::Metres(metres) => metres,
        Length::Radii(radii) => radii * on_ground.reference_radius_m(),
    };
    let test = DropTest::new(on_ground.spheres().to_vec(), DropValues { height_m, ..values })?;
    Ok(Drop { name, test, sphere_count, warning: None })
}

/// The figures of a drop, in the order of the report.
struct Figures {
    final_relative_indentation: f64,
    hertz_relative_indentation: f64,
    own_relative_indentation: f64,
    contact_time_s: Option<f64>,
    rebound_speed_m_s: Option<f64>,
    impact_speed_m_s: Option<f64>,
    restitution_exact: Option<f64>,
    restitution_approximate: Option<f64>,
}

impl Figures {
    fn of(report: &DropReport) -> Self {
        let radius = report.reference_radius_m;
        let contact = report.first_contact;
        let lift = contact.and_then(|contact| contact.end);
        Self {
            final_relative_indentation: report.final_indentation_m / radius,
            hertz_relative_indentation: report.hertz_indentation_m / radius,
            own_relative_indentation: report.equilibrium_indentation_m / radius,
            contact_time_s: lift.map(|lift| lift.contact_time_s),
            rebound_speed_m_s: lift.map(|lift| lift.rebound_speed_m_s),
            impact_speed_m_s: contact.map(|contact| contact.impact_speed_m_s),
            restitution_exact: contact.map(|contact| contact.restitution_exact),
            restitution_approximate: contact.and_then(|contact| contact.restitution_approximate),
        }
    }
}

fn text(drop: &Drop, report: &DropReport, compared: Option<(&Difference, &str)>) -> String {
    let values = drop.test.values();
    let figures = Figures::of(report);
    let mut text = format!(
        "{}: {} kg on {} spheres, {} m/s2, from {} m, {} s\n\n",
        drop.name,
        number(values.mass_kg),
        number(drop.sphere_count),
        number(values.gravity_m_s2),
        number(values.height_m),
        number(values.duration_s)
    );
    let mut table = table(&["figure", "value", "unit"]);
    let mut row = |name: &str, value: Option<f64>, unit: &str| {
        let shown = value.map_or_else(|| "absent".to_owned(), number);
        let unit = if value.is_some() { unit } else { "" };
        table.add_row(vec![name.to_owned(), shown, unit.to_owned()]);
    };
    row("indentation/radius at the end", Some(figures.final_relative_indentation), "");
    row("  at rest, Hertz law (11)", Some(figures.hertz_relative_indentation), "");
    row("  at rest, the model's own law", Some(figures.own_relative_indentation), "");
    row("peak force", Some(report.peak_force_n), "N");
    row("peak force/body weight", Some(report.peak_force_bw()), "");
    row("stiffness of one sphere at rest, own law", Some(report.equilibrium_stiffness_n_m), "N/m");
    row("stiffness of one sphere at rest, Hertz (B.1)", Some(report.hertz_stiffness_n_m), "N/m");
    row("impact speed", figures.impact_speed_m_s, "m/s");
    row("restitution without gravity, exact", figures.restitution_exact, "");
    row("restitution by (13)", figures.restitution_approximate, "");
    row("contact time", figures.contact_time_s, "s");
    row("rebound speed", figures.rebound_speed_m_s, "m/s");
    row("time unit sqrt(R/g)", Some(report.reference_time_s), "s");
    right(&mut table, &[1]);
    text.push_str(&table.trim_fmt());
    text.push('\n');
    text.push_str(&limits(&figures));
    if report.first_contact.is_none() {
        text.push_str("\nthe body does not reach the ground in this time\n");
    } else if figures.contact_time_s.is_none() {
        text.push_str(
            "\nthe body does not leave the ground again: contact time and rebound speed are absent\n",
        );
    }
    if let Some((difference, other)) = compared {
        text.push_str(&format!(
            "\nagainst {other}, dimensionless, up to t/sqrt(R/g) = {}:\n  largest difference of height/radius {}, \
             of force/body weight {}\n",
            number(difference.until),
            apart(difference.height),
            apart(difference.force)
        ));
    }
    if std::io::stdout().is_terminal() {
        text.push_str(&chart(report));
    }
    text
}

/// Whether the figures are within what the laws were made for.
fn limits(figures: &Figures) -> String {
    let word = |holds: bool| if holds { "within" } else { "outside" };
    let hertz = contact_scaling::limits::hertz_holds(figures.own_relative_indentation);
    let mut text = format!("\nindentation/radius at rest is {} the Hertz law (at most 0.16)\n", word(hertz));
    if let (Some(exact), Some(speed)) = (figures.restitution_exact, figures.impact_speed_m_s) {
        let holds = contact_scaling::limits::hunt_crossley_holds(exact);
        text.push_str(&format!("restitution is {} the Hunt-Crossley law (at least 0.8)\n", word(holds)));
        if figures.restitution_approximate.is_none() {
            text.push_str(&format!("(13) would be below 0 at {} m/s, outside its domain\n", number(speed)));
        }
    }
    text
}

/// A difference; what is left of rounding is none.
fn apart(difference: f64) -> String {
    if difference < ROUNDING { "below 1e-9".to_owned() } else { format!("{difference:.3e}") }
}

/// Force over body weight against time; only for terminals, which can draw it.
fn chart(report: &DropReport) -> String {
    use textplots::{Chart, Plot, Shape};
    #[expect(clippy::cast_possible_truncation, reason = "a chart of a few dots")]
    let points: Vec<(f32, f32)> = report
        .series
        .iter()
        .map(|sample| (sample.time_s as f32, (sample.force_n / report.body_weight_n) as f32))
        .collect();
    let end = points.last().map_or(1.0, |point| point.0);
    let lines = Shape::Lines(&points);
    let mut chart = Chart::new(120, 40, 0.0, end);
    let chart = chart.lineplot(&lines);
    chart.axis();
    chart.figures();
    format!("\nforce/body weight against time (s)\n{chart}\n")
}

#[derive(Serialize)]
struct JsonDrop<'d> {
    schema_version: u32,
    model: &'d str,
    mass_kg: f64,
    sphere_count: f64,
    gravity_m_s2: f64,
    height_m: f64,
    duration_s: f64,
    reference_radius_m: f64,
    reference_time_s: f64,
    final_relative_indentation: f64,
    hertz_relative_indentation: f64,
    own_relative_indentation: f64,
    peak_force_n: f64,
    peak_force_bw: f64,
    equilibrium_stiffness_n_m: f64,
    hertz_stiffness_n_m: f64,
    impact_speed_m_s: Option<f64>,
    restitution_exact: Option<f64>,
    restitution_approximate: Option<f64>,
    contact_time_s: Option<f64>,
    rebound_speed_m_s: Option<f64>,
    compare: Option<JsonDifference<'d>>,
    series: JsonSeries,
}

#[derive(Serialize)]
struct JsonDifference<'d> {
    other: &'d str,
    until_dimensionless_time: f64,
    height_over_radius: f64,
    force_bw: f64,
}

#[derive(Serialize)]
struct JsonSeries {
    time_s: Vec<f64>,
    height_m: Vec<f64>,
    speed_m_s: Vec<f64>,
    force_n: Vec<f64>,
    force_bw: Vec<f64>,
    dimensionless_time: Vec<f64>,
}

fn json_text(drop: &Drop, report: &DropReport, compared: Option<(&Difference, &str)>) -> String {
    let values = drop.test.values();
    let figures = Figures::of(report);
    let series = &report.series;
    json::line(&JsonDrop {
        schema_version: 1,
        model: &drop.name,
        mass_kg: values.mass_kg,
        sphere_count: drop.sphere_count,
        gravity_m_s2: values.gravity_m_s2,
        height_m: values.height_m,
        duration_s: values.duration_s,
        reference_radius_m: report.reference_radius_m,
        reference_time_s: report.reference_time_s,
        final_relative_indentation: figures.final_relative_indentation,
        hertz_relative_indentation: figures.hertz_relative_indentation,
        own_relative_indentation: figures.own_relative_indentation,
        peak_force_n: report.peak_force_n,
        peak_force_bw: report.peak_force_bw(),
        equilibrium_stiffness_n_m: report.equilibrium_stiffness_n_m,
        hertz_stiffness_n_m: report.hertz_stiffness_n_m,
        impact_speed_m_s: figures.impact_speed_m_s,
        restitution_exact: figures.restitution_exact,
        restitution_approximate: figures.restitution_approximate,
        contact_time_s: figures.contact_time_s,
        rebound_speed_m_s: figures.rebound_speed_m_s,
        compare: compared.map(|(difference, other)| JsonDifference {
            other,
            until_dimensionless_time: difference.until,
            height_over_radius: difference.height,
            force_bw: difference.force,
        }),
        series: JsonSeries {
            time_s: series.iter().map(|sample| sample.time_s).collect(),
            height_m: series.iter().map(|sample| sample.height_m).collect(),
            speed_m_s: series.iter().map(|sample| sample.speed_m_s).collect(),
            force_n: series.iter().map(|sample| sample.force_n).collect(),
            force_bw: series.iter().map(|sample| sample.force_n / report.body_weight_n).collect(),
            dimensionless_time: series.iter().map(|sample| sample.time_s / report.reference_time_s).collect(),
        },
    })
}

fn csv_text(report: &DropReport) -> Result<String> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(["time_s", "height_m", "speed_m_s", "force_n", "force_bw", "dimensionless_time"])?;
    for sample in &report.series {
        let row = [
            sample.time_s,
            sample.height_m,
            sample.speed_m_s,
            sample.force_n,
            sample.force_n / report.body_weight_n,
            sample.time_s / report.reference_time_s,
        ];
        writer.write_record(row.map(osim_patch::shortest))?;
    }
    Ok(String::from_utf8(writer.into_inner()?)?)
}
