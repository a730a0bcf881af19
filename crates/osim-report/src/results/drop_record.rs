//! The JSON contract of a drop.

use osim_inspect::SCHEMA_VERSION;
use osim_requests::{ComparedDrop, DropResult};
use schemars::JsonSchema;
use serde::Serialize;

use super::drop_test::DropFigures;

/// A drop, as the JSON has it.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
#[non_exhaustive]
pub struct DropRecord {
    /// Raised when a field changes its meaning or goes away.
    pub schema_version: u32,
    /// The model or preset.
    pub model: String,
    /// Its name in bytes, where that is not UTF-8.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub model_bytes: Option<Vec<u8>>,
    /// M, kg.
    pub mass_kg: f64,
    /// n, spheres that share the weight.
    pub sphere_count: f64,
    /// g, m/s².
    pub gravity_m_s2: f64,
    /// Height of the sphere bottoms at the start, m.
    pub height_m: f64,
    /// How long it was followed, s.
    pub duration_s: f64,
    /// √(Σ R_i²/n), m.
    pub reference_radius_m: f64,
    /// √(R/g), s.
    pub reference_time_s: f64,
    /// x̂ at the end.
    pub final_relative_indentation: f64,
    /// x̂ at rest by the Hertz law (11).
    pub relative_indentation_hertz: f64,
    /// x̂ at rest by the law of the contacts.
    pub relative_indentation_model_law: f64,
    /// Largest force of all spheres, N.
    pub peak_force_n: f64,
    /// The same over body weight.
    pub peak_force_bw: f64,
    /// Stiffness of one sphere at rest by the law of the contacts, N/m.
    pub equilibrium_stiffness_n_m: f64,
    /// The same by the Hertz law (B.1), N/m.
    pub hertz_stiffness_n_m: f64,
    /// Speed at the first contact, m/s.
    pub impact_speed_m_s: Option<f64>,
    /// Restitution of a free impact at that speed, by the exact law.
    pub restitution_exact: Option<f64>,
    /// The same by (13).
    pub restitution_approximate: Option<f64>,
    /// How long the first contact lasts, s.
    pub contact_time_s: Option<f64>,
    /// Speed at its end, m/s.
    pub rebound_speed_m_s: Option<f64>,
    /// How far it is from another drop, where one was asked for.
    pub compare: Option<DropDifferenceRecord>,
    /// The motion.
    pub series: DropSeriesRecord,
}

/// How far two drops are apart without dimensions.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
#[non_exhaustive]
pub struct DropDifferenceRecord {
    /// The other body.
    pub other: String,
    /// Its name in bytes, where that is not UTF-8.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub other_bytes: Option<Vec<u8>>,
    /// Up to which t/√(R/g).
    pub until_dimensionless_time: f64,
    /// Largest difference of height over radius.
    pub height_over_radius: f64,
    /// Largest difference of force over body weight.
    pub force_bw: f64,
}

/// The motion of a drop; entry `i` of each list is one moment.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
#[non_exhaustive]
pub struct DropSeriesRecord {
    /// Time, s.
    pub time_s: Vec<f64>,
    /// Height of the sphere bottoms, m.
    pub height_m: Vec<f64>,
    /// Speed, upwards, m/s.
    pub speed_m_s: Vec<f64>,
    /// Force of all spheres, N.
    pub force_n: Vec<f64>,
    /// The same over body weight.
    pub force_bw: Vec<f64>,
    /// t/√(R/g).
    pub dimensionless_time: Vec<f64>,
}

impl From<&DropResult> for DropRecord {
    fn from(drop: &DropResult) -> Self {
        let (values, report) = (drop.values, &drop.report);
        let figures = DropFigures::of(report);
        let series = &report.series;
        let (model, model_bytes) = drop.name.clone().into_parts();
        Self {
            schema_version: SCHEMA_VERSION,
            model,
            model_bytes,
            mass_kg: values.mass_kg,
            sphere_count: drop.sphere_count,
            gravity_m_s2: values.gravity_m_s2,
            height_m: values.height_m,
            duration_s: values.duration_s,
            reference_radius_m: report.reference_radius_m,
            reference_time_s: report.reference_time_s,
            final_relative_indentation: figures.final_relative_indentation,
            relative_indentation_hertz: figures.relative_indentation_hertz,
            relative_indentation_model_law: figures.relative_indentation_model_law,
            peak_force_n: report.peak_force_n,
            peak_force_bw: report.peak_force_bw(),
            equilibrium_stiffness_n_m: report.equilibrium_stiffness_n_m,
            hertz_stiffness_n_m: report.hertz_stiffness_n_m,
            impact_speed_m_s: figures.impact_speed_m_s,
            restitution_exact: figures.restitution_exact,
            restitution_approximate: figures.restitution_approximate,
            contact_time_s: figures.contact_time_s,
            rebound_speed_m_s: figures.rebound_speed_m_s,
            compare: drop.compared.as_ref().map(DropDifferenceRecord::from),
            series: DropSeriesRecord {
                time_s: series.iter().map(|sample| sample.time_s).collect(),
                height_m: series.iter().map(|sample| sample.height_m).collect(),
                speed_m_s: series.iter().map(|sample| sample.speed_m_s).collect(),
                force_n: series.iter().map(|sample| sample.force_n).collect(),
                force_bw: series.iter().map(|sample| sample.force_n / report.body_weight_n).collect(),
                dimensionless_time: series
                    .iter()
                    .map(|sample| sample.time_s / report.reference_time_s)
                    .collect(),
            },
        }
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
