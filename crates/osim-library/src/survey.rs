//! Inspects or checks many models in one call: makes the result, the text and the entry on the report page for each.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::path::PathBuf;

use osim_inspect::{CheckResult, Counts, Inspection};
use osim_model::files::{Failure, OpenModel};
use osim_model::messages::{Input, Verb, phrase};
use osim_planning::{Inspector, ModelFeet};
use osim_requests::options::{OutputOptions, ReportOptions};
use osim_requests::{CheckRequest, Jobs};
use osim_view::html::{Columns, DetailLevel, Entry, NamedDigest, PageHead};
use osim_view::report::check::{self, LibraryTable, RESULTS_FOLDER};
use osim_view::report::extent::Layout;
use osim_view::report::inspection::{self, ModelsTable};

use crate::file_access::FileKinds;
use crate::paths::refuse_file_as_folder;
use crate::report_page::{ReportPage, Words};
use crate::run::{ModelToFix, NOTHING_WRITTEN, PathConflicts, PathOwner, ResultDestination};
use crate::source::MemoryFirst;
use crate::workers::{thread_count, work_in_order};
use crate::{
    Disk, LibraryFault, LoadedModel, ModelSource, OutputFolders, Result, Sources, require_folder_of, sha256,
};

/// The largest number of commands that are proposed for models with the same names.
const MOST_COMMANDS: usize = 5;

/// Models that one call inspects or checks, with the options of the call.
pub struct Survey<'s> {
    /// With `check` the models are checked; with any other verb they are inspected.
    pub verb: Verb,
    pub sources: &'s Sources,
    /// Files in memory, used instead of files of the same names on the disk.
    pub memory: &'s BTreeMap<PathBuf, Vec<u8>>,
    pub inspector: &'s Inspector,
    pub report: &'s ReportOptions,
    /// Whether each model has a text of its own, even if there are many models.
    pub shows_each: bool,
    /// The request of the check. The command that the text about many models proposes repeats its options.
    pub check: Option<&'s CheckRequest>,
    /// The layout of texts. In a full layout each model has a text of its own, too.
    pub layout: Layout,
    /// The front end that spells options and calls in messages.
    pub words: Words,
}

/// Result of inspecting or checking one model, with messages spelled for the caller.
pub enum SurveyedModel {
    /// The model's inspection, and the numbers of its findings if they are shown.
    Inspected(Box<Inspection>, Option<Counts>),
    /// The model's findings. With `fix`, the findings about the corrected model and a sentence about the written file.
    Checked(Box<CheckResult>, Option<String>),
    /// The model has no contacts, and was found in a folder.
    WithoutContacts,
    Failed(Box<Failure>),
}

impl Survey<'_> {
    /// Begins the report page if the options name one, with entries of models that could not be listed. The page shows `call`.
    ///
    /// # Errors
    /// The check would write several models to one file or into a file, or several results exist already. The name of the page has another
    /// ending than `.html`, its folder is not there, the file exists already, or this call reads it.
    pub fn begin_page(&self, call: String) -> Result<Option<ReportPage>> {
        let mut conflicts = PathConflicts::default();
        self.sources.models.iter().for_each(|source| conflicts.add_input_of_model(source.path.as_path()));
        self.inspector.extra_files.iter().for_each(|path| conflicts.add_input(path.as_path()));
        self.check.map_or(Ok(()), |call| self.refuse_outputs(call, &mut conflicts))?;
        let Some(path) = &self.report.report else { return Ok(None) };
        require_folder_of(path, self.check.and_then(|call| call.output_dir.as_deref()))?;
        conflicts.add_output(path, "the report")?;
        let shown = match (self.sources.models.as_slice(), self.sources.failures.as_slice()) {
            ([source], []) => Some(source.shown()),
            ([], [failure]) => Some(failure.model.to_string()),
            _ => None,
        };
        let head = PageHead { verb: self.verb, model: shown, columns: Columns::Inspections, call };
        OutputFolders::list(std::iter::once(path.as_path()), true);
        let failures = &self.sources.failures;
        ReportPage::begin(path, self.report.force, head, failures, self.words).map(Some)
    }

    /// Refuses one output for several models, a file as their folder, several results that exist already and may not be replaced, results
    /// of one name, and results with the name of an input.
    fn refuse_outputs<'p>(&'p self, call: &CheckRequest, conflicts: &mut PathConflicts<'p>) -> Result<()> {
        let (models, output) = (&self.sources.models, call.output());
        if models.len() > 1 && output.output.is_some() {
            return Err(LibraryFault::new(phrase![
                "{} names one file, and these are several models: name a folder with {}";
                Input::Output, Input::OutputDir.with_placeholder("DIR")
            ]));
        }
        output.output_dir.as_deref().map_or(Ok(()), refuse_file_as_folder)?;
        if call.fix {
            self.add_results(&output, conflicts)?;
        }
        let results = models.iter().filter(|_| call.fix && !output.force);
        let existing = results.filter_map(|source| match ResultDestination::of_source(source, &output) {
            ResultDestination::File(path) if path.exists() => Some(path),
            _ => None,
        });
        LibraryFault::refuse_existing(&existing.collect::<Vec<_>>(), models.len(), None)
    }

    /// Adds the results of all models to the outputs that are compared; refuses one file for two of them.
    fn add_results<'p>(&'p self, output: &OutputOptions, conflicts: &mut PathConflicts<'p>) -> Result<()> {
        self.sources.models.iter().try_for_each(|source| {
            let owner = PathOwner::Model(&source.path, None);
            match ResultDestination::of_source(source, output) {
                ResultDestination::File(path) => conflicts.add_output(&path, owner),
                ResultDestination::InPlace => conflicts.add_changed_in_place(&source.path, owner),
                ResultDestination::Stdout => Ok(()),
            }
        })
    }

    /// New folders for the results of proposed commands: one, or one for each of the `named` paths if results would get the same name.
    fn result_folders(&self, named: usize) -> Vec<PathBuf> {
        let output = OutputOptions { output_dir: Some(RESULTS_FOLDER.into()), ..OutputOptions::default() };
        let are_apart = self.add_results(&output, &mut PathConflicts::default()).is_ok();
        let count = match named {
            _ if are_apart => 1,
            2..=MOST_COMMANDS => named,
            _ => 0,
        };
        let all = (1..).map(|number| format!("{RESULTS_FOLDER}-{number}"));
        let all = are_apart.then(|| RESULTS_FOLDER.to_owned()).into_iter().chain(all).map(PathBuf::from);
        all.filter(|folder| !folder.exists()).take(count).collect()
    }

    /// Inspects or checks all models on `jobs` threads, until `is_stopped` returns true. Puts each model on the `page`, then calls `each`
    /// with its name and result, in the order in which the user named the models.
    ///
    /// Without a page, an error of `each` ends the work. With a page, the work goes on, so that the page gets all models, and the first
    /// error is returned in the end.
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

    /// An empty text, to which the text about each model is added.
    pub fn begin_text(&self) -> SurveyText {
        let call = self.check.filter(|_| self.is_table());
        let mut text = SurveyText {
            words: self.words,
            layout: self.layout,
            is_first: true,
            names_full: true,
            models: (call.is_none() && self.is_table()).then(ModelsTable::default),
            library: call.map(|call| LibraryTable::new(call.clone(), self.result_folders(call.models.len()))),
        };
        let failures = self.sources.failures.iter();
        failures.for_each(|failure| text.add_failed(&failure.model.to_string(), failure.code));
        text
    }

    /// Whether the text is one table of all models.
    fn is_table(&self) -> bool {
        let models = self.sources.models.len();
        let several =
            if self.verb == Verb::Check { models } else { models + self.sources.failures.len() } > 1;
        several && !self.shows_each && !self.layout.extent.is_full()
    }

    /// Inspects or checks one model; with its entry on the report page if there is one.
    fn survey_model(
        &self,
        source: &ModelSource,
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

    /// Reads, inspects and checks one model.
    fn inspect_and_check(
        &self,
        source: &ModelSource,
        folders: Option<&OutputFolders>,
        with_page: bool,
    ) -> Result<(SurveyedModel, Option<Entry>), Failure> {
        let LoadedModel { files: kept, origin } =
            LoadedModel::read_with_memory(source, &self.inspector.set_files, self.memory)?;
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
            let (memory, kinds) = (self.memory, FileKinds::Streams);
            let files = MemoryFirst { memory, kinds, stamps: RefCell::default() };
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
            .map(|check_result| self.page_entry(&opened, &inspection, check_result));
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
    fn page_entry(&self, opened: &OpenModel, inspection: &Inspection, check: &CheckResult) -> Entry {
        let digest =
            |(name, bytes): (&str, &[u8])| NamedDigest { name: name.to_owned(), sha256: sha256(bytes) };
        let files: Vec<NamedDigest> = opened.files().map(digest).collect();
        let detail = DetailLevel::for_models(self.sources.models.len() + self.sources.failures.len());
        let recording = self.inspector.recording(&opened.name().to_path(), &Disk);
        let shown = osim_view::html::InspectedModelOnPage {
            options: &self.inspector.options,
            model: opened,
            examined: (inspection, check),
            files: &files,
            feet: detail.has_feet().then(|| self.feet_with_bones(opened)).flatten(),
            recording: recording
                .map(|(result, remarks)| osim_view::html::recording(&result, &remarks, self.words)),
        };
        osim_view::html::entry_of_inspected_model(shown, detail, self.words)
    }

    /// The feet of a model, with the bones whose meshes are available.
    fn feet_with_bones(&self, opened: &OpenModel) -> Option<ModelFeet> {
        let path = opened.name().to_path();
        let mut feet = ModelFeet::for_page(opened.name(), opened, &self.inspector.options.selection)?;
        feet.add_bones(&opened.model, &path, None, &Disk);
        Some(feet)
    }
}

/// The text about all models of a survey: one text for each model, or one table of all models.
pub struct SurveyText {
    words: Words,
    layout: Layout,
    is_first: bool,
    /// Whether the text under a table names the option that shows all models in full.
    names_full: bool,
    /// The table of inspected models; `None` if each model has a text of its own.
    models: Option<ModelsTable>,
    /// The table of findings about all models; `None` if each model has a text of its own.
    library: Option<LibraryTable>,
}

impl SurveyText {
    /// The text for a front end that cannot show several models in full: no option for that is named.
    pub fn without_full(self) -> Self {
        Self { names_full: false, ..self }
    }

    /// Adds the model that the user named `name`. Returns the text about it, which is empty if all models are in one table.
    pub fn add(&mut self, name: &str, surveyed: &SurveyedModel) -> String {
        match (surveyed, &mut self.models, &mut self.library) {
            (SurveyedModel::Inspected(inspected, counts), Some(table), _) => {
                table.add(inspected, counts.unwrap_or_default());
            }
            (SurveyedModel::Inspected(inspected, _), None, _) => {
                let gap = if std::mem::take(&mut self.is_first) { "" } else { "\n" };
                return format!("{gap}{}", inspection::text(inspected, self.words, self.layout));
            }
            (SurveyedModel::Checked(check_result, written), _, Some(table)) => {
                table.add(check_result);
                if written.as_ref().is_some_and(|written| !written.starts_with(NOTHING_WRITTEN)) {
                    table.written += 1;
                }
            }
            (SurveyedModel::Checked(check_result, written), _, None) => {
                let mut text = check::text(check_result, self.words, self.layout);
                text.extend(written.as_ref().map(|written| format!("{written}\n")));
                return text;
            }
            (SurveyedModel::Failed(failure), ..) => self.add_failed(name, failure.code),
            (SurveyedModel::WithoutContacts, _, library) => {
                library.iter_mut().for_each(|table| table.add_without_contacts(name));
            }
        }
        String::new()
    }

    fn add_failed(&mut self, name: &str, code: &str) {
        self.models.iter_mut().for_each(|table| table.add_failed(name, code));
        self.library.iter_mut().for_each(|table| table.add_failed(name, code));
    }

    /// The table of all models; an empty text if each model has a text of its own.
    pub fn end(self) -> String {
        let Layout { columns, colour, .. } = self.layout;
        let models = self.models.map(|table| table.text(columns, self.words, colour, self.names_full));
        let library = self.library.map(|table| table.text(self.words, self.layout));
        models.or(library).unwrap_or_default()
    }
}
