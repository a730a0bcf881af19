//! Changes many models in one run: all models of a request, or the models in the rows of a table.

use std::path::PathBuf;

use osim_library::report_page::{ReportPage, entry_of_change, entry_of_record};
use osim_library::run::{
    ChangedModel, CheckedRows, JsonRecord, ModelDetail, ModelOutcome, Record, RowReader, Run, RunFrontEnd,
    RunRequest, Task,
};
use osim_library::{LibraryFault, SweepRun, folder_of};
use osim_model::files::{Failure, Files};
use osim_planning::prepare;
use osim_requests::Request;
use osim_requests::options::RunOptions;
use osim_requests::spell::Speller;
use osim_view::html::{DetailLevel, Entry};
use osim_view::report::json::FailureRecord;
use pyo3::prelude::*;
use pyo3::pybacked::PyBackedBytes;
use pyo3::types::PyDict;

use crate::calls::request;
use crate::calls_into_rust::{ProgressCallback, dictionary, request_fields, without_gil};
use crate::files::RequestFiles;
use crate::planned_change::PYTHON_SPELLING;
use crate::problem::Problem;

/// Makes the entry of each model on the report page, if the request names a page.
struct PageEntryMaker<'r> {
    watch: &'r ProgressCallback,
    detail: Option<DetailLevel>,
}

impl RunFrontEnd for PageEntryMaker<'_> {
    type Shown = Option<Entry>;

    fn dialect(&self) -> &dyn Speller {
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
    let mut page = ReportPage::begin_for_run(&run, options, call, PYTHON_SPELLING)?;
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
