//! Cells that several tables share.

use maud::{Markup, html};
use osim_patch::Severity;

/// How bad something is, as a word with a colour.
pub(super) fn severity(severity: Severity) -> Markup {
    let word = severity.as_str();
    html! { span class={ "tag " (word) } { (word) } }
}

/// Names that are listed, before they are counted.
const NAMED: usize = 8;

/// The first names, and how many more there are.
pub(super) fn listed(names: &[&str]) -> String {
    let shown: Vec<&str> = names.iter().take(NAMED).copied().collect();
    match names.len().saturating_sub(NAMED) {
        0 => shown.join(", "),
        more => format!("{} and {more} more", shown.join(", ")),
    }
}

/// "1 error, 2 warnings", or nothing to say.
pub(super) fn counted(counts: crate::check::Counts) -> String {
    let all = [(counts.error, "error"), (counts.warn, "warning"), (counts.info, "remark")];
    let parts: Vec<String> = all
        .into_iter()
        .filter(|(count, _)| *count > 0)
        .map(|(count, name)| format!("{count} {name}{}", if count == 1 { "" } else { "s" }))
        .collect();
    if parts.is_empty() { "no findings".to_owned() } else { parts.join(", ") }
}

/// A clause as a sentence.
pub(super) fn sentence(clause: &str) -> String {
    let mut letters = clause.chars();
    let first = letters.next().map(|letter| letter.to_uppercase().collect::<String>()).unwrap_or_default();
    let end = if clause.ends_with('.') { "" } else { "." };
    format!("{first}{}{end}", letters.as_str())
}
