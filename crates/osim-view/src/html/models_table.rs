//! The table of the models of a library, the details of the models below it, and the models with plots.

use maud::{Markup, html};
use osim_model::messages::Dialect;

use crate::html::entry::{Cell, DONE_EARLIER_MARK, Entry};
use crate::html::explained::{Topics, breakable_path};
use crate::html::fragment::header_cell;
use crate::html::page_frame::{section as titled_section, section_opening};
use crate::html::plots;
use crate::html::special_models::ChosenModels;

/// Id and title of the section with the table of models.
pub(super) const MODELS_SECTION: (&str, &str) = ("models", "Models");
/// Id and title of the section that shows each model in full.
pub(super) const MODELS_IN_FULL_SECTION: (&str, &str) = ("in-full", "Each model in full");

/// The end of the table of failed models, in HTML.
pub(super) const END_OF_FAILURES: &str = "</tbody></table></div>\n";
/// The end of the table of models and of its section, in HTML.
pub(super) const END_OF_TABLE: &str = "</tbody></table></div></section>\n";
/// The end of a section, in HTML.
pub(super) const END_OF_SECTION: &str = "</section>\n";

/// The set of columns in the table of models.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Columns {
    Changes,
    Inspections,
}

impl Columns {
    /// Headings of the columns. A heading that begins with a blank is above words instead of numbers.
    fn headers(self) -> Vec<&'static str> {
        let headers = match self {
            Self::Changes => {
                " outcome|made for, kg|numbers changed|radius, m|stiffness, N/m²|dissipation, s/m|x/R at 1 BW|\
                 findings of the change| findings in the new model"
            }
            Self::Inspections => {
                " outcome|weighs, kg|contacts for, kg|spheres per limb|x/R at 1 BW| findings"
            }
        };
        headers.split('|').collect()
    }

    fn failures_caption(self) -> &'static str {
        match self {
            Self::Changes => "Nothing was written for these models. Codes are explained below.",
            Self::Inspections => "These models could not be read or checked. Codes are explained below.",
        }
    }

    fn caption(self) -> &'static str {
        match self {
            Self::Changes => {
                "Old → new. Made for: the body mass that the contacts are made for. ×: new over old; “unequal” where it is not \
                 the same everywhere. x/R at 1 BW: x̂ of the sphere that sinks in most under the body weight on one limb, by the \
                 Hertz law; ! is outside the limit."
            }
            Self::Inspections => {
                "x/R at 1 BW: x̂, indentation over radius of the sphere that sinks in most under the body weight on one limb, by \
                 the Hertz law; ! is outside the limit."
            }
        }
    }
}

/// The beginning of the table, before its first row. `left_out` are sentences about models that the page does not show.
pub(super) fn table_opening(columns: Columns, left_out: &[String]) -> String {
    let remarks = html! { @for text in left_out { p.aside { (text) } } };
    let headers = [vec!["model"], columns.headers()].concat();
    let table = opening_of_table(MODELS_SECTION.1, "models", columns.caption(), &headers);
    format!("{}{}{table}", section_opening(MODELS_SECTION), remarks.0)
}

/// A table of models up to its first row.
fn opening_of_table(title: &str, class: &str, caption: &str, headers: &[&str]) -> String {
    let head = html! {
        caption { span { (caption) } }
        thead { tr { @for header in headers { (header_cell(header)) } } }
    };
    format!(
        "<div class=\"wide\" role=\"group\" aria-label=\"{title}\" tabindex=\"0\"><table class=\"{class}\">{}<tbody>\n",
        head.0
    )
}

/// The row of a model. It is linked to the details of the model by their number `details`, if the page has them.
pub(super) fn row(entry: &Entry, columns: Columns, details: Option<usize>, topics: &mut Topics) -> String {
    let name = breakable_path(&entry.model);
    let empty = columns.headers().len().saturating_sub(1 + entry.cells.len());
    let row = html! {
        tr {
            th scope="row" { @if let Some(number) = details { a href={ "#model-" (number) } { (name) } } @else { (name) } }
            @if entry.cells.is_empty() {
                td.words colspan=(columns.headers().len()) { (entry.outcome) (code(entry, topics)) }
            } @else {
                td.words { (entry.outcome) @if entry.earlier { (DONE_EARLIER_MARK) } }
                @for cell in &entry.cells { (table_cell(cell)) }
                @if empty > 0 { td colspan=(empty) {} }
            }
        }
    };
    format!("{}\n", row.0)
}

fn table_cell(cell: &Cell) -> Markup {
    html! {
        td class=[cell.class()] {
            (cell.text) @if !cell.second_line.is_empty() { @if !cell.text.is_empty() { " " br; } span.quiet { (cell.second_line) } }
        }
    }
}

/// The beginning of the table of failed models, before its first row.
pub(super) fn failures_opening(columns: Columns) -> String {
    let title = "Failed models";
    let headers = ["model", " what is wrong", " code"];
    let table = opening_of_table(title, "models failures", columns.failures_caption(), &headers);
    format!("<h3>{title}</h3>{table}")
}

/// The table row of a model that failed.
pub(super) fn failure(entry: &Entry, topics: &mut Topics) -> String {
    let row = html! {
        tr {
            th scope="row" { (breakable_path(&entry.model)) }
            td.words { (entry.outcome) }
            td.words { @if let Some(error) = entry.error { (topics.link_to_error(error)) } }
        }
    };
    format!("{}\n", row.0)
}

/// The details of model `number`, folded until the reader opens them.
///
/// The anchor is inside: a browser that follows a link into closed details opens them.
pub(super) fn details(entry: &Entry, number: usize, inside: &str) -> String {
    let summary = html! {
        h3 { (breakable_path(&entry.model)) } " "
        span.quiet { (entry.summary) @if entry.earlier { (DONE_EARLIER_MARK) } }
    };
    format!(
        "<details><summary>{}</summary><div class=\"model\" id=\"model-{number}\">{inside}</div></details>\n",
        summary.0
    )
}

/// The code of the error of a model, linked to its explanation.
pub(super) fn code(entry: &Entry, topics: &mut Topics) -> Markup {
    html! { @if let Some(error) = entry.error { " [" (topics.link_to_error(error)) "]" } }
}

// The models of a library that are drawn, with the reasons.

/// Id and title of the section with plots of special models.
pub(super) const SECTION_HEAD: (&str, &str) = ("chosen", "Plots of special models");

pub(super) fn section(chosen: &ChosenModels, dialect: &dyn Dialect) -> Markup {
    let models = chosen.models_to_draw();
    let feet = models.iter().any(|(one, _)| !one.drawn.feet.is_empty());
    let body = html! {
        p {
            (models.len()) " of " (chosen.models) " models are drawn: those with the most findings, the deepest and the \
             least deep, the heaviest and the lightest, the most common, and one for each other finding."
            @if !feet { " Feet are drawn on pages about few models, or about one." }
        }
        @for (one, reasons) in &models {
            div.chosen {
                h3 { (breakable_path(&one.model)) }
                p { b { "Chosen because: " } (reasons.join("; ")) "." }
                @if let Some(drawn) = plots::feet_figure(&one.drawn.feet) { (drawn) }
                @if !one.drawn.bodies.is_empty() {
                    (plots::figures(&one.drawn.bodies, one.drawn.has_reference, dialect))
                }
            }
        }
    };
    titled_section(SECTION_HEAD, &body)
}
