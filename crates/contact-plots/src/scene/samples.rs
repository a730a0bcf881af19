//! What the legend shows of a scene, before the names.

use plotters::element::Rectangle;
use plotters::style::Color;

use super::data::LevelKind;
use super::marks::{BONE, BONE_OPACITY, circle, draw, level, place, ring, spot};
use crate::document::Area;
use crate::error::PlotError;
use crate::legend::SAMPLE_PT;
use crate::style::stroke;

const RADIUS_PT: f64 = 3.6;

/// A kind of mark.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum SceneSample {
    Ball,
    BallBefore,
    Astray,
    Spot,
    Bone,
    Lowest,
    Ground,
}

/// One sample, with its left end and its middle on the page.
pub(super) fn sample(root: &Area<'_>, sample: SceneSample, left: f64, middle: f64) -> Result<(), PlotError> {
    let centre = (left + SAMPLE_PT / 2.0, middle);
    let ends = (left, left + SAMPLE_PT);
    match sample {
        SceneSample::Ball => circle(root, centre, RADIUS_PT, false),
        SceneSample::Astray => circle(root, centre, RADIUS_PT, true),
        SceneSample::BallBefore => draw(root, &ring(centre, RADIUS_PT)),
        SceneSample::Spot => spot(root, centre, 2.2),
        SceneSample::Lowest => level(root, ends, middle, LevelKind::Lowest),
        SceneSample::Ground => level(root, ends, middle - 1.5, LevelKind::Ground),
        SceneSample::Bone => {
            let corners = [place((left, middle - 3.0)), place((left + SAMPLE_PT, middle + 3.0))];
            draw(root, &Rectangle::new(corners, BONE.mix(BONE_OPACITY).filled()))?;
            draw(root, &Rectangle::new(corners, stroke(BONE, 0.6)))
        }
    }
}
