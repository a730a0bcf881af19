//! Drawing a figure of panels.

use plotters::chart::{ChartBuilder, ChartContext, LabelAreaPosition};
use plotters::coord::Shift;
use plotters::coord::cartesian::Cartesian2d;
use plotters::element::{Circle, DashedPathElement, PathElement, Polygon};
use plotters::prelude::{DrawingArea, IntoDrawingArea, SVGBackend};
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{Color, RGBColor};

use crate::axis::{Scale, Ticks};
use crate::error::PlotError;
use crate::figure::{Direction, Figure, Limit, Panel};
use crate::legend::Legend;
use crate::style::{
    INK, LIMIT, SHADE, SHADE_OPACITY, TEXT_PT, TITLE_PT, fitting, stroke, text, units, width_pt,
};
use crate::svg::{finished, printable};

pub(crate) const MARGIN_PT: f64 = 4.0;
pub(crate) const TITLE_ROW_PT: f64 = 13.0;
/// Tick labels and the axis's name below a panel.
pub(crate) const BELOW_PT: f64 = 22.5;
/// From the axis's name beside a panel to its tick labels.
pub(crate) const NAME_PT: f64 = 10.0;
pub(crate) const TICK_PT: f64 = 2.2;
const LIMIT_ROW_PT: f64 = 8.5;
const GAP_PT: f64 = 8.0;
/// Height over width of what is drawn between the axes.
const ASPECT: f64 = 0.62;

pub(crate) type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
type Chart<'a, 'b> = ChartContext<'a, SVGBackend<'b>, Cartesian2d<Scale, Scale>>;

/// Draws panels with one legend below them, as an SVG document.
///
/// # Errors
/// [`PlotError`]: no panel, a panel without a curve, or a point that is not a finite number.
pub fn figure(figure: &Figure) -> Result<String, PlotError> {
    if figure.panels.is_empty() {
        return Err(PlotError::Empty { what: "the figure has no panel" });
    }
    for panel in &figure.panels {
        panel.check()?;
    }
    let layout = Layout::of(figure);
    document(layout.size_pt, &figure.title, &figure.description, |root| {
        for (index, panel) in figure.panels.iter().enumerate() {
            layout.draw_panel(root, panel, index)?;
        }
        layout.legend.draw(root, (layout.left_pt(), layout.legend_top_pt()))
    })
}

/// An SVG document of a size in points with its title drawn at the top; `draw` draws the rest.
pub(crate) fn document(
    (width_pt, height_pt): (f64, f64),
    title: &str,
    description: &str,
    draw: impl FnOnce(&Area<'_>) -> Result<(), PlotError>,
) -> Result<String, PlotError> {
    let size = (units(width_pt).unsigned_abs(), units(height_pt).unsigned_abs());
    let mut drawn = String::new();
    {
        let root = SVGBackend::with_string(&mut drawn, size).into_drawing_area();
        root.fill(&RGBColor(255, 255, 255)).map_err(PlotError::drawing)?;
        let shown = fitting(&printable(title), TITLE_PT, width_pt - 2.0 * MARGIN_PT);
        let style = text(TITLE_PT).pos(Pos::new(HPos::Center, VPos::Top));
        root.draw_text(&shown, &style, (units(width_pt / 2.0), units(MARGIN_PT)))
            .map_err(PlotError::drawing)?;
        draw(&root)?;
        root.present().map_err(PlotError::drawing)?;
    }
    finished(&drawn, size, title, description)
}

/// Where everything of a figure goes.
struct Layout {
    size_pt: (f64, f64),
    columns: usize,
    panel_pt: (f64, f64),
    /// Room for tick labels and the axis's name left of each panel.
    beside_pt: f64,
    /// Room for the panel's title.
    title_pt: f64,
    /// Room for the names of limits.
    limits_pt: f64,
    legend: Legend,
    legend_top: f64,
    letters: bool,
}

impl Layout {
    fn of(figure: &Figure) -> Self {
        let width = figure.width.pt();
        let columns = figure.columns.clamp(1, figure.panels.len());
        let room = width - 2.0 * MARGIN_PT;
        let panel_width = (room - GAP_PT * float(columns - 1)) / float(columns);
        let longest = figure.panels.iter().map(|panel| width_pt(&y_ticks(panel).longest(), TEXT_PT));
        let beside_pt = NAME_PT + 3.0 * TICK_PT + longest.fold(8.0, f64::max);
        let letters = figure.panels.len() > 1;
        let titled = letters || figure.panels.iter().any(|panel| !panel.title.is_empty());
        let title_pt = if titled { TITLE_ROW_PT } else { 0.0 };
        let rows_of_limits = figure.panels.iter().map(|p| limit_rows(p, panel_width - beside_pt).len()).max();
        let limits_pt = LIMIT_ROW_PT * float(rows_of_limits.unwrap_or(0));
        let plot_height = ASPECT * (panel_width - beside_pt);
        let panel_height = title_pt + limits_pt + plot_height + BELOW_PT;
        let rows = figure.panels.len().div_ceil(columns);
        let legend = Legend::of(figure, room - beside_pt);
        let legend_top = MARGIN_PT + TITLE_ROW_PT + float(rows) * (panel_height + GAP_PT) - GAP_PT;
        let height = legend_top + legend.height_pt() + MARGIN_PT;
        Self {
            size_pt: (width, height),
            columns,
            panel_pt: (panel_width, panel_height),
            beside_pt,
            title_pt,
            limits_pt,
            legend,
            legend_top,
            letters,
        }
    }

    fn left_pt(&self) -> f64 {
        MARGIN_PT + self.beside_pt
    }

    fn legend_top_pt(&self) -> f64 {
        self.legend_top
    }

    fn draw_panel(&self, root: &Area<'_>, panel: &Panel, index: usize) -> Result<(), PlotError> {
        let (width, height) = self.panel_pt;
        let left = MARGIN_PT + float(index % self.columns) * (width + GAP_PT);
        let top = MARGIN_PT + TITLE_ROW_PT + float(index / self.columns) * (height + GAP_PT);
        let area = root.clone().shrink((units(left), units(top)), (units(width), units(height)));
        self.draw_title(&area, panel, index)?;
        // Room on the right for half of the last tick's label.
        let mut chart = ChartBuilder::on(&area)
            .margin_top(units(self.title_pt + self.limits_pt))
            .margin_right(units(5.0))
            .set_label_area_size(LabelAreaPosition::Left, units(self.beside_pt))
            .set_label_area_size(LabelAreaPosition::Bottom, units(BELOW_PT))
            .build_cartesian_2d(
                Scale::new(x_span(panel), x_ticks(panel).at),
                Scale::new(y_span(panel), y_ticks(panel).at),
            )
            .map_err(PlotError::drawing)?;
        draw_areas(&mut chart, panel)?;
        draw_axes(&mut chart, panel)?;
        for limit in &panel.limits {
            draw_limit(&mut chart, panel, limit)?;
        }
        draw_curves(&mut chart, panel)?;
        self.draw_limit_names(&area, panel)
    }

    fn draw_title(&self, area: &Area<'_>, panel: &Panel, index: usize) -> Result<(), PlotError> {
        let shown = fitting(&printable(&panel.title), TEXT_PT, self.panel_pt.0 - self.beside_pt - 10.0);
        let style = text(TEXT_PT).pos(Pos::new(HPos::Left, VPos::Top));
        let at = (units(self.beside_pt), units(2.0));
        area.draw_text(&shown, &style, at).map_err(PlotError::drawing)?;
        if !self.letters {
            return Ok(());
        }
        let letter = char::from_u32('A' as u32 + u32::try_from(index).unwrap_or(0)).unwrap_or(' ');
        let style = text(TITLE_PT).pos(Pos::new(HPos::Left, VPos::Top));
        area.draw_text(&letter.to_string(), &style, (0, units(1.2))).map_err(PlotError::drawing)
    }

    /// The names of vertical limits, above the panel, in as many rows as keep them apart.
    fn draw_limit_names(&self, area: &Area<'_>, panel: &Panel) -> Result<(), PlotError> {
        let plot_width = self.panel_pt.0 - self.beside_pt - 5.0;
        for (row, limits) in limit_rows(panel, plot_width).into_iter().enumerate() {
            for limit in limits {
                let x = self.beside_pt + plot_width * share(panel, limit);
                let y = self.title_pt + self.limits_pt - LIMIT_ROW_PT * (float(row) + 0.5) + 0.6;
                let style = text(TEXT_PT).color(&LIMIT).pos(Pos::new(HPos::Center, VPos::Center));
                area.draw_text(&printable(&limit.label), &style, (units(x), units(y)))
                    .map_err(PlotError::drawing)?;
            }
        }
        Ok(())
    }
}

pub(crate) fn x_span(panel: &Panel) -> (f64, f64) {
    panel.x.span(panel.points().map(|(_, (x, _))| x), false)
}

pub(crate) fn y_span(panel: &Panel) -> (f64, f64) {
    let across = panel.limits.iter().filter(|limit| limit.direction == Direction::Horizontal);
    panel.y.span(panel.points().map(|(_, (_, y))| y).chain(across.map(|limit| limit.at)), true)
}

fn x_ticks(panel: &Panel) -> Ticks {
    Ticks::linear(x_span(panel), 7)
}

fn y_ticks(panel: &Panel) -> Ticks {
    Ticks::linear(y_span(panel), 6)
}

/// Where a vertical limit is, as a share of the panel's width.
fn share(panel: &Panel, limit: &Limit) -> f64 {
    let (low, high) = x_span(panel);
    (limit.at - low) / (high - low)
}

/// Named vertical limits within the panel, split into rows in which no two names touch.
fn limit_rows(panel: &Panel, plot_width_pt: f64) -> Vec<Vec<&Limit>> {
    let mut rows: Vec<Vec<&Limit>> = Vec::new();
    let place = |limit: &Limit| {
        let middle = plot_width_pt * share(panel, limit);
        let half = width_pt(&limit.label, TEXT_PT) / 2.0 + 2.0;
        (middle - half, middle + half)
    };
    let named = panel.limits.iter().filter(|limit| {
        limit.direction == Direction::Vertical
            && !limit.label.is_empty()
            && (0.0..=1.0).contains(&share(panel, limit))
    });
    for limit in named {
        let (from, to) = place(limit);
        let free = |row: &&mut Vec<&Limit>| {
            row.iter().all(|other| {
                let (start, end) = place(other);
                to < start || end < from
            })
        };
        match rows.iter_mut().find(free) {
            Some(row) => row.push(limit),
            None => rows.push(vec![limit]),
        }
    }
    rows
}

fn draw_axes(chart: &mut Chart<'_, '_>, panel: &Panel) -> Result<(), PlotError> {
    let (x_ticks, y_ticks) = (x_ticks(panel), y_ticks(panel));
    chart
        .configure_mesh()
        .disable_mesh()
        .axis_style(stroke(INK, 0.6))
        .set_all_tick_mark_size(units(TICK_PT))
        .label_style(text(TEXT_PT))
        .axis_desc_style(text(TEXT_PT))
        .x_desc(printable(&panel.x.label))
        .y_desc(printable(&panel.y.label))
        .x_label_formatter(&|value| x_ticks.label(*value))
        .y_label_formatter(&|value| y_ticks.label(*value))
        .draw()
        .map_err(PlotError::drawing)
}

fn draw_areas(chart: &mut Chart<'_, '_>, panel: &Panel) -> Result<(), PlotError> {
    for area in &panel.areas {
        let (Some(first), Some(last)) = (area.points.first(), area.points.last()) else { continue };
        let mut outline = area.points.clone();
        outline.extend([(last.0, 0.0), (first.0, 0.0)]);
        let shade = Polygon::new(outline, SHADE.mix(SHADE_OPACITY).filled());
        chart.draw_series([shade]).map_err(PlotError::drawing)?;
    }
    Ok(())
}

fn draw_curves(chart: &mut Chart<'_, '_>, panel: &Panel) -> Result<(), PlotError> {
    for curve in &panel.curves {
        let (points, style) = (curve.points.clone(), curve.look.stroke());
        match curve.look.dash.lengths_pt() {
            None => chart.draw_series([PathElement::new(points, style)]).map(|_| ()),
            Some((dash, gap)) => chart
                .draw_series([DashedPathElement::new(points, units(dash), units(gap), style)])
                .map(|_| ()),
        }
        .map_err(PlotError::drawing)?;
    }
    for mark in &panel.marks {
        let (r, g, b) = mark.look.colour;
        let dot = Circle::new(mark.at, units(2.2), RGBColor(r, g, b).filled());
        chart.draw_series([dot]).map_err(PlotError::drawing)?;
    }
    Ok(())
}

fn draw_limit(chart: &mut Chart<'_, '_>, panel: &Panel, limit: &Limit) -> Result<(), PlotError> {
    let ((left, right), (low, high)) = (x_span(panel), y_span(panel));
    let line = match limit.direction {
        Direction::Vertical if (left..=right).contains(&limit.at) => [(limit.at, low), (limit.at, high)],
        Direction::Vertical => return Ok(()),
        Direction::Horizontal => [(left, limit.at), (right, limit.at)],
    };
    let dashed = DashedPathElement::new(line, units(2.0), units(1.6), stroke(LIMIT, 0.6));
    chart.draw_series([dashed]).map(|_| ()).map_err(PlotError::drawing)
}

#[expect(clippy::cast_precision_loss, reason = "panels and rows")]
pub(crate) fn float(count: usize) -> f64 {
    count as f64
}
