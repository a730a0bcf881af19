//! One line of JSON.

use serde::Serialize;

/// A value as one JSON object and a line end. Numbers that are not finite become null.
pub fn line(value: &impl Serialize) -> String {
    // Serialising owned strings, numbers and lists cannot fail; an empty line would be seen at once if it did.
    let mut text = serde_json::to_string(value).unwrap_or_default();
    text.push('\n');
    text
}
