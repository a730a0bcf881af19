//! Objects in space, seen from several sides: circles, points and outlines with names, with the same scale on all axes.

mod elements;
mod labels;
mod layout;

use plotters::element::{Circle, DashedPathElement, PathElement, Polygon, Rectangle};
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{Color, FontTransform, RGBColor};

use crate::document::{Area, MARGIN_PT, Paper, document, text_allowed_in_xml};
use crate::error::PlotError;
use crate::figure::Point;
use crate::legend::SAMPLE_PT;
use crate::panels_svg::TICK_LENGTH_PT;
use crate::style::{INK, LIMIT, Look, TEXT_PT, float, stroke, text, units};
pub use elements::{Ball, Block, Level, LevelKind, Outline, Scene, SceneNames, Spot, State, View};
use labels::LEADER_PT;
use layout::{
    LINE_PT, PlacedBlock, PlacedName, PlacedView, RIGHT_PT, SceneLayout, SceneSample, has_outlines,
};

/// Draws objects from several sides, as an SVG document. The scale is the same in all directions, so that circles stay circles.
///
/// # Errors
/// [`PlotError`]: nothing to draw, a point that is not a finite number, or too little room on the paper.
pub fn scene(scene: &Scene, paper: Paper) -> Result<String, PlotError> {
    scene.check()?;
    let layout = SceneLayout::of(scene, paper, legend_entries(scene));
    paper.check(layout.width, layout.beside + 2.0 * MARGIN_PT + RIGHT_PT)?;
    let texts: [&str; 2] = [&scene.title, &scene.description];
    document((paper, layout.width), layout.height_pt, &layout.title, texts, |root| {
        for block in &layout.blocks {
            draw_block(root, block)?;
        }
        layout.legend.draw(root, layout.legend_at, draw_sample)
    })
}

/// The legend entries, only for elements that the scene shows.
fn legend_entries(scene: &Scene) -> Vec<(SceneSample, String)> {
    let views = || scene.blocks.iter().flat_map(|block| &block.views);
    let balls = || views().flat_map(|view| &view.balls);
    let level = |kind| views().any(|view| view.levels.iter().any(|level| level.kind == kind));
    let names = &scene.names;
    let found = [
        (balls().any(|ball| ball.state == State::Now && !ball.misplaced), SceneSample::Ball, &names.now),
        (balls().any(|ball| ball.misplaced), SceneSample::Misplaced, &names.misplaced),
        (balls().any(|ball| ball.state == State::Before), SceneSample::BallBefore, &names.before),
        (views().any(|view| !view.spots.is_empty()), SceneSample::Spot, &names.spot),
        (scene.blocks.iter().any(has_outlines), SceneSample::Bone, &names.outline),
        (level(LevelKind::Lowest), SceneSample::Lowest, &names.lowest),
        (level(LevelKind::Ground), SceneSample::Ground, &names.ground),
    ];
    let there = found.into_iter().filter(|(there, _, name)| *there && !name.is_empty());
    there.map(|(_, sample, name)| (sample, name.clone())).collect()
}

fn draw_block(root: &Area<'_>, block: &PlacedBlock<'_>) -> Result<(), PlotError> {
    let words = |line: &str, at: Point| {
        let style = text(TEXT_PT).pos(Pos::new(HPos::Left, VPos::Top));
        root.draw_text(line, &style, (units(at.0), units(at.1))).map_err(PlotError::drawing)
    };
    words(&block.title, (block.left, block.top + 2.0))?;
    for (index, view) in block.views.iter().enumerate() {
        words(&text_allowed_in_xml(&view.view.title), (view.left, view.top - LINE_PT))?;
        draw_view(root, view, index + 1 == block.views.len())?;
    }
    for (index, line) in block.remarks.iter().enumerate() {
        words(line, (block.left, block.remarks_top + LINE_PT * float(index)))?;
    }
    Ok(())
}

fn draw_view(root: &Area<'_>, view: &PlacedView<'_>, is_last: bool) -> Result<(), PlotError> {
    draw_outlines(root, view)?;
    for level in &view.view.levels {
        draw_level(root, (view.left, view.left + view.width), view.at((0.0, level.at)).1, level.kind)?;
    }
    for ball in &view.view.balls {
        let (centre, radius) = (view.at(ball.centre), view.length(ball.radius));
        match ball.state {
            State::Now => draw_circle(root, centre, radius, ball.misplaced)?,
            State::Before => draw(root, &dashed_circle(centre, radius))?,
        }
    }
    draw_axes(root, view, is_last)?;
    for name in &view.names {
        draw_leader(root, name)?;
    }
    for ball in view.view.balls.iter().filter(|ball| ball.state == State::Now) {
        let colour = if ball.misplaced { MISPLACED_COLOUR } else { PRESENT_LOOK.rgb() };
        draw(root, &Circle::new(place(view.at(ball.centre)), units(0.9), colour.filled()))?;
    }
    for spot in &view.view.spots {
        let size = if spot.state == State::Now { SPOT_PT } else { 0.6 * SPOT_PT };
        draw_square(root, view.at(spot.at), size)?;
    }
    view.names.iter().chain(&view.level_names).try_for_each(|name| draw_name(root, name))
}

fn draw_outlines(root: &Area<'_>, view: &PlacedView<'_>) -> Result<(), PlotError> {
    for outline in &view.view.outlines {
        let mut points: Vec<(i32, i32)> = outline.points.iter().map(|&point| place(view.at(point))).collect();
        points.extend(points.first().copied());
        match outline.state {
            State::Now => {
                draw(root, &Polygon::new(points.clone(), BONE_COLOUR.mix(BONE_OPACITY).filled()))?;
                draw(root, &PathElement::new(points, stroke(BONE_COLOUR, 0.6)))?;
            }
            State::Before => draw(root, &dashed_line(points, BONE_COLOUR, 0.6))?,
        }
    }
    Ok(())
}

/// Draws the line from a name to its element, if they are apart.
fn draw_leader(root: &Area<'_>, name: &PlacedName) -> Result<(), PlotError> {
    let end = name.place.nearest(name.at);
    let (dx, dy) = (end.0 - name.at.0, end.1 - name.at.1);
    if dx * dx + dy * dy < LEADER_PT * LEADER_PT {
        return Ok(());
    }
    draw(root, &PathElement::new(vec![place(name.at), place(end)], stroke(INK, 0.4)))
}

fn draw_name(root: &Area<'_>, name: &PlacedName) -> Result<(), PlotError> {
    let at = &name.place;
    let corners = [place((at.left, at.top)), place((at.right, at.bottom))];
    draw(root, &Rectangle::new(corners, RGBColor(255, 255, 255).mix(0.65).filled()))?;
    let middle = (f64::midpoint(at.left, at.right), f64::midpoint(at.top, at.bottom));
    let style = text(TEXT_PT).pos(Pos::new(HPos::Center, VPos::Center));
    root.draw_text(&name.text, &style, place(middle)).map_err(PlotError::drawing)
}

fn draw_axes(root: &Area<'_>, view: &PlacedView<'_>, is_last: bool) -> Result<(), PlotError> {
    let (left, right) = (view.left, view.left + view.width);
    let (top, bottom) = (view.top, view.top + view.height);
    let line = stroke(INK, 0.6);
    draw(
        root,
        &PathElement::new(vec![place((left, top)), place((left, bottom)), place((right, bottom))], line),
    )?;
    let words = |line: &str, at: Point, style: Pos| {
        root.draw_text(line, &text(TEXT_PT).pos(style), place(at)).map_err(PlotError::drawing)
    };
    let ticks = view.x_ticks();
    for (value, label) in &ticks.marks {
        let (x, _) = view.at((*value, 0.0));
        draw(root, &PathElement::new(vec![place((x, bottom)), place((x, bottom + TICK_LENGTH_PT))], line))?;
        if is_last {
            words(label, (x, bottom + 2.0 * TICK_LENGTH_PT), Pos::new(HPos::Center, VPos::Top))?;
        }
    }
    let ticks = view.y_ticks();
    for (value, label) in &ticks.marks {
        let (_, y) = view.at((0.0, *value));
        draw(root, &PathElement::new(vec![place((left - TICK_LENGTH_PT, y)), place((left, y))], line))?;
        words(label, (left - 2.0 * TICK_LENGTH_PT, y), Pos::new(HPos::Right, VPos::Center))?;
    }
    if is_last {
        let middle = (f64::midpoint(left, right), bottom + 2.0 * TICK_LENGTH_PT + LINE_PT);
        words(&text_allowed_in_xml(&view.view.x_label), middle, Pos::new(HPos::Center, VPos::Top))?;
    }
    let style = text(TEXT_PT).transform(FontTransform::Rotate270).pos(Pos::new(HPos::Center, VPos::Top));
    root.draw_text(
        &text_allowed_in_xml(&view.view.y_label),
        &style,
        place((left - view.beside, f64::midpoint(top, bottom))),
    )
    .map_err(PlotError::drawing)
}

// What the legend shows of a scene, before the names.

/// Radius of a circle in the legend, pt.
const SAMPLE_CIRCLE_RADIUS_PT: f64 = 3.6;

/// Draws a sample of the legend; `left` is its left end and `middle` its vertical middle on the page, in points.
fn draw_sample(root: &Area<'_>, sample: SceneSample, left: f64, middle: f64) -> Result<(), PlotError> {
    let centre = (left + SAMPLE_PT / 2.0, middle);
    let ends = (left, left + SAMPLE_PT);
    match sample {
        SceneSample::Ball => draw_circle(root, centre, SAMPLE_CIRCLE_RADIUS_PT, false),
        SceneSample::Misplaced => draw_circle(root, centre, SAMPLE_CIRCLE_RADIUS_PT, true),
        SceneSample::BallBefore => draw(root, &dashed_circle(centre, SAMPLE_CIRCLE_RADIUS_PT)),
        SceneSample::Spot => draw_square(root, centre, 2.2),
        SceneSample::Lowest => draw_level(root, ends, middle, LevelKind::Lowest),
        SceneSample::Ground => draw_level(root, ends, middle - 1.5, LevelKind::Ground),
        SceneSample::Bone => {
            let corners = [place((left, middle - 3.0)), place((left + SAMPLE_PT, middle + 3.0))];
            draw(root, &Rectangle::new(corners, BONE_COLOUR.mix(BONE_OPACITY).filled()))?;
            draw(root, &Rectangle::new(corners, stroke(BONE_COLOUR, 0.6)))
        }
    }
}

// The marks of a scene, which its legend shows too.

/// The colour of bones: a grey on which the other colours are clearly visible.
const BONE_COLOUR: RGBColor = RGBColor(0x88, 0x88, 0x88);
/// Opacity of the shade inside a bone, from 0 to 1.
const BONE_OPACITY: f64 = 0.22;
/// The look of spheres in the present state.
const PRESENT_LOOK: Look = Look::HERTZ;
/// The colour of a sphere that is in a wrong place.
const MISPLACED_COLOUR: RGBColor = RGBColor(0xD5, 0x5E, 0x00);
/// Width of the line of a misplaced circle, pt: twice that of other circles.
const MISPLACED_LINE_PT: f64 = 2.2;
/// Number of corners of a dashed circle.
const RING_CORNERS: u32 = 120;
/// Opacity of the shade inside a circle, from 0 to 1.
const BALL_OPACITY: f64 = 0.13;
/// A dashed line on the page.
type Dashes = DashedPathElement<std::vec::IntoIter<(i32, i32)>, i32>;
/// Size of a marked point in the present state, pt.
const SPOT_PT: f64 = 1.7;

/// Draws a circle with a light shade inside.
fn draw_circle(root: &Area<'_>, centre: Point, radius: f64, misplaced: bool) -> Result<(), PlotError> {
    let (colour, width) = if misplaced {
        (MISPLACED_COLOUR, MISPLACED_LINE_PT)
    } else {
        (PRESENT_LOOK.rgb(), PRESENT_LOOK.width_pt)
    };
    let (at, radius) = (place(centre), units(radius));
    draw(root, &Circle::new(at, radius, colour.mix(BALL_OPACITY).filled()))?;
    draw(root, &Circle::new(at, radius, stroke(colour, width)))
}

/// A dashed circle; the library has only circles with solid lines.
fn dashed_circle((x, y): Point, radius: f64) -> Dashes {
    let corner = |index: u32| {
        let (sin, cos) = (std::f64::consts::TAU * f64::from(index) / f64::from(RING_CORNERS)).sin_cos();
        place((x + radius * cos, y + radius * sin))
    };
    dashed_line((0..=RING_CORNERS).map(corner).collect(), INK, 0.8)
}

fn dashed_line(points: Vec<(i32, i32)>, colour: RGBColor, width_pt: f64) -> Dashes {
    DashedPathElement::new(points, units(2.4), units(1.8), stroke(colour, width_pt))
}

/// Draws a square that stands on its corner, white inside.
fn draw_square(root: &Area<'_>, (x, y): Point, size: f64) -> Result<(), PlotError> {
    let corners = [(x, y - size), (x + size, y), (x, y + size), (x - size, y), (x, y - size)].map(place);
    draw(root, &Polygon::new(corners.to_vec(), RGBColor(255, 255, 255).filled()))?;
    draw(root, &PathElement::new(corners.to_vec(), stroke(INK, 0.8)))
}

/// Draws a horizontal line: dashed for the lowest point, with short strokes below it for the ground.
fn draw_level(root: &Area<'_>, (left, right): (f64, f64), y: f64, kind: LevelKind) -> Result<(), PlotError> {
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

fn place((x, y): Point) -> (i32, i32) {
    (units(x), units(y))
}

fn draw<E>(root: &Area<'_>, element: &E) -> Result<(), PlotError>
where
    for<'b> &'b E: plotters::element::PointCollection<'b, (i32, i32)>,
    E: for<'a> plotters::element::Drawable<plotters::prelude::SVGBackend<'a>>,
{
    root.draw(element).map_err(PlotError::drawing)
}
