//! A measured curve from a CSV file, as spreadsheets of any country write it.

use std::path::Path;

use osim_model::files::Files;
use osim_requests::options::ColumnOptions;

use crate::sheet::Sheet;

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
        let find = |name: &str| sheet.column(name);
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

    /// Line of a row in the file.
    pub(super) fn line(&self, row: usize) -> u64 {
        self.lines.get(row).copied().unwrap_or_default()
    }
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
