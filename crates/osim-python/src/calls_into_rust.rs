//! Calls from Python into Rust: without the GIL, and without ending the interpreter on a panic.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, PoisonError};

use osim_library::{LibraryFault, work_in_order};
use osim_requests::RequestFault;
use pyo3::exceptions::{PyException, PyOverflowError};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use serde::Serialize;
use serde_json::{Map, Value};

use crate::problem::Problem;

/// Does `work` while other threads of Python run. A panic (a defect of this program) becomes an exception of Python.
///
/// # Errors
/// The problem of `work`, or Ctrl-C.
pub(crate) fn without_gil<T: Send>(
    py: Python<'_>,
    work: impl FnOnce() -> Result<T, Problem> + Send,
) -> PyResult<T> {
    let result = py.detach(|| catch_unwind(AssertUnwindSafe(work)));
    let result = result.unwrap_or_else(|panic| {
        let text = panic.downcast_ref::<&str>().map(|text| (*text).to_owned());
        let text = text.or_else(|| panic.downcast_ref::<String>().cloned());
        Err(Problem::defect(text.unwrap_or_else(|| "no message".to_owned())))
    });
    // Ctrl-C that came meanwhile goes before any result.
    py.check_signals()?;
    result.map_err(|problem| problem.into_error(py))
}

/// The fields of a request as JSON, from a dictionary of Python.
///
/// # Errors
/// A value that JSON cannot hold, such as a number that is too large.
pub(crate) fn request_fields(fields: &Bound<'_, PyDict>) -> PyResult<Map<String, Value>> {
    let mut all = Map::new();
    for (name, value) in fields {
        let name: String = name.extract()?;
        let value =
            pythonize::depythonize(&value).map_err(|error| value_fault(&name, &value, error.into()))?;
        all.insert(name, value);
    }
    Ok(all)
}

/// The exception that no request can hold `value` as the field `name`.
fn value_fault(name: &str, value: &Bound<'_, PyAny>, error: PyErr) -> PyErr {
    let py = value.py();
    if !error.is_instance_of::<PyException>(py) {
        return error;
    }
    let text = error.value(py).to_string();
    let too_large = error.is_instance_of::<PyOverflowError>(py) || text.contains("out of range");
    let reason =
        if too_large { "a whole number is too large, expected less than 1e19".to_owned() } else { text };
    // The digits of a large number would say nothing, and Python refuses to write thousands of them.
    let value = if too_large { "...".to_owned() } else { value.to_string() };
    Problem::from(RequestFault::BadValue { field: name.to_owned(), value, reason }).into_error(py)
}

/// A record as a dictionary of Python, with the same numbers as in its JSON.
///
/// # Errors
/// None in practice: records are made of texts, numbers and lists.
pub(crate) fn dictionary<'py>(py: Python<'py>, record: &impl Serialize) -> PyResult<Bound<'py, PyAny>> {
    Ok(pythonize::pythonize(py, record)?)
}

/// A panic on one of `threads` threads, for the test that no panic ends an interpreter or makes it wait for ever.
#[pyfunction]
#[allow(clippy::panic, reason = "that is what it is for")]
pub(crate) fn defect(py: Python<'_>, threads: usize) -> PyResult<()> {
    let work = |_: &usize| panic!("asked for by a test");
    without_gil(py, || Ok(work_in_order(&[0; 10], threads, work, |_, ()| Ok::<(), LibraryFault>(()))?))
}

// How far a long call is, and Ctrl-C.

/// Reports the progress of a run to a callback of Python, and stops the run on Ctrl-C.
pub(crate) struct ProgressCallback {
    callback: Option<Py<PyAny>>,
    stopped: AtomicBool,
    /// The exception after which no further model should be begun: of the callback, or Ctrl-C.
    raised: Mutex<Option<PyErr>>,
}

impl ProgressCallback {
    /// For each finished model, `callback` is called with 1 and whether the model failed.
    pub(crate) fn new(callback: Option<Py<PyAny>>) -> Self {
        Self { callback, stopped: AtomicBool::new(false), raised: Mutex::default() }
    }

    /// Whether no further model should be begun.
    pub(crate) fn is_stopped(&self) -> bool {
        self.stopped.load(Ordering::Relaxed)
    }

    /// Reports that one more model is finished. Only the thread that Python called may call this function. An exception waits for
    /// [`check_stopped`](Self::check_stopped), so that results of other threads are still written into the summary.
    pub(crate) fn model_done(&self, failed: bool) {
        if self.is_stopped() {
            return;
        }
        let outcome = Python::attach(|py| {
            py.check_signals()?;
            self.callback.as_ref().map_or(Ok(()), |callback| callback.call1(py, (1, failed)).map(|_| ()))
        });
        if let Err(error) = outcome {
            self.stopped.store(true, Ordering::Relaxed);
            *self.raised.lock().unwrap_or_else(PoisonError::into_inner) = Some(error);
        }
    }

    /// Fails if an exception ended the work early. The function has to be called after all results are in the summary.
    ///
    /// # Errors
    /// Ctrl-C, or the exception of the callback.
    pub(crate) fn check_stopped(&self) -> Result<(), Problem> {
        let raised = self.raised.lock().unwrap_or_else(PoisonError::into_inner).take();
        raised.map_or(Ok(()), |error| Err(Problem::raised(error)))
    }
}
