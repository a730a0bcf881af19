//! Character and entity references.

use std::borrow::Cow;

/// Resolves character and predefined entity references; an unknown one stays as it is written.
pub(super) fn decode(raw: Cow<'_, str>) -> Cow<'_, str> {
    if !raw.contains('&') {
        return raw;
    }
    match quick_xml::escape::unescape(&raw) {
        Ok(text) => Cow::Owned(text.into_owned()),
        Err(_) => raw,
    }
}
