//! A quantity over two parameters, as colours on logarithmic axes.

use plotters::chart::{ChartBuilder, LabelAreaPosition};
use plotters::element::{PathElement, Rectangle};
use plotters::style::colors::colormaps::{ColorMap, ViridisRGB};
use plotters::style::{Color, RGBColor};

use crate::axis::{Scale, Ticks, log_ticks, minor_log_ticks};
use crate::draw::{Area, BELOW_PT, MARGIN_PT, NAME_PT, TICK_PT, TITLE_ROW_PT, document};
use crate::error::PlotError;
use crate::figure::{Point, Width};
use crate::legend::{Legend, Sample, casing, draw_cross, filling};
use crate::style::{INK, TEXT_PT, stroke, text, units, width_pt};
use crate::svg::printable;

const PLOT_HEIGHT_PT: f64 = 140.0;
const BAR_PT: f64 = 9.0;
const GAP_PT: f64 = 9.0;
const RIGHT_PT: f64 = 6.0;
const SLICES: u32 = 64;
/// Cells without a value.
const BLANK: RGBColor = RGBColor(0xBB, 0xBB, 0xBB);

/// A limit of the quantity, drawn between the cells that are within and those that are outside.
#[derive(Debug, Clone, PartialEq)]
pub struct HeatLimit {
    /// Its name in the legend.
    pub label: String,
    /// Its value.
    pub at: f64,
}

/// A quantity over two parameters.
#[derive(Debug, Clone, PartialEq)]
pub struct HeatMap {
    /// What it shows.
    pub title: String,
    /// The same in full sentences.
    pub description: String,
    /// What is written below, with its unit.
    pub x_label: String,
    /// Values of the horizontal parameter: rising, above 0, equally spaced on a logarithmic axis.
    pub x: Vec<f64>,
    /// What is written on the left, with its unit.
    pub y_label: String,
    /// Values of the vertical parameter, likewise.
    pub y: Vec<f64>,
    /// The quantity: a row for each of `y`, in it a value for each of `x`; `None` where there is none.
    pub values: Vec<Vec<Option<f64>>>,
    /// What is written beside the colour bar, with its unit.
    pub value_label: String,
    /// A limit of the quantity.
    pub limit: Option<HeatLimit>,
    /// A point to mark, with its name in the legend.
    pub mark: Option<(String, Point)>,
}

/// Draws a heat map with its colour bar, as an SVG document.
///
/// # Errors
/// [`PlotError`]: fewer than two values along an axis, values that do not rise or are not above 0, a quantity that is not a
/// finite number, or none at all.
pub fn heat_map(map: &HeatMap) -> Result<String, PlotError> {
    let layout = HeatLayout::of(map)?;
    document(layout.size_pt, &map.title, &map.description, |root| {
        layout.draw_cells(root, map)?;
        layout.draw_bar(root, map)?;
        layout.legend.draw(root, (MARGIN_PT + layout.beside_pt, layout.legend_top))
    })
}

/// Edges of the cells around values, halfway between them on a logarithmic axis, as logarithms.
fn edges(values: &[f64], axis: &str) -> Result<Vec<f64>, PlotError> {
    let wrong = values.iter().any(|value| !value.is_finite() || *value <= 0.0);
    if wrong || values.windows(2).any(|pair| pair[0] >= pair[1]) {
        return Err(PlotError::NotPositive { axis: axis.to_owned() });
    }
    let logs: Vec<f64> = values.iter().map(|value| value.log10()).collect();
    let (Some(first), Some(last), true) = (logs.first(), logs.last(), logs.len() > 1) else {
        return Err(PlotError::Empty { what: "a heat map needs two values along each axis" });
    };
    let inner: Vec<f64> = logs.windows(2).map(|pair| 0.5 * (pair[0] + pair[1])).collect();
    let lowest = 2.0 * first - inner.first().copied().unwrap_or(*first);
    let highest = 2.0 * last - inner.last().copied().unwrap_or(*last);
    Ok(std::iter::once(lowest).chain(inner).chain([highest]).collect())
}

/// Where everything of a heat map goes.
struct HeatLayout {
    size_pt: (f64, f64),
    x_edges: Vec<f64>,
    y_edges: Vec<f64>,
    /// The smallest and the largest value.
    span: (f64, f64),
    beside_pt: f64,
    /// The colour bar with its ticks and name.
    bar_room_pt: f64,
    bar_ticks: Ticks,
    legend: Legend,
    legend_top: f64,
}

impl HeatLayout {
    fn of(map: &HeatMap) -> Result<Self, PlotError> {
        let (x_edges, y_edges) = (edges(&map.x, &map.x_label)?, edges(&map.y, &map.y_label)?);
        let span = span(map)?;
        let bar_ticks = Ticks::linear(span, 7);
        let (low, high) = (10_f64.powf(first(&y_edges)), 10_f64.powf(last(&y_edges)));
        let labels = log_ticks(low, high).into_iter().map(|(_, label)| width_pt(&label, TEXT_PT));
        let beside_pt = NAME_PT + 3.0 * TICK_PT + labels.fold(8.0, f64::max);
        let bar_room_pt = GAP_PT + BAR_PT + 3.0 * TICK_PT + width_pt(&bar_ticks.longest(), TEXT_PT) + NAME_PT;
        let width = Width::Column.pt();
        let mut entries = Vec::new();
        if let Some(limit) = &map.limit {
            entries.push((Sample::Border, limit.label.clone()));
        }
        entries.extend(map.mark.iter().map(|(label, _)| (Sample::Cross, label.clone())));
        if map.values.iter().flatten().any(Option::is_none) {
            entries.push((Sample::Blank, "no value".to_owned()));
        }
        let legend = Legend::new(entries, width - 2.0 * MARGIN_PT - beside_pt);
        let legend_top = MARGIN_PT + TITLE_ROW_PT + PLOT_HEIGHT_PT + BELOW_PT;
        let size_pt = (width, legend_top + legend.height_pt() + MARGIN_PT);
        Ok(Self { size_pt, x_edges, y_edges, span, beside_pt, bar_room_pt, bar_ticks, legend, legend_top })
    }

    fn colour(&self, value: Option<f64>) -> RGBColor {
        let (low, high) = self.span;
        value.map_or(BLANK, |value| ViridisRGB.get_color_normalized(value, low, high))
    }

    fn draw_cells(&self, root: &Area<'_>, map: &HeatMap) -> Result<(), PlotError> {
        let (left, top) = (units(MARGIN_PT), units(MARGIN_PT + TITLE_ROW_PT));
        let width = units(self.size_pt.0 - 2.0 * MARGIN_PT - self.bar_room_pt);
        let area = root.clone().shrink((left, top), (width, units(PLOT_HEIGHT_PT + BELOW_PT)));
        let (x_ticks, y_ticks) = (named(&self.x_edges), named(&self.y_edges));
        let axis = |edges: &[f64], ticks: &[(f64, String)]| {
            Scale::new((first(edges), last(edges)), ticks.iter().map(|(at, _)| *at).collect())
        };
        let mut chart = ChartBuilder::on(&area)
            .margin_right(units(RIGHT_PT))
            .set_label_area_size(LabelAreaPosition::Left, units(self.beside_pt))
            .set_label_area_size(LabelAreaPosition::Bottom, units(BELOW_PT))
            .build_cartesian_2d(axis(&self.x_edges, &x_ticks), axis(&self.y_edges, &y_ticks))
            .map_err(PlotError::drawing)?;
        chart.draw_series(self.cells(map)).map_err(PlotError::drawing)?;
        let border = self.limit(map);
        for style in [casing(), filling()] {
            let lines = border.iter().map(|line| PathElement::new(line.clone(), style));
            chart.draw_series(lines).map_err(PlotError::drawing)?;
        }
        chart
            .configure_mesh()
            .disable_mesh()
            .axis_style(stroke(INK, 0.6))
            .set_all_tick_mark_size(units(TICK_PT))
            .label_style(text(TEXT_PT))
            .axis_desc_style(text(TEXT_PT))
            .x_desc(printable(&map.x_label))
            .y_desc(printable(&map.y_label))
            .x_label_formatter(&|at| label_of(&x_ticks, *at))
            .y_label_formatter(&|at| label_of(&y_ticks, *at))
            .draw()
            .map_err(PlotError::drawing)?;
        let corner = |x: f64, y: f64| chart.backend_coord(&(x, y));
        self.draw_minor_ticks(root, &corner)?;
        match &map.mark {
            Some((_, (x, y))) if *x > 0.0 && *y > 0.0 => draw_cross(root, corner(x.log10(), y.log10())),
            _ => Ok(()),
        }
    }

    /// One rectangle for each cell, a little larger to the right and to the top so that no seam shows; the next one
    /// covers that.
    fn cells(&self, map: &HeatMap) -> Vec<Rectangle<(f64, f64)>> {
        let (right, top) = (last(&self.x_edges), last(&self.y_edges));
        let mut cells = Vec::new();
        for (row, y) in map.values.iter().zip(self.y_edges.windows(2)) {
            for (value, x) in row.iter().zip(self.x_edges.windows(2)) {
                let to = ((x[1] + 0.1 * (x[1] - x[0])).min(right), (y[1] + 0.1 * (y[1] - y[0])).min(top));
                cells.push(Rectangle::new([(x[0], y[0]), to], self.colour(*value).filled()));
            }
        }
        cells
    }

    /// Edges between cells on either side of the limit.
    fn limit(&self, map: &HeatMap) -> Vec<Vec<Point>> {
        let Some(limit) = &map.limit else { return Vec::new() };
        let within = |row: usize, column: usize| {
            let value = map.values.get(row).and_then(|row| row.get(column)).copied().flatten();
            value.map(|value| value <= limit.at)
        };
        let differ = |a: Option<bool>, b: Option<bool>| matches!((a, b), (Some(a), Some(b)) if a != b);
        let mut lines = Vec::new();
        for (row, y) in self.y_edges.windows(2).enumerate() {
            for (column, x) in self.x_edges.windows(2).enumerate() {
                let here = within(row, column);
                if differ(here, within(row, column + 1)) {
                    lines.push(vec![(x[1], y[0]), (x[1], y[1])]);
                }
                if differ(here, within(row + 1, column)) {
                    lines.push(vec![(x[0], y[1]), (x[1], y[1])]);
                }
            }
        }
        lines
    }

    /// The library draws no ticks without labels.
    fn draw_minor_ticks(
        &self,
        root: &Area<'_>,
        corner: &dyn Fn(f64, f64) -> (i32, i32),
    ) -> Result<(), PlotError> {
        let (left, bottom) = (first(&self.x_edges), first(&self.y_edges));
        let tick = units(0.55 * TICK_PT);
        let mut lines = Vec::new();
        for at in minor(&self.x_edges) {
            let (x, y) = corner(at, bottom);
            lines.push(vec![(x, y), (x, y + tick)]);
        }
        for at in minor(&self.y_edges) {
            let (x, y) = corner(left, at);
            lines.push(vec![(x - tick, y), (x, y)]);
        }
        for line in lines {
            root.draw(&PathElement::new(line, stroke(INK, 0.4))).map_err(PlotError::drawing)?;
        }
        Ok(())
    }

    fn draw_bar(&self, root: &Area<'_>, map: &HeatMap) -> Result<(), PlotError> {
        let left = self.size_pt.0 - MARGIN_PT - self.bar_room_pt + GAP_PT;
        let area = root.clone().shrink(
            (units(left), units(MARGIN_PT + TITLE_ROW_PT)),
            (units(self.bar_room_pt - GAP_PT), units(PLOT_HEIGHT_PT)),
        );
        let (low, high) = self.span;
        let mut chart = ChartBuilder::on(&area)
            .set_label_area_size(LabelAreaPosition::Right, units(self.bar_room_pt - GAP_PT - BAR_PT))
            .build_cartesian_2d(
                Scale::new((0.0, 1.0), vec![]),
                Scale::new((low, high), self.bar_ticks.at.clone()),
            )
            .map_err(PlotError::drawing)?;
        let at = |slice: u32| low + (high - low) * f64::from(slice) / f64::from(SLICES);
        let slices = (0..SLICES).map(|slice| {
            let colour = self.colour(Some(0.5 * (at(slice) + at(slice + 1))));
            Rectangle::new([(0.0, at(slice)), (1.0, at((slice + 2).min(SLICES)))], colour.filled())
        });
        chart.draw_series(slices).map_err(PlotError::drawing)?;
        if let Some(limit) = map.limit.as_ref().filter(|limit| (low..=high).contains(&limit.at)) {
            for style in [casing(), filling()] {
                let line = PathElement::new(vec![(0.0, limit.at), (1.0, limit.at)], style);
                chart.draw_series([line]).map_err(PlotError::drawing)?;
            }
        }
        chart
            .configure_mesh()
            .disable_mesh()
            .axis_style(stroke(INK, 0.6))
            .set_all_tick_mark_size(units(TICK_PT))
            .label_style(text(TEXT_PT))
            .axis_desc_style(text(TEXT_PT))
            .y_desc(printable(&map.value_label))
            .y_label_formatter(&|value| self.bar_ticks.label(*value))
            .draw()
            .map_err(PlotError::drawing)
    }
}

fn span(map: &HeatMap) -> Result<(f64, f64), PlotError> {
    let values = || map.values.iter().flatten().filter_map(|value| *value);
    if values().any(|value| !value.is_finite()) {
        return Err(PlotError::NotFinite { curve: map.value_label.clone() });
    }
    let (low, high) = (values().fold(f64::INFINITY, f64::min), values().fold(f64::NEG_INFINITY, f64::max));
    match () {
        () if low > high => Err(PlotError::Empty { what: "the heat map has no value" }),
        // One colour for all: a span of some width around it.
        () if high - low <= 1e-12 * high.abs() => Ok((low - 0.5, high + 0.5)),
        () => Ok((low, high)),
    }
}

fn first(edges: &[f64]) -> f64 {
    edges.first().copied().unwrap_or(0.0)
}

fn last(edges: &[f64]) -> f64 {
    edges.last().copied().unwrap_or(1.0)
}

/// Labelled ticks between the outer edges, as logarithms.
fn named(edges: &[f64]) -> Vec<(f64, String)> {
    let ticks = log_ticks(10_f64.powf(first(edges)), 10_f64.powf(last(edges)));
    ticks.into_iter().map(|(at, label)| (at.log10(), label)).collect()
}

fn minor(edges: &[f64]) -> Vec<f64> {
    let ticks = minor_log_ticks(10_f64.powf(first(edges)), 10_f64.powf(last(edges)));
    ticks.into_iter().map(f64::log10).collect()
}

fn label_of(ticks: &[(f64, String)], at: f64) -> String {
    ticks.iter().find(|(tick, _)| *tick == at).map(|(_, label)| label.clone()).unwrap_or_default()
}
