//! What a panel covers: from where to where its axes go, and what is between them.

use crate::axis::Ticks;
use crate::figure::{Direction, Limit, Panel, Point};

/// Ticks along an axis.
const X_TICKS: usize = 7;
const Y_TICKS: usize = 6;

/// The spans of a panel's axes, as places along them (logarithms on a logarithmic axis), and their ticks.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Frame<'p> {
    panel: &'p Panel,
    pub(crate) x: (f64, f64),
    pub(crate) y: (f64, f64),
    pub(crate) x_ticks: Ticks,
    pub(crate) y_ticks: Ticks,
}

impl<'p> Frame<'p> {
    pub(crate) fn of(panel: &'p Panel) -> Self {
        let x = panel.x.span(panel.points().map(|(_, (x, _))| x), false);
        // The vertical axis covers what the limits of the horizontal one leave.
        let within = |value: f64| (x.0..=x.1).contains(&panel.x.place(value));
        let shown = panel.points().filter(|(_, (x, _))| within(*x)).map(|(_, (_, y))| y);
        let across = panel.limits.iter().filter(|limit| limit.direction == Direction::Horizontal);
        let y = panel.y.span(shown.chain(across.map(|limit| limit.at)), true);
        Self { panel, x, y, x_ticks: panel.x.ticks(x, X_TICKS), y_ticks: panel.y.ticks(y, Y_TICKS) }
    }

    /// Where a point is.
    pub(crate) fn place(&self, (x, y): Point) -> Point {
        (self.panel.x.place(x), self.panel.y.place(y))
    }

    pub(crate) fn places(&self, points: &[Point]) -> Vec<Point> {
        points.iter().map(|&point| self.place(point)).collect()
    }

    /// Whether a point is between the axes.
    pub(crate) fn holds(&self, point: Point) -> bool {
        let (x, y) = self.place(point);
        (self.x.0..=self.x.1).contains(&x) && (self.y.0..=self.y.1).contains(&y)
    }

    /// Where a limit is along its axis, if it is in the panel.
    pub(crate) fn limit(&self, limit: &Limit) -> Option<f64> {
        let (axis, (low, high)) = match limit.direction {
            Direction::Vertical => (&self.panel.x, self.x),
            Direction::Horizontal => (&self.panel.y, self.y),
        };
        let at = axis.place(limit.at);
        (low..=high).contains(&at).then_some(at)
    }

    /// How far along the horizontal axis a limit is, from 0 to 1.
    pub(crate) fn share(&self, limit: &Limit) -> Option<f64> {
        let at = self.limit(limit).filter(|_| limit.direction == Direction::Vertical)?;
        Some((at - self.x.0) / (self.x.1 - self.x.0))
    }
}
