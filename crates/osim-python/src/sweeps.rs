//! `sweep`: variants of a model in a folder, and the table of what is in which.

use std::path::{Path, PathBuf};

use osim_library::{SweepFrontEnd, SweepRun};
use osim_model::files::Failure;
use osim_requests::Request;
use osim_view::report::json::FailureRecord;
use osim_view::report::results::SweepRecord;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::guard::{dictionary, fields_of, guarded};
use crate::planned::WORDS;
use crate::problem::Problem;
use crate::progress::Watch;

impl SweepFrontEnd for Watch {
    fn is_interrupted(&self) -> bool {
        self.is_stopped()
    }

    fn done(&self, _failed: bool) {
        // Called on the threads that do the work, where Python must not be called: it would hold all of them up.
    }
}

/// What a sweep did: its record, the table, and a record for each variant that could not be made.
type Swept<'py> = (Bound<'py, PyAny>, Option<PathBuf>, Vec<Bound<'py, PyAny>>);

/// Makes all variants.
#[pyfunction]
pub(crate) fn sweep<'py>(
    py: Python<'py>,
    fields: &Bound<'py, PyDict>,
    callback: Option<Py<PyAny>>,
) -> PyResult<Swept<'py>> {
    let fields = fields_of(fields)?;
    let ((record, manifest), failures) = guarded(py, || {
        let Request::Sweep(request) = Request::from_map(fields)? else {
            return Err(Problem::defect("a request for another verb".to_owned()));
        };
        let sweep = SweepRun::new(&request)?;
        sweep.check_ends()?;
        let mut failures: Vec<Failure> = Vec::new();
        if request.dry_run {
            let record = begun(&sweep, None).counted(sweep.count(), 0);
            return Ok(((serde_json::to_value(&record), None), failures));
        }
        let watch = Watch::new(callback);
        let end = sweep.run(&watch, |failure| {
            let failed = failure.is_some();
            failures.extend(failure);
            watch.one_more(failed);
        });
        watch.ended()?;
        let end = end?;
        let record = begun(&sweep, end.manifest.as_deref());
        let record = record.counted(end.made + end.earlier, end.failed).of_which_before(end.earlier);
        Ok(((serde_json::to_value(&record), end.manifest), failures))
    })?;
    let record = record.map_err(|error| Problem::defect(error.to_string()).into_error(py))?;
    let failures = failures.iter().map(|failure| dictionary(py, &FailureRecord::new(failure, WORDS)));
    Ok((dictionary(py, &record)?, manifest, failures.collect::<PyResult<_>>()?))
}

/// What is known before a model is made.
fn begun(sweep: &SweepRun<'_>, manifest: Option<&Path>) -> SweepRecord {
    let record = SweepRecord::new(sweep.model(), sweep.folder(), manifest);
    record.of_points(sweep.points(), sweep.point_file())
}
