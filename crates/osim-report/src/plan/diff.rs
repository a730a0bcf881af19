//! The change as a unified diff, as version control shows it.

use similar::TextDiff;

/// Differences between the bytes of a model before and after, under these names.
#[must_use]
pub fn unified_diff(old: &[u8], new: &[u8], old_name: &str, new_name: &str) -> String {
    // Bytes that are no UTF-8 are the same on both sides; a diff is for reading, so they may be shown as replacements.
    let (old, new) = (String::from_utf8_lossy(old), String::from_utf8_lossy(new));
    TextDiff::from_lines(old.as_ref(), new.as_ref())
        .unified_diff()
        .context_radius(1)
        .header(old_name, new_name)
        .to_string()
}
