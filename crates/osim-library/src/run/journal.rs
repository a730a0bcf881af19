//! A summary: one line per model, in order; and while the run lasts, `FILE.partial` in the order of the work.
//!
//! A line of the partial file is written before its output takes its name. Whenever the program is killed, every
//! finished output therefore has its line, and a run that goes on compares what the line says with what is there.

use std::ffi::OsString;
use std::fs::File;
use std::io::{Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::sync::Mutex;

use osim_model::wording::{Input, phrase};
use osim_requests::cell;
use osim_requests::options::RunOptions;

use super::record::{JsonRecord, Record};
use crate::door;
use crate::fault::{Context, LibraryFault};
use crate::folders::make_folder_of;
use crate::write::{Mode, Prepared};

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
                format!(" {}: expected a name that ends in .csv or .ndjson", path.display()),
            ])),
        }
    }

    /// One record and a line end; `first` with the header.
    fn line(self, record: &Record, first: bool) -> Result<Vec<u8>, LibraryFault> {
        if self == Self::Ndjson {
            let mut line = serde_json::to_vec(&JsonRecord::from(record.clone())).map_err(said)?;
            line.push(b'\n');
            return Ok(line);
        }
        let mut csv = csv::WriterBuilder::new().has_headers(first).from_writer(Vec::new());
        csv.serialize(record.marked()).map_err(said)?;
        with_remarks(csv.into_inner().map_err(said)?, record)
    }
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

/// What another library says.
fn said(error: impl std::fmt::Display) -> LibraryFault {
    LibraryFault::new(error.to_string())
}

/// The file that lasts as long as the run.
pub(super) fn partial(path: &Path) -> PathBuf {
    let mut name = OsString::from(path.as_os_str());
    name.push(".partial");
    PathBuf::from(name)
}

/// The length of what was written to its end.
fn whole_lines(path: &Path) -> std::io::Result<u64> {
    let (mut file, length) = door::to_read(path)?;
    end_of_lines(&mut file, length)
}

/// Where the last whole line ends.
pub(super) fn end_of_lines(file: &mut File, length: u64) -> std::io::Result<u64> {
    const BLOCK: u64 = 1 << 16;
    let mut end = length;
    while end > 0 {
        let start = end.saturating_sub(BLOCK);
        file.seek(SeekFrom::Start(start))?;
        let mut block = Vec::new();
        Read::by_ref(file).take(end - start).read_to_end(&mut block)?;
        if let Some(at) = block.iter().rposition(|&byte| byte == b'\n') {
            return Ok(start + at as u64 + 1);
        }
        end = start;
    }
    Ok(0)
}

/// A summary that is being written.
#[derive(Debug)]
pub(super) struct Journal {
    form: Form,
    /// In the order of the work.
    partial: Mutex<Partial>,
    partial_path: PathBuf,
    /// In the order of the models.
    summary: Mutex<Summary>,
}

#[derive(Debug)]
struct Summary {
    file: Prepared,
    first: bool,
    /// Why it is not whole; then no more is added.
    broken: Option<LibraryFault>,
}

impl Summary {
    fn add(&mut self, form: Form, record: &Record) -> Result<(), LibraryFault> {
        let line = form.line(record, self.first)?;
        self.first = false;
        self.file.add(&line)
    }
}

/// Whole lines only.
#[derive(Debug)]
struct Partial {
    file: File,
    length: u64,
}

impl Partial {
    /// Opens the file for this run alone, with the whole lines that are there if it goes on with them.
    fn open(path: &Path, summary: &Path, resume: bool) -> Result<Self, LibraryFault> {
        let cannot = || format!("cannot write {}", path.display());
        let file = door::append(path).map_err(|error| door::reason(&error)).context(cannot)?;
        if file.try_lock().is_err_and(|error| matches!(error, std::fs::TryLockError::WouldBlock)) {
            return Err(LibraryFault::new(format!(
                "{} is being written by another run: give each run a summary of its own",
                summary.display()
            )));
        }
        // A line cut off when the run was killed must not run into the next one.
        let kept = if resume { whole_lines(path).context(cannot)? } else { 0 };
        file.set_len(kept).context(cannot)?;
        Ok(Self { file, length: kept })
    }

    fn add(&mut self, line: &[u8]) -> std::io::Result<()> {
        if let Err(error) = self.file.write_all(line) {
            // On a full disk a part of the line may be there: the next one would run into it.
            self.file.set_len(self.length)?;
            return Err(error);
        }
        self.length += line.len() as u64;
        Ok(())
    }
}

impl Journal {
    /// # Errors
    /// A summary of that name is there, and nothing says that the run goes on with it or replaces it; or another run is
    /// writing it.
    pub(super) fn begin(options: &RunOptions, force: bool) -> Result<Option<Self>, LibraryFault> {
        let Some(path) = &options.summary else { return Ok(None) };
        let form = Form::of(path)?;
        let partial_path = partial(path);
        make_folder_of(path)?;
        let replace = options.resume || force;
        if !replace && path.exists() {
            return Err(LibraryFault::new(phrase![
                format!("{} exists already: go on with it (", path.display()),
                Input::Resume,
                "), replace it (",
                Input::Force,
                "), or choose another name",
            ]));
        }
        if !replace && partial_path.exists() {
            return Err(LibraryFault::new(phrase![
                format!("{} was left by a run that was stopped: go on with it (", partial_path.display()),
                Input::Resume,
                "), or start again (",
                Input::Force,
                ")",
            ]));
        }
        let mode = if replace { Mode::Replace } else { Mode::New };
        let summary = Summary { file: Prepared::begin(path, None, mode)?, first: true, broken: None };
        let partial = Mutex::new(Partial::open(&partial_path, path, options.resume)?);
        Ok(Some(Self { form, partial, partial_path, summary: Mutex::new(summary) }))
    }

    /// An output is complete and about to take its name.
    pub(super) fn about_to_finish(&self, record: &Record) -> Result<(), LibraryFault> {
        let mut partial = self.partial.lock().map_err(|_| LibraryFault::new("a thread ended early"))?;
        let line = self.form.line(record, partial.length == 0)?;
        partial.add(&line).context(|| format!("cannot write {}", self.partial_path.display()))
    }

    /// The next model in order. Whether that went well, [`finish`](Self::finish) says: models do not wait for it.
    pub(super) fn add(&self, record: &Record) {
        let Ok(mut summary) = self.summary.lock() else { return };
        if summary.broken.is_none() {
            summary.broken = summary.add(self.form, record).err();
        }
    }

    /// The summary is whole; the partial one is no longer needed.
    ///
    /// # Errors
    /// The summary could not be written. What is done stays in the partial one.
    pub(super) fn finish(self) -> Result<(), LibraryFault> {
        let summary = self.summary.into_inner().map_err(|_| LibraryFault::new("a thread ended early"))?;
        let written = summary.broken.map_or_else(|| summary.file.commit(), Err);
        written.map_err(|fault| {
            let mut message =
                phrase!["the summary is missing: make room for it, then go on with ", Input::Resume, ": "];
            message.push(fault.phrase());
            LibraryFault::new(message)
        })?;
        drop(self.partial);
        std::fs::remove_file(&self.partial_path)
            .context(|| format!("cannot remove {}", self.partial_path.display()))
    }
}
