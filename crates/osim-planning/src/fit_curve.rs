//! Fits contact parameters to a measured curve of force over indentation.

use std::path::{Path, PathBuf};

use contact_scaling::fit::{Fit, FitError, FitValues, Measurement, Rate, fit};
use osim_model::files::{Failure, Files};
use osim_model::messages::{Input, four_significant, phrase};
use osim_model::{Suspicion, YesQuestion};
use osim_requests::{ColumnOptions, FitRequest, LengthUnit, RequestFault, Result};

use crate::calculator::require_plausible_radius;
use crate::sheet::Sheet;

/// The deepest indentation over the radius that is believed without an answer: the whole sphere is in the other surface.
const DEEPEST_PLAUSIBLE: f64 = 2.0;
const IMPLAUSIBLE: YesQuestion = YesQuestion::ImplausibleRadius;

/// A fit of contact parameters to a measured curve.
#[derive(Debug, Clone)]
pub struct FitResult {
    pub file: PathBuf,
    /// Number of spheres that shared the force.
    pub sphere_count: f64,
    pub radius_m: f64,
    /// The fitted parameters, with the residuals of the fit.
    pub fit: Fit,
    /// The lines in the file of the rows that were fitted.
    pub lines: Vec<u64>,
}

/// Reads the measured curve and fits contact parameters to it.
///
/// # Errors
/// Columns or cells that cannot be read, or values that cannot be fitted.
pub fn run_fit(request: &FitRequest, files: &dyn Files) -> Result<FitResult> {
    let file = request.file.clone().ok_or(RequestFault::Missing { field: "file" })?;
    let radius = request.radius.ok_or(RequestFault::Missing { field: "radius" })?;
    let (sphere_count, radius_m) = (request.spheres.get(), radius.get());
    require_plausible_radius(radius_m, &request.answers)?;
    let values =
        FitValues { radius_m, sphere_count, onset: request.onset.get(), branch: request.branch.branch() };
    let shown = file.display().to_string();
    let failed = |why: String| Failure::outside(&shown, "fit", format!("{shown}: {why}"));
    let measured = MeasuredCurve::read(&file, &request.columns, files).map_err(failed)?;
    let rate = match (&measured.speed_m_s, &measured.time_s) {
        (Some(speed), _) => Rate::Speed(speed),
        (None, Some(time)) => Rate::Time(time),
        (None, None) => Rate::Unknown,
    };
    let measurement =
        Measurement { indentation_m: &measured.indentation_m, force_n: &measured.force_n, rate };
    let fit = fit(&measurement, &values).map_err(|error| failed(with_line_of_file(&error, &measured)))?;
    if fit.largest_relative_indentation > DEEPEST_PLAUSIBLE && !request.answers.confirms(IMPLAUSIBLE) {
        let times = four_significant(fit.largest_relative_indentation);
        let text = match request.columns.indentation_unit {
            LengthUnit::M => phrase![
                "the indentation goes to {times} times the radius: if it is in mm, add {}";
                Input::IndentationUnit.with_value("mm")
            ],
            _ => {
                phrase!["the indentation goes to {times} times the radius: are {} and its unit right?"; Input::Radius]
            }
        };
        let doubt = Suspicion::Other { question: IMPLAUSIBLE, text };
        return Err(RequestFault::refused(Input::IndentationUnit, doubt.phrase()).into());
    }
    let lines = fit.rows.iter().map(|&row| measured.line_of_row(row)).collect();
    Ok(FitResult { file, sphere_count, radius_m, fit, lines })
}

/// The error in words. It names the line in the file instead of the row number of the equations, which count from 0.
fn with_line_of_file(error: &FitError, measured: &MeasuredCurve) -> String {
    match error {
        FitError::NotFinite { column, row, value } => {
            format!("line {}: {column} is {value}, expected a finite number", measured.line_of_row(*row))
        }
        FitError::TimeOrder { row } => {
            format!(
                "line {}: the time does not rise after it, expected rising times",
                measured.line_of_row(*row)
            )
        }
        other => other.to_string(),
    }
}

/// A measured curve from a CSV file, in SI units; the values at one index belong together.
struct MeasuredCurve {
    indentation_m: Vec<f64>,
    force_n: Vec<f64>,
    speed_m_s: Option<Vec<f64>>,
    time_s: Option<Vec<f64>>,
    /// The line in the file of each row.
    lines: Vec<u64>,
}

impl MeasuredCurve {
    /// Reads the columns with the names in `columns`.
    ///
    /// # Errors
    /// A column that is missing (with those that are there), a row of another length, or a cell that is not a number, with
    /// row and column.
    fn read(path: &Path, columns: &ColumnOptions, files: &dyn Files) -> Result<Self, String> {
        let bytes = files.read(path).map_err(|error| error.to_string())?;
        let sheet = Sheet::read(&bytes)?;
        let header = &sheet.header;
        let column = |name: &str, unit: f64| {
            sheet.column(name).map(|index| Column { index, unit, values: Vec::new() })
        };
        let mut wanted = vec![
            column(&columns.indentation_column, columns.indentation_unit.metres())?,
            column(&columns.force_column, columns.force_unit.newtons())?,
        ];
        if let Some(name) = &columns.speed_column {
            wanted.push(column(name, columns.speed_unit.metres_per_second())?);
        }
        if let Some(name) = &columns.time_column {
            wanted.push(column(name, columns.time_unit.seconds())?);
        }
        let mut lines = Vec::new();
        for row in &sheet.rows {
            for column in &mut wanted {
                let cell = row.cells.get(column.index).map_or("", String::as_str);
                let name = header.get(column.index).map_or("", String::as_str);
                let value = sheet
                    .number(cell)
                    .map_err(|why| format!("line {}, column '{name}': '{cell}' {why}", row.line))?;
                column.values.push(value * column.unit);
            }
            lines.push(row.line);
        }
        let mut taken = wanted.into_iter().map(|column| column.values);
        let (indentation_m, force_n) = (taken.next().unwrap_or_default(), taken.next().unwrap_or_default());
        let rate = taken.next();
        let (speed_m_s, time_s) = if columns.speed_column.is_some() { (rate, None) } else { (None, rate) };
        Ok(Self { indentation_m, force_n, speed_m_s, time_s, lines })
    }

    /// The line in the file of a row of the curve.
    fn line_of_row(&self, row: usize) -> u64 {
        self.lines.get(row).copied().unwrap_or_default()
    }
}

/// A column of a measured curve, and the size of its unit in SI.
struct Column {
    index: usize,
    unit: f64,
    values: Vec<f64>,
}
