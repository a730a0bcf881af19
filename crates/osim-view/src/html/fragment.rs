//! What a page says about one model: sections, and what they need explained.

use maud::{Markup, PreEscaped, html};
use serde::Serialize;

use crate::html::explained::Topics;

/// One model on the page.
#[derive(Debug)]
pub(super) struct Fragment {
    pub(super) detail: DetailLevel,
    pub(super) sections: Vec<Section>,
    pub(super) topics: Topics,
    /// The sections that are asked for; `None` for all.
    wanted: Option<Vec<String>>,
}

impl Fragment {
    pub(super) fn new(detail: DetailLevel) -> Self {
        Self { detail, sections: Vec::new(), topics: Topics::default(), wanted: None }
    }

    /// A model alone, with only the sections that are asked for.
    pub(super) fn of_some(wanted: Option<&[String]>) -> Self {
        Self { wanted: wanted.map(<[String]>::to_vec), ..Self::new(DetailLevel::Alone) }
    }

    /// Whether the section `id` is asked for. The others need not be made.
    pub(super) fn wants(&self, id: &str) -> bool {
        self.wanted.as_ref().is_none_or(|wanted| wanted.iter().any(|one| one == id))
    }

    /// Whether the section `id` is asked for by its name: one that reports do without.
    pub(super) fn names(&self, id: &str) -> bool {
        self.wanted.is_some() && self.wants(id)
    }

    /// Adds a section, if it is asked for.
    pub(super) fn section(&mut self, id: &'static str, title: &'static str, body: &Markup) {
        if self.wants(id) {
            self.sections.push(Section { id, title, html: body.0.clone() });
        }
    }

    /// All sections with their headings. Anchors are there only where the model stands alone, so that none comes twice.
    pub(super) fn html(&self) -> String {
        let one = |section: &Section| {
            let (id, title, body) = (section.id, section.title, PreEscaped(&section.html));
            if self.detail.is_alone() {
                html! { section id=(id) aria-labelledby={ (id) "-title" } { h2 id={ (id) "-title" } { (title) } (body) } }
            } else {
                html! { h4 { (title) } (body) }
            }
        };
        self.sections.iter().map(|section| one(section).0).collect()
    }

    /// A heading inside a section.
    pub(super) fn heading(&self, text: &str) -> Markup {
        if self.detail.is_alone() {
            html! { h3 { (text) } }
        } else {
            html! { h5 { (text) } }
        }
    }
}

/// A table in a box of its own, which scrolls where the page is too narrow; `name` says what it is in screen readers.
pub(super) fn boxed(name: &str, table: &Markup) -> Markup {
    html! { div.wide role="group" aria-label=(name) tabindex="0" { (table) } }
}

/// A table under `caption` with one row of headers; those that begin with a blank are above words, not numbers.
pub(super) fn table(name: &str, caption: &str, headers: &[&str], rows: &[Markup]) -> Markup {
    let table = html! {
        table {
            caption { span { (caption) } }
            thead { tr { @for header in headers { (header_cell(header)) } } }
            tbody { @for row in rows { (row) } }
        }
    };
    boxed(name, &table)
}

pub(super) fn header_cell(header: &str) -> Markup {
    let class = header.starts_with(' ').then_some("words");
    html! { th class=[class] scope="col" { (header.trim_start_matches(' ')) } }
}

/// One section, without its heading.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Section {
    /// Its name, such as `plots`.
    pub id: &'static str,
    pub title: &'static str,
    pub html: String,
}

/// Models of a library whose feet may be drawn: bones take most of the time and the room of a page.
const FEW: usize = 20;

/// How much of a model a page shows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DetailLevel {
    /// The page is about this model alone.
    Alone,
    /// One of few: its feet may be drawn.
    OneOfFew,
    OneOfMany,
}

impl DetailLevel {
    /// The level for each model on a page about this many.
    pub const fn of(models: usize) -> Self {
        match models {
            0 | 1 => Self::Alone,
            2..=FEW => Self::OneOfFew,
            _ => Self::OneOfMany,
        }
    }

    /// Whether feet may be drawn.
    pub const fn has_feet(self) -> bool {
        !matches!(self, Self::OneOfMany)
    }

    pub(super) const fn is_alone(self) -> bool {
        matches!(self, Self::Alone)
    }
}
