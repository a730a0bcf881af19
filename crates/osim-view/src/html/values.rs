//! Words that several sections share.

use std::ffi::OsStr;
use std::path::Path;

use crate::report::layout::OUTSIDE;
use maud::{Markup, html};
use osim_model::Severity;

/// How bad something is, as a word with a colour.
pub(super) fn severity(severity: Severity) -> Markup {
    let word = severity.as_str();
    html! { span class={ "tag " (word) } { (word) } }
}

/// The first names, and how many more there are.
pub(super) fn listed(names: &[&str]) -> String {
    const NAMED: usize = 8;
    osim_model::messages::listed(names, NAMED)
}

/// A path that may be broken after each folder, so that long ones leave room for what is beside them.
pub(super) fn broken_at_folders(path: &str) -> Markup {
    html! { @for part in path.split_inclusive(['/', '\\']) { (part) @if part.ends_with(['/', '\\']) { wbr; } } }
}

/// A figure outside of its limit. The sign and the value must stay on one line.
pub(super) fn marked_outside(figure: &str) -> String {
    format!("{figure}\u{a0}{OUTSIDE}")
}

/// A clause as a sentence.
pub(super) fn sentence(clause: &str) -> String {
    let mut letters = clause.chars();
    let first = letters.next().map(|letter| letter.to_uppercase().collect::<String>()).unwrap_or_default();
    let end = if clause.ends_with('.') { "" } else { "." };
    format!("{first}{}{end}", letters.as_str())
}

/// The last part of a path as it is shown.
pub(super) fn file_name(shown: &str) -> &str {
    if shown == "-" {
        return "standard input";
    }
    Path::new(shown).file_name().and_then(OsStr::to_str).unwrap_or(shown)
}
