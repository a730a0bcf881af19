//! The verdicts on a model, a line each.

use osim_inspect::Verdict;

use crate::report::layout::{Colour, sign, wrapped};

/// Columns before the words of a verdict.
const INDENT: usize = 20;

/// A line for each verdict: its sign, what it is on, and the answer.
pub(super) fn lines(verdicts: &[Verdict], colour: Colour) -> String {
    verdicts.iter().map(|verdict| line(verdict, colour)).collect()
}

fn line(verdict: &Verdict, colour: Colour) -> String {
    let word = verdict.sign.as_str();
    let head = format!("  {word:<8} {:<9}", verdict.on.as_str());
    let text = verdict.text.to_string();
    let place = verdict.place.as_deref().filter(|place| !text.contains(*place));
    let place = place.map(|place| format!(" ({place})")).unwrap_or_default();
    let line = wrapped(&format!("{head}{text}{place}"), &" ".repeat(INDENT));
    line.replacen(word, &sign(verdict.sign, colour), 1)
}
