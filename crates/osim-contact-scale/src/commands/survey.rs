//! Models looked at, on all processors: what `inspect` and `check` share.

use anyhow::Result;
use osim_inspect::{CheckResult, Inspection};
use osim_library::run::PathConflicts;
use osim_library::{Disk, Folders, Loaded, Source, Sources};
use osim_model::Finding;
use osim_model::files::{Failure, OpenModel};
use osim_model::wording::Verb;
use osim_report::html::{self, About, Columns, DetailLevel, Entry};
use osim_requests::options::ReportOptions;
use osim_requests::{Inspector, ModelFeet};

use super::asked::asked;
use crate::interrupt;
use crate::report_page::{Replace, ReportPage};
use crate::session::Session;
use crate::words::Words;

/// Models and how they are looked at.
pub(super) struct Survey<'s> {
    pub verb: Verb,
    pub sources: &'s Sources,
    pub inspector: &'s Inspector,
    pub report: &'s ReportOptions,
    pub words: Words,
}

/// A model that was looked at.
pub(super) struct Seen {
    pub opened: OpenModel,
    pub inspection: Inspection,
}

impl Survey<'_> {
    /// The page, if one is asked for; what could not even be listed is on it already.
    ///
    /// # Errors
    /// Its name, a file that is there already, or a file that is read has that name.
    pub(super) fn begin_page(&self, session: &Session) -> Result<Option<ReportPage>> {
        let Some(path) = &self.report.report else { return Ok(None) };
        let mut conflicts = PathConflicts::default();
        self.sources.models.iter().for_each(|source| conflicts.read(source.path.as_path()));
        self.inspector.reads().iter().for_each(|path| conflicts.read(path.as_path()));
        conflicts.write(path, "the report").map_err(|fault| session.refused(&fault))?;
        let shown = match (self.sources.models.as_slice(), self.sources.failures.as_slice()) {
            ([source], []) => Some(source.shown()),
            ([], [failure]) => Some(failure.model.to_string()),
            _ => None,
        };
        let about = About::new(self.verb, shown, Columns::Inspections, asked());
        let replace = if self.report.force { Replace::Files } else { Replace::Never };
        interrupt::outlive_size_limit();
        Folders::list(std::iter::once(path.as_path()), true);
        let mut page = ReportPage::begin(path, replace, about, session)?;
        self.sources.failures.iter().for_each(|failure| page.add(Entry::failed(failure, self.words)));
        Ok(Some(page))
    }

    /// Reads and inspects a model.
    ///
    /// # Errors
    /// It cannot be read.
    pub(super) fn see(&self, source: &Source) -> Result<Seen, Failure> {
        let loaded = Loaded::read(source, self.inspector.set_files())?;
        let opened = loaded.files.open()?;
        let inspection = self.inspector.inspect(&opened)?;
        Ok(Seen { opened, inspection })
    }

    /// What is wrong with it, spelled.
    pub(super) fn check(&self, seen: &mut Seen, compiled: Option<&Finding>) -> CheckResult {
        let mut found = self.inspector.check(&seen.opened.model, &seen.inspection, compiled);
        found.spell(self.words);
        found
    }

    /// The model on the page, where one is asked for.
    pub(super) fn entry(&self, seen: &Seen, found: &CheckResult) -> Entry {
        let files: Vec<(String, String)> =
            seen.opened.files().map(|(name, bytes)| (name.to_owned(), osim_library::sha256(bytes))).collect();
        let both = (&seen.inspection, found);
        let detail = DetailLevel::of(self.sources.models.len() + self.sources.failures.len());
        let feet = detail.has_feet().then(|| self.feet(&seen.opened)).flatten();
        html::inspected(self.inspector.options(), &seen.opened, both, &files, (detail, feet), self.words)
    }

    /// The feet of a model, with the bones whose meshes are at hand.
    fn feet(&self, opened: &OpenModel) -> Option<ModelFeet> {
        let path = opened.name().to_path();
        let mut feet = ModelFeet::for_page(opened.name(), opened, &self.inspector.options().selection)?;
        feet.add_bones((&opened.model, &path), None, &Disk);
        Some(feet)
    }
}
