//! Contact state against indentation.

use super::parts::{before, check_count, names};
use super::units::IndentationAxis;
use crate::axis::Axis;
use crate::error::PlotError;
use crate::figure::{Area, Curve, Figure, Limit, Panel, Point, Width};
use crate::style::Look;

/// Contact state against indentation of one contact.
#[derive(Debug, Clone, PartialEq)]
pub struct StateCurve {
    /// Name of the body or contact.
    pub name: String,
    /// s_c (C.4).
    pub points: Vec<Point>,
}

/// Contact state against indentation.
#[derive(Debug, Clone, PartialEq)]
pub struct StateFigure {
    /// What it shows.
    pub title: String,
    /// Unit of the horizontal axis.
    pub indentation: IndentationAxis,
    /// One body: its smoothed state over the step without smoothing. Several: the state of each.
    pub bodies: Vec<StateCurve>,
    /// Thresholds, such as x̂_t (C.6).
    pub limits: Vec<Limit>,
}

/// The contact state (C.4) with the step that it smooths.
///
/// # Errors
/// As [`force_figure`](super::force_figure).
pub fn state_figure(data: &StateFigure) -> Result<Figure, PlotError> {
    Ok(Figure {
        title: data.title.clone(),
        description: format!(
            "Contact state, from 0 to 1, against indentation of {}.",
            names(data.bodies.iter().map(|body| &body.name))
        ),
        width: Width::Column,
        columns: 1,
        panels: vec![state_panel(data)?],
    })
}

/// The panel of a [`StateFigure`], its title left empty.
///
/// # Errors
/// As [`force_figure`](super::force_figure).
pub fn state_panel(data: &StateFigure) -> Result<Panel, PlotError> {
    check_count(data.bodies.len())?;
    let mut panel =
        Panel::new("", Axis::new(data.indentation.label()), Axis::over("contact state (–)", 0.0, 1.05));
    panel.limits.clone_from(&data.limits);
    let single = data.bodies.len() == 1;
    if let (true, Some(points)) = (single, data.bodies.first().map(|body| &body.points)) {
        let ends = points.first().zip(points.last()).map(|(first, last)| (first.0, last.0));
        if let Some((from, to)) = ends.filter(|(from, to)| *from < 0.0 && *to > 0.0) {
            panel.curves.push(Curve {
                label: "binary contact, without smoothing".to_owned(),
                points: vec![(from, 0.0), (0.0, 0.0), (0.0, 1.0), (to, 1.0)],
                look: Look::HERTZ,
            });
        }
        panel.areas.push(Area { label: "before contact".to_owned(), points: before(points) });
    }
    for (index, body) in data.bodies.iter().enumerate() {
        panel.curves.push(Curve {
            label: if single { "smoothed (C.4)".to_owned() } else { body.name.clone() },
            points: body.points.clone(),
            look: if single { Look::OWN } else { Look::series(index) },
        });
    }
    Ok(panel)
}
