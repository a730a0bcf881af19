//! The feet of a model on a page.

use crate::figures;
use maud::{Markup, PreEscaped, html};
use osim_planning::ModelFeet;

use super::fragment::Fragment;

const SECTION: (&str, &str) = ("feet", "Feet from the side and from above");

/// The section: `states` of one model, the last with its bones. Nothing without feet.
pub(super) fn section(fragment: &mut Fragment, states: &[ModelFeet]) {
    if let Some(figure) = fragment.wants(SECTION.0).then(|| figure(states)).flatten() {
        fragment.section(SECTION.0, SECTION.1, &figure);
    }
}

/// Meshes that are listed; more are counted.
const LISTED: usize = 12;

/// The figure with its caption.
pub(super) fn figure(states: &[ModelFeet]) -> Option<Markup> {
    let last = states.last()?;
    let svg = figures::feet_svg(states, &last.name, Some("Feet")).ok()?;
    let mut caption = "From the right and from above, at the default pose and to one scale.".to_owned();
    let had_spheres =
        states.split_last().is_some_and(|(_, before)| before.iter().any(ModelFeet::has_spheres));
    if had_spheres {
        caption.push_str(" Dashed: where spheres were before the change.");
    }
    let missing = figures::missing_meshes(last);
    Some(html! {
        figure { div.plot.feet role="group" aria-label="Feet" tabindex="0" { (PreEscaped(svg)) } figcaption { (caption) } }
        @if !missing.is_empty() {
            p.note { "No bones are drawn of " (osim_model::messages::listed(&missing, LISTED)) ": they are neither beside the model nor in its folder Geometry." }
        }
    })
}
