//! The section with the verdicts and the findings of a model, or of a model before and after a change.

use maud::{Markup, html};
use osim_inspect::{CheckResult, FindingIndex, FindingWithRemedy, Sign, Verdict};
use osim_model::messages::readable;

use crate::html::explained::severity_tag;
use crate::html::fragment::{Fragment, table};
use crate::html::page_frame::command_line;

/// Id and title of the section about findings.
pub(super) const SECTION_HEAD: (&str, &str) = ("findings", "Findings");

/// Adds the section with the verdicts and findings of one model.
pub(super) fn add_verdicts_and_findings(fragment: &mut Fragment, check: &CheckResult) {
    let findings: Vec<&FindingWithRemedy> = check.findings.iter().collect();
    let list = list_of_items(&items_of_findings(fragment, &findings, "", true));
    let body = html! {
        (verdicts_of_model(&check.verdicts))
        @if check.findings.is_empty() { p { "No findings: all values are within the limits." } }
        (list)
    };
    fragment.add_section(SECTION_HEAD.0, SECTION_HEAD.1, &body);
}

/// Adds the section about findings before and after a change: new findings, findings that stayed, and findings that are gone.
/// `in_file` says whether the new model is in a file, so that commands can name it. `gravity_m_s2` is the gravity that the contacts
/// are scaled to, if it differs from the gravity in the file of the model.
pub(super) fn add_findings_of_change(
    fragment: &mut Fragment,
    now: &CheckResult,
    new: &CheckResult,
    in_file: bool,
    gravity_m_s2: Option<f64>,
) {
    let old = FindingIndex::new(&now.findings);
    let pairs: Vec<_> = new.findings.iter().map(|one| (one, old.find_same_or_other_depth(one))).collect();
    let new_findings: Vec<&FindingWithRemedy> =
        pairs.iter().filter(|(_, before)| before.is_none()).map(|(one, _)| *one).collect();
    let index = FindingIndex::new(&new.findings);
    let gone = |one: &&FindingWithRemedy| index.find_same_or_other_depth(one).is_none();
    let gone_findings: Vec<&FindingWithRemedy> = now.findings.iter().filter(gone).collect();
    let new_findings = items_of_findings(fragment, &new_findings, " of the new file", in_file);
    let kept_items: Vec<Markup> = pairs
        .iter()
        .filter_map(|(one, before)| Some((one, before.as_ref()?)))
        .map(|(one, before)| html! { (item_of_finding(fragment, one, " of the new file", in_file)) (old_message(fragment, one, before)) })
        .collect();
    let gone_findings = items_of_findings(fragment, &gone_findings, " of the old file", false);
    let groups = [
        ("New with this change", new_findings),
        ("Still there", kept_items),
        ("Gone with this change", gone_findings),
    ];
    let body = html! {
        p {
            "As " code { "check" } " sees the model before, and the new one under the mass its contacts are made for"
            @if let Some(gravity) = gravity_m_s2 {
                " at " (readable(gravity)) " m/s². The model's own " code { "<gravity>" } " is still another: set it in OpenSim"
            }
            "."
            @if !in_file { " The new model is in no file yet, so no commands are given." }
        }
        (verdicts_of_change(&now.verdicts, &new.verdicts))
        @for (title, items) in groups {
            (fragment.heading(title))
            @if items.is_empty() { p.quiet { "Nothing." } } @else { (list_of_items(&items)) }
        }
    };
    fragment.add_section(SECTION_HEAD.0, SECTION_HEAD.1, &body);
}

/// The message of the old finding, if it differs from the new message.
fn old_message(fragment: &mut Fragment, one: &FindingWithRemedy, before: &FindingWithRemedy) -> Markup {
    let other = before.code() != one.code();
    let (message, message_before) = (one.message.to_string(), before.message.to_string());
    html! {
        @if other || message_before != message {
            p.quiet {
                "Before: "
                @if other { (severity_tag(before.severity)) " " (fragment.topics.link_to_finding(before.code())) " " }
                (message_before) "."
            }
        }
    }
}

fn list_of_items(items: &[Markup]) -> Markup {
    html! { @if !items.is_empty() { ul.findings { @for item in items { li { (item) } } } } }
}

fn items_of_findings(
    fragment: &mut Fragment,
    findings: &[&FindingWithRemedy],
    file: &str,
    with_commands: bool,
) -> Vec<Markup> {
    findings.iter().map(|finding| item_of_finding(fragment, finding, file, with_commands)).collect()
}

/// A finding. `file` says to which file the line number belongs.
fn item_of_finding(
    fragment: &mut Fragment,
    finding: &FindingWithRemedy,
    file: &str,
    with_commands: bool,
) -> Markup {
    let message = finding.message.to_string();
    let place = finding.place.as_deref().filter(|place| !message.contains(*place));
    html! {
        p {
            (severity_tag(finding.severity)) " " (fragment.topics.link_to_finding(finding.code())) " "
            (message) "."
            @if place.is_some() || finding.position.is_some() {
                " " span.quiet {
                    @if let Some(place) = place { (place) }
                    @if place.is_some() && finding.position.is_some() { ", " }
                    @if let Some(position) = finding.position { (position) (file) }
                }
            }
        }
        @if let Some(command) = finding.command.as_ref().filter(|_| with_commands) {
            (command_line(command))
        }
    }
}

/// What screen readers call the table of verdicts.
const TABLE_NAME: &str = "Verdicts";

fn verdicts_of_model(verdicts: &[Verdict]) -> Markup {
    let rows = html! {
        @for verdict in verdicts {
            tr { (heading_cell(verdict)) td.words { (sign_tag(verdict.sign)) } (verdict_cell(verdict)) }
        }
    };
    let caption = format!("{} questions about the model.", number_in_words(verdicts.len()));
    table(TABLE_NAME, &caption, &["question", " verdict", " why"], &rows)
}

fn verdicts_of_change(before: &[Verdict], after: &[Verdict]) -> Markup {
    let rows = html! {
        @for (before, after) in before.iter().zip(after) { tr {
            (heading_cell(after)) td.words { (sign_tag(before.sign)) } td.words { (sign_tag(after.sign)) } (verdict_cell(after))
        } }
    };
    let headers = ["question", " before", " after", " why, after the change"];
    table(TABLE_NAME, "Six questions about the model, before and after the change.", &headers, &rows)
}

fn heading_cell(verdict: &Verdict) -> Markup {
    html! { th scope="row" { (verdict.on.as_question()) } }
}

fn sign_tag(sign: Sign) -> Markup {
    html! { span class={ "tag " (sign.as_str()) } { (sign.as_str()) } }
}

fn verdict_cell(verdict: &Verdict) -> Markup {
    let text = verdict.text.to_string();
    let place = verdict.place.as_deref().filter(|place| !text.contains(*place));
    html! { td.words { (text) @if let Some(place) = place { " " span.quiet { (place) } } } }
}

/// The number of questions in words: six; with a recording, seven.
fn number_in_words(questions: usize) -> String {
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

    fn are_paired(old: &FindingWithRemedy, new: &FindingWithRemedy) -> bool {
        FindingIndex::new(std::slice::from_ref(old)).find_same_or_other_depth(new).is_some()
    }

    #[test]
    fn findings_with_another_worst_sphere_are_paired() {
        let (heel, toe) = (&["heel", "toe"], &["toe"]);
        let before = finding(FindingCode::BeyondHertz, "heel", heel);
        assert!(are_paired(&before, &finding(FindingCode::BeyondHertz, "toe", toe)));
        assert!(are_paired(&before, &finding(FindingCode::SunkIn, "toe", toe)));
        assert!(!are_paired(&before, &finding(FindingCode::BeyondHuntCrossley, "toe", toe)));
    }

    #[test]
    fn findings_about_forces_are_paired_by_force() {
        let before = finding(FindingCode::ConnecteeByName, "left", &[]);
        assert!(are_paired(&before, &finding(FindingCode::ConnecteeByName, "left", &[])));
        assert!(!are_paired(&before, &finding(FindingCode::ConnecteeByName, "right", &[])));
    }

    #[test]
    fn an_equal_finding_is_preferred_to_a_similar_one() {
        let now = [finding(FindingCode::SunkIn, "a", &["a"]), finding(FindingCode::BeyondHertz, "b", &["b"])];
        let new = [finding(FindingCode::BeyondHertz, "c", &["c"])];
        let old = FindingIndex::new(&now);
        assert_eq!(
            old.find_same_or_other_depth(&new[0]).map(|old| old.code()),
            Some(FindingCode::BeyondHertz)
        );
    }
}
