//! A measured curve from a CSV file, as spreadsheets of any country write it.

use std::path::Path;

use anyhow::{Context, Result, anyhow, bail};

use crate::args::{ColumnArgs, ForceUnit, LengthUnit, SpeedUnit, TimeUnit};
use crate::load::read;

/// Columns in SI units; row `i` of each belongs together.
pub(crate) struct Measured {
    pub indentation_m: Vec<f64>,
    pub force_n: Vec<f64>,
    pub speed_m_s: Option<Vec<f64>>,
    pub time_s: Option<Vec<f64>>,
    /// Line of each row in the file.
    pub lines: Vec<u64>,
}

const BYTE_ORDER_MARK: &[u8] = b"\xEF\xBB\xBF";

/// Reads the columns that `columns` names.
///
/// # Errors
/// A column that is missing (with those that are there), a row of another length, or a cell that is no number, with
/// row and column.
pub(crate) fn read_columns(path: &Path, columns: &ColumnArgs) -> Result<Measured> {
    let shown = path.display().to_string();
    let bytes = read(path).with_context(|| shown.clone())?;
    if bytes.starts_with(b"\xFF\xFE") || bytes.starts_with(b"\xFE\xFF") || bytes.contains(&0) {
        bail!("{shown}: the file is UTF-16 or binary: save it as CSV in UTF-8");
    }
    let bytes = bytes.strip_prefix(BYTE_ORDER_MARK).unwrap_or(&bytes);
    let delimiter = delimiter(bytes);
    let mut reader = csv::ReaderBuilder::new().delimiter(delimiter).trim(csv::Trim::All).from_reader(bytes);
    let header = reader.headers().with_context(|| shown.clone())?.clone();
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
    for record in reader.records() {
        let record = record.map_err(|error| anyhow!("{shown}: {}", in_words(&error)))?;
        let line = record.position().map_or(0, csv::Position::line);
        for column in &mut wanted {
            let cell = record.get(column.index).unwrap_or_default();
            let name = header.get(column.index).unwrap_or_default();
            let value = cell_number(cell, delimiter)
                .map_err(|why| anyhow!("{shown}: line {line}, column '{name}': '{cell}' {why}"))?;
            column.values.push(value * column.unit);
        }
        lines.push(line);
    }
    let mut taken = wanted.into_iter().map(|column| column.values);
    let (indentation_m, force_n) = (taken.next().unwrap_or_default(), taken.next().unwrap_or_default());
    let rate = taken.next();
    let (speed_m_s, time_s) = if columns.speed_column.is_some() { (rate, None) } else { (None, rate) };
    Ok(Measured { indentation_m, force_n, speed_m_s, time_s, lines })
}

/// What the CSV reader refuses.
fn in_words(error: &csv::Error) -> String {
    match error.kind() {
        csv::ErrorKind::UnequalLengths { pos: Some(place), expected_len, len } => {
            format!("line {}: {len} cells, expected {expected_len} as in the first row", place.line())
        }
        csv::ErrorKind::Utf8 { pos: Some(place), .. } => {
            format!("line {}: not UTF-8 text: save it as CSV in UTF-8", place.line())
        }
        _ => error.to_string(),
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

/// `;` and tabs part the cells where commas are decimal; the first line tells.
fn delimiter(bytes: &[u8]) -> u8 {
    let first = bytes.split(|&byte| byte == b'\n').next().unwrap_or_default();
    [b';', b'\t'].into_iter().find(|delimiter| first.contains(delimiter)).unwrap_or(b',')
}

/// A finite number, with a decimal comma only where cells are not parted by commas.
fn cell_number(cell: &str, delimiter: u8) -> Result<f64, &'static str> {
    if cell.is_empty() {
        return Err("is empty, expected a number");
    }
    let text = match (cell.matches(',').count(), cell.contains('.')) {
        (0, _) => cell.to_owned(),
        (1, false) if delimiter != b',' => cell.replace(',', "."),
        (1, false) => return Err("has a decimal comma: part the columns by ; or write a decimal point"),
        _ => return Err("has separators between thousands, expected a plain number"),
    };
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
    fn numbers_of_european_spreadsheets_are_read_where_they_are_clear() {
        assert_eq!(cell_number("1,5", b';'), Ok(1.5));
        assert_eq!(cell_number("1.5", b';'), Ok(1.5));
        assert!(cell_number("1.234,5", b';').is_err());
        assert!(cell_number("1,5", b',').is_err());
        assert!(cell_number("nan", b',').is_err());
        assert!(cell_number("", b',').is_err());
        assert!(cell_number("5 N", b',').is_err());
    }

    #[test]
    fn the_first_line_tells_the_delimiter() {
        assert_eq!(delimiter(b"a;b\n1,5;2"), b';');
        assert_eq!(delimiter(b"a\tb\n"), b'\t');
        assert_eq!(delimiter(b"a,b\n"), b',');
    }
}
