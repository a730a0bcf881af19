//! Slack: smooth corrections of a foot's height and pitch while it is on the ground, as uniform cubic B-splines.

use std::ops::Range;

use crate::fit::data::FootForces;
use crate::stance::Stance;

/// Knots of a spline are about this far apart, s: a foot's error hardly changes faster while it stands.
const KNOT_S: f64 = 0.1;
/// A window has at most so many pieces.
const MOST_PIECES: usize = 60;

/// Frames of one foot that share a spline: a stance, with half of the swing before and after it.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Window {
    pub(super) frames: Range<usize>,
    from_s: f64,
    piece_s: f64,
    pieces: usize,
}

/// The four splines that are not 0 at a time.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct Basis {
    /// The first of them.
    pub(super) first: usize,
    pub(super) values: [f64; 4],
    /// Their slopes, 1/s.
    pub(super) slopes: [f64; 4],
}

impl Window {
    /// Those of a foot: its frames, split in the middle between two stances.
    pub(super) fn all(foot: &FootForces, time_s: &[f64], weight_n: f64) -> Vec<Self> {
        let stances = Stance::all(time_s, &foot.measured_n, weight_n);
        let cuts = stances.windows(2).filter_map(|two| match two {
            [one, next] => Some(one.last.midpoint(next.first) + 1),
            _ => None,
        });
        let mut bounds: Vec<usize> = std::iter::once(0).chain(cuts).collect();
        bounds.push(time_s.len());
        let window = |two: &[usize]| match two {
            &[first, end] => Self::of(first..end, time_s),
            _ => None,
        };
        bounds.windows(2).filter_map(window).collect()
    }

    fn of(frames: Range<usize>, time_s: &[f64]) -> Option<Self> {
        let from_s = *time_s.get(frames.start)?;
        let length_s = *time_s.get(frames.end.checked_sub(1)?)? - from_s;
        let pieces = ((length_s / KNOT_S).round() as usize).clamp(1, MOST_PIECES);
        // One frame has no length.
        let piece_s = if length_s > 0.0 { length_s / pieces as f64 } else { KNOT_S };
        Some(Self { frames, from_s, piece_s, pieces })
    }

    /// How many splines there are.
    pub(super) fn splines(&self) -> usize {
        self.pieces + 3
    }

    /// The splines at a time.
    pub(super) fn basis(&self, time_s: f64) -> Basis {
        let place = ((time_s - self.from_s) / self.piece_s).clamp(0.0, self.pieces as f64);
        let first = (place as usize).min(self.pieces - 1);
        let t = place - first as f64;
        let left = 1.0 - t;
        let slope = 1.0 / self.piece_s;
        Basis {
            first,
            values: [
                left.powi(3) / 6.0,
                (3.0 * t.powi(3) - 6.0 * t * t + 4.0) / 6.0,
                (3.0 * left.powi(3) - 6.0 * left * left + 4.0) / 6.0,
                t.powi(3) / 6.0,
            ],
            slopes: [
                -slope * left * left / 2.0,
                slope * (3.0 * t * t - 4.0 * t) / 2.0,
                -slope * (3.0 * left * left - 4.0 * left) / 2.0,
                slope * t * t / 2.0,
            ],
        }
    }
}

impl Basis {
    /// A spline and its slope (1/s) with these coefficients.
    pub(super) fn at(&self, coefficients: &[f64]) -> (f64, f64) {
        let own = coefficients.get(self.first..self.first + 4).unwrap_or_default();
        let sum = |parts: &[f64; 4]| own.iter().zip(parts).map(|(a, b)| a * b).sum();
        (sum(&self.values), sum(&self.slopes))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn splines_add_to_one_and_follow_a_line() {
        let time_s: Vec<f64> = (0..=40).map(|step| 2.0 + f64::from(step) * 0.01).collect();
        let window = Window::of(0..41, &time_s).unwrap();
        assert_eq!((window.pieces, window.splines()), (4, 7));
        // The coefficients of the line t - 2: each at the middle of its spline, from one knot before the start.
        let line: Vec<f64> = (0..7).map(|place| 0.1 * (f64::from(place) - 1.0)).collect();
        for &time in &time_s {
            let basis = window.basis(time);
            assert!((basis.values.iter().sum::<f64>() - 1.0).abs() < 1e-12);
            assert!(basis.slopes.iter().sum::<f64>().abs() < 1e-9);
            let (value, slope) = basis.at(&line);
            assert!((value - (time - 2.0)).abs() < 1e-12 && (slope - 1.0).abs() < 1e-9, "{time}: {value}");
        }
    }
}
