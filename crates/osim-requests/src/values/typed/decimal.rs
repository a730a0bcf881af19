//! Numbers as people type them, read strictly: a wrong one is refused with what to type instead.

use osim_model::messages::shortest;

use super::blanks::trimmed;

/// A spelling of a unit, and its size in the unit that is expected.
pub type UnitSpelling = (&'static str, f64);

/// Units of mass, in kg. A pound is 0.45359237 kg by definition, an ounce its 16th part.
pub const MASSES: &[UnitSpelling] = &[
    ("kg", 1.0),
    ("mg", 1e-6),
    ("g", 1e-3),
    ("t", 1e3),
    ("lbs", 0.453_592_37),
    ("lb", 0.453_592_37),
    ("oz", 0.453_592_37 / 16.0),
];

/// Units of length, in m. An inch is 0.0254 m by definition.
pub const LENGTHS: &[UnitSpelling] =
    &[("mm", 1e-3), ("cm", 1e-2), ("um", 1e-6), ("µm", 1e-6), ("m", 1.0), ("inch", 0.0254), ("in", 0.0254)];

/// A finite number above 0. `units` are spellings with a unit that are refused with the number to type.
///
/// # Errors
/// What was expected, and what to type.
pub fn positive(text: &str, expected: &str, units: &[UnitSpelling]) -> Result<f64, String> {
    let text = trimmed(text);
    if let Some(value) = plain(text) {
        return if value > 0.0 && value.is_finite() {
            Ok(value)
        } else {
            Err(format!("expected {expected}, above 0"))
        };
    }
    if let Some(value) = plain(&text.replacen(',', ".", 1)).filter(|_| text.matches(',').count() == 1) {
        // `1,190` may be a thousand and something: then the comma is not a decimal one.
        let grouped = |tail: &str| tail.len() == 3 && tail.bytes().all(|byte| byte.is_ascii_digit());
        return Err(match text.split_once(',') {
            Some((head, tail)) if head != "0" && grouped(tail) => {
                format!(
                    "it has a comma: type {} (or {head}{tail}, if it separates thousands)",
                    shortest(value)
                )
            }
            _ => format!("it has a decimal comma: type {}", shortest(value)),
        });
    }
    if let Some(value) = converted(text, units) {
        return Err(format!("units are not written here, expected {expected}: type {}", shortest(value)));
    }
    let number = text.trim_end_matches(|c: char| !c.is_ascii_digit() && c != '.');
    // What the number is in the unit that is expected is not known here: none is proposed.
    match plain(number) {
        Some(_) if number.len() < text.len() => {
            Err(format!("units are not written here, expected {expected}"))
        }
        _ => Err(format!("expected {expected}")),
    }
}

/// What a number with a unit is in the unit that is expected, to the digits that a conversion leaves right.
#[must_use]
pub fn converted(text: &str, units: &[UnitSpelling]) -> Option<f64> {
    let small = text.to_ascii_lowercase();
    // A capital M is another unit, a million times as large or more.
    let small = if text.ends_with("Mg") || text.contains("Mm") { text } else { small.as_str() };
    let (value, factor) = units.iter().find_map(|(unit, factor)| {
        let number = trimmed(small.strip_suffix(unit)?);
        Some((plain(number)?, *factor))
    })?;
    // 20.9 times 1e-3 would show 0.020900000000000002.
    let digits = format!("{:.13e}", value * factor);
    digits.parse().ok().filter(|value: &f64| *value > 0.0 && value.is_finite())
}

/// A decimal number without words such as `inf` or `nan`.
#[must_use]
pub fn plain(text: &str) -> Option<f64> {
    let digits = text.bytes().all(|byte| byte.is_ascii_digit() || b"+-.eE".contains(&byte));
    if digits { text.parse().ok() } else { None }
}

/// A finite number above 0, whatever it counts.
///
/// # Errors
/// It is none.
pub fn positive_number(text: &str) -> Result<f64, String> {
    positive(text, "a number", &[])
}

/// A finite number, 0 or more.
///
/// # Errors
/// It is none.
pub fn number(text: &str) -> Result<f64, String> {
    number_in(text, "a number", &[])
}

/// The same, with what is expected and spellings with a unit.
///
/// # Errors
/// It is none.
pub fn number_in(text: &str, expected: &str, units: &[UnitSpelling]) -> Result<f64, String> {
    if plain(trimmed(text)) == Some(0.0) {
        return Ok(0.0);
    }
    positive(text, expected, units)
}

/// The same, and one below 0 is refused in these words.
///
/// # Errors
/// It is none.
pub fn not_negative(text: &str, expected: &str, units: &[UnitSpelling]) -> Result<f64, String> {
    match plain(trimmed(text)) {
        Some(value) if value < 0.0 || !value.is_finite() => Err(format!("expected {expected}, 0 or more")),
        _ => number_in(text, expected, units),
    }
}

/// What is after the `x` of a factor such as `x1.5`.
#[must_use]
pub fn factor(text: &str) -> Option<&str> {
    text.strip_prefix(['x', 'X'])
}
