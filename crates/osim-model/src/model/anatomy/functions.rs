//! The functions by which joints move.

use super::simm_spline::SimmSpline;
use super::straight_lines::straight;
use crate::model::document::Document;
use crate::xml::{ElementId, opensim_text};

/// A function of one coordinate (or of time), read from a file.
#[derive(Debug, Clone, PartialEq)]
pub struct CoordinateFunction(Kind);

#[derive(Debug, Clone, PartialEq)]
enum Kind {
    /// The coefficients of a polynomial, that of the highest power first; a constant is one.
    Polynomial(Vec<f64>),
    /// Another one, times a number.
    Scaled(f64, Box<Kind>),
    /// Straight lines between points.
    Straight(Vec<f64>, Vec<f64>),
    /// SIMM's cubic spline.
    Spline(SimmSpline),
}

impl CoordinateFunction {
    /// 0 everywhere.
    pub(super) const ZERO: Self = Self(Kind::Polynomial(Vec::new()));

    /// The function at `element`; `None` for one that is not known.
    #[must_use]
    pub fn read(document: &Document, element: ElementId) -> Option<Self> {
        Kind::read(document, element).map(Self)
    }

    /// Its value at `x`.
    #[must_use]
    pub fn value(&self, x: f64) -> f64 {
        self.0.value(x)
    }

    /// Its derivative at `x`.
    #[must_use]
    pub fn slope(&self, x: f64) -> f64 {
        self.0.slope(x)
    }
}

impl Kind {
    fn read(document: &Document, element: ElementId) -> Option<Self> {
        let tree = document.tree();
        match tree.name(element) {
            "Constant" => match tree.child(element, "value") {
                Some(_) => Some(Self::Polynomial(vec![*numbers(document, element, "value")?.first()?])),
                None => Some(Self::Polynomial(Vec::new())),
            },
            "LinearFunction" | "PolynomialFunction" => {
                Some(Self::Polynomial(numbers(document, element, "coefficients")?))
            }
            "MultiplierFunction" => {
                let inner = tree.children(tree.child(element, "function")?).next()?;
                let scale = match tree.child(element, "scale") {
                    Some(_) => numbers(document, element, "scale")?.first().copied()?,
                    None => 1.0,
                };
                Some(Self::Scaled(scale, Box::new(Self::read(document, inner)?)))
            }
            "PiecewiseLinearFunction" => {
                let (xs, ys) = knots(document, element)?;
                Some(Self::Straight(xs, ys))
            }
            // OpenSim reads both as the first.
            "SimmSpline" | "NaturalCubicSpline" | "natCubicSpline" => {
                let (xs, ys) = knots(document, element)?;
                Some(Self::Spline(SimmSpline::new(xs, ys)))
            }
            "GCVSpline" | "PiecewiseConstantFunction" => {
                let (_, ys) = knots(document, element)?;
                // Many joints hold constants as curves between equal values.
                let first = ys.first().copied()?;
                ys.iter().all(|&y| y == first).then(|| Self::Polynomial(vec![first]))
            }
            _ => None,
        }
    }

    fn value(&self, x: f64) -> f64 {
        match self {
            Self::Polynomial(coefficients) => {
                coefficients.iter().fold(0.0, |sum, coefficient| sum * x + coefficient)
            }
            Self::Scaled(scale, inner) => scale * inner.value(x),
            Self::Straight(xs, ys) => straight(xs, ys, x).0,
            Self::Spline(spline) => spline.at(x).0,
        }
    }

    fn slope(&self, x: f64) -> f64 {
        match self {
            // Horner's scheme, differentiated.
            Self::Polynomial(coefficients) => {
                let step = |(sum, slope), coefficient: &f64| (sum * x + coefficient, slope * x + sum);
                coefficients.iter().fold((0.0, 0.0), step).1
            }
            Self::Scaled(scale, inner) => scale * inner.slope(x),
            Self::Straight(xs, ys) => straight(xs, ys, x).1,
            Self::Spline(spline) => spline.at(x).1,
        }
    }
}

pub(super) fn numbers(document: &Document, owner: ElementId, tag: &str) -> Option<Vec<f64>> {
    let tree = document.tree();
    let text = tree.text_of(tree.child(owner, tag)?);
    opensim_text::numbers(&text).filter(|values| values.iter().all(|value| value.is_finite()))
}

/// The points of a curve: at least one, x rising.
fn knots(document: &Document, function: ElementId) -> Option<(Vec<f64>, Vec<f64>)> {
    let (xs, ys) = (numbers(document, function, "x")?, numbers(document, function, "y")?);
    (xs.len() == ys.len() && xs.is_sorted_by(|a, b| a < b)).then_some((xs, ys))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn polynomials_have_slopes() {
        // 2 x^3 - x + 5 at 3: 54 - 3 + 5, and 6 x^2 - 1.
        let cubic = Kind::Polynomial(vec![2.0, 0.0, -1.0, 5.0]);
        assert_eq!((cubic.value(3.0), cubic.slope(3.0)), (56.0, 53.0));
        let scaled = Kind::Scaled(-0.5, Box::new(cubic));
        assert_eq!((scaled.value(3.0), scaled.slope(3.0)), (-28.0, -26.5));
        assert_eq!((CoordinateFunction::ZERO.value(3.0), CoordinateFunction::ZERO.slope(3.0)), (0.0, 0.0));
    }
}
