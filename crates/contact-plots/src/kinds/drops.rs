//! Drop tests.

use super::parts::{check_count, names};
use super::units::TimeAxis;
use crate::axis::Axis;
use crate::error::PlotError;
use crate::figure::{Curve, Direction, Figure, Limit, Panel, Point, Width};
use crate::style::Look;

/// Force over body weight of one falling body.
#[derive(Debug, Clone, PartialEq)]
pub struct DropCurve {
    /// Name of the body.
    pub name: String,
    /// Time in s, and normal force of all spheres over M g.
    pub points: Vec<Point>,
    /// √(R/g), in s.
    pub time_unit_s: f64,
}

/// A drop test, or several.
#[derive(Debug, Clone, PartialEq)]
pub struct DropFigure {
    /// What it shows.
    pub title: String,
    /// From where and for how long they fell, as a full sentence.
    pub conditions: String,
    /// Where the time axes end; `None`: with the points.
    pub shown: Option<DropEnd>,
    /// The bodies.
    pub bodies: Vec<DropCurve>,
}

/// Where the time axes of a drop test end.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DropEnd {
    /// In s.
    pub seconds: f64,
    /// In √(R/g).
    pub dimensionless: f64,
}

/// The drop test against time and, below, against non-dimensional time, as in Fig. 4.
///
/// # Errors
/// As [`force_figure`](super::force_figure).
pub fn drop_figure(data: &DropFigure) -> Result<Figure, PlotError> {
    let shown = |time| {
        data.shown.map(|shown| match time {
            TimeAxis::Second => shown.seconds,
            TimeAxis::Dimensionless => shown.dimensionless,
        })
    };
    let panel = |time| drop_panel(&data.bodies, time, shown(time));
    Ok(Figure {
        title: data.title.clone(),
        description: format!(
            "Normal force over body weight of {} in a drop test, against time and against non-dimensional time. {}",
            names(data.bodies.iter().map(|body| &body.name)),
            data.conditions
        ),
        width: Width::Column,
        columns: 1,
        panels: vec![panel(TimeAxis::Second)?, panel(TimeAxis::Dimensionless)?],
    })
}

/// One panel of a drop test; its time axis ends where it is `shown`, at the latest with the shortest of several bodies.
///
/// # Errors
/// As [`force_figure`](super::force_figure).
pub fn drop_panel(bodies: &[DropCurve], time: TimeAxis, shown: Option<f64>) -> Result<Panel, PlotError> {
    check_count(bodies.len())?;
    let unit = |body: &DropCurve| match time {
        TimeAxis::Second => 1.0,
        TimeAxis::Dimensionless => body.time_unit_s,
    };
    let end = |body: &DropCurve| body.points.last().map_or(0.0, |point| point.0 / unit(body));
    let until = bodies.iter().map(end).chain(shown).fold(f64::INFINITY, f64::min);
    let mut panel = Panel::new("", Axis::new(time.label()), Axis::new("normal force / body weight (–)"));
    panel.limits.push(Limit { label: "body weight".to_owned(), at: 1.0, direction: Direction::Horizontal });
    if until > 0.0 && until.is_finite() {
        panel.x.limits = Some((0.0, until));
    }
    for (index, body) in bodies.iter().enumerate() {
        let scaled = body.points.iter().map(|&(t, force)| (t / unit(body), force));
        panel.curves.push(Curve {
            label: body.name.clone(),
            points: scaled.collect(),
            look: Look::series(index),
        });
    }
    Ok(panel)
}
