//! Names and digests of files, as tables of sweeps have them.

use std::collections::HashSet;
use std::io::{BufRead, BufReader, Read, Seek, SeekFrom};
use std::path::Path;

use osim_model::messages::{Input, phrase};
use osim_planning::{SweepPlan, from_cell};

use super::table_row::line;
use crate::digest::{self, NameDigest};
use crate::door;
use crate::fault::LibraryFault;
use crate::partial::{Partial, end_of_lines};

/// Columns of every table, and all of a partial one.
pub(super) const COLUMNS: [&str; 2] = ["file", "sha256"];

/// Files that sweeps made.
#[derive(Debug, Default)]
pub(super) struct Known(HashSet<NameDigest>);

impl Known {
    /// Adds what `table` and its partial table have; `only_in_table` is called for what is in the table alone.
    ///
    /// # Errors
    /// One of them is not the table of a sweep.
    pub(super) fn add(
        &mut self,
        table: &Path,
        mut only_in_table: impl FnMut(&str, &str) -> Result<(), LibraryFault>,
    ) -> Result<(), LibraryFault> {
        each(&Partial::path_of(table), true, |file, sha256| {
            self.0.insert(key(file, sha256));
            Ok(())
        })?;
        each(table, false, |file, sha256| match self.0.insert(key(file, sha256)) {
            true => only_in_table(file, sha256),
            false => Ok(()),
        })
    }

    /// Whether a sweep made `file` with this digest.
    pub(super) fn has(&self, file: &str, sha256: &str) -> bool {
        self.0.contains(&key(file, sha256))
    }
}

/// Whether `table` and its partial table, if they are there, are those of a sweep.
pub(super) fn is_of_sweep(table: &Path) -> bool {
    Known::default().add(table, |_, _| Ok(())).is_ok()
}

/// Equal for the same file with the same bytes.
fn key(file: &str, sha256: &str) -> NameDigest {
    // No name holds a slash.
    digest::of_name(format!("{sha256}/{file}").as_ref())
}

/// Calls `each` with file and digest of every line; never if there is no such table.
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

/// The error of another library.
fn said(error: impl std::fmt::Display) -> LibraryFault {
    LibraryFault::new(error.to_string())
}
