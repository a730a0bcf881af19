//! `FILE.partial` has one line for each finished output of a run. It exists until `FILE` itself is complete.
//!
//! A line is written before its output file gets its final name. So every finished output has a line, even if the program is killed.

use std::ffi::OsString;
use std::fs::File;
use std::io::{ErrorKind, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

use osim_model::messages::{Input, Phrase, phrase};

use crate::fault::{Context, LibraryFault, Result, fault_of_error};
use crate::file_access;

/// A file of whole lines that only one run at a time may write.
#[derive(Debug)]
pub(crate) struct PartialFile {
    path: PathBuf,
    file: File,
    length: u64,
}

impl PartialFile {
    /// The ending of a partial file's name, after the name of the complete file.
    pub(crate) const ENDING: &'static str = ".partial";

    /// The path of the partial file that belongs to the file `whole`.
    pub(crate) fn path_for(whole: &Path) -> PathBuf {
        let mut name = OsString::from(whole.as_os_str());
        name.push(Self::ENDING);
        PathBuf::from(name)
    }

    /// Refuses to begin if a run that was stopped left a partial file.
    pub(crate) fn refuse_leftover(whole: &Path) -> Result<()> {
        let path = Self::path_for(whole);
        if !path.exists() {
            return Ok(());
        }
        Err(LibraryFault::new(phrase![
            "{} was left by a run that was stopped: continue it ({}), or start again ({})";
            path.display().to_string(), Input::Resume, Input::Force
        ]))
    }

    /// Refuses to begin if another run has the partial file of `whole` open.
    pub(crate) fn refuse_if_in_use(whole: &Path, way_out: &Phrase) -> Result<()> {
        let path = Self::path_for(whole);
        match file_access::is_open_exclusively(&path).context(|| format!("cannot read {}", path.display()))? {
            true => Err(fault_of_file_in_use(whole, way_out)),
            false => Ok(()),
        }
    }

    /// Opens the partial file of `whole` for this run alone. If the run resumes, whole lines are kept. `way_out` is the advice in the
    /// fault if another run has the file open.
    ///
    /// # Errors
    /// The partial file cannot be written, or another run has it open.
    pub(crate) fn open(whole: &Path, resume: bool, way_out: &Phrase) -> Result<Self> {
        let path = Self::path_for(whole);
        let cannot = || format!("cannot write {}", path.display());
        let opened = file_access::open_exclusively(&path).map_err(|error| match error.kind() {
            // The message already says that this is not an ordinary file.
            ErrorKind::Other => LibraryFault::new(format!("{}: {error}", cannot())),
            _ => LibraryFault::system(cannot(), file_access::reason(&error)),
        })?;
        let mut file = opened.ok_or_else(|| fault_of_file_in_use(whole, way_out))?;
        // A line that was cut off when the run was killed must not run into the next one.
        let length = if resume { file.metadata().context(cannot)?.len() } else { 0 };
        let kept = end_of_lines(&mut file, length).context(cannot)?;
        truncate_to(&mut file, kept).context(cannot)?;
        Ok(Self { file, length: kept, path })
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.length == 0
    }

    /// Adds whole lines.
    ///
    /// # Errors
    /// The disk is full. No part of the lines is in the file then.
    pub(crate) fn add_lines(&mut self, lines: &[u8]) -> Result<()> {
        let cannot = || format!("cannot write {}", self.path.display());
        if let Err(error) = self.file.write_all(lines) {
            // A part of the line may have been written: the next line would run into it.
            truncate_to(&mut self.file, self.length).context(cannot)?;
            return Err(error).context(cannot);
        }
        self.length += lines.len() as u64;
        Ok(())
    }

    /// Removes the file, after the complete file was written.
    pub(crate) fn remove(self) -> Result<()> {
        let Self { path, file, .. } = self;
        // While the file is open, no other run begins with a file that is about to be removed. Windows cannot remove an open file.
        let open = cfg!(unix).then_some(file);
        let removed = std::fs::remove_file(&path);
        drop(open);
        match removed {
            Err(error) if error.kind() == ErrorKind::NotFound => Ok(()),
            removed => removed.context(|| format!("cannot remove {}", path.display())),
        }
    }
}

/// The fault that another run is writing the file.
fn fault_of_file_in_use(whole: &Path, way_out: &Phrase) -> LibraryFault {
    LibraryFault::busy(phrase![format!("{} is being written by another run: ", whole.display()), way_out])
}

/// Shortens the file to `length` bytes and goes to its end.
fn truncate_to(file: &mut File, length: u64) -> std::io::Result<()> {
    file.set_len(length)?;
    file.seek(SeekFrom::Start(length)).map(|_| ())
}

/// Opens a file of lines to read it. Returns also the length of its whole lines.
///
/// # Errors
/// The file cannot be read, or its last line is incomplete although `may_be_cut` is false.
pub(crate) fn open_lines(path: &Path, may_be_cut: bool) -> Result<(File, u64)> {
    let (mut file, length) = file_access::open_to_read(path).map_err(fault_of_error)?;
    let end = end_of_lines(&mut file, length).map_err(fault_of_error)?;
    if end < length && !may_be_cut {
        return Err(LibraryFault::new("its last line is cut off, so this tool did not leave it like that"));
    }
    Ok((file, end))
}

/// The length of the whole lines in the first `length` bytes of a file.
fn end_of_lines(file: &mut File, length: u64) -> std::io::Result<u64> {
    const READ_BLOCK_BYTES: u64 = 1 << 16;
    let mut end = length;
    while end > 0 {
        let start = end.saturating_sub(READ_BLOCK_BYTES);
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

    /// A resumed run reads the file by one handle while it writes by another.
    #[test]
    fn one_run_appends_after_whole_lines_while_others_may_read() {
        let folder = tempfile::tempdir().unwrap();
        let whole = folder.path().join("summary.csv");
        let partial = PartialFile::path_for(&whole);
        std::fs::write(&partial, "one\ntwo\nthr").unwrap();
        let (mut earlier, _) = file_access::open_to_read(&partial).unwrap();
        let mut open = PartialFile::open(&whole, true, &"wait".into()).unwrap();
        let other = PartialFile::open(&whole, true, &"wait".into()).unwrap_err().to_string();
        assert!(other.ends_with("is being written by another run: wait"), "{other}");
        open.add_lines(b"three\n").unwrap();
        assert_eq!(std::fs::read_to_string(&partial).unwrap(), "one\ntwo\nthree\n");
        let mut line = [0; 4];
        earlier.read_exact(&mut line).unwrap();
        assert_eq!(&line, b"one\n");
        drop(earlier);
        open.remove().unwrap();
        assert!(!partial.exists());
        let mut anew = PartialFile::open(&whole, false, &"wait".into()).unwrap();
        anew.add_lines(b"new\n").unwrap();
        drop(anew);
        drop(PartialFile::open(&whole, false, &"wait".into()).unwrap());
        assert_eq!(std::fs::read(&partial).unwrap(), b"");
    }
}
