//! A measured curve from a CSV file, as spreadsheets of any country write it.

use std::path::Path;

use osim_model::files::Files;

use crate::options::ColumnOptions;
use crate::spreadsheet::Sheet;

/// Columns in SI units; row `i` of each belongs together.
pub(super) struct Measured {
    pub(super) indentation_m: Vec<f64>,
    pub(super) force_n: Vec<f64>,
    pub(super) speed_m_s: Option<Vec<f64>>,
    pub(super) time_s: Option<Vec<f64>>,
    /// Line of each row in the file.
    lines: Vec<u64>,
}

impl Measured {
    /// Reads the columns that `columns` names.
    ///
    /// # Errors
    /// A column that is missing (with those that are there), a row of another length, or a cell that is not a number, with
    /// row and column.
    pub(super) fn read(path: &Path, columns: &ColumnOptions, files: &dyn Files) -> Result<Self, String> {
        let bytes = files.read(path).map_err(|error| error.to_string())?;
        Self::of_sheet(&Sheet::read(&bytes)?, columns)
    }

    fn of_sheet(sheet: &Sheet, columns: &ColumnOptions) -> Result<Self, String> {
        let header = &sheet.header;
        let find = |name: &str| find(header, name);
        let mut wanted = vec![
            Column::new(find(&columns.indentation_column)?, columns.indentation_unit.metres()),
            Column::new(find(&columns.force_column)?, columns.force_unit.newtons()),
        ];
        if let Some(name) = &columns.speed_column {
            wanted.push(Column::new(find(name)?, columns.speed_unit.metres_per_second()));
        }
        if let Some(name) = &columns.time_column {
            wanted.push(Column::new(find(name)?, columns.time_unit.seconds()));
        }
        let mut lines = Vec::new();
        for row in &sheet.rows {
            for column in &mut wanted {
                let cell = row.cells.get(column.index).map_or("", String::as_str);
                let name = header.get(column.index).map_or("", String::as_str);
                let value = cell_number(cell, sheet)
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

    /// Line of a row in the file.
    pub(super) fn line(&self, row: usize) -> u64 {
        self.lines.get(row).copied().unwrap_or_default()
    }
}

/// The place of a column.
fn find(header: &[String], name: &str) -> Result<usize, String> {
    if header.iter().filter(|cell| cell.eq_ignore_ascii_case(name)).count() > 1 {
        return Err(format!("the column '{name}' appears twice, expected one"));
    }
    header.iter().position(|cell| cell.eq_ignore_ascii_case(name)).ok_or_else(|| {
        let known: Vec<_> = header.iter().map(|cell| format!("'{cell}'")).collect();
        let known = if known.is_empty() { "nothing".to_owned() } else { known.join(", ") };
        format!("no column '{name}' in the first row, which has {known}")
    })
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
        Err(_) => Err("is not a number"),
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
