//! The kinds of figures: what a contact does, from points somebody else computed.

use crate::axis::Axis;
use crate::error::PlotError;
use crate::figure::{Area, Curve, Direction, Figure, Limit, Mark, Panel, Point, Width};
use crate::style::{Dash, Look};

// What axes are measured in.

/// What the horizontal axis of an indentation is measured in.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum IndentationAxis {
    /// x̂ = x/R.
    #[default]
    Relative,
    /// x in mm.
    Millimetre,
}

impl IndentationAxis {
    fn label(self) -> &'static str {
        match self {
            Self::Relative => "relative indentation x̂ = x/R (–)",
            Self::Millimetre => "indentation x (mm)",
        }
    }
}

/// What a force is measured in.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum ForceAxis {
    /// N, of one sphere.
    #[default]
    Newton,
    /// The share of the body weight that one sphere carries, M g / n.
    WeightShare,
}

impl ForceAxis {
    fn label(self) -> &'static str {
        match self {
            Self::Newton => "force of one sphere (N)",
            Self::WeightShare => "force of one sphere / its share Mg/n (–)",
        }
    }
}

/// What time is measured in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum TimeAxis {
    /// s.
    Second,
    /// t / √(R/g).
    Dimensionless,
}

impl TimeAxis {
    fn label(self) -> &'static str {
        match self {
            Self::Second => "time t (s)",
            Self::Dimensionless => "non-dimensional time t/√(R/g) (–)",
        }
    }
}

// Force against indentation.

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

// Contact state against indentation.

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
/// As [`force_figure`].
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
/// As [`force_figure`].
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

// Force while a sphere goes in and out.

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
/// As [`force_figure`].
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

// Drop tests.

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
/// As [`force_figure`].
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
/// As [`force_figure`].
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

// What several kinds of figures share.

/// The points before contact, up to x = 0 itself.
fn before(points: &[Point]) -> Vec<Point> {
    let mut part: Vec<Point> = points.iter().copied().take_while(|(x, _)| *x <= 0.0).collect();
    let next = points.get(part.len());
    if let (Some(&(x0, y0)), Some(&(x1, y1))) = (part.last(), next)
        && x0 < 0.0
    {
        part.push((0.0, y0 + (y1 - y0) * (0.0 - x0) / (x1 - x0)));
    }
    part
}

fn names<'n>(names: impl Iterator<Item = &'n String>) -> String {
    names.map(String::as_str).collect::<Vec<_>>().join(", ")
}

fn check_count(count: usize) -> Result<(), PlotError> {
    if count > Look::MOST_SERIES {
        return Err(PlotError::TooMany { count, most: Look::MOST_SERIES });
    }
    Ok(())
}
