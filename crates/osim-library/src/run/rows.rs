//! Makes a task of a run from each row of a table.
//!
//! All rows are read before the first file is written, and all wrong rows are reported at once.

use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use osim_model::files::Failure;
use osim_model::messages::{Input, Phrase, Verb, phrase, shown_path};
use osim_planning::{RowFault, RowRequest, Table};
use osim_requests::BatchRequest;
use osim_requests::options::OutputOptions;

use crate::paths::{refuse_file_as_folder, similar_file};
use crate::run::request::RunRequest;
use crate::run::summary_lines::summary_columns;
use crate::run::task::{JobSettings, ResultDestination, Task};
use crate::{LibraryFault, ModelSource, OrdinaryFiles, Result, resolved};

/// The rows of a table after all of them were checked.
pub enum CheckedRows {
    /// All rows are right. The run has a task for each row.
    Run(RunRequest),
    /// Some rows are wrong, so no model is changed. There is a failure for each wrong row.
    Invalid(Vec<Failure>),
}

/// Reads and checks the rows of a table.
pub struct RowReader<'r> {
    request: &'r BatchRequest,
}

impl<'r> RowReader<'r> {
    /// A reader with the options of `request`.
    ///
    /// # Errors
    /// An option of the call makes sense for one model only, or the folder of the results is a file.
    pub fn new(request: &'r BatchRequest) -> Result<Self> {
        if request.output.output.is_some() || request.output.geometry_output.is_some() {
            return Err(LibraryFault::new(phrase![
                "{} is for one model: give the rows a column 'output', or write all into a folder with {}";
                Input::Output, Input::OutputDir.with_placeholder("DIR")
            ]));
        }
        request.output.output_dir.as_deref().map_or(Ok(()), refuse_file_as_folder)?;
        Ok(Self { request })
    }

    /// Reads all rows of `table` (CSV). Messages call the table `name`; relative paths in it begin in `folder`. No model is opened yet.
    ///
    /// No result may replace the file that is the `manifest` of the request: `None` for a table in memory.
    ///
    /// # Errors
    /// The bytes are not a table with a column `model`, or the table has no rows.
    pub fn read(&self, table: &[u8], name: &str, folder: &Path) -> Result<CheckedRows> {
        let Self { request } = *self;
        // Paths are shown without `./` before them.
        let folder = if folder == Path::new(".") { Path::new("") } else { folder };
        // A caller with a table in memory has its own way to keep columns.
        let keeps_others = request.manifest.is_some();
        let mut table = Table::read(table, folder, keeps_others)
            .map_err(|fault| LibraryFault::new(fault).with_context(name))?;
        table.yes.clone_from(&request.answers.yes);
        let others = table.unmarked_user_columns();
        let columns = summary_columns()?;
        if let Some(taken) = others.iter().find(|other| columns.iter().any(|column| column == *other)) {
            return Err(LibraryFault::new(format!(
                "{name}: the summary has a column '{taken}' of its own: let the name of yours begin with #"
            )));
        }
        let remark =
            format!("{name}: these columns are not options, so a summary keeps them: {}", others.join(", "));
        let remarks = if others.is_empty() { Vec::new() } else { vec![remark] };
        let rows = TableRows {
            table,
            call_output: &request.output,
            writable_folder: (!request.allow_outside)
                .then(|| WritableFolder::of_folder(request.output.output_dir.as_deref().unwrap_or(folder))),
        };
        let (tasks, wrong) = rows.tasks_and_failures(name);
        if !wrong.is_empty() {
            return Ok(CheckedRows::Invalid(wrong));
        }
        if tasks.is_empty() {
            let why = format!("{name}: no rows below the first one, which names the columns");
            return Err(LibraryFault::new(why));
        }
        let extra_files = request.manifest.iter().cloned().collect();
        let force = request.output.force;
        let request = RunRequest { extra_files, remarks, force, ..RunRequest::new(Verb::Batch, tasks) };
        Ok(CheckedRows::Run(request))
    }
}

/// The settings of rows by their text. Rows that differ only in model and output share one value.
type SharedSettings = HashMap<String, Arc<JobSettings>>;

/// A table of models whose rows become the tasks of a run.
struct TableRows<'r> {
    table: Table,
    /// The output options of the call, for rows without an output.
    call_output: &'r OutputOptions,
    /// The folder that rows may write into; `None` allows every folder.
    writable_folder: Option<WritableFolder>,
}

impl TableRows<'_> {
    /// A task for each row that is right, and a failure for each other row of the table `name`.
    fn tasks_and_failures(&self, name: &str) -> (Vec<Task>, Vec<Failure>) {
        let (mut tasks, mut wrong, mut shared) = (Vec::new(), Vec::new(), SharedSettings::new());
        for (row, read) in self.table.requests(self.call_output, &OrdinaryFiles) {
            match read.and_then(|read| self.make_task(&read, &mut shared)) {
                Ok(task) => tasks.push(task),
                Err(fault) => wrong.push(self.table.failure(name, row, &fault)),
            }
        }
        (tasks, wrong)
    }

    /// The task of one row, after all checks.
    fn make_task(&self, row: &RowRequest, shared: &mut SharedSettings) -> Result<Task, RowFault> {
        let column = self.table.model_column();
        if row.model.is_dir() {
            return Err(RowFault::of(column, "a folder, expected one model per row"));
        }
        if !row.model.is_file() {
            let why =
                if row.model.exists() { "this is not an ordinary file" } else { "there is no such file" };
            let model = similar_file(&row.model).filter(|_| !row.model.exists());
            let hint = model.map(|path| format!(": did you mean {}?", path.display())).unwrap_or_default();
            return Err(RowFault::of(column, format!("{why}: {}{hint}", row.model.display())));
        }
        let settings = self.settings(row, shared)?;
        let source = ModelSource { named: false, ..ModelSource::file(&row.model) };
        let task = Task::new(source, &row.output, settings);
        if let Some(folder) = &self.writable_folder {
            folder.check(&task, &row.output, self.call_output).map_err(|(input, message)| {
                RowFault::of(self.table.header_of(input).unwrap_or(column), message)
            })?;
        }
        Ok(Task { row: usize::try_from(row.line).ok(), user_columns: row.user_columns.clone(), ..task })
    }

    /// The settings of a row, shared with rows that have equal ones.
    fn settings(&self, row: &RowRequest, shared: &mut SharedSettings) -> Result<Arc<JobSettings>, RowFault> {
        let key = row.settings();
        if let Some(settings) = shared.get(&key) {
            return Ok(Arc::clone(settings));
        }
        let change = self.table.prepare(row, &OrdinaryFiles)?;
        let settings = Arc::new(JobSettings::new(Arc::new(change), &row.output));
        shared.insert(key, Arc::clone(&settings));
        Ok(settings)
    }
}

/// The folder that the rows of a table may write into. A table often comes from somebody else, and its cells must not reach all files
/// of the user.
struct WritableFolder {
    folder: PathBuf,
    /// The path without links, `.` and `..`.
    real: PathBuf,
}

impl WritableFolder {
    /// `folder` as the one that the rows of a table may write into, with everything in it.
    fn of_folder(folder: &Path) -> Self {
        Self { folder: folder.to_owned(), real: resolved(folder) }
    }

    /// Checks the files that a task writes. The output options of its table row are `row`, those of the call are `call`. A new
    /// result beside its model is always allowed; a result that replaces a file is allowed where the call allows it.
    ///
    /// # Errors
    /// The first file that is outside the folder, with the column that names it.
    fn check(&self, task: &Task, row: &OutputOptions, call: &OutputOptions) -> Result<(), (Input, Phrase)> {
        let changes_model = matches!(task.destination, ResultDestination::InPlace);
        let replaces = row.force && !call.force;
        if !(task.output_is_named || changes_model || replaces) {
            return Ok(());
        }
        let column = |own: Input, is_named: bool| match () {
            () if changes_model => Input::InPlace,
            () if is_named => own,
            () if task.output_is_named => Input::OutputDir,
            () => Input::Force,
        };
        let output = task.output().map(|path| (column(Input::Output, row.output.is_some()), path));
        let is_named = row.geometry_output.is_some();
        let geometry =
            task.geometry_output.as_deref().map(|path| (column(Input::GeometryOutput, is_named), path));
        output.into_iter().chain(geometry).try_for_each(|(column, path)| {
            if resolved(path).starts_with(&self.real) {
                return Ok(());
            }
            let folder = if self.folder == Path::new("") { Path::new(".") } else { &self.folder };
            let does = if column == Input::Force { "replace files" } else { "write" };
            let place = format!("{} is outside the folder {}", shown_path(path), shown_path(folder));
            let text = format!("{place}: if rows may {does} there, allow it with ");
            Err((column, phrase![text, Input::AllowOutside]))
        })
    }
}
