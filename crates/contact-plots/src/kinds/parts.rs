//! What several kinds of figures share.

use crate::error::PlotError;
use crate::figure::Point;
use crate::style::Look;

/// The points before contact, up to x = 0 itself.
pub(super) fn before(points: &[Point]) -> Vec<Point> {
    let mut part: Vec<Point> = points.iter().copied().take_while(|(x, _)| *x <= 0.0).collect();
    let next = points.get(part.len());
    if let (Some(&(x0, y0)), Some(&(x1, y1))) = (part.last(), next)
        && x0 < 0.0
    {
        part.push((0.0, y0 + (y1 - y0) * (0.0 - x0) / (x1 - x0)));
    }
    part
}

pub(super) fn names<'n>(names: impl Iterator<Item = &'n String>) -> String {
    names.map(String::as_str).collect::<Vec<_>>().join(", ")
}

pub(super) fn check_count(count: usize) -> Result<(), PlotError> {
    if count > Look::MOST_SERIES {
        return Err(PlotError::TooMany { count, most: Look::MOST_SERIES });
    }
    Ok(())
}
