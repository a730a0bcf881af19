//! One number of the table, printed and computed.

use super::column::Column;

/// One number of Table 1, as printed and as computed.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Compared {
    /// Where it is.
    pub column: Column,
    /// As the paper prints it.
    pub printed: &'static str,
    /// As it is computed, in the unit of the paper.
    pub computed: f64,
    /// As it is computed from the rounded number that the paper prints for the human, if it can also be computed in this way.
    pub from_rounded: Option<f64>,
}

impl Compared {
    /// The printed number; NaN if it is not a number.
    #[must_use]
    pub fn printed_value(&self) -> f64 {
        self.printed.parse().unwrap_or(f64::NAN)
    }

    /// Computed minus printed, in the unit of the paper.
    #[must_use]
    pub fn difference(&self) -> f64 {
        self.computed - self.printed_value()
    }

    /// The difference over the printed number.
    #[must_use]
    pub fn relative_difference(&self) -> f64 {
        self.difference() / self.printed_value()
    }

    /// Half a unit of the last digit that is printed.
    #[must_use]
    pub fn half_last_digit(&self) -> f64 {
        // An index of bytes says where the point is; what follows it are the decimals.
        let decimals = self.printed.find('.').map_or(0, |point| self.printed.len() - point - 1);
        0.5 * 10.0_f64.powi(-i32::try_from(decimals).unwrap_or(i32::MAX))
    }

    /// Whether the computed number is within half a unit of the last printed digit.
    #[must_use]
    pub fn is_within_last_digit(&self) -> bool {
        self.is_near(self.computed)
    }

    /// Whether it is not, but the number from the rounded one of the human is: then the paper has computed it so.
    #[must_use]
    pub fn is_from_rounded(&self) -> bool {
        !self.is_within_last_digit() && self.from_rounded.is_some_and(|value| self.is_near(value))
    }

    fn is_near(&self, value: f64) -> bool {
        // 2.065 - 2.07 is not 0.005 in binary; nothing that matters is hidden by one part in 1e9 of a digit.
        (value - self.printed_value()).abs() <= self.half_last_digit() * (1.0 + 1e-9)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn compared(printed: &'static str, computed: f64) -> Compared {
        Compared { column: Column::ContactStiffness, printed, computed, from_rounded: None }
    }

    #[test]
    fn half_a_unit_of_the_last_printed_digit_is_allowed() {
        for (printed, half) in [("207", 0.5), ("13.4", 0.05), ("0.218", 0.0005), ("2.00", 0.005)] {
            assert_eq!(compared(printed, 0.0).half_last_digit(), half, "{printed}");
        }
        assert!(compared("13.4", 13.4495).is_within_last_digit());
        assert!(compared("13.4", 13.35).is_within_last_digit());
        assert!(!compared("13.4", 13.4505).is_within_last_digit());
        assert!(!compared("13.5", 13.4495).is_within_last_digit());
    }

    #[test]
    fn differences_are_computed_minus_printed() {
        let seen = compared("200", 207.0);
        assert_eq!((seen.difference(), seen.relative_difference()), (7.0, 0.035));
    }

    #[test]
    fn a_number_from_a_rounded_one_is_told_apart() {
        let seen = Compared { from_rounded: Some(0.09155), ..compared("0.0916", 0.0915) };
        assert!(seen.is_from_rounded());
        assert!(!Compared { from_rounded: Some(0.0915), ..seen }.is_from_rounded());
        assert!(!Compared { computed: 0.0916, ..seen }.is_from_rounded());
    }
}
