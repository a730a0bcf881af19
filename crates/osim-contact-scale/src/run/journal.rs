//! `--summary FILE`: one line per model, in order; and while the run lasts, `FILE.partial` in the order of the work.
//!
//! A line of the partial file is written before its output takes its name. Whenever the program is killed, every
//! finished output therefore has its line, and `--resume` compares what the line says with what is there.

use std::ffi::OsString;
use std::fs::{File, OpenOptions};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::Mutex;

use anyhow::{Context, Result, anyhow, bail};

use super::record::Record;
use crate::args::RunArgs;
use crate::folders;
use crate::write::{Mode, Prepared};

/// How a summary is written, by the ending of its name.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Form {
    Csv,
    Ndjson,
}

impl Form {
    pub(super) fn of(path: &Path) -> Result<Self> {
        match path.extension().map(std::ffi::OsStr::to_ascii_lowercase) {
            Some(extension) if extension == "csv" => Ok(Self::Csv),
            Some(extension) if extension == "ndjson" || extension == "jsonl" => Ok(Self::Ndjson),
            _ => bail!("--summary {}: expected a name that ends in .csv or .ndjson", path.display()),
        }
    }

    /// Records, one per line.
    ///
    /// # Errors
    /// The lines hold something else; also where a table has another header and not one line.
    pub(super) fn read(self, lines: &[u8]) -> Result<Vec<Record>> {
        if self == Self::Ndjson {
            let lines = lines.split(|&byte| byte == b'\n').filter(|line| !line.is_empty());
            return Ok(lines.map(serde_json::from_slice).collect::<Result<_, _>>()?);
        }
        let mut reader = csv::Reader::from_reader(lines);
        if !lines.is_empty() && !reader.headers()?.iter().any(|column| column == "sha256_output") {
            bail!("there is no column 'sha256_output'");
        }
        Ok(reader.deserialize().collect::<Result<_, _>>()?)
    }

    /// One record and a line end; `first` with the header.
    fn line(self, record: &Record, first: bool) -> Result<Vec<u8>> {
        if self == Self::Ndjson {
            return Ok(crate::report::json::line(record).into_bytes());
        }
        let mut csv = csv::WriterBuilder::new().has_headers(first).from_writer(Vec::new());
        csv.serialize(record)?;
        csv.into_inner().map_err(|error| anyhow!(error.to_string()))
    }
}

/// The file that lasts as long as the run.
pub(super) fn partial(path: &Path) -> PathBuf {
    let mut name = OsString::from(path.as_os_str());
    name.push(".partial");
    PathBuf::from(name)
}

/// What was written to its end.
pub(super) fn whole_lines(bytes: &[u8]) -> &[u8] {
    let end = bytes.iter().rposition(|&byte| byte == b'\n').map_or(0, |at| at + 1);
    bytes.get(..end).unwrap_or_default()
}

/// A summary that is being written.
pub(super) struct Journal {
    form: Form,
    /// In the order of the work.
    partial: Mutex<Partial>,
    partial_path: PathBuf,
    /// In the order of the models.
    summary: Mutex<Summary>,
}

struct Summary {
    file: Prepared,
    first: bool,
    /// Why it is not whole; then no more is added.
    broken: Option<anyhow::Error>,
}

impl Summary {
    fn add(&mut self, form: Form, record: &Record) -> Result<()> {
        let line = form.line(record, self.first)?;
        self.first = false;
        self.file.add(&line)
    }
}

/// Whole lines only.
struct Partial {
    file: File,
    length: u64,
}

impl Partial {
    /// Opens the file for this run alone, with the whole lines that are there if it goes on with them.
    fn open(path: &Path, summary: &Path, resume: bool) -> Result<Self> {
        let cannot = || format!("cannot write {}", path.display());
        let file = OpenOptions::new().create(true).append(true).open(path).with_context(cannot)?;
        if file.try_lock().is_err_and(|error| matches!(error, std::fs::TryLockError::WouldBlock)) {
            bail!(
                "{} is being written by another run: give each run a summary of its own",
                summary.display()
            );
        }
        // A line cut off when the run was killed must not run into the next one.
        let kept =
            if resume { whole_lines(&std::fs::read(path).with_context(cannot)?).len() as u64 } else { 0 };
        file.set_len(kept).with_context(cannot)?;
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
    /// A summary of that name is there, and neither `--resume` nor `--force` says what to do with it; or another
    /// run is writing it.
    pub(super) fn begin(args: &RunArgs, force: bool) -> Result<Option<Self>> {
        let Some(path) = &args.summary else { return Ok(None) };
        let form = Form::of(path)?;
        let partial_path = partial(path);
        folders::make(path)?;
        let replace = args.resume || force;
        if !replace && path.exists() {
            bail!(
                "{} exists already: go on with it (--resume), replace it (--force), or choose another name",
                path.display()
            );
        }
        if !replace && partial_path.exists() {
            bail!(
                "{} was left by a run that was stopped: go on with it (--resume), or begin anew (--force)",
                partial_path.display()
            );
        }
        let mode = if replace { Mode::Replace } else { Mode::New };
        let summary = Summary { file: Prepared::begin(path, None, mode)?, first: true, broken: None };
        let partial = Mutex::new(Partial::open(&partial_path, path, args.resume)?);
        Ok(Some(Self { form, partial, partial_path, summary: Mutex::new(summary) }))
    }

    /// An output is complete and about to take its name.
    pub(super) fn about_to_finish(&self, record: &Record) -> Result<()> {
        let mut partial = self.partial.lock().map_err(|_| anyhow!("a thread ended early"))?;
        let line = self.form.line(record, partial.length == 0)?;
        partial.add(&line).with_context(|| format!("cannot write {}", self.partial_path.display()))
    }

    /// The next model in order. Whether that went well, [`finish`](Self::finish) says: models do not wait for it.
    pub(super) fn tell(&self, record: &Record) {
        let Ok(mut summary) = self.summary.lock() else { return };
        if summary.broken.is_none() {
            summary.broken = summary.add(self.form, record).err();
        }
    }

    /// The summary is whole; the partial one is no longer needed.
    ///
    /// # Errors
    /// The summary could not be written. What is done stays in the partial one.
    pub(super) fn finish(self) -> Result<()> {
        let summary = self.summary.into_inner().map_err(|_| anyhow!("a thread ended early"))?;
        let written = summary.broken.map_or_else(|| summary.file.commit(), Err);
        written.context("the summary is missing: make room for it, then go on with --resume")?;
        drop(self.partial);
        std::fs::remove_file(&self.partial_path)
            .with_context(|| format!("cannot remove {}", self.partial_path.display()))
    }
}
