//! A plain value or factor for a property.

use crate::messages::shortest;

/// What happens to a property.
///
/// Exhaustive: there is nothing between a value and a factor.
///
/// ```
/// use osim_model::Assignment;
/// assert_eq!(Assignment::Value(1e6).to_string(), "1000000");
/// assert_eq!(Assignment::Factor(0.5).to_string(), "x0.5");
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Assignment {
    /// This value, in the unit of the property.
    Value(f64),
    /// Its value times this.
    Factor(f64),
}

impl std::fmt::Display for Assignment {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Value(value) => f.write_str(&shortest(*value)),
            Self::Factor(factor) => write!(f, "x{}", shortest(*factor)),
        }
    }
}
