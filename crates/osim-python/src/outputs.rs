//! Files that Python asks for: figures and pages.

use std::path::PathBuf;

use osim_library::{Mode, Prepared, make_folder_of};
use pyo3::prelude::*;
use pyo3::pybacked::PyBackedBytes;

use crate::guard::guarded;

/// Writes a file: whole, or not at all. What is there is replaced only with `force`.
#[pyfunction]
pub(crate) fn write_file(py: Python<'_>, path: PathBuf, bytes: PyBackedBytes, force: bool) -> PyResult<()> {
    guarded(py, || {
        make_folder_of(&path)?;
        let mode = if force { Mode::Replace } else { Mode::New };
        Ok(Prepared::new(&path, &bytes, None, mode)?.commit()?)
    })
}
