//! The part of a sweep that one call makes: all of it, one point, or a share of the points.

use std::iter::StepBy;
use std::ops::Range;

use osim_model::messages::{Input, phrase};
use osim_requests::{RequestFault, SweepRequest};

/// A number from 1 to `count`, with zeros before it, so that names sort as the numbers do.
pub(super) fn padded(number: usize, count: usize) -> String {
    format!("{number:0width$}", width = count.to_string().len())
}

/// Which of `count` variants a call makes, counted from 0.
pub(super) fn of(request: &SweepRequest, count: usize) -> StepBy<Range<usize>> {
    match (request.point, request.shard) {
        (Some(point), _) => (point.saturating_sub(1)..point.min(count)).step_by(1),
        (None, Some(shard)) => shard.of(count),
        (None, None) => (0..count).step_by(1),
    }
}

/// Refuses a point that is not there.
///
/// # Errors
/// Which there are.
pub(super) fn check(request: &SweepRequest, count: usize) -> Result<(), RequestFault> {
    let Some(point) = request.point.filter(|point| !(1..=count).contains(point)) else { return Ok(()) };
    let points = if request.ladder.is_some() { "steps of the ladder" } else { "points of the grid" };
    let message = phrase![Input::Point, format!(" {point}: the {points} are counted from 1 to {count}")];
    Err(RequestFault::refused(Input::Point, message))
}

/// What the name of the table of a part has before its end; `None` if all is made.
pub(super) fn of_name(request: &SweepRequest) -> Option<String> {
    // Without zeros before it, as the job of an array knows its own number.
    let point = request.point.map(|point| format!("{POINT}{point}"));
    point.or_else(|| request.shard.map(osim_requests::Shard::file_part))
}

const POINT: &str = "point-";
const SHARD: &str = "shard-";

/// Whether the table of some part has this in its name.
pub(super) fn is_of_name(text: &str) -> bool {
    let numbers = |text: &str| text.bytes().all(|byte| byte.is_ascii_digit()) && !text.is_empty();
    let is_point = text.strip_prefix(POINT).is_some_and(numbers);
    let share = text.strip_prefix(SHARD).and_then(|share| share.split_once("-of-"));
    is_point || share.is_some_and(|(index, count)| numbers(index) && numbers(count))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn request(point: Option<usize>, shard: Option<&str>) -> SweepRequest {
        SweepRequest { point, shard: shard.map(|text| text.parse().unwrap()), ..SweepRequest::default() }
    }

    #[test]
    fn parts_together_are_the_whole() {
        let of = |point, shard| of(&request(point, shard), 5).collect::<Vec<_>>();
        assert_eq!(of(None, None), [0, 1, 2, 3, 4]);
        assert_eq!((1..=5).flat_map(|point| of(Some(point), None)).collect::<Vec<_>>(), [0, 1, 2, 3, 4]);
        assert_eq!([of(None, Some("1/2")), of(None, Some("2/2"))].concat(), [0, 2, 4, 1, 3]);
    }

    #[test]
    fn points_are_counted_from_1() {
        for (point, is_there) in [(0, false), (1, true), (5, true), (6, false)] {
            assert_eq!(check(&request(Some(point), None), 5).is_ok(), is_there, "{point}");
        }
    }

    #[test]
    fn the_table_of_a_part_is_known_by_its_name() {
        for (point, shard, expected) in
            [(Some(7), None, Some("point-7")), (None, Some("2/8"), Some("shard-2-of-8")), (None, None, None)]
        {
            let name = of_name(&request(point, shard));
            assert_eq!(name.as_deref(), expected);
            assert!(name.is_none_or(|name| is_of_name(&name)));
        }
        for other in ["", "point-", "point-x", "shard-1", "shard-1-of-", "shard-of-2", "notes"] {
            assert!(!is_of_name(other), "{other}");
        }
    }
}
