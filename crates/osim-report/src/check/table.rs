//! Findings of one model, for people.

use osim_inspect::{CheckResult, Found};
use osim_messages::one_line;
use osim_model::FindingCode;

use super::verdicts;
use crate::layout::{Colour, severity, wrapped, wrapped_with_path};

/// The six verdicts, then every finding, worst first, with what to do. What was found is taken as it is spelled; `prompt` is before each remedy.
///
/// What was published so with known contacts is named once, and not explained.
#[must_use]
pub fn text(found: &CheckResult, prompt: &str, colour: Colour) -> String {
    let known = found.findings.iter().find(|finding| finding.code() == FindingCode::KnownContacts);
    let clean = known.filter(|_| found.counts.error + found.counts.warn == 0);
    let shown: Vec<&Found> = found
        .findings
        .iter()
        .filter(|finding| !finding.as_published && clean.is_none_or(|known| known.code() != finding.code()))
        .collect();
    let published = published(found);
    let head = match clean {
        Some(known) => format!("nothing is wrong; {}{published}", known.message),
        None => found.counts.describe("nothing to say"),
    };
    let mut text = wrapped_with_path(&found.model, &head, "  ");
    text.push_str(&verdicts::lines(&found.verdicts, colour));
    let mut rest = shown.as_slice();
    while let Some(first) = rest.first() {
        // The same trap in several places is explained once.
        let same = rest.iter().take_while(|finding| finding.code() == first.code()).count();
        let (alike, others) = rest.split_at(same);
        text.push('\n');
        let more = if first.code() == FindingCode::KnownContacts { published.as_str() } else { "" };
        text.push_str(&block(first, alike, more, (prompt, colour)));
        rest = others;
    }
    text
}

/// The codes that are the published state of known contacts.
fn published(found: &CheckResult) -> String {
    let mut codes: Vec<&str> = found
        .findings
        .iter()
        .filter(|finding| finding.as_published)
        .map(|finding| finding.code().as_str())
        .collect();
    codes.dedup();
    if codes.is_empty() { String::new() } else { format!(" (as published: {})", codes.join(", ")) }
}

fn block(first: &Found, alike: &[&Found], more: &str, (prompt, colour): (&str, Colour)) -> String {
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
    // Never broken into lines: it is there to be copied.
    let mut commands: Vec<&String> = alike.iter().filter_map(|finding| finding.command.as_ref()).collect();
    commands.dedup();
    for command in commands {
        text.push_str(&format!("  {prompt}{}\n", one_line(command.clone())));
    }
    text
}
