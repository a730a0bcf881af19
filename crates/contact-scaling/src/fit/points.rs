//! The rows of a measurement, checked, with a speed each.

use super::error::FitError;
use super::measurement::{Branch, Measurement, Rate};

/// One row.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Point {
    pub(super) row: usize,
    pub(super) indentation: f64,
    pub(super) force: f64,
    /// 0 where no rate is known.
    pub(super) speed: f64,
}

/// The rows of the branch that is to be fitted.
pub(super) fn collect(measurement: &Measurement<'_>, branch: Branch) -> Result<Vec<Point>, FitError> {
    let Measurement { indentation_m, force_n, rate } = measurement;
    check("indentation", indentation_m, indentation_m.len())?;
    check("force", force_n, indentation_m.len())?;
    let speeds = match rate {
        Rate::Unknown => None,
        Rate::Speed(speeds) => {
            check("speed", speeds, indentation_m.len())?;
            Some(speeds.to_vec())
        }
        Rate::Time(times) => {
            check("time", times, indentation_m.len())?;
            Some(speeds_from_times(indentation_m, times)?)
        }
    };
    let deepest = deepest_row(indentation_m);
    let wanted = |row: usize| match (branch, &speeds) {
        (Branch::Both, _) => true,
        (Branch::Loading, Some(speeds)) => speeds[row] >= 0.0,
        (Branch::Unloading, Some(speeds)) => speeds[row] < 0.0,
        (Branch::Loading, None) => row <= deepest,
        (Branch::Unloading, None) => row > deepest,
    };
    let point = |row: usize| Point {
        row,
        indentation: indentation_m[row],
        force: force_n[row],
        speed: speeds.as_ref().map_or(0.0, |speeds| speeds[row]),
    };
    Ok((0..indentation_m.len()).filter(|&row| wanted(row)).map(point).collect())
}

fn check(column: &'static str, values: &[f64], expected: usize) -> Result<(), FitError> {
    if values.len() != expected {
        return Err(FitError::Lengths { column, rows: values.len(), expected });
    }
    match values.iter().position(|value| !value.is_finite()) {
        Some(row) => Err(FitError::NotFinite { column, row, value: values[row] }),
        None => Ok(()),
    }
}

fn deepest_row(indentation: &[f64]) -> usize {
    let deeper = |best: usize, row: usize| if indentation[row] > indentation[best] { row } else { best };
    (0..indentation.len()).fold(0, deeper)
}

/// ẋ at each row: the slope there of the parabola through it and its neighbours.
fn speeds_from_times(indentation: &[f64], times: &[f64]) -> Result<Vec<f64>, FitError> {
    if let Some(row) = times.windows(2).position(|pair| pair[1] <= pair[0]) {
        return Err(FitError::TimeOrder { row });
    }
    let last = indentation.len().checked_sub(1).filter(|&last| last >= 2);
    let last = last.ok_or(FitError::TooFewPoints { found: indentation.len(), needed: 3 })?;
    let slope = |row: usize| {
        let middle = row.clamp(1, last - 1);
        let (a, b) = (times[middle] - times[middle - 1], times[middle + 1] - times[middle]);
        let first = (indentation[middle] - indentation[middle - 1]) / a;
        let second = (indentation[middle + 1] - indentation[middle]) / b;
        let bend = (second - first) / (a + b);
        first + bend * (2.0 * times[row] - times[middle - 1] - times[middle])
    };
    Ok((0..=last).map(slope).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn speeds_of_a_parabola_are_exact() {
        let times = [0.0, 0.1, 0.25, 0.3, 0.7];
        let x: Vec<f64> = times.iter().map(|t| 0.3 + 2.0 * t - 1.5 * t * t).collect();
        for (speed, t) in speeds_from_times(&x, &times).unwrap().iter().zip(times) {
            assert!((speed - (2.0 - 3.0 * t)).abs() < 1e-13);
        }
    }

    #[test]
    fn bad_columns_are_named_with_their_row() {
        let x = [0.0, 1.0, 2.0];
        let measure = |force_n, rate| {
            collect(&Measurement { indentation_m: &x, force_n, rate }, Branch::Both).unwrap_err().to_string()
        };
        assert_eq!(measure(&[1.0], Rate::Unknown), "force has 1 rows, expected 3 as indentation has");
        let nan = [1.0, f64::NAN, 1.0];
        assert_eq!(measure(&nan, Rate::Unknown), "force in row 1 is NaN, expected a finite number");
        let times = [0.0, 1.0, 1.0];
        assert_eq!(measure(&x, Rate::Time(&times)), "time does not rise after row 1, expected rising times");
    }

    #[test]
    fn branches_are_told_by_speed_or_by_depth() {
        let x = [0.0, 1.0, 2.0, 1.0, 0.5];
        let rows = |rate, branch| {
            let points = collect(&Measurement { indentation_m: &x, force_n: &x, rate }, branch).unwrap();
            points.iter().map(|p| p.row).collect::<Vec<_>>()
        };
        assert_eq!(rows(Rate::Unknown, Branch::Loading), [0, 1, 2]);
        assert_eq!(rows(Rate::Unknown, Branch::Unloading), [3, 4]);
        let speeds = [1.0, 0.0, -0.1, -1.0, -1.0];
        assert_eq!(rows(Rate::Speed(&speeds), Branch::Loading), [0, 1]);
        assert_eq!(rows(Rate::Speed(&speeds), Branch::Unloading), [2, 3, 4]);
    }
}
