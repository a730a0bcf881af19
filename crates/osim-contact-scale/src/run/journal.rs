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
    summary: Mutex<(Prepared, bool)>,
}

struct Partial {
    file: File,
    first: bool,
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
        let mut options = OpenOptions::new();
        options.create(true).append(true);
        let cannot = || format!("cannot write {}", partial_path.display());
        let file = options.open(&partial_path).with_context(cannot)?;
        if file.try_lock().is_err_and(|error| matches!(error, std::fs::TryLockError::WouldBlock)) {
            bail!("{} is being written by another run: give each run a summary of its own", path.display());
        }
        if !args.resume {
            file.set_len(0).with_context(cannot)?;
        } else {
            // A line cut off when the run was killed must not run into the next one.
            let bytes = std::fs::read(&partial_path).with_context(cannot)?;
            file.set_len(whole_lines(&bytes).len() as u64).with_context(cannot)?;
        }
        let first = file.metadata().with_context(cannot)?.len() == 0;
        let mode = if replace { Mode::Replace } else { Mode::New };
        let summary = Mutex::new((Prepared::begin(path, None, mode)?, true));
        let partial = Mutex::new(Partial { file, first });
        Ok(Some(Self { form, partial, partial_path, summary }))
    }

    /// An output is complete and about to take its name.
    pub(super) fn about_to_finish(&self, record: &Record) -> Result<()> {
        let mut partial = self.partial.lock().map_err(|_| anyhow!("a thread ended early"))?;
        let line = self.form.line(record, partial.first)?;
        partial.first = false;
        partial.file.write_all(&line).with_context(|| format!("cannot write {}", self.partial_path.display()))
    }

    /// The next model in order.
    pub(super) fn tell(&self, record: &Record) -> Result<()> {
        let mut summary = self.summary.lock().map_err(|_| anyhow!("a thread ended early"))?;
        let line = self.form.line(record, summary.1)?;
        summary.1 = false;
        summary.0.add(&line)
    }

    /// The summary is whole; the partial one is no longer needed.
    pub(super) fn finish(self) -> Result<()> {
        let (summary, _) = self.summary.into_inner().map_err(|_| anyhow!("a thread ended early"))?;
        summary.commit()?;
        drop(self.partial);
        std::fs::remove_file(&self.partial_path)
            .with_context(|| format!("cannot remove {}", self.partial_path.display()))
    }
}
