//! Explanations for people, 80 columns wide.

use comfy_table::ContentArrangement;
use contact_scaling::Equation;
use osim_patch::WarningCode;

use super::errors::ErrorCode;
use super::{Topic, uses};
use crate::report::table;

/// Columns of an old terminal.
const WIDTH: usize = 80;

/// How letters beyond ASCII are written; done before the layout, since spellings differ in length.
pub(super) type Spelling = fn(&str) -> String;

/// One topic in full.
pub(super) fn of(topic: Topic, spelled: Spelling) -> String {
    match topic {
        Topic::Equation(equation) => of_equation(equation, spelled),
        Topic::Warning(code) => of_warning(code),
        Topic::Error(error) => of_error(error),
    }
}

fn of_equation(equation: &Equation, spelled: Spelling) -> String {
    let mut text = format!("{}  {}\n\n", shown(equation.label), equation.title);
    for form in equation.forms {
        let note = if form.note.is_empty() { String::new() } else { format!("    ({})", form.note) };
        text.push_str(&spelled(&format!("    {}{note}\n", form.formula)));
    }
    let mut symbols = table(&["symbol", "meaning", "unit"]);
    for symbol in equation.symbols {
        symbols.add_row([symbol.symbol, symbol.meaning, symbol.unit].map(spelled).to_vec());
    }
    if !equation.symbols.is_empty() {
        text.push_str(&format!("\n{}\n", fitted(symbols)));
    }
    text.push('\n');
    text.push_str(&paragraph("Source: ", &spelled(equation.source)));
    text.push_str(&paragraph("Used:   ", uses::of(equation.label)));
    text
}

fn of_warning(code: WarningCode) -> String {
    let parts = [("What: ", code.what()), ("Why:  ", code.why()), ("Do:   ", code.remedy())];
    let body: String = parts.into_iter().map(|(label, body)| paragraph(label, body)).collect();
    format!("{code}\n\n{body}")
}

fn of_error(error: &ErrorCode) -> String {
    let parts = [("Means: ", error.means), ("Do:    ", error.way_out)];
    let body: String = parts.into_iter().map(|(label, body)| paragraph(label, body)).collect();
    format!("{} (error)\n\n{body}", error.code)
}

/// Everything that can be explained, one line each.
pub(super) fn list(topics: &[Topic], spelled: Spelling) -> String {
    let (mut equations, mut warnings, mut errors) = (
        table(&["equation", "what it says"]),
        table(&["warning", "what it is"]),
        table(&["error", "what it means"]),
    );
    for topic in topics {
        match topic {
            Topic::Equation(equation) => {
                equations.add_row(vec![shown(equation.label), spelled(equation.title)])
            }
            Topic::Warning(code) => warnings.add_row(vec![code.as_str(), code.what().trim()]),
            Topic::Error(error) => errors.add_row(vec![error.code.to_owned(), spelled(error.means)]),
        };
    }
    [equations, warnings, errors].map(|table| format!("{}\n", fitted(table))).join("\n")
}

/// Numbers of the paper stand in brackets, as there.
fn shown(label: &str) -> String {
    if label.ends_with(|c: char| c.is_ascii_digit()) && !label.contains(' ') {
        format!("({label})")
    } else {
        label.to_owned()
    }
}

fn paragraph(label: &str, body: &str) -> String {
    let body = format!("{}.", body.trim().trim_end_matches('.'));
    let indent = " ".repeat(label.len());
    let options = textwrap::Options::new(WIDTH).initial_indent(label).subsequent_indent(&indent);
    format!("{}\n", textwrap::fill(&body, options))
}

fn fitted(mut table: comfy_table::Table) -> String {
    table.set_content_arrangement(ContentArrangement::Dynamic).set_width(WIDTH as u16);
    table.trim_fmt()
}
