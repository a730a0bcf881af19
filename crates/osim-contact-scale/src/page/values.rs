//! Cells that several tables share.

use maud::{Markup, html};
use osim_patch::Severity;

/// How bad something is, as a word with a colour.
pub(super) fn severity(severity: Severity) -> Markup {
    let word = severity.as_str();
    html! { span class={ "tag " (word) } { (word) } }
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
