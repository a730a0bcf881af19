//! How a summary is spelled: the lines of a table, or of JSON.

use std::path::Path;

use osim_model::messages::{Input, phrase};
use osim_planning::cell;

use super::record::{JsonRecord, Record};
use crate::fault::LibraryFault;

/// How a summary is written, by the ending of its name.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Form {
    Csv,
    Ndjson,
}

impl Form {
    pub(super) fn of(path: &Path) -> Result<Self, LibraryFault> {
        match path.extension().map(std::ffi::OsStr::to_ascii_lowercase) {
            Some(extension) if extension == "csv" => Ok(Self::Csv),
            Some(extension) if extension == "ndjson" || extension == "jsonl" => Ok(Self::Ndjson),
            _ => Err(LibraryFault::new(phrase![
                Input::Summary,
                format!(" '{}': expected a name that ends in .csv or .ndjson", path.display()),
            ])),
        }
    }

    /// One record and a line end; `first` with the header.
    pub(super) fn line(self, record: &Record, first: bool) -> Result<Vec<u8>, LibraryFault> {
        if self == Self::Ndjson {
            let mut line = serde_json::to_vec(&JsonRecord::from(record.clone())).map_err(said)?;
            line.push(b'\n');
            return Ok(line);
        }
        let mut csv = csv::WriterBuilder::new().has_headers(first).from_writer(Vec::new());
        csv.serialize(record.as_cells()).map_err(said)?;
        with_remarks(csv.into_inner().map_err(said)?, record)
    }
}

/// The first line of a summary with these columns after its own.
///
/// # Errors
/// None in practice: it is written into memory.
pub(super) fn header_line<'c>(own: impl Iterator<Item = &'c str>) -> Result<Vec<u8>, LibraryFault> {
    let line = Form::Csv.line(&Record::default(), true)?;
    let mut columns = csv::Reader::from_reader(line.as_slice()).headers().map_err(said)?.clone();
    columns.extend(own);
    let mut csv = csv::WriterBuilder::new().from_writer(Vec::new());
    csv.write_record(&columns).map_err(said)?;
    csv.into_inner().map_err(said)
}

/// Columns of the user's own table come after those of a summary.
fn with_remarks(lines: Vec<u8>, record: &Record) -> Result<Vec<u8>, LibraryFault> {
    if record.remarks.is_empty() {
        return Ok(lines);
    }
    let mut reader = csv::ReaderBuilder::new().has_headers(false).from_reader(lines.as_slice());
    let mut rows: Vec<csv::StringRecord> = reader.records().collect::<Result<_, _>>().map_err(said)?;
    // The line of the record is the last one; the names of the columns may be before it.
    let last = rows.len().saturating_sub(1);
    let mut csv = csv::WriterBuilder::new().from_writer(Vec::new());
    for (index, row) in rows.iter_mut().enumerate() {
        let remarks = record.remarks.iter();
        row.extend(remarks.map(|(name, text)| if index == last { cell(text) } else { cell(name) }));
        csv.write_record(&*row).map_err(said)?;
    }
    csv.into_inner().map_err(said)
}

/// The error of another library.
fn said(error: impl std::fmt::Display) -> LibraryFault {
    LibraryFault::new(error.to_string())
}
