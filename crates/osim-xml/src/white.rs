//! White space as C has it, which models are read with.

/// Whether C calls `letter` white space.
#[must_use]
pub const fn is_white(letter: char) -> bool {
    matches!(letter, ' ' | '\t'..='\r')
}

/// `text` without the white space around it.
#[must_use]
pub fn trimmed(text: &str) -> &str {
    text.trim_matches(is_white)
}
