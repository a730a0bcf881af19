//! The lines of a summary, of a table or of JSON: how they are spelled, and those of an earlier run, read one at a time.

use std::fs::File;
use std::io::{BufRead, BufReader, Read, Seek, SeekFrom};
use std::path::Path;
use std::sync::Mutex;

use osim_model::messages::{Input, phrase, shown};
use osim_planning::{cell, from_cell};

use crate::door;
use crate::fault::{Context, LibraryFault, foreign_fault};
use crate::partial::end_of_lines;
use crate::run::record::{JsonRecord, Record};

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
            let mut line = serde_json::to_vec(&JsonRecord::from(record.clone())).map_err(foreign_fault)?;
            line.push(b'\n');
            return Ok(line);
        }
        let mut csv = csv::WriterBuilder::new().has_headers(first).from_writer(Vec::new());
        csv.serialize(record.as_cells()).map_err(foreign_fault)?;
        with_remarks(csv.into_inner().map_err(foreign_fault)?, record)
    }
}

/// The first line of a summary with these columns after its own.
///
/// # Errors
/// None in practice: it is written into memory.
fn header_line<'c>(own: impl Iterator<Item = &'c str>) -> Result<Vec<u8>, LibraryFault> {
    let line = Form::Csv.line(&Record::default(), true)?;
    let mut columns = csv::Reader::from_reader(line.as_slice()).headers().map_err(foreign_fault)?.clone();
    columns.extend(own);
    let mut csv = csv::WriterBuilder::new().from_writer(Vec::new());
    csv.write_record(&columns).map_err(foreign_fault)?;
    csv.into_inner().map_err(foreign_fault)
}

/// Columns of the user's own table come after those of a summary.
fn with_remarks(lines: Vec<u8>, record: &Record) -> Result<Vec<u8>, LibraryFault> {
    if record.remarks.is_empty() {
        return Ok(lines);
    }
    let mut reader = csv::ReaderBuilder::new().has_headers(false).from_reader(lines.as_slice());
    let mut rows: Vec<csv::StringRecord> =
        reader.records().collect::<Result<_, _>>().map_err(foreign_fault)?;
    // The line of the record is the last one; the names of the columns may be before it.
    let last = rows.len().saturating_sub(1);
    let mut csv = csv::WriterBuilder::new().from_writer(Vec::new());
    for (index, row) in rows.iter_mut().enumerate() {
        let remarks = record.remarks.iter();
        row.extend(remarks.map(|(name, text)| if index == last { cell(text) } else { cell(name) }));
        csv.write_record(&*row).map_err(foreign_fault)?;
    }
    csv.into_inner().map_err(foreign_fault)
}

/// A summary, whole or partial, that stays open: a resumed run replaces its name, not the file.
pub(super) struct PreviousLines {
    form: Form,
    file: Mutex<File>,
    /// Where its last whole line ends.
    end: u64,
    header: csv::StringRecord,
}

impl PreviousLines {
    /// # Errors
    /// It cannot be read, or its last line is cut off and it is not one that `may_be_cut`.
    pub(super) fn open(path: &Path, form: Form, may_be_cut: bool) -> Result<Self, LibraryFault> {
        let (mut file, length) = door::to_read(path).map_err(foreign_fault)?;
        let end = end_of_lines(&mut file, length).map_err(foreign_fault)?;
        if end < length && !may_be_cut {
            let why = "its last line is cut off, so this tool did not leave it like that";
            return Err(LibraryFault::new(why));
        }
        Ok(Self { form, file: Mutex::new(file), end, header: csv::StringRecord::new() })
    }

    /// Calls `each` with every record and where its line begins. `own` are the user's own columns in this run, `None` if not
    /// known.
    ///
    /// # Errors
    /// The lines hold something else; also where a table has another header and not one line.
    pub(super) fn each(
        &mut self,
        own: Option<&[String]>,
        mut each: impl FnMut(u64, &Record),
    ) -> Result<(), LibraryFault> {
        let no_summary = || "this is not a summary of this tool, or it was edited";
        let mut header = csv::StringRecord::new();
        {
            let mut file = self.file.lock().map_err(|_| ended_early())?;
            file.seek(SeekFrom::Start(0)).map_err(foreign_fault)?;
            let lines = BufReader::new(&mut *file).take(self.end);
            match self.form {
                Form::Ndjson => each_json(lines, &mut each).context(no_summary)?,
                Form::Csv => header = each_row(lines, own, &mut each).context(no_summary)?,
            }
        }
        self.header = header;
        Ok(())
    }

    /// The record whose line begins at `offset`.
    pub(super) fn at(&self, offset: u64) -> Result<Record, LibraryFault> {
        let mut file = self.file.lock().map_err(|_| ended_early())?;
        file.seek(SeekFrom::Start(offset)).map_err(foreign_fault)?;
        let mut lines = BufReader::new(&mut *file).take(self.end.saturating_sub(offset));
        if self.form == Form::Ndjson {
            let mut line = Vec::new();
            lines.read_until(b'\n', &mut line).map_err(foreign_fault)?;
            return serde_json::from_slice::<JsonRecord>(&line).map(Record::from).map_err(foreign_fault);
        }
        let mut row = csv::StringRecord::new();
        csv::ReaderBuilder::new()
            .has_headers(false)
            .from_reader(lines)
            .read_record(&mut row)
            .map_err(foreign_fault)?;
        let record: Record = row.deserialize(Some(&self.header)).map_err(foreign_fault)?;
        let cells = self.header.iter().zip(&row).map(|(name, text)| (from_cell(name), from_cell(text)));
        let remarks = cells.filter(|(name, _)| name.starts_with('#'));
        let remarks = remarks.map(|(name, text)| (name.into_owned(), text.into_owned())).collect();
        Ok(Record { remarks, ..record.read_from_cells() })
    }
}

fn each_json(mut lines: impl BufRead, each: &mut impl FnMut(u64, &Record)) -> Result<(), LibraryFault> {
    let (mut offset, mut line) = (0, Vec::new());
    loop {
        line.clear();
        let length = lines.read_until(b'\n', &mut line).map_err(foreign_fault)?;
        if length == 0 {
            return Ok(());
        }
        if line != b"\n" {
            let record = serde_json::from_slice::<JsonRecord>(&line).map_err(foreign_fault)?;
            each(offset, &record.into());
        }
        offset += length as u64;
    }
}

fn each_row(
    mut lines: impl BufRead,
    own: Option<&[String]>,
    each: &mut impl FnMut(u64, &Record),
) -> Result<csv::StringRecord, LibraryFault> {
    let mut first = Vec::new();
    if lines.read_until(b'\n', &mut first).map_err(foreign_fault)? == 0 {
        return Ok(csv::StringRecord::new());
    }
    let header = csv::Reader::from_reader(first.as_slice()).headers().map_err(foreign_fault)?.clone();
    check_header(&header, &first, own)?;
    let mut reader = csv::ReaderBuilder::new().has_headers(false).from_reader(lines);
    let mut row = csv::StringRecord::new();
    while reader.read_record(&mut row).map_err(foreign_fault)? {
        let record: Record = row.deserialize(Some(&header)).map_err(foreign_fault)?;
        let offset = row.position().map_or(0, csv::Position::byte);
        each(first.len() as u64 + offset, &record.read_from_cells());
    }
    Ok(header)
}

/// The first line is, byte for byte, one of ours: otherwise another program saved the table, perhaps with columns of the user's,
/// which the new summary would not have.
fn check_header(
    header: &csv::StringRecord,
    first: &[u8],
    own: Option<&[String]>,
) -> Result<(), LibraryFault> {
    let added: Vec<&str> = header.iter().skip_while(|column| !column.starts_with('#')).collect();
    if header_line(added.iter().copied())? != first {
        return Err(LibraryFault::new("its first line differs from the one that this version writes"));
    }
    let lost = |column: &&&str| own.is_some_and(|own| !own.iter().any(|name| *name == from_cell(column)));
    match added.iter().find(lost) {
        Some(column) => Err(LibraryFault::new(format!(
            "it has the column '{}', which this run does not have",
            shown(column)
        ))),
        None => Ok(()),
    }
}

fn ended_early() -> LibraryFault {
    LibraryFault::new("a thread ended early")
}
