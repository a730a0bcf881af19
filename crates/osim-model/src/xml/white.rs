//! White space as C has it, which models are read with.

/// Whether C calls `letter` white space.
#[must_use]
pub const fn is_white(letter: char) -> bool {
    matches!(letter, ' ' | '\t'..='\r')
}

/// The same of a byte: white space is ASCII, so that what lies between its bytes are whole letters.
pub(super) const fn is_white_byte(byte: u8) -> bool {
    is_white(byte as char)
}

/// `text` without the white space around it.
#[must_use]
pub fn trimmed(text: &str) -> &str {
    let is_letter = |byte: &u8| !is_white_byte(*byte);
    let start = text.as_bytes().iter().position(is_letter);
    let end = text.as_bytes().iter().rposition(is_letter);
    let inner = start.zip(end).and_then(|(start, last)| text.get(start..=last));
    inner.unwrap_or_default()
}
