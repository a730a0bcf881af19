//! Numbers and ranges in texts from users, read strictly; the error message says what to type.

use osim_model::messages::shortest;

/// `text` without the white space around it, of any kind: typed or pasted texts may have a no-break space there. For texts of
/// models, see `osim_model::xml::opensim_text`.
#[expect(clippy::disallowed_methods, reason = "the one place for texts of people, not of models")]
pub fn trimmed(text: &str) -> &str {
    text.trim()
}

/// A spelling of a unit, and the size of this unit in the expected unit.
pub type UnitSpelling = (&'static str, f64);

/// Units of mass, in kg. A pound is 0.45359237 kg by definition, an ounce its 16th part.
pub(crate) const MASS_UNITS: &[UnitSpelling] = &[
    ("kg", 1.0),
    ("mg", 1e-6),
    ("g", 1e-3),
    ("t", 1e3),
    ("lbs", 0.453_592_37),
    ("lb", 0.453_592_37),
    ("oz", 0.453_592_37 / 16.0),
];

/// Units of length, in m. An inch is 0.0254 m by definition.
pub(crate) const LENGTH_UNITS: &[UnitSpelling] =
    &[("mm", 1e-3), ("cm", 1e-2), ("um", 1e-6), ("µm", 1e-6), ("m", 1.0), ("inch", 0.0254), ("in", 0.0254)];

/// A finite number above 0. A number with one of `units` is refused, and the message gives the converted number.
///
/// # Errors
/// The expected form, and advice what to type.
pub fn positive(text: &str, expected: &str, units: &[UnitSpelling]) -> Result<f64, String> {
    let text = trimmed(text);
    if let Some(value) = plain_number(text) {
        return if value > 0.0 && value.is_finite() {
            Ok(value)
        } else {
            Err(format!("expected {expected}, above 0"))
        };
    }
    if let Some(value) = plain_number(&text.replacen(',', ".", 1)).filter(|_| text.matches(',').count() == 1)
    {
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
    match plain_number(number) {
        Some(_) if number.len() < text.len() => {
            Err(format!("units are not written here, expected {expected}"))
        }
        _ => Err(format!("expected {expected}")),
    }
}

/// The number in a text with a unit, converted to the expected unit, without digits from rounding.
pub fn converted(text: &str, units: &[UnitSpelling]) -> Option<f64> {
    let small = text.to_ascii_lowercase();
    // A capital M is another unit, a million times as large or more.
    let small = if text.ends_with("Mg") || text.contains("Mm") { text } else { small.as_str() };
    let (value, factor) = units.iter().find_map(|(unit, factor)| {
        let number = trimmed(small.strip_suffix(unit)?);
        Some((plain_number(number)?, *factor))
    })?;
    // 20.9 times 1e-3 would show 0.020900000000000002.
    let digits = format!("{:.13e}", value * factor);
    digits.parse().ok().filter(|value: &f64| *value > 0.0 && value.is_finite())
}

/// A decimal number; words such as `inf` or `nan` are not numbers.
pub(crate) fn plain_number(text: &str) -> Option<f64> {
    let digits = text.bytes().all(|byte| byte.is_ascii_digit() || b"+-.eE".contains(&byte));
    if digits { text.parse().ok() } else { None }
}

/// A finite number above 0, for any quantity.
///
/// # Errors
/// The text is not such a number.
pub(crate) fn positive_number(text: &str) -> Result<f64, String> {
    positive(text, "a number", &[])
}

/// A finite number, 0 or more.
///
/// # Errors
/// The text is not such a number.
pub fn number(text: &str) -> Result<f64, String> {
    number_in(text, "a number", &[])
}

/// A finite number; `expected` and `units` are for the error message.
///
/// # Errors
/// The text is not such a number.
pub(crate) fn number_in(text: &str, expected: &str, units: &[UnitSpelling]) -> Result<f64, String> {
    if plain_number(trimmed(text)) == Some(0.0) { Ok(0.0) } else { positive(text, expected, units) }
}

/// A number that is 0 or more; `expected` and `units` are for the error message.
///
/// # Errors
/// The text is not such a number.
pub(crate) fn not_negative(text: &str, expected: &str, units: &[UnitSpelling]) -> Result<f64, String> {
    match plain_number(trimmed(text)) {
        Some(value) if value < 0.0 || !value.is_finite() => Err(format!("expected {expected}, 0 or more")),
        _ => number_in(text, expected, units),
    }
}

/// The text after the `x` of a factor such as `x1.5`.
pub fn factor(text: &str) -> Option<&str> {
    text.strip_prefix(['x', 'X'])
}

// Numbers along an axis, in words: `FROM..TO/COUNT`.

/// A range as it was typed; the caller interprets both ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TypedRange<'t> {
    /// First value of the range, as it was typed.
    pub first: &'t str,
    /// Last value of the range, as it was typed.
    pub last: &'t str,
    /// The number of values in the range, with both ends.
    pub count: u32,
}

impl<'t> TypedRange<'t> {
    /// Whether `text` looks like a range.
    pub fn is_meant(text: &str) -> bool {
        text.contains("..")
    }

    /// Reads a range of 2 to `most` values; `None` if it is not a range.
    pub fn read(text: &'t str, most: u32) -> Option<Self> {
        let (first, rest) = text.split_once("..")?;
        let (last, count) = rest.split_once('/')?;
        let count = trimmed(count).parse().ok().filter(|count| (2..=most).contains(count))?;
        Some(Self { first: trimmed(first), last: trimmed(last), count })
    }

    /// Whether both ends are factors (true) or both are plain numbers (false); `None` if they differ.
    pub(crate) fn are_factors(&self) -> Option<bool> {
        let is_factor = factor(self.first).is_some();
        (is_factor == factor(self.last).is_some()).then_some(is_factor)
    }
}

/// The range with colons in this program's spelling; `None` if there are no colons between numbers, or if the range is empty.
pub(crate) fn respell_colons(text: &str) -> Option<String> {
    ColonRange::read(text)?.range
}

/// The advice for a range with colons, as MATLAB has it: `FROM:STEP:TO`, or `FROM:TO` with steps of 1. `None` if there are no
/// colons between numbers.
pub(crate) fn advice_about_colons(text: &str) -> Option<String> {
    let here = "ranges are FROM..TO/COUNT here, equally spaced in their logarithm";
    Some(match ColonRange::read(text)? {
        ColonRange { range: Some(range), has_steps: true } => {
            let colons = "FROM:STEP:TO, as in MATLAB, has steps of equal size";
            format!("{here}: {colons}; write {range}, or the values with commas")
        }
        ColonRange { range: Some(range), .. } => format!("{here}: write {range}"),
        ColonRange { range: None, .. } => here.to_owned(),
    })
}

/// A range with colons between its numbers.
struct ColonRange {
    /// The range in this program's spelling; `None` if it has no values.
    range: Option<String>,
    /// Whether the range is `FROM:STEP:TO`; else it is `FROM:TO:COUNT`.
    has_steps: bool,
}

impl ColonRange {
    /// Reads two or three numbers with colons between them.
    fn read(text: &str) -> Option<Self> {
        let number = |part: &str| plain_number(factor(part).unwrap_or(part));
        let parts: Option<Vec<(&str, f64)>> =
            text.split(':').map(trimmed).map(|part| Some((part, number(part)?))).collect();
        let (from, middle, to) = match parts?.as_slice() {
            [from, to] => (*from, ("1", 1.0), *to),
            [from, middle, to] => (*from, *middle, *to),
            _ => return None,
        };
        let count = ((to.1 - from.1) / middle.1).floor() + 1.0;
        if count >= 2.0 && middle.1 > 0.0 {
            let range = format!("{}..{}/{}", from.0, to.0, shortest(count));
            return Some(Self { range: Some(range), has_steps: true });
        }
        // From 1e5 in steps of 1e6 to 10 is nothing: the last number is how many values there are.
        let is_count = to.1 >= 2.0 && to.1.fract() == 0.0 && from.1 < middle.1;
        let range = is_count.then(|| format!("{}..{}/{}", from.0, middle.0, to.0));
        Some(Self { range, has_steps: false })
    }
}

/// `count` numbers from `first` to `last`, at equal distances of their logarithms; both ends are exact.
pub(super) fn log_spaced(first: f64, last: f64, count: u32) -> impl Iterator<Item = f64> {
    let steps = f64::from(count - 1);
    (0..count).map(move |index| match index {
        0 => first,
        _ if index + 1 == count => last,
        _ => first * (last / first).powf(f64::from(index) / steps),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_range_has_two_ends_and_a_count() {
        assert_eq!(
            TypedRange::read("x0.1 .. x10 / 9", 9),
            Some(TypedRange { first: "x0.1", last: "x10", count: 9 })
        );
        for refused in ["1..4", "1/3", "1..4/1", "1..4/10", "1..4/x", "1..4/-2", ""] {
            assert_eq!(TypedRange::read(refused, 9), None, "{refused}");
        }
    }

    #[test]
    fn ranges_of_matlab_are_refused_with_the_right_spelling() {
        for (text, said) in [
            // In MATLAB this is empty: the last number is how many values there are.
            ("1e5:1e6:10", "write 1e5..1e6/10"),
            ("x0.1:x10:9", "write x0.1..x10/9"),
            // 1, 3, 5, 7, 9.
            ("1:2:9", "write 1..9/5,"),
            ("1e5:1e5:1e6", "write 1e5..1e6/10,"),
            // 2, 3, 4.
            ("2:4", "write 2..4/3,"),
            ("9:2:1", "FROM..TO/COUNT"),
        ] {
            let found = advice_about_colons(text).unwrap_or_default();
            assert!(found.contains(said), "{text}: {found}");
        }
        for text in ["1..4/3", "5", "a:b", "", "1:2:3:4"] {
            assert_eq!(advice_about_colons(text), None, "{text}");
        }
    }

    #[test]
    fn ends_are_exact_and_the_middle_is_the_geometric_mean() {
        // 0.1 * 100^(1/2) = 1.
        let values: Vec<f64> = log_spaced(0.1, 10.0, 3).collect();
        assert_eq!((values[0], values[2]), (0.1, 10.0));
        assert!((values[1] - 1.0).abs() < 1e-15);
    }
}
