//! Many models in one call, on all processors: `inspect` and `check` of them, and runs that change them, of a request or of the rows in a
//! table.

use std::collections::BTreeMap;
use std::path::PathBuf;

use osim_library::report_page::{ReportPage, entry_of_change, entry_of_record};
use osim_library::run::{
    ChangedModel, CheckedRows, JsonRecord, ModelDetail, ModelOutcome, Record, RowReader, Run, RunFrontEnd,
    RunRequest, Task,
};
use osim_library::{LibraryFault, ModelSource, Sources, Survey, SurveyedModel, SweepRun, folder_of};
use osim_model::files::{Failure, Files};
use osim_model::messages::terminal_safe;
use osim_planning::{Inspector, prepare};
use osim_requests::options::RunOptions;
use osim_requests::spell::FrontEnd;
use osim_requests::{Jobs, Request};
use osim_view::html::{DetailLevel, Entry};
use osim_view::report::extent::{Extent, Layout};
use osim_view::report::json::FailureRecord;
use pyo3::prelude::*;
use pyo3::pybacked::PyBackedBytes;
use pyo3::types::PyDict;

use crate::calls::request;
use crate::calls_into_rust::{ProgressCallback, dictionary, request_fields, without_gil};
use crate::files::RequestFiles;
use crate::planned_change::{PYTHON_SPELLING, remedies};
use crate::problem::Problem;

/// Makes the entry of each model on the report page, if the request names a page.
struct PageEntryMaker<'r> {
    watch: &'r ProgressCallback,
    detail: Option<DetailLevel>,
}

impl RunFrontEnd for PageEntryMaker<'_> {
    type Shown = Option<Entry>;

    fn dialect(&self) -> &dyn FrontEnd {
        PYTHON_SPELLING
    }

    fn detail(&self) -> ModelDetail {
        self.detail
            .map_or(ModelDetail::ResultOnly, |detail| ModelDetail::BeforeAfter { feet: detail.has_feet() })
    }

    fn show(&self, mut changed: ChangedModel<'_>) -> Option<Entry> {
        let before_after = changed.before_after.take()?;
        Some(entry_of_change(&changed, &before_after, self.detail?, PYTHON_SPELLING))
    }

    fn is_interrupted(&self) -> bool {
        self.watch.is_stopped()
    }

    fn task_done(&self, _failed: bool) {
        // Called on the threads that do the work, where Python must not be called: it would hold all of them up.
    }
}

/// The lines of a run's summary, and remarks about the run.
type Lines<'py> = (Vec<Bound<'py, PyAny>>, Vec<String>);

/// Changes all models of a request: a line of a summary for each.
#[pyfunction]
pub(crate) fn change_many<'py>(
    py: Python<'py>,
    fields: &Bound<'py, PyDict>,
    call: String,
    callback: Option<Py<PyAny>>,
) -> PyResult<Lines<'py>> {
    let fields = request_fields(fields)?;
    let (records, remarks) = without_gil(py, || {
        let request = Request::from_map(fields)?;
        let options = request.run_options().cloned().unwrap_or_default();
        let change = prepare(request, &RequestFiles::new([].into(), true))?;
        let request = RunRequest::for_change(change, &options)?;
        run(request, &options, call, &ProgressCallback::new(callback))
    })?;
    lines(py, records, remarks)
}

/// Does the rows of a table, given as CSV in memory, whose paths begin in the current folder; or those of the table that the
/// request names. A line of a summary for each.
#[pyfunction]
pub(crate) fn rescale_many<'py>(
    py: Python<'py>,
    fields: &Bound<'py, PyDict>,
    table: Option<PyBackedBytes>,
    call: String,
    callback: Option<Py<PyAny>>,
) -> PyResult<Lines<'py>> {
    let mut fields = request_fields(fields)?;
    if table.is_some() {
        // The request needs a name there; none of a file that is read.
        fields.insert("manifest".to_owned(), NAME_OF_TABLE.into());
    }
    let (records, remarks) = without_gil(py, || {
        let mut request = request!(Batch, fields);
        let (bytes, name, folder) = match table {
            Some(table) => {
                request.manifest = None;
                (table.to_vec(), NAME_OF_TABLE.to_owned(), PathBuf::new())
            }
            None => {
                let path = request.manifest.clone().unwrap_or_default();
                let name = path.display().to_string();
                let bytes = RequestFiles::new([].into(), true)
                    .read(&path)
                    .map_err(|error| Failure::outside(path.as_path(), "unreadable", error.to_string()))?;
                (bytes, name, folder_of(&path).to_owned())
            }
        };
        // A table that cannot be read is a wrong call; no file was to be written yet.
        let wrong = |fault: LibraryFault| Problem::general("RequestError", "usage", fault.phrase());
        match RowReader::new(&request)?.read(&bytes, &name, &folder).map_err(wrong)? {
            CheckedRows::Run(rows) => run(rows, &request.run, call, &ProgressCallback::new(callback)),
            CheckedRows::Invalid(rows) => Err(Problem::wrong_rows(&rows)),
        }
    })?;
    lines(py, records, remarks)
}

/// The name of a table without a file in messages.
const NAME_OF_TABLE: &str = "table";

/// Changes models by a request and writes the results.
pub(crate) fn run(
    request: RunRequest,
    options: &RunOptions,
    call: String,
    watch: &ProgressCallback,
) -> Result<(Vec<JsonRecord>, Vec<String>), Problem> {
    let mut run = Run::new(request, options)?;
    run.read_previous()?;
    let detail = DetailLevel::for_models(run.request.tasks.len() + run.request.failures.len());
    let mut page = ReportPage::for_run(&run, options, call, PYTHON_SPELLING)?;
    run.begin()?;
    let mut remarks = run.request.remarks.clone();
    remarks.extend(run.kept_files.iter().cloned());
    let mut records: Vec<JsonRecord> =
        run.request.failures.iter().map(|failure| Record::of_failure(failure).into()).collect();
    let reporter = PageEntryMaker { watch, detail: options.report.as_ref().map(|_| detail) };
    let report = |_: &Task, outcome: ModelOutcome<Option<Entry>>| {
        let failed = outcome.failure.is_some();
        if let Some(page) = &mut page {
            let shown = outcome.shown.flatten();
            page.add(shown.unwrap_or_else(|| entry_of_record(&outcome.record, outcome.earlier)));
        }
        records.push(outcome.record.into());
        watch.model_done(failed);
    };
    let outcome = run.do_tasks(&reporter, report);
    // What was done before Ctrl-C is in the summary, so that a run can go on. A summary that cannot be written does not hide Ctrl-C.
    let finished = run.finish();
    watch.check_stopped()?;
    outcome?;
    finished?;
    page.map_or(Ok(()), ReportPage::finish)?;
    Ok((records, remarks))
}

/// The records of a run as lines for Python.
pub(crate) fn lines(py: Python<'_>, records: Vec<JsonRecord>, remarks: Vec<String>) -> PyResult<Lines<'_>> {
    let records = records.iter().map(|record| dictionary(py, record)).collect::<PyResult<_>>()?;
    Ok((records, remarks))
}

// `sweep`: variants of a model in a folder, and the table of what is in which.

/// Results of a sweep: its record, the path of its table, and a record for each variant that could not be made.
type SweepResult<'py> = (Bound<'py, PyAny>, Option<PathBuf>, Vec<Bound<'py, PyAny>>);

/// Makes all variants of a sweep.
#[pyfunction]
pub(crate) fn sweep<'py>(
    py: Python<'py>,
    fields: &Bound<'py, PyDict>,
    callback: Option<Py<PyAny>>,
) -> PyResult<SweepResult<'py>> {
    let fields = request_fields(fields)?;
    let ((record, manifest), failures) = without_gil(py, || {
        let request = request!(Sweep, fields);
        let sweep = SweepRun::new(&request)?;
        sweep.plan.check_ends()?;
        let mut failures: Vec<Failure> = Vec::new();
        if request.dry_run {
            return Ok(((serde_json::to_value(sweep.record(None)), None), failures));
        }
        let watch = ProgressCallback::new(callback);
        // Python must not be called on the threads that do the work: it would hold all of them up.
        let end = sweep.run(
            || watch.is_stopped(),
            |_| (),
            |failure| {
                let failed = failure.is_some();
                failures.extend(failure);
                watch.model_done(failed);
            },
        );
        watch.check_stopped()?;
        let end = end?;
        Ok(((serde_json::to_value(sweep.record(Some(&end))), end.manifest), failures))
    })?;
    let record = record.map_err(|error| Problem::defect(error).into_error(py))?;
    let failures =
        failures.iter().map(|failure| dictionary(py, &FailureRecord::new(failure, PYTHON_SPELLING)));
    Ok((dictionary(py, &record)?, manifest, failures.collect::<PyResult<_>>()?))
}

/// The result for one model: its record and, for each finding, the requests that correct the model; or else the exception.
type SurveyRow<'py> = (Option<Bound<'py, PyAny>>, Vec<Option<String>>, Option<Bound<'py, PyAny>>);

/// Inspects or checks the models of a request. Returns a row for each, remarks that come before them, and the text that the command
/// prints.
#[pyfunction]
pub(crate) fn survey<'py>(
    py: Python<'py>,
    fields: &Bound<'py, PyDict>,
    memory: BTreeMap<PathBuf, PyBackedBytes>,
    jobs: Option<usize>,
    call: String,
    callback: Option<Py<PyAny>>,
) -> PyResult<(Vec<SurveyRow<'py>>, Vec<String>, String)> {
    let fields = request_fields(fields)?;
    let (rows, remarks, text) = without_gil(py, || {
        let files = RequestFiles::from_python(&memory, true);
        let request = Request::from_map(fields)?;
        let (models, inspector, report, check, full) = match &request {
            Request::Inspect(request) => (
                &request.models,
                Inspector::for_inspect(request, &files),
                &request.report,
                None,
                request.full,
            ),
            Request::Check(request) => {
                let inspector = Inspector::for_check(request, &files);
                (&request.models, inspector, &request.report, Some(&**request), request.full)
            }
            other => return Err(Problem::defect(format!("a survey for {}", other.verb().name()))),
        };
        if let Some(failure) = inspector.generic_failure() {
            return Err(failure.clone().into());
        }
        // Factors of bodies have no room in a row.
        let shows_each = matches!(&request, Request::Inspect(request) if request.from.is_some());
        let survey = Survey {
            verb: request.verb(),
            sources: &sources(models, &files),
            memory: &files.memory,
            inspector: &inspector,
            report,
            shows_each,
            check,
            layout: Layout { extent: Extent::new(full), ..Layout::default() },
            words: PYTHON_SPELLING,
        };
        // Python checked it with its own name.
        let jobs = jobs.and_then(|jobs| jobs.to_string().parse().ok());
        survey_models(&survey, jobs, call, &ProgressCallback::new(callback))
    })?;
    let rows = rows.into_iter().map(|surveyed| row_of_model(py, surveyed)).collect::<PyResult<_>>()?;
    Ok((rows, remarks, text))
}

/// The models among the paths `models`, in the same order.
fn sources(models: &[PathBuf], files: &RequestFiles) -> Sources {
    let mut sources = Sources::default();
    for path in models {
        if files.memory.contains_key(path) {
            sources.models.push(ModelSource::file(path));
        } else {
            let mut found = Sources::find(std::slice::from_ref(path), None);
            sources.models.append(&mut found.models);
            sources.failures.append(&mut found.failures);
            sources.remarks.append(&mut found.remarks);
        }
    }
    sources
}

/// Inspects or checks all models. Returns the results (first those of models that could not be listed), remarks, and the text. Lines
/// of the text are not broken, because the cell of a notebook can be scrolled.
fn survey_models(
    survey: &Survey<'_>,
    jobs: Option<Jobs>,
    call: String,
    watch: &ProgressCallback,
) -> Result<(Vec<SurveyedModel>, Vec<String>, String), Problem> {
    let mut page = survey.begin_page(call)?;
    let unlisted = survey.sources.failures.iter().cloned().map(Box::new);
    let mut rows: Vec<SurveyedModel> = unlisted.map(SurveyedModel::Failed).collect();
    let mut pieces = survey.begin_text().without_full();
    let mut text = String::new();
    let each = |name: &str, surveyed: SurveyedModel| -> Result<(), LibraryFault> {
        text.push_str(&pieces.add(name, &surveyed));
        watch.model_done(matches!(surveyed, SurveyedModel::Failed(_)));
        rows.push(surveyed);
        Ok(())
    };
    survey.run(&mut page, jobs, || watch.is_stopped(), each)?;
    watch.check_stopped()?;
    page.map_or(Ok(()), ReportPage::finish)?;
    text.push_str(&pieces.end());
    Ok((rows, survey.sources.remarks.clone(), terminal_safe(&text).into_owned()))
}

fn row_of_model(py: Python<'_>, surveyed: SurveyedModel) -> PyResult<SurveyRow<'_>> {
    Ok(match surveyed {
        SurveyedModel::Inspected(inspection, _) => (Some(dictionary(py, &*inspection)?), Vec::new(), None),
        SurveyedModel::Checked(found, _) => (Some(dictionary(py, &*found)?), remedies(&found), None),
        SurveyedModel::WithoutContacts => (None, Vec::new(), None),
        SurveyedModel::Failed(failure) => {
            let record = dictionary(py, &FailureRecord::new(&failure, PYTHON_SPELLING))?;
            let error = Problem::from(*failure).into_error(py);
            (Some(record), Vec::new(), Some(error.into_value(py).into_bound(py).into_any()))
        }
    })
}
