//! The six verdicts on a model, what `check` found, and what a change made of it.

use maud::{Markup, html};
use osim_inspect::{CheckResult, FindingIndex, FindingWithRemedy, Sign, Verdict};
use osim_model::messages::readable;

use crate::html::explained::severity;
use crate::html::fragment::{Fragment, table};
use crate::html::shell::command_line;

pub(super) const SECTION: (&str, &str) = ("findings", "Findings");

/// Findings of a model that was inspected.
pub(super) fn of_model(fragment: &mut Fragment, found: &CheckResult) {
    let findings: Vec<&FindingWithRemedy> = found.findings.iter().collect();
    let list = list(&items(fragment, &findings, Lines::Only, Commands::Shown));
    let body = html! {
        (verdicts_of_model(&found.verdicts))
        @if found.findings.is_empty() { p { "Nothing to say: all figures are within the limits." } }
        (list)
    };
    fragment.section(SECTION.0, SECTION.1, &body);
}

/// What findings have to know of the new model.
pub(super) struct After<'r> {
    pub(super) found: &'r CheckResult,
    /// Whether it is in a file, so that commands can name it.
    pub(super) in_file: bool,
    /// Contacts are scaled to a gravity that the model's file does not say yet, m/s².
    pub(super) gravity_m_s2: Option<f64>,
}

/// Findings before and after: what came, what stayed, what went.
pub(super) fn of_change(fragment: &mut Fragment, now: &CheckResult, new: &After<'_>) {
    let pairs = paired(&now.findings, &new.found.findings);
    let comes: Vec<&FindingWithRemedy> =
        pairs.iter().filter(|(_, before)| before.is_none()).map(|(one, _)| *one).collect();
    let index = FindingIndex::new(&new.found.findings);
    let gone = |one: &&FindingWithRemedy| index.find_same_or_other_depth(one).is_none();
    let goes: Vec<&FindingWithRemedy> = now.findings.iter().filter(gone).collect();
    let commands = if new.in_file { Commands::Shown } else { Commands::Left };
    let comes = items(fragment, &comes, Lines::New, commands);
    let stays: Vec<Markup> = pairs
        .iter()
        .filter_map(|(one, before)| Some((one, before.as_ref()?)))
        .map(|(one, before)| html! { (item(fragment, one, Lines::New, commands)) (was(fragment, one, before)) })
        .collect();
    let goes = items(fragment, &goes, Lines::Old, Commands::Left);
    let groups = [("New with this change", comes), ("Still there", stays), ("Gone with this change", goes)];
    let body = html! {
        p {
            "As " code { "check" } " sees the model before, and the new one under the mass its contacts are made for"
            @if let Some(gravity) = new.gravity_m_s2 {
                " at " (readable(gravity)) " m/s². The model's own " code { "<gravity>" } " is still another: set it in OpenSim"
            }
            "."
            @if !new.in_file { " The new model is in no file yet, so no commands are given." }
        }
        (verdicts_of_change(&now.verdicts, &new.found.verdicts))
        @for (title, items) in groups {
            (fragment.heading(title))
            @if items.is_empty() { p.quiet { "Nothing." } } @else { (list(&items)) }
        }
    };
    fragment.section(SECTION.0, SECTION.1, &body);
}

/// Each new finding with the old one that says the same, if there is one.
fn paired<'f>(
    now: &'f [FindingWithRemedy],
    new: &'f [FindingWithRemedy],
) -> Vec<(&'f FindingWithRemedy, Option<&'f FindingWithRemedy>)> {
    let index = FindingIndex::new(now);
    new.iter().map(|one| (one, index.find_same_or_other_depth(one))).collect()
}

/// What the finding was before, where that differs.
fn was(fragment: &mut Fragment, one: &FindingWithRemedy, before: &FindingWithRemedy) -> Markup {
    let other = before.code() != one.code();
    let (message, message_before) = (one.message.to_string(), before.message.to_string());
    html! {
        @if other || message_before != message {
            p.quiet {
                "Before: "
                @if other { (severity(before.severity)) " " (fragment.topics.code(before.code())) " " }
                (message_before) "."
            }
        }
    }
}

/// Which file a finding's line is of, where there are two.
#[derive(Clone, Copy)]
enum Lines {
    Only,
    Old,
    New,
}

/// Whether commands that fix are shown.
#[derive(Clone, Copy, PartialEq)]
enum Commands {
    Shown,
    Left,
}

fn list(items: &[Markup]) -> Markup {
    html! { @if !items.is_empty() { ul.findings { @for item in items { li { (item) } } } } }
}

fn items(
    fragment: &mut Fragment,
    findings: &[&FindingWithRemedy],
    lines: Lines,
    commands: Commands,
) -> Vec<Markup> {
    findings.iter().map(|finding| item(fragment, finding, lines, commands)).collect()
}

fn item(fragment: &mut Fragment, finding: &FindingWithRemedy, lines: Lines, commands: Commands) -> Markup {
    let message = finding.message.to_string();
    let place = finding.place.as_deref().filter(|place| !message.contains(*place));
    let file = match lines {
        Lines::Only => "",
        Lines::Old => " of the old file",
        Lines::New => " of the new file",
    };
    html! {
        p {
            (severity(finding.severity)) " " (fragment.topics.code(finding.code())) " "
            (message) "."
            @if place.is_some() || finding.line.is_some() {
                " " span.quiet {
                    @if let Some(place) = place { (place) }
                    @if place.is_some() && finding.line.is_some() { ", " }
                    @if let Some(line) = finding.line { "line " (line) (file) }
                }
            }
        }
        @if let Some(command) = finding.command.as_ref().filter(|_| commands == Commands::Shown) {
            (command_line(command))
        }
    }
}

// The six verdicts on a model, a row each; after a change, on both states.

const NAME: &str = "Verdicts";

fn verdicts_of_model(verdicts: &[Verdict]) -> Markup {
    let rows: Vec<Markup> = verdicts
        .iter()
        .map(|verdict| html! { tr { (question(verdict)) td.words { (sign(verdict.sign)) } (answer(verdict)) } })
        .collect();
    table(
        NAME,
        &format!("{} questions about the model.", number(rows.len())),
        &["question", " verdict", " why"],
        &rows,
    )
}

fn verdicts_of_change(before: &[Verdict], after: &[Verdict]) -> Markup {
    let rows: Vec<Markup> = before
        .iter()
        .zip(after)
        .map(|(before, after)| {
            html! { tr {
                (question(after)) td.words { (sign(before.sign)) } td.words { (sign(after.sign)) } (answer(after))
            } }
        })
        .collect();
    let headers = ["question", " before", " after", " why, after the change"];
    table(NAME, "Six questions about the model, before and after the change.", &headers, &rows)
}

fn question(verdict: &Verdict) -> Markup {
    html! { th scope="row" { (verdict.on.question()) } }
}

fn sign(sign: Sign) -> Markup {
    html! { span class={ "tag " (sign.as_str()) } { (sign.as_str()) } }
}

fn answer(verdict: &Verdict) -> Markup {
    let text = verdict.text.to_string();
    let place = verdict.place.as_deref().filter(|place| !text.contains(*place));
    html! { td.words { (text) @if let Some(place) = place { " " span.quiet { (place) } } } }
}

/// Six questions, and one more where a recording is named.
fn number(questions: usize) -> String {
    match questions {
        6 => "Six".to_owned(),
        7 => "Seven".to_owned(),
        other => other.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use osim_model::{Finding, FindingCode};
    use osim_planning::rules;

    use super::*;

    fn finding(code: FindingCode, place: &str, spheres: &[&str]) -> FindingWithRemedy {
        let spheres = spheres.iter().map(|&name| name.to_owned()).collect();
        let rule = rules::with_code(|one| one == code).next().unwrap();
        Finding::new(rule, "").with_place(place).with_spheres(spheres).into()
    }

    fn are_akin(old: &FindingWithRemedy, new: &FindingWithRemedy) -> bool {
        FindingIndex::new(std::slice::from_ref(old)).find_same_or_other_depth(new).is_some()
    }

    #[test]
    fn the_worst_sphere_may_be_another_one_after_a_change() {
        let (heel, toe) = (&["heel", "toe"], &["toe"]);
        let before = finding(FindingCode::BeyondHertz, "heel", heel);
        assert!(are_akin(&before, &finding(FindingCode::BeyondHertz, "toe", toe)));
        assert!(are_akin(&before, &finding(FindingCode::SunkIn, "toe", toe)));
        assert!(!are_akin(&before, &finding(FindingCode::BeyondHuntCrossley, "toe", toe)));
    }

    #[test]
    fn what_is_said_of_forces_belongs_to_each() {
        let before = finding(FindingCode::ConnecteeByName, "left", &[]);
        assert!(are_akin(&before, &finding(FindingCode::ConnecteeByName, "left", &[])));
        assert!(!are_akin(&before, &finding(FindingCode::ConnecteeByName, "right", &[])));
    }

    #[test]
    fn the_same_finding_is_nearer_than_another_step() {
        let now = [finding(FindingCode::SunkIn, "a", &["a"]), finding(FindingCode::BeyondHertz, "b", &["b"])];
        let new = [finding(FindingCode::BeyondHertz, "c", &["c"])];
        assert_eq!(paired(&now, &new)[0].1.map(|old| old.code()), Some(FindingCode::BeyondHertz));
    }
}
