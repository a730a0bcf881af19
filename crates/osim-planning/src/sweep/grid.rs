//! The points of a grid: every combination of the values of its axes.

use std::fmt;

use osim_requests::{Axis, AxisName, GridValue};

/// One combination of values.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Point<'g> {
    pub values: Vec<(AxisName, &'g GridValue)>,
}

impl fmt::Display for Point<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let each: Vec<String> =
            self.values.iter().map(|(name, value)| format!("{}={}", in_files(*name), value.label)).collect();
        f.write_str(&each.join(" "))
    }
}

impl Point<'_> {
    /// The point in a file's name.
    pub(super) fn file_part(&self) -> String {
        let each = self.values.iter().map(|(name, value)| format!("{}-{}", in_files(*name), value.label));
        each.collect::<Vec<_>>().join("_")
    }

    /// The value of an axis.
    pub(super) fn number(&self, wanted: AxisName) -> Option<f64> {
        self.values.iter().find(|(name, _)| *name == wanted).map(|(_, value)| value.number)
    }
}

/// The axis in notes and in names of files, as those that people have already say it.
fn in_files(name: AxisName) -> &'static str {
    match name {
        AxisName::TargetMass => "target-mass",
        other => other.as_str(),
    }
}

/// Point `index` of all, the last axis fastest.
pub(super) fn point(axes: &[Axis], index: usize) -> Point<'_> {
    let mut rest = index;
    let mut values = Vec::with_capacity(axes.len());
    for axis in axes.iter().rev() {
        let count = axis.values.len().max(1);
        if let Some(value) = axis.values.get(rest % count) {
            values.push((axis.name, value));
        }
        rest /= count;
    }
    values.reverse();
    Point { values }
}

/// Points along one axis, the others at their first value: each with the number of this axis.
pub(super) fn along(axes: &[Axis], name: AxisName) -> Vec<(usize, f64)> {
    let mut stride = 1_usize;
    for axis in axes.iter().rev() {
        if axis.name == name {
            let numbers = axis.values.iter().enumerate();
            return numbers.map(|(place, value)| (place.saturating_mul(stride), value.number)).collect();
        }
        stride = stride.saturating_mul(axis.values.len().max(1));
    }
    Vec::new()
}

/// Points at the ends of every axis, the others at their first value: where one value makes no sense, one of these does
/// not, because what a value may be is an interval.
pub(super) fn ends(axes: &[Axis]) -> Vec<usize> {
    let mut indices = Vec::new();
    let mut stride = 1_usize;
    for axis in axes.iter().rev() {
        let numbers = || axis.values.iter().map(|value| value.number).enumerate();
        let least = numbers().min_by(|a, b| a.1.total_cmp(&b.1));
        let most = numbers().max_by(|a, b| a.1.total_cmp(&b.1));
        let ends = [least, most].into_iter().flatten();
        indices.extend(ends.map(|(place, _)| place.saturating_mul(stride)));
        stride = stride.saturating_mul(axis.values.len().max(1));
    }
    indices.sort_unstable();
    indices.dedup();
    indices
}

#[cfg(test)]
mod tests {
    use super::*;

    fn axis(text: &str) -> Axis {
        text.parse().unwrap()
    }

    #[test]
    fn the_ends_of_every_axis_are_among_its_points() {
        let axes = [axis("stiffness=3,1,2"), axis("dissipation=0.5,4,1")];
        let ends: Vec<String> =
            ends(&axes).into_iter().map(|index| point(&axes, index).to_string()).collect();
        for wanted in ["stiffness=1", "stiffness=3", "dissipation=0.5", "dissipation=4"] {
            assert!(ends.iter().any(|point| point.contains(wanted)), "{wanted}: {ends:?}");
        }
    }

    #[test]
    fn points_along_an_axis_have_each_of_its_numbers() {
        let axes = [axis("target_mass=3,1,2"), axis("dissipation=0.5,4")];
        let name = axes[0].name;
        let points: Vec<String> =
            along(&axes, name).into_iter().map(|(index, _)| point(&axes, index).to_string()).collect();
        assert_eq!(
            points,
            [
                "target-mass=3 dissipation=0.5",
                "target-mass=1 dissipation=0.5",
                "target-mass=2 dissipation=0.5"
            ]
        );
    }

    #[test]
    fn a_grid_is_every_combination() {
        let axes = [axis("stiffness=x0.1,x1"), axis("dissipation=0.5,1,2")];
        let names: Vec<String> = (0..6).map(|index| point(&axes, index).file_part()).collect();
        assert_eq!(names[0], "stiffness-x0.1_dissipation-0.5");
        assert_eq!(names[5], "stiffness-x1_dissipation-2");
        assert_eq!(point(&axes, 1).to_string(), "stiffness=x0.1 dissipation=1");
    }
}
