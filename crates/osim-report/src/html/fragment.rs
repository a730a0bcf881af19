//! What a page says about one model: sections, and what they need explained.

use maud::{Markup, html};

use super::detail_level::DetailLevel;
use super::explained::Topics;

/// One model on the page.
#[derive(Debug)]
pub(super) struct Fragment {
    pub(super) detail: DetailLevel,
    pub(super) html: String,
    /// Their anchors and headings; anchors are there only where the model stands alone, so that none comes twice.
    pub(super) sections: Vec<(&'static str, &'static str)>,
    pub(super) topics: Topics,
}

impl Fragment {
    pub(super) fn new(detail: DetailLevel) -> Self {
        Self { detail, html: String::new(), sections: Vec::new(), topics: Topics::default() }
    }

    /// Adds a section.
    pub(super) fn section(&mut self, id: &'static str, title: &'static str, body: &Markup) {
        let section = if self.detail.is_alone() {
            html! { section id=(id) aria-labelledby={ (id) "-title" } { h2 id={ (id) "-title" } { (title) } (body) } }
        } else {
            html! { h4 { (title) } (body) }
        };
        self.html.push_str(&section.0);
        self.sections.push((id, title));
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

/// A table in a box of its own, which scrolls where the page is too narrow; `name` says what it is to those who hear it.
pub(super) fn boxed(name: &str, table: &Markup) -> Markup {
    html! { div.wide role="group" aria-label=(name) tabindex="0" { (table) } }
}

/// A table under `caption` with one row of headers; those that begin with a blank stand above words, not numbers.
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
