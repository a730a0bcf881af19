//! Writes the lines of a summary in CSV or NDJSON, and reads the lines of an earlier summary one at a time.

use std::fs::File;
use std::io::{BufRead, BufReader, Read, Seek, SeekFrom};
use std::path::Path;
use std::sync::Mutex;

use osim_model::messages::{Input, phrase, shown};
use osim_planning::{cell, from_cell};

use crate::fault::{Context, LibraryFault, Result, fault_of_error, fault_of_panic};
use crate::partial::open_lines;
use crate::run::record::{JsonRecord, Record};

/// The format of a summary, which follows from the ending of its name.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum SummaryFormat {
    Csv,
    Ndjson,
}

impl SummaryFormat {
    /// The format that the ending of the name means.
    pub(super) fn of_path(path: &Path) -> Result<Self> {
        match path.extension().map(std::ffi::OsStr::to_ascii_lowercase) {
            Some(extension) if extension == "csv" => Ok(Self::Csv),
            Some(extension) if extension == "ndjson" || extension == "jsonl" => Ok(Self::Ndjson),
            _ => Err(LibraryFault::new(phrase![
                Input::Summary,
                format!(" '{}': expected a name that ends in .csv or .ndjson", path.display()),
            ])),
        }
    }

    /// A record as one line of a summary. In CSV the header precedes the `first` line.
    pub(super) fn record_line(self, record: &Record, first: bool) -> Result<Vec<u8>> {
        if self == Self::Ndjson {
            let mut line = serde_json::to_vec(&JsonRecord::from(record.clone())).map_err(fault_of_error)?;
            line.push(b'\n');
            return Ok(line);
        }
        let mut csv = csv::WriterBuilder::new().has_headers(first).from_writer(Vec::new());
        csv.serialize(record.with_texts_as_cells()).map_err(fault_of_error)?;
        with_user_columns(csv.into_inner().map_err(fault_of_error)?, record)
    }
}

/// The columns of every summary; those of the user come after them.
///
/// # Errors
/// None in practice, because the line is written into memory.
pub(super) fn summary_columns() -> Result<csv::StringRecord> {
    let line = SummaryFormat::Csv.record_line(&Record::default(), true)?;
    csv::Reader::from_reader(line.as_slice()).headers().map_err(fault_of_error).cloned()
}

/// The header of a table with `user_columns` after the columns of every summary.
///
/// # Errors
/// As [`summary_columns`].
fn header_line<'c>(user_columns: impl Iterator<Item = &'c str>) -> Result<Vec<u8>> {
    let mut columns = summary_columns()?;
    columns.extend(user_columns);
    let mut csv = csv::WriterBuilder::new().from_writer(Vec::new());
    csv.write_record(&columns).map_err(fault_of_error)?;
    csv.into_inner().map_err(fault_of_error)
}

/// Appends the user's own columns to the cells of a record, and of the header if `lines` has it.
fn with_user_columns(lines: Vec<u8>, record: &Record) -> Result<Vec<u8>> {
    if record.user_columns.is_empty() {
        return Ok(lines);
    }
    let mut reader = csv::ReaderBuilder::new().has_headers(false).from_reader(lines.as_slice());
    let mut rows: Vec<csv::StringRecord> =
        reader.records().collect::<Result<_, _>>().map_err(fault_of_error)?;
    // The record is the last line; the header may be before it.
    let last = rows.len().saturating_sub(1);
    let mut csv = csv::WriterBuilder::new().from_writer(Vec::new());
    for (index, row) in rows.iter_mut().enumerate() {
        let user_columns = record.user_columns.iter();
        row.extend(user_columns.map(|(name, text)| if index == last { cell(text) } else { cell(name) }));
        csv.write_record(&*row).map_err(fault_of_error)?;
    }
    csv.into_inner().map_err(fault_of_error)
}

/// An earlier summary or partial summary, which stays open while a resumed run replaces it.
pub(super) struct PreviousLines {
    format: SummaryFormat,
    file: Mutex<File>,
    /// Length of the summary's complete lines, in bytes.
    end: u64,
    header: csv::StringRecord,
}

impl PreviousLines {
    /// Opens a summary, to read its lines.
    ///
    /// # Errors
    /// As [`open_lines`].
    pub(super) fn open(path: &Path, format: SummaryFormat, may_be_cut: bool) -> Result<Self> {
        let (file, end) = open_lines(path, may_be_cut)?;
        Ok(Self { format, file: Mutex::new(file), end, header: csv::StringRecord::new() })
    }

    /// Calls `each` with every record and the offset of its line. `user_columns` are the user's own columns in this run, `None` if they
    /// are not known.
    ///
    /// # Errors
    /// The file is not a summary, or has another header.
    pub(super) fn for_each(
        &mut self,
        user_columns: Option<&[String]>,
        mut each: impl FnMut(u64, &Record),
    ) -> Result<()> {
        let not_a_summary = || "this is not a summary of this tool, or it was edited";
        let mut header = csv::StringRecord::new();
        {
            let mut file = self.file.lock().map_err(|_| fault_of_panic())?;
            file.seek(SeekFrom::Start(0)).map_err(fault_of_error)?;
            let lines = BufReader::new(&mut *file).take(self.end);
            match self.format {
                SummaryFormat::Ndjson => for_each_json_line(lines, &mut each).context(not_a_summary)?,
                SummaryFormat::Csv => {
                    header = for_each_row(lines, user_columns, &mut each).context(not_a_summary)?;
                }
            }
        }
        self.header = header;
        Ok(())
    }

    /// Reads the record whose line begins at `offset`.
    pub(super) fn record_at(&self, offset: u64) -> Result<Record> {
        let mut file = self.file.lock().map_err(|_| fault_of_panic())?;
        file.seek(SeekFrom::Start(offset)).map_err(fault_of_error)?;
        let mut lines = BufReader::new(&mut *file).take(self.end.saturating_sub(offset));
        if self.format == SummaryFormat::Ndjson {
            let mut line = Vec::new();
            lines.read_until(b'\n', &mut line).map_err(fault_of_error)?;
            return serde_json::from_slice::<JsonRecord>(&line).map(Record::from).map_err(fault_of_error);
        }
        let mut row = csv::StringRecord::new();
        csv::ReaderBuilder::new()
            .has_headers(false)
            .from_reader(lines)
            .read_record(&mut row)
            .map_err(fault_of_error)?;
        let record: Record = row.deserialize(Some(&self.header)).map_err(fault_of_error)?;
        let cells = self.header.iter().zip(&row).map(|(name, text)| (from_cell(name), from_cell(text)));
        let user_columns = cells.skip(summary_columns()?.len());
        let user_columns = user_columns.map(|(name, text)| (name.into_owned(), text.into_owned())).collect();
        Ok(Record { user_columns, ..record.with_texts_from_cells() })
    }
}

/// Calls `each` with every record of a summary in NDJSON, and the offset of its line.
fn for_each_json_line(mut lines: impl BufRead, each: &mut impl FnMut(u64, &Record)) -> Result<()> {
    let (mut offset, mut line) = (0, Vec::new());
    loop {
        line.clear();
        let length = lines.read_until(b'\n', &mut line).map_err(fault_of_error)?;
        if length == 0 {
            return Ok(());
        }
        if line != b"\n" {
            let record = serde_json::from_slice::<JsonRecord>(&line).map_err(fault_of_error)?;
            each(offset, &record.into());
        }
        offset += length as u64;
    }
}

/// Calls `each` with every record of a summary in CSV, and the offset of its line; returns the header.
fn for_each_row(
    mut lines: impl BufRead,
    user_columns: Option<&[String]>,
    each: &mut impl FnMut(u64, &Record),
) -> Result<csv::StringRecord> {
    let mut first = Vec::new();
    if lines.read_until(b'\n', &mut first).map_err(fault_of_error)? == 0 {
        return Ok(csv::StringRecord::new());
    }
    let header = csv::Reader::from_reader(first.as_slice()).headers().map_err(fault_of_error)?.clone();
    check_header(&header, &first, user_columns)?;
    let mut reader = csv::ReaderBuilder::new().has_headers(false).from_reader(lines);
    let mut row = csv::StringRecord::new();
    while reader.read_record(&mut row).map_err(fault_of_error)? {
        let record: Record = row.deserialize(Some(&header)).map_err(fault_of_error)?;
        let offset = row.position().map_or(0, csv::Position::byte);
        each(first.len() as u64 + offset, &record.with_texts_from_cells());
    }
    Ok(header)
}

/// Refuses a table whose first line is not, byte for byte, a header of this version, or that has user columns which the new summary
/// would lose.
fn check_header(header: &csv::StringRecord, first: &[u8], user_columns: Option<&[String]>) -> Result<()> {
    let user_columns_of_file: Vec<&str> = header.iter().skip(summary_columns()?.len()).collect();
    if header_line(user_columns_of_file.iter().copied())? != first {
        return Err(LibraryFault::new("its first line differs from the one that this version writes"));
    }
    let is_lost = |column: &&&str| {
        user_columns.is_some_and(|user_columns| !user_columns.iter().any(|name| *name == from_cell(column)))
    };
    match user_columns_of_file.iter().find(is_lost) {
        Some(column) => Err(LibraryFault::new(format!(
            "it has the column '{}', which this run does not have",
            shown(column)
        ))),
        None => Ok(()),
    }
}
