//! The error of a number outside the domain of an equation.

/// A quantity that lies outside the domain of an equation.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum DomainError {
    /// A quantity is outside the range for which its equation is defined.
    #[error("{quantity} is {value:?}, expected {expected}")]
    OutOfRange {
        /// Name of the refused quantity, without its unit: `"sphere radius"`.
        quantity: &'static str,
        /// The value that was given, in SI units.
        value: f64,
        /// The allowed range in words: `"a finite number above 0"`.
        expected: &'static str,
    },
}

/// What an equation gives, or why it refuses its numbers.
pub type Result<T, E = DomainError> = std::result::Result<T, E>;

impl DomainError {
    /// The quantity that was refused: `"sphere radius"`.
    pub fn quantity(&self) -> &'static str {
        let Self::OutOfRange { quantity, .. } = self;
        quantity
    }

    /// The value that was refused, in SI units.
    pub fn value(&self) -> f64 {
        let Self::OutOfRange { value, .. } = self;
        *value
    }

    /// The range that was expected, in words.
    pub fn expected(&self) -> &'static str {
        let Self::OutOfRange { expected, .. } = self;
        expected
    }
}

/// `value`, if the condition `ok` of the caller is true; else an error with the `expected` range.
pub(crate) fn require_range(
    ok: bool,
    quantity: &'static str,
    value: f64,
    expected: &'static str,
) -> Result<f64> {
    if ok { Ok(value) } else { Err(DomainError::OutOfRange { quantity, value, expected }) }
}

/// Returns `value` if it is finite, else an error with the name of the quantity.
pub(crate) fn require_finite(quantity: &'static str, value: f64) -> Result<f64> {
    require_range(value.is_finite(), quantity, value, "a finite number")
}

/// `value`, if it is finite and above 0.
pub(crate) fn require_positive(quantity: &'static str, value: f64) -> Result<f64> {
    require_range(value.is_finite() && value > 0.0, quantity, value, "a finite number above 0")
}

/// `value`, if it is finite and not below 0.
pub(crate) fn require_non_negative(quantity: &'static str, value: f64) -> Result<f64> {
    require_range(value.is_finite() && value >= 0.0, quantity, value, "a finite number, 0 or above")
}

/// `value`, if it is finite and not below 1.
pub(crate) fn require_at_least_one(quantity: &'static str, value: f64) -> Result<f64> {
    require_range(value.is_finite() && value >= 1.0, quantity, value, "a finite number, 1 or above")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_message_has_the_value_and_the_expected_range() {
        let error = require_positive("sphere radius", -0.5).unwrap_err();
        assert_eq!(error.to_string(), "sphere radius is -0.5, expected a finite number above 0");
        assert_eq!((error.quantity(), error.value()), ("sphere radius", -0.5));
        assert_eq!(error.expected(), "a finite number above 0");
    }

    #[test]
    fn numbers_that_are_not_finite_are_refused() {
        for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert!(require_positive("q", value).is_err());
            assert!(require_non_negative("q", value).is_err());
            assert!(require_at_least_one("q", value).is_err());
        }
    }

    #[test]
    fn bounds_are_allowed_only_in_closed_domains() {
        assert!(require_positive("q", 0.0).is_err());
        assert_eq!(require_non_negative("q", 0.0), Ok(0.0));
        assert_eq!(require_at_least_one("q", 1.0), Ok(1.0));
        assert!(require_at_least_one("q", 0.999).is_err());
    }
}
