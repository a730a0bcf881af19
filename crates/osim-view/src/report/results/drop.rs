//! The result of a drop test: as text, CSV, a chart of letters, and JSON.

#[cfg(feature = "schemas")]
use std::borrow::Cow;

use contact_plots::{Axis, Curve, Look, Panel};
use contact_scaling::drop_test::DropReport;
#[cfg(feature = "schemas")]
use osim_inspect::ObjectSchema;
use osim_inspect::SCHEMA_VERSION;
use osim_model::messages::{counted, four_significant, readable, shortest};
use osim_planning::{ComparedDrop, DropColumn, DropFigure, DropResult, DropRow};
use serde::ser::SerializeMap;
use serde::{Serialize, Serializer};

use super::fit::within_or_outside;
use crate::report::layout::{WIDTH, csv_text, table};

/// A difference of curves below this (in radii and body weights) comes from rounding in the integration, and is printed as "below" this.
const ROUNDING_OF_CURVES: f64 = 1e-9;
/// The height of the chart of a drop, in lines of text.
const CHART_ROWS: usize = 16;

/// The values of a drop, whether they are within the limits of the laws, and the difference from another drop, for a terminal with
/// this many columns.
pub fn drop_text(drop: &DropResult, columns: Option<usize>) -> String {
    let values = drop.values;
    let mut text = format!(
        "{}: {} kg on {}, {} m/s2, from {} m, {} s\n\n",
        drop.name,
        four_significant(values.mass_kg),
        counted(readable(drop.sphere_count), "sphere"),
        readable(values.gravity_m_s2),
        four_significant(values.height_m),
        four_significant(values.duration_s)
    );
    if drop.is_of_foot {
        text.push_str("the foot alone falls: body weight below is its weight\n\n");
    }
    text.push_str(&rows(drop, columns));
    text.push_str(&limits_in_words(drop));
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
            four_significant(compared.difference.until),
            difference_in_words(compared.difference.height),
            difference_in_words(compared.difference.force)
        ));
    }
    text
}

fn rows(drop: &DropResult, columns: Option<usize>) -> String {
    let mut table = table(&["figure", "value", "unit"]);
    for place in [DropRow::InOrder, DropRow::Last] {
        for figure in DropFigure::ALL.iter().filter(|figure| figure.row() == place) {
            let (info, value) = (figure.info(), figure.value(drop));
            let shown = value.map_or_else(|| "absent".to_owned(), four_significant);
            let unit = if value.is_some() { info.unit } else { "" };
            table.add_row(vec![info.heading_without_unit(), shown, unit.to_owned()]);
        }
    }
    table.right_aligned(&[1]);
    format!("{}\n", table.into_lines(columns))
}

/// Whether the figures are within the limits of the laws. The equations (11) and (13) are the same that `check` uses for these limits.
fn limits_in_words(drop: &DropResult) -> String {
    let admits = |figure: DropFigure| {
        let limit = figure.info().limit?;
        Some((figure.value(drop).is_some_and(|value| limit.admits(value)), limit.in_words()))
    };
    let mut text = String::new();
    if let Some((within, limit)) = admits(DropFigure::IndentationHertz) {
        text.push_str(&format!(
            "\nindentation/radius at rest, by (11), is {} the limit of the Hertz law ({limit})\n",
            within_or_outside(within)
        ));
    }
    let restitution = admits(DropFigure::RestitutionApproximate).zip(DropFigure::ImpactSpeed.value(drop));
    if let Some(((within, limit), speed)) = restitution {
        text.push_str(&format!(
            "restitution by (13) is {} the limit of the Hunt-Crossley law ({limit})\n",
            within_or_outside(within)
        ));
        if DropFigure::RestitutionApproximate.value(drop).is_none() {
            text.push_str(&format!(
                "(13) would be below 0 at {} m/s, outside its domain\n",
                four_significant(speed)
            ));
        }
    }
    text
}

/// A difference in words. A difference that is only a rounding error counts as 0.
fn difference_in_words(difference: f64) -> String {
    if difference < ROUNDING_OF_CURVES { "below 1e-9".to_owned() } else { four_significant(difference) }
}

/// A chart of force over body weight against time, made of letters, for a terminal with this many columns.
pub fn drop_chart(drop: &DropResult, columns: Option<usize>) -> String {
    let report = &drop.report;
    let points = report
        .series
        .iter()
        .map(|sample| (DropColumn::Time.value(report, sample), DropColumn::ForceBw.value(report, sample)));
    let mut panel = Panel::new("", Axis::new("time (s)"), Axis::new("force/body weight"));
    panel.curves.push(Curve::new("", points.collect(), Look::series(0)));
    // One sample alone is not a curve; the figures are enough.
    let chart = contact_plots::text(&panel, columns.unwrap_or(WIDTH), CHART_ROWS);
    chart.map_or_else(|_| String::new(), |chart| format!("\n{chart}"))
}

/// The motion of the drop as CSV, one row for each moment.
///
/// # Errors
/// None in practice: the rows are written into memory.
pub fn drop_csv(drop: &DropResult) -> Result<String, csv::Error> {
    let report = &drop.report;
    let header = DropColumn::ALL.iter().map(|column| column.info().name.to_owned()).collect();
    let rows = report
        .series
        .iter()
        .map(|sample| DropColumn::ALL.iter().map(|column| shortest(column.value(report, sample))).collect());
    csv_text(std::iter::once(header).chain(rows))
}

// The JSON contract of a drop.

/// A drop for JSON: each [`DropFigure`] under its name, and the motion.
#[derive(Debug, Clone, Copy)]
pub struct DropRecord<'d>(pub &'d DropResult);

osim_inspect::json_records! {
    /// How far two drops are apart without dimensions.
    DropDifferenceRecord from compared: &ComparedDrop {
        /// Name of the body with which this one is compared.
        other: String = compared.name.clone().into_parts().0,
        /// The other body's name in bytes, if it is not UTF-8.
        #[serde(skip_serializing_if = "Option::is_none")]
        other_bytes: Option<Vec<u8>> = compared.name.clone().into_parts().1,
        /// Dimensionless time t/√(R/g) up to which the drops are compared.
        until_dimensionless_time: f64 = compared.difference.until,
        /// Largest difference of height over radius.
        height_over_radius: f64 = compared.difference.height,
        /// Largest difference of force over body weight.
        force_bw: f64 = compared.difference.force,
    }
}

/// The motion of a drop for JSON: each [`DropColumn`] under its name.
#[derive(Debug, Clone, Copy)]
pub struct DropSeriesRecord<'d>(&'d DropReport);

impl Serialize for DropRecord<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let Self(drop) = self;
        let (model, model_bytes) = drop.name.clone().into_parts();
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry("schema_version", &SCHEMA_VERSION)?;
        map.serialize_entry("model", &model)?;
        if let Some(bytes) = model_bytes {
            map.serialize_entry("model_bytes", &bytes)?;
        }
        for figure in DropFigure::ALL {
            map.serialize_entry(figure.info().name, &figure.value(drop))?;
        }
        map.serialize_entry("compare", &drop.compared.as_ref().map(DropDifferenceRecord::from))?;
        map.serialize_entry("series", &DropSeriesRecord(&drop.report))?;
        map.end()
    }
}

#[cfg(feature = "schemas")]
impl schemars::JsonSchema for DropRecord<'_> {
    fn schema_name() -> Cow<'static, str> {
        "DropRecord".into()
    }

    fn json_schema(generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
        let mut object = ObjectSchema::new(generator);
        object.field::<u32>(
            "schema_version",
            "Version of this JSON, which rises when a field changes its meaning or goes away.",
        );
        object.field::<String>("model", "The model or preset.");
        object.field_or_none::<Option<Vec<u8>>>("model_bytes", "Its name in bytes, if it is not UTF-8.");
        for figure in DropFigure::ALL {
            let info = figure.info();
            match figure.is_always_known() {
                true => object.field::<f64>(info.name, &info.schema_description()),
                false => object.field::<Option<f64>>(info.name, &info.schema_description()),
            }
        }
        let compare = "How far it is from another drop, where one was asked for.";
        object.field::<Option<DropDifferenceRecord>>("compare", compare);
        object.field::<DropSeriesRecord<'_>>("series", "The motion.");
        object.finish("A drop, as the JSON has it.")
    }
}

impl Serialize for DropSeriesRecord<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let Self(report) = self;
        let mut map = serializer.serialize_map(None)?;
        for column in DropColumn::ALL {
            let values = report.series.iter().map(|sample| column.value(report, sample));
            map.serialize_entry(column.info().name, &values.collect::<Vec<f64>>())?;
        }
        map.end()
    }
}

#[cfg(feature = "schemas")]
impl schemars::JsonSchema for DropSeriesRecord<'_> {
    fn schema_name() -> Cow<'static, str> {
        "DropSeriesRecord".into()
    }

    fn json_schema(generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
        let mut object = ObjectSchema::new(generator);
        for info in DropColumn::ALL.iter().map(|column| column.info()) {
            object.field::<Vec<f64>>(info.name, &info.schema_description());
        }
        object.finish("The motion of a drop; entry `i` of each list is one moment.")
    }
}
