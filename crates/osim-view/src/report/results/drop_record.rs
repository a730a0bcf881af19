//! The JSON contract of a drop.

#[cfg(feature = "schemas")]
use std::borrow::Cow;

use contact_scaling::drop_test::DropReport;
#[cfg(feature = "schemas")]
use osim_inspect::ObjectSchema;
use osim_inspect::SCHEMA_VERSION;
use osim_planning::{ComparedDrop, DropColumn, DropFigure, DropResult};
#[cfg(feature = "schemas")]
use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde::ser::SerializeMap;
use serde::{Serialize, Serializer};

/// A drop, as the JSON has it: each [`DropFigure`] by its name, and the motion.
#[derive(Debug, Clone, Copy)]
pub struct DropRecord<'d>(&'d DropResult);

/// How far two drops are apart without dimensions.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema), schemars(deny_unknown_fields))]
#[non_exhaustive]
pub struct DropDifferenceRecord {
    /// The other body.
    pub other: String,
    /// Its name in bytes, if it is not UTF-8.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub other_bytes: Option<Vec<u8>>,
    /// Up to which t/√(R/g).
    pub until_dimensionless_time: f64,
    /// Largest difference of height over radius.
    pub height_over_radius: f64,
    /// Largest difference of force over body weight.
    pub force_bw: f64,
}

/// The motion of a drop: each [`DropColumn`] by its name.
#[derive(Debug, Clone, Copy)]
pub struct DropSeriesRecord<'d>(&'d DropReport);

impl<'d> From<&'d DropResult> for DropRecord<'d> {
    fn from(drop: &'d DropResult) -> Self {
        Self(drop)
    }
}

impl From<&ComparedDrop> for DropDifferenceRecord {
    fn from(compared: &ComparedDrop) -> Self {
        let (other, other_bytes) = compared.name.clone().into_parts();
        Self {
            other,
            other_bytes,
            until_dimensionless_time: compared.difference.until,
            height_over_radius: compared.difference.height,
            force_bw: compared.difference.force,
        }
    }
}

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
impl JsonSchema for DropRecord<'_> {
    fn schema_name() -> Cow<'static, str> {
        "DropRecord".into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let mut object = ObjectSchema::new(generator);
        object.field::<u32>("schema_version", "Raised when a field changes its meaning or goes away.");
        object.field::<String>("model", "The model or preset.");
        object.field_or_none::<Option<Vec<u8>>>("model_bytes", "Its name in bytes, if it is not UTF-8.");
        for figure in DropFigure::ALL {
            let info = figure.info();
            match figure.is_always_known() {
                true => object.field::<f64>(info.name, &info.described()),
                false => object.field::<Option<f64>>(info.name, &info.described()),
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
impl JsonSchema for DropSeriesRecord<'_> {
    fn schema_name() -> Cow<'static, str> {
        "DropSeriesRecord".into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let mut object = ObjectSchema::new(generator);
        for info in DropColumn::ALL.iter().map(|column| column.info()) {
            object.field::<Vec<f64>>(info.name, &info.described());
        }
        object.finish("The motion of a drop; entry `i` of each list is one moment.")
    }
}
