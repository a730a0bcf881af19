//! White space around what people type.

/// `text` without white space around it, of whatever kind: what is typed or pasted may have a no-break space there, and it means
/// nothing. The texts of models are OpenSim's, see `osim_model::xml::opensim_text`.
#[must_use]
#[expect(clippy::disallowed_methods, reason = "the one place for texts of people, not of models")]
pub fn trimmed(text: &str) -> &str {
    text.trim()
}
