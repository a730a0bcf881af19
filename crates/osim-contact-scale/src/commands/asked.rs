//! The call as it was typed, for reports.

use osim_requests::spell::shell_quoted;

/// The command line, each word quoted where a shell asks for it.
pub(super) fn asked() -> String {
    let words = std::env::args_os().skip(1).map(|word| shell_quoted(&word.to_string_lossy()));
    std::iter::once("osim-contact-scale".to_owned()).chain(words).collect::<Vec<_>>().join(" ")
}
