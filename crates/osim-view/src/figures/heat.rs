//! A quantity over stiffness and dissipation.

use contact_plots::{
    Axis, Curve, Direction, Drawing, Figure, HeatLimit, HeatMap, Limit, Look, Mark, Panel, Width,
};
use contact_scaling::limits;
use osim_inspect::series::{self, Body, HeatRequest, Parameter, Profile};
use osim_model::files::Failure;
use osim_model::messages::{Input, phrase};
use osim_requests::HeatQuantity;

use super::names::failure;

/// Colours over E₁* and α for the one contact of the one body; `stiffness` and `dissipation` make axes of its own E₁* (N/m²)
/// and α (s/m). Where only one of the two changes the quantity, a curve over that one.
///
/// # Errors
/// There are several bodies or contacts, the weight is not known, or the contact has no dissipation to multiply.
pub fn heat(
    bodies: &[Body],
    request: &HeatRequest,
    stiffness: impl FnOnce(f64) -> Vec<f64>,
    dissipation: impl FnOnce(f64) -> Vec<f64>,
    wanted_title: Option<&str>,
) -> Result<Drawing, Failure> {
    let body = only(bodies)?;
    let series = series::heat(body, request, stiffness, dissipation)?;
    let words = Words::of(request.quantity);
    let title = wanted_title.map_or_else(|| format!("{}: {}", words.title, body.name), str::to_owned);
    let now = format!("{} now", body.name);
    if let Some(profile) = series.profile {
        return Ok(Drawing::Panels(curve(
            profile,
            series.limit,
            &words,
            Texts { title, body: &body.name, now },
        )));
    }
    Ok(Drawing::HeatMap(HeatMap {
        title,
        description: format!(
            "{} of {} as a colour, over stiffness E₁* and dissipation α, both on logarithmic axes.",
            words.label, body.name
        ),
        x_axis: Axis::logarithmic(STIFFNESS),
        y_axis: Axis::logarithmic(DISSIPATION),
        value_axis: value_axis(words.label, &series.values),
        values: series.values,
        x: series.x,
        y: series.y,
        limit: series.limit.map(|at| HeatLimit { label: words.limit.clone(), at }),
        mark: Some((now, series.now)),
    }))
}

const STIFFNESS: &str = "stiffness E₁* (N/m²)";
const DISSIPATION: &str = "dissipation α (s/m)";
/// If the largest value is more than this many times the smallest, equal ratios have equal steps of colour: else most of the map
/// would have one.
const WIDE: f64 = 8.0;

/// How a quantity becomes a colour.
pub(super) fn value_axis(label: &str, values: &[Vec<Option<f64>>]) -> Axis {
    let values = || values.iter().flatten().flatten().copied();
    let (low, high) = (values().fold(f64::INFINITY, f64::min), values().fold(f64::NEG_INFINITY, f64::max));
    if low > 0.0 && high > WIDE * low { Axis::logarithmic(label) } else { Axis::new(label) }
}

/// What a curve says beside its axes.
struct Texts<'t> {
    title: String,
    /// Name of the body.
    body: &'t str,
    /// At the point where the body is now.
    now: String,
}

/// The quantity along the one parameter that changes it.
fn curve(profile: Profile, limit: Option<f64>, words: &Words, texts: Texts<'_>) -> Figure {
    let Texts { title, body, now } = texts;
    let (axis, other) = match profile.along {
        Parameter::Stiffness => (STIFFNESS, "dissipation α"),
        Parameter::Dissipation => (DISSIPATION, "stiffness E₁*"),
    };
    let mut panel = Panel::new("", Axis::logarithmic(axis), Axis::new(words.label));
    panel.curves.push(Curve { label: words.curve.to_owned(), points: profile.points, look: Look::HERTZ });
    panel.marks.extend(profile.now.map(|at| Mark { label: now, at, look: Look::OWN }));
    panel.limits.extend(limit.map(|at| Limit {
        label: words.limit.clone(),
        at,
        direction: Direction::Horizontal,
    }));
    Figure {
        title,
        description: format!(
            "{} of {body} over {axis}, on a logarithmic axis. It does not depend on the {other}, so it is a curve and no \
             heat map.",
            words.label
        ),
        width: Width::Column,
        columns: 1,
        panels: vec![panel],
    }
}

/// The one body of a figure that is about one.
fn only(bodies: &[Body]) -> Result<&Body, Failure> {
    match bodies {
        [one] => Ok(one),
        _ => {
            let why = phrase!["a sweep is about one body: name one model, without ", Input::TargetMass];
            Err(failure(bodies, why))
        }
    }
}

/// How a quantity is called.
struct Words {
    title: &'static str,
    label: &'static str,
    /// The curve, in the legend.
    curve: &'static str,
    limit: String,
}

impl Words {
    fn of(quantity: HeatQuantity) -> Self {
        match quantity {
            HeatQuantity::Indentation => Self {
                title: "Indentation at rest",
                label: "x̂ under body weight, Hertz (–)",
                curve: "at rest, by (11)",
                limit: format!("x̂ = {}, limit of the Hertz law", limits::INDENTATION.value),
            },
            HeatQuantity::Restitution => Self {
                title: "Restitution",
                label: "coefficient of restitution (–)",
                curve: "exact, at the impact speed",
                limit: format!("{} by (13), limit of the Hunt–Crossley law", limits::RESTITUTION.value),
            },
            HeatQuantity::PeakForce => Self {
                title: "Peak force of the drop",
                label: "peak force / body weight (–)",
                curve: "in the drop",
                limit: String::new(),
            },
        }
    }
}
