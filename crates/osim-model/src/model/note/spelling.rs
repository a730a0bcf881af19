//! How words and numbers are spelled in a note.

/// What nobody knew.
pub(super) const UNKNOWN: &str = "unknown";
const DIGEST_DIGITS: usize = 16;

/// `unknown`, or a mass above 0 with its unit; the outer `None` for anything else.
#[expect(clippy::option_option, reason = "what is unknown is not what cannot be read")]
pub(super) fn mass_kg(text: &str) -> Option<Option<f64>> {
    if text == UNKNOWN {
        return Some(None);
    }
    positive(text.strip_suffix(" kg")?).map(Some)
}

/// A number above 0.
pub(super) fn positive(text: &str) -> Option<f64> {
    text.parse().ok().filter(|number: &f64| number.is_finite() && *number > 0.0)
}

/// `unknown`, or a gravity of at least 0 with its unit; the outer `None` for anything else.
#[expect(clippy::option_option, reason = "what is unknown is not what cannot be read")]
pub(super) fn gravity_m_s2(text: &str) -> Option<Option<f64>> {
    if text == UNKNOWN {
        return Some(None);
    }
    let gravity: f64 = text.strip_suffix(" m/s2")?.parse().ok()?;
    (gravity.is_finite() && gravity >= 0.0).then_some(Some(gravity))
}

pub(super) fn is_digest(text: &str) -> bool {
    text.len() == DIGEST_DIGITS && text.bytes().all(|byte| byte.is_ascii_hexdigit())
}

/// Whether a note, inside a field, can hold `letter`. `-` is among the letters, but two of them would end a comment: see
/// [`plain`].
pub(super) fn is_plain(letter: char) -> bool {
    letter.is_ascii_graphic() && !";[]()<>&'\"".contains(letter)
}

/// `text` with `_` for every letter that a note cannot hold, and single blanks.
pub(super) fn plain(text: &str) -> String {
    let words = text.split_ascii_whitespace().map(|word| {
        let letters = word.chars().map(|letter| if is_plain(letter) { letter } else { '_' });
        letters.collect::<String>()
    });
    words.collect::<Vec<_>>().join(" ").replace("--", "__")
}
