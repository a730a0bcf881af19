//! Rows that are missing.

use super::data::Table;

/// A step this many times as long as the usual one lacks a row: less is a rounded time.
const LACKS_A_ROW: f64 = 1.5;

/// A time without rows, longer than the usual step from row to row.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Gap {
    /// The time of the row before it, s.
    pub from_s: f64,
    /// The time of the row after it, s.
    pub to_s: f64,
}

impl Gap {
    /// How long it is, s.
    #[must_use]
    pub fn length_s(&self) -> f64 {
        self.to_s - self.from_s
    }
}

impl Table {
    /// Where rows are missing: steps in time that are longer than 1.5 times the median of all.
    ///
    /// ```
    /// use osim_motion::Table;
    ///
    /// let table = Table::read(b"endheader\ntime x\n0.00 1\n0.01 1\n0.02 1\n0.05 1\n0.06 1\n")?;
    /// let gaps = table.gaps();
    /// assert_eq!((gaps.len(), gaps[0].from_s, gaps[0].to_s), (1, 0.02, 0.05));
    /// # Ok::<(), osim_motion::MotionFault>(())
    /// ```
    #[must_use]
    pub fn gaps(&self) -> Vec<Gap> {
        let steps = self.time_s.windows(2).filter_map(|pair| match pair {
            [from_s, to_s] => Some(Gap { from_s: *from_s, to_s: *to_s }),
            _ => None,
        });
        let mut lengths: Vec<f64> = steps.clone().map(|step| step.length_s()).collect();
        let middle = lengths.len() / 2;
        if lengths.is_empty() {
            return Vec::new();
        }
        let (_, usual_s, _) = lengths.select_nth_unstable_by(middle, f64::total_cmp);
        let longest_usual_s = LACKS_A_ROW * *usual_s;
        steps.filter(|step| step.length_s() > longest_usual_s).collect()
    }
}

#[cfg(test)]
mod tests {
    use crate::table::{AngleUnit, Table};

    fn gaps(times: &[f64]) -> Vec<(f64, f64)> {
        let table = Table::of_columns(times.to_vec(), Vec::new(), AngleUnit::Radians).unwrap();
        table.gaps().iter().map(|gap| (gap.from_s, gap.to_s)).collect()
    }

    #[test]
    fn a_gap_lacks_a_row() {
        assert_eq!(gaps(&[]), []);
        assert_eq!(gaps(&[1.0]), []);
        assert_eq!(gaps(&[1.0, 2.0]), []);
        // 120 Hz with three digits: steps of 8 and 9 ms.
        assert_eq!(gaps(&[0.0, 0.008, 0.017, 0.025, 0.033, 0.042]), []);
        assert_eq!(gaps(&[0.0, 0.1, 0.2, 0.4, 0.5, 0.9, 1.0]), [(0.2, 0.4), (0.5, 0.9)]);
    }
}
