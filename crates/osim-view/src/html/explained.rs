//! Links to equations, findings and errors, the explanations of these, and texts that several sections use.

use std::collections::BTreeSet;
use std::ffi::OsStr;
use std::path::Path;

use contact_scaling::Equation;
use contact_scaling::equations::reference;
use maud::{Markup, html};
use osim_model::messages::{Dialect, Phrase};
use osim_model::{FindingCode, Rule, Severity};
use osim_planning::rules;

use crate::html::page_frame::section;
use crate::report::explain::{self, ErrorCode, equations};
use crate::report::layout::OUTSIDE_MARK;

/// The anchor and the heading of the section with all explanations.
pub(super) const SECTION_HEAD: (&str, &str) = ("explained", "Equations and findings explained");

/// The equations, findings and errors that a page names. Each is explained once.
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

    /// Adds the equations, findings and errors of another part of the page.
    pub(super) fn add(&mut self, other: &Self) {
        self.equations.extend(&other.equations);
        self.codes.extend(&other.codes);
        self.errors.extend(&other.errors);
    }

    /// The numbers of the equations of a change, each linked to its explanation.
    pub(super) fn links_to_equations(&mut self, named: &str) -> Markup {
        let parts: Vec<Markup> =
            named.split(", ").map(|name| self.link_to_equation(name, &reference(name))).collect();
        html! { @for (index, part) in parts.iter().enumerate() { @if index > 0 { ", " } (part) } }
    }

    fn link_to_equation(&mut self, name: &str, shown: &str) -> Markup {
        match explain::equation(name) {
            Some(equation) => {
                self.equations.insert(equation.label);
                html! { a href={ "#" (anchor_of_topic("equation", equation.label)) } { (shown) } }
            }
            None => html! { (shown) },
        }
    }

    /// The text; each number of an equation in brackets is a link to the explanation of the equation.
    pub(super) fn with_links_to_equations(&mut self, text: &str) -> Markup {
        let mut parts = Vec::new();
        let mut rest = text;
        while let Some((before, number, after)) = first_bracketed_equation(rest) {
            parts.push(html! { (before) (self.link_to_equation(number, &format!("({number})"))) });
            rest = after;
        }
        html! { @for part in parts { (part) } (rest) }
    }

    /// The code of a finding, linked to its explanation.
    pub(super) fn link_to_finding(&mut self, code: FindingCode) -> Markup {
        self.codes.insert(code);
        html! { a.code href={ "#" (anchor_of_topic("finding", code.as_str())) } { (code.as_str()) } }
    }

    /// The code of an error linked to its explanation.
    pub(super) fn link_to_error(&mut self, error: &'static ErrorCode) -> Markup {
        self.errors.insert(error.code);
        html! { a.code href={ "#" (anchor_of_topic("error", error.code)) } { (error.code) } }
    }
}

/// Splits a text at the first number of an equation in brackets: the text before it, the number, the text after it.
fn first_bracketed_equation(text: &str) -> Option<(&str, &str, &str)> {
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

fn anchor_of_topic(kind: &str, name: &str) -> String {
    let plain = |c: char| if c.is_ascii_alphanumeric() { c.to_ascii_lowercase() } else { '-' };
    format!("{kind}-{}", name.chars().map(plain).collect::<String>())
}

/// The section with all explanations, in the order of the registers.
pub(super) fn explained_section(topics: &Topics, dialect: &dyn Dialect) -> String {
    let equations: Vec<&Equation> =
        equations().filter(|equation| topics.equations.contains(equation.label)).collect();
    let body = html! {
        @if !equations.is_empty() {
            h3 { "Equations" }
            p { "Numbers are those of the paper (see " a href="#origin" { "Program and citation" } ")." }
            @for equation in equations { (explained_equation(equation, dialect)) }
        }
        @if !topics.codes.is_empty() {
            h3 { "Findings" }
            @for rule in rules::with_code(|code| topics.codes.contains(&code)) { (explained_rule(rule, dialect)) }
        }
        @if !topics.errors.is_empty() {
            h3 { "Errors" }
            @for error in topics.errors.iter().filter_map(|code| explain::error(code)) { (explained_error(error, dialect)) }
        }
    };
    section(SECTION_HEAD, &body).0
}

/// The anchor and the explanation of each topic, in the order of the registers.
pub(super) fn explanations_by_anchor(topics: &Topics, dialect: &dyn Dialect) -> Vec<(String, Markup)> {
    let equations = equations().filter(|equation| topics.equations.contains(equation.label));
    let equations = equations
        .map(|equation| (anchor_of_topic("equation", equation.label), explained_equation(equation, dialect)));
    let codes = rules::with_code(|code| topics.codes.contains(&code))
        .map(|rule| (anchor_of_topic("finding", rule.code.as_str()), explained_rule(rule, dialect)));
    let errors = topics.errors.iter().filter_map(|code| explain::error(code));
    let errors = errors.map(|error| (anchor_of_topic("error", error.code), explained_error(error, dialect)));
    equations.chain(codes).chain(errors).collect()
}

fn explained_equation(equation: &Equation, dialect: &dyn Dialect) -> Markup {
    let spelled = |template: &'static str| Phrase::template(template).spelled(dialect);
    html! {
        div.explained id=(anchor_of_topic("equation", equation.label)) {
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

fn explained_rule(rule: &Rule, dialect: &dyn Dialect) -> Markup {
    html! {
        div.explained id=(anchor_of_topic("finding", rule.code.as_str())) {
            h4 { (rule.code.as_str()) }
            p { (rule.what().spelled(dialect)) " " (rule.why().spelled(dialect)) }
            p { b { "What to do: " } (rule.advice().spelled(dialect)) "." }
        }
    }
}

fn explained_error(error: &ErrorCode, dialect: &dyn Dialect) -> Markup {
    html! {
        div.explained id=(anchor_of_topic("error", error.code)) {
            h4 { (error.code) }
            p { (as_sentence(&error.means().spelled(dialect))) }
            p { b { "What to do: " } (as_sentence(&error.way_out().spelled(dialect))) }
        }
    }
}

/// The word for a severity, in its colour.
pub(super) fn severity_tag(severity: Severity) -> Markup {
    let word = severity.as_str();
    html! { span class={ "tag " (word) } { (word) } }
}

/// The first names, and the number of the other names.
pub(super) fn first_names_and_count(names: &[&str]) -> String {
    const MOST_NAMES: usize = 8;
    osim_model::messages::listed(names, MOST_NAMES)
}

/// A path in which lines may break after each folder.
pub(super) fn breakable_path(path: &str) -> Markup {
    html! { @for part in path.split_inclusive(['/', '\\']) { (part) @if part.ends_with(['/', '\\']) { wbr; } } }
}

/// A figure that is outside its limit, with a sign that stays on the same line.
pub(super) fn marked_outside(figure: &str) -> String {
    format!("{figure}\u{a0}{OUTSIDE_MARK}")
}

pub(super) fn as_sentence(clause: &str) -> String {
    let mut letters = clause.chars();
    let first = letters.next().map(|letter| letter.to_uppercase().collect::<String>()).unwrap_or_default();
    let end = if clause.ends_with('.') { "" } else { "." };
    format!("{first}{}{end}", letters.as_str())
}

/// Name of the file `shown` without its folders, for titles.
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
    fn equation_numbers_in_brackets_become_links() {
        let mut topics = Topics::default();
        let linked = topics.with_links_to_equations("stiffness k, N/m (B.2), (as found)").0;
        assert_eq!(linked, "stiffness k, N/m <a href=\"#equation-b-2\">(B.2)</a>, (as found)");
        assert!(topics.equations.contains("B.2"));
        let named = topics.links_to_equations("11, B.2").0;
        assert!(named.starts_with("<a href=\"#equation-11\">(11)</a>, "), "{named}");
    }
}
