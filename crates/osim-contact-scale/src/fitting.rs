//! `fit`: contact parameters from a measured indentation and force.

use anyhow::{Result, anyhow, bail};
use contact_scaling::fit::{
    Branch, Estimate, Fit, FitError, FitValues, Measurement, Onset, Parameter, Rate, fit,
};
use serde::Serialize;

use crate::args::{BranchArg, FitArgs, Format};
use crate::failure::Failure;
use crate::measured::{Measured, read_columns};
use crate::report::{json, number, right, table};
use crate::terminal::{Exit, Terminal};

/// Fits and reports.
///
/// # Errors
/// Wrong usage (an onset that is no number).
pub(crate) fn run(args: &FitArgs, terminal: &mut Terminal) -> Result<Exit> {
    let values = FitValues {
        radius_m: args.radius,
        sphere_count: args.spheres,
        onset: onset(&args.onset)?,
        branch: match args.branch {
            BranchArg::Both => Branch::Both,
            BranchArg::Loading => Branch::Loading,
            BranchArg::Unloading => Branch::Unloading,
        },
    };
    let shown = args.file.display().to_string();
    let fitted = read_columns(&args.file, &args.columns).and_then(|measured| {
        let rate = match (&measured.speed_m_s, &measured.time_s) {
            (Some(speed), _) => Rate::Speed(speed),
            (None, Some(time)) => Rate::Time(time),
            (None, None) => Rate::Unknown,
        };
        let measurement =
            Measurement { indentation_m: &measured.indentation_m, force_n: &measured.force_n, rate };
        let fitted =
            fit(&measurement, &values).map_err(|error| anyhow!("{shown}: {}", in_file(&error, &measured)))?;
        Ok((fitted, measured))
    });
    match fitted {
        Ok((fitted, measured)) => {
            let text = match args.format {
                Format::Table => text(&fitted, args),
                Format::Json => json_text(&fitted, &measured, args),
            };
            terminal.print(&text)?;
            Ok(Exit::Done)
        }
        Err(error) => {
            if args.format == Format::Json {
                terminal.print(&Failure::outside(&shown, "fit", &error).json())?;
            }
            terminal.error(&format!("error: {error:#}\n"));
            Ok(Exit::Failed)
        }
    }
}

fn onset(text: &str) -> Result<Onset> {
    if text == "fit" {
        return Ok(Onset::Fitted);
    }
    match text.trim().parse::<f64>() {
        Ok(metres) if metres.is_finite() => Ok(Onset::At(metres)),
        _ => bail!("--onset '{text}': expected an indentation in metres, or fit to find it"),
    }
}

/// Rows count from 0 in the library and from the first line in a file.
fn in_file(error: &FitError, measured: &Measured) -> String {
    let line = |row: usize| measured.lines.get(row).copied().unwrap_or_default();
    match error {
        FitError::NotFinite { column, row, value } => {
            format!("line {}: {column} is {value}, expected a finite number", line(*row))
        }
        FitError::TimeOrder { row } => {
            format!("line {}: the time does not rise after it, expected rising times", line(*row))
        }
        other => other.to_string(),
    }
}

fn text(fitted: &Fit, args: &FitArgs) -> String {
    let mut table = table(&["parameter", "value", "95 % from", "to", "unit", "equation"]);
    let mut row = |name: &str, value: &Estimate, unit: &str, equation: &str| {
        let cells = [name, &number(value.value), &number(value.low), &number(value.high), unit, equation];
        table.add_row(cells.map(str::to_owned).to_vec());
    };
    row("E* (composite)", &fitted.composite_modulus, "N/m^2", "(1)");
    row("stiffness to write (E1*)", &fitted.plane_strain_modulus, "N/m^2", "(A.4)");
    if let Some(dissipation) = &fitted.dissipation {
        row("dissipation", dissipation, "s/m", "(12)");
    }
    if let Some(onset) = &fitted.onset_m {
        row("contact onset", onset, "m", "(1)");
    }
    right(&mut table, &[1, 2, 3]);
    let mut text = format!(
        "{}: {} rows in the fit, n = {}, R = {} m\n\n{}\n\n",
        args.file.display(),
        fitted.rows.len(),
        number(args.spheres),
        number(args.radius),
        table.trim_fmt()
    );
    text.push_str(&format!(
        "R squared {:.6}; residuals have a standard deviation of {} N\n",
        fitted.r_squared,
        number(fitted.residual_deviation_n)
    ));
    let holds = |holds: bool| if holds { "within" } else { "outside" };
    text.push_str(&format!(
        "largest indentation/radius {:.4}: {} the Hertz law (at most 0.16)\n",
        fitted.largest_relative_indentation,
        holds(fitted.hertz_holds)
    ));
    if fitted.largest_relative_indentation > 1.0 {
        text.push_str("that is more than the whole radius: is --indentation-unit right?\n");
    }
    match (fitted.restitution, fitted.hunt_crossley_holds, fitted.largest_speed_m_s) {
        (Some(restitution), Some(within), Some(speed)) => text.push_str(&format!(
            "restitution by (13) at the largest speed ({} m/s) {restitution:.4}: {} the Hunt-Crossley law (at least 0.8)\n",
            number(speed),
            holds(within)
        )),
        (None, Some(_), Some(speed)) => text.push_str(&format!(
            "at the largest speed ({} m/s) (13) is outside its domain: the Hunt-Crossley law does not hold\n",
            number(speed)
        )),
        _ => text.push_str("no speed is known, so the force is taken as elastic and dissipation is not fitted\n"),
    }
    if fitted.dissipation.is_some_and(|dissipation| dissipation.value < 0.0) {
        text.push_str(
            "the dissipation comes out below 0, which no model takes: check the sign of the speed\n",
        );
    }
    text
}

#[derive(Serialize)]
struct JsonFit<'f> {
    schema_version: u32,
    file: String,
    sphere_count: f64,
    radius_m: f64,
    composite_modulus_n_m2: JsonEstimate,
    stiffness: JsonEstimate,
    dissipation: Option<JsonEstimate>,
    onset_m: Option<JsonEstimate>,
    parameters: Vec<&'static str>,
    covariance: &'f [Vec<f64>],
    r_squared: f64,
    degrees_of_freedom: usize,
    residual_deviation_n: f64,
    largest_relative_indentation: f64,
    hertz_holds: bool,
    largest_speed_m_s: Option<f64>,
    restitution: Option<f64>,
    hunt_crossley_holds: Option<bool>,
    residuals: JsonResiduals<'f>,
}

#[derive(Serialize)]
struct JsonEstimate {
    value: f64,
    standard_error: f64,
    low_95: f64,
    high_95: f64,
}

#[derive(Serialize)]
struct JsonResiduals<'f> {
    line: Vec<u64>,
    force_n: &'f [f64],
}

impl From<&Estimate> for JsonEstimate {
    fn from(estimate: &Estimate) -> Self {
        Self {
            value: estimate.value,
            standard_error: estimate.standard_error,
            low_95: estimate.low,
            high_95: estimate.high,
        }
    }
}

fn json_text(fitted: &Fit, measured: &Measured, args: &FitArgs) -> String {
    let name = |parameter: &Parameter| match parameter {
        Parameter::CompositeModulus => "composite_modulus_n_m2",
        Parameter::Dissipation => "dissipation",
        Parameter::Onset => "onset_m",
    };
    json::line(&JsonFit {
        schema_version: 1,
        file: args.file.display().to_string(),
        sphere_count: args.spheres,
        radius_m: args.radius,
        composite_modulus_n_m2: (&fitted.composite_modulus).into(),
        stiffness: (&fitted.plane_strain_modulus).into(),
        dissipation: fitted.dissipation.as_ref().map(Into::into),
        onset_m: fitted.onset_m.as_ref().map(Into::into),
        parameters: fitted.parameters.iter().map(name).collect(),
        covariance: &fitted.covariance,
        r_squared: fitted.r_squared,
        degrees_of_freedom: fitted.degrees_of_freedom,
        residual_deviation_n: fitted.residual_deviation_n,
        largest_relative_indentation: fitted.largest_relative_indentation,
        hertz_holds: fitted.hertz_holds,
        largest_speed_m_s: fitted.largest_speed_m_s,
        restitution: fitted.restitution,
        hunt_crossley_holds: fitted.hunt_crossley_holds,
        residuals: JsonResiduals {
            line: fitted
                .rows
                .iter()
                .map(|&row| measured.lines.get(row).copied().unwrap_or_default())
                .collect(),
            force_n: &fitted.residuals_n,
        },
    })
}
