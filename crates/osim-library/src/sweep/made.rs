//! Files that sweeps into a folder made: what a sweep that goes on may take for its own.
//!
//! They are in the table of the last sweep that came to its end, and, name and digest alone, in `TABLE.partial`, which stays
//! until every variant is made. That a file is as it should be needs neither: its bytes say it.

use std::collections::HashSet;
use std::io::{BufRead, BufReader, Read, Seek, SeekFrom};
use std::path::Path;
use std::sync::Mutex;

use osim_model::wording::{Input, phrase};
use osim_requests::{SweepPlan, from_cell};

use super::table_row::line;
use crate::digest::{self, NameDigest};
use crate::door;
use crate::fault::LibraryFault;
use crate::folders::make_folder_of;
use crate::partial::{Partial, end_of_lines};

/// Columns of the table, and all of the partial one.
const COLUMNS: [&str; 2] = ["file", "sha256"];

/// What was made, and where that is written down.
pub(super) struct MadeFiles {
    /// Names and digests of earlier sweeps' files.
    known: HashSet<NameDigest>,
    partial: Mutex<Partial>,
}

impl MadeFiles {
    /// Begins the partial table of `manifest`, with what is known if the sweep goes on.
    ///
    /// # Errors
    /// What is there is not the table of a sweep, or another one is being made.
    pub(super) fn begin(manifest: &Path, resume: bool) -> Result<Self, LibraryFault> {
        let mut known = HashSet::new();
        let mut only_in_table = Vec::new();
        if resume {
            each(&Partial::path_of(manifest), true, |file, sha256| {
                known.insert(key(file, sha256));
                Ok(())
            })?;
            each(manifest, false, |file, sha256| {
                if known.insert(key(file, sha256)) {
                    only_in_table.extend(line(&[file.to_owned(), sha256.to_owned()])?);
                }
                Ok(())
            })?;
        }
        make_folder_of(manifest)?;
        let way_out = phrase!["write into another folder with ", Input::OutputDir.like("DIR")];
        let mut partial = Partial::open(manifest, resume, &way_out)?;
        // The new table may get its name without the files of which this sweep makes nothing: they stay known.
        if !only_in_table.is_empty() {
            add(&mut partial, &only_in_table)?;
        }
        Ok(Self { known, partial: Mutex::new(partial) })
    }

    /// Whether a sweep made `file` with this digest.
    pub(super) fn knows(&self, file: &str, sha256: &str) -> bool {
        self.known.contains(&key(file, sha256))
    }

    /// The file is complete and about to take its name, or has it.
    ///
    /// # Errors
    /// There is no room for its line.
    pub(super) fn about_to_finish(&self, file: &str, sha256: &str) -> Result<(), LibraryFault> {
        if self.knows(file, sha256) {
            return Ok(());
        }
        let line = line(&[file.to_owned(), sha256.to_owned()])?;
        let mut partial = self.partial.lock().map_err(|_| ended_early())?;
        add(&mut partial, &line)
    }

    /// The sweep is at its end. The partial table stays where something is left to do.
    ///
    /// # Errors
    /// The folder cannot be changed.
    pub(super) fn finish(self, all: bool) -> Result<(), LibraryFault> {
        let partial = self.partial.into_inner().map_err(|_| ended_early())?;
        if all || partial.is_empty() { partial.remove() } else { Ok(()) }
    }
}

/// Adds lines, after the header.
fn add(partial: &mut Partial, lines: &[u8]) -> Result<(), LibraryFault> {
    let mut whole = Vec::new();
    if partial.is_empty() {
        whole = line(&COLUMNS.map(str::to_owned))?;
    }
    whole.extend_from_slice(lines);
    partial.add(&whole)
}

/// Equal for the same file with the same bytes.
fn key(file: &str, sha256: &str) -> NameDigest {
    // No name holds a slash.
    digest::of_name(format!("{sha256}/{file}").as_ref())
}

/// Calls `each` with file and digest of every line; of none where no such table is there.
fn each(
    path: &Path,
    may_be_cut: bool,
    each: impl FnMut(&str, &str) -> Result<(), LibraryFault>,
) -> Result<(), LibraryFault> {
    if !path.exists() {
        return Ok(());
    }
    read(path, may_be_cut, each).map_err(|fault| {
        let mut message = phrase![format!("cannot go on with {}: ", path.display())];
        message.push(fault.phrase());
        message.push("; leave out ");
        message.push(Input::Resume);
        message.push(" and replace all with ");
        message.push(Input::Force);
        message.push(", or choose another folder with ");
        message.push(Input::OutputDir.like("DIR"));
        LibraryFault::new(message)
    })
}

fn read(
    path: &Path,
    may_be_cut: bool,
    mut each: impl FnMut(&str, &str) -> Result<(), LibraryFault>,
) -> Result<(), LibraryFault> {
    let (mut file, length) = door::to_read(path).map_err(said)?;
    let end = end_of_lines(&mut file, length).map_err(said)?;
    if end < length && !may_be_cut {
        return Err(LibraryFault::new("its last line is cut off, so this tool did not leave it like that"));
    }
    file.seek(SeekFrom::Start(0)).map_err(said)?;
    let mut lines = BufReader::new(file).take(end);
    let mut first = Vec::new();
    if lines.read_until(b'\n', &mut first).map_err(said)? == 0 && may_be_cut {
        // Killed before its first line was whole.
        return Ok(());
    }
    let (name, digest) = columns(&first)?;
    let mut reader = csv::ReaderBuilder::new().has_headers(false).from_reader(lines);
    let mut row = csv::StringRecord::new();
    while reader.read_record(&mut row).map_err(said)? {
        let cell = |at: usize| from_cell(row.get(at).unwrap_or_default());
        each(&cell(name), &cell(digest))?;
    }
    Ok(())
}

/// Where file and digest are in the rows below `first`.
///
/// # Errors
/// It is not, byte for byte, the first line of a table of ours: another program saved it, perhaps with columns of the user's, which the
/// new table would not have.
fn columns(first: &[u8]) -> Result<(usize, usize), LibraryFault> {
    let header = csv::Reader::from_reader(first).headers().map_err(said)?.clone();
    let columns: Vec<String> = header.iter().map(str::to_owned).collect();
    let is_ours = (columns == COLUMNS || SweepPlan::is_table_header(&columns)) && line(&columns)? == first;
    let [name, digest] = COLUMNS.map(|column| columns.iter().position(|cell| cell == column));
    match (name, digest) {
        (Some(name), Some(digest)) if is_ours => Ok((name, digest)),
        _ => Err(LibraryFault::new(
            "this is not the table of a sweep, or another program saved it: its first line differs",
        )),
    }
}

/// What another library says.
fn said(error: impl std::fmt::Display) -> LibraryFault {
    LibraryFault::new(error.to_string())
}

fn ended_early() -> LibraryFault {
    LibraryFault::new("a thread ended early")
}
