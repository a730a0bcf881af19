//! The sections about one model, each separately, for a front end that shows some now and others later.

use osim_inspect::ReferenceState;
use osim_inspect::series::ContactBody;
use osim_model::messages::{Dialect, terminal_safe};
use osim_patch::Plan;
use serde::Serialize;

use crate::html::change::{ChangedModelOnPage, add_change_sections, add_changes_section};
use crate::html::fragment::{Fragment, Section};
use crate::html::inspected::{self, InspectedModelOnPage};
use crate::html::special_models::DrawnStates;
use crate::html::{explained, plots};

/// The equations and codes that links in a section lead to.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Explained {
    /// The id of the element with the explanation, for links.
    pub id: String,
    /// The equation, finding or error, explained; an element with that anchor.
    pub html: String,
}

/// Sections about one model, and everything that their links lead to.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize)]
pub struct Sections {
    /// Sections in the order of a report.
    pub sections: Vec<Section>,
    pub explained: Vec<Explained>,
}

impl Sections {
    /// The sections of a fragment, with the explanations that their links lead to.
    fn of(fragment: Fragment, words: &dyn Dialect) -> Self {
        let explained = explained::explanations_by_anchor(&fragment.topics, words).into_iter();
        let explained =
            explained.map(|(id, html)| Explained { id, html: terminal_safe(&html.0).into_owned() });
        let sections = fragment.sections.into_iter();
        let sections =
            sections.map(|section| Section { html: terminal_safe(&section.html).into_owned(), ..section });
        Self { sections: sections.collect(), explained: explained.collect() }
    }

    /// Sections about a plan: the changes, and the plots of `bodies` that are `wanted`. `bodies` are the model before and after the change,
    /// and the reference if the contacts come from another body. Nothing else is computed, so that pictures can follow a slider.
    pub fn of_plan(
        plan: &Plan,
        bodies: &[ContactBody],
        reference: Option<&ReferenceState>,
        wanted: Option<&[String]>,
        words: &dyn Dialect,
    ) -> Self {
        let mut fragment = Fragment::of_wanted_sections(wanted);
        add_changes_section(&mut fragment, plan);
        if !bodies.is_empty() {
            let other = reference.and_then(|reference| reference.body.clone());
            let bodies = bodies.iter().cloned().chain(other).collect();
            let drawn = DrawnStates { bodies, has_reference: reference.is_some(), feet: Vec::new() };
            plots::add_sections(&mut fragment, &drawn, words);
        }
        Self::of(fragment, words)
    }

    /// The sections about a change whose names are in `wanted`; `None` for all sections.
    pub fn of_change(shown: ChangedModelOnPage<'_>, wanted: Option<&[String]>, words: &dyn Dialect) -> Self {
        let mut fragment = Fragment::of_wanted_sections(wanted);
        add_change_sections(&mut fragment, shown, words);
        Self::of(fragment, words)
    }

    /// The sections about an inspected model whose names are in `wanted`; `None` for all sections.
    pub fn of_model(shown: InspectedModelOnPage<'_>, wanted: Option<&[String]>, words: &dyn Dialect) -> Self {
        let mut fragment = Fragment::of_wanted_sections(wanted);
        inspected::add_inspection_sections(&mut fragment, shown, words);
        Self::of(fragment, words)
    }
}
