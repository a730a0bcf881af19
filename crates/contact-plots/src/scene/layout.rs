//! The layout of a scene: one scale for all objects, views below each other, and names beside their elements.

use super::elements::{Block, LevelKind, Scene, View};
use super::labels::{NameToPlace, Obstacles, Rect, place_names};
use crate::axis::Ticks;
use crate::document::{MARGIN_PT, Paper, Title, text_allowed_in_xml};
use crate::figure::{Point, Width};
use crate::legend::Legend;
use crate::panels_svg::{AXIS_NAME_DISTANCE_PT, TICK_LABELS_HEIGHT_PT, TICK_LENGTH_PT};
use crate::style::{TEXT_PT, float};
use crate::text_width::{cut_to_width, lines, width_pt};

/// Distance between two lines of text, pt.
pub(super) const LINE_PT: f64 = 8.6;
/// Distance between two blocks of views, pt.
const BLOCK_GAP_PT: f64 = 10.0;
/// Height of the row with the title of a block, pt.
const BLOCK_TITLE_PT: f64 = 13.0;
/// Room on the right for half of the last tick label, pt.
pub(super) const RIGHT_PT: f64 = 5.0;
/// The smallest width of a plot for blocks side by side, pt; narrower blocks are placed below each other.
const SIDE_BY_SIDE_PT: f64 = 90.0;
/// Distance between the elements and the edge of their view, pt.
const VIEW_PADDING_PT: f64 = 4.0;
/// Height of the box of a name, pt.
const NAME_HEIGHT_PT: f64 = 7.6;
/// The largest width of a name, as a share of the view's width.
const LONGEST_NAME: f64 = 0.45;
/// The largest width of a text at a level line, as a share of the view's width.
const LONGEST_LEVEL_NAME: f64 = 0.9;
/// Smallest visible size of an outline, as a share of its block: about 2 points.
const SMALLEST_VISIBLE_SHARE: f64 = 0.01;
/// The largest height of a view without its names, pt.
const GREATEST_VIEW_HEIGHT_PT: f64 = 260.0;
/// Largest ratio of sizes of two objects with the same scale; larger objects have a scale of their own.
const MOST_SCALE_RATIO: f64 = 4.0;
/// Largest number of names in a view that fits a column; a view with more names needs the width of a page.
const MOST_NAMES_IN_COLUMN: usize = 12;
/// If a view has more names than this, all names are left out, because nobody could read them.
const MOST_NAMES: usize = 80;
/// The width of an object whose points all have the same horizontal value, in the units of the axis.
const WIDTH_OF_ONE_VALUE: f64 = 1.0;

/// A name and its box on the page, in points.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct PlacedName {
    pub text: String,
    pub at: Point,
    pub place: Rect,
}

/// A view on the page: its place, and the values at its edges.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct PlacedView<'s> {
    pub view: &'s View,
    pub left: f64,
    pub top: f64,
    pub width: f64,
    pub height: f64,
    /// Scale: points on the page per unit of the axes.
    scale: f64,
    /// The value of the horizontal axis at the left edge.
    x_left: f64,
    /// Room for the tick labels and the label of the vertical axis, pt.
    pub beside: f64,
    /// Distance on the page of the value 0 from the top edge of the view, pt; 0 may be outside the view.
    zero: f64,
    /// The names of circles, points and level lines.
    pub names: Vec<PlacedName>,
    pub level_names: Vec<PlacedName>,
}

impl PlacedView<'_> {
    /// The place on the page, pt, of a point in the units of the axes.
    pub(super) fn at(&self, (x, y): Point) -> Point {
        (self.left + (x - self.x_left) * self.scale, self.top + self.zero + self.sign() * y * self.scale)
    }

    /// The length on the page, pt, of a length in the units of the axes.
    pub(super) fn length(&self, value: f64) -> f64 {
        value * self.scale
    }

    /// Whether values grow downwards on the page (1) or upwards (-1).
    fn sign(&self) -> f64 {
        if self.view.y_down { 1.0 } else { -1.0 }
    }

    pub(super) fn x_ticks(&self) -> Ticks {
        round_ticks((self.x_left, self.x_left + self.width / self.scale), self.width)
    }

    pub(super) fn y_ticks(&self) -> Ticks {
        let (a, b) =
            (self.sign() * -self.zero / self.scale, self.sign() * (self.height - self.zero) / self.scale);
        round_ticks((a.min(b), a.max(b)), self.height)
    }

    /// Moves all names to the right and down, in points.
    fn move_names(&mut self, to_right: f64, down: f64) {
        for name in self.names.iter_mut().chain(&mut self.level_names) {
            name.at = (name.at.0 + to_right, name.at.1 + down);
            let Rect { left: l, top: t, right: r, bottom: b } = name.place;
            name.place = Rect { left: l + to_right, top: t + down, right: r + to_right, bottom: b + down };
        }
    }

    /// Gives the view more room above and below, in points.
    fn add_room(&mut self, above: f64, below: f64) {
        self.move_names(0.0, above);
        self.zero += above;
        self.height += above + below;
    }
}

/// Ticks at round values with enough distance, without those outside the view.
fn round_ticks((low, high): (f64, f64), length_pt: f64) -> Ticks {
    let count = (2..9).rev().find(|&count| length_pt >= 22.0 * float(count)).unwrap_or(2);
    let mut ticks = Ticks::linear((low, high), count);
    ticks.marks.retain(|(at, _)| (low..=high).contains(at));
    ticks
}

/// A block of views with its place in the picture.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct PlacedBlock<'s> {
    pub title: String,
    pub left: f64,
    pub top: f64,
    pub views: Vec<PlacedView<'s>>,
    /// The remarks below the block, broken into lines.
    pub remarks: Vec<String>,
    pub remarks_top: f64,
}

/// A kind of element in the legend.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum SceneSample {
    Ball,
    BallBefore,
    Misplaced,
    Spot,
    Bone,
    Lowest,
    Ground,
}

/// Positions of all parts of a scene.
pub(super) struct SceneLayout<'s> {
    /// The default width of the scene.
    pub width: Width,
    pub title: Title,
    pub height_pt: f64,
    pub blocks: Vec<PlacedBlock<'s>>,
    pub legend: Legend<SceneSample>,
    pub legend_at: Point,
    /// Room for the tick labels and the labels of vertical axes, pt.
    pub beside: f64,
}

impl<'s> SceneLayout<'s> {
    /// Places the views of `scene` on the paper, and below them a legend with these `entries`: a sample and its name each.
    pub(super) fn of(scene: &'s Scene, paper: Paper, entries: Vec<(SceneSample, String)>) -> Self {
        let count_block_names = |block: &Block| block.views.iter().map(count_names).max().unwrap_or(0);
        let crowded = scene.blocks.iter().any(|block| count_block_names(block) > MOST_NAMES_IN_COLUMN);
        let page = if scene.blocks.len() > 1 || crowded { Width::Page } else { Width::Column };
        let width = paper.layout_pt(page);
        // Room for the widest tick label of vertical axes; the axes may become longer when names are placed.
        let corners = scene.blocks.iter().flat_map(|block| &block.views).flat_map(View::corners);
        let largest = corners.fold(100.0_f64, |most, (_, y)| most.max(y.abs()));
        let longest_tick = width_pt(&format!("-{:.0}", 1.3 * largest), TEXT_PT);
        let beside = AXIS_NAME_DISTANCE_PT + 3.0 * TICK_LENGTH_PT + longest_tick;
        let column =
            |columns: usize| (width - 2.0 * MARGIN_PT - BLOCK_GAP_PT * float(columns - 1)) / float(columns);
        let is_wide = column(2) - beside - RIGHT_PT >= SIDE_BY_SIDE_PT;
        let columns = if scene.blocks.len() > 1 && is_wide { 2 } else { 1 };
        let column = column(columns);
        let plot = column - beside - RIGHT_PT;
        let title = Title::new(&scene.title, width);
        let scales = block_scales(scene, plot);
        let mut blocks = Vec::new();
        let mut top = title.bottom_pt();
        let rows = scene.blocks.chunks(columns).zip(scales.chunks(columns));
        for (row, scales) in rows {
            let views: Vec<Vec<PlacedView<'s>>> = row
                .iter()
                .zip(scales)
                .map(|(block, &(scale, _))| {
                    block.views.iter().map(|view| place_view(view, block, scale, (plot, beside))).collect()
                })
                .collect();
            let mut bottom = top;
            for (index, ((block, views), &(_, other))) in
                row.iter().zip(align_axes(views)).zip(scales).enumerate()
            {
                let left = MARGIN_PT + float(index) * (column + BLOCK_GAP_PT);
                let mut remarks = block.remarks.clone();
                if count_block_names(block) > MOST_NAMES {
                    remarks.push(format!("Without names, as there are more than {MOST_NAMES}."));
                }
                remarks.extend(other.then(|| "Drawn smaller than the others.".to_owned()));
                let placed = stack_views(block, views, (left, beside, top), (&remarks, column));
                bottom = bottom.max(placed.remarks_top + LINE_PT * float(placed.remarks.len()));
                blocks.push(placed);
            }
            top = bottom + BLOCK_GAP_PT;
        }
        let legend = Legend::new(entries, width - 2.0 * MARGIN_PT - beside);
        let legend_top = top - BLOCK_GAP_PT;
        let height_pt = legend_top + legend.height_pt() + MARGIN_PT;
        let legend_at = (MARGIN_PT + beside, legend_top);
        Self { width: page, title, height_pt, blocks, legend, legend_at, beside }
    }
}

fn count_names(view: &View) -> usize {
    let balls = view.balls.iter().filter(|ball| !ball.name.is_empty()).count();
    balls + view.spots.iter().filter(|spot| !spot.name.is_empty()).count()
}

fn span_of_values(values: impl Iterator<Item = f64>) -> (f64, f64) {
    let (low, high) = values
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)));
    match high - low {
        width if width > 0.0 => (low, high),
        0.0 => (low - WIDTH_OF_ONE_VALUE / 2.0, high + WIDTH_OF_ONE_VALUE / 2.0),
        _ => (-WIDTH_OF_ONE_VALUE / 2.0, WIDTH_OF_ONE_VALUE / 2.0),
    }
}

fn x_span(block: &Block) -> (f64, f64) {
    span_of_values(block.views.iter().flat_map(View::corners).map(|(x, _)| x))
}

fn y_span(view: &View) -> (f64, f64) {
    span_of_values(view.corners().map(|(_, y)| y).chain(view.levels.iter().map(|level| level.at)))
}

/// Whether an outline of a block is large enough to be seen.
pub(super) fn has_outlines(block: &Block) -> bool {
    let size = |(low, high): (f64, f64)| high - low;
    let whole = block.views.iter().map(|view| size(y_span(view))).fold(size(x_span(block)), f64::max);
    let mut outlines = block.views.iter().flat_map(|view| &view.outlines);
    outlines.any(|outline| {
        let along = |axis: fn(&Point) -> f64| size(span_of_values(outline.points.iter().map(axis)));
        along(|point| point.0).max(along(|point| point.1)) >= SMALLEST_VISIBLE_SHARE * whole
    })
}

/// The scale of each block, and whether it is smaller than the scale of other blocks. Objects of similar size share one scale.
fn block_scales(scene: &Scene, plot: f64) -> Vec<(f64, bool)> {
    let scale_alone = |block: &Block| {
        let (low, high) = x_span(block);
        let highest = block.views.iter().map(y_span).map(|(low, high)| high - low).fold(0.0, f64::max);
        ((plot - 2.0 * VIEW_PADDING_PT) / (high - low)).min(GREATEST_VIEW_HEIGHT_PT / highest)
    };
    let alone: Vec<f64> = scene.blocks.iter().map(scale_alone).collect();
    let largest = alone.iter().copied().fold(0.0, f64::max);
    let alike = |scale: &f64| *scale * MOST_SCALE_RATIO >= largest;
    let common = alone.iter().copied().filter(|scale| alike(scale)).fold(f64::INFINITY, f64::min);
    alone.iter().map(|scale| if alike(scale) { (common, false) } else { (*scale, true) }).collect()
}

/// A view placed at (0, 0), as high as its elements and names need.
fn place_view<'s>(view: &'s View, block: &Block, scale: f64, (width, beside): (f64, f64)) -> PlacedView<'s> {
    let (low, high) = x_span(block);
    let x_left = f64::midpoint(low, high) - width / scale / 2.0;
    let mut placed = PlacedView {
        view,
        left: 0.0,
        top: 0.0,
        width,
        height: 0.0,
        scale,
        x_left,
        beside,
        zero: 0.0,
        names: vec![],
        level_names: vec![],
    };
    placed.level_names = level_names(&placed);
    if count_names(view) <= MOST_NAMES {
        placed.names = placed_names(&placed);
    }
    let (from, to) = y_span(view);
    let ends = [placed.at((0.0, from)).1, placed.at((0.0, to)).1];
    let boxes = placed.names.iter().chain(&placed.level_names).map(|name| name.place);
    let (top, bottom) =
        span_of_values(ends.into_iter().chain(boxes.flat_map(|place| [place.top, place.bottom])));
    placed.add_room(VIEW_PADDING_PT - top, bottom + VIEW_PADDING_PT);
    placed
}

/// The texts at level lines: for the ground on the left, for the lowest point on the right, so that texts at close lines do not
/// touch.
fn level_names(placed: &PlacedView<'_>) -> Vec<PlacedName> {
    let mut names: Vec<PlacedName> = Vec::new();
    for level in placed.view.levels.iter().filter(|level| !level.name.is_empty()) {
        let text =
            cut_to_width(&text_allowed_in_xml(&level.name), TEXT_PT, LONGEST_LEVEL_NAME * placed.width);
        let width = width_pt(&text, TEXT_PT);
        let (_, y) = placed.at((0.0, level.at));
        let (left, top) = match level.kind {
            LevelKind::Ground => (2.0, y + 4.5),
            LevelKind::Lowest => {
                let crossed = placed.view.levels.iter().any(|other| {
                    let below = placed.at((0.0, other.at)).1 - y;
                    other.kind == LevelKind::Ground && (-3.0..NAME_HEIGHT_PT + 3.0).contains(&below)
                });
                let top = if crossed { y - 1.5 - NAME_HEIGHT_PT } else { y + 1.5 };
                (placed.width - width - 2.0, top)
            }
        };
        let place = Rect { left, right: left + width, top, bottom: top + NAME_HEIGHT_PT };
        names.push(PlacedName { text, at: (left, y), place });
    }
    names
}

fn placed_names(placed: &PlacedView<'_>) -> Vec<PlacedName> {
    let view = placed.view;
    let balls = view.balls.iter().map(|ball| (&ball.name, ball.centre));
    let spots = view.spots.iter().map(|spot| (&spot.name, spot.at));
    let wanted: Vec<(String, NameToPlace)> = balls
        .chain(spots)
        .filter(|(name, _)| !name.is_empty())
        .map(|(name, at)| {
            let text = cut_to_width(&text_allowed_in_xml(name), TEXT_PT, LONGEST_NAME * placed.width);
            let size = (width_pt(&text, TEXT_PT) + 1.0, NAME_HEIGHT_PT);
            (text, NameToPlace { at: placed.at(at), size })
        })
        .collect();
    let points = view.balls.iter().map(|ball| ball.centre).chain(view.spots.iter().map(|spot| spot.at));
    let obstacles = Obstacles {
        points: points.map(|point| placed.at(point)).collect(),
        circles: view.balls.iter().map(|ball| (placed.at(ball.centre), placed.length(ball.radius))).collect(),
        levels: view.levels.iter().map(|level| placed.at((0.0, level.at)).1).collect(),
        boxes: placed.level_names.iter().map(|name| name.place).collect(),
    };
    let boxes: Vec<NameToPlace> = wanted.iter().map(|(_, wanted)| wanted.clone()).collect();
    let places = place_names(&boxes, (0.0, placed.width), &obstacles);
    let named = wanted.into_iter().zip(places);
    named.map(|((text, wanted), place)| PlacedName { text, at: wanted.at, place }).collect()
}

/// Gives the views of one row the same height, and a common vertical axis if this needs little more room.
fn align_axes(mut row: Vec<Vec<PlacedView<'_>>>) -> Vec<Vec<PlacedView<'_>>> {
    let most = row.iter().map(Vec::len).max().unwrap_or(0);
    for index in 0..most {
        let views: Vec<&PlacedView<'_>> = row.iter().filter_map(|views| views.get(index)).collect();
        let highest = views.iter().map(|view| view.height).fold(0.0, f64::max);
        let above = views.iter().map(|view| view.zero).fold(f64::NEG_INFINITY, f64::max);
        let below = views.iter().map(|view| view.height - view.zero).fold(f64::NEG_INFINITY, f64::max);
        let same_scale = views.windows(2).all(|pair| pair[0].scale == pair[1].scale);
        let on_one_axis = same_scale && above + below <= 1.3 * highest;
        for view in row.iter_mut().filter_map(|views| views.get_mut(index)) {
            let room = if on_one_axis {
                (above - view.zero, below - (view.height - view.zero))
            } else {
                ((highest - view.height) / 2.0, (highest - view.height) / 2.0)
            };
            view.add_room(room.0, room.1);
        }
    }
    row
}

/// Places the views of a block below each other.
fn stack_views<'s>(
    block: &Block,
    views: Vec<PlacedView<'s>>,
    (left, beside, top): (f64, f64, f64),
    (remarks, column): (&[String], f64),
) -> PlacedBlock<'s> {
    let title = cut_to_width(&text_allowed_in_xml(&block.title), TEXT_PT, column - beside);
    let mut at = top + BLOCK_TITLE_PT;
    let last = views.len().saturating_sub(1);
    let mut placed = Vec::new();
    for (index, mut view) in views.into_iter().enumerate() {
        at += LINE_PT;
        (view.left, view.top) = (left + beside, at);
        view.move_names(view.left, view.top);
        // Only the last view has numbers below it: all share one horizontal axis.
        let below = if index == last { TICK_LABELS_HEIGHT_PT } else { TICK_LENGTH_PT + VIEW_PADDING_PT };
        at += view.height + below;
        placed.push(view);
    }
    let text = |remark: &String| lines(&text_allowed_in_xml(remark), TEXT_PT, column - beside);
    let remarks = remarks.iter().flat_map(text).collect();
    PlacedBlock { title, left: left + beside, top, views: placed, remarks, remarks_top: at }
}
