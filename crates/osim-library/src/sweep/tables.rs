//! The tables of one sweep: of the whole, and of parts that several runs make at the same time, each with a table of its own.
//!
//! No two runs write one table. The run that makes the whole takes in what parts made, and their tables go when it has all.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use osim_model::messages::phrase;
use osim_planning::SweepPlan;

use super::known::is_of_sweep;
use crate::fault::{Context, LibraryFault};
use crate::partial::Partial;

/// Where the tables of a sweep are.
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

    /// The table that this run writes.
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
                let name = name.strip_suffix(Partial::ENDING).unwrap_or(name);
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
            return Partial::check_free(&self.whole, &way_out);
        }
        self.replaced().try_for_each(|part| Partial::check_free(part, &way_out))
    }

    /// The table of the whole has its name: those of parts that were there when this run began are no longer needed. What another
    /// program saved is not ours to remove.
    ///
    /// # Errors
    /// The folder cannot be changed.
    pub(super) fn remove_parts(&self) -> Result<(), LibraryFault> {
        for part in self.replaced().filter(|part| is_of_sweep(part)) {
            let partial = Partial::path_of(part);
            for file in [part, &partial] {
                if file.exists() {
                    std::fs::remove_file(file).context(|| format!("cannot remove {}", file.display()))?;
                }
            }
        }
        Ok(())
    }
}
