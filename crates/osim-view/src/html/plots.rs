//! The pictures on a page: plots, feet, and contacts along a recording.

use contact_plots::{Drawing, Figure, Paper};
use maud::{Markup, PreEscaped, html};
use osim_inspect::series::{ContactBody, ForceUnit, IndentationUnit, PlotUnits};
use osim_model::files::Failure;
use osim_model::messages::Dialect;
use osim_planning::{ModelFeet, MotionRemark, MotionResult};
use osim_requests::DropHeight;

use crate::figures;
use crate::html::explained::as_sentence;
use crate::html::fragment::{Fragment, Section, table};
use crate::html::special_models::DrawnStates;
use crate::report::results::motion_feet;

/// Id and title of the section with plots of force, dissipation and a drop test.
const PLOTS_SECTION: (&str, &str) = ("plots", "Plots of force, dissipation and a drop test");
/// Id and title of the section about the contact state. It is only shown if the caller names it, so not in reports.
const STATE_SECTION: (&str, &str) = ("state", "Contact state against indentation");
/// The units of the plots: shares of the weight against x/R. Bodies of all sizes fit into one figure with these.
const PLOT_UNITS: PlotUnits =
    PlotUnits { indentation: IndentationUnit::Relative, force: ForceUnit::WeightShare };
/// The height of falls in the plots: a quarter of the radius, as in the paper's drop tests.
const HEIGHT_OF_FALLS: DropHeight = DropHeight::Radii(0.25);

/// Adds the sections with the feet and the plots of `drawn`. Without feet or bodies, no such section.
pub(super) fn add_sections(fragment: &mut Fragment, drawn: &DrawnStates, dialect: &dyn Dialect) {
    if let Some(figure) = fragment.is_wanted(FEET_SECTION.0).then(|| feet_figure(&drawn.feet)).flatten() {
        fragment.add_section(FEET_SECTION.0, FEET_SECTION.1, &figure);
    }
    if drawn.bodies.is_empty() {
        return;
    }
    if fragment.is_wanted(PLOTS_SECTION.0) {
        let plots = figures(&drawn.bodies, drawn.has_reference, dialect);
        fragment.add_section(PLOTS_SECTION.0, PLOTS_SECTION.1, &plots);
    }
    state_section(fragment, &drawn.bodies);
}

/// Adds the section about the contact state of a smoothed law, if the caller names the section. A law without smoothing has no such
/// section.
fn state_section(fragment: &mut Fragment, bodies: &[ContactBody]) {
    let drawn = || figures::contact_state(bodies, PLOT_UNITS, None, Some("Contact state"));
    if fragment.is_named(STATE_SECTION.0)
        && let Ok(svg) = svg_or_failure(bodies, drawn())
    {
        let what = "How softly contact begins: from 0, no contact, to 1. Where curves lie on each other, the dimensionless smoothing is the same.";
        let body = html! { div.plots { (plot_with_caption(what, &svg)) } };
        fragment.add_section(STATE_SECTION.0, STATE_SECTION.1, &body);
    }
}

/// The figures with their captions, and for a figure that cannot be drawn the reason.
pub(super) fn figures(bodies: &[ContactBody], has_reference: bool, dialect: &dyn Dialect) -> Markup {
    let pressed = if has_reference {
        "Force of a sphere that is pressed into the ground, before and after the change, and of the reference. The curve \
         after the change and that of the reference lie on each other where the dimensionless contact is the same; the \
         curve before it is that of other contacts."
    } else if bodies.len() > 1 {
        "Force of a sphere that is pressed into the ground. Where curves lie on each other, the dimensionless contact is the same."
    } else {
        "Force of a sphere that is pressed into the ground."
    };
    let from = "a quarter of the sphere radius";
    let drawn = [
        (pressed, figures::contact_force(bodies, PLOT_UNITS, None, Some("Force against indentation"))),
        (
            "Force while a sphere goes in and out. The area inside is the energy that dissipation takes.",
            figures::impact_loops(bodies, PLOT_UNITS, HEIGHT_OF_FALLS, Some("Dissipation")),
        ),
        (
            "A fall from a quarter of the radius, against time in seconds (A) and in dimensionless form (B).",
            figures::drops(bodies, HEIGHT_OF_FALLS, from, None, Some("Drop test")),
        ),
    ]
    .map(|(what, figure)| (what, svg_or_failure(bodies, figure)));
    let mut reasons: Vec<String> =
        drawn.iter().filter_map(|(_, drawn)| Some(drawn.as_ref().err()?.message.spelled(dialect))).collect();
    reasons.dedup();
    html! {
        div.plots { @for (what, drawn) in &drawn { @if let Ok(svg) = drawn { (plot_with_caption(what, svg)) } } }
        @for reason in reasons { p.aside { "Not drawn: " (reason) "." } }
    }
}

fn plot_with_caption(what: &str, svg: &str) -> Markup {
    html! { figure { div.plot { (PreEscaped(svg)) } figcaption { (what) } } }
}

/// A figure as SVG. The forces were chosen for the whole page, so the failure does not propose to choose other forces.
fn svg_or_failure(bodies: &[ContactBody], figure: Result<Figure, Failure>) -> Result<String, Failure> {
    let svg = figure?.distinct().and_then(|figure| Drawing::Panels(figure).svg(Paper::default()));
    let name = || bodies.first().map(|body| body.name.clone()).unwrap_or_default();
    svg.map_err(|error| Failure::outside(name(), "plot", error.to_string()))
}

// The feet of a model on a page.

/// Id and title of the section with pictures of the feet.
const FEET_SECTION: (&str, &str) = ("feet", "Feet from the side and from above");

/// The largest number of meshes that are listed; if there are more, the page has their number.
const MOST_LISTED_MESHES: usize = 12;

/// The figure of the feet, with its caption.
pub(super) fn feet_figure(states: &[ModelFeet]) -> Option<Markup> {
    let last = states.last()?;
    let scene = Drawing::Scene(figures::feet(states, Some("Feet")));
    let svg = figures::svg(&scene, Paper::default(), &[]).ok()?;
    let mut caption = "From the right and from above, at the default pose and to one scale.".to_owned();
    let had_spheres =
        states.split_last().is_some_and(|(_, before)| before.iter().any(ModelFeet::has_spheres));
    if had_spheres {
        caption.push_str(" Dashed: where spheres were before the change.");
    }
    let missing = figures::names_of_missing_meshes(last);
    Some(html! {
        figure { div.plot.feet role="group" aria-label="Feet" tabindex="0" { (PreEscaped(svg)) } figcaption { (caption) } }
        @if !missing.is_empty() {
            p.aside { "No bones are drawn of " (osim_model::messages::listed(&missing, MOST_LISTED_MESHES)) ": they are neither beside the model nor in its folder Geometry." }
        }
    })
}

// What contacts do along a recording: words, one row for each foot, and the figure.

/// Makes the section about contacts along a recording. It is a function of its own, so that pages without a recording do not need this
/// code.
pub fn recording(result: &MotionResult, remarks: &[MotionRemark], dialect: &dyn Dialect) -> Section {
    let body = html! {
        p.aside {
            (result.motion.to_string()) ": " (result.states.frames()) " frames."
        }
        ul { @for remark in remarks { li { (as_sentence(&remark.message.spelled(dialect))) } } }
        (feet_table(result))
        (recording_figure(result, dialect))
    };
    Section { id: "recording", title: "Contacts along the recording", html: body.0 }
}

fn feet_table(result: &MotionResult) -> Markup {
    let (columns, rows) = motion_feet(result);
    let rows = html! {
        @for row in rows {
            tr { @for (index, cell) in row.iter().enumerate() { @if index == 0 { th scope="row" { (cell) } } @else { td { (cell) } } } }
        }
    };
    let caption = "Forces along the normal of the floor, in body weights (BW): the largest of the model and of the plates, and the root mean \
                   square of their difference. COP: the root mean square distance between the centres of pressure.";
    table("Feet along the recording", caption, &columns, &rows)
}

fn recording_figure(result: &MotionResult, dialect: &dyn Dialect) -> Markup {
    let drawing = Drawing::Panels(figures::motion(result, None));
    match figures::svg(&drawing, Paper::default(), &[]) {
        Ok(svg) => html! {
            div.plots { figure {
                div.plot { (PreEscaped(svg)) }
                figcaption { "For each foot: its force beside the plates'; how deep each sphere is, over time and over strides; where the force acts on the sole; forces of one stance along the foot." }
            } }
        },
        Err(failure) => html! { p.aside { "Not drawn: " (failure.message.spelled(dialect)) "." } },
    }
}
