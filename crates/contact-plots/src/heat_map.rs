//! Heat maps: a quantity over two parameters, shown by colours.

use plotters::chart::{ChartBuilder, LabelAreaPosition};
use plotters::element::{PathElement, Rectangle};
use plotters::style::colors::colormaps::{ColorMap, ViridisRGB};
use plotters::style::{Color, RGBColor};

use crate::axis::{Axis, Scale, Ticks};
use crate::document::{Area, MARGIN_PT, Paper, Title, document, text_allowed_in_xml};
use crate::legend::{Legend, Sample, core_stroke, draw_cross, draw_sample, rim_stroke};
use crate::panels_svg::{AXIS_NAME_DISTANCE_PT, TICK_LABELS_HEIGHT_PT, TICK_LENGTH_PT, draw_axes};
use crate::style::{INK, TEXT_PT, stroke, text, units};
use crate::{PlotError, Point, Width};

/// Height of a heat map between its axes, pt.
const PLOT_HEIGHT_PT: f64 = 140.0;
/// Width of the colour bar, pt.
const COLOUR_BAR_WIDTH_PT: f64 = 9.0;
/// Distance between a heat map and its colour bar, pt.
const COLOUR_BAR_GAP_PT: f64 = 9.0;
/// Room on the right of the figure, pt.
const RIGHT_MARGIN_PT: f64 = 6.0;
/// Number of rectangles that make the colour bar, each of one colour.
const COLOUR_BAR_SLICES: u32 = 64;
/// Number of ticks along an axis and along the colour bar, roughly.
const TICKS_PER_AXIS: usize = 7;
/// The colour of a cell without a value.
const COLOUR_OF_EMPTY_CELLS: RGBColor = RGBColor(0xBB, 0xBB, 0xBB);

/// A limit of the quantity, drawn as a line between cells below the limit and cells above it.
#[derive(Debug, Clone, PartialEq)]
pub struct HeatLimit {
    /// Name of the limit line in the legend.
    pub label: String,
    /// Value of the quantity at the limit, in the unit of the heat map's `value_axis`.
    pub at: f64,
}

/// A heat map: a quantity over two parameters.
#[derive(Debug, Clone, PartialEq)]
pub struct HeatMap {
    /// Title above the heat map.
    pub title: String,
    /// Description of the map in full sentences.
    pub description: String,
    /// Axis of the horizontal parameter; it ends with the outer edges of the cells.
    pub x_axis: Axis,
    /// Values of the horizontal parameter, each at the middle of a column of cells; they must rise.
    pub x: Vec<f64>,
    /// Axis of the vertical parameter; it ends with the outer edges of the cells.
    pub y_axis: Axis,
    /// Values of the vertical parameter, each at the middle of a row of cells; they must rise.
    pub y: Vec<f64>,
    /// The quantity: for each value of `y` a row with one value for each value of `x`; `None` if the value is not known.
    pub values: Vec<Vec<Option<f64>>>,
    /// Axis of the quantity, along the colour bar. If it has limits, values outside have the colour of the nearer limit.
    pub value_axis: Axis,
    /// A limit of the quantity, if a line is to show it.
    pub limit: Option<HeatLimit>,
    /// A point to mark, with its name in the legend.
    pub mark: Option<(String, Point)>,
}

/// Draws a heat map with its colour bar, as an SVG document.
///
/// # Errors
/// [`PlotError`]: fewer than two values along an axis, values that do not rise, a logarithmic axis with values that are not above
/// 0, a quantity that is not a finite number, no value at all, or too little room on the paper.
pub fn heat_map(map: &HeatMap, paper: Paper) -> Result<String, PlotError> {
    let layout = HeatLayout::of(map, paper.layout_pt(Width::Column))?;
    paper.check(Width::Column, layout.beside_pt + layout.bar_room_pt + 2.0 * MARGIN_PT + RIGHT_MARGIN_PT)?;
    let height_pt = layout.legend_top() + layout.legend.height_pt() + MARGIN_PT;
    document((paper, Width::Column), height_pt, &layout.title, [&map.title, &map.description], |root| {
        layout.draw_cells(root, map)?;
        layout.draw_bar(root, map)?;
        layout.legend.draw(root, (MARGIN_PT + layout.beside_pt, layout.legend_top()), draw_sample)
    })
}

/// Edges of the cells around the values: halfway between neighbouring positions along the axis.
fn cell_edges(values: &[f64], axis: &Axis) -> Result<Vec<f64>, PlotError> {
    axis.check(values.iter().copied())?;
    if values.iter().any(|value| !value.is_finite()) || values.windows(2).any(|pair| pair[0] >= pair[1]) {
        return Err(PlotError::NotRising(axis.label.clone()));
    }
    let places: Vec<f64> = values.iter().map(|value| axis.place(*value)).collect();
    let (Some(first), Some(last), true) = (places.first(), places.last(), places.len() > 1) else {
        return Err(PlotError::Empty("a heat map needs two values along each axis"));
    };
    let inner: Vec<f64> = places.windows(2).map(|pair| 0.5 * (pair[0] + pair[1])).collect();
    let lowest = 2.0 * first - inner.first().copied().unwrap_or(*first);
    let highest = 2.0 * last - inner.last().copied().unwrap_or(*last);
    Ok(std::iter::once(lowest).chain(inner).chain([highest]).collect())
}

/// Positions of all parts of a heat map; positions along a logarithmic axis are logarithms.
struct HeatLayout {
    width_pt: f64,
    title: Title,
    x_edges: Vec<f64>,
    y_edges: Vec<f64>,
    /// The smallest and the largest position on the colour bar.
    span: (f64, f64),
    beside_pt: f64,
    /// Room for the colour bar with its ticks and its label, pt.
    bar_room_pt: f64,
    bar_ticks: Ticks,
    legend: Legend<Sample>,
}

impl HeatLayout {
    /// The layout of a heat map in a figure that is `width_pt` wide.
    fn of(map: &HeatMap, width_pt: f64) -> Result<Self, PlotError> {
        let (x_edges, y_edges) = (cell_edges(&map.x, &map.x_axis)?, cell_edges(&map.y, &map.y_axis)?);
        let span = value_span(map)?;
        let bar_ticks = map.value_axis.ticks(span, TICKS_PER_AXIS);
        let y_ticks = map.y_axis.ticks(end_edges(&y_edges), TICKS_PER_AXIS);
        let beside_pt = AXIS_NAME_DISTANCE_PT + 3.0 * TICK_LENGTH_PT + y_ticks.width_pt().max(8.0);
        let bar_room_pt = COLOUR_BAR_GAP_PT
            + COLOUR_BAR_WIDTH_PT
            + 3.0 * TICK_LENGTH_PT
            + bar_ticks.width_pt()
            + AXIS_NAME_DISTANCE_PT;
        let legend = Legend::new(legend_entries(map, span), width_pt - 2.0 * MARGIN_PT - beside_pt);
        let title = Title::new(&map.title, width_pt);
        Ok(Self { width_pt, title, x_edges, y_edges, span, beside_pt, bar_room_pt, bar_ticks, legend })
    }

    fn top(&self) -> f64 {
        self.title.bottom_pt()
    }

    fn legend_top(&self) -> f64 {
        self.top() + PLOT_HEIGHT_PT + TICK_LABELS_HEIGHT_PT
    }

    /// The ticks of an axis that ends with the outer edges of its cells.
    fn ticks(axis: &Axis, edges: &[f64]) -> Ticks {
        let (low, high) = end_edges(edges);
        let mut ticks = axis.ticks((low, high), TICKS_PER_AXIS);
        ticks.marks.retain(|(at, _)| (low..=high).contains(at));
        ticks
    }

    fn draw_cells(&self, root: &Area<'_>, map: &HeatMap) -> Result<(), PlotError> {
        let (left, top) = (units(MARGIN_PT), units(self.top()));
        let width = units(self.width_pt - 2.0 * MARGIN_PT - self.bar_room_pt);
        let area = root.clone().shrink((left, top), (width, units(PLOT_HEIGHT_PT + TICK_LABELS_HEIGHT_PT)));
        let (x_ticks, y_ticks) =
            (Self::ticks(&map.x_axis, &self.x_edges), Self::ticks(&map.y_axis, &self.y_edges));
        let scale = |edges: &[f64], ticks: &Ticks| Scale::new(end_edges(edges), ticks.at());
        let mut chart = ChartBuilder::on(&area)
            .margin_right(units(RIGHT_MARGIN_PT))
            .set_label_area_size(LabelAreaPosition::Left, units(self.beside_pt))
            .set_label_area_size(LabelAreaPosition::Bottom, units(TICK_LABELS_HEIGHT_PT))
            .build_cartesian_2d(scale(&self.x_edges, &x_ticks), scale(&self.y_edges, &y_ticks))
            .map_err(PlotError::drawing)?;
        chart.draw_series(self.cells(map)).map_err(PlotError::drawing)?;
        let border = self.limit(map);
        for style in [rim_stroke(), core_stroke()] {
            let lines = border.iter().map(|line| PathElement::new(line.clone(), style));
            chart.draw_series(lines).map_err(PlotError::drawing)?;
        }
        let ((left, right), (bottom, top)) = (end_edges(&self.x_edges), end_edges(&self.y_edges));
        draw_axes(root, &mut chart, (&map.x_axis, &map.y_axis), (&x_ticks, &y_ticks), (left, bottom))?;
        let mark = map.mark.as_ref().map(|(_, (x, y))| (map.x_axis.place(*x), map.y_axis.place(*y)));
        match mark {
            Some((x, y)) if (left..=right).contains(&x) && (bottom..=top).contains(&y) => {
                draw_cross(root, chart.backend_coord(&(x, y)))
            }
            _ => Ok(()),
        }
    }

    /// A rectangle for each cell. It is a little too large to the right and to the top, so that no gap shows; the next cells
    /// cover the excess.
    fn cells(&self, map: &HeatMap) -> Vec<Rectangle<(f64, f64)>> {
        let ((_, right), (_, top)) = (end_edges(&self.x_edges), end_edges(&self.y_edges));
        let (low, high) = self.span;
        let mut cells = Vec::new();
        for (row, y) in map.values.iter().zip(self.y_edges.windows(2)) {
            for (value, x) in row.iter().zip(self.x_edges.windows(2)) {
                let to = ((x[1] + 0.1 * (x[1] - x[0])).min(right), (y[1] + 0.1 * (y[1] - y[0])).min(top));
                let colour = value.map_or(COLOUR_OF_EMPTY_CELLS, |value| {
                    let place = map.value_axis.place(value).clamp(low, high);
                    ViridisRGB.get_color_normalized(place, low, high)
                });
                cells.push(Rectangle::new([(x[0], y[0]), to], colour.filled()));
            }
        }
        cells
    }

    /// The edges between cells on different sides of the limit.
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

    fn draw_bar(&self, root: &Area<'_>, map: &HeatMap) -> Result<(), PlotError> {
        let left = self.width_pt - MARGIN_PT - self.bar_room_pt + COLOUR_BAR_GAP_PT;
        let area = root.clone().shrink(
            (units(left), units(self.top())),
            (units(self.bar_room_pt - COLOUR_BAR_GAP_PT), units(PLOT_HEIGHT_PT)),
        );
        let (low, high) = self.span;
        let mut chart = ChartBuilder::on(&area)
            .set_label_area_size(
                LabelAreaPosition::Right,
                units(self.bar_room_pt - COLOUR_BAR_GAP_PT - COLOUR_BAR_WIDTH_PT),
            )
            .build_cartesian_2d(Scale::new((0.0, 1.0), vec![]), Scale::new((low, high), self.bar_ticks.at()))
            .map_err(PlotError::drawing)?;
        let at = |slice: u32| low + (high - low) * f64::from(slice) / f64::from(COLOUR_BAR_SLICES);
        let slices = (0..COLOUR_BAR_SLICES).map(|slice| {
            let middle = 0.5 * (at(slice) + at(slice + 1));
            let colour = ViridisRGB.get_color_normalized(middle, low, high);
            Rectangle::new([(0.0, at(slice)), (1.0, at((slice + 2).min(COLOUR_BAR_SLICES)))], colour.filled())
        });
        chart.draw_series(slices).map_err(PlotError::drawing)?;
        let limit = map.limit.as_ref().map(|limit| map.value_axis.place(limit.at));
        if let Some(limit) = limit.filter(|limit| (low..=high).contains(limit)) {
            for style in [rim_stroke(), core_stroke()] {
                let line = PathElement::new(vec![(0.0, limit), (1.0, limit)], style);
                chart.draw_series([line]).map_err(PlotError::drawing)?;
            }
        }
        chart
            .configure_mesh()
            .disable_mesh()
            .axis_style(stroke(INK, 0.6))
            .set_all_tick_mark_size(units(TICK_LENGTH_PT))
            .label_style(text(TEXT_PT))
            .axis_desc_style(text(TEXT_PT))
            .y_desc(text_allowed_in_xml(&map.value_axis.label))
            .y_label_formatter(&|at| self.bar_ticks.label(*at).to_owned())
            .draw()
            .map_err(PlotError::drawing)
    }
}

/// The legend entries, only for elements that the map shows.
fn legend_entries(map: &HeatMap, (low, high): (f64, f64)) -> Vec<(Sample, String)> {
    let mut entries = Vec::new();
    if let Some(limit) = &map.limit {
        entries.push((Sample::Border, limit.label.clone()));
    }
    entries.extend(map.mark.iter().map(|(label, _)| (Sample::Cross, label.clone())));
    let places = || map.values.iter().flatten().flatten().map(|value| map.value_axis.place(*value));
    if let Some((from, to)) = map.value_axis.limits {
        let end = |at| Sample::Cell(ViridisRGB.get_color_normalized(at, low, high));
        if places().any(|place| place > high) {
            entries.push((end(high), format!("{to} and more")));
        }
        if places().any(|place| place < low) {
            entries.push((end(low), format!("{from} and less")));
        }
    }
    if map.values.iter().flatten().any(Option::is_none) {
        entries.push((Sample::Cell(COLOUR_OF_EMPTY_CELLS), "no value".to_owned()));
    }
    entries
}

fn value_span(map: &HeatMap) -> Result<(f64, f64), PlotError> {
    let values = || map.values.iter().flatten().flatten().copied();
    if values().any(|value| !value.is_finite()) {
        return Err(PlotError::NotFinite(map.value_axis.label.clone()));
    }
    map.value_axis.check(values())?;
    if values().next().is_none() {
        return Err(PlotError::Empty("the heat map has no value"));
    }
    let (low, high) = map.value_axis.span(values(), false);
    // One colour for all: a span of some width around it.
    if high - low <= 1e-12 * high.abs() { Ok((low - 0.5, high + 0.5)) } else { Ok((low, high)) }
}

/// The first and the last edge of the cells.
fn end_edges(edges: &[f64]) -> (f64, f64) {
    (edges.first().copied().unwrap_or(0.0), edges.last().copied().unwrap_or(1.0))
}
