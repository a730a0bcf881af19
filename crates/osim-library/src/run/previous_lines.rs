//! The lines of an earlier run's summary, read one at a time.

use std::fs::File;
use std::io::{BufRead, BufReader, Read, Seek, SeekFrom};
use std::path::Path;
use std::sync::Mutex;

use osim_model::messages::shown;
use osim_planning::from_cell;

use super::form::{Form, header_line};
use super::record::{JsonRecord, Record};
use crate::door;
use crate::fault::{Context, LibraryFault};
use crate::partial::end_of_lines;

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
        let (mut file, length) = door::to_read(path).map_err(said)?;
        let end = end_of_lines(&mut file, length).map_err(said)?;
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
            file.seek(SeekFrom::Start(0)).map_err(said)?;
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
    ///
    /// # Errors
    /// It cannot be read any more.
    pub(super) fn at(&self, offset: u64) -> Result<Record, LibraryFault> {
        let mut file = self.file.lock().map_err(|_| ended_early())?;
        file.seek(SeekFrom::Start(offset)).map_err(said)?;
        let mut lines = BufReader::new(&mut *file).take(self.end.saturating_sub(offset));
        if self.form == Form::Ndjson {
            let mut line = Vec::new();
            lines.read_until(b'\n', &mut line).map_err(said)?;
            return serde_json::from_slice::<JsonRecord>(&line).map(Record::from).map_err(said);
        }
        let mut row = csv::StringRecord::new();
        csv::ReaderBuilder::new()
            .has_headers(false)
            .from_reader(lines)
            .read_record(&mut row)
            .map_err(said)?;
        let record: Record = row.deserialize(Some(&self.header)).map_err(said)?;
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
        let length = lines.read_until(b'\n', &mut line).map_err(said)?;
        if length == 0 {
            return Ok(());
        }
        if line != b"\n" {
            let record = serde_json::from_slice::<JsonRecord>(&line).map_err(said)?;
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
    if lines.read_until(b'\n', &mut first).map_err(said)? == 0 {
        return Ok(csv::StringRecord::new());
    }
    let header = csv::Reader::from_reader(first.as_slice()).headers().map_err(said)?.clone();
    check_header(&header, &first, own)?;
    let mut reader = csv::ReaderBuilder::new().has_headers(false).from_reader(lines);
    let mut row = csv::StringRecord::new();
    while reader.read_record(&mut row).map_err(said)? {
        let record: Record = row.deserialize(Some(&header)).map_err(said)?;
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

/// What another library says.
fn said(error: impl std::fmt::Display) -> LibraryFault {
    LibraryFault::new(error.to_string())
}

fn ended_early() -> LibraryFault {
    LibraryFault::new("a thread ended early")
}
