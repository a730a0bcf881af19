//! The result of a fit, as text and as JSON.

use contact_scaling::fit::{Doubt, Estimate, Fit, Parameter};
use contact_scaling::limits;
use osim_inspect::SCHEMA_VERSION;
use osim_model::files::FileName;
use osim_model::messages::{Dialect, Input, four_significant, phrase, readable, shown_path};
use osim_planning::FitResult;

use crate::report::layout::table;

/// The fitted parameters with their confidence intervals, and whether the measurement is within the limits of the laws, for a
/// terminal with this many columns.
pub fn fit_text(result: &FitResult, dialect: &dyn Dialect, columns: Option<usize>) -> String {
    let fit = &result.fit;
    let mut text = format!(
        "{}: {} rows in the fit, n = {}, R = {} m\n\n{}\n\n",
        shown_path(&result.file),
        fit.rows.len(),
        readable(result.sphere_count),
        readable(result.radius_m),
        table_of_parameters(fit, columns)
    );
    text.push_str(&format!(
        "R squared {:.6}; residuals have a standard deviation of {} N\n",
        fit.r_squared,
        four_significant(fit.residual_deviation_n)
    ));
    text.push_str(&format!(
        "largest indentation/radius {:.4}: {} the limit of the Hertz law ({})\n",
        fit.largest_relative_indentation,
        within_or_outside(fit.within_hertz_limit),
        limits::INDENTATION.in_words()
    ));
    if fit.largest_relative_indentation > 1.0 {
        let question =
            phrase!["that is more than the whole radius: is ", Input::IndentationUnit, " right?\n"];
        text.push_str(&question.spelled(dialect));
    }
    text.push_str(&restitution_in_words(fit));
    for doubt in &fit.doubts {
        text.push_str(&format!("warning: {} [{}]\n", doubt_in_words(doubt), doubt.code()));
    }
    if fit.dissipation.is_some_and(|dissipation| dissipation.value < 0.0) {
        text.push_str(
            "the dissipation comes out below 0, which no model takes: check the sign of the speed\n",
        );
    }
    text
}

/// A reason to doubt a fit, in words.
pub(super) fn doubt_in_words(doubt: &Doubt) -> String {
    match doubt {
        Doubt::LowRSquared { r_squared } => format!(
            "the law explains only {:.0} % of what the force does: look at the residuals before you use these values",
            100.0 * r_squared
        ),
        Doubt::Undetermined { parameter } => format!(
            "the 95 % interval of the {parameter} contains 0, so these data do not determine it: measure more, or other, \
             indentations and speeds",
            parameter = parameter.in_words()
        ),
        Doubt::NoResiduals => {
            "no residual is left, as in calculated data: the uncertainty of the values is unknown".to_owned()
        }
        _ => doubt.code().to_owned(),
    }
}

/// A bound of a confidence interval, in words; the bound may be unknown.
fn bound_in_words(value: f64) -> String {
    if value.is_nan() { "not known".to_owned() } else { four_significant(value) }
}

pub(super) fn within_or_outside(within: bool) -> &'static str {
    if within { "within" } else { "outside" }
}

fn table_of_parameters(fit: &Fit, columns: Option<usize>) -> String {
    let mut table = table(&["parameter", "value", "95 % from", "to", "unit", "equation"]);
    let mut row = |name: &str, value: &Estimate, unit: &str, equation: &str| {
        let cells = [
            name,
            &four_significant(value.value),
            &bound_in_words(value.low),
            &bound_in_words(value.high),
            unit,
            equation,
        ];
        table.add_row(cells.map(str::to_owned).to_vec());
    };
    row("E* (composite)", &fit.composite_modulus, "N/m2", "(1)");
    row("stiffness to write (E1*)", &fit.plane_strain_modulus, "N/m2", "(A.4)");
    if let Some(dissipation) = &fit.dissipation {
        row("dissipation", dissipation, "s/m", "(12)");
    }
    if let Some(onset) = &fit.onset_m {
        row("contact onset", onset, "m", "(1)");
    }
    table.right_aligned(&[1, 2, 3]);
    table.fitted(columns.unwrap_or(usize::MAX))
}

fn restitution_in_words(fit: &Fit) -> String {
    match (fit.restitution, fit.within_hunt_crossley_limit, fit.largest_speed_m_s) {
        (Some(restitution), Some(within), Some(speed)) => format!(
            "restitution by (13) at the largest speed ({} m/s) {restitution:.4}: {} the limit of the Hunt-Crossley law ({})\n",
            four_significant(speed),
            within_or_outside(within),
            limits::RESTITUTION.in_words()
        ),
        (None, Some(_), Some(speed)) => format!(
            "at the largest speed ({} m/s) (13) is outside its domain: the Hunt-Crossley law does not hold\n",
            four_significant(speed)
        ),
        _ => "no speed is known, so the force is taken as elastic and dissipation is not fitted\n".to_owned(),
    }
}

// The JSON contract of a fit.

osim_inspect::json_records! {
    /// A fit, as the JSON has it.
    FitRecord from result: &FitResult {
        /// Version of this JSON, which rises when a field changes its meaning or goes away.
        schema_version: u32 = SCHEMA_VERSION,
        /// Name of the file of the measurement.
        file: String = FileName::from(result.file.as_path()).into_parts().0,
        /// The file's name in bytes, if it is not UTF-8.
        #[serde(skip_serializing_if = "Option::is_none")]
        file_bytes: Option<Vec<u8>> = FileName::from(result.file.as_path()).into_parts().1,
        /// Spheres that shared the force.
        sphere_count: f64 = result.sphere_count,
        /// Radius of the spheres, m.
        radius_m: f64 = result.radius_m,
        /// Fitted E* (1), N/m².
        composite_modulus_n_m2: EstimateRecord = (&result.fit.composite_modulus).into(),
        /// E₁* (A.4), N/m²: what OpenSim calls stiffness.
        stiffness: EstimateRecord = (&result.fit.plane_strain_modulus).into(),
        /// Fitted α (12), s/m.
        dissipation: Option<EstimateRecord> = result.fit.dissipation.as_ref().map(Into::into),
        /// Where contact begins, m.
        onset_m: Option<EstimateRecord> = result.fit.onset_m.as_ref().map(Into::into),
        /// Names of the fitted parameters, in the order of the covariance.
        parameters: Vec<&'static str> = result.fit.parameters.iter().map(name).collect(),
        /// Covariance of the parameters.
        #[cfg_attr(feature = "schemas", schemars(with = "Vec<Vec<Option<f64>>>"))]
        covariance: Vec<Vec<f64>> = result.fit.covariance.clone(),
        /// Why the result must not be taken as it is.
        warnings: Vec<FitWarningRecord> = result.fit.doubts.iter().map(Into::into).collect(),
        /// Coefficient of determination R².
        r_squared: f64 = result.fit.r_squared,
        /// The number of rows less that of fitted parameters.
        degrees_of_freedom: usize = result.fit.degrees_of_freedom,
        /// Standard deviation of the residuals, N.
        #[cfg_attr(feature = "schemas", schemars(with = "Option<f64>"))]
        residual_deviation_n: f64 = result.fit.residual_deviation_n,
        /// The largest x̂ of the measurement.
        largest_relative_indentation: f64 = result.fit.largest_relative_indentation,
        /// Whether the largest indentation is within the Hertz law.
        within_hertz_limit: bool = result.fit.within_hertz_limit,
        /// The largest speed of the measurement, m/s.
        largest_speed_m_s: Option<f64> = result.fit.largest_speed_m_s,
        /// c_r by (13) at that speed.
        restitution: Option<f64> = result.fit.restitution,
        /// Whether the largest rate is within the Hunt–Crossley law.
        within_hunt_crossley_limit: Option<bool> = result.fit.within_hunt_crossley_limit,
        /// Residuals of the fit.
        residuals: ResidualsRecord = result.into(),
    }

    /// Why a result must not be taken as it is.
    FitWarningRecord from doubt: &Doubt {
        /// Stable short name of the warning.
        code: &'static str = doubt.code(),
        /// What the data do not determine, and what to do.
        message: String = doubt_in_words(doubt),
    }

    /// A fitted parameter.
    EstimateRecord from estimate: &Estimate {
        /// Fitted value of the parameter.
        #[cfg_attr(feature = "schemas", schemars(with = "Option<f64>"))]
        value: f64 = estimate.value,
        /// Standard error of the fitted value.
        #[cfg_attr(feature = "schemas", schemars(with = "Option<f64>"))]
        standard_error: f64 = estimate.standard_error,
        /// Begin of the 95 % confidence interval.
        #[cfg_attr(feature = "schemas", schemars(with = "Option<f64>"))]
        low_95: f64 = estimate.low,
        /// End of the 95 % interval.
        #[cfg_attr(feature = "schemas", schemars(with = "Option<f64>"))]
        high_95: f64 = estimate.high,
    }

    /// Residuals of a fit, row by row.
    ResidualsRecord from result: &FitResult {
        /// Line in the file.
        line: Vec<u64> = result.lines.clone(),
        /// Measured less fitted force, N.
        force_n: Vec<f64> = result.fit.residuals_n.clone(),
    }
}

fn name(parameter: &Parameter) -> &'static str {
    match parameter {
        Parameter::CompositeModulus => "composite_modulus_n_m2",
        Parameter::Dissipation => "dissipation",
        Parameter::Onset => "onset_m",
    }
}
