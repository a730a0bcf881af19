//! The parts of a figure, the axis ranges of its panels, and the parts of lines and areas within these ranges.

use line_clipping::cohen_sutherland::clip_line;
use line_clipping::sutherland_hodgman::clip_polygon;
use line_clipping::{LineSegment, Polygon, Window};

use crate::axis::{Axis, Ticks};
use crate::{Look, PlotError};

/// A point: value on the horizontal axis, value on the vertical axis.
pub type Point = (f64, f64);

/// A curve through points.
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    /// Name of the curve in the legend; curves with equal names and equal looks share one entry. No entry for an empty name.
    pub label: String,
    /// Points of the curve, in order.
    pub points: Vec<Point>,
    /// Colour, dash and width of the curve.
    pub look: Look,
}

impl Curve {
    /// A curve through `points`, with the name `label` in the legend.
    pub fn new(label: impl Into<String>, points: Vec<Point>, look: Look) -> Self {
        Self { label: label.into(), points, look }
    }
}

/// The area between a curve and 0, shaded.
#[derive(Debug, Clone, PartialEq)]
pub struct Area {
    /// Name of the area in the legend.
    pub label: String,
    /// Points of the area's upper edge, in order.
    pub points: Vec<Point>,
}

/// The direction of a straight line across a panel.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Direction {
    /// A vertical line: a limit at one value of the horizontal axis.
    Vertical,
    /// A horizontal line: a limit at one value of the vertical axis.
    Horizontal,
}

/// A limit or threshold: a thin dashed line across the panel with its name beside it.
#[derive(Debug, Clone, PartialEq)]
pub struct Limit {
    /// Text beside the limit; empty for none.
    pub label: String,
    /// Value of the limit, in the units of its axis.
    pub at: f64,
    /// Whether the line of the limit is vertical or horizontal.
    pub direction: Direction,
}

impl Limit {
    /// A limit at one value of the horizontal axis.
    pub fn vertical(label: impl Into<String>, at: f64) -> Self {
        Self { label: label.into(), at, direction: Direction::Vertical }
    }

    /// A limit at one value of the vertical axis.
    pub fn horizontal(label: impl Into<String>, at: f64) -> Self {
        Self { label: label.into(), at, direction: Direction::Horizontal }
    }
}

/// A single point, as a filled dot.
#[derive(Debug, Clone, PartialEq)]
pub struct Mark {
    /// Name of the point in the legend.
    pub label: String,
    /// The point, in the units of the axes.
    pub at: Point,
    /// Colour of the point; its dash and width have no meaning.
    pub look: Look,
}

/// A panel: a pair of axes and the curves, areas, limits and points between them.
#[derive(Debug, Clone, PartialEq)]
pub struct Panel {
    /// Title of the panel; may be empty.
    pub title: String,
    /// Horizontal axis of the panel.
    pub x: Axis,
    /// Vertical axis of the panel.
    pub y: Axis,
    /// Curves of the panel, the first at the bottom.
    pub curves: Vec<Curve>,
    /// Shaded areas between curves and the line at 0.
    pub areas: Vec<Area>,
    /// Limits and thresholds of the panel.
    pub limits: Vec<Limit>,
    /// Single points, above everything else in the panel.
    pub marks: Vec<Mark>,
}

impl Panel {
    /// An empty panel with a title and axes.
    pub fn new(title: impl Into<String>, x: Axis, y: Axis) -> Self {
        let title = title.into();
        Self { title, x, y, curves: vec![], areas: vec![], limits: vec![], marks: vec![] }
    }

    /// All points of curves, areas and marks, each with the label of its curve, area or mark.
    pub(crate) fn points(&self) -> impl Iterator<Item = (&str, Point)> {
        let curves = self.curves.iter().flat_map(|c| c.points.iter().map(|&p| (c.label.as_str(), p)));
        let areas = self.areas.iter().flat_map(|a| a.points.iter().map(|&p| (a.label.as_str(), p)));
        let marks = self.marks.iter().map(|m| (m.label.as_str(), m.at));
        curves.chain(areas).chain(marks)
    }

    pub(crate) fn check(&self) -> Result<(), PlotError> {
        if self.curves.iter().all(|curve| curve.points.len() < 2) {
            return Err(PlotError::Empty("a panel has no curve of two points"));
        }
        if let Some((curve, _)) = self.points().find(|(_, (x, y))| !x.is_finite() || !y.is_finite()) {
            return Err(PlotError::NotFinite(curve.to_owned()));
        }
        self.x.check(self.points().map(|(_, (x, _))| x))?;
        self.y.check(self.points().map(|(_, (_, y))| y))
    }
}

/// The default width of a figure on paper.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum Width {
    /// One column of a journal, 90 mm.
    #[default]
    Column,
    /// The width of a journal's whole page, 190 mm.
    Page,
}

impl Width {
    /// The width in millimetres.
    pub fn mm(self) -> f64 {
        match self {
            Self::Column => 90.0,
            Self::Page => 190.0,
        }
    }
}

/// Panels side by side and below each other, with one legend for all.
#[derive(Debug, Clone, PartialEq)]
pub struct Figure {
    /// Title above the panels, and the document's `<title>`.
    pub title: String,
    /// Description in full sentences, the document's `<desc>`.
    pub description: String,
    /// Width of the figure.
    pub width: Width,
    /// Number of panels in a row.
    pub columns: usize,
    /// The panels, row by row.
    pub panels: Vec<Panel>,
}

impl Figure {
    /// Panels below each other, in one column of a journal.
    pub fn in_column(title: impl Into<String>, description: String, panels: Vec<Panel>) -> Self {
        Self { title: title.into(), description, width: Width::Column, columns: 1, panels }
    }

    /// The figure itself, if the curves of each panel can be distinguished.
    ///
    /// # Errors
    /// [`PlotError::TooMany`]: a panel has more curves than [`Look::MOST_SERIES`].
    pub fn distinct(self) -> Result<Self, PlotError> {
        let count = self.panels.iter().map(|panel| panel.curves.len()).max().unwrap_or(0);
        let most = Look::MOST_SERIES;
        if count > most { Err(PlotError::TooMany { count, most }) } else { Ok(self) }
    }
}

// What a panel covers: from where to where its axes go, and what is between them.

/// Number of ticks along a horizontal axis, roughly.
const X_TICK_COUNT: usize = 7;
/// Number of ticks along a vertical axis, roughly.
const Y_TICK_COUNT: usize = 6;

/// The ends of a panel's axes as positions (logarithms on a logarithmic axis), and their ticks.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Frame<'p> {
    panel: &'p Panel,
    pub(crate) x: (f64, f64),
    pub(crate) y: (f64, f64),
    pub(crate) x_ticks: Ticks,
    pub(crate) y_ticks: Ticks,
}

impl<'p> Frame<'p> {
    /// The ends and the ticks of the axes of `panel`.
    pub(crate) fn of(panel: &'p Panel) -> Self {
        let x = panel.x.span(panel.points().map(|(_, (x, _))| x), false);
        // The vertical axis covers what the limits of the horizontal one leave.
        let within = |value: f64| (x.0..=x.1).contains(&panel.x.place(value));
        let shown = panel.points().filter(|(_, (x, _))| within(*x)).map(|(_, (_, y))| y);
        let across = panel.limits.iter().filter(|limit| limit.direction == Direction::Horizontal);
        let y = panel.y.span(shown.chain(across.map(|limit| limit.at)), true);
        Self { panel, x, y, x_ticks: panel.x.ticks(x, X_TICK_COUNT), y_ticks: panel.y.ticks(y, Y_TICK_COUNT) }
    }

    /// Position of a point in the panel: values, or their logarithms on a logarithmic axis.
    pub(crate) fn place(&self, (x, y): Point) -> Point {
        (self.panel.x.place(x), self.panel.y.place(y))
    }

    pub(crate) fn places(&self, points: &[Point]) -> Vec<Point> {
        points.iter().map(|&point| self.place(point)).collect()
    }

    /// Whether a position is between the axes.
    pub(crate) fn contains_point(&self, point: Point) -> bool {
        let (x, y) = self.place(point);
        (self.x.0..=self.x.1).contains(&x) && (self.y.0..=self.y.1).contains(&y)
    }

    /// Position of a limit along its axis; `None` if it is outside the panel.
    pub(crate) fn limit(&self, limit: &Limit) -> Option<f64> {
        let (axis, (low, high)) = match limit.direction {
            Direction::Vertical => (&self.panel.x, self.x),
            Direction::Horizontal => (&self.panel.y, self.y),
        };
        let at = axis.place(limit.at);
        (low..=high).contains(&at).then_some(at)
    }
}

// What of a line or an area is inside of a panel: lines and polygons cut at its borders.

type Span = (f64, f64);

fn clipping_point((x, y): Point) -> line_clipping::Point {
    line_clipping::Point::new(x, y)
}

/// The parts of a polyline that are between `x.0` and `x.1`, `y.0` and `y.1`.
pub(crate) fn clip_polyline(points: &[Point], x: Span, y: Span) -> Vec<Vec<Point>> {
    let window = Window::new(x.0, x.1, y.0, y.1);
    let mut parts: Vec<Vec<Point>> = Vec::new();
    for pair in points.windows(2) {
        let Some(inside) =
            clip_line(LineSegment::new(clipping_point(pair[0]), clipping_point(pair[1])), window)
        else {
            continue;
        };
        let (from, to) = ((inside.p1.x, inside.p1.y), (inside.p2.x, inside.p2.y));
        // Outside, it may still touch the edge.
        if from == to {
            continue;
        }
        match parts.last_mut() {
            Some(part) if part.last() == Some(&from) => part.push(to),
            _ => parts.push(vec![from, to]),
        }
    }
    parts
}

/// The part of an area that is between `x.0` and `x.1`, `y.0` and `y.1`; `None` if no part is.
pub(crate) fn clip_area(corners: &[Point], x: Span, y: Span) -> Option<Vec<Point>> {
    let corners: Vec<line_clipping::Point> = corners.iter().copied().map(clipping_point).collect();
    if corners.len() < 3 {
        return None;
    }
    let inside = clip_polygon(&Polygon::new(&corners), Window::new(x.0, x.1, y.0, y.1));
    let inside: Vec<Point> = inside.vertices.iter().map(|corner| (corner.x, corner.y)).collect();
    (inside.len() > 2).then_some(inside)
}

#[cfg(test)]
mod tests {
    use super::*;

    const UNIT: Span = (0.0, 1.0);

    #[test]
    fn a_line_between_the_edges_is_not_cut() {
        let points = [(0.0, 0.0), (0.3, 1.0), (1.0, 0.5)];
        assert_eq!(clip_polyline(&points, UNIT, UNIT), [points.to_vec()]);
    }

    #[test]
    fn a_line_that_leaves_and_comes_back_becomes_two_lines() {
        let points = [(0.0, 0.5), (0.5, 1.5), (1.0, 0.5)];
        assert_eq!(
            clip_polyline(&points, UNIT, UNIT),
            [[(0.0, 0.5), (0.25, 1.0)], [(0.75, 1.0), (1.0, 0.5)]]
        );
        assert!(clip_polyline(&[(2.0, 2.0), (3.0, 2.0)], UNIT, UNIT).is_empty());
    }

    #[test]
    fn an_area_ends_at_the_edges() {
        let square = [(0.5, 0.5), (2.0, 0.5), (2.0, 2.0), (0.5, 2.0)];
        let mut inside = clip_area(&square, UNIT, UNIT).unwrap_or_default();
        inside.sort_by(|a, b| a.partial_cmp(b).unwrap_or(std::cmp::Ordering::Equal));
        assert_eq!(inside, [(0.5, 0.5), (0.5, 1.0), (1.0, 0.5), (1.0, 1.0)]);
        assert!(clip_area(&[(2.0, 2.0), (3.0, 2.0), (3.0, 3.0)], UNIT, UNIT).is_none());
    }
}
