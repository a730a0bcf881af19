//! Force against indentation.

use super::parts::{before, check_count, names};
use super::units::{ForceAxis, IndentationAxis};
use crate::axis::Axis;
use crate::error::PlotError;
use crate::figure::{Area, Curve, Figure, Limit, Mark, Panel, Point, Width};
use crate::style::Look;

/// Force against indentation of one contact, in the units of the figure's axes.
#[derive(Debug, Clone, PartialEq)]
pub struct ForceCurves {
    /// Name of the body or contact.
    pub name: String,
    /// The Hertz law (1).
    pub hertz: Vec<Point>,
    /// The Hertz law with the constant indentation (C.1); empty where the law has none.
    pub with_constant: Vec<Point>,
    /// The smoothed law of the file at rest (C.9); empty for a law without smoothing.
    pub own: Vec<Point>,
    /// Where the body rests on its contacts, if that is known.
    pub rest: Option<Point>,
    /// What the legend says of the law of the file in brackets; empty for nothing.
    pub remark: String,
}

impl ForceCurves {
    /// The name of the curve that is the law of the file, with its remark.
    fn remarked(&self, label: &str) -> String {
        if self.remark.is_empty() { label.to_owned() } else { format!("{label} ({})", self.remark) }
    }
}

/// Force against indentation.
#[derive(Debug, Clone, PartialEq)]
pub struct ForceFigure {
    /// What it shows.
    pub title: String,
    /// Unit of the horizontal axis.
    pub indentation: IndentationAxis,
    /// Unit of the vertical axis.
    pub force: ForceAxis,
    /// Where the vertical axis ends; `None`: it holds all points.
    pub top: Option<f64>,
    /// One body: its laws, and the force before contact shaded. Several: the law of each.
    pub bodies: Vec<ForceCurves>,
    /// Limits and thresholds, such as x̂ = 0.16.
    pub limits: Vec<Limit>,
}

/// Force against indentation: Hertz, Hertz with cf and smoothed, as in Fig. C.5.
///
/// # Errors
/// [`PlotError`]: no body, more than [`Look::MOST_SERIES`], or a point that is not a finite number.
pub fn force_figure(data: &ForceFigure) -> Result<Figure, PlotError> {
    let description = match data.bodies.as_slice() {
        [one] if !one.own.is_empty() => format!(
            "Force against indentation of {}: the Hertz law, the Hertz law with the constant indentation, and the \
             smoothed law. The force before contact is shaded.",
            one.name
        ),
        bodies => format!("Force against indentation of {}.", names(bodies.iter().map(|body| &body.name))),
    };
    Ok(Figure {
        title: data.title.clone(),
        description,
        width: Width::Column,
        columns: 1,
        panels: vec![force_panel(data)?],
    })
}

/// The panel of a [`ForceFigure`], its title left empty.
///
/// # Errors
/// As [`force_figure`].
pub fn force_panel(data: &ForceFigure) -> Result<Panel, PlotError> {
    check_count(data.bodies.len())?;
    let mut panel = Panel::new("", Axis::new(data.indentation.label()), Axis::new(data.force.label()));
    panel.limits.clone_from(&data.limits);
    panel.y.limits = data.top.map(|top| (0.0, top));
    for at in data.bodies.iter().filter_map(|body| body.rest) {
        panel.marks.push(Mark { label: "at rest under body weight".to_owned(), at, look: Look::OWN });
    }
    if let [one] = data.bodies.as_slice() {
        let curve = |label: &str, points: &Vec<Point>, look| Curve {
            label: label.to_owned(),
            points: points.clone(),
            look,
        };
        let hertz = if one.own.is_empty() { one.remarked("Hertz (1)") } else { "Hertz (1)".to_owned() };
        panel.curves.push(curve(&hertz, &one.hertz, Look::HERTZ));
        if !one.with_constant.is_empty() {
            panel.curves.push(curve("Hertz with cf (C.1)", &one.with_constant, Look::WITH_CONSTANT));
        }
        if !one.own.is_empty() {
            panel.curves.push(curve(&one.remarked("smoothed, at rest (C.9)"), &one.own, Look::OWN));
            panel.areas.push(Area { label: "before contact".to_owned(), points: before(&one.own) });
        }
        return Ok(panel);
    }
    for (index, body) in data.bodies.iter().enumerate() {
        let points = if body.own.is_empty() { &body.hertz } else { &body.own };
        panel.curves.push(Curve {
            label: body.remarked(&body.name),
            points: points.clone(),
            look: Look::series(index),
        });
    }
    Ok(panel)
}
