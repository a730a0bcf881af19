//! Force while a sphere goes in and out.

use super::parts::check_count;
use super::units::{ForceAxis, IndentationAxis};
use crate::axis::Axis;
use crate::error::PlotError;
use crate::figure::{Curve, Figure, Limit, Panel, Point, Width};
use crate::style::{Dash, Look};

/// One loading and unloading.
#[derive(Debug, Clone, PartialEq)]
pub struct LoopCurve {
    /// Its name: a speed, a body.
    pub name: String,
    /// Force against indentation, in then out.
    pub points: Vec<Point>,
}

/// Dissipation loops.
#[derive(Debug, Clone, PartialEq)]
pub struct LoopFigure {
    /// What it shows.
    pub title: String,
    /// How the sphere moved, as a full sentence.
    pub motion: String,
    /// Unit of the horizontal axis.
    pub indentation: IndentationAxis,
    /// Unit of the vertical axis.
    pub force: ForceAxis,
    /// The force at rest, without a loop; empty for none.
    pub elastic: Vec<Point>,
    /// The loops.
    pub loops: Vec<LoopCurve>,
    /// Limits, such as x̂ = 0.16.
    pub limits: Vec<Limit>,
}

/// Loops of force against indentation: the area within is the energy lost.
///
/// # Errors
/// As [`force_figure`](super::force_figure).
pub fn loop_figure(data: &LoopFigure) -> Result<Figure, PlotError> {
    check_count(data.loops.len())?;
    let mut panel = Panel::new("", Axis::new(data.indentation.label()), Axis::new(data.force.label()));
    panel.limits.clone_from(&data.limits);
    if !data.elastic.is_empty() {
        let look = Look { colour: (0x77, 0x77, 0x77), dash: Dash::Solid, width_pt: 0.8 };
        panel.curves.push(Curve { label: "force at rest".to_owned(), points: data.elastic.clone(), look });
    }
    for (index, one) in data.loops.iter().enumerate() {
        let (label, points) = (one.name.clone(), one.points.clone());
        panel.curves.push(Curve { label, points, look: Look::series(index) });
    }
    Ok(Figure {
        title: data.title.clone(),
        description: format!("Force against indentation while a sphere goes in and out. {}", data.motion),
        width: Width::Column,
        columns: 1,
        panels: vec![panel],
    })
}
