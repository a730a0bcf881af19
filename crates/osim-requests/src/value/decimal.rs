//! Numbers as people type them, read strictly: a wrong one is refused with what to type instead.

use osim_model::shortest;

/// A spelling of a unit, and its size in the unit that is expected.
pub(crate) type UnitSpelling = (&'static str, f64);

/// A finite number above 0. `units` are spellings with a unit that are refused with the number to type.
pub(crate) fn positive(text: &str, expected: &str, units: &[UnitSpelling]) -> Result<f64, String> {
    let text = text.trim();
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
    for (unit, factor) in units {
        let number = text.strip_suffix(unit).map(str::trim_end).and_then(plain);
        if let Some(value) = number {
            // Multiplying by 1e-3 would show 0.020900000000000002; dividing is exact enough to type.
            let value = if *factor < 1.0 { value / (1.0 / factor).round() } else { value * factor };
            return Err(format!("units are not written here, expected {expected}: type {}", shortest(value)));
        }
    }
    let number = text.trim_end_matches(|c: char| !c.is_ascii_digit() && c != '.').trim_end();
    match plain(number) {
        Some(value) if number.len() < text.len() => {
            Err(format!("units are not written here, expected {expected} such as {}", shortest(value)))
        }
        _ => Err(format!("expected {expected}")),
    }
}

/// A decimal number without words such as `inf` or `nan`.
pub(crate) fn plain(text: &str) -> Option<f64> {
    let digits = text.bytes().all(|byte| byte.is_ascii_digit() || b"+-.eE".contains(&byte));
    if digits { text.parse().ok() } else { None }
}

/// A finite number above 0, whatever it counts.
pub(crate) fn positive_number(text: &str) -> Result<f64, String> {
    positive(text, "a number", &[])
}

/// A finite number, 0 or more.
pub(crate) fn number(text: &str) -> Result<f64, String> {
    if plain(text.trim()) == Some(0.0) {
        return Ok(0.0);
    }
    positive(text, "a number", &[])
}

/// What is after the `x` of a factor such as `x1.5`.
pub(crate) fn factor(text: &str) -> Option<&str> {
    text.strip_prefix(['x', 'X'])
}
