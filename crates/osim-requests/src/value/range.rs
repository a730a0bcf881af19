//! Numbers along an axis, in words: `FROM..TO/COUNT`.

use super::decimal::factor;

/// A range as it is written; what its ends mean is for the reader to say.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Range<'t> {
    /// The first value.
    pub(super) first: &'t str,
    /// The last value.
    pub(super) last: &'t str,
    /// How many there are, both ends among them.
    pub(super) count: u32,
}

impl<'t> Range<'t> {
    /// Whether `text` is meant as a range.
    pub(super) fn is_meant(text: &str) -> bool {
        text.contains("..")
    }

    /// Reads a range of 2 to `most` values; `None` where it is none.
    pub(super) fn read(text: &'t str, most: u32) -> Option<Self> {
        let (first, rest) = text.split_once("..")?;
        let (last, count) = rest.split_once('/')?;
        let count = count.trim().parse().ok().filter(|count| (2..=most).contains(count))?;
        Some(Self { first: first.trim(), last: last.trim(), count })
    }

    /// Whether both ends are factors, or both numbers; `None` where they are unlike.
    pub(super) fn are_factors(&self) -> Option<bool> {
        let is_factor = factor(self.first).is_some();
        (is_factor == factor(self.last).is_some()).then_some(is_factor)
    }
}

/// `count` numbers from `first` to `last`, equally far apart in their logarithms, both ends exact.
pub(super) fn spaced(first: f64, last: f64, count: u32) -> impl Iterator<Item = f64> {
    let steps = f64::from(count - 1);
    (0..count).map(move |index| match index {
        0 => first,
        _ if index + 1 == count => last,
        _ => first * (last / first).powf(f64::from(index) / steps),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_range_has_two_ends_and_a_count() {
        assert_eq!(Range::read("x0.1 .. x10 / 9", 9), Some(Range { first: "x0.1", last: "x10", count: 9 }));
        for refused in ["1..4", "1/3", "1..4/1", "1..4/10", "1..4/x", "1..4/-2", ""] {
            assert_eq!(Range::read(refused, 9), None, "{refused}");
        }
    }

    #[test]
    fn ends_are_exact_and_the_middle_is_the_geometric_mean() {
        // 0.1 * 100^(1/2) = 1.
        let values: Vec<f64> = spaced(0.1, 10.0, 3).collect();
        assert_eq!((values[0], values[2]), (0.1, 10.0));
        assert!((values[1] - 1.0).abs() < 1e-15);
    }
}
