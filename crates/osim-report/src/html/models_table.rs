//! The table of a library's models, and their details below it.

use maud::{Markup, html};

use super::entry::Entry;
use super::explained::Topics;
use super::fragment::header_cell;

pub(super) const MODELS: (&str, &str) = ("models", "Models");
pub(super) const IN_FULL: (&str, &str) = ("in-full", "Each model in full");

pub(super) const TABLE_END: &str = "</tbody></table></div></section>\n";
pub(super) const DETAILS_BEGIN: &str = "<section id=\"in-full\" aria-labelledby=\"in-full-title\">\
                                        <h2 id=\"in-full-title\">Each model in full</h2>\n";
pub(super) const DETAILS_END: &str = "</section>\n";

/// Which table the models are in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Columns {
    /// What changed.
    Changes,
    /// What was found.
    Inspections,
}

impl Columns {
    /// Those that begin with a blank stand above words, not numbers.
    fn headers(self) -> &'static [&'static str] {
        match self {
            Self::Changes => &[
                " outcome",
                "from, kg",
                "to, kg",
                "changes",
                "radius ×",
                "stiffness ×",
                "dissipation ×",
                "warned",
                "errors",
                "warnings",
                "remarks",
            ],
            Self::Inspections => &[
                " outcome",
                "weighs, kg",
                "contacts for, kg",
                "spheres per limb",
                "deepest x/R at 1 BW",
                "errors",
                "warnings",
                "remarks",
            ],
        }
    }

    fn explained(self) -> &'static str {
        match self {
            Self::Changes => {
                "From and to: the body mass that the contacts are made for. ×: new over old; “unequal” where it is not \
                 the same everywhere. Warned: warnings of the change. Errors, warnings, remarks: findings in the new model."
            }
            Self::Inspections => {
                "Deepest x/R: indentation over radius of the sphere that sinks in most under the body weight on one \
                 limb, by the Hertz law."
            }
        }
    }
}

/// The table as far as its first row; `left_out` says what the page does not show.
pub(super) fn table_opening(columns: Columns, left_out: &[String]) -> String {
    let (id, title) = MODELS;
    let before = html! {
        h2 id="models-title" { (title) }
        @for text in left_out { p.note { (text) } }
    };
    let head = html! {
        caption { span { (columns.explained()) } }
        thead { tr { th scope="col" { "model" } @for header in columns.headers() { (header_cell(header)) } } }
    };
    let (before, head) = (before.0, head.0);
    format!(
        "<section id=\"{id}\" aria-labelledby=\"models-title\">{before}\
         <div class=\"wide\" role=\"region\" aria-label=\"{title}\" tabindex=\"0\">\
         <table class=\"models\">{head}<tbody>\n"
    )
}

/// The row of model `number`, linked to its details where it has some.
pub(super) fn row(
    entry: &Entry,
    columns: Columns,
    (number, in_full): (usize, bool),
    topics: &mut Topics,
) -> String {
    let missing = columns.headers().len().saturating_sub(entry.cells.len());
    let row = html! {
        tr {
            th scope="row" {
                @if in_full { a href={ "#model-" (number) } { (entry.model) } } @else { (entry.model) }
            }
            @for (index, cell) in entry.cells.iter().enumerate() {
                @if index == 0 { td.words { (cell) (code(entry, topics)) } } @else { td { (cell) } }
            }
            @for _ in 0..missing { td {} }
        }
    };
    format!("{}\n", row.0)
}

/// Everything about model `number`, closed until somebody asks.
///
/// The anchor is inside: a browser that follows a link into closed details opens them.
pub(super) fn details(entry: &Entry, number: usize, inside: &str) -> String {
    let summary = html! { h3 { (entry.model) } " " span.quiet { (entry.summary) } };
    format!(
        "<details><summary>{}</summary><div class=\"model\" id=\"model-{number}\">{inside}</div></details>\n",
        summary.0
    )
}

/// The one model of a page, where there is nothing to show of it.
pub(super) fn alone(entry: &Entry, topics: &mut Topics) -> String {
    html! { p.note { b { (entry.model) } ": " (entry.summary) (code(entry, topics)) } }.0
}

/// The code of what was wrong, linked to its explanation.
fn code(entry: &Entry, topics: &mut Topics) -> Markup {
    html! { @if let Some(error) = entry.error { " [" (topics.error(error)) "]" } }
}
