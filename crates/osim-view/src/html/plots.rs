//! Plots of a page.

use crate::figures as draw;
use contact_plots::{
    Drawing, Figure, Paper, PlotError, drop_figure, force_figure, loop_figure, state_figure,
};
use maud::{Markup, PreEscaped, html};
use osim_inspect::series::{Body, ForceUnit, IndentationUnit, Units};
use osim_model::files::Failure;
use osim_model::messages::Dialect;
use osim_requests::DropHeight;

use super::fragment::Fragment;

const SECTION: (&str, &str) = ("plots", "Plots of force, dissipation and a drop test");
/// For a page that has room for it; reports have the three others.
const STATE: (&str, &str) = ("state", "Contact state against indentation");
/// Shares of the weight of one sphere against x/R: bodies of all sizes fit into one figure.
const UNITS: Units = Units { indentation: IndentationUnit::Relative, force: ForceUnit::WeightShare };
/// A fall from a quarter of the radius, as in the paper's drop tests.
const HEIGHT: DropHeight = DropHeight::Radii(0.25);

/// The section: what `bodies`, states of one model, do.
///
/// `has_reference`: the last one is another body.
pub(super) fn section(fragment: &mut Fragment, bodies: &[Body], has_reference: bool, dialect: &dyn Dialect) {
    if fragment.wants(SECTION.0) {
        fragment.section(SECTION.0, SECTION.1, &figures(bodies, has_reference, dialect));
    }
}

/// The section about the contact state of a smoothed law, if it is asked for; there is none without smoothing.
pub(super) fn state_section(fragment: &mut Fragment, bodies: &[Body]) {
    let svg = fragment.names(STATE.0).then(|| state(bodies).ok()).flatten();
    if let Some(svg) = svg {
        let what = "How softly contact sets in: from 0, no contact, to 1. Where curves lie on each other, the smoothing without \
                    dimensions is the same.";
        fragment.section(STATE.0, STATE.1, &html! { div.plots { (plot(what, &svg)) } });
    }
}

/// The figures with their captions, and why one is not there.
pub(super) fn figures(bodies: &[Body], has_reference: bool, dialect: &dyn Dialect) -> Markup {
    let pressed = if has_reference {
        "Force of a sphere that is pressed into the ground, before and after the change, and of the reference. The curve \
         after the change and that of the reference lie on each other where the contact without dimensions is the same; the \
         curve before it is that of other contacts."
    } else if bodies.len() > 1 {
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
            drops(bodies),
        ),
    ];
    let mut reasons: Vec<String> =
        drawn.iter().filter_map(|(_, drawn)| Some(drawn.as_ref().err()?.message.spelled(dialect))).collect();
    reasons.dedup();
    html! {
        div.plots { @for (what, drawn) in &drawn { @if let Ok(svg) = drawn { (plot(what, svg)) } } }
        @for reason in reasons { p.note { "Not drawn: " (reason) "." } }
    }
}

fn plot(what: &str, svg: &str) -> Markup {
    html! { figure { div.plot { (PreEscaped(svg)) } figcaption { (what) } } }
}

/// What was drawn. Which forces are shown was chosen for the whole page, so a failure does not propose to choose others.
fn drawn(bodies: &[Body], figure: Result<Figure, PlotError>) -> Result<String, Failure> {
    let name = bodies.first().map(|body| body.name.clone()).unwrap_or_default();
    let svg = figure.and_then(|figure| Drawing::Panels(figure).svg(Paper::default()));
    svg.map_err(|error| Failure::outside(&name, "plot", error.to_string()))
}

fn force(bodies: &[Body]) -> Result<String, Failure> {
    let figure = draw::force(bodies, UNITS, None, Some("Force against indentation"))?;
    drawn(bodies, force_figure(&figure))
}

fn state(bodies: &[Body]) -> Result<String, Failure> {
    let figure = draw::state(bodies, UNITS, None, Some("Contact state"))?;
    drawn(bodies, state_figure(&figure))
}

fn loops(bodies: &[Body]) -> Result<String, Failure> {
    let figure = draw::impact_loops(bodies, UNITS, HEIGHT, Some("Dissipation"))?;
    drawn(bodies, loop_figure(&figure))
}

fn drops(bodies: &[Body]) -> Result<String, Failure> {
    let figure = draw::drops(bodies, HEIGHT, None, Some("Drop test"))?;
    let conditions = "They fall from a quarter of the sphere radius.".to_owned();
    drawn(bodies, drop_figure(&contact_plots::DropFigure { conditions, ..figure }))
}
