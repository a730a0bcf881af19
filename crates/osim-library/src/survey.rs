//! Many models inspected or checked in one call: what is known of each, its text, and its entry on a page.

use std::collections::BTreeMap;
use std::path::PathBuf;

use osim_inspect::{CheckResult, Counts, Inspection};
use osim_model::files::{Failure, OpenModel};
use osim_model::messages::Verb;
use osim_planning::{Inspector, ModelFeet};
use osim_requests::Jobs;
use osim_requests::options::ReportOptions;
use osim_view::html::{About, Columns, DetailLevel, Entry, Examined, NamedDigest, Section};
use osim_view::report::check::{self, LibraryTable};
use osim_view::report::extent::Extent;
use osim_view::report::inspection::{self, ModelsTable};
use osim_view::report::layout::Colour;

use crate::report_page::{MayReplace, ReportPage, Words};
use crate::run::PathConflicts;
use crate::source::MemoryFirst;
use crate::{
    Disk, LibraryFault, Loaded, OutputFolders, Source, Sources, sha256, thread_count, work_in_order,
};

/// Models and how they are looked at.
pub struct Survey<'s> {
    /// `check`, else the models are inspected.
    pub verb: Verb,
    /// The models.
    pub sources: &'s Sources,
    /// Files that are not read from the disk.
    pub memory: &'s BTreeMap<PathBuf, Vec<u8>>,
    /// How they are inspected.
    pub inspector: &'s Inspector,
    /// The page that is asked for.
    pub report: &'s ReportOptions,
    /// Whether each model is shown by itself, however many there are.
    pub shows_each: bool,
    /// How much the text of a model shows; in full each is shown by itself, too.
    pub extent: Extent,
    /// The words of messages.
    pub words: Words,
}

/// What a survey knows of one model, spelled.
pub enum Surveyed {
    /// What it holds; and how much is wrong with it, where that is shown.
    Inspected(Box<Inspection>, Option<Counts>),
    /// What is wrong with it.
    Checked(Box<CheckResult>),
    /// It is one of a folder, and has no contacts.
    WithoutContacts,
    /// It cannot be read.
    Failed(Box<Failure>),
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
        self.inspector.extra_files().iter().for_each(|path| conflicts.read(path.as_path()));
        conflicts.write(path, "the report")?;
        let shown = match (self.sources.models.as_slice(), self.sources.failures.as_slice()) {
            ([source], []) => Some(source.shown()),
            ([], [failure]) => Some(failure.model.to_string()),
            _ => None,
        };
        let about = About::new(self.verb, shown, Columns::Inspections, asked);
        let replace = if self.report.force { MayReplace::Files } else { MayReplace::Never };
        OutputFolders::list(std::iter::once(path.as_path()), true);
        let mut page = ReportPage::begin(path, replace, about, self.words)?;
        self.sources.failures.iter().for_each(|failure| page.add(Entry::failed(failure, self.words)));
        Ok(Some(page))
    }

    /// Looks at all models, on as many threads as `jobs` says, until the call `is_stopped`. `each` gets them with
    /// their names, in the order in which they were named; they are on the `page` already.
    ///
    /// An error of `each` ends the work. Where there is a page, what cannot be shown is no reason to leave it without its models: then
    /// the first error is returned in the end.
    ///
    /// # Errors
    /// Threads cannot be started, or an error of `each` without a page.
    pub fn run<E: From<LibraryFault>>(
        &self,
        page: &mut Option<ReportPage>,
        jobs: Option<Jobs>,
        is_stopped: impl Fn() -> bool + Sync,
        mut each: impl FnMut(&str, Surveyed) -> Result<(), E>,
    ) -> Result<Option<E>, E> {
        let models = &self.sources.models;
        let lists = self.verb == Verb::Check || self.is_table();
        let folders =
            lists.then(|| OutputFolders::list(models.iter().map(|source| source.path.as_path()), false));
        let (with_page, mut untold) = (page.is_some(), None);
        work_in_order(
            models,
            thread_count(jobs, models.len()),
            |source| (!is_stopped()).then(|| self.look(source, folders.as_ref(), with_page)),
            |source, looked| -> Result<(), E> {
                let Some((surveyed, entry)) = looked else { return Ok(()) };
                if let Some((page, entry)) = page.as_mut().zip(entry) {
                    page.add(entry);
                }
                match each(&source.shown(), surveyed) {
                    Err(error) if with_page => untold = untold.take().or(Some(error)),
                    told => told?,
                }
                Ok(())
            },
        )?;
        Ok(untold)
    }

    /// The text of its models, without any of them.
    pub fn text(&self, colour: Colour) -> SurveyText {
        let mut text = SurveyText {
            words: self.words,
            colour,
            extent: self.extent,
            is_first: true,
            names_full: true,
            models: None,
            library: None,
        };
        if self.is_table() && self.verb == Verb::Check {
            text.library = Some(LibraryTable::default());
        } else if self.is_table() {
            let table = text.models.insert(ModelsTable::default());
            let failures = self.sources.failures.iter();
            failures.for_each(|failure| table.add_failed(&failure.model.to_string(), failure.code));
        }
        text
    }

    /// Whether its models are shown as one table.
    fn is_table(&self) -> bool {
        let models = self.sources.models.len();
        let several =
            if self.verb == Verb::Check { models } else { models + self.sources.failures.len() } > 1;
        several && !self.shows_each && !self.extent.is_full()
    }

    fn look(
        &self,
        source: &Source,
        folders: Option<&OutputFolders>,
        with_page: bool,
    ) -> (Surveyed, Option<Entry>) {
        match self.examine(source, folders, with_page) {
            Ok(looked) => looked,
            Err(failure) if self.verb == Verb::Check && source.is_skipped(&failure) => {
                (Surveyed::WithoutContacts, with_page.then(|| Entry::without_contacts(&failure.model)))
            }
            Err(failure) => {
                let entry = with_page.then(|| Entry::failed(&failure, self.words));
                (Surveyed::Failed(Box::new(failure)), entry)
            }
        }
    }

    fn examine(
        &self,
        source: &Source,
        folders: Option<&OutputFolders>,
        with_page: bool,
    ) -> Result<(Surveyed, Option<Entry>), Failure> {
        let opened = Loaded::read_beside(source, self.inspector.set_files(), self.memory)?.files.open()?;
        let mut inspection = self.inspector.inspect(&opened)?;
        let is_check = self.verb == Verb::Check;
        if is_check && source.folder.is_some() {
            self.inspector.refuse_without_contacts(&opened, &inspection)?;
        }
        let found = (with_page || folders.is_some()).then(|| {
            let is_file = !source.is_stdin() && !self.memory.contains_key(&source.path);
            let compiled = folders
                .filter(|_| is_file)
                .and_then(|known| known.compiled_model_beside_output(&source.path));
            let files = MemoryFirst { memory: self.memory, disk: &Disk };
            let mut found = self.inspector.check(&opened.model, &inspection, compiled.as_ref(), &files);
            found.spell(self.words);
            found
        });
        inspection.spell(self.words);
        let entry = found.as_ref().filter(|_| with_page).map(|found| self.entry(&opened, &inspection, found));
        let surveyed = match found {
            Some(found) if is_check => Surveyed::Checked(Box::new(found)),
            found => Surveyed::Inspected(Box::new(inspection), found.map(|found| found.counts)),
        };
        Ok((surveyed, entry))
    }

    /// The model on the page.
    fn entry(&self, opened: &OpenModel, inspection: &Inspection, check: &CheckResult) -> Entry {
        let digest =
            |(name, bytes): (&str, &[u8])| NamedDigest { name: name.to_owned(), sha256: sha256(bytes) };
        let files: Vec<NamedDigest> = opened.files().map(digest).collect();
        let detail = DetailLevel::of(self.sources.models.len() + self.sources.failures.len());
        let shown = osim_view::html::Inspected {
            options: self.inspector.options(),
            model: opened,
            examined: Examined { inspection, check },
            files: &files,
            feet: detail.has_feet().then(|| self.feet(opened)).flatten(),
            recording: self.recording(opened),
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

/// The text of a survey: of each model by itself, or one table in the end.
pub struct SurveyText {
    words: Words,
    colour: Colour,
    extent: Extent,
    is_first: bool,
    /// Whether a table says how all models are shown in full.
    names_full: bool,
    /// What models hold.
    models: Option<ModelsTable>,
    /// What is wrong with models.
    library: Option<LibraryTable>,
}

impl SurveyText {
    /// For a front end in which several models cannot be asked for in full: the text does not name the option.
    pub fn without_full(self) -> Self {
        Self { names_full: false, ..self }
    }

    /// Adds the model that was named `name`. Returns what is shown of it now: nothing where there is a table.
    pub fn add(&mut self, name: &str, surveyed: &Surveyed) -> String {
        match (surveyed, &mut self.models, &mut self.library) {
            (Surveyed::Inspected(inspected, counts), Some(table), _) => {
                table.add(inspected, counts.unwrap_or_default());
            }
            (Surveyed::Inspected(inspected, _), None, _) => {
                let gap = if std::mem::take(&mut self.is_first) { "" } else { "\n" };
                return format!("{gap}{}", inspection::text(inspected, self.words, self.colour, self.extent));
            }
            (Surveyed::Checked(found), _, Some(table)) => table.add(found),
            (Surveyed::Checked(found), _, None) => {
                return check::text(found, self.words.prompt(), self.colour, self.extent);
            }
            (Surveyed::Failed(failure), models, library) => {
                models.iter_mut().for_each(|table| table.add_failed(name, failure.code));
                library.iter_mut().for_each(|table| table.add_failed(name, failure.code));
            }
            (Surveyed::WithoutContacts, ..) => {}
        }
        String::new()
    }

    /// The table, where there is one, for lines of `width` characters; `None` is a file, whose lines have no end.
    pub fn end(self, width: Option<usize>) -> String {
        let models = self.models.map(|table| table.text(width, self.words, self.colour, self.names_full));
        let library =
            self.library.map(|table| table.text(width.is_none(), self.words, self.colour, self.names_full));
        models.or(library).unwrap_or_default()
    }
}
