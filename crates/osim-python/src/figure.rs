//! `plot`: a figure as SVG, PDF or PNG, and its numbers.

use std::collections::BTreeMap;
use std::path::PathBuf;

use contact_plots::{Axis, Curve, Drawing, PlotError};
use osim_library::{PendingFile, WriteMode, require_folder_of};
use osim_model::messages::Input;
use osim_requests::spell::Python as PythonWords;
use osim_requests::{Request, RequestFault};
use osim_view::figures;
use pyo3::prelude::*;
use pyo3::pybacked::PyBackedBytes;
use pyo3::types::PyDict;

use crate::calls::request;
use crate::calls_into_rust::{request_fields, without_gil};
use crate::files::RequestFiles;
use crate::problem::Problem;

/// A figure for Python.
#[pyclass(frozen, module = "osim_contact_scale._native")]
pub(crate) struct Figure {
    /// The figure as an SVG document.
    #[pyo3(get)]
    svg: String,
    /// Remarks beside the figure.
    #[pyo3(get)]
    remarks: String,
    title: String,
    /// The numbers that are drawn, as CSV.
    #[pyo3(get)]
    csv: String,
    /// For each panel in order, what is not in the numbers.
    #[pyo3(get)]
    panels: Vec<PanelLook>,
    dpi: f32,
}

/// Whether an axis is logarithmic, and its limits if it has fixed limits.
type AxisLook = (bool, Option<(f64, f64)>);

/// A panel of a figure: its horizontal axis, its vertical axis, whether vertical values grow downwards, and the number of points of
/// each curve (several curves may have one name).
type PanelLook = (AxisLook, AxisLook, bool, Vec<usize>);

/// Draws the figure of a request.
#[pyfunction]
pub(crate) fn plot(
    py: Python<'_>,
    fields: &Bound<'_, PyDict>,
    memory: BTreeMap<PathBuf, PyBackedBytes>,
) -> PyResult<Figure> {
    let fields = request_fields(fields)?;
    without_gil(py, move || {
        let files = RequestFiles::from_python(&memory, true);
        let request = request!(Plot, fields);
        let (drawing, bodies, remarks) = figures::draw_request(&request, &files, &PythonWords)?;
        let svg = figures::svg(&drawing, figures::paper_of(&request.looks), &bodies)?;
        let csv = figures::data_csv(&drawing).map_err(Problem::defect)?;
        let csv = String::from_utf8(csv).map_err(Problem::defect)?;
        Ok(Figure {
            svg,
            remarks,
            title: drawing.title().to_owned(),
            csv,
            panels: panel_looks(&drawing),
            dpi: f32::from(request.looks.dpi.get()),
        })
    })
}

fn panel_looks(drawing: &Drawing) -> Vec<PanelLook> {
    let axis = |axis: &Axis| (axis.logarithmic, axis.limits);
    match drawing {
        Drawing::Panels(figure) => {
            let panels = figure.panels.iter();
            let points = |curves: &[Curve]| curves.iter().map(|curve| curve.points.len()).collect();
            panels.map(|panel| (axis(&panel.x), axis(&panel.y), false, points(&panel.curves))).collect()
        }
        Drawing::HeatMap(map) => vec![(axis(&map.x_axis), axis(&map.y_axis), false, Vec::new())],
        Drawing::Scene(scene) => {
            let views = scene.blocks.iter().flat_map(|block| &block.views);
            views.map(|view| ((false, None), (false, None), view.y_down, Vec::new())).collect()
        }
        _ => Vec::new(),
    }
}

#[pymethods]
impl Figure {
    /// The figure as a PDF document.
    fn pdf(&self, py: Python<'_>) -> PyResult<Vec<u8>> {
        without_gil(py, || contact_plots::pdf(&self.svg, &self.title).map_err(Problem::defect))
    }

    /// The figure as a PNG picture, with so many pixels to the inch as the request says.
    fn png(&self, py: Python<'_>) -> PyResult<Vec<u8>> {
        without_gil(py, || {
            contact_plots::png(&self.svg, self.dpi).map_err(|error| match error {
                PlotError::TooManyPixels { .. } => {
                    RequestFault::refused(Input::Dpi, error.to_string()).into()
                }
                error => Problem::defect(error),
            })
        })
    }
}

// Files that Python asks for: figures and pages.

/// Writes a file: whole, or not at all. What is there is replaced only with `force`.
#[pyfunction]
pub(crate) fn write_file(py: Python<'_>, path: PathBuf, bytes: PyBackedBytes, force: bool) -> PyResult<()> {
    without_gil(py, || {
        require_folder_of(&path, None)?;
        let mode = if force { WriteMode::Replace } else { WriteMode::New };
        Ok(PendingFile::new(&path, &bytes, None, mode)?.commit()?)
    })
}
