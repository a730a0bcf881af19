//! The units of series.

/// A point of a curve.
pub type Point = (f64, f64);

/// How indentations are counted.
///
/// Exhaustive: code that draws a series needs an axis for each unit, and no other axis can take its place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum IndentationUnit {
    /// x/R.
    Relative,
    /// mm.
    Millimetre,
}

/// How forces are counted. Exhaustive, as [`IndentationUnit`] is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ForceUnit {
    /// N.
    Newton,
    /// Shares of the body weight that one sphere carries, M g / n.
    WeightShare,
}

/// The units of a figure.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Units {
    /// Of the indentation.
    pub indentation: IndentationUnit,
    /// Of the force.
    pub force: ForceUnit,
}

impl Units {
    /// An indentation in m, of a sphere of radius R.
    #[must_use]
    pub fn x(self, indentation_m: f64, radius_m: f64) -> f64 {
        match self.indentation {
            IndentationUnit::Relative => indentation_m / radius_m,
            IndentationUnit::Millimetre => indentation_m * 1e3,
        }
    }

    /// The indentation in m that the axis shows as `value`, of a sphere of radius R.
    #[must_use]
    pub fn metres(self, value: f64, radius_m: f64) -> f64 {
        match self.indentation {
            IndentationUnit::Relative => value * radius_m,
            IndentationUnit::Millimetre => value * 1e-3,
        }
    }
}
