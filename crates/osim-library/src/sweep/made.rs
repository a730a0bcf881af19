//! Files that sweeps into a folder made: what a resumed sweep may take for its own.
//!
//! They are in the tables of the last sweep that came to its end, and, name and digest alone, in `TABLE.partial`, which stays
//! until every variant is made. That a file is as it should be needs neither: its bytes say it.

use std::sync::{Mutex, OnceLock};

use osim_model::messages::{Input, phrase};

use super::known::{COLUMNS, Known};
use super::table_row::line;
use super::tables::Tables;
use crate::fault::LibraryFault;
use crate::folders::make_folder_of;
use crate::partial::Partial;

/// What was made, and the table that records it.
pub(super) struct MadeFiles<'t> {
    tables: &'t Tables<'t>,
    /// By the table of this run.
    known: Known,
    /// By tables of other runs.
    known_elsewhere: OnceLock<Result<Known, LibraryFault>>,
    partial: Mutex<Partial>,
}

impl<'t> MadeFiles<'t> {
    /// Begins the partial table of the run's table, with what is known if the sweep resumes.
    ///
    /// # Errors
    /// What is there is not the table of a sweep, or another one is being made.
    pub(super) fn begin(tables: &'t Tables<'t>, resume: bool) -> Result<Self, LibraryFault> {
        let mut known = Known::default();
        let mut only_in_table = Vec::new();
        if resume {
            known.add(tables.own(), |file, sha256| {
                only_in_table.extend(line(&[file.to_owned(), sha256.to_owned()])?);
                Ok(())
            })?;
        }
        let known_elsewhere = OnceLock::new();
        if resume && !tables.is_part() {
            // What another program made of tables of parts shows before anything is written.
            drop(known_elsewhere.set(Ok(known_by(tables)?)));
        }
        make_folder_of(tables.own())?;
        let way_out = phrase!["write into another folder with ", Input::OutputDir.like("DIR")];
        let mut partial = Partial::open(tables.own(), resume, &way_out)?;
        // The new table may get its name without the files that this sweep does not make: they stay known.
        if !only_in_table.is_empty() {
            add(&mut partial, &only_in_table)?;
        }
        Ok(Self { tables, known, known_elsewhere, partial: Mutex::new(partial) })
    }

    /// Whether a sweep made `file` with this digest.
    ///
    /// # Errors
    /// A table of another run is not that of a sweep.
    pub(super) fn knows(&self, file: &str, sha256: &str) -> Result<bool, LibraryFault> {
        Ok(self.known.has(file, sha256) || self.known_elsewhere()?.has(file, sha256))
    }

    /// A thousand jobs of one sweep would read a million tables: each reads those of others only where it finds a file that is not
    /// as it should be.
    fn known_elsewhere(&self) -> Result<&Known, LibraryFault> {
        self.known_elsewhere.get_or_init(|| known_by(self.tables)).as_ref().map_err(LibraryFault::clone)
    }

    /// Records that the file is about to be written with this digest, or has it.
    ///
    /// # Errors
    /// There is no room for its line.
    pub(super) fn about_to_finish(&self, file: &str, sha256: &str) -> Result<(), LibraryFault> {
        if self.known.has(file, sha256) {
            return Ok(());
        }
        let line = line(&[file.to_owned(), sha256.to_owned()])?;
        let mut partial = self.partial.lock().map_err(|_| ended_early())?;
        add(&mut partial, &line)
    }

    /// The sweep is at its end. The partial table stays where something is left to do, and so do tables of parts, which the whole
    /// one else replaces.
    ///
    /// # Errors
    /// The folder cannot be changed.
    pub(super) fn finish(self, all: bool) -> Result<(), LibraryFault> {
        let partial = self.partial.into_inner().map_err(|_| ended_early())?;
        if all {
            self.tables.remove_parts()?;
        }
        if all || partial.is_empty() { partial.remove() } else { Ok(()) }
    }
}

/// What tables of other runs have.
fn known_by(tables: &Tables<'_>) -> Result<Known, LibraryFault> {
    let mut known = Known::default();
    tables.others().try_for_each(|table| known.add(table, |_, _| Ok(())))?;
    Ok(known)
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

fn ended_early() -> LibraryFault {
    LibraryFault::new("a thread ended early")
}
