//! A measured curve from a CSV file, as spreadsheets of any country write it.

use std::path::Path;

use anyhow::{Context, Result, anyhow, bail};

use crate::args::{ColumnArgs, ForceUnit, LengthUnit, SpeedUnit, TimeUnit};
use crate::load::read;
use crate::spreadsheet::Sheet;

/// Columns in SI units; row `i` of each belongs together.
pub(crate) struct Measured {
    pub indentation_m: Vec<f64>,
    pub force_n: Vec<f64>,
    pub speed_m_s: Option<Vec<f64>>,
    pub time_s: Option<Vec<f64>>,
    /// Line of each row in the file.
    pub lines: Vec<u64>,
}

/// Reads the columns that `columns` names.
///
/// # Errors
/// A column that is missing (with those that are there), a row of another length, or a cell that is no number, with
/// row and column.
pub(crate) fn read_columns(path: &Path, columns: &ColumnArgs) -> Result<Measured> {
    let shown = path.display().to_string();
    let bytes = read(path).with_context(|| shown.clone())?;
    let sheet = Sheet::read(&bytes).with_context(|| shown.clone())?;
    let header = &sheet.header;
    let find = |name: &str| -> Result<usize> {
        if header.iter().filter(|cell| cell.eq_ignore_ascii_case(name)).count() > 1 {
            bail!("{shown}: the column '{name}' is there twice, expected one");
        }
        header.iter().position(|cell| cell.eq_ignore_ascii_case(name)).ok_or_else(|| {
            let known: Vec<_> = header.iter().map(|cell| format!("'{cell}'")).collect();
            let known = if known.is_empty() { "nothing".to_owned() } else { known.join(", ") };
            anyhow!("{shown}: no column '{name}' in the first row, which has {known}")
        })
    };
    let mut wanted = vec![
        Column::new(find(&columns.indentation_column)?, length(columns.indentation_unit)),
        Column::new(find(&columns.force_column)?, force(columns.force_unit)),
    ];
    if let Some(name) = &columns.speed_column {
        wanted.push(Column::new(find(name)?, speed(columns.speed_unit)));
    }
    if let Some(name) = &columns.time_column {
        wanted.push(Column::new(find(name)?, time(columns.time_unit)));
    }
    let mut lines = Vec::new();
    for row in &sheet.rows {
        for column in &mut wanted {
            let cell = row.cells.get(column.index).map_or("", String::as_str);
            let name = header.get(column.index).map_or("", String::as_str);
            let value = cell_number(cell, &sheet)
                .map_err(|why| anyhow!("{shown}: line {}, column '{name}': '{cell}' {why}", row.line))?;
            column.values.push(value * column.unit);
        }
        lines.push(row.line);
    }
    let mut taken = wanted.into_iter().map(|column| column.values);
    let (indentation_m, force_n) = (taken.next().unwrap_or_default(), taken.next().unwrap_or_default());
    let rate = taken.next();
    let (speed_m_s, time_s) = if columns.speed_column.is_some() { (rate, None) } else { (None, rate) };
    Ok(Measured { indentation_m, force_n, speed_m_s, time_s, lines })
}

struct Column {
    index: usize,
    unit: f64,
    values: Vec<f64>,
}

impl Column {
    fn new(index: usize, unit: f64) -> Self {
        Self { index, unit, values: Vec::new() }
    }
}

/// A finite number.
fn cell_number(cell: &str, sheet: &Sheet) -> Result<f64, &'static str> {
    if cell.is_empty() {
        return Err("is empty, expected a number");
    }
    let text = sheet.with_point(cell)?;
    match text.parse::<f64>() {
        Ok(value) if value.is_finite() => Ok(value),
        Ok(_) => Err("is not finite, expected a number"),
        Err(_) => Err("is no number"),
    }
}

fn length(unit: LengthUnit) -> f64 {
    match unit {
        LengthUnit::M => 1.0,
        LengthUnit::Mm => 1e-3,
        LengthUnit::Um => 1e-6,
    }
}

fn force(unit: ForceUnit) -> f64 {
    match unit {
        ForceUnit::Newton => 1.0,
        ForceUnit::Kilonewton => 1e3,
        ForceUnit::Millinewton => 1e-3,
    }
}

fn speed(unit: SpeedUnit) -> f64 {
    match unit {
        SpeedUnit::MetresPerSecond => 1.0,
        SpeedUnit::MillimetresPerSecond => 1e-3,
    }
}

fn time(unit: TimeUnit) -> f64 {
    match unit {
        TimeUnit::S => 1.0,
        TimeUnit::Ms => 1e-3,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cell_is_one_plain_finite_number() {
        let commas = Sheet::read(b"a,b\n").unwrap();
        let semicolons = Sheet::read(b"a;b\n").unwrap();
        assert_eq!(cell_number("1,5", &semicolons), Ok(1.5));
        assert_eq!(cell_number("1.5", &commas), Ok(1.5));
        for cell in ["nan", "", "5 N", "1,5"] {
            assert!(cell_number(cell, &commas).is_err(), "{cell}");
        }
    }
}
