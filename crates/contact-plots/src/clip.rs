//! What of a line or an area is inside of a panel.

use line_clipping::cohen_sutherland::clip_line;
use line_clipping::sutherland_hodgman::clip_polygon;
use line_clipping::{LineSegment, Polygon, Window};

use crate::figure::Point;

type Span = (f64, f64);

fn window((left, right): Span, (low, high): Span) -> Window {
    Window::new(left, right, low, high)
}

fn corner((x, y): Point) -> line_clipping::Point {
    line_clipping::Point::new(x, y)
}

/// The parts of a line of many points that are inside.
pub(crate) fn line(points: &[Point], x: Span, y: Span) -> Vec<Vec<Point>> {
    let window = window(x, y);
    let mut parts: Vec<Vec<Point>> = Vec::new();
    for pair in points.windows(2) {
        let Some(inside) = clip_line(LineSegment::new(corner(pair[0]), corner(pair[1])), window) else {
            continue;
        };
        let (from, to) = ((inside.p1.x, inside.p1.y), (inside.p2.x, inside.p2.y));
        // Outside, it may still touch the edge.
        if from == to {
            continue;
        }
        match parts.last_mut() {
            Some(part) if part.last() == Some(&from) => part.push(to),
            _ => parts.push(vec![from, to]),
        }
    }
    parts
}

/// The part of an area that is inside; `None` where nothing is.
pub(crate) fn area(corners: &[Point], x: Span, y: Span) -> Option<Vec<Point>> {
    let corners: Vec<line_clipping::Point> = corners.iter().copied().map(corner).collect();
    if corners.len() < 3 {
        return None;
    }
    let inside = clip_polygon(&Polygon::new(&corners), window(x, y));
    let inside: Vec<Point> = inside.vertices.iter().map(|corner| (corner.x, corner.y)).collect();
    (inside.len() > 2).then_some(inside)
}

#[cfg(test)]
mod tests {
    use super::*;

    const UNIT: Span = (0.0, 1.0);

    #[test]
    fn a_line_within_stays_as_it_is() {
        let points = [(0.0, 0.0), (0.3, 1.0), (1.0, 0.5)];
        assert_eq!(line(&points, UNIT, UNIT), [points.to_vec()]);
    }

    #[test]
    fn a_line_that_leaves_and_comes_back_is_two() {
        let points = [(0.0, 0.5), (0.5, 1.5), (1.0, 0.5)];
        assert_eq!(line(&points, UNIT, UNIT), [[(0.0, 0.5), (0.25, 1.0)], [(0.75, 1.0), (1.0, 0.5)]]);
        assert!(line(&[(2.0, 2.0), (3.0, 2.0)], UNIT, UNIT).is_empty());
    }

    #[test]
    fn an_area_ends_at_the_edges() {
        let square = [(0.5, 0.5), (2.0, 0.5), (2.0, 2.0), (0.5, 2.0)];
        let mut inside = area(&square, UNIT, UNIT).unwrap_or_default();
        inside.sort_by(|a, b| a.partial_cmp(b).unwrap_or(std::cmp::Ordering::Equal));
        assert_eq!(inside, [(0.5, 0.5), (0.5, 1.0), (1.0, 0.5), (1.0, 1.0)]);
        assert!(area(&[(2.0, 2.0), (3.0, 2.0), (3.0, 3.0)], UNIT, UNIT).is_none());
    }
}
