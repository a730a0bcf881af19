//! The tables of a sweep: one table of all variants, or one for each run that makes a part of them; and the files in the tables.

use std::collections::{BTreeSet, HashSet};
use std::io::{BufRead, BufReader, Read, Seek, SeekFrom};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, OnceLock};

use osim_model::messages::{Input, phrase};
use osim_planning::{SweepPlan, cell, from_cell};

use crate::fault::{Context, LibraryFault, Result, fault_of_error, fault_of_panic};
use crate::file_access::{NameDigest, digest_of_name};
use crate::partial::{PartialFile, open_lines};
use crate::paths::make_folder_of;

/// The tables of a sweep in the folder of its variants: of all variants, and of parts that other runs make.
pub(super) struct SweepTables<'p> {
    folder: &'p Path,
    plan: &'p SweepPlan<'p>,
    whole: PathBuf,
    /// The table of this run, if the run makes only a part of the variants.
    part: Option<PathBuf>,
    /// Tables of runs that make a part of the variants, listed when they are first needed.
    parts: OnceLock<BTreeSet<PathBuf>>,
}

impl<'p> SweepTables<'p> {
    /// The paths of the tables of `plan` in `folder`. No file is opened yet.
    pub(super) fn new(folder: &'p Path, plan: &'p SweepPlan<'p>) -> Self {
        let part = plan.part_table_name().map(|name| folder.join(name));
        Self { folder, plan, whole: folder.join(plan.table_name()), part, parts: OnceLock::new() }
    }

    /// The table that this run writes.
    pub(super) fn table_of_run(&self) -> &Path {
        self.part.as_deref().unwrap_or(&self.whole)
    }

    /// Whether this run makes only some of the variants.
    pub(super) fn is_part(&self) -> bool {
        self.part.is_some()
    }

    /// Tables of the folder that other runs of the same sweep write.
    pub(super) fn tables_of_others(&self) -> impl Iterator<Item = &Path> {
        let whole = self.is_part().then_some(self.whole.as_path());
        let parts = self.tables_of_parts().iter().map(PathBuf::as_path);
        whole.into_iter().chain(parts.filter(|part| *part != self.table_of_run()))
    }

    /// Tables of parts of the sweep that the table of all variants replaces; none if this run makes only a part.
    pub(super) fn replaced_tables(&self) -> impl Iterator<Item = &Path> {
        self.tables_of_others().filter(|_| !self.is_part())
    }

    /// Existing tables of runs that made a part of the variants, complete or partial.
    fn tables_of_parts(&self) -> &BTreeSet<PathBuf> {
        self.parts.get_or_init(|| {
            let entries = std::fs::read_dir(self.folder).into_iter().flatten().flatten();
            let table = |name: &str| {
                let name = name.strip_suffix(PartialFile::ENDING).unwrap_or(name);
                self.plan.is_part_table_name(name).then(|| self.folder.join(name))
            };
            entries.filter_map(|entry| entry.file_name().to_str().and_then(table)).collect()
        })
    }

    /// Refuses to make all variants while another run makes a part, or a part while another run makes all.
    ///
    /// # Errors
    /// Another run is writing a table that excludes this run.
    pub(super) fn refuse_if_in_use(&self) -> Result<()> {
        let way_out = phrase!["wait until that has ended"];
        if self.is_part() {
            return PartialFile::refuse_if_in_use(&self.whole, &way_out);
        }
        self.replaced_tables().try_for_each(|part| PartialFile::refuse_if_in_use(part, &way_out))
    }

    /// Removes the tables of parts after the table of all variants was written, except tables that another program saved.
    fn remove_parts(&self) -> Result<()> {
        let is_of_sweep = |part: &&Path| FileDigests::default().add(part, |_, _| Ok(())).is_ok();
        for part in self.replaced_tables().filter(is_of_sweep) {
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

/// The files that runs of a sweep wrote, by the tables that list them.
pub(super) struct WrittenFiles<'t> {
    tables: &'t SweepTables<'t>,
    /// Files in the table of this run.
    files_of_run: FileDigests,
    /// Files in the tables of other runs, read when they are first needed.
    files_of_others: OnceLock<Result<FileDigests>>,
    partial: Mutex<PartialFile>,
}

impl<'t> WrittenFiles<'t> {
    /// Begins the partial table of this run. If the sweep resumes, reads from the tables which files earlier runs wrote.
    ///
    /// # Errors
    /// An existing file is not the table of a sweep, or another run is writing it.
    pub(super) fn begin(tables: &'t SweepTables<'t>, resume: bool) -> Result<Self> {
        let mut files_of_run = FileDigests::default();
        let mut only_in_table = Vec::new();
        if resume {
            files_of_run.add(tables.table_of_run(), |file, sha256| {
                only_in_table.extend(csv_line(&[file.to_owned(), sha256.to_owned()])?);
                Ok(())
            })?;
        }
        let files_of_others = OnceLock::new();
        if resume && !tables.is_part() {
            // Tables of parts that another program changed are refused before anything is written.
            drop(files_of_others.set(Ok(read_tables_of_others(tables)?)));
        }
        make_folder_of(tables.table_of_run())?;
        let way_out = phrase!["write into another folder with ", Input::OutputDir.with_placeholder("DIR")];
        let mut partial = PartialFile::open(tables.table_of_run(), resume, &way_out)?;
        // Files that this sweep does not make are not in its new table; the partial table keeps them.
        if !only_in_table.is_empty() {
            add_partial_lines(&mut partial, &only_in_table)?;
        }
        Ok(Self { tables, files_of_run, files_of_others, partial: Mutex::new(partial) })
    }

    /// Whether a sweep wrote `file` with this digest.
    ///
    /// # Errors
    /// A table of another run is not the table of a sweep.
    pub(super) fn was_written(&self, file: &str, sha256: &str) -> Result<bool> {
        Ok(self.files_of_run.contains(file, sha256) || self.files_of_others()?.contains(file, sha256))
    }

    /// Files in the tables of other runs. The tables are read only if an existing file differs: otherwise a thousand jobs would read
    /// a million tables.
    fn files_of_others(&self) -> Result<&FileDigests> {
        self.files_of_others
            .get_or_init(|| read_tables_of_others(self.tables))
            .as_ref()
            .map_err(LibraryFault::clone)
    }

    /// Adds the line of a file that is about to be written with the digest `sha256`, or has this digest already.
    ///
    /// # Errors
    /// The line cannot be written.
    pub(super) fn about_to_finish(&self, file: &str, sha256: &str) -> Result<()> {
        if self.files_of_run.contains(file, sha256) {
            return Ok(());
        }
        let line = csv_line(&[file.to_owned(), sha256.to_owned()])?;
        let mut partial = self.partial.lock().map_err(|_| fault_of_panic())?;
        add_partial_lines(&mut partial, &line)
    }

    /// Ends the sweep. If `all` variants are made, removes the partial table and the tables of parts.
    pub(super) fn finish(self, all: bool) -> Result<()> {
        let partial = self.partial.into_inner().map_err(|_| fault_of_panic())?;
        if all {
            self.tables.remove_parts()?;
        }
        if all || partial.is_empty() { partial.remove() } else { Ok(()) }
    }
}

/// Reads which files other runs of the sweep wrote.
fn read_tables_of_others(tables: &SweepTables<'_>) -> Result<FileDigests> {
    let mut files_of_run = FileDigests::default();
    tables.tables_of_others().try_for_each(|table| files_of_run.add(table, |_, _| Ok(())))?;
    Ok(files_of_run)
}

/// Adds lines to a partial table, before the first line its header.
fn add_partial_lines(partial: &mut PartialFile, lines: &[u8]) -> Result<()> {
    let mut whole = Vec::new();
    if partial.is_empty() {
        whole = csv_line(&FILE_COLUMNS.map(str::to_owned))?;
    }
    whole.extend_from_slice(lines);
    partial.add_lines(&whole)
}

// Names and digests of files, as tables of sweeps have them.

/// Columns that every table of a sweep has; a partial table has only these.
const FILE_COLUMNS: [&str; 2] = ["file", "sha256"];

/// Names and digests of files that sweeps wrote.
#[derive(Debug, Default)]
struct FileDigests(HashSet<NameDigest>);

impl FileDigests {
    /// Adds the files of `table` and of its partial table. Calls `only_in_table` for each file that the partial table does not have.
    ///
    /// # Errors
    /// The file `table` or its partial table is not the table of a sweep.
    fn add(&mut self, table: &Path, mut only_in_table: impl FnMut(&str, &str) -> Result<()>) -> Result<()> {
        for_each_line(&PartialFile::path_for(table), true, |file, sha256| {
            self.0.insert(digest_of_file(file, sha256));
            Ok(())
        })?;
        for_each_line(table, false, |file, sha256| match self.0.insert(digest_of_file(file, sha256)) {
            true => only_in_table(file, sha256),
            false => Ok(()),
        })
    }

    /// Whether a sweep wrote a file of this name with this digest.
    fn contains(&self, file: &str, sha256: &str) -> bool {
        self.0.contains(&digest_of_file(file, sha256))
    }
}

/// A digest of a file's name and the digest of its bytes.
fn digest_of_file(file: &str, sha256: &str) -> NameDigest {
    // No name has a slash.
    digest_of_name(format!("{sha256}/{file}").as_ref())
}

/// Calls `each` with the file and the digest of every line of a table, if the table exists.
fn for_each_line(path: &Path, may_be_cut: bool, each: impl FnMut(&str, &str) -> Result<()>) -> Result<()> {
    if !path.exists() {
        return Ok(());
    }
    read_lines(path, may_be_cut, each).map_err(|fault| {
        LibraryFault::new(phrase![
            "cannot continue with {}: {}; leave out {} and replace all with {}, or choose another \
             folder with {}";
            path.display().to_string(), fault.phrase(), Input::Resume, Input::Force,
            Input::OutputDir.with_placeholder("DIR")
        ])
    })
}

/// Calls `each` with the file and the digest of every line of a table.
fn read_lines(path: &Path, may_be_cut: bool, mut each: impl FnMut(&str, &str) -> Result<()>) -> Result<()> {
    let (mut file, end) = open_lines(path, may_be_cut)?;
    file.seek(SeekFrom::Start(0)).map_err(fault_of_error)?;
    let mut lines = BufReader::new(file).take(end);
    let mut first = Vec::new();
    if lines.read_until(b'\n', &mut first).map_err(fault_of_error)? == 0 && may_be_cut {
        // The run was killed before it had written its first line.
        return Ok(());
    }
    let (name, digest) = file_and_digest_columns(&first)?;
    let mut reader = csv::ReaderBuilder::new().has_headers(false).from_reader(lines);
    let mut row = csv::StringRecord::new();
    while reader.read_record(&mut row).map_err(fault_of_error)? {
        let cell = |at: usize| from_cell(row.get(at).unwrap_or_default());
        each(&cell(name), &cell(digest))?;
    }
    Ok(())
}

/// The indices of the columns of file and digest in a table whose header is `first`.
///
/// # Errors
/// The header is not, byte for byte, one that this program writes: another program saved the table, perhaps with columns that the new
/// table would lose.
fn file_and_digest_columns(first: &[u8]) -> Result<(usize, usize)> {
    let header = csv::Reader::from_reader(first).headers().map_err(fault_of_error)?.clone();
    let columns: Vec<String> = header.iter().map(str::to_owned).collect();
    let is_ours =
        (columns == FILE_COLUMNS || SweepPlan::is_table_header(&columns)) && csv_line(&columns)? == first;
    let [name, digest] = FILE_COLUMNS.map(|column| columns.iter().position(|cell| cell == column));
    match (name, digest) {
        (Some(name), Some(digest)) if is_ours => Ok((name, digest)),
        _ => Err(LibraryFault::new(
            "this is not the table of a sweep, or another program saved it: its first line differs",
        )),
    }
}

/// The cells as one line of CSV; no cell is a formula.
pub(super) fn csv_line(cells: &[String]) -> Result<Vec<u8>> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(cells.iter().map(|text| cell(text).into_owned())).map_err(fault_of_error)?;
    writer.into_inner().map_err(fault_of_error)
}
