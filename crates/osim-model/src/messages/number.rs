//! The one spelling in which this project writes numbers into models and tables.

use std::fmt::{self, Display, Write as _};

/// Shortest decimal text that reads back as exactly `value`.
///
/// Plain digits between 1e-5 and 1e15 (`0.0641715826`, `2005361.956`), an exponent outside (`4e-6`), no `.0`.
/// The layout is frozen: the same value has the same bytes on every platform and in every version. Not-finite values
/// are spelled `NaN`, `inf`, `-inf`; they are never written into a model.
#[must_use]
pub fn shortest(value: f64) -> String {
    if !value.is_finite() {
        return if value.is_nan() {
            "NaN".to_owned()
        } else if value > 0.0 {
            "inf".to_owned()
        } else {
            "-inf".to_owned()
        };
    }
    let magnitude = value.abs();
    if magnitude == 0.0 || (1e-5..1e15).contains(&magnitude) {
        // In this range `{}` is the shortest digits without an exponent.
        return text_of(format_args!("{value}"));
    }
    text_of(format_args!("{value:e}"))
}

/// A number has few letters: its text gets room for all of them at once.
fn text_of(number: fmt::Arguments<'_>) -> String {
    const LONGEST: usize = 24;
    let mut text = String::with_capacity(LONGEST);
    // Writing to a string cannot fail.
    let _ = text.write_fmt(number);
    text
}

/// A number for people: exact if the exact text is short, else eight significant digits.
#[must_use]
pub fn readable(value: f64) -> String {
    const SHORT: usize = 10;
    let exact = shortest(value);
    if exact.len() <= SHORT || !value.is_finite() {
        return exact;
    }
    shortest(rounded(value, 7))
}

/// `1 sphere`, `2 spheres`: a count, or a number as it is to be read, and what is counted.
#[must_use]
pub fn counted(count: impl Display, what: &str) -> String {
    let count = count.to_string();
    let ending = if count == "1" { "" } else { "s" };
    format!("{count} {what}{ending}")
}

/// Four significant digits, to compare by eye.
#[must_use]
pub fn four_significant(value: f64) -> String {
    significant(value, 4)
}

/// Three significant digits, for columns that are narrow.
#[must_use]
pub fn three_significant(value: f64) -> String {
    significant(value, 3)
}

fn significant(value: f64, digits: usize) -> String {
    let decimals = digits.saturating_sub(1);
    readable(rounded(value, decimals))
}

/// `value` with so many decimals in its exponential form; itself where that is more than a double holds.
fn rounded(value: f64, decimals: usize) -> f64 {
    let rounded = format!("{value:.decimals$e}").parse().ok();
    rounded.filter(|rounded: &f64| rounded.is_finite()).unwrap_or(value)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn the_layout_is_frozen() {
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
    fn numbers_for_people_are_short() {
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
    fn four_digits_are_kept() {
        assert_eq!(four_significant(0.353_300_157), "0.3533");
        assert_eq!(four_significant(13_449.52), "13450");
    }

    proptest! {
        #[test]
        fn reads_back_exactly(value in any::<f64>().prop_filter("finite", |v| v.is_finite())) {
            prop_assert_eq!(shortest(value).parse::<f64>().unwrap().to_bits(), value.to_bits());
        }
    }
}
