//! The legend of names below a figure, and the names of vertical limits above a panel.

use plotters::element::{Circle, DashedPathElement, PathElement, Rectangle};
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{Color, RGBColor, ShapeStyle};

use crate::document::{Area, text_allowed_in_xml};
use crate::error::PlotError;
use crate::figure::{Direction, Figure, Frame, Limit, Panel};
use crate::style::{LIMIT, Look, SHADE_COLOUR, SHADE_OPACITY, TEXT_PT, float, stroke, text, units};
use crate::text_width::{lines, width_with_reserve_pt};

/// Height of a legend entry whose name has one line, pt.
const ENTRY_ROW_PT: f64 = 10.0;
/// Distance between lines of one name, pt.
const NAME_LINE_PT: f64 = 8.2;
/// Width of the sample (line, area or point) before a name in a legend, pt.
pub(crate) const SAMPLE_PT: f64 = 18.0;
/// Distance between a sample and its name in a legend, pt.
const ENTRY_GAP_PT: f64 = 4.0;

/// The sample of a legend entry: the line, area or point to the left of its name.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Sample {
    Line(Look),
    Shade,
    Dot(Look),
    Limit,
    Border,
    Cross,
    Cell(RGBColor),
}

/// The entries of a legend with samples `S`, and their arrangement in columns.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Legend<S> {
    /// Each entry with the lines of its name.
    entries: Vec<(S, Vec<String>)>,
    columns: usize,
    column_pt: f64,
}

impl Legend<Sample> {
    /// The legend of a figure's panels.
    pub(crate) fn of(figure: &Figure, room_pt: f64) -> Self {
        let mut entries: Vec<(Sample, String)> = Vec::new();
        for panel in &figure.panels {
            let frame = Frame::of(panel);
            let curves = panel.curves.iter().map(|curve| (Sample::Line(curve.look), &curve.label));
            let marks = panel.marks.iter().filter(|mark| frame.contains_point(mark.at));
            let marks = marks.map(|mark| (Sample::Dot(mark.look), &mark.label));
            let areas = panel.areas.iter().map(|area| (Sample::Shade, &area.label));
            let across = panel.limits.iter().filter(|limit| limit.direction == Direction::Horizontal);
            let across = across.filter(|limit| frame.limit(limit).is_some());
            let limits = across.map(|limit| (Sample::Limit, &limit.label));
            for (sample, label) in curves.chain(marks).chain(areas).chain(limits) {
                if !label.is_empty() && !entries.iter().any(|entry| *entry == (sample, label.clone())) {
                    entries.push((sample, label.clone()));
                }
            }
        }
        Self::new(entries, room_pt)
    }
}

impl<S: Copy> Legend<S> {
    /// A legend with as many columns as possible if each name fits into one line; else with one column, in which long names
    /// take several lines. No name is cut.
    pub(crate) fn new(entries: Vec<(S, String)>, room_pt: f64) -> Self {
        let name = |(_, label): &(S, String)| width_with_reserve_pt(label, TEXT_PT);
        let widest = SAMPLE_PT + 3.0 * ENTRY_GAP_PT + entries.iter().map(name).fold(0.0, f64::max);
        let columns = (1..=entries.len().max(1)).rev().find(|&n| room_pt >= widest * float(n)).unwrap_or(1);
        let column_pt = room_pt / float(columns);
        let room = column_pt - SAMPLE_PT - 2.0 * ENTRY_GAP_PT;
        let entries = entries.into_iter();
        let entries =
            entries.map(|(sample, label)| (sample, lines(&text_allowed_in_xml(&label), TEXT_PT, room)));
        Self { entries: entries.collect(), columns, column_pt }
    }

    /// Number of entries in a column; the last column may have fewer.
    fn rows(&self) -> usize {
        self.entries.len().div_ceil(self.columns)
    }

    /// Height of the legend below the panels, pt.
    pub(crate) fn height_pt(&self) -> f64 {
        let columns = self.entries.chunks(self.rows().max(1));
        let height = |column: &[(S, Vec<String>)]| column.iter().map(|(_, lines)| height_pt(lines)).sum();
        let highest = columns.map(height).fold(0.0, f64::max);
        if self.entries.is_empty() { 0.0 } else { highest + ENTRY_GAP_PT }
    }

    /// Draws the legend with its upper left corner at `(left_pt, top_pt)`. `draw_sample` draws a sample, given its left end and its middle,
    /// in points.
    pub(crate) fn draw(
        &self,
        area: &Area<'_>,
        (left_pt, top_pt): (f64, f64),
        draw_sample: fn(&Area<'_>, S, f64, f64) -> Result<(), PlotError>,
    ) -> Result<(), PlotError> {
        // Down the first column, then down the next.
        let (mut left, mut top) = (left_pt, top_pt + ENTRY_GAP_PT);
        for (index, (sample, lines)) in self.entries.iter().enumerate() {
            if index > 0 && index % self.rows() == 0 {
                (left, top) = (left + self.column_pt, top_pt + ENTRY_GAP_PT);
            }
            draw_sample(area, *sample, left, top + 0.5 * ENTRY_ROW_PT)?;
            for (row, line) in lines.iter().enumerate() {
                let style = text(TEXT_PT).pos(Pos::new(HPos::Left, VPos::Center));
                let middle = top + 0.5 * ENTRY_ROW_PT + NAME_LINE_PT * float(row);
                let at = (units(left + SAMPLE_PT + ENTRY_GAP_PT), units(middle));
                area.draw_text(line, &style, at).map_err(PlotError::drawing)?;
            }
            top += height_pt(lines);
        }
        Ok(())
    }
}

/// Height of an entry whose name has these lines, pt.
fn height_pt(lines: &[String]) -> f64 {
    ENTRY_ROW_PT + NAME_LINE_PT * float(lines.len().saturating_sub(1))
}

pub(crate) fn draw_sample(area: &Area<'_>, sample: Sample, left: f64, middle: f64) -> Result<(), PlotError> {
    let at = |dx: f64, dy: f64| (units(left + dx), units(middle + dy));
    let line = vec![at(0.0, 0.0), at(SAMPLE_PT, 0.0)];
    match sample {
        Sample::Line(look) => match look.dash.lengths_pt() {
            None => area.draw(&PathElement::new(line, look.stroke())),
            Some((dash, gap)) => {
                area.draw(&DashedPathElement::new(line, units(dash), units(gap), look.stroke()))
            }
        },
        Sample::Shade => area.draw(&Rectangle::new(
            [at(0.0, -3.0), at(SAMPLE_PT, 3.0)],
            SHADE_COLOUR.mix(SHADE_OPACITY).filled(),
        )),
        Sample::Dot(look) => {
            area.draw(&Circle::new(at(SAMPLE_PT / 2.0, 0.0), units(2.2), look.rgb().filled()))
        }
        Sample::Limit => area.draw(&DashedPathElement::new(line, units(2.0), units(1.6), stroke(LIMIT, 0.7))),
        Sample::Border => {
            area.draw(&PathElement::new(line.clone(), rim_stroke())).map_err(PlotError::drawing)?;
            area.draw(&PathElement::new(line, core_stroke()))
        }
        Sample::Cross => return draw_cross(area, at(SAMPLE_PT / 2.0, 0.0)),
        Sample::Cell(colour) => {
            area.draw(&Rectangle::new([at(0.0, -3.0), at(SAMPLE_PT, 3.0)], colour.filled()))
        }
    }
    .map_err(PlotError::drawing)
}

/// The wide dark stroke below [`core_stroke`]: together they make a white line with a dark rim, visible on every colour of a heat
/// map.
pub(crate) fn rim_stroke() -> ShapeStyle {
    stroke(RGBColor(0, 0, 0), 2.2)
}

pub(crate) fn core_stroke() -> ShapeStyle {
    stroke(RGBColor(255, 255, 255), 1.0)
}

/// A white ring with a dark rim: visible on every colour of a heat map.
pub(crate) fn draw_cross(area: &Area<'_>, at: (i32, i32)) -> Result<(), PlotError> {
    let ring = |pt: f64, colour: RGBColor, width: f64| Circle::new(at, units(pt), stroke(colour, width));
    area.draw(&ring(2.6, RGBColor(0, 0, 0), 2.0)).map_err(PlotError::drawing)?;
    area.draw(&ring(2.6, RGBColor(255, 255, 255), 1.0)).map_err(PlotError::drawing)
}

// The names of vertical limits, above a panel, in as many rows as keep them apart.

/// Height of a row with names of vertical limits, pt.
pub(crate) const LIMIT_ROW_PT: f64 = 8.5;
/// Smallest distance between two names of limits in one row, pt.
const LIMIT_GAP_PT: f64 = 4.0;

/// A vertical limit, and the position of the middle of its name along the axis, in points.
pub(crate) type PlacedLimit<'p> = (&'p Limit, f64);

/// The named vertical limits within the panel, in rows in which no two names touch.
pub(crate) fn limit_rows<'p>(panel: &'p Panel, frame: &Frame<'_>, plot_pt: f64) -> Vec<Vec<PlacedLimit<'p>>> {
    let mut rows: Vec<Vec<PlacedLimit<'p>>> = Vec::new();
    let named = panel.limits.iter().filter(|limit| !limit.label.is_empty());
    for limit in named.filter(|limit| limit.direction == Direction::Vertical) {
        let Some(at) = frame.limit(limit) else { continue };
        let placed = (limit, plot_pt * ((at - frame.x.0) / (frame.x.1 - frame.x.0)));
        match rows.iter_mut().find(|row| row.iter().all(|other| are_apart(*other, placed))) {
            Some(row) => row.push(placed),
            None => rows.push(vec![placed]),
        }
    }
    rows
}

fn are_apart((a, at_a): PlacedLimit<'_>, (b, at_b): PlacedLimit<'_>) -> bool {
    let wide = |limit: &Limit| width_with_reserve_pt(&limit.label, TEXT_PT);
    (at_a - at_b).abs() > 0.5 * (wide(a) + wide(b)) + LIMIT_GAP_PT
}
