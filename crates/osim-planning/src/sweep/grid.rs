//! The points of a sweep's grid, and the choice of the points that one call makes.

use std::iter::StepBy;
use std::ops::Range;

use osim_model::messages::{Input, phrase};
use osim_requests::{Axis, AxisName, GridValue, RequestFault, SweepRequest};

/// A point of a sweep's grid: one value on each axis.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct GridPoint<'g> {
    pub values: Vec<(AxisName, &'g GridValue)>,
}

impl GridPoint<'_> {
    /// The names of the axes, as in notes and in names of files, and their values, with `equals` between name and value.
    pub(super) fn joined(&self, equals: &str, separator: &str) -> String {
        let one = |(name, value): &(AxisName, &GridValue)| {
            let name = if *name == AxisName::TargetMass { "target-mass" } else { name.as_str() };
            [name, &value.label].join(equals)
        };
        self.values.iter().map(one).collect::<Vec<String>>().join(separator)
    }

    pub(super) fn value_of_axis(&self, wanted: AxisName) -> Option<f64> {
        self.values.iter().find(|(name, _)| *name == wanted).map(|(_, value)| value.number)
    }
}

/// The point with this index, counted from 0; the last axis changes fastest.
pub(super) fn point_at(axes: &[Axis], index: usize) -> GridPoint<'_> {
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
    GridPoint { values }
}

/// Index and value of each point along the axis `name`, with all other axes at their first value.
pub(super) fn points_along(axes: &[Axis], name: AxisName) -> Vec<(usize, f64)> {
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

/// Indices of the points with the least and the largest value of each axis, with all other axes at their first value. If any value is
/// outside its domain, which is an interval, one of these points is outside its domain.
pub(super) fn points_at_ends(axes: &[Axis]) -> Vec<usize> {
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

/// A number from 1 to `count`, with zeros before it, so that names of files sort in the order of the numbers.
pub(super) fn zero_padded(number: usize, count: usize) -> String {
    format!("{number:0width$}", width = count.to_string().len())
}

/// Indices of the variants that a call makes: all `count` variants, one point, or a shard.
pub(super) fn indices_of_call(request: &SweepRequest, count: usize) -> StepBy<Range<usize>> {
    match (request.point, request.shard) {
        (Some(point), _) => (point.saturating_sub(1)..point.min(count)).step_by(1),
        (None, Some(shard)) => shard.of(count),
        (None, None) => (0..count).step_by(1),
    }
}

/// Refuses the number of a point that the grid does not have.
///
/// # Errors
/// The message has the range of the numbers.
pub(super) fn check_point_exists(request: &SweepRequest, count: usize) -> Result<(), RequestFault> {
    let Some(point) = request.point.filter(|point| !(1..=count).contains(point)) else { return Ok(()) };
    let points = if request.ladder.is_some() { "steps of the ladder" } else { "points of the grid" };
    let message = phrase![Input::Point, format!(" {point}: the {points} are counted from 1 to {count}")];
    Err(RequestFault::refused(Input::Point, message))
}

/// The end of the name of a table with one point or one shard, such as `shard-1-of-4`; `None` if the call makes all variants.
pub(super) fn part_name(request: &SweepRequest) -> Option<String> {
    // Without zeros before it, because an array job has its number in this form.
    let point = request.point.map(|point| format!("{POINT_PREFIX}{point}"));
    point.or_else(|| request.shard.map(osim_requests::Shard::file_part))
}

/// The beginning of the name of a part with one point.
const POINT_PREFIX: &str = "point-";
/// The beginning of the name of a part with a shard.
const SHARD_PREFIX: &str = "shard-";

/// Whether `text` has the form of a name that [`part_name`] returns.
pub(super) fn is_part_name(text: &str) -> bool {
    let numbers = |text: &str| text.bytes().all(|byte| byte.is_ascii_digit()) && !text.is_empty();
    let is_point = text.strip_prefix(POINT_PREFIX).is_some_and(numbers);
    let share = text.strip_prefix(SHARD_PREFIX).and_then(|share| share.split_once("-of-"));
    is_point || share.is_some_and(|(index, count)| numbers(index) && numbers(count))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parsed_axis(text: &str) -> Axis {
        text.parse().unwrap()
    }

    #[test]
    fn the_ends_of_every_axis_are_among_its_points() {
        let axes = [parsed_axis("stiffness=3,1,2"), parsed_axis("dissipation=0.5,4,1")];
        let ends: Vec<String> =
            points_at_ends(&axes).into_iter().map(|index| point_at(&axes, index).joined("=", " ")).collect();
        for wanted in ["stiffness=1", "stiffness=3", "dissipation=0.5", "dissipation=4"] {
            assert!(ends.iter().any(|point| point.contains(wanted)), "{wanted}: {ends:?}");
        }
    }

    #[test]
    fn points_along_an_axis_have_each_of_its_numbers() {
        let axes = [parsed_axis("target_mass=3,1,2"), parsed_axis("dissipation=0.5,4")];
        let name = axes[0].name;
        let points: Vec<String> = points_along(&axes, name)
            .into_iter()
            .map(|(index, _)| point_at(&axes, index).joined("=", " "))
            .collect();
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
    fn a_grid_has_every_combination_of_its_values() {
        let axes = [parsed_axis("stiffness=x0.1,x1"), parsed_axis("dissipation=0.5,1,2")];
        let names: Vec<String> = (0..6).map(|index| point_at(&axes, index).joined("-", "_")).collect();
        assert_eq!(names[0], "stiffness-x0.1_dissipation-0.5");
        assert_eq!(names[5], "stiffness-x1_dissipation-2");
        assert_eq!(point_at(&axes, 1).joined("=", " "), "stiffness=x0.1 dissipation=1");
    }

    fn sweep_request(point: Option<usize>, shard: Option<&str>) -> SweepRequest {
        SweepRequest { point, shard: shard.map(|text| text.parse().unwrap()), ..SweepRequest::default() }
    }

    #[test]
    fn parts_of_a_sweep_together_make_every_variant() {
        let of = |point, shard| indices_of_call(&sweep_request(point, shard), 5).collect::<Vec<_>>();
        assert_eq!(of(None, None), [0, 1, 2, 3, 4]);
        assert_eq!((1..=5).flat_map(|point| of(Some(point), None)).collect::<Vec<_>>(), [0, 1, 2, 3, 4]);
        assert_eq!([of(None, Some("1/2")), of(None, Some("2/2"))].concat(), [0, 2, 4, 1, 3]);
    }

    #[test]
    fn points_are_counted_from_1() {
        for (point, is_there) in [(0, false), (1, true), (5, true), (6, false)] {
            assert_eq!(check_point_exists(&sweep_request(Some(point), None), 5).is_ok(), is_there, "{point}");
        }
    }

    #[test]
    fn the_table_of_a_part_is_known_by_its_name() {
        for (point, shard, expected) in
            [(Some(7), None, Some("point-7")), (None, Some("2/8"), Some("shard-2-of-8")), (None, None, None)]
        {
            let name = part_name(&sweep_request(point, shard));
            assert_eq!(name.as_deref(), expected);
            assert!(name.is_none_or(|name| is_part_name(&name)));
        }
        for other in ["", "point-", "point-x", "shard-1", "shard-1-of-", "shard-of-2", "notes"] {
            assert!(!is_part_name(other), "{other}");
        }
    }
}
