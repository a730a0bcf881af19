//! Functions for Python that compute results and change no model.

use std::collections::BTreeMap;
use std::path::PathBuf;

use osim_library::MotionFiles;
use osim_model::Property;
use osim_planning::{NextModels, design_sheet, find_presets, run_drop_test, run_fit, run_motion};
use osim_requests::Request;
use osim_requests::spell::Python as PythonWords;
use osim_view::report::explain::{Alphabet, answer};
use osim_view::report::layout::WIDTH;
use osim_view::report::messages::mass_mismatch;
use osim_view::report::reproduce::{ReproductionRecord, fig1_text, reproduction_text};
use osim_view::report::results::{
    DropRecord, FitRecord, MotionCells, MotionRecord, PresetRecord, design_sheet_text, drop_text, fit_text,
    motion_columns, motion_text, preset_text,
};
use pyo3::prelude::*;
use pyo3::pybacked::PyBackedBytes;
use pyo3::types::PyDict;
use serde_json::{Map, Value};

use crate::calls_into_rust::{dictionary, request_fields, without_gil};
use crate::files::RequestFiles;
use crate::problem::Problem;

/// A record as a dictionary in the form of its JSON, and its text for people.
type Answer<'py> = (Bound<'py, PyAny>, String);

/// Reads a request of the verb `$verb` from a dictionary.
macro_rules! request {
    ($verb:ident, $fields:expr) => {
        match Request::from_map($fields)? {
            Request::$verb(request) => *request,
            other => return Err($crate::calls::unexpected_request(&other)),
        }
    };
}
pub(crate) use request;

pub(crate) fn unexpected_request(request: &Request) -> Problem {
    Problem::defect(format!("a request for {} came where none is taken", request.verb().name()))
}

/// `design` without a model: the quantities, and their text.
#[pyfunction]
pub(crate) fn calculate<'py>(py: Python<'py>, fields: &Bound<'py, PyDict>) -> PyResult<Answer<'py>> {
    let fields = request_fields(fields)?;
    let sheet = without_gil(py, || Ok(design_sheet(&request!(Design, fields))?))?;
    Ok((dictionary(py, &sheet)?, design_sheet_text(&sheet, None)))
}

/// `drop-test`: the drop, its text, and remarks about masses.
#[pyfunction]
pub(crate) fn drop_test<'py>(
    py: Python<'py>,
    fields: &Bound<'py, PyDict>,
    memory: BTreeMap<PathBuf, PyBackedBytes>,
) -> PyResult<(Bound<'py, PyAny>, String, Vec<String>)> {
    let fields = request_fields(fields)?;
    let drop = without_gil(py, || {
        Ok(run_drop_test(&request!(DropTest, fields), &RequestFiles::from_python(&memory, true))?)
    })?;
    let mismatches = drop.mismatches.iter();
    let remarks = mismatches.map(|(name, mismatch)| mass_mismatch(name, mismatch, &PythonWords)).collect();
    Ok((dictionary(py, &DropRecord(&drop))?, drop_text(&drop, None), remarks))
}

/// `motion`: the contacts along a recording as a dictionary, the same as text, and as a table: a list of cells for each column.
#[pyfunction]
pub(crate) fn motion<'py>(
    py: Python<'py>,
    fields: &Bound<'py, PyDict>,
    memory: BTreeMap<PathBuf, PyBackedBytes>,
) -> PyResult<(Bound<'py, PyAny>, String, Bound<'py, PyDict>)> {
    let fields = request_fields(fields)?;
    let (result, remarks) = without_gil(py, || {
        let request = request!(Motion, fields);
        let files = MotionFiles::of(&request)?;
        let given = RequestFiles::from_python(&memory, true);
        let result = run_motion(&request, &given)?;
        files.write(&result, &NextModels::new(&request, &result, &given)?)?;
        let remarks = result.remarks(&request);
        Ok((result, remarks))
    })?;
    let columns = PyDict::new(py);
    for column in motion_columns(&result) {
        match column.cells {
            MotionCells::Numbers(numbers) => columns.set_item(column.name, numbers)?,
            MotionCells::Texts(texts) => columns.set_item(column.name, texts)?,
            MotionCells::Flags(flags) => columns.set_item(column.name, flags)?,
        }
    }
    let record = MotionRecord::new(&result, &remarks, &PythonWords);
    Ok((dictionary(py, &record)?, motion_text(&result, &remarks, &PythonWords, None), columns))
}

/// `fit`: the parameters found, and their text.
#[pyfunction]
pub(crate) fn fit<'py>(
    py: Python<'py>,
    fields: &Bound<'py, PyDict>,
    memory: BTreeMap<PathBuf, PyBackedBytes>,
) -> PyResult<Answer<'py>> {
    let fields = request_fields(fields)?;
    let fit =
        without_gil(py, || Ok(run_fit(&request!(Fit, fields), &RequestFiles::from_python(&memory, true))?))?;
    Ok((dictionary(py, &FitRecord::from(&fit))?, fit_text(&fit, &PythonWords, None)))
}

/// `presets`: each with its text.
#[pyfunction]
pub(crate) fn presets<'py>(py: Python<'py>, fields: &Bound<'py, PyDict>) -> PyResult<Vec<Answer<'py>>> {
    let fields = request_fields(fields)?;
    let presets = without_gil(py, || {
        Ok(find_presets(&request!(Presets, fields), &RequestFiles::from_python(&BTreeMap::new(), true))?)
    })?;
    presets
        .iter()
        .map(|preset| Ok((dictionary(py, &PresetRecord::from(preset))?, preset_text(preset, None))))
        .collect()
}

/// `explain`: the text for people, and its content as one JSON object per line.
#[pyfunction]
pub(crate) fn explain(py: Python<'_>, fields: &Bound<'_, PyDict>) -> PyResult<(String, String)> {
    let fields = request_fields(fields)?;
    without_gil(py, || {
        let explanation = |format: Option<&str>| {
            let mut fields: Map<String, Value> = fields.clone();
            fields.extend(format.map(|format| ("format".to_owned(), format.into())));
            let request = request!(Explain, fields);
            answer(&request, Alphabet::Unicode, &PythonWords, WIDTH)
                .map_err(|unknown| Problem::general("RequestError", "usage", unknown.message(&PythonWords)))
        };
        Ok((explanation(None)?, explanation(Some("json"))?))
    })
}

/// `reproduce`: what the paper prints and what its equations give, and its text.
#[pyfunction]
pub(crate) fn reproduce<'py>(py: Python<'py>) -> PyResult<Answer<'py>> {
    let record = without_gil(py, || Ok(ReproductionRecord::new(&PythonWords)?))?;
    let text = format!("{}\n{}", reproduction_text(&record, None), fig1_text(&record, None));
    Ok((dictionary(py, &record)?, text))
}

/// The SI unit of each property by OpenSim's name, and of `location`; "" where it has none.
#[pyfunction]
pub(crate) fn units() -> BTreeMap<&'static str, &'static str> {
    let properties = Property::changeable().map(|property| (property.as_str(), property.unit()));
    properties.chain([("location", "m")]).collect()
}
