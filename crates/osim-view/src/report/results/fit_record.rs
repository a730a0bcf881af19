//! The JSON contract of a fit.

use contact_scaling::fit::{Doubt, Estimate, Parameter};
use osim_inspect::SCHEMA_VERSION;
use osim_model::files::FileName;
use osim_planning::FitResult;
#[cfg(feature = "schemas")]
use schemars::JsonSchema;
use serde::Serialize;

use super::fit::in_words;

/// A fit, as the JSON has it.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema), schemars(deny_unknown_fields))]
#[non_exhaustive]
pub struct FitRecord {
    /// Raised when a field changes its meaning or goes away.
    pub schema_version: u32,
    /// The measurement.
    pub file: String,
    /// Its name in bytes, if it is not UTF-8.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub file_bytes: Option<Vec<u8>>,
    /// Spheres that shared the force.
    pub sphere_count: f64,
    /// Their radius, m.
    pub radius_m: f64,
    /// E* (1), N/m².
    pub composite_modulus_n_m2: EstimateRecord,
    /// E₁* (A.4), N/m²: what OpenSim calls stiffness.
    pub stiffness: EstimateRecord,
    /// α (12), s/m.
    pub dissipation: Option<EstimateRecord>,
    /// Where contact begins, m.
    pub onset_m: Option<EstimateRecord>,
    /// Names of the fitted parameters, in the order of the covariance.
    pub parameters: Vec<&'static str>,
    /// Covariance of the parameters.
    #[cfg_attr(feature = "schemas", schemars(with = "Vec<Vec<Option<f64>>>"))]
    pub covariance: Vec<Vec<f64>>,
    /// Why the result must not be taken as it is.
    pub warnings: Vec<FitWarningRecord>,
    /// R².
    pub r_squared: f64,
    /// Rows less parameters.
    pub degrees_of_freedom: usize,
    /// Standard deviation of the residuals, N.
    #[cfg_attr(feature = "schemas", schemars(with = "Option<f64>"))]
    pub residual_deviation_n: f64,
    /// Largest x̂.
    pub largest_relative_indentation: f64,
    /// Whether it is within the Hertz law.
    pub within_hertz_limit: bool,
    /// Largest speed, m/s.
    pub largest_speed_m_s: Option<f64>,
    /// c_r by (13) at that speed.
    pub restitution: Option<f64>,
    /// Whether it is within the Hunt–Crossley law.
    pub within_hunt_crossley_limit: Option<bool>,
    /// What the fit leaves over.
    pub residuals: ResidualsRecord,
}

/// Why a result must not be taken as it is.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema), schemars(deny_unknown_fields))]
#[non_exhaustive]
pub struct FitWarningRecord {
    /// Stable short name.
    pub code: &'static str,
    /// What the data do not determine, and what to do.
    pub message: String,
}

/// One parameter.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema), schemars(deny_unknown_fields))]
#[non_exhaustive]
pub struct EstimateRecord {
    /// Its value.
    #[cfg_attr(feature = "schemas", schemars(with = "Option<f64>"))]
    pub value: f64,
    /// Its standard error.
    #[cfg_attr(feature = "schemas", schemars(with = "Option<f64>"))]
    pub standard_error: f64,
    /// Begin of the 95 % confidence interval.
    #[cfg_attr(feature = "schemas", schemars(with = "Option<f64>"))]
    pub low_95: f64,
    /// Its end.
    #[cfg_attr(feature = "schemas", schemars(with = "Option<f64>"))]
    pub high_95: f64,
}

/// What a fit leaves over, row by row.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema), schemars(deny_unknown_fields))]
#[non_exhaustive]
pub struct ResidualsRecord {
    /// Line in the file.
    pub line: Vec<u64>,
    /// Measured less fitted force, N.
    pub force_n: Vec<f64>,
}

impl From<&Estimate> for EstimateRecord {
    fn from(estimate: &Estimate) -> Self {
        Self {
            value: estimate.value,
            standard_error: estimate.standard_error,
            low_95: estimate.low,
            high_95: estimate.high,
        }
    }
}

fn name(parameter: &Parameter) -> &'static str {
    match parameter {
        Parameter::CompositeModulus => "composite_modulus_n_m2",
        Parameter::Dissipation => "dissipation",
        Parameter::Onset => "onset_m",
    }
}

fn warning(doubt: &Doubt) -> FitWarningRecord {
    FitWarningRecord { code: doubt.code(), message: in_words(doubt) }
}

impl From<&FitResult> for FitRecord {
    fn from(result: &FitResult) -> Self {
        let fit = &result.fit;
        let (file, file_bytes) = FileName::from(result.file.as_path()).into_parts();
        Self {
            schema_version: SCHEMA_VERSION,
            file,
            file_bytes,
            sphere_count: result.sphere_count,
            radius_m: result.radius_m,
            composite_modulus_n_m2: (&fit.composite_modulus).into(),
            stiffness: (&fit.plane_strain_modulus).into(),
            dissipation: fit.dissipation.as_ref().map(Into::into),
            onset_m: fit.onset_m.as_ref().map(Into::into),
            parameters: fit.parameters.iter().map(name).collect(),
            covariance: fit.covariance.clone(),
            warnings: fit.doubts.iter().map(warning).collect(),
            r_squared: fit.r_squared,
            degrees_of_freedom: fit.degrees_of_freedom,
            residual_deviation_n: fit.residual_deviation_n,
            largest_relative_indentation: fit.largest_relative_indentation,
            within_hertz_limit: fit.within_hertz_limit,
            largest_speed_m_s: fit.largest_speed_m_s,
            restitution: fit.restitution,
            within_hunt_crossley_limit: fit.within_hunt_crossley_limit,
            residuals: ResidualsRecord { line: result.lines.clone(), force_n: fit.residuals_n.clone() },
        }
    }
}
