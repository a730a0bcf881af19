//! How far a long call is, and Ctrl-C.

use std::sync::atomic::{AtomicBool, Ordering};

use osim_library::LibraryFault;
use pyo3::prelude::*;

use crate::problem::Problem;

/// Listens to Ctrl-C between two models, and calls back.
pub(crate) struct Watch {
    callback: Option<Py<PyAny>>,
    stopped: AtomicBool,
}

/// Why a long call ended early.
pub(crate) enum Stop {
    Fault(LibraryFault),
    /// An exception of Python's: of the callback, or Ctrl-C.
    Raised(PyErr),
}

impl From<LibraryFault> for Stop {
    fn from(fault: LibraryFault) -> Self {
        Self::Fault(fault)
    }
}

impl From<Stop> for Problem {
    fn from(stop: Stop) -> Self {
        match stop {
            Stop::Fault(fault) => fault.into(),
            Stop::Raised(error) => Self::raised(error),
        }
    }
}

impl Watch {
    /// `callback` is called with 1 for each model that is done, and whether it failed.
    pub(crate) fn new(callback: Option<Py<PyAny>>) -> Self {
        Self { callback, stopped: AtomicBool::new(false) }
    }

    /// Whether no further model should be begun.
    pub(crate) fn is_stopped(&self) -> bool {
        self.stopped.load(Ordering::Relaxed)
    }

    /// One more is done. To be called on the thread that Python called.
    ///
    /// # Errors
    /// Ctrl-C, or an exception of the callback: no further model is begun then.
    pub(crate) fn one_more(&self, failed: bool) -> Result<(), Stop> {
        let said = Python::attach(|py| {
            py.check_signals()?;
            self.callback.as_ref().map_or(Ok(()), |callback| callback.call1(py, (1, failed)).map(|_| ()))
        });
        said.map_err(|error| {
            self.stopped.store(true, Ordering::Relaxed);
            Stop::Raised(error)
        })
    }
}
