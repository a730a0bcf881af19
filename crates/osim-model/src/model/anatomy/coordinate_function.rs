//! The functions that describe how coordinates move joints, such as SIMM's cubic spline.

use crate::model::document::Document;
use crate::xml::{ElementId, opensim_text};

/// A function of one coordinate or of time, read from a model file: the kinds of OpenSim's functions that are supported, with their
/// numbers.
#[derive(Debug, Clone, PartialEq)]
pub enum CoordinateFunction {
    /// The coefficients of a polynomial, beginning with the highest power. A constant has one coefficient.
    Polynomial(Vec<f64>),
    /// A factor, and the function that it multiplies.
    Scaled(f64, Box<CoordinateFunction>),
    /// Straight lines between points: the x values and the y values of the points.
    PiecewiseLinear(Vec<f64>, Vec<f64>),
    /// A cubic spline as the program SIMM defines it.
    Spline(SimmSpline),
}

impl CoordinateFunction {
    /// The function that is 0 everywhere.
    pub(crate) const ZERO: Self = Self::Polynomial(Vec::new());

    /// Reads the function in `element`; `None` if its class is not supported or its numbers cannot be read.
    pub fn read(document: &Document, element: ElementId) -> Option<Self> {
        let tree = document.tree();
        match tree.name(element) {
            "Constant" => match tree.child(element, "value") {
                Some(_) => {
                    Some(Self::Polynomial(vec![*finite_numbers(document, element, "value")?.first()?]))
                }
                None => Some(Self::Polynomial(Vec::new())),
            },
            "LinearFunction" | "PolynomialFunction" => {
                Some(Self::Polynomial(finite_numbers(document, element, "coefficients")?))
            }
            "MultiplierFunction" => {
                let inner = tree.children(tree.child(element, "function")?).next()?;
                let scale = match tree.child(element, "scale") {
                    Some(_) => finite_numbers(document, element, "scale")?.first().copied()?,
                    None => 1.0,
                };
                Some(Self::Scaled(scale, Box::new(Self::read(document, inner)?)))
            }
            "PiecewiseLinearFunction" => {
                let (xs, ys) = points_of_curve(document, element)?;
                Some(Self::PiecewiseLinear(xs, ys))
            }
            // OpenSim reads both as the first.
            "SimmSpline" | "NaturalCubicSpline" | "natCubicSpline" => {
                let (xs, ys) = points_of_curve(document, element)?;
                Some(Self::Spline(SimmSpline::new(xs, ys)))
            }
            "GCVSpline" | "PiecewiseConstantFunction" => {
                let (_, ys) = points_of_curve(document, element)?;
                // Many joints hold constants as curves between equal values.
                let first = ys.first().copied()?;
                ys.iter().all(|&y| y == first).then(|| Self::Polynomial(vec![first]))
            }
            _ => None,
        }
    }

    /// The value of the function at `x`.
    pub fn value(&self, x: f64) -> f64 {
        self.value_and_slope(x).0
    }

    /// The derivative of the function at `x`.
    pub fn slope(&self, x: f64) -> f64 {
        self.value_and_slope(x).1
    }

    fn value_and_slope(&self, x: f64) -> (f64, f64) {
        match self {
            // Horner's scheme, differentiated.
            Self::Polynomial(coefficients) => {
                let step = |(sum, slope), coefficient: &f64| (sum * x + coefficient, slope * x + sum);
                coefficients.iter().fold((0.0, 0.0), step)
            }
            Self::Scaled(scale, inner) => {
                let (value, slope) = inner.value_and_slope(x);
                (scale * value, scale * slope)
            }
            Self::PiecewiseLinear(xs, ys) => piecewise_linear(xs, ys, x),
            Self::Spline(spline) => spline.value_and_slope(x),
        }
    }
}

pub(crate) fn finite_numbers(document: &Document, owner: ElementId, tag: &str) -> Option<Vec<f64>> {
    let tree = document.tree();
    let text = tree.text_of(tree.child(owner, tag)?);
    opensim_text::numbers(&text).filter(|values| values.iter().all(|value| value.is_finite()))
}

/// The points of a curve: at least one, with rising x.
fn points_of_curve(document: &Document, function: ElementId) -> Option<(Vec<f64>, Vec<f64>)> {
    let (xs, ys) = (finite_numbers(document, function, "x")?, finite_numbers(document, function, "y")?);
    (xs.len() == ys.len() && xs.is_sorted_by(|a, b| a < b)).then_some((xs, ys))
}

// SIMM's cubic spline, as OpenSim evaluates it.

/// A cubic spline through points; outside its points it continues as a straight line.
#[derive(Debug, Clone, PartialEq)]
pub struct SimmSpline {
    xs: Vec<f64>,
    ys: Vec<f64>,
    /// The width in x of each interval between two points.
    widths: Vec<f64>,
    /// The slope of the straight line across each interval.
    chord_slopes: Vec<f64>,
    /// A sixth of the second derivative at each point; empty for fewer than three points.
    curvature_sixths: Vec<f64>,
}

impl SimmSpline {
    /// The spline through the points; `xs` have to rise.
    fn new(xs: Vec<f64>, ys: Vec<f64>) -> Self {
        let widths: Vec<f64> = xs.windows(2).map(|pair| pair[1] - pair[0]).collect();
        let chord_slopes: Vec<f64> =
            ys.windows(2).zip(&widths).map(|(pair, width)| (pair[1] - pair[0]) / width).collect();
        let curvature_sixths =
            if xs.len() < 3 { Vec::new() } else { curvature_sixths(&xs, &widths, &chord_slopes) };
        Self { xs, ys, widths, chord_slopes, curvature_sixths }
    }

    // All indices are below the number of knots.
    fn value_and_slope(&self, x: f64) -> (f64, f64) {
        let Self { xs, ys, widths, chord_slopes, curvature_sixths } = self;
        let n = xs.len();
        if n < 3 {
            return piecewise_linear(xs, ys, x);
        }
        // y = y0 + b dx + c dx^2 + d dx^3 in each piece.
        let b =
            |k: usize| chord_slopes[k] - widths[k] * (curvature_sixths[k + 1] + 2.0 * curvature_sixths[k]);
        if x < xs[0] {
            return (ys[0] + (x - xs[0]) * b(0), b(0));
        }
        let last_slope = || {
            chord_slopes[n - 2] + widths[n - 2] * (curvature_sixths[n - 2] + 2.0 * curvature_sixths[n - 1])
        };
        if x > xs[n - 1] {
            return (ys[n - 1] + (x - xs[n - 1]) * last_slope(), last_slope());
        }
        let k = piece_index(xs, x);
        if x == xs[k + 1] {
            return (ys[k + 1], last_slope());
        }
        let dx = x - xs[k];
        let (c, d) = (3.0 * curvature_sixths[k], (curvature_sixths[k + 1] - curvature_sixths[k]) / widths[k]);
        (ys[k] + dx * (b(k) + dx * (c + dx * d)), b(k) + dx * (2.0 * c + dx * 3.0 * d))
    }
}

/// A sixth of the second derivative at each point of the spline of Forsythe, Malcolm and Moler, Computer Methods for Mathematical
/// Computations (1977), chapter 4: at both ends, the third derivative is that of the cubic through the four nearest points.
fn curvature_sixths(xs: &[f64], widths: &[f64], chord_slopes: &[f64]) -> Vec<f64> {
    // All indices are below the number of knots, which are three or more.
    let n = xs.len();
    let mut diagonal: Vec<f64> = vec![0.0; n];
    let mut right: Vec<f64> = vec![0.0; n];
    for k in 1..n - 1 {
        diagonal[k] = 2.0 * (widths[k - 1] + widths[k]);
        right[k] = chord_slopes[k] - chord_slopes[k - 1];
    }
    diagonal[0] = -widths[0];
    diagonal[n - 1] = -widths[n - 2];
    if n > 3 {
        let divided = |k: usize| right[k] / (xs[k + 1] - xs[k - 1]);
        let (first, last) = (divided(2) - divided(1), divided(n - 2) - divided(n - 3));
        right[0] = first * widths[0] * widths[0] / (xs[3] - xs[0]);
        right[n - 1] = -last * widths[n - 2] * widths[n - 2] / (xs[n - 1] - xs[n - 4]);
    }
    for k in 1..n {
        let part = widths[k - 1] / diagonal[k - 1];
        diagonal[k] -= part * widths[k - 1];
        right[k] -= part * right[k - 1];
    }
    right[n - 1] /= diagonal[n - 1];
    for k in (0..n - 1).rev() {
        right[k] = (right[k] - widths[k] * right[k + 1]) / diagonal[k];
    }
    right
}

/// The index of the interval that contains `x`; outside all intervals, the first or the last one.
fn piece_index(xs: &[f64], x: f64) -> usize {
    let after = xs.partition_point(|&knot| knot <= x);
    after.saturating_sub(1).min(xs.len().saturating_sub(2))
}

/// Value and slope of straight lines between points. The outer lines continue without end.
fn piecewise_linear(xs: &[f64], ys: &[f64], x: f64) -> (f64, f64) {
    let k = piece_index(xs, x);
    let (Some([x0, x1]), Some([y0, y1])) = (xs.get(k..k + 2), ys.get(k..k + 2)) else {
        return (ys.first().copied().unwrap_or_default(), 0.0);
    };
    (y0 + (x - x0) * (y1 - y0) / (x1 - x0), (y1 - y0) / (x1 - x0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn polynomial_functions_have_their_derivative_as_slope() {
        // 2 x^3 - x + 5 at 3: 54 - 3 + 5, and 6 x^2 - 1.
        let cubic = CoordinateFunction::Polynomial(vec![2.0, 0.0, -1.0, 5.0]);
        assert_eq!((cubic.value(3.0), cubic.slope(3.0)), (56.0, 53.0));
        let scaled = CoordinateFunction::Scaled(-0.5, Box::new(cubic));
        assert_eq!((scaled.value(3.0), scaled.slope(3.0)), (-28.0, -26.5));
        assert_eq!((CoordinateFunction::ZERO.value(3.0), CoordinateFunction::ZERO.slope(3.0)), (0.0, 0.0));
    }

    const KNOT_XS: [f64; 5] = [-1.0, 0.0, 0.5, 2.0, 3.5];
    const KNOT_YS: [f64; 5] = [0.2, 1.0, -0.3, 0.4, 2.0];

    fn spline_through(points: usize) -> SimmSpline {
        SimmSpline::new(KNOT_XS[..points].to_vec(), KNOT_YS[..points].to_vec())
    }

    /// The expected numbers are the results of `SimmSpline.calcValue` in OpenSim 4.6.
    #[test]
    fn spline_values_are_those_of_opensim() {
        let at = [-2.0, -1.0, -0.5, 0.0, 0.3, 0.5, 1.0, 2.0, 3.0, 3.5, 4.0];
        let expected = [
            -5.046931762395681,
            0.2,
            1.553399607265587,
            1.0,
            0.19329955817378497,
            -0.3,
            -0.7815742104401899,
            0.4,
            1.9023073146784486,
            2.0,
            1.7370152184585175,
        ];
        for (x, expected) in at.into_iter().zip(expected) {
            assert!((spline_through(5).value_and_slope(x).0 - expected).abs() < 1e-14, "at {x}");
        }
        // Three knots and two.
        let three = [(-2.0, -2.866666666666667), (-0.5, 1.166666666666667), (0.3, 0.356), (2.0, -5.9)];
        for (x, expected) in three {
            assert!((spline_through(3).value_and_slope(x).0 - expected).abs() < 1e-14, "at {x}");
        }
        assert!((spline_through(2).value_and_slope(0.3).0 - 1.24).abs() < 1e-14);
        assert_eq!(spline_through(1).value_and_slope(7.0).0, 0.2);
    }

    /// A slope equals the difference quotient of neighbouring values, also at points and outside the first and last point.
    #[test]
    fn spline_slopes_are_differences_of_values() {
        let (spline, step) = (spline_through(5), 1e-6);
        for x in [-2.0, -1.0, -0.5, 0.0, 0.3, 0.5, 1.0, 2.0, 3.0, 3.5, 4.0] {
            let by_values =
                (spline.value_and_slope(x + step).0 - spline.value_and_slope(x - step).0) / (2.0 * step);
            assert!(
                (spline.value_and_slope(x).1 - by_values).abs() < 1e-5,
                "at {x}: {} {by_values}",
                spline.value_and_slope(x).1
            );
        }
    }

    #[test]
    fn linear_functions_continue_outside_their_points() {
        for (x, expected, slope) in [
            (-2.0, -0.6, 0.8),
            (-0.5, 0.6, 0.8),
            (0.3, 0.22, -2.6),
            (2.0, 0.4, 1.6 / 1.5),
            (4.0, 2.0 + 1.6 / 3.0, 1.6 / 1.5),
        ] {
            let (value, its_slope) = piecewise_linear(&KNOT_XS, &KNOT_YS, x);
            assert!((value - expected).abs() < 1e-15 && (its_slope - slope).abs() < 1e-15, "at {x}");
        }
    }
}
