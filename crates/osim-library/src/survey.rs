//! Many models that are inspected or checked in one call: the result, the text and the page entry of each.

use std::collections::BTreeMap;
use std::path::PathBuf;

use osim_inspect::{CheckResult, Counts, Inspection};
use osim_model::files::{Failure, OpenModel};
use osim_model::messages::{Input, Verb, phrase};
use osim_planning::{Inspector, ModelFeet};
use osim_requests::options::ReportOptions;
use osim_requests::{CheckRequest, Jobs};
use osim_view::html::{About, Columns, DetailLevel, Entry, InspectedAndChecked, NamedDigest, Section};
use osim_view::report::check::{self, LibraryTable};
use osim_view::report::extent::Layout;
use osim_view::report::inspection::{self, ModelsTable};

use crate::report_page::{MayReplace, ReportPage, Words};
use crate::run::{ModelToFix, PathConflicts};
use crate::source::MemoryFirst;
use crate::workers::{thread_count, work_in_order};
use crate::{Disk, LibraryFault, Loaded, OutputFolders, Source, Sources, sha256};

/// Models and how they are looked at.
pub struct Survey<'s> {
    /// `check`, or another verb: then the models are inspected.
    pub verb: Verb,
    pub sources: &'s Sources,
    /// Files in memory, which go before those on the disk.
    pub memory: &'s BTreeMap<PathBuf, Vec<u8>>,
    pub inspector: &'s Inspector,
    pub report: &'s ReportOptions,
    /// Whether each model is shown by itself, however many there are.
    pub shows_each: bool,
    /// The call of a check, which the command for many models repeats.
    pub check: Option<&'s CheckRequest>,
    /// How texts are laid out; in full each model is shown by itself, too.
    pub layout: Layout,
    /// The front end whose words messages use.
    pub words: Words,
}

/// Result of a survey for one model, spelled.
pub enum SurveyedModel {
    /// The model's inspection, and the numbers of its findings if they are shown.
    Inspected(Box<Inspection>, Option<Counts>),
    /// Its findings; with `fix` those of the result, and what was written.
    Checked(Box<CheckResult>, Option<String>),
    /// A model of a folder without contacts.
    WithoutContacts,
    Failed(Box<Failure>),
}

impl Survey<'_> {
    /// Begins the page if one is asked for, with entries of models that could not be listed. `call` is shown on the page.
    ///
    /// # Errors
    /// The name is not that of a page, the file exists already, or it is read in this call.
    pub fn begin_page(&self, call: String) -> Result<Option<ReportPage>, LibraryFault> {
        let Some(path) = &self.report.report else { return Ok(None) };
        let mut conflicts = PathConflicts::default();
        self.sources.models.iter().for_each(|source| conflicts.add_input(source.path.as_path()));
        self.inspector.extra_files().iter().for_each(|path| conflicts.add_input(path.as_path()));
        conflicts.add_output(path, "the report")?;
        let shown = match (self.sources.models.as_slice(), self.sources.failures.as_slice()) {
            ([source], []) => Some(source.shown()),
            ([], [failure]) => Some(failure.model.to_string()),
            _ => None,
        };
        let about = About::new(self.verb, shown, Columns::Inspections, call);
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
        mut each: impl FnMut(&str, SurveyedModel) -> Result<(), E>,
    ) -> Result<Option<E>, E> {
        let models = &self.sources.models;
        if models.len() > 1 && self.check.is_some_and(|call| call.output.is_some()) {
            let fault = phrase![
                Input::Output,
                " names one file, and these are several models: name a folder with ",
                Input::OutputDir
            ];
            return Err(LibraryFault::new(fault).into());
        }
        let lists = self.verb == Verb::Check || self.is_table();
        let folders =
            lists.then(|| OutputFolders::list(models.iter().map(|source| source.path.as_path()), false));
        let (with_page, mut first_error) = (page.is_some(), None);
        work_in_order(
            models,
            thread_count(jobs, models.len()),
            |source| (!is_stopped()).then(|| self.survey_model(source, folders.as_ref(), with_page)),
            |source, looked| -> Result<(), E> {
                let Some((surveyed, entry)) = looked else { return Ok(()) };
                if let Some((page, entry)) = page.as_mut().zip(entry) {
                    page.add(entry);
                }
                match each(&source.shown(), surveyed) {
                    Err(error) if with_page => first_error = first_error.take().or(Some(error)),
                    told => told?,
                }
                Ok(())
            },
        )?;
        Ok(first_error)
    }

    /// Begins the text about the models.
    pub fn begin_text(&self) -> SurveyText {
        let mut text = SurveyText {
            words: self.words,
            layout: self.layout,
            is_first: true,
            names_full: true,
            models: None,
            library: None,
        };
        if let Some(call) = self.check.filter(|_| self.is_table()) {
            let table = text.library.insert(LibraryTable::new(call.clone()));
            let failures = self.sources.failures.iter();
            failures.for_each(|failure| table.add_failed(&failure.model.to_string(), failure.code));
        } else if self.is_table() {
            let table = text.models.insert(ModelsTable::default());
            let failures = self.sources.failures.iter();
            failures.for_each(|failure| table.add_failed(&failure.model.to_string(), failure.code));
        }
        text
    }

    /// Whether the text is one table of all models.
    fn is_table(&self) -> bool {
        let models = self.sources.models.len();
        let several =
            if self.verb == Verb::Check { models } else { models + self.sources.failures.len() } > 1;
        several && !self.shows_each && !self.layout.extent.is_full()
    }

    fn survey_model(
        &self,
        source: &Source,
        folders: Option<&OutputFolders>,
        with_page: bool,
    ) -> (SurveyedModel, Option<Entry>) {
        match self.inspect_and_check(source, folders, with_page) {
            Ok(looked) => looked,
            Err(failure) if self.verb == Verb::Check && source.is_skipped(&failure) => {
                (SurveyedModel::WithoutContacts, with_page.then(|| Entry::without_contacts(&failure.model)))
            }
            Err(failure) => {
                let entry = with_page.then(|| Entry::failed(&failure, self.words));
                (SurveyedModel::Failed(Box::new(failure)), entry)
            }
        }
    }

    fn inspect_and_check(
        &self,
        source: &Source,
        folders: Option<&OutputFolders>,
        with_page: bool,
    ) -> Result<(SurveyedModel, Option<Entry>), Failure> {
        let Loaded { files: kept, origin } =
            Loaded::read_with_memory(source, self.inspector.set_files(), self.memory)?;
        let fix = self.check.filter(|call| call.fix).map(|call| (call.output(), kept.with_bytes(Vec::new())));
        let opened = kept.open()?;
        let mut inspection = self.inspector.inspect(&opened)?;
        let is_check = self.verb == Verb::Check;
        if is_check && source.folder.is_some() {
            self.inspector.refuse_without_contacts(&opened, &inspection)?;
        }
        let check_result = (with_page || folders.is_some()).then(|| {
            let is_file = !source.is_stdin() && !self.memory.contains_key(&source.path);
            let compiled = folders
                .filter(|_| is_file)
                .and_then(|known| known.compiled_model_beside_output(&source.path));
            let files = MemoryFirst { memory: self.memory, disk: &Disk };
            self.inspector.check(&opened.model, &inspection, compiled.as_ref(), &files)
        });
        let (mut check_result, mut written) = (check_result, None);
        if let Some((output, files)) = fix
            && let Some(checked) = check_result.take()
        {
            let model = ModelToFix { source, files, opened: &opened, origin: &origin, checked };
            let (judged, what) = model.fix(self.inspector, &output)?;
            (check_result, written) = (Some(judged), Some(what));
        }
        check_result.iter_mut().for_each(|result| result.spell(self.words));
        inspection.spell(self.words);
        let entry = check_result
            .as_ref()
            .filter(|_| with_page)
            .map(|check_result| self.entry(&opened, &inspection, check_result));
        let surveyed = match check_result {
            Some(check_result) if is_check => SurveyedModel::Checked(Box::new(check_result), written),
            check_result => SurveyedModel::Inspected(
                Box::new(inspection),
                check_result.map(|check_result| check_result.counts),
            ),
        };
        Ok((surveyed, entry))
    }

    /// The entry of one model on the report page.
    fn entry(&self, opened: &OpenModel, inspection: &Inspection, check: &CheckResult) -> Entry {
        let digest =
            |(name, bytes): (&str, &[u8])| NamedDigest { name: name.to_owned(), sha256: sha256(bytes) };
        let files: Vec<NamedDigest> = opened.files().map(digest).collect();
        let detail = DetailLevel::for_models(self.sources.models.len() + self.sources.failures.len());
        let shown = osim_view::html::InspectedModelOnPage {
            options: self.inspector.options(),
            model: opened,
            examined: InspectedAndChecked { inspection, check },
            files: &files,
            feet: detail.has_feet().then(|| self.feet(opened)).flatten(),
            recording: self.recording(opened),
        };
        osim_view::html::entry_of_inspected_model(shown, detail, self.words)
    }

    /// The section about the model's contacts along the recording, if one is named.
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

/// The text of a survey: one text for each model, or one table of all.
pub struct SurveyText {
    words: Words,
    layout: Layout,
    is_first: bool,
    /// Whether a table says how all models are shown in full.
    names_full: bool,
    /// The table of inspections, if there is one.
    models: Option<ModelsTable>,
    /// The table of findings, if there is one.
    library: Option<LibraryTable>,
}

impl SurveyText {
    /// The survey for a front end in which several models cannot be asked for in full: the text does not name the option.
    pub fn without_full(self) -> Self {
        Self { names_full: false, ..self }
    }

    /// Adds the model that was named `name`. Returns what is shown of it now: nothing where there is a table.
    pub fn add(&mut self, name: &str, surveyed: &SurveyedModel) -> String {
        match (surveyed, &mut self.models, &mut self.library) {
            (SurveyedModel::Inspected(inspected, counts), Some(table), _) => {
                table.add(inspected, counts.unwrap_or_default());
            }
            (SurveyedModel::Inspected(inspected, _), None, _) => {
                let gap = if std::mem::take(&mut self.is_first) { "" } else { "\n" };
                return format!("{gap}{}", inspection::text(inspected, self.words, self.layout));
            }
            (SurveyedModel::Checked(check_result, _), _, Some(table)) => table.add(check_result),
            (SurveyedModel::Checked(check_result, written), _, None) => {
                let mut text = check::text(check_result, self.words, self.layout);
                text.extend(written.as_ref().map(|written| format!("{written}\n")));
                return text;
            }
            (SurveyedModel::Failed(failure), models, library) => {
                models.iter_mut().for_each(|table| table.add_failed(name, failure.code));
                library.iter_mut().for_each(|table| table.add_failed(name, failure.code));
            }
            (SurveyedModel::WithoutContacts, _, library) => {
                library.iter_mut().for_each(LibraryTable::add_without_contacts);
            }
        }
        String::new()
    }

    /// The table, where there is one.
    pub fn end(self) -> String {
        let Layout { columns, colour, .. } = self.layout;
        let models = self.models.map(|table| table.text(columns, self.words, colour, self.names_full));
        let library = self.library.map(|table| table.text(self.words, self.layout));
        models.or(library).unwrap_or_default()
    }
}
