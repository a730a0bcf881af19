//! A model with a planned change, as an object of Python.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use osim_inspect::CheckResult;
use osim_library::report_page::{Words, entry_of_change};
use osim_library::run::{PlannedModel, WrittenOutput};
use osim_library::{LoadedModel, ModelSource};
use osim_model::FileId;
use osim_model::messages::Verb;
use osim_planning::{PreparedChange, prepare};
use osim_requests::Request;
use osim_requests::options::OutputOptions;
use osim_requests::spell::Python as PythonWords;
use osim_view::html::{Columns, DeferredParts, DetailLevel, Page, PageHead};
use osim_view::report::json::PlanRecord;
use osim_view::report::plan as plan_text;
use pyo3::prelude::*;
use pyo3::pybacked::PyBackedBytes;
use pyo3::types::{PyBytes, PyDict, PyList};
use serde_json::{Map, Value};

use crate::calls_into_rust::{dictionary, request_fields, without_gil};
use crate::files::{Memory, RequestFiles};
use crate::problem::Problem;

/// Spells options and calls in messages as Python does.
pub(crate) static PYTHON_SPELLING: Words = &PythonWords;

/// The JSON of a check of a model, and for each finding the request that corrects the model.
type CheckAndRequests<'py> = (Bound<'py, PyAny>, Vec<Option<String>>);

/// A model with the change that is planned for it: everything that is known of it, and its writing.
#[pyclass(frozen, module = "osim_contact_scale._native")]
pub(crate) struct Planned {
    model: PlannedModel,
    path: PathBuf,
    /// Fields of the request.
    fields: Map<String, Value>,
    /// Files that were read beside the model.
    beside: Memory,
}

/// Plans a change of one model. `fields` are those of its request; `memory` has the bytes of what has no file, by name.
#[pyfunction]
pub(crate) fn plan(
    py: Python<'_>,
    fields: &Bound<'_, PyDict>,
    memory: BTreeMap<PathBuf, PyBackedBytes>,
    with_disk: bool,
) -> PyResult<Planned> {
    let fields = request_fields(fields)?;
    without_gil(py, move || {
        let files = RequestFiles::from_python(&memory, with_disk);
        let change = prepare(Request::from_map(fields.clone())?, &files)?;
        let [path] = change.models.as_slice() else {
            return Err(Problem::general("RequestError", "usage", "expected one model"));
        };
        let path = path.clone();
        let loaded = load(&path, &change, &files)?;
        let model = PlannedModel::new(&path, loaded, change, &files, &PythonWords)?;
        Ok(Planned { model, path, fields, beside: files.read.into_inner() })
    })
}

/// The output options in `fields`, checked as a request without other fields.
fn checked_output(mut fields: Map<String, Value>) -> Result<OutputOptions, Problem> {
    fields.insert("models".to_owned(), "model.osim".into());
    match Request::read(Verb::Remove, fields)? {
        Request::Remove(request) => Ok(request.output),
        other => Err(Problem::defect(format!("a request for {}", other.verb().name()))),
    }
}

impl Planned {
    /// Refuses a change in place that would apply the same factor twice. The plan could not know that the change is in place.
    fn check_in_place(&self, output: &OutputOptions) -> Result<(), Problem> {
        if !output.in_place || output.force {
            return Ok(());
        }
        let mut fields = self.fields.clone();
        fields.insert("in_place".to_owned(), true.into());
        let files = RequestFiles::new(self.beside.clone(), false);
        let change = prepare(Request::from_map(fields)?, &files)?;
        Ok(change.plan(&self.model.opened, &files).map(|_| ())?)
    }
}

/// Reads the model at `path` from memory, or else from the disk.
fn load(path: &Path, change: &PreparedChange, files: &RequestFiles) -> Result<LoadedModel, Problem> {
    Ok(match files.memory.get(path) {
        Some(bytes) => LoadedModel::in_memory(path, bytes.clone(), &change.set_files, files)?,
        None if path.is_dir() => {
            let folder = path.display();
            let message = format!(
                "{folder} is a folder: name one model, or change all in it by ocs.many(\"rescale\", folder, ...)"
            );
            return Err(Problem::general("RequestError", "usage", message));
        }
        None => LoadedModel::read_with_memory(&ModelSource::file(path), &change.set_files, &files.memory)?,
    })
}

#[pymethods]
impl Planned {
    /// The plan as the JSON of the command has it.
    fn record<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        dictionary(py, &PlanRecord::new(&self.model.plan, &self.model.opened.model, &self.path, None, None))
    }

    /// The plan as the command prints it.
    fn text(&self) -> String {
        plan_text::text(&self.model.plan, self.model.opened.name(), "nothing written yet", None)
    }

    /// The changes as a unified diff; `output` is how the new model is called in it.
    fn diff(&self, py: Python<'_>, output: Option<String>) -> PyResult<String> {
        without_gil(py, || {
            let opened = &self.model.opened;
            let each = self.model.results()?.into_iter().map(|(file, bytes)| {
                let old_name = opened.name_of(file);
                let new_name = output.as_deref().filter(|_| file == FileId::MAIN).unwrap_or(old_name);
                plan_text::unified_diff(opened.model.file(file).bytes(), &bytes, old_name, new_name)
            });
            Ok(each.collect())
        })
    }

    /// The bytes of each file that changes, the model first, with its name.
    fn results<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyList>> {
        let results = without_gil(py, || Ok(self.model.results()?))?;
        let opened = &self.model.opened;
        let each = results.iter().map(|(file, bytes)| (opened.name_of(*file), PyBytes::new(py, bytes)));
        PyList::new(py, each.collect::<Vec<_>>())
    }

    /// The bytes of the model before the change.
    fn old<'py>(&self, py: Python<'py>) -> Bound<'py, PyBytes> {
        PyBytes::new(py, self.model.opened.model.file(FileId::MAIN).bytes())
    }

    /// The bytes of every file that was read, by name: from these the same plan can be made without a disk.
    fn read<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let files = PyDict::new(py);
        let beside = self.beside.iter().map(|(path, bytes)| (path.as_path(), bytes.as_slice()));
        let opened = &self.model.opened;
        let companions = opened.files().skip(1).map(|(name, bytes)| (Path::new(name), bytes));
        let model = opened.files().take(1).map(|(_, bytes)| (self.path.as_path(), bytes));
        for (path, bytes) in beside.chain(companions).chain(model) {
            files.set_item(path, PyBytes::new(py, bytes))?;
        }
        Ok(files)
    }

    /// The masses of the bodies of the model, kg, by their component paths.
    fn masses(&self) -> BTreeMap<String, f64> {
        let bodies = self.model.opened.model.bodies().iter();
        bodies.filter_map(|body| Some((body.path.clone(), body.mass_kg().ok()?))).collect()
    }

    /// Checks of the model before the change and after it, each as the JSON of the command `check`, and for each finding the request
    /// that corrects it.
    fn checked<'py>(&self, py: Python<'py>) -> PyResult<Vec<CheckAndRequests<'py>>> {
        let both = without_gil(py, || {
            let both = self.model.show(&PythonWords, false, |changed| changed.before_after)?;
            let Some(both) = both else { return Ok(Vec::new()) };
            let after = both.after.map(|(_, found)| found);
            Ok(std::iter::once(both.before.1).chain(after).collect::<Vec<_>>())
        })?;
        both.iter().map(|found| Ok((dictionary(py, found)?, remedies(found)))).collect()
    }

    /// The page of a report about this change, as HTML; `call` is what was called, for those who want to do it again.
    fn page(&self, py: Python<'_>, verb: &str, call: String) -> PyResult<String> {
        without_gil(py, || {
            let detail = DetailLevel::for_models(1);
            let entry = self.model.show(&PythonWords, detail.has_feet(), |mut changed| {
                let both = changed.before_after.take();
                both.map(|both| entry_of_change(&changed, &both, detail, PYTHON_SPELLING))
            })?;
            let verb = Verb::ALL.iter().copied().find(|known| known.name() == verb).unwrap_or(Verb::Set);
            let model = Some(self.model.opened.name().to_string());
            let head = PageHead { verb, model, columns: Columns::Changes, call };
            let mut page = Page::new(head, DeferredParts::<String>::default(), PYTHON_SPELLING);
            entry.into_iter().for_each(|entry| page.add(entry));
            let mut bytes = Vec::new();
            page.finish(&mut bytes).map_err(Problem::defect)?;
            String::from_utf8(bytes).map_err(Problem::defect)
        })
    }

    /// Writes the files, as the fields of an output say. Returns their names, and remarks about them.
    fn write(
        &self,
        py: Python<'_>,
        fields: &Bound<'_, PyDict>,
    ) -> PyResult<(Vec<PathBuf>, Vec<PathBuf>, Vec<String>)> {
        let output = request_fields(fields)?;
        without_gil(py, || {
            let output = checked_output(output)?;
            self.check_in_place(&output)?;
            let (written, remarks) = self.model.write(&output)?;
            Ok(match written {
                WrittenOutput::Files { paths, kept } => (paths, kept, remarks),
                _ => (Vec::new(), Vec::new(), remarks),
            })
        })
    }
}

/// For each finding of a check: the requests that correct the model, in order, as a JSON list; `None` if no request corrects it.
pub(crate) fn remedies(found: &CheckResult) -> Vec<Option<String>> {
    let steps_to = |finding| {
        let steps: Vec<String> = found.steps_to(finding).iter().map(Request::to_json).collect();
        (!steps.is_empty()).then(|| format!("[{}]", steps.join(",")))
    };
    found.findings.iter().map(steps_to).collect()
}
