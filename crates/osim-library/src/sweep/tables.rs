//! The tables of one sweep, of the whole and of parts that several runs make at the same time; and what they say of files that sweeps made.

use std::collections::{BTreeSet, HashSet};
use std::io::{BufRead, BufReader, Read, Seek, SeekFrom};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, OnceLock};

use osim_model::messages::{Input, phrase};
use osim_planning::{SweepPlan, cell, from_cell};

use crate::digest::{self, NameDigest};
use crate::fault::{Context, LibraryFault, fault_of_error};
use crate::file_access;
use crate::folders::make_folder_of;
use crate::partial::{PartialFile, end_of_lines};

pub(super) struct Tables<'p> {
    folder: &'p Path,
    plan: &'p SweepPlan<'p>,
    whole: PathBuf,
    /// That of this run, where it makes a part.
    part: Option<PathBuf>,
    /// As they were when somebody first asked.
    parts: OnceLock<BTreeSet<PathBuf>>,
}

impl<'p> Tables<'p> {
    pub(super) fn new(folder: &'p Path, plan: &'p SweepPlan<'p>) -> Self {
        let part = plan.part_table_name().map(|name| folder.join(name));
        Self { folder, plan, whole: folder.join(plan.table_name()), part, parts: OnceLock::new() }
    }

    pub(super) fn own(&self) -> &Path {
        self.part.as_deref().unwrap_or(&self.whole)
    }

    /// Whether this run makes a part.
    pub(super) fn is_part(&self) -> bool {
        self.part.is_some()
    }

    /// Those that other runs write.
    pub(super) fn others(&self) -> impl Iterator<Item = &Path> {
        let whole = self.is_part().then_some(self.whole.as_path());
        let parts = self.parts().iter().map(PathBuf::as_path);
        whole.into_iter().chain(parts.filter(|part| *part != self.own()))
    }

    /// Tables of parts that the whole one replaces: empty if this run makes a part.
    pub(super) fn replaced(&self) -> impl Iterator<Item = &Path> {
        self.others().filter(|_| !self.is_part())
    }

    /// Tables of parts that are there, whole or partial.
    fn parts(&self) -> &BTreeSet<PathBuf> {
        self.parts.get_or_init(|| {
            let entries = std::fs::read_dir(self.folder).into_iter().flatten().flatten();
            let table = |name: &str| {
                let name = name.strip_suffix(PartialFile::ENDING).unwrap_or(name);
                self.plan.is_part_table_name(name).then(|| self.folder.join(name))
            };
            entries.filter_map(|entry| entry.file_name().to_str().and_then(table)).collect()
        })
    }

    /// The whole and a part of it are not made at the same time. Parts are.
    ///
    /// # Errors
    /// Another run is at it.
    pub(super) fn check_free(&self) -> Result<(), LibraryFault> {
        let way_out = phrase!["wait until that has ended"];
        if self.is_part() {
            return PartialFile::refuse_if_in_use(&self.whole, &way_out);
        }
        self.replaced().try_for_each(|part| PartialFile::refuse_if_in_use(part, &way_out))
    }

    /// The table of the whole has its name: those of parts that were there when this run began are no longer needed. What another
    /// program saved is not ours to remove.
    fn remove_parts(&self) -> Result<(), LibraryFault> {
        for part in self.replaced().filter(|part| is_of_sweep(part)) {
            let partial = PartialFile::path_for(part);
            for file in [part, &partial] {
                if file.exists() {
                    std::fs::remove_file(file).context(|| format!("cannot remove {}", file.display()))?;
                }
            }
        }
        Ok(())
    }
}

// Files that sweeps into a folder made: what a resumed sweep may take for its own.
//
// They are in the tables of the last sweep that came to its end, and, name and digest alone, in `TABLE.partial`, which stays
// until every variant is made. That a file is as it should be needs neither: its bytes say it.

pub(super) struct MadeFiles<'t> {
    tables: &'t Tables<'t>,
    /// By the table of this run.
    known: KnownFiles,
    /// By tables of other runs.
    known_elsewhere: OnceLock<Result<KnownFiles, LibraryFault>>,
    partial: Mutex<PartialFile>,
}

impl<'t> MadeFiles<'t> {
    /// Begins the partial table of the run's table, with what is known if the sweep resumes.
    ///
    /// # Errors
    /// What is there is not the table of a sweep, or another one is being made.
    pub(super) fn begin(tables: &'t Tables<'t>, resume: bool) -> Result<Self, LibraryFault> {
        let mut known = KnownFiles::default();
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
        let way_out = phrase!["write into another folder with ", Input::OutputDir.with_placeholder("DIR")];
        let mut partial = PartialFile::open(tables.own(), resume, &way_out)?;
        // The new table may get its name without the files that this sweep does not make: they stay known.
        if !only_in_table.is_empty() {
            add_lines(&mut partial, &only_in_table)?;
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
    fn known_elsewhere(&self) -> Result<&KnownFiles, LibraryFault> {
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
        add_lines(&mut partial, &line)
    }

    /// The sweep is at its end. The partial table stays where something is left to do, and so do tables of parts, which the whole
    /// one else replaces.
    pub(super) fn finish(self, all: bool) -> Result<(), LibraryFault> {
        let partial = self.partial.into_inner().map_err(|_| ended_early())?;
        if all {
            self.tables.remove_parts()?;
        }
        if all || partial.is_empty() { partial.remove() } else { Ok(()) }
    }
}

/// What tables of other runs have.
fn known_by(tables: &Tables<'_>) -> Result<KnownFiles, LibraryFault> {
    let mut known = KnownFiles::default();
    tables.others().try_for_each(|table| known.add(table, |_, _| Ok(())))?;
    Ok(known)
}

fn add_lines(partial: &mut PartialFile, lines: &[u8]) -> Result<(), LibraryFault> {
    let mut whole = Vec::new();
    if partial.is_empty() {
        whole = line(&COLUMNS.map(str::to_owned))?;
    }
    whole.extend_from_slice(lines);
    partial.add_lines(&whole)
}

fn ended_early() -> LibraryFault {
    LibraryFault::new("a thread ended early")
}

// Names and digests of files, as tables of sweeps have them.

/// Columns of every table, and all of a partial one.
const COLUMNS: [&str; 2] = ["file", "sha256"];

#[derive(Debug, Default)]
struct KnownFiles(HashSet<NameDigest>);

impl KnownFiles {
    /// Adds what `table` and its partial table have; `only_in_table` is called for what is in the table alone.
    ///
    /// # Errors
    /// One of them is not the table of a sweep.
    pub(super) fn add(
        &mut self,
        table: &Path,
        mut only_in_table: impl FnMut(&str, &str) -> Result<(), LibraryFault>,
    ) -> Result<(), LibraryFault> {
        each_line(&PartialFile::path_for(table), true, |file, sha256| {
            self.0.insert(key(file, sha256));
            Ok(())
        })?;
        each_line(table, false, |file, sha256| match self.0.insert(key(file, sha256)) {
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
fn is_of_sweep(table: &Path) -> bool {
    KnownFiles::default().add(table, |_, _| Ok(())).is_ok()
}

/// Equal for the same file with the same bytes.
fn key(file: &str, sha256: &str) -> NameDigest {
    // No name holds a slash.
    digest::digest_of_name(format!("{sha256}/{file}").as_ref())
}

/// Calls `each` with file and digest of every line; never if there is no such table.
fn each_line(
    path: &Path,
    may_be_cut: bool,
    each: impl FnMut(&str, &str) -> Result<(), LibraryFault>,
) -> Result<(), LibraryFault> {
    if !path.exists() {
        return Ok(());
    }
    read_lines(path, may_be_cut, each).map_err(|fault| {
        let mut message = phrase![format!("cannot go on with {}: ", path.display())];
        message.push(fault.phrase());
        message.push("; leave out ");
        message.push(Input::Resume);
        message.push(" and replace all with ");
        message.push(Input::Force);
        message.push(", or choose another folder with ");
        message.push(Input::OutputDir.with_placeholder("DIR"));
        LibraryFault::new(message)
    })
}

fn read_lines(
    path: &Path,
    may_be_cut: bool,
    mut each: impl FnMut(&str, &str) -> Result<(), LibraryFault>,
) -> Result<(), LibraryFault> {
    let (mut file, length) = file_access::open_to_read(path).map_err(fault_of_error)?;
    let end = end_of_lines(&mut file, length).map_err(fault_of_error)?;
    if end < length && !may_be_cut {
        return Err(LibraryFault::new("its last line is cut off, so this tool did not leave it like that"));
    }
    file.seek(SeekFrom::Start(0)).map_err(fault_of_error)?;
    let mut lines = BufReader::new(file).take(end);
    let mut first = Vec::new();
    if lines.read_until(b'\n', &mut first).map_err(fault_of_error)? == 0 && may_be_cut {
        // Killed before its first line was whole.
        return Ok(());
    }
    let (name, digest) = columns(&first)?;
    let mut reader = csv::ReaderBuilder::new().has_headers(false).from_reader(lines);
    let mut row = csv::StringRecord::new();
    while reader.read_record(&mut row).map_err(fault_of_error)? {
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
    let header = csv::Reader::from_reader(first).headers().map_err(fault_of_error)?.clone();
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

/// The cells as one line of CSV; no cell is a formula.
pub(super) fn line(cells: &[String]) -> Result<Vec<u8>, LibraryFault> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(cells.iter().map(|text| cell(text).into_owned())).map_err(fault_of_error)?;
    writer.into_inner().map_err(fault_of_error)
}
