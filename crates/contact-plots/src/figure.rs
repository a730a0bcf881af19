//! What a figure is made of.

use crate::axis::Axis;
use crate::error::PlotError;
use crate::style::Look;

/// A point: along the horizontal axis, along the vertical axis.
pub type Point = (f64, f64);

/// A curve through points.
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    /// Its name in the legend; equal names with equal looks share one entry. Empty for none.
    pub label: String,
    /// Its points, in order.
    pub points: Vec<Point>,
    /// How it looks.
    pub look: Look,
}

/// The area between a curve and 0, shaded.
#[derive(Debug, Clone, PartialEq)]
pub struct Area {
    /// Its name in the legend.
    pub label: String,
    /// Its upper edge, in order.
    pub points: Vec<Point>,
}

/// Which way a straight line runs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Direction {
    /// At one value of the horizontal axis.
    Vertical,
    /// At one value of the vertical axis.
    Horizontal,
}

/// A limit or threshold: a thin dashed line across the panel with its name beside it.
#[derive(Debug, Clone, PartialEq)]
pub struct Limit {
    /// What is written beside it; empty for none.
    pub label: String,
    /// Where it is, in the units of its axis.
    pub at: f64,
    /// Which way it runs.
    pub direction: Direction,
}

/// A single point, as a filled dot.
#[derive(Debug, Clone, PartialEq)]
pub struct Mark {
    /// Its name in the legend.
    pub label: String,
    /// Where it is.
    pub at: Point,
    /// Its colour; the dash has no meaning here.
    pub look: Look,
}

/// One pair of axes with what is drawn between them.
#[derive(Debug, Clone, PartialEq)]
pub struct Panel {
    /// What it shows; may be empty.
    pub title: String,
    /// The horizontal axis.
    pub x: Axis,
    /// The vertical axis.
    pub y: Axis,
    /// Its curves, the first at the bottom.
    pub curves: Vec<Curve>,
    /// Areas below them.
    pub areas: Vec<Area>,
    /// Limits and thresholds.
    pub limits: Vec<Limit>,
    /// Single points on top.
    pub marks: Vec<Mark>,
}

impl Panel {
    /// A panel without anything in it.
    #[must_use]
    pub fn new(title: impl Into<String>, x: Axis, y: Axis) -> Self {
        let title = title.into();
        Self { title, x, y, curves: vec![], areas: vec![], limits: vec![], marks: vec![] }
    }

    /// All points with the label of what they belong to.
    pub(crate) fn points(&self) -> impl Iterator<Item = (&str, Point)> {
        let curves = self.curves.iter().flat_map(|c| c.points.iter().map(|&p| (c.label.as_str(), p)));
        let areas = self.areas.iter().flat_map(|a| a.points.iter().map(|&p| (a.label.as_str(), p)));
        let marks = self.marks.iter().map(|m| (m.label.as_str(), m.at));
        curves.chain(areas).chain(marks)
    }

    pub(crate) fn check(&self) -> Result<(), PlotError> {
        if self.curves.iter().all(|curve| curve.points.len() < 2) {
            return Err(PlotError::Empty { what: "a panel has no curve of two points" });
        }
        if let Some((curve, _)) = self.points().find(|(_, (x, y))| !x.is_finite() || !y.is_finite()) {
            return Err(PlotError::NotFinite { curve: curve.to_owned() });
        }
        self.x.check(self.points().map(|(_, (x, _))| x))?;
        self.y.check(self.points().map(|(_, (_, y))| y))
    }
}

/// How wide a figure is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum Width {
    /// One column of a journal, 90 mm.
    #[default]
    Column,
    /// The whole page, 190 mm.
    Page,
}

impl Width {
    /// In millimetres.
    #[must_use]
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
    /// What it shows, above the panels and as the document's `<title>`.
    pub title: String,
    /// The same in full sentences, as the document's `<desc>`.
    pub description: String,
    /// How wide it is.
    pub width: Width,
    /// Panels in a row.
    pub columns: usize,
    /// The panels, row by row.
    pub panels: Vec<Panel>,
}
