//! Findings of one model, for people.

use osim_inspect::CheckResult;
use osim_model::Finding;

use crate::layout::{Colour, severity, wrapped};

/// Every finding, worst first, with what to do. What was found is taken as it is spelled; `prompt` is before each remedy.
#[must_use]
pub fn text(found: &CheckResult, prompt: &str, colour: Colour) -> String {
    let mut text = wrapped(&format!("{}: {}", found.model, found.counts.describe("nothing to say")), "  ");
    let mut rest = found.findings.as_slice();
    while let Some(first) = rest.first() {
        // The same trap in several places is explained once.
        let same = rest.iter().take_while(|finding| finding.code == first.code).count();
        let (alike, others) = rest.split_at(same);
        text.push('\n');
        text.push_str(&block(first, alike, prompt, colour));
        rest = others;
    }
    text
}

fn block(first: &Finding, alike: &[Finding], prompt: &str, colour: Colour) -> String {
    let mut text = format!("{} {}\n", severity(first.code.severity(), colour), first.code);
    for finding in alike {
        let line = finding.line.map(|line| format!("line {line}: ")).unwrap_or_default();
        let message = finding.message.to_string();
        let place = finding.place.as_deref().filter(|place| !message.contains(*place));
        let place = place.map(|place| format!("{place}: ")).unwrap_or_default();
        text.push_str(&wrapped(&format!("  {line}{place}{message}"), "    "));
    }
    text.push_str(&wrapped(&format!("  Why: {}", first.why), "       "));
    text.push_str(&wrapped(&format!("  Do:  {}.", first.advice), "       "));
    // Never broken into lines: it is there to be copied.
    for command in alike.iter().filter_map(|finding| finding.command.as_ref()) {
        text.push_str(&format!("  {prompt}{command}\n"));
    }
    text
}
