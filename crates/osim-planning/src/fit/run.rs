//! A measurement, fitted.

use std::path::PathBuf;

use contact_scaling::fit::{Fit, FitError, FitValues, Measurement, Rate, fit};
use osim_model::files::{Failure, Files};
use osim_requests::{FitRequest, RequestError, RequestFault};

use super::measured::Measured;

/// What a measurement says of a contact.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct FitResult {
    /// The measurement.
    pub file: PathBuf,
    /// Spheres that shared the force.
    pub sphere_count: f64,
    /// Their radius, m.
    pub radius_m: f64,
    /// The parameters, with what is left over.
    pub fit: Fit,
    /// Line in the file of each row that was fitted.
    pub lines: Vec<u64>,
}

/// Reads the measurement and fits it.
///
/// # Errors
/// Columns or cells that cannot be read, or values that cannot be fitted.
pub fn run_fit(request: &FitRequest, files: &dyn Files) -> Result<FitResult, RequestError> {
    let Some(file) = request.file.clone() else {
        return Err(RequestFault::Missing { field: "file" }.into());
    };
    let Some(radius) = request.radius else { return Err(RequestFault::Missing { field: "radius" }.into()) };
    let (sphere_count, radius_m) = (request.spheres.get(), radius.get());
    let values =
        FitValues { radius_m, sphere_count, onset: request.onset.get(), branch: request.branch.branch() };
    let shown = file.display().to_string();
    let failed = |why: String| Failure::outside(&shown, "fit", format!("{shown}: {why}"));
    let measured = Measured::read(&file, &request.columns, files).map_err(failed)?;
    let rate = match (&measured.speed_m_s, &measured.time_s) {
        (Some(speed), _) => Rate::Speed(speed),
        (None, Some(time)) => Rate::Time(time),
        (None, None) => Rate::Unknown,
    };
    let measurement =
        Measurement { indentation_m: &measured.indentation_m, force_n: &measured.force_n, rate };
    let fit = fit(&measurement, &values).map_err(|error| failed(in_file(&error, &measured)))?;
    let lines = fit.rows.iter().map(|&row| measured.line(row)).collect();
    Ok(FitResult { file, sphere_count, radius_m, fit, lines })
}

/// Rows count from 0 in the equations and from the first line in a file.
fn in_file(error: &FitError, measured: &Measured) -> String {
    match error {
        FitError::NotFinite { column, row, value } => {
            format!("line {}: {column} is {value}, expected a finite number", measured.line(*row))
        }
        FitError::TimeOrder { row } => {
            format!("line {}: the time does not rise after it, expected rising times", measured.line(*row))
        }
        other => other.to_string(),
    }
}
