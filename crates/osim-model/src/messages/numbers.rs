//! Writes numbers: exactly, for models and tables, or rounded, for readers.

use std::fmt::{self, Display, Write};

/// The shortest decimal text that reads back as exactly `value`.
///
/// Plain digits between 1e-5 and 1e15 (`0.0641715826`, `2005361.956`), else an exponent (`4e-6`); no `.0`. The layout never changes: the
/// same value gives the same bytes on every platform and in every version. Values that are not finite become `NaN`, `inf`, `-inf`; these
/// are never written into a model.
pub fn shortest(value: f64) -> String {
    let magnitude = value.abs();
    if magnitude == 0.0 || (1e-5..1e15).contains(&magnitude) {
        // In this range `{}` is the shortest digits without an exponent.
        return formatted(format_args!("{value}"));
    }
    formatted(format_args!("{value:e}"))
}

/// Writes a number into a string that is allocated only once.
fn formatted(number: fmt::Arguments<'_>) -> String {
    const LONGEST_NUMBER: usize = 24;
    let mut text = String::with_capacity(LONGEST_NUMBER);
    // Writing to a string cannot fail.
    let _ = text.write_fmt(number);
    text
}

/// A number for readers: exact if the exact text is short, else with eight significant digits.
pub fn readable(value: f64) -> String {
    const LONGEST_EXACT_TEXT: usize = 10;
    let exact = shortest(value);
    if exact.len() <= LONGEST_EXACT_TEXT || !value.is_finite() {
        return exact;
    }
    shortest(rounded(value, 7))
}

/// A count with its noun, plural if needed: `1 sphere`, `2 spheres`.
pub fn counted(count: impl Display, what: &str) -> String {
    let count = count.to_string();
    let ending = if count == "1" { "" } else { "s" };
    format!("{count} {what}{ending}")
}

/// A number with four significant digits, for comparing by eye.
pub fn four_significant(value: f64) -> String {
    in_significant_digits(value, 4)
}

/// Two numbers with four significant digits; with more if they would look equal.
pub fn four_significant_apart(pair: [f64; 2]) -> [String; 2] {
    let [one, other] = pair.map(four_significant);
    if one == other { pair.map(readable) } else { [one, other] }
}

/// A number with three significant digits, for narrow columns.
pub fn three_significant(value: f64) -> String {
    in_significant_digits(value, 3)
}

fn in_significant_digits(value: f64, digits: usize) -> String {
    let decimals = digits.saturating_sub(1);
    readable(rounded(value, decimals))
}

/// `value` rounded to `decimals` digits after the first one; `value` itself if the result is not finite.
fn rounded(value: f64, decimals: usize) -> f64 {
    let rounded = format!("{value:.decimals$e}").parse().ok();
    rounded.filter(|rounded: &f64| rounded.is_finite()).unwrap_or(value)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn shortest_numbers_keep_their_layout() {
        for (value, text) in [
            (1e6, "1000000"),
            (0.032, "0.032"),
            (1e-5, "0.00001"),
            (9.9e-6, "9.9e-6"),
            (1e15, "1e15"),
            (123456789012345.0, "123456789012345"),
            (-2.5, "-2.5"),
            (0.0, "0"),
            (1.5e-300, "1.5e-300"),
        ] {
            assert_eq!(shortest(value), text);
        }
    }

    #[test]
    fn numbers_in_messages_are_short() {
        for (value, text) in [
            (0.032, "0.032"),
            (2_005_361.956_123, "2005362"),
            (0.064_171_582_614_44, "0.064171583"),
            (4.021_476_612_3e-6, "4.0214766e-6"),
            (f64::NAN, "NaN"),
        ] {
            assert_eq!(readable(value), text);
        }
    }

    #[test]
    fn numbers_with_four_digits_keep_them() {
        assert_eq!(four_significant(0.353_300_157), "0.3533");
        assert_eq!(four_significant(13_449.52), "13450");
        assert_eq!(four_significant_apart([0.054_124_409, 0.0541]), ["0.05412", "0.0541"]);
        assert_eq!(four_significant_apart([75.1646, 75.1649]), ["75.1646", "75.1649"]);
    }

    proptest! {
        #[test]
        fn shortest_numbers_read_back_exactly(value in any::<f64>().prop_filter("finite", |v| v.is_finite())) {
            prop_assert_eq!(shortest(value).parse::<f64>().unwrap().to_bits(), value.to_bits());
        }
    }
}
