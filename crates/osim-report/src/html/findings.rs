//! What `check` found, and what a change made of it.

use maud::{Markup, html};
use osim_inspect::CheckResult;
use osim_model::{Finding, FindingCode, readable};

use super::fragment::Fragment;
use super::shell::command_line;
use super::values::severity;

const SECTION: (&str, &str) = ("findings", "Findings");

/// Findings of a model that was inspected.
pub(super) fn of_model(fragment: &mut Fragment, found: &CheckResult) {
    let findings: Vec<&Finding> = found.findings.iter().collect();
    let list = list(&items(fragment, &findings, Lines::Only, Commands::Shown));
    let body = html! {
        @if found.findings.is_empty() { p { "Nothing to say: all figures are within the limits." } }
        (list)
    };
    fragment.section(SECTION.0, SECTION.1, &body);
}

/// The new model, as far as its findings are concerned.
pub(super) struct After<'r> {
    pub(super) found: &'r CheckResult,
    /// It is in a file, so that commands can name it.
    pub(super) in_file: bool,
    /// Contacts are scaled to a gravity that the model's file does not say yet, m/s².
    pub(super) gravity_m_s2: Option<f64>,
}

/// Findings before and after: what came, what stayed, what went.
pub(super) fn of_change(fragment: &mut Fragment, now: &CheckResult, new: &After<'_>) {
    let pairs = paired(&now.findings, &new.found.findings);
    let comes: Vec<&Finding> =
        pairs.iter().filter(|(_, before)| before.is_none()).map(|(one, _)| *one).collect();
    let gone = |one: &&Finding| !new.found.findings.iter().any(|other| kinship(one, other).is_some());
    let goes: Vec<&Finding> = now.findings.iter().filter(gone).collect();
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
        @for (title, items) in groups {
            (fragment.heading(title))
            @if items.is_empty() { p.quiet { "Nothing." } } @else { (list(&items)) }
        }
    };
    fragment.section(SECTION.0, SECTION.1, &body);
}

/// Each new finding with the old one that says the same, if there is one.
fn paired<'f>(now: &'f [Finding], new: &'f [Finding]) -> Vec<(&'f Finding, Option<&'f Finding>)> {
    let nearest = |one: &Finding| {
        now.iter().filter_map(|old| Some((kinship(old, one)?, old))).min_by_key(|(far, _)| *far)
    };
    new.iter().map(|one| (one, nearest(one).map(|(_, old)| old))).collect()
}

/// Findings that are steps of one ladder: one takes the place of the other as spheres sink in deeper.
const DEPTH: [FindingCode; 3] =
    [FindingCode::BeyondHertzAtTwo, FindingCode::BeyondHertz, FindingCode::SunkIn];

/// How far apart what two findings say is: 0 the same, 1 another step of a ladder; `None` where they are not akin.
///
/// What is said of spheres is shown once for all of them, at the worst, which may be another one after the change.
fn kinship(old: &Finding, new: &Finding) -> Option<u8> {
    let about_spheres = !old.spheres.is_empty() && !new.spheres.is_empty();
    match old.code == new.code {
        true if about_spheres || old.place == new.place => Some(0),
        false if DEPTH.contains(&old.code) && DEPTH.contains(&new.code) => Some(1),
        _ => None,
    }
}

/// What the finding was before, where that differs.
fn was(fragment: &mut Fragment, one: &Finding, before: &Finding) -> Markup {
    let other = before.code != one.code;
    let (message, message_before) = (one.message.to_string(), before.message.to_string());
    html! {
        @if other || message_before != message {
            p.quiet {
                "Before: "
                @if other { (severity(before.severity)) " " (fragment.topics.code(before.code)) " " }
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

fn items(fragment: &mut Fragment, findings: &[&Finding], lines: Lines, commands: Commands) -> Vec<Markup> {
    findings.iter().map(|finding| item(fragment, finding, lines, commands)).collect()
}

fn item(fragment: &mut Fragment, finding: &Finding, lines: Lines, commands: Commands) -> Markup {
    let message = finding.message.to_string();
    let place = finding.place.as_deref().filter(|place| !message.contains(*place));
    let file = match lines {
        Lines::Only => "",
        Lines::Old => " of the old file",
        Lines::New => " of the new file",
    };
    html! {
        p {
            (severity(finding.severity)) " " (fragment.topics.code(finding.code)) " "
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

#[cfg(test)]
mod tests {
    use super::*;

    fn finding(code: FindingCode, place: &str, spheres: &[&str]) -> Finding {
        let spheres = spheres.iter().map(|&name| name.to_owned()).collect();
        Finding::new(code, "").about(place).of_spheres(spheres)
    }

    #[test]
    fn the_worst_sphere_may_be_another_one_after_a_change() {
        let (heel, toe) = (&["heel", "toe"], &["toe"]);
        let before = finding(FindingCode::BeyondHertz, "heel", heel);
        assert_eq!(kinship(&before, &finding(FindingCode::BeyondHertz, "toe", toe)), Some(0));
        assert_eq!(kinship(&before, &finding(FindingCode::SunkIn, "toe", toe)), Some(1));
        assert_eq!(kinship(&before, &finding(FindingCode::BeyondHuntCrossley, "toe", toe)), None);
    }

    #[test]
    fn what_is_said_of_forces_belongs_to_each() {
        let before = finding(FindingCode::ConnecteeByName, "left", &[]);
        assert_eq!(kinship(&before, &finding(FindingCode::ConnecteeByName, "left", &[])), Some(0));
        assert_eq!(kinship(&before, &finding(FindingCode::ConnecteeByName, "right", &[])), None);
    }

    #[test]
    fn the_same_finding_is_nearer_than_another_step() {
        let now = [finding(FindingCode::SunkIn, "a", &["a"]), finding(FindingCode::BeyondHertz, "b", &["b"])];
        let new = [finding(FindingCode::BeyondHertz, "c", &["c"])];
        assert_eq!(paired(&now, &new)[0].1.map(|old| old.code), Some(FindingCode::BeyondHertz));
    }
}
