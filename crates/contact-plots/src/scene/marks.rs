//! The marks of a scene, which its legend shows too.

use plotters::element::{Circle, DashedPathElement, PathElement, Polygon};
use plotters::style::{Color, RGBColor};

use super::data::LevelKind;
use crate::document::Area;
use crate::error::PlotError;
use crate::figure::Point;
use crate::style::{INK, LIMIT, Look, stroke, units};

/// Bones: a grey that both colours stand out from.
pub(super) const BONE: RGBColor = RGBColor(0x88, 0x88, 0x88);
pub(super) const BONE_OPACITY: f64 = 0.22;
pub(super) const NOW: Look = Look::HERTZ;
pub(super) const ASTRAY: RGBColor = RGBColor(0xD5, 0x5E, 0x00);
/// The line of what is astray: twice as wide as that of others.
const ASTRAY_PT: f64 = 2.2;
/// A ring of dashes has this many corners.
const CORNERS: u32 = 120;
pub(super) const BALL_OPACITY: f64 = 0.13;
/// A line of dashes on the page.
pub(super) type Dashes = DashedPathElement<std::vec::IntoIter<(i32, i32)>, i32>;
pub(super) const SPOT_PT: f64 = 1.7;

/// A circle with a light shade inside.
pub(super) fn circle(root: &Area<'_>, centre: Point, radius: f64, astray: bool) -> Result<(), PlotError> {
    let (colour, width) = if astray { (ASTRAY, ASTRAY_PT) } else { (rgb(NOW), NOW.width_pt) };
    let (at, radius) = (place(centre), units(radius));
    draw(root, &Circle::new(at, radius, colour.mix(BALL_OPACITY).filled()))?;
    draw(root, &Circle::new(at, radius, stroke(colour, width)))
}

/// A circle of dashes; the library's circles have none.
pub(super) fn ring((x, y): Point, radius: f64) -> Dashes {
    let corner = |index: u32| {
        let (sin, cos) = (std::f64::consts::TAU * f64::from(index) / f64::from(CORNERS)).sin_cos();
        place((x + radius * cos, y + radius * sin))
    };
    dashed((0..=CORNERS).map(corner).collect(), INK, 0.8)
}

pub(super) fn dashed(points: Vec<(i32, i32)>, colour: RGBColor, width_pt: f64) -> Dashes {
    DashedPathElement::new(points, units(2.4), units(1.8), stroke(colour, width_pt))
}

/// A square that stands on its corner, white inside.
pub(super) fn spot(root: &Area<'_>, (x, y): Point, size: f64) -> Result<(), PlotError> {
    let corners = [(x, y - size), (x + size, y), (x, y + size), (x - size, y), (x, y - size)].map(place);
    draw(root, &Polygon::new(corners.to_vec(), RGBColor(255, 255, 255).filled()))?;
    draw(root, &PathElement::new(corners.to_vec(), stroke(INK, 0.8)))
}

/// A horizontal line: dashed at the lowest place, with strokes below it for the ground.
pub(super) fn level(
    root: &Area<'_>,
    (left, right): (f64, f64),
    y: f64,
    kind: LevelKind,
) -> Result<(), PlotError> {
    let line = [place((left, y)), place((right, y))];
    if kind == LevelKind::Lowest {
        let dashes = DashedPathElement::new(line, units(2.0), units(1.6), stroke(LIMIT, 0.7));
        return draw(root, &dashes);
    }
    draw(root, &PathElement::new(line.to_vec(), stroke(INK, 1.0)))?;
    let mut x = left + 3.0;
    while x <= right {
        draw(root, &PathElement::new(vec![place((x, y)), place((x - 3.0, y + 3.0))], stroke(INK, 0.4)))?;
        x += 4.5;
    }
    Ok(())
}

pub(super) fn rgb(look: Look) -> RGBColor {
    RGBColor(look.colour.0, look.colour.1, look.colour.2)
}

pub(super) fn place((x, y): Point) -> (i32, i32) {
    (units(x), units(y))
}

pub(super) fn draw<E>(root: &Area<'_>, element: &E) -> Result<(), PlotError>
where
    for<'b> &'b E: plotters::element::PointCollection<'b, (i32, i32)>,
    E: for<'a> plotters::element::Drawable<plotters::prelude::SVGBackend<'a>>,
{
    root.draw(element).map_err(PlotError::drawing)
}
