//! The first section of a page: counts of models, findings and failures, and the chart of indentations.

use std::cmp::Reverse;
use std::collections::BTreeMap;

use contact_scaling::limits;
use indexmap::IndexMap;
use maud::{Markup, html};
use osim_model::messages::{counted, four_significant};
use osim_model::{FindingCode, Severity};

use crate::figures;
use crate::html::entry::{DONE_EARLIER_MARK, Entry};
use crate::html::explained::{Topics, marked_outside, severity_tag};
use crate::html::fragment::table;
use crate::html::page_frame::section;
use crate::html::special_models::{Indentation, is_too_deep};

/// Id and title of the section with the numbers of models and findings.
pub(super) const SECTION_HEAD: (&str, &str) = ("glance", "At a glance");
/// Id and title of the chart of x̂ of all models.
pub(super) const CHART_OF_INDENTATIONS: (&str, &str) = ("indentation", "Relative indentation at rest, x̂");

/// The largest number of references that are named. Each row of a manifest may have its own reference.
const MOST_REFERENCES: usize = 5;

/// Counts of models, findings and failures over all models of a page.
#[derive(Debug, Default)]
pub(super) struct PageCounts {
    pub(super) models: usize,
    pub(super) failed: usize,
    earlier: usize,
    /// The references of all models, each once, in the order of the models.
    references: Vec<String>,
    /// The outcomes of models that did not fail, with the number of models for each, in the order of the models.
    outcomes: IndexMap<String, usize>,
    /// Number of models that were inspected.
    inspected: usize,
    /// Numbers of inspected models with errors, with warnings and with remarks.
    models_with: [usize; 3],
    findings: BTreeMap<(FindingCode, Severity), usize>,
    /// The known x̂ of all models before the change. `not_scaled` has x̂ under the new weight, `now` after the change.
    before: Vec<f64>,
    not_scaled: Vec<f64>,
    pub(super) now: Vec<f64>,
}

impl PageCounts {
    /// Counts the entry of one more model.
    pub(super) fn add(&mut self, entry: &Entry) {
        self.models += 1;
        self.earlier += usize::from(entry.earlier);
        if entry.failed {
            self.failed += 1;
            return;
        }
        *self.outcomes.entry(entry.outcome.clone()).or_default() += 1;
        let Some(facts) = &entry.facts else { return };
        if let Some(reference) = &facts.reference
            && self.references.len() < MOST_REFERENCES
            && !self.references.contains(reference)
        {
            self.references.push(reference.clone());
        }
        self.inspected += 1;
        let counts = [facts.counts.error, facts.counts.warning, facts.counts.remark];
        for (models_with, count) in self.models_with.iter_mut().zip(counts) {
            *models_with += usize::from(count > 0);
        }
        for (code, severity) in &facts.codes {
            *self.findings.entry((*code, *severity)).or_default() += 1;
        }
        let Indentation { before, not_scaled, now } = facts.indentation;
        self.before.extend(before);
        self.not_scaled.extend(not_scaled);
        self.now.extend(now);
    }

    /// The counts of models and findings as a list of the page.
    pub(super) fn counts(&self) -> Markup {
        let too_deep = self.now.iter().filter(|value| is_too_deep(**value)).count();
        html! {
            ul.counts {
                li { b { (self.models) } (if self.models == 1 { " model" } else { " models" }) }
                @if self.failed > 0 { li.bad { b { (self.failed) } " failed" } }
                @for (outcome, count) in &self.outcomes { li { b { (count) } " " (outcome) } }
                @if self.inspected > 0 {
                    @for (severity, (models_with, what)) in [Severity::Error, Severity::Warning, Severity::Remark]
                        .into_iter().zip(self.models_with.iter().zip(["errors", "warnings", "remarks"])) {
                        @if *models_with > 0 { li class=(severity.as_str()) { b { (models_with) } " with " (what) } }
                    }
                }
                @if !self.now.is_empty() {
                    li { b { (too_deep) " of " (self.now.len()) } " deeper at rest than x̂ = " (limits::INDENTATION.value) }
                }
            }
            @for reference in &self.references { p { b { "Reference: " } (reference) "." } }
            @if self.earlier > 0 {
                p { (counted(self.earlier, "model")) " done by an earlier run of this call, marked with" (DONE_EARLIER_MARK) "." }
            }
        }
    }

    /// The table of findings, the worst and most frequent first.
    pub(super) fn findings(&self, topics: &mut Topics) -> Markup {
        let rows = self.rows_of_findings(topics);
        html! {
            @if !self.findings.is_empty() {
                h3 { "Findings by kind" }
                (table("Findings by kind", "In how many models each finding is.", &["finding", " how bad", "models"], &rows))
            }
        }
    }

    fn rows_of_findings(&self, topics: &mut Topics) -> Markup {
        let mut findings: Vec<((FindingCode, Severity), usize)> =
            self.findings.iter().map(|(finding, count)| (*finding, *count)).collect();
        findings.sort_by_key(|((code, severity), count)| (Reverse((*severity, *count)), *code));
        html! {
            @for ((code, how_bad), count) in findings {
                tr { th scope="row" { (topics.link_to_finding(code)) } td.words { (severity_tag(how_bad)) } td { (count) } }
            }
        }
    }

    /// The chart with x̂ of all models.
    pub(super) fn chart(&self) -> Markup {
        let (now, limit) =
            (if self.before.is_empty() { "models" } else { "after" }, limits::INDENTATION.value);
        let states: [(&str, &[f64]); 3] =
            [(now, &self.now), ("before", &self.before), ("before, under the new weight", &self.not_scaled)];
        let above: usize =
            states.map(|(_, indentations)| figures::count_above_axis(indentations)).iter().sum();
        let Some(svg) = figures::indentations(&states) else { return html! {} };
        let body = html! {
            figure {
                div.plot { (maud::PreEscaped(svg)) }
                figcaption {
                    "x̂ = x/R of the sphere that sinks in most under the body weight on one limb, by the Hertz law, which \
                     holds up to " (limit) ". Each curve is sorted by itself, from the smallest value to the largest"
                    @if self.inspected > self.now.len() { "; " (counted(self.inspected - self.now.len(), "model")) " without a known x̂ left out" }
                    @if above > 0 { "; " (counted(above, "value")) " above 1 drawn at 1" }
                    "."
                    @if !self.before.is_empty() {
                        " Where the curves before and after are one, scaling kept x̂."
                    }
                    @if !self.not_scaled.is_empty() {
                        " Under the new weight: the old contacts, unchanged."
                    }
                }
            }
        };
        section(CHART_OF_INDENTATIONS, &body)
    }
}

/// The section "at a glance" of a page about one model.
pub(super) fn overview_of_one_model(entry: &Entry, code: &Markup) -> Markup {
    let body = html! {
        @if entry.failed || entry.facts.is_none() {
            p.aside { b { (entry.model) } ": " (entry.summary) (code) }
        } @else {
            ul.counts {
                li { (entry.summary) @if entry.earlier { " (done by an earlier run)" } }
                @if let Some(facts) = &entry.facts { (depth_item(facts.indentation)) }
            }
        }
    };
    section(SECTION_HEAD, &body)
}

fn depth_item(indentation: Indentation) -> Markup {
    let Indentation { before, not_scaled, now } = indentation;
    let Some(now) = now else { return html! {} };
    let which = if before.is_some() { "after" } else { "at rest" };
    let shown = four_significant(now);
    let shown = if is_too_deep(now) { marked_outside(&shown) } else { shown };
    html! {
        li {
            "x̂ of the deepest sphere " (which) ": " b { (shown) }
            @if let Some(before) = before { "; before: " (four_significant(before)) }
            @if let Some(not_scaled) = not_scaled { "; before, under the new weight: " (four_significant(not_scaled)) }
            "; limit " (limits::INDENTATION.value)
        }
    }
}
