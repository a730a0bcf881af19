//! Draws a figure of panels as an SVG document.

use plotters::chart::{ChartBuilder, ChartContext, LabelAreaPosition};
use plotters::coord::cartesian::Cartesian2d;
use plotters::element::{Circle, DashedPathElement, PathElement, Polygon};
use plotters::prelude::SVGBackend;
use plotters::style::Color;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use crate::axis::{Axis, Scale, Ticks};
use crate::document::{Area, MARGIN_PT, Paper, Title, document, text_allowed_in_xml};
use crate::error::PlotError;
use crate::figure::{self, Direction, Figure, Frame, Limit, Panel};
use crate::legend::{LIMIT_ROW_PT, Legend, Sample, draw_sample, limit_rows};
use crate::style::{INK, LIMIT, SHADE_COLOUR, SHADE_OPACITY, TEXT_PT, TITLE_PT, float, stroke, text, units};
use crate::text_width::cut_to_width;

/// Height of the row with a panel's title, pt.
const PANEL_TITLE_PT: f64 = 13.0;
/// Room below a panel for the tick labels and the axis label, pt.
pub(crate) const TICK_LABELS_HEIGHT_PT: f64 = 22.5;
/// Distance from the axis label beside a panel to its tick labels, pt.
pub(crate) const AXIS_NAME_DISTANCE_PT: f64 = 10.0;
/// Length of a tick, pt.
pub(crate) const TICK_LENGTH_PT: f64 = 2.2;
/// Room on the right for half of the last tick label, pt.
const RIGHT_MARGIN_PT: f64 = 5.0;
/// Distance between two panels, pt.
const PANEL_GAP_PT: f64 = 8.0;
/// The smallest width of a plot for panels side by side, pt; narrower panels are placed below each other.
const SIDE_BY_SIDE_PT: f64 = 90.0;
/// Height of the plot between the axes, divided by its width.
const PLOT_HEIGHT_OVER_WIDTH: f64 = 0.62;

type Chart<'a, 'b> = ChartContext<'a, SVGBackend<'b>, Cartesian2d<Scale, Scale>>;

/// Draws panels with one legend below them, as an SVG document.
///
/// # Errors
/// [`PlotError`]: no panel, a panel without a curve, a point that is not a finite number, or too little room on the paper.
pub fn figure(figure: &Figure, paper: Paper) -> Result<String, PlotError> {
    if figure.panels.is_empty() {
        return Err(PlotError::Empty("the figure has no panel"));
    }
    figure.panels.iter().try_for_each(Panel::check)?;
    let layout = Layout::of(figure, paper.layout_pt(figure.width));
    paper.check(figure.width, layout.beside_pt + 2.0 * MARGIN_PT + RIGHT_MARGIN_PT)?;
    let height_pt = layout.legend_top_pt() + layout.legend.height_pt() + MARGIN_PT;
    document((paper, figure.width), height_pt, &layout.title, [&figure.title, &figure.description], |root| {
        for (index, panel) in figure.panels.iter().enumerate() {
            layout.draw_panel(root, panel, index)?;
        }
        layout.legend.draw(root, (MARGIN_PT + layout.beside_pt, layout.legend_top_pt()), draw_sample)
    })
}

/// Positions of all parts of a figure.
struct Layout {
    title: Title,
    columns: usize,
    rows: usize,
    panel_pt: (f64, f64),
    /// Room for tick labels and the axis label left of each panel, pt.
    beside_pt: f64,
    /// Height of the room for the panel's title, pt.
    title_pt: f64,
    /// Room for the names of limits above a panel, pt.
    limits_pt: f64,
    legend: Legend<Sample>,
    letters: bool,
}

impl Layout {
    /// The layout of `figure` in this width, pt.
    fn of(figure: &Figure, width: f64) -> Self {
        let frames: Vec<Frame<'_>> = figure.panels.iter().map(Frame::of).collect();
        let room = width - 2.0 * MARGIN_PT;
        let beside_pt = AXIS_NAME_DISTANCE_PT
            + 3.0 * TICK_LENGTH_PT
            + frames.iter().map(|frame| frame.y_ticks.width_pt()).fold(8.0, f64::max);
        let panel_width = |columns: usize| (room - PANEL_GAP_PT * float(columns - 1)) / float(columns);
        let wanted = figure.columns.clamp(1, figure.panels.len());
        let is_wide = |&columns: &usize| panel_width(columns) - beside_pt >= SIDE_BY_SIDE_PT;
        let columns = (1..=wanted).rev().find(is_wide).unwrap_or(1);
        let panel_width = panel_width(columns);
        let plot_width = panel_width - beside_pt - RIGHT_MARGIN_PT;
        let letters = figure.panels.len() > 1;
        let titled = letters || figure.panels.iter().any(|panel| !panel.title.is_empty());
        let title_pt = if titled { PANEL_TITLE_PT } else { 0.0 };
        let panels = figure.panels.iter().zip(&frames);
        let rows_of_limits = panels.map(|(panel, frame)| limit_rows(panel, frame, plot_width).len()).max();
        let limits_pt = LIMIT_ROW_PT * float(rows_of_limits.unwrap_or(0));
        let plot_height = PLOT_HEIGHT_OVER_WIDTH * (panel_width - beside_pt);
        Self {
            title: Title::new(&figure.title, width),
            columns,
            rows: figure.panels.len().div_ceil(columns),
            panel_pt: (panel_width, title_pt + limits_pt + plot_height + TICK_LABELS_HEIGHT_PT),
            beside_pt,
            title_pt,
            limits_pt,
            legend: Legend::of(figure, room - beside_pt),
            letters,
        }
    }

    fn legend_top_pt(&self) -> f64 {
        self.title.bottom_pt() + float(self.rows) * (self.panel_pt.1 + PANEL_GAP_PT) - PANEL_GAP_PT
    }

    fn draw_panel(&self, root: &Area<'_>, panel: &Panel, index: usize) -> Result<(), PlotError> {
        let (width, height) = self.panel_pt;
        let left = MARGIN_PT + float(index % self.columns) * (width + PANEL_GAP_PT);
        let top = self.title.bottom_pt() + float(index / self.columns) * (height + PANEL_GAP_PT);
        let area = root.clone().shrink((units(left), units(top)), (units(width), units(height)));
        self.draw_title(&area, panel, index)?;
        let frame = Frame::of(panel);
        let mut chart = ChartBuilder::on(&area)
            .margin_top(units(self.title_pt + self.limits_pt))
            .margin_right(units(RIGHT_MARGIN_PT))
            .set_label_area_size(LabelAreaPosition::Left, units(self.beside_pt))
            .set_label_area_size(LabelAreaPosition::Bottom, units(TICK_LABELS_HEIGHT_PT))
            .build_cartesian_2d(
                Scale::new(frame.x, frame.x_ticks.at()),
                Scale::new(frame.y, frame.y_ticks.at()),
            )
            .map_err(PlotError::drawing)?;
        draw_areas(&mut chart, panel, &frame)?;
        let ticks = (&frame.x_ticks, &frame.y_ticks);
        draw_axes(root, &mut chart, (&panel.x, &panel.y), ticks, (frame.x.0, frame.y.0))?;
        for limit in &panel.limits {
            draw_limit(&mut chart, &frame, limit)?;
        }
        draw_curves(&mut chart, panel, &frame)?;
        self.draw_limit_names(&area, panel, &frame)
    }

    fn draw_title(&self, area: &Area<'_>, panel: &Panel, index: usize) -> Result<(), PlotError> {
        let words = |line: &str, size: f64, at: (i32, i32)| {
            let style = text(size).pos(Pos::new(HPos::Left, VPos::Top));
            area.draw_text(line, &style, at).map_err(PlotError::drawing)
        };
        let room = self.panel_pt.0 - self.beside_pt - 10.0;
        let shown = cut_to_width(&text_allowed_in_xml(&panel.title), TEXT_PT, room);
        if !shown.is_empty() {
            words(&shown, TEXT_PT, (units(self.beside_pt), units(2.0)))?;
        }
        if self.letters { words(&letter(index), TITLE_PT, (0, units(1.2))) } else { Ok(()) }
    }

    /// Draws the names of vertical limits above the panel.
    fn draw_limit_names(&self, area: &Area<'_>, panel: &Panel, frame: &Frame<'_>) -> Result<(), PlotError> {
        let plot_width = self.panel_pt.0 - self.beside_pt - RIGHT_MARGIN_PT;
        for (row, limits) in limit_rows(panel, frame, plot_width).into_iter().enumerate() {
            for (limit, along) in limits {
                let y = self.title_pt + self.limits_pt - LIMIT_ROW_PT * (float(row) + 0.5) + 0.6;
                let style = text(TEXT_PT).color(&LIMIT).pos(Pos::new(HPos::Center, VPos::Center));
                let at = (units(self.beside_pt + along), units(y));
                area.draw_text(&text_allowed_in_xml(&limit.label), &style, at).map_err(PlotError::drawing)?;
            }
        }
        Ok(())
    }
}

/// The letter of a panel: A, B, C, …
pub(crate) fn letter(index: usize) -> String {
    let letter = u32::try_from(index).ok().and_then(|index| char::from_u32(u32::from('A') + index));
    letter.map(String::from).unwrap_or_default()
}

/// Draws the axes with their labels and ticks; `(left, bottom)` is where they meet. The library draws no ticks without labels.
pub(crate) fn draw_axes(
    root: &Area<'_>,
    chart: &mut Chart<'_, '_>,
    (x_axis, y_axis): (&Axis, &Axis),
    (x_ticks, y_ticks): (&Ticks, &Ticks),
    (left, bottom): (f64, f64),
) -> Result<(), PlotError> {
    chart
        .configure_mesh()
        .disable_mesh()
        .axis_style(stroke(INK, 0.6))
        .set_all_tick_mark_size(units(TICK_LENGTH_PT))
        .label_style(text(TEXT_PT))
        .axis_desc_style(text(TEXT_PT))
        .x_desc(text_allowed_in_xml(&x_axis.label))
        .y_desc(text_allowed_in_xml(&y_axis.label))
        .x_label_formatter(&|at| x_ticks.label(*at).to_owned())
        .y_label_formatter(&|at| y_ticks.label(*at).to_owned())
        .draw()
        .map_err(PlotError::drawing)?;
    let tick = units(0.55 * TICK_LENGTH_PT);
    let along_x = x_ticks.minor.iter().map(|&at| {
        let (x, y) = chart.backend_coord(&(at, bottom));
        vec![(x, y), (x, y + tick)]
    });
    let along_y = y_ticks.minor.iter().map(|&at| {
        let (x, y) = chart.backend_coord(&(left, at));
        vec![(x - tick, y), (x, y)]
    });
    for line in along_x.chain(along_y) {
        root.draw(&PathElement::new(line, stroke(INK, 0.4))).map_err(PlotError::drawing)?;
    }
    Ok(())
}

fn draw_areas(chart: &mut Chart<'_, '_>, panel: &Panel, frame: &Frame<'_>) -> Result<(), PlotError> {
    for area in &panel.areas {
        let (Some(first), Some(last)) = (area.points.first(), area.points.last()) else { continue };
        let mut outline = area.points.clone();
        outline.extend([(last.0, 0.0), (first.0, 0.0)]);
        if let Some(inside) = figure::clip_area(&frame.places(&outline), frame.x, frame.y) {
            let shade = Polygon::new(inside, SHADE_COLOUR.mix(SHADE_OPACITY).filled());
            chart.draw_series([shade]).map_err(PlotError::drawing)?;
        }
    }
    Ok(())
}

fn draw_curves(chart: &mut Chart<'_, '_>, panel: &Panel, frame: &Frame<'_>) -> Result<(), PlotError> {
    for curve in &panel.curves {
        let style = curve.look.stroke();
        let parts = figure::clip_polyline(&frame.places(&curve.points), frame.x, frame.y).into_iter();
        match curve.look.dash.lengths_pt() {
            None => chart.draw_series(parts.map(|part| PathElement::new(part, style))).map(|_| ()),
            Some((dash, gap)) => {
                let dashed = parts.map(|part| DashedPathElement::new(part, units(dash), units(gap), style));
                chart.draw_series(dashed).map(|_| ())
            }
        }
        .map_err(PlotError::drawing)?;
    }
    for mark in panel.marks.iter().filter(|mark| frame.contains_point(mark.at)) {
        let dot = Circle::new(frame.place(mark.at), units(2.2), mark.look.rgb().filled());
        chart.draw_series([dot]).map_err(PlotError::drawing)?;
    }
    Ok(())
}

fn draw_limit(chart: &mut Chart<'_, '_>, frame: &Frame<'_>, limit: &Limit) -> Result<(), PlotError> {
    let Some(at) = frame.limit(limit) else { return Ok(()) };
    let line = match limit.direction {
        Direction::Vertical => [(at, frame.y.0), (at, frame.y.1)],
        Direction::Horizontal => [(frame.x.0, at), (frame.x.1, at)],
    };
    let dashed = DashedPathElement::new(line, units(2.0), units(1.6), stroke(LIMIT, 0.6));
    chart.draw_series([dashed]).map(|_| ()).map_err(PlotError::drawing)
}
