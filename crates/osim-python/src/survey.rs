//! `inspect` and `check` of many models, on all processors.

use std::collections::BTreeMap;
use std::path::PathBuf;

use osim_library::report_page::ReportPage;
use osim_library::{LibraryFault, ModelSource, Sources, Survey, SurveyedModel};
use osim_model::messages::terminal_safe;
use osim_planning::Inspector;
use osim_requests::{Jobs, Request};
use osim_view::report::extent::{Extent, Layout};
use osim_view::report::json::FailureRecord;
use pyo3::prelude::*;
use pyo3::pybacked::PyBackedBytes;
use pyo3::types::PyDict;

use crate::calls_into_rust::{ProgressCallback, dictionary, request_fields, without_gil};
use crate::files::RequestFiles;
use crate::planned_change::{PYTHON_SPELLING, remedies};
use crate::problem::Problem;

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
