//! A drop as text, CSV and a chart of letters.

use contact_plots::{Axis, Curve, Look, Panel};
use contact_scaling::drop_test::DropReport;
use contact_scaling::limits;
use osim_model::{readable, shortest};
use osim_requests::DropResult;

use crate::layout::{WIDTH, right_aligned, table};

/// Curves closer than this (in radii and body weights) differ by the rounding of the integration.
const ROUNDING: f64 = 1e-9;
/// Rows of a chart.
const CHART_ROWS: usize = 16;

/// The figures of a drop, in the order of the report.
pub(super) struct DropFigures {
    pub(super) final_relative_indentation: f64,
    pub(super) relative_indentation_hertz: f64,
    pub(super) relative_indentation_model_law: f64,
    pub(super) contact_time_s: Option<f64>,
    pub(super) rebound_speed_m_s: Option<f64>,
    pub(super) impact_speed_m_s: Option<f64>,
    pub(super) restitution_exact: Option<f64>,
    pub(super) restitution_approximate: Option<f64>,
}

impl DropFigures {
    pub(super) fn of(report: &DropReport) -> Self {
        let radius = report.reference_radius_m;
        let contact = report.first_contact;
        let lift = contact.and_then(|contact| contact.end);
        Self {
            final_relative_indentation: report.final_indentation_m / radius,
            relative_indentation_hertz: report.hertz_indentation_m / radius,
            relative_indentation_model_law: report.equilibrium_indentation_m / radius,
            contact_time_s: lift.map(|lift| lift.contact_time_s),
            rebound_speed_m_s: lift.map(|lift| lift.rebound_speed_m_s),
            impact_speed_m_s: contact.map(|contact| contact.impact_speed_m_s),
            restitution_exact: contact.map(|contact| contact.restitution_exact),
            restitution_approximate: contact.and_then(|contact| contact.restitution_approximate),
        }
    }
}

/// The figures of a drop, whether they are within what the laws were made for, and how far it is from another drop.
#[must_use]
pub fn drop_text(drop: &DropResult) -> String {
    let values = drop.values;
    let figures = DropFigures::of(&drop.report);
    let mut text = format!(
        "{}: {} kg on {} spheres, {} m/s2, from {} m, {} s\n\n",
        drop.name,
        readable(values.mass_kg),
        readable(drop.sphere_count),
        readable(values.gravity_m_s2),
        readable(values.height_m),
        readable(values.duration_s)
    );
    text.push_str(&rows(&drop.report, &figures));
    text.push_str(&limits(&figures));
    if drop.report.first_contact.is_none() {
        text.push_str("\nthe body does not reach the ground in this time\n");
    } else if figures.contact_time_s.is_none() {
        text.push_str(
            "\nthe body does not leave the ground again: contact time and rebound speed are absent\n",
        );
    }
    if let Some(compared) = &drop.compared {
        text.push_str(&format!(
            "\nagainst {}, dimensionless, up to t/sqrt(R/g) = {}:\n  largest difference of height/radius {}, \
             of force/body weight {}\n",
            compared.name,
            readable(compared.difference.until),
            apart(compared.difference.height),
            apart(compared.difference.force)
        ));
    }
    text
}

fn rows(report: &DropReport, figures: &DropFigures) -> String {
    let mut table = table(&["figure", "value", "unit"]);
    let mut row = |name: &str, value: Option<f64>, unit: &str| {
        let shown = value.map_or_else(|| "absent".to_owned(), readable);
        let unit = if value.is_some() { unit } else { "" };
        table.add_row(vec![name.to_owned(), shown, unit.to_owned()]);
    };
    row("indentation/radius at the end", Some(figures.final_relative_indentation), "");
    row("  at rest, Hertz law (11)", Some(figures.relative_indentation_hertz), "");
    row("  at rest, the model's law", Some(figures.relative_indentation_model_law), "");
    row("peak force", Some(report.peak_force_n), "N");
    row("peak force/body weight", Some(report.peak_force_bw()), "");
    row("stiffness of one sphere at rest, model's law", Some(report.equilibrium_stiffness_n_m), "N/m");
    row("stiffness of one sphere at rest, Hertz (B.1)", Some(report.hertz_stiffness_n_m), "N/m");
    row("impact speed", figures.impact_speed_m_s, "m/s");
    row("restitution without gravity, exact", figures.restitution_exact, "");
    row("restitution by (13)", figures.restitution_approximate, "");
    row("contact time", figures.contact_time_s, "s");
    row("rebound speed", figures.rebound_speed_m_s, "m/s");
    row("time unit sqrt(R/g)", Some(report.reference_time_s), "s");
    right_aligned(&mut table, &[1]);
    format!("{}\n", table.trim_fmt())
}

/// Whether the figures are within what the laws were made for.
fn limits(figures: &DropFigures) -> String {
    let word = |within: bool| if within { "within" } else { "outside" };
    let hertz = limits::INDENTATION.admits(figures.relative_indentation_model_law);
    let mut text = format!(
        "\nindentation/radius at rest is {} the Hertz law ({})\n",
        word(hertz),
        limits::INDENTATION.in_words()
    );
    if let (Some(exact), Some(speed)) = (figures.restitution_exact, figures.impact_speed_m_s) {
        let within = limits::RESTITUTION.admits(exact);
        let limit = limits::RESTITUTION.in_words();
        text.push_str(&format!("restitution is {} the Hunt-Crossley law ({limit})\n", word(within)));
        if figures.restitution_approximate.is_none() {
            text.push_str(&format!("(13) would be below 0 at {} m/s, outside its domain\n", readable(speed)));
        }
    }
    text
}

/// A difference; what is left of rounding is none.
fn apart(difference: f64) -> String {
    if difference < ROUNDING { "below 1e-9".to_owned() } else { format!("{difference:.3e}") }
}

/// Force over body weight against time, in letters: for terminals, which can draw it.
#[must_use]
pub fn drop_chart(drop: &DropResult) -> String {
    let report = &drop.report;
    let points = report.series.iter().map(|sample| (sample.time_s, sample.force_n / report.body_weight_n));
    let mut panel = Panel::new("", Axis::new("time (s)"), Axis::new("force/body weight"));
    panel.curves.push(Curve { label: String::new(), points: points.collect(), look: Look::series(0) });
    // One sample alone is no curve; the figures say all.
    let chart = contact_plots::text(&panel, WIDTH, CHART_ROWS);
    chart.map_or_else(|_| String::new(), |chart| format!("\n{chart}"))
}

/// The series, one row for each moment.
///
/// # Errors
/// None in practice: the rows are written into memory.
pub fn drop_csv(drop: &DropResult) -> Result<String, csv::Error> {
    let report = &drop.report;
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
        writer.write_record(row.map(shortest))?;
    }
    let bytes = writer.into_inner().map_err(|error| csv::Error::from(error.into_error()))?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}
