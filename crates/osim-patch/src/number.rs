//! The one spelling in which this project writes numbers into models and tables.

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
        return format!("{value}");
    }
    format!("{value:e}")
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

    proptest! {
        #[test]
        fn reads_back_exactly(value in any::<f64>().prop_filter("finite", |v| v.is_finite())) {
            prop_assert_eq!(shortest(value).parse::<f64>().unwrap().to_bits(), value.to_bits());
        }
    }
}
