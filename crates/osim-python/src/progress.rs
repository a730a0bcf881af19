//! How far a long call is, and Ctrl-C.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, PoisonError};

use pyo3::prelude::*;

use crate::problem::Problem;

/// Listens to Ctrl-C between two models, and calls back.
pub(crate) struct Watch {
    callback: Option<Py<PyAny>>,
    stopped: AtomicBool,
    /// Why no further model should be begun: an exception of the callback, or Ctrl-C.
    raised: Mutex<Option<PyErr>>,
}

impl Watch {
    /// `callback` is called with 1 for each model that is done, and whether it failed.
    pub(crate) fn new(callback: Option<Py<PyAny>>) -> Self {
        Self { callback, stopped: AtomicBool::new(false), raised: Mutex::default() }
    }

    /// Whether no further model should be begun.
    pub(crate) fn is_stopped(&self) -> bool {
        self.stopped.load(Ordering::Relaxed)
    }

    /// One more is done. To be called on the thread that Python called. An exception waits for [`ended`](Self::ended), so that
    /// what other threads have done meanwhile is still written down.
    pub(crate) fn one_more(&self, failed: bool) {
        if self.is_stopped() {
            return;
        }
        let said = Python::attach(|py| {
            py.check_signals()?;
            self.callback.as_ref().map_or(Ok(()), |callback| callback.call1(py, (1, failed)).map(|_| ()))
        });
        if let Err(error) = said {
            self.stopped.store(true, Ordering::Relaxed);
            *self.raised.lock().unwrap_or_else(PoisonError::into_inner) = Some(error);
        }
    }

    /// What ended the work early, if anything did. To be asked when all that was done is written down.
    ///
    /// # Errors
    /// Ctrl-C, or the exception of the callback.
    pub(crate) fn ended(&self) -> Result<(), Problem> {
        let raised = self.raised.lock().unwrap_or_else(PoisonError::into_inner).take();
        raised.map_or(Ok(()), |error| Err(Problem::raised(error)))
    }
}
