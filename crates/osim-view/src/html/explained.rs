//! Equations and findings that a page names, each explained once, and words that sections share.

use std::collections::BTreeSet;
use std::ffi::OsStr;
use std::path::Path;

use contact_scaling::Equation;
use contact_scaling::equations::reference;
use maud::{Markup, html};
use osim_model::messages::{Dialect, Phrase};
use osim_model::{FindingCode, Rule, Severity};
use osim_planning::rules;

use crate::report::explain::{self, ErrorCode, equations};
use crate::report::layout::OUTSIDE;

/// The section's anchor and heading.
pub(super) const SECTION: (&str, &str) = ("explained", "Equations and findings explained");

/// What is named.
#[derive(Debug, Clone, Default)]
pub(super) struct Topics {
    equations: BTreeSet<&'static str>,
    codes: BTreeSet<FindingCode>,
    errors: BTreeSet<&'static str>,
}

impl Topics {
    pub(super) fn is_empty(&self) -> bool {
        self.equations.is_empty() && self.codes.is_empty() && self.errors.is_empty()
    }

    pub(super) fn add(&mut self, other: &Self) {
        self.equations.extend(&other.equations);
        self.codes.extend(&other.codes);
        self.errors.extend(&other.errors);
    }

    /// The column "equation" of a change, each equation linked to its explanation.
    pub(super) fn equations(&mut self, named: &str) -> Markup {
        let parts: Vec<Markup> =
            named.split(", ").map(|name| self.equation(name, &reference(name))).collect();
        html! { @for (index, part) in parts.iter().enumerate() { @if index > 0 { ", " } (part) } }
    }

    fn equation(&mut self, name: &str, shown: &str) -> Markup {
        match explain::equation(name) {
            Some(equation) => {
                self.equations.insert(equation.label);
                html! { a href={ "#" (anchor("equation", equation.label)) } { (shown) } }
            }
            None => html! { (shown) },
        }
    }

    /// Text with every number of an equation in brackets linked to its explanation.
    pub(super) fn linked(&mut self, text: &str) -> Markup {
        let mut parts = Vec::new();
        let mut rest = text;
        while let Some((before, number, after)) = bracketed(rest) {
            parts.push(html! { (before) (self.equation(number, &format!("({number})"))) });
            rest = after;
        }
        html! { @for part in parts { (part) } (rest) }
    }

    /// A code linked to its explanation.
    pub(super) fn code(&mut self, code: FindingCode) -> Markup {
        self.codes.insert(code);
        html! { a.code href={ "#" (anchor("finding", code.as_str())) } { (code.as_str()) } }
    }
}

impl Topics {
    /// The code of an error linked to its explanation.
    pub(super) fn error(&mut self, error: &'static ErrorCode) -> Markup {
        self.errors.insert(error.code);
        html! { a.code href={ "#" (anchor("error", error.code)) } { (error.code) } }
    }
}

/// The first number of an equation that is in brackets, and what is around it.
fn bracketed(text: &str) -> Option<(&str, &str, &str)> {
    let mut from = 0;
    loop {
        let open = from + text.get(from..)?.find('(')?;
        let close = open + text.get(open..)?.find(')')?;
        let number = text.get(open + 1..close)?;
        let is_number = number.ends_with(|c: char| c.is_ascii_digit()) && !number.contains(' ');
        if is_number && contact_scaling::equations::find(number).is_some() {
            return Some((text.get(..open)?, number, text.get(close + 1..)?));
        }
        from = open + 1;
    }
}

fn anchor(kind: &str, name: &str) -> String {
    let plain = |c: char| if c.is_ascii_alphanumeric() { c.to_ascii_lowercase() } else { '-' };
    format!("{kind}-{}", name.chars().map(plain).collect::<String>())
}

/// The section, in the order of the registers.
pub(super) fn section(topics: &Topics, dialect: &dyn Dialect) -> String {
    let equations: Vec<&Equation> =
        equations().filter(|equation| topics.equations.contains(equation.label)).collect();
    let (id, title) = SECTION;
    html! {
        section id=(id) aria-labelledby="explained-title" {
            h2 id="explained-title" { (title) }
            @if !equations.is_empty() {
                h3 { "Equations" }
                p { "Numbers are those of the paper (see " a href="#origin" { "Program and citation" } ")." }
                @for equation in equations { (of_equation(equation, dialect)) }
            }
            @if !topics.codes.is_empty() {
                h3 { "Findings" }
                @for rule in rules::with_code(|code| topics.codes.contains(&code)) { (of_rule(rule, dialect)) }
            }
            @if !topics.errors.is_empty() {
                h3 { "Errors" }
                @for error in topics.errors.iter().filter_map(|code| explain::error(code)) { (of_error(error, dialect)) }
            }
        }
    }
    .0
}

/// Each topic by itself, in the order of the registers: its anchor, and its explanation.
pub(super) fn each(topics: &Topics, dialect: &dyn Dialect) -> Vec<(String, Markup)> {
    let equations = equations().filter(|equation| topics.equations.contains(equation.label));
    let equations =
        equations.map(|equation| (anchor("equation", equation.label), of_equation(equation, dialect)));
    let codes = rules::with_code(|code| topics.codes.contains(&code))
        .map(|rule| (anchor("finding", rule.code.as_str()), of_rule(rule, dialect)));
    let errors = topics.errors.iter().filter_map(|code| explain::error(code));
    let errors = errors.map(|error| (anchor("error", error.code), of_error(error, dialect)));
    equations.chain(codes).chain(errors).collect()
}

fn of_equation(equation: &Equation, dialect: &dyn Dialect) -> Markup {
    let spelled = |template: &'static str| Phrase::template(template).spelled(dialect);
    html! {
        div.explained id=(anchor("equation", equation.label)) {
            h4 { (reference(equation.label)) " " (equation.title) }
            @for form in equation.forms {
                p.formula { code { (form.formula) } @if !form.variant.is_empty() { " " span.quiet { (form.variant) } } }
            }
            @if !equation.symbols.is_empty() {
                ul.symbols {
                    @for symbol in equation.symbols {
                        li { i { (symbol.symbol) } " " (spelled(symbol.meaning))
                            @if symbol.unit != "1" && !symbol.unit.is_empty() { " (" (symbol.unit) ")" } }
                    }
                }
            }
            p.quiet { "Source: " (spelled(equation.source)) }
        }
    }
}

fn of_rule(rule: &Rule, dialect: &dyn Dialect) -> Markup {
    html! {
        div.explained id=(anchor("finding", rule.code.as_str())) {
            h4 { (rule.code.as_str()) }
            p { (rule.what().spelled(dialect)) " " (rule.why().spelled(dialect)) }
            p { b { "What to do: " } (rule.advice().spelled(dialect)) "." }
        }
    }
}

fn of_error(error: &ErrorCode, dialect: &dyn Dialect) -> Markup {
    html! {
        div.explained id=(anchor("error", error.code)) {
            h4 { (error.code) }
            p { (sentence(&error.means().spelled(dialect))) }
            p { b { "What to do: " } (sentence(&error.way_out().spelled(dialect))) }
        }
    }
}

// Words that several sections share.

/// How bad something is, as a word with a colour.
pub(super) fn severity(severity: Severity) -> Markup {
    let word = severity.as_str();
    html! { span class={ "tag " (word) } { (word) } }
}

/// The first names, and how many more there are.
pub(super) fn listed(names: &[&str]) -> String {
    const NAMED: usize = 8;
    osim_model::messages::listed(names, NAMED)
}

/// A path that may be broken after each folder, so that long ones leave room for what is beside them.
pub(super) fn broken_at_folders(path: &str) -> Markup {
    html! { @for part in path.split_inclusive(['/', '\\']) { (part) @if part.ends_with(['/', '\\']) { wbr; } } }
}

/// A figure outside of its limit. The sign and the value must stay on one line.
pub(super) fn marked_outside(figure: &str) -> String {
    format!("{figure}\u{a0}{OUTSIDE}")
}

pub(super) fn sentence(clause: &str) -> String {
    let mut letters = clause.chars();
    let first = letters.next().map(|letter| letter.to_uppercase().collect::<String>()).unwrap_or_default();
    let end = if clause.ends_with('.') { "" } else { "." };
    format!("{first}{}{end}", letters.as_str())
}

/// The last part of a path as it is shown.
pub(super) fn file_name(shown: &str) -> &str {
    if shown == "-" {
        return "standard input";
    }
    Path::new(shown).file_name().and_then(OsStr::to_str).unwrap_or(shown)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_in_brackets_become_links() {
        let mut topics = Topics::default();
        let linked = topics.linked("stiffness k, N/m (B.2), (as found)").0;
        assert_eq!(linked, "stiffness k, N/m <a href=\"#equation-b-2\">(B.2)</a>, (as found)");
        assert!(topics.equations.contains("B.2"));
        let named = topics.equations("11, B.2").0;
        assert!(named.starts_with("<a href=\"#equation-11\">(11)</a>, "), "{named}");
    }
}
