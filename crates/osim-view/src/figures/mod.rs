//! Figures about contacts, as a request describes them, and their numbers as a table. The crate `contact_plots` draws them.
//!
//! [`osim_inspect::series`] computes the points; here they get titles, labels and limits.
//!
//! ```
//! use contact_plots::{Drawing, Paper};
//!
//! // The paper's Fig. 4 in one column of a journal.
//! let figure = Drawing::Panels(osim_view::figures::paper::fig4(None).expect("Table 1 is complete"));
//! let svg = figure.svg(Paper { width_mm: Some(85.0), ..Paper::default() })?;
//! assert!(svg.starts_with("<svg") && svg.contains("width=\"85mm\""));
//! # Ok::<(), contact_plots::PlotError>(())
//! ```

mod axes;
mod curves;
mod feet;
mod heat;
mod motion;
pub mod paper;

use contact_plots::{Datum, Drawing, Paper, PlotError};
use osim_inspect::series::ContactBody;
use osim_model::files::{Failure, Files};
use osim_model::messages::{Dialect, Input, Phrase, phrase, shortest, terminal_safe};
use osim_planning::{HeatTable, cell, plot_bodies, plot_feet, plot_motion};
use osim_requests::{FigureOptions, PlotKind, PlotRequest, Positive, RequestError, Span, no_fig1};

use crate::figures::axes::{Result, plot_failure};
use crate::figures::feet::feet_remarks;
use crate::figures::heat::table_figure;
use crate::figures::paper::{fig_c5, fig4};

pub use axes::{units_for, weights_in_words};
pub(crate) use curves::count_above_axis;
pub use curves::{contact_force, contact_state, drops, impact_loops, indentations, loops};
pub use feet::feet;
pub(crate) use feet::names_of_missing_meshes;
pub use heat::heat;
pub(crate) use motion::motion;

/// Reads and draws what a request asks for: the figure, the bodies that it shows, and remarks on them.
///
/// # Errors
/// A model or a table cannot be read, or the figure cannot be drawn.
pub fn draw_request(
    request: &PlotRequest,
    files: &dyn Files,
    dialect: &dyn Dialect,
) -> Result<(Drawing, Vec<ContactBody>, String), RequestError> {
    request.check_models()?;
    let title = request.looks.title.as_deref();
    let (drawing, remarks) = match request.kind {
        Some(PlotKind::Feet) => {
            let states = plot_feet(request, files)?;
            (Drawing::Scene(feet(&states, title)), feet_remarks(&states, dialect))
        }
        Some(PlotKind::Motion) => {
            (Drawing::Panels(motion(&plot_motion(request, files)?, title)), String::new())
        }
        _ => {
            let read = |path| HeatTable::read(path, &request.heat, files);
            let table = request.heat.table.as_deref().map(read).transpose()?;
            let bodies = plot_bodies(request, files)?;
            let drawing = draw(request, &bodies, table.as_ref())?;
            let remarks = weights_in_words(&bodies, dialect);
            return Ok((drawing, bodies, remarks));
        }
    };
    let drawing = with_looks(drawing, &request.looks).map_err(|error| failure_of_plot(error, &[]))?;
    Ok((drawing, Vec::new(), remarks))
}

/// Draws the figure that `request` describes, of `bodies` or of a table. The size of the paper is not yet known.
///
/// # Errors
/// The weight of a body is not known and needed, there are too many or too few bodies, or the figure does not have the axes or curves
/// that the request limits or names.
pub fn draw(request: &PlotRequest, bodies: &[ContactBody], table: Option<&HeatTable>) -> Result<Drawing> {
    let title = request.looks.title.as_deref();
    let mut drawing = match table {
        Some(table) => table_figure(table, title)?,
        None => drawing_of_bodies(request, bodies, title)?,
    };
    if let (Drawing::HeatMap(map), Some(range)) = (&mut drawing, request.heat.value_range) {
        map.value_axis.limits = Some(range.ends());
    }
    with_looks(drawing, &request.looks).map_err(|error| failure_of_plot(error, bodies))
}

fn drawing_of_bodies(request: &PlotRequest, bodies: &[ContactBody], title: Option<&str>) -> Result<Drawing> {
    let units = units_for(bodies, request.axes);
    let height = request.fall.height;
    let duration = request.fall.duration.map(Positive::get);
    let limits = request.looks.x_range.map(Span::ends);
    let drawn = match request.kind {
        Some(PlotKind::State) => contact_state(bodies, units, limits, title)?,
        Some(PlotKind::Loop) => loops(bodies, units, height, title)?,
        Some(PlotKind::Drop) => {
            drops(bodies, height, &height.describe("m", "sphere radii"), duration, title)?
        }
        Some(PlotKind::Sweep) => {
            let (stiffness, dissipation) = (request.heat.stiffness, request.heat.dissipation);
            let values = |grid: osim_requests::Grid| move |now| grid.values(now);
            let (quantity, fall) = (request.heat.quantity, &request.fall);
            return heat(bodies, quantity, fall, values(stiffness), values(dissipation), title);
        }
        Some(PlotKind::Fig1) => return Err(Failure::outside("Fig. 1", "plot", no_fig1())),
        Some(PlotKind::Fig4) => fig4(title)?,
        Some(PlotKind::FigC5) => fig_c5(title)?,
        _ => contact_force(bodies, units, limits, title)?,
    };
    drawn.distinct().map(Drawing::Panels).map_err(|error| failure_of_plot(error, bodies))
}

/// The drawing with the names of curves and the limits of axes from the request.
///
/// # Errors
/// It has no such curve or axis.
fn with_looks(mut drawing: Drawing, looks: &FigureOptions) -> Result<Drawing, PlotError> {
    drawing.rename(&looks.label)?;
    if let Some(limits) = looks.x_range.map(Span::ends) {
        drawing.limit_x(limits)?;
    }
    if let Some(limits) = looks.y_range.map(Span::ends) {
        drawing.limit_y(limits)?;
    }
    Ok(drawing)
}

pub fn paper_of(looks: &FigureOptions) -> Paper {
    Paper { width_mm: looks.width.map(osim_requests::FigureWidth::get), text_pt: looks.font_size.get() }
}

/// A figure of `bodies` as an SVG document.
///
/// # Errors
/// The figure cannot be drawn.
pub fn svg(drawing: &Drawing, paper: Paper, bodies: &[ContactBody]) -> Result<String> {
    // Control characters in names of spheres would make the SVG unreadable.
    let drawn = drawing.svg(paper).map(|svg| terminal_safe(&svg).into_owned());
    drawn.map_err(|error| failure_of_plot(error, bodies))
}

/// The failure that a figure of `bodies` could not be drawn, with advice.
pub fn failure_of_plot(error: PlotError, bodies: &[ContactBody]) -> Failure {
    let why: Phrase = match error {
        PlotError::TooMany { .. } => {
            phrase![error.to_string(), ": choose with ", Input::Select.with_placeholder("GLOB")]
        }
        PlotError::NoAxis { which: "horizontal", .. } => phrase![
            "{}: leave out {}; a drop is made shorter by {}, a heat map by its grid";
            error.to_string(), Input::XRange, Input::Duration
        ],
        error => error.to_string().into(),
    };
    plot_failure(bodies, why)
}

/// Names of the columns in the data of a figure.
const DATA_COLUMNS: [&str; 9] =
    ["panel", "kind", "name", "x_axis", "x", "y_axis", "y", "value_name", "value"];

/// All numbers of a figure as CSV: a row for each point of a curve, each mark, limit and cell. Cells without a meaning in a row are empty.
///
/// # Errors
/// The library that writes CSV fails.
pub fn data_csv(drawing: &Drawing) -> Result<Vec<u8>, csv::Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(DATA_COLUMNS)?;
    for datum in drawing.data() {
        let Datum { panel, kind, name, x_axis, x, y_axis, y, value_name, value, .. } = datum;
        let number = |value: Option<f64>| value.map(shortest).unwrap_or_default();
        writer.write_record([
            cell(&panel).into_owned(),
            kind.to_owned(),
            cell(&name).into_owned(),
            x_axis,
            number(x),
            y_axis,
            number(y),
            value_name,
            number(value),
        ])?;
    }
    writer.into_inner().map_err(|error| error.into_error().into())
}
