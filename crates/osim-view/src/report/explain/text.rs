//! Explanations for people, 80 columns wide.

use contact_scaling::Equation;
use contact_scaling::equations::reference;
use osim_model::Rule;
use osim_model::messages::{Dialect, Phrase};

use super::errors::ErrorCode;
use super::letters::Letters;
use super::quantities::QuantityTopic;
use super::topic::Topic;
use super::uses::uses;
use crate::report::layout::{options, table};

/// One topic in full.
#[must_use]
pub fn text(topic: Topic, dialect: &dyn Dialect, letters: Letters) -> String {
    match topic {
        Topic::Equation(equation) => of_equation(equation, dialect, letters),
        Topic::Quantity(quantity) => of_quantity(quantity, dialect, letters),
        Topic::Finding(rule) => of_finding(rule, dialect),
        Topic::Error(error) => of_error(error, dialect),
    }
}

fn of_equation(equation: &Equation, dialect: &dyn Dialect, letters: Letters) -> String {
    let spelled = |template: &'static str| letters.spelled(&Phrase::template(template).spelled(dialect));
    let mut text = format!("{}  {}\n\n", reference(equation.label), equation.title);
    for form in equation.forms {
        let note = if form.note.is_empty() { String::new() } else { format!("    ({})", form.note) };
        text.push_str(&letters.spelled(&format!("    {}{note}\n", form.formula)));
    }
    let mut symbols = table(&["symbol", "meaning", "unit"]);
    for symbol in equation.symbols {
        symbols.add_row([symbol.symbol, symbol.meaning, symbol.unit].map(spelled).to_vec());
    }
    if !equation.symbols.is_empty() {
        text.push_str(&format!("\n{}\n", symbols.fitted()));
    }
    text.push('\n');
    text.push_str(&paragraph("Source: ", &spelled(equation.source)));
    text.push_str(&paragraph("Used:   ", &uses(equation.label).spelled(dialect)));
    text.push_str(&book("Book:   ", "equations"));
    text
}

fn of_quantity(quantity: &QuantityTopic, dialect: &dyn Dialect, letters: Letters) -> String {
    let mut parts =
        vec![("What:  ", quantity.what().spelled(dialect)), ("Unit:  ", quantity.unit_in_words().to_owned())];
    if !quantity.symbols.is_empty() {
        parts.push(("Also:  ", quantity.symbols.join(", ")));
    }
    if !quantity.equation.is_empty() {
        parts.push(("By:    ", reference(quantity.equation)));
    }
    parts.extend(quantity.limit.clone().map(|limit| ("Limit: ", limit)));
    parts.push(("Trap:  ", quantity.trap().spelled(dialect)));
    let body: String =
        parts.into_iter().map(|(label, body)| paragraph(label, &letters.spelled(&body))).collect();
    format!("{} (quantity)\n\n{body}", quantity.name)
}

fn of_finding(rule: &Rule, dialect: &dyn Dialect) -> String {
    let repair = rule.repair.sentence().into();
    let parts =
        [("What: ", rule.what()), ("Why:  ", rule.why()), ("Do:   ", rule.advice()), ("Fix:  ", repair)];
    let body: String =
        parts.into_iter().map(|(label, body)| paragraph(label, &body.spelled(dialect))).collect();
    format!("{}\n\n{body}{}", rule.code, book("Book: ", "warnings"))
}

fn of_error(error: &ErrorCode, dialect: &dyn Dialect) -> String {
    let parts = [("Means: ", error.means()), ("Do:    ", error.way_out())];
    let body: String =
        parts.into_iter().map(|(label, body)| paragraph(label, &body.spelled(dialect))).collect();
    format!("{} (error)\n\n{body}{}", error.code, book("Book:  ", "errors"))
}

/// Topics by kind, one line each.
#[must_use]
pub fn list(topics: &[Topic], dialect: &dyn Dialect, letters: Letters) -> String {
    let (mut equations, mut quantities, mut findings, mut errors) = (
        table(&["equation", "what it says"]),
        table(&["quantity", "what it is"]),
        table(&["finding", "what it is"]),
        table(&["error", "what it means"]),
    );
    for topic in topics {
        match topic {
            Topic::Equation(equation) => {
                equations.add_row(vec![reference(equation.label), letters.spelled(equation.title)]);
            }
            Topic::Quantity(quantity) => {
                let what = letters.spelled(&quantity.what().spelled(dialect));
                quantities.add_row(vec![quantity.name.to_owned(), what]);
            }
            Topic::Finding(rule) => {
                findings.add_row(vec![rule.code.as_str().to_owned(), rule.what().spelled(dialect)]);
            }
            Topic::Error(error) => {
                let means = letters.spelled(&error.means().spelled(dialect));
                errors.add_row(vec![error.code.to_owned(), means]);
            }
        }
    }
    // A name that is broken cannot be copied.
    quantities.unbroken(0);
    [equations, quantities, findings, errors].map(|table| format!("{}\n", table.fitted())).join("\n")
}

/// The page of the book that has all topics of this kind.
fn book(label: &str, page: &str) -> String {
    format!("{label}docs/reference/{page}.md\n")
}

fn paragraph(label: &str, body: &str) -> String {
    let body = format!("{}.", body.trim_ascii().trim_end_matches('.'));
    let indent = " ".repeat(label.len());
    let options = options().initial_indent(label).subsequent_indent(&indent);
    format!("{}\n", textwrap::fill(&body, options))
}
