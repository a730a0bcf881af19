//! Models inspected and checked one by one, with their entry on a page.

use osim_inspect::{CheckResult, Inspection};
use osim_model::Finding;
use osim_model::files::{Failure, Files, OpenModel};
use osim_model::messages::Verb;
use osim_planning::{Inspector, ModelFeet};
use osim_requests::options::ReportOptions;
use osim_view::html::{About, Columns, DetailLevel, Entry, Examined, NamedDigest, Section};

use crate::page::report_page::{Replace, ReportPage};
use crate::page::words::Words;
use crate::run::PathConflicts;
use crate::{Disk, Folders, LibraryFault, Loaded, Source, Sources};

/// Models and how they are looked at.
pub struct Survey<'s> {
    /// `inspect` or `check`.
    pub verb: Verb,
    /// The models.
    pub sources: &'s Sources,
    /// How they are inspected.
    pub inspector: &'s Inspector,
    /// The page that is asked for.
    pub report: &'s ReportOptions,
    /// The words of messages.
    pub words: Words,
}

/// A model that was inspected.
pub struct Inspected {
    /// The model.
    pub opened: OpenModel,
    /// What is known of it, not spelled yet.
    pub inspection: Inspection,
}

impl Survey<'_> {
    /// The page, if one is asked for, about the call `asked`; what could not even be listed is on it already.
    ///
    /// # Errors
    /// Its name, a file that is there already, or a file that is read has that name.
    pub fn begin_page(&self, asked: String) -> Result<Option<ReportPage>, LibraryFault> {
        let Some(path) = &self.report.report else { return Ok(None) };
        let mut conflicts = PathConflicts::default();
        self.sources.models.iter().for_each(|source| conflicts.read(source.path.as_path()));
        self.inspector.reads().iter().for_each(|path| conflicts.read(path.as_path()));
        conflicts.write(path, "the report")?;
        let shown = match (self.sources.models.as_slice(), self.sources.failures.as_slice()) {
            ([source], []) => Some(source.shown()),
            ([], [failure]) => Some(failure.model.to_string()),
            _ => None,
        };
        let about = About::new(self.verb, shown, Columns::Inspections, asked);
        let replace = if self.report.force { Replace::Files } else { Replace::Never };
        Folders::list(std::iter::once(path.as_path()), true);
        let mut page = ReportPage::begin(path, replace, about, self.words)?;
        self.sources.failures.iter().for_each(|failure| page.add(Entry::failed(failure, self.words)));
        Ok(Some(page))
    }

    /// Reads and inspects a model.
    ///
    /// # Errors
    /// It cannot be read.
    pub fn inspect(&self, source: &Source) -> Result<Inspected, Failure> {
        self.inspect_loaded(Loaded::read(source, self.inspector.set_files())?)
    }

    /// Inspects a model that was loaded.
    ///
    /// # Errors
    /// It cannot be read.
    pub fn inspect_loaded(&self, loaded: Loaded) -> Result<Inspected, Failure> {
        let opened = loaded.files.open()?;
        let inspection = self.inspector.inspect(&opened)?;
        Ok(Inspected { opened, inspection })
    }

    /// What is wrong with it, spelled; remedies are tried with what `files` has beside it.
    pub fn check(
        &self,
        inspected: &mut Inspected,
        compiled: Option<&Finding>,
        files: &dyn Files,
    ) -> CheckResult {
        let mut found = self.inspector.check(&inspected.opened.model, &inspected.inspection, compiled, files);
        found.spell(self.words);
        found
    }

    /// The model on the page, if a page is asked for.
    pub fn entry(&self, inspected: &Inspected, found: &CheckResult) -> Entry {
        let digest = |(name, bytes): (&str, &[u8])| NamedDigest {
            name: name.to_owned(),
            sha256: crate::sha256(bytes),
        };
        let files: Vec<NamedDigest> = inspected.opened.files().map(digest).collect();
        let detail = DetailLevel::of(self.sources.models.len() + self.sources.failures.len());
        let feet = detail.has_feet().then(|| self.feet(&inspected.opened)).flatten();
        let shown = osim_view::html::Inspected {
            options: self.inspector.options(),
            model: &inspected.opened,
            examined: Examined { inspection: &inspected.inspection, check: found },
            files: &files,
            feet,
            recording: self.recording(&inspected.opened),
        };
        osim_view::html::inspected(shown, detail, self.words)
    }

    /// What its contacts do along the recording that was named, if one was.
    fn recording(&self, opened: &OpenModel) -> Option<Section> {
        let (result, remarks) = self.inspector.recording(&opened.name().to_path(), &Disk)?;
        Some(osim_view::html::recording(&result, &remarks, self.words))
    }

    /// The feet of a model, with the bones whose meshes are available.
    fn feet(&self, opened: &OpenModel) -> Option<ModelFeet> {
        let path = opened.name().to_path();
        let mut feet = ModelFeet::for_page(opened.name(), opened, &self.inspector.options().selection)?;
        feet.add_bones(&opened.model, &path, None, &Disk);
        Some(feet)
    }
}
