//! The models of a library that are drawn, with the reasons.

use maud::{Markup, html};
use osim_model::messages::Dialect;

use super::values::broken_at_folders;
use super::{feet, plots};
use crate::html::special::Chosen;

pub(super) const SECTION: (&str, &str) = ("chosen", "Plots of special models");

/// The section.
pub(super) fn section(chosen: &Chosen, dialect: &dyn Dialect) -> Markup {
    let (id, title) = SECTION;
    let models = chosen.choice();
    let feet = models.iter().any(|(one, _)| !one.drawn.feet.is_empty());
    html! {
        section id=(id) aria-labelledby="chosen-title" {
            h2 id="chosen-title" { (title) }
            p {
                (models.len()) " of " (chosen.models()) " models are drawn: those with the most findings, the deepest and the \
                 least deep, the heaviest and the lightest, the most common, and one for each other finding."
                @if !feet { " Feet are drawn on pages about few models, or about one." }
            }
            @for (one, reasons) in &models {
                div.chosen {
                    h3 { (broken_at_folders(&one.model)) }
                    p { b { "Chosen because: " } (reasons.join("; ")) "." }
                    @if let Some(drawn) = feet::figure(&one.drawn.feet) { (drawn) }
                    @if !one.drawn.bodies.is_empty() {
                        (plots::figures(&one.drawn.bodies, one.drawn.has_reference, dialect))
                    }
                }
            }
        }
    }
}
