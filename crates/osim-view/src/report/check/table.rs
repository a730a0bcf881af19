//! Findings of one model, for people.

use std::collections::BTreeSet;

use osim_inspect::{CheckResult, Found};
use osim_model::FindingCode;
use osim_model::messages::one_line;

use super::verdicts;
use crate::report::layout::{Colour, severity, wrapped, wrapped_with_path};
use crate::report::similarity;

/// The verdicts, then every finding, worst first, with what to do. What was found is taken as it is spelled; `prompt` is before each remedy.
///
/// What was published so with known contacts is named once, and not explained, except that they may be for another mass.
#[must_use]
pub fn text(found: &CheckResult, prompt: &str, colour: Colour) -> String {
    let known = found.findings.iter().find(|finding| finding.code() == FindingCode::KnownContacts);
    let clean = known.filter(|_| found.counts.error + found.counts.warn == 0);
    let shown: Vec<&Found> = found
        .findings
        .iter()
        .filter(|finding| {
            (!finding.as_published || is_of_another_mass(finding))
                && clean.is_none_or(|known| known.code() != finding.code())
        })
        .collect();
    let published = published(found);
    let head = match clean {
        Some(known) if found.findings.iter().any(is_of_another_mass) => {
            let mass = "this body weighs something else: the contacts may be for another mass";
            format!("nothing is wrong for certain; {}, and {mass}{published}", known.message)
        }
        Some(known) => format!("nothing is wrong; {}{published}", known.message),
        None => found.counts.describe("nothing to say"),
    };
    let mut text = wrapped_with_path(&found.model, &head, "  ");
    text.push_str(&verdicts::lines(&found.verdicts, colour));
    // What puts several findings right is not repeated with each.
    let mended: BTreeSet<FindingCode> =
        found.findings.iter().filter(|one| one.command.is_some()).map(|one| one.code()).collect();
    let at_end = found.commands.len() > 1 || mended.len() > 1;
    let mut rest = shown.as_slice();
    while let Some(first) = rest.first() {
        // The same trap in several places is explained once.
        let same = rest.iter().take_while(|finding| finding.code() == first.code()).count();
        let (alike, others) = rest.split_at(same);
        text.push('\n');
        let more = if first.code() == FindingCode::KnownContacts { published.as_str() } else { "" };
        text.push_str(&block(first, alike, more, colour));
        if !at_end {
            text.push_str(&commands(alike.iter().filter_map(|finding| finding.command.as_ref()), prompt));
        }
        rest = others;
    }
    if at_end {
        let order = if found.commands.len() > 1 { ", one after the other" } else { "" };
        text.push_str(&format!("\nTo put it right{order}:\n"));
        text.push_str(&commands(&found.commands, prompt));
    }
    if let Some(list) = found.similarity.as_ref().filter(|list| list.is_worth_showing()) {
        text.push('\n');
        text.push_str(&similarity::text(list));
    }
    text
}

/// Commands, each once and in a line of its own, never broken: they are there to be copied.
fn commands<'f>(commands: impl IntoIterator<Item = &'f String>, prompt: &str) -> String {
    let mut commands: Vec<&String> = commands.into_iter().collect();
    commands.dedup();
    commands.into_iter().map(|command| format!("  {prompt}{}\n", one_line(command.clone()))).collect()
}

/// Whether it is a doubt about the mass: that others published contacts so does not make them right for this body.
fn is_of_another_mass(finding: &Found) -> bool {
    finding.code() == FindingCode::ContactsOfAnotherMass
}

/// The codes that are the published state of known contacts.
fn published(found: &CheckResult) -> String {
    let mut codes: Vec<&str> = found
        .findings
        .iter()
        .filter(|finding| finding.as_published && !is_of_another_mass(finding))
        .map(|finding| finding.code().as_str())
        .collect();
    codes.dedup();
    if codes.is_empty() {
        String::new()
    } else {
        format!(" (the published model has these findings, too: {})", codes.join(", "))
    }
}

fn block(first: &Found, alike: &[&Found], more: &str, colour: Colour) -> String {
    let mut text = format!("{} {}\n", severity(first.severity, colour), first.code());
    for finding in alike {
        let line = finding.line.map(|line| format!("line {line}: ")).unwrap_or_default();
        let message = finding.message.to_string();
        let place = finding.place.as_deref().filter(|place| !message.contains(*place));
        let place = place.map(|place| format!("{place}: ")).unwrap_or_default();
        text.push_str(&wrapped(&format!("  {line}{place}{message}{more}"), "    "));
    }
    text.push_str(&wrapped(&format!("  Why: {}", first.why), "       "));
    text.push_str(&wrapped(&format!("  Do:  {}.", first.advice), "       "));
    text
}
