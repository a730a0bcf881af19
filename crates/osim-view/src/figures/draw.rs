//! The figure that a request asks for, and its numbers as a table.

use contact_plots::{Datum, Drawing, Paper, PlotError};
use osim_inspect::series::{Body, HeatRequest};
use osim_model::files::Failure;
use osim_model::messages::{Input, Phrase, phrase, shortest, terminal_safe};
use osim_planning::{HeatTable, ModelFeet, MotionResult, cell};
use osim_requests::{AxesChoice, FigureOptions, PlotKind, PlotRequest, Positive, Span, no_fig1};

use crate::figures::axes::{Axes, failure, units};
use crate::figures::curves::{drops, force, loops, state};
use crate::figures::feet::feet;
use crate::figures::heat::{heat, table};
use crate::figures::motion::motion;
use crate::figures::paper::{fig_c5, fig4};

/// A figure of `bodies`, or of a table, as `request` asks for it, before it is put on paper.
///
/// # Errors
/// What a body weighs is not known where the figure needs it, there are too many or too few of them, or the figure does not
/// have what the request limits or names.
pub fn draw(
    request: &PlotRequest,
    bodies: &[Body],
    of_table: Option<&HeatTable>,
) -> Result<Drawing, Failure> {
    let title = request.looks.title.as_deref();
    let mut drawing = match of_table {
        Some(of_table) => table(of_table, title)?,
        None => drawing_of_bodies(request, bodies, title)?,
    };
    if let (Drawing::HeatMap(map), Some(range)) = (&mut drawing, request.heat.value_range) {
        map.value_axis.limits = Some(range.ends());
    }
    finished(drawing, &request.looks).map_err(|error| not_drawn(error, bodies))
}

fn drawing_of_bodies(
    request: &PlotRequest,
    bodies: &[Body],
    title: Option<&str>,
) -> Result<Drawing, Failure> {
    let wanted = request.axes.map(|axes| match axes {
        AxesChoice::Real => Axes::Real,
        _ => Axes::Dimensionless,
    });
    let units = units(bodies, wanted);
    let height = request.fall.height.get();
    let duration = request.fall.duration.map(Positive::get);
    let limits = request.looks.x_range.map(Span::ends);
    let drawn = match request.kind {
        Some(PlotKind::State) => state(bodies, units, limits, title)?,
        Some(PlotKind::Loop) => loops(bodies, units, height, title)?,
        Some(PlotKind::Drop) => {
            drops(bodies, height, &height.describe("m", "sphere radii"), duration, title)?
        }
        Some(PlotKind::Sweep) => {
            let (stiffness, dissipation) = (request.heat.stiffness, request.heat.dissipation);
            let values = |grid: osim_requests::Grid| move |now| grid.values(now);
            return heat(bodies, &HeatRequest::from(request), values(stiffness), values(dissipation), title);
        }
        Some(PlotKind::Fig1) => {
            return Err(Failure::outside("Fig. 1", "plot", no_fig1()));
        }
        Some(PlotKind::Fig4) => fig4(title)?,
        Some(PlotKind::FigC5) => fig_c5(title)?,
        _ => force(bodies, units, limits, title)?,
    };
    drawn.distinct().map(Drawing::Panels).map_err(|error| not_drawn(error, bodies))
}

/// A figure with the names and limits that are wanted.
///
/// # Errors
/// It has no such curve or axis.
fn finished(mut drawing: Drawing, looks: &FigureOptions) -> Result<Drawing, PlotError> {
    drawing.rename(&looks.label)?;
    if let Some(limits) = looks.x_range.map(Span::ends) {
        drawing.limit_x(limits)?;
    }
    if let Some(limits) = looks.y_range.map(Span::ends) {
        drawing.limit_y(limits)?;
    }
    Ok(drawing)
}

/// A figure of feet as `request` asks for it.
///
/// # Errors
/// The request names curves or limits axes, which it does not have.
pub fn draw_feet(request: &PlotRequest, states: &[ModelFeet]) -> Result<Drawing, Failure> {
    let drawing = Drawing::Scene(feet(states, request.looks.title.as_deref()));
    finished(drawing, &request.looks).map_err(|error| not_drawn(error, &[]))
}

/// A figure of a motion as `request` asks for it.
///
/// # Errors
/// The request names curves or limits that it does not have.
pub fn draw_motion(request: &PlotRequest, result: &MotionResult) -> Result<Drawing, Failure> {
    let drawing = Drawing::Panels(motion(result, request.looks.title.as_deref()));
    finished(drawing, &request.looks).map_err(|error| not_drawn(error, &[]))
}

pub fn paper(looks: &FigureOptions) -> Paper {
    Paper { width_mm: looks.width.map(osim_requests::FigureWidth::get), text_pt: looks.font_size.get() }
}

/// A figure of `bodies` as an SVG document.
///
/// # Errors
/// It was not drawn: the failure says why, and a way out where there is one.
pub fn svg(drawing: &Drawing, paper: Paper, bodies: &[Body]) -> Result<String, Failure> {
    // Names of spheres are labels: what a picture cannot show would make it unreadable.
    let drawn = drawing.svg(paper).map(|svg| terminal_safe(&svg).into_owned());
    drawn.map_err(|error| not_drawn(error, bodies))
}

/// Why a figure of `bodies` was not drawn, with a way out where there is one.
pub fn not_drawn(error: PlotError, bodies: &[Body]) -> Failure {
    let why: Phrase = match error {
        PlotError::TooMany { .. } => {
            phrase![error.to_string(), ": choose with ", Input::Select.with_placeholder("GLOB")]
        }
        PlotError::NoAxis { which: "horizontal", .. } => phrase![
            error.to_string(),
            ": leave out ",
            Input::XRange,
            "; a drop is made shorter by ",
            Input::Duration,
            ", a heat map by its grid"
        ],
        error => error.to_string().into(),
    };
    failure(bodies, why)
}

/// What the columns are called: they say themselves what is in them.
const COLUMNS: [&str; 9] = ["panel", "kind", "name", "x_axis", "x", "y_axis", "y", "value_name", "value"];

/// All numbers of a figure as CSV: a row for each point of a curve, each mark, limit and cell; what one does not have is empty.
///
/// # Errors
/// The library that writes CSV did not get through, which it says.
pub fn data_csv(drawing: &Drawing) -> Result<Vec<u8>, csv::Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(COLUMNS)?;
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
