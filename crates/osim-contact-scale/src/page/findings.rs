//! What `check` found, and what a change made of it.

use maud::{Markup, html};

use super::fragment::Fragment;
use super::values::severity;
use crate::check::{Finding, Report};

const SECTION: (&str, &str) = ("findings", "Findings");

/// Findings of a model that was looked at.
pub(super) fn of_model(fragment: &mut Fragment, report: &Report) {
    let list = list(fragment, &report.findings.iter().collect::<Vec<_>>());
    let body = html! {
        @if report.findings.is_empty() { p { "Nothing to say: all figures are within the limits." } }
        (list)
    };
    fragment.section(SECTION.0, SECTION.1, &body);
}

/// Findings before and after: what came, what stayed, what went.
pub(super) fn of_change(fragment: &mut Fragment, now: &Report, new: &Report) {
    let same = |a: &Finding, b: &Finding| a.code == b.code && (a.place == b.place || a.place.is_none());
    let is_in = |one: &Finding, report: &Report| report.findings.iter().any(|other| same(one, other));
    let (stays, comes): (Vec<&Finding>, Vec<&Finding>) = new.findings.iter().partition(|one| is_in(one, now));
    let goes: Vec<&Finding> = now.findings.iter().filter(|one| !is_in(one, new)).collect();
    let groups = [
        ("New with this change", comes, "Nothing."),
        ("Still there", stays, "Nothing."),
        ("Gone with this change", goes, "Nothing."),
    ];
    let mut body = html! {
        p { "As " code { "check" } " sees the model before, and the new one under the mass its contacts stand for." }
    };
    for (title, findings, nothing) in groups {
        let list = list(fragment, &findings);
        body = html! {
            (body) (fragment.heading(title))
            @if findings.is_empty() { p.quiet { (nothing) } } @else { (list) }
        };
    }
    fragment.section(SECTION.0, SECTION.1, &body);
}

fn list(fragment: &mut Fragment, findings: &[&Finding]) -> Markup {
    let items: Vec<Markup> = findings.iter().map(|finding| item(fragment, finding)).collect();
    html! { @if !items.is_empty() { ul.findings { @for item in items { li { (item) } } } } }
}

fn item(fragment: &mut Fragment, finding: &Finding) -> Markup {
    let place = finding.place.as_deref().filter(|place| !finding.message.contains(*place));
    html! {
        p {
            (severity(finding.severity)) " " (fragment.topics.code(finding.code)) " "
            (finding.message) "."
            @if place.is_some() || finding.line.is_some() {
                " " span.quiet {
                    @if let Some(place) = place { (place) }
                    @if place.is_some() && finding.line.is_some() { ", " }
                    @if let Some(line) = finding.line { "line " (line) }
                }
            }
        }
        @if let Some(command) = &finding.command { (super::shell::command_line(command)) }
    }
}
