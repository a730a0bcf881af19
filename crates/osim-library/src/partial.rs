//! `FILE.partial`: what a run has done so far, one line each, while `FILE` itself is not whole.
//!
//! A line is there before its output takes its name. Whenever the program is killed, every finished output therefore has
//! its line.

use std::ffi::OsString;
use std::fs::File;
use std::io::{ErrorKind, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

use osim_model::messages::{Input, Phrase, phrase};

use crate::door;
use crate::fault::{Context, LibraryFault};

/// Whole lines only. While it is open, no other run opens it.
#[derive(Debug)]
pub(crate) struct Partial {
    path: PathBuf,
    file: File,
    length: u64,
}

impl Partial {
    /// What its name has after that of the whole file.
    pub(crate) const ENDING: &'static str = ".partial";

    pub(crate) fn path_of(whole: &Path) -> PathBuf {
        let mut name = OsString::from(whole.as_os_str());
        name.push(Self::ENDING);
        PathBuf::from(name)
    }

    /// Refuses to begin where a run that was stopped left one.
    ///
    /// # Errors
    /// It is there.
    pub(crate) fn check_none_left(whole: &Path) -> Result<(), LibraryFault> {
        let path = Self::path_of(whole);
        if !path.exists() {
            return Ok(());
        }
        Err(LibraryFault::new(phrase![
            format!("{} was left by a run that was stopped: go on with it (", path.display()),
            Input::Resume,
            "), or start again (",
            Input::Force,
            ")",
        ]))
    }

    /// Refuses to begin where another run has that of `whole`. Several runs may ask at the same time.
    ///
    /// # Errors
    /// It has it, or that cannot be found out.
    pub(crate) fn check_free(whole: &Path, way_out: &Phrase) -> Result<(), LibraryFault> {
        let path = Self::path_of(whole);
        match door::is_taken(&path).context(|| format!("cannot read {}", path.display()))? {
            true => Err(being_written(whole, way_out)),
            false => Ok(()),
        }
    }

    /// Opens that of `whole` for this run alone, with the whole lines that are there if the run continues them. `way_out` is what
    /// to do if another run has it.
    ///
    /// # Errors
    /// It cannot be written, or another run has it.
    pub(crate) fn open(whole: &Path, resume: bool, way_out: &Phrase) -> Result<Self, LibraryFault> {
        let path = Self::path_of(whole);
        let cannot = || format!("cannot write {}", path.display());
        let opened = door::alone(&path).map_err(|error| match error.kind() {
            // The call names what is no file.
            ErrorKind::Other => LibraryFault::new(format!("{}: {error}", cannot())),
            _ => LibraryFault::because(cannot(), door::reason(&error)),
        })?;
        let Some(mut file) = opened else {
            return Err(being_written(whole, way_out));
        };
        // A line cut off when the run was killed must not run into the next one.
        let kept = if resume { whole_lines(&mut file).context(cannot)? } else { 0 };
        cut(&mut file, kept).context(cannot)?;
        Ok(Self { file, length: kept, path })
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.length == 0
    }

    /// Adds whole lines.
    ///
    /// # Errors
    /// The disk is full; then nothing of them is there.
    pub(crate) fn add(&mut self, lines: &[u8]) -> Result<(), LibraryFault> {
        let cannot = || format!("cannot write {}", self.path.display());
        if let Err(error) = self.file.write_all(lines) {
            // On a full disk a part of the line may be there: the next one would run into it.
            cut(&mut self.file, self.length).context(cannot)?;
            return Err(error).context(cannot);
        }
        self.length += lines.len() as u64;
        Ok(())
    }

    /// Removes it, once the whole file is there.
    pub(crate) fn remove(self) -> Result<(), LibraryFault> {
        let Self { path, file, .. } = self;
        drop(file);
        std::fs::remove_file(&path).context(|| format!("cannot remove {}", path.display()))
    }
}

fn being_written(whole: &Path, way_out: &Phrase) -> LibraryFault {
    let mut message = phrase![format!("{} is being written by another run: ", whole.display())];
    message.push(way_out);
    LibraryFault::busy(message)
}

/// The length of what was written to its end.
fn whole_lines(file: &mut File) -> std::io::Result<u64> {
    let length = file.metadata()?.len();
    end_of_lines(file, length)
}

/// Cuts the file to `length` bytes: the next line comes after them.
fn cut(file: &mut File, length: u64) -> std::io::Result<()> {
    file.set_len(length)?;
    file.seek(SeekFrom::Start(length)).map(|_| ())
}

/// Where the last whole line ends.
pub(crate) fn end_of_lines(file: &mut File, length: u64) -> std::io::Result<u64> {
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

#[cfg(test)]
mod tests {
    use super::*;

    /// Also while another handle of this process reads it, as a run does that goes on.
    #[test]
    fn one_run_at_a_time_writes_after_the_whole_lines_and_all_may_read() {
        let folder = tempfile::tempdir().unwrap();
        let whole = folder.path().join("summary.csv");
        let partial = Partial::path_of(&whole);
        std::fs::write(&partial, "one\ntwo\nthr").unwrap();
        let (mut earlier, _) = door::to_read(&partial).unwrap();
        let mut open = Partial::open(&whole, true, &"wait".into()).unwrap();
        let other = Partial::open(&whole, true, &"wait".into()).unwrap_err().to_string();
        assert!(other.ends_with("is being written by another run: wait"), "{other}");
        open.add(b"three\n").unwrap();
        assert_eq!(std::fs::read_to_string(&partial).unwrap(), "one\ntwo\nthree\n");
        let mut line = [0; 4];
        earlier.read_exact(&mut line).unwrap();
        assert_eq!(&line, b"one\n");
        drop(earlier);
        open.remove().unwrap();
        assert!(!partial.exists());
        let mut anew = Partial::open(&whole, false, &"wait".into()).unwrap();
        anew.add(b"new\n").unwrap();
        drop(anew);
        drop(Partial::open(&whole, false, &"wait".into()).unwrap());
        assert_eq!(std::fs::read(&partial).unwrap(), b"");
    }
}
