//! The sections about one model, with the equations, findings and errors that they name.

use maud::{Markup, PreEscaped, html};
use serde::Serialize;

use crate::html::explained::Topics;
use crate::html::page_frame::section;

/// The sections of one model on the page.
pub(super) struct Fragment {
    pub(super) detail: DetailLevel,
    pub(super) sections: Vec<Section>,
    pub(super) topics: Topics,
    /// Ids of the sections that the caller wants; `None` for all sections.
    wanted: Option<Vec<String>>,
}

impl Fragment {
    /// No sections yet, on a page with this level of detail.
    pub(super) fn new(detail: DetailLevel) -> Self {
        Self { detail, sections: Vec::new(), topics: Topics::default(), wanted: None }
    }

    /// An empty fragment of a page about one model, which will only have the sections in `wanted`.
    pub(super) fn of_wanted_sections(wanted: Option<&[String]>) -> Self {
        Self { wanted: wanted.map(<[String]>::to_vec), ..Self::new(DetailLevel::Alone) }
    }

    /// Whether the caller wants the section `id`. Other sections need not be made.
    pub(super) fn is_wanted(&self, id: &str) -> bool {
        self.wanted.as_ref().is_none_or(|wanted| wanted.iter().any(|one| one == id))
    }

    /// Whether the caller wants the section `id` and named it. Some sections are shown only if they are named.
    pub(super) fn is_named(&self, id: &str) -> bool {
        self.wanted.is_some() && self.is_wanted(id)
    }

    /// Adds a section, if the caller wants it.
    pub(super) fn add_section(&mut self, id: &'static str, title: &'static str, body: &Markup) {
        if self.is_wanted(id) {
            self.sections.push(Section { id, title, html: body.0.clone() });
        }
    }

    /// All sections with their headings; with anchors if the page is about one model.
    pub(super) fn html(&self) -> String {
        let one = |part: &Section| {
            let (id, title, body) = (part.id, part.title, PreEscaped(&part.html));
            if self.detail.is_alone() {
                section((id, title), &html! { (body) })
            } else {
                html! { h4 { (title) } (body) }
            }
        };
        self.sections.iter().map(|part| one(part).0).collect()
    }

    /// A heading inside a section of this model.
    pub(super) fn heading(&self, text: &str) -> Markup {
        if self.detail.is_alone() {
            html! { h3 { (text) } }
        } else {
            html! { h5 { (text) } }
        }
    }
}

/// A table in a box that scrolls if the page is too narrow. Screen readers call it `name`.
pub(super) fn scrollable(name: &str, table: &Markup) -> Markup {
    html! { div.wide role="group" aria-label=(name) tabindex="0" { (table) } }
}

/// A table with a caption and a row of headers. A header that begins with a blank is for a column of words instead of numbers.
pub(super) fn table(name: &str, caption: &str, headers: &[&str], rows: &Markup) -> Markup {
    let table = html! {
        table {
            caption { span { (caption) } }
            thead { tr { @for header in headers { (header_cell(header)) } } }
            tbody { (rows) }
        }
    };
    scrollable(name, &table)
}

/// A table, or nothing without rows.
pub(super) fn table_if_any(name: &str, caption: &str, headers: &[&str], rows: &Markup) -> Markup {
    if rows.0.is_empty() {
        html! {}
    } else {
        table(name, caption, headers, rows)
    }
}

pub(super) fn header_cell(header: &str) -> Markup {
    let class = header.starts_with(' ').then_some("words");
    html! { th class=[class] scope="col" { (header.trim_start_matches(' ')) } }
}

/// A section of the page, without its heading.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Section {
    /// Name of the section, such as `plots`.
    pub id: &'static str,
    pub title: &'static str,
    pub html: String,
}

/// The largest number of models on a page that draws feet. Bones need most of the time and most of the size of a page.
const MOST_MODELS_WITH_FEET: usize = 20;

/// The amount of detail with which a page shows each model.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DetailLevel {
    /// The page is about a single model.
    Alone,
    /// The page is about few models. It may draw their feet.
    OneOfFew,
    OneOfMany,
}

impl DetailLevel {
    /// The level of detail on a page about this many models.
    pub const fn for_models(models: usize) -> Self {
        match models {
            0 | 1 => Self::Alone,
            2..=MOST_MODELS_WITH_FEET => Self::OneOfFew,
            _ => Self::OneOfMany,
        }
    }

    /// Whether a page with this level of detail draws feet.
    pub const fn has_feet(self) -> bool {
        !matches!(self, Self::OneOfMany)
    }

    pub(super) const fn is_alone(self) -> bool {
        matches!(self, Self::Alone)
    }
}
