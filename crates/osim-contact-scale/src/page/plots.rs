//! Plots of a page, drawn by `contact_plots` from what `plotting` computes.

use anyhow::anyhow;
use contact_plots::{
    DropFigure, ForceAxis, ForceFigure, IndentationAxis, LoopFigure, drop_figure, force_figure, loop_figure,
};
use maud::{Markup, PreEscaped, html};

use super::fragment::Fragment;
use crate::args::Length;
use crate::failure::Failure;
use crate::plotting::body::Body;
use crate::plotting::series::{self, Axes};

const SECTION: (&str, &str) = ("plots", "Plots");
/// Shares of the weight of one sphere against x/R: bodies of all sizes fit into one figure.
const AXES: Axes = Axes { indentation: IndentationAxis::Relative, force: ForceAxis::WeightShare };
/// A fall from a quarter of the radius, as in the paper's drop tests.
const HEIGHT: Length = Length::Radii(0.25);

/// The section: what `bodies`, states of one model, do.
pub(super) fn section(fragment: &mut Fragment, bodies: &[Body]) {
    let pressed = if bodies.len() > 1 {
        "Force of a sphere that is pressed into the ground. Where curves lie on each other, the \
         contact without dimensions is the same."
    } else {
        "Force of a sphere that is pressed into the ground."
    };
    let drawn = [
        (pressed, force(bodies)),
        (
            "Force while a sphere goes in and out. The area inside is the energy that dissipation takes.",
            loops(bodies),
        ),
        (
            "A fall from a quarter of the radius, against time in seconds (A) and without dimensions (B).",
            drop(bodies),
        ),
    ];
    let mut reasons: Vec<&str> =
        drawn.iter().filter_map(|(_, drawn)| Some(drawn.as_ref().err()?.message.as_str())).collect();
    reasons.dedup();
    let body = html! {
        div.plots { @for (what, drawn) in &drawn { @if let Ok(svg) = drawn { (plot(what, svg)) } } }
        @for reason in reasons { p.note { "Not drawn: " (reason) "." } }
    };
    fragment.has_plots = drawn.iter().any(|(_, drawn)| drawn.is_ok());
    fragment.section(SECTION.0, SECTION.1, &body);
}

fn plot(what: &str, svg: &str) -> Markup {
    html! { figure { div.plot { (PreEscaped(svg)) } figcaption { (what) } } }
}

fn drawn(bodies: &[Body], svg: Result<String, contact_plots::PlotError>) -> Result<String, Failure> {
    let name = bodies.first().map(|body| body.name.clone()).unwrap_or_default();
    svg.map_err(|error| Failure::outside(&name, "plot", &anyhow!("{error}")))
}

fn force(bodies: &[Body]) -> Result<String, Failure> {
    let depth = series::depth(bodies);
    let curves = series::kinds(bodies).map(|(body, kind)| series::force(body, kind, AXES, depth));
    let figure = ForceFigure {
        title: "Force against indentation".to_owned(),
        indentation: AXES.indentation,
        force: AXES.force,
        bodies: curves.collect::<Result<_, _>>()?,
        limits: series::hertz_limit(AXES),
    };
    drawn(bodies, force_figure(&figure))
}

fn loops(bodies: &[Body]) -> Result<String, Failure> {
    let mut loops = Vec::new();
    for (body, kind) in series::kinds(bodies) {
        let speed = series::impact_speed(body, kind, HEIGHT)?;
        let mut one = series::hysteresis(body, kind, AXES, speed)?;
        // The page says whose it is: a model alone needs no name, which would push the figures out of the legend.
        let name = if bodies.len() > 1 { series::name_of(body, kind) } else { kind.spheres.clone() };
        if !name.is_empty() {
            one.name = format!("{name}: {}", one.name);
        }
        loops.push(one);
    }
    let figure = LoopFigure {
        title: "Dissipation".to_owned(),
        motion: "Half a sine wave, as deep as twice the body weight presses by the Hertz law; it begins with the speed \
                 of a fall from a quarter of the radius."
            .to_owned(),
        indentation: AXES.indentation,
        force: AXES.force,
        elastic: vec![],
        loops,
        limits: series::hertz_limit(AXES),
    };
    drawn(bodies, loop_figure(&figure))
}

fn drop(bodies: &[Body]) -> Result<String, Failure> {
    let duration = series::duration(bodies)?;
    let falls = bodies.iter().map(|body| series::fall(body, HEIGHT, duration));
    let figure = DropFigure {
        title: "Drop test".to_owned(),
        conditions: "They fall from a quarter of the sphere radius.".to_owned(),
        bodies: falls.collect::<Result<_, _>>()?,
    };
    drawn(bodies, drop_figure(&figure))
}
