//! A drop as text, CSV and a chart of letters.

use contact_plots::{Axis, Curve, Look, Panel};
use osim_model::messages::{counted, readable, shortest};
use osim_planning::{DropColumn, DropFigure, DropResult, DropRow};

use crate::report::layout::{WIDTH, table};

/// Curves closer than this (in radii and body weights) differ by the rounding of the integration.
const ROUNDING: f64 = 1e-9;
/// Rows of a chart.
const CHART_ROWS: usize = 16;

/// The figures of a drop, whether they are within what the laws were made for, and how far it is from another drop.
#[must_use]
pub fn drop_text(drop: &DropResult) -> String {
    let values = drop.values;
    let mut text = format!(
        "{}: {} kg on {}, {} m/s2, from {} m, {} s\n\n",
        drop.name,
        readable(values.mass_kg),
        counted(readable(drop.sphere_count), "sphere"),
        readable(values.gravity_m_s2),
        readable(values.height_m),
        readable(values.duration_s)
    );
    text.push_str(&rows(drop));
    text.push_str(&limits(drop));
    if drop.report.first_contact.is_none() {
        text.push_str("\nthe body does not reach the ground in this time\n");
    } else if DropFigure::ContactTime.value(drop).is_none() {
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

fn rows(drop: &DropResult) -> String {
    let mut table = table(&["figure", "value", "unit"]);
    for place in [DropRow::Here, DropRow::Last] {
        for figure in DropFigure::ALL.iter().filter(|figure| figure.row() == place) {
            let (info, value) = (figure.info(), figure.value(drop));
            let shown = value.map_or_else(|| "absent".to_owned(), readable);
            let unit = if value.is_some() { info.unit } else { "" };
            table.add_row(vec![info.heading_without_unit(), shown, unit.to_owned()]);
        }
    }
    table.right_aligned(&[1]);
    format!("{}\n", table.trim_fmt())
}

/// Whether the figures are within what the laws were made for, by the equations that `check` compares with the same limits:
/// (11) and (13).
fn limits(drop: &DropResult) -> String {
    let word = |within: bool| if within { "within" } else { "outside" };
    let admits = |figure: DropFigure| {
        let limit = figure.info().limit?;
        Some((figure.value(drop).is_some_and(|value| limit.admits(value)), limit.in_words()))
    };
    let mut text = String::new();
    if let Some((within, limit)) = admits(DropFigure::IndentationHertz) {
        text.push_str(&format!(
            "\nindentation/radius at rest, by (11), is {} the Hertz law ({limit})\n",
            word(within)
        ));
    }
    let restitution = admits(DropFigure::RestitutionApproximate).zip(DropFigure::ImpactSpeed.value(drop));
    if let Some(((within, limit), speed)) = restitution {
        text.push_str(&format!("restitution by (13) is {} the Hunt-Crossley law ({limit})\n", word(within)));
        if DropFigure::RestitutionApproximate.value(drop).is_none() {
            text.push_str(&format!("(13) would be below 0 at {} m/s, outside its domain\n", readable(speed)));
        }
    }
    text
}

/// A difference; what rounding leaves counts as 0.
fn apart(difference: f64) -> String {
    if difference < ROUNDING { "below 1e-9".to_owned() } else { format!("{difference:.3e}") }
}

/// Force over body weight against time, in letters: for terminals, which can draw it.
#[must_use]
pub fn drop_chart(drop: &DropResult) -> String {
    let report = &drop.report;
    let points = report
        .series
        .iter()
        .map(|sample| (DropColumn::Time.value(report, sample), DropColumn::ForceBw.value(report, sample)));
    let mut panel = Panel::new("", Axis::new("time (s)"), Axis::new("force/body weight"));
    panel.curves.push(Curve { label: String::new(), points: points.collect(), look: Look::series(0) });
    // One sample alone is not a curve; the figures are enough.
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
    writer.write_record(DropColumn::ALL.iter().map(|column| column.info().name))?;
    for sample in &report.series {
        writer.write_record(DropColumn::ALL.iter().map(|column| shortest(column.value(report, sample))))?;
    }
    let bytes = writer.into_inner().map_err(|error| csv::Error::from(error.into_error()))?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}
