//! Elements of a scene.

use crate::{PlotError, Point};

/// The state that an element shows, in a scene that compares two states of the same objects.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum State {
    /// The present state, or the only one: drawn in colour, with its name.
    Now,
    /// The earlier state: drawn as a dashed line below the present one.
    Before,
}

/// A closed outline, such as that of a bone, with a light shade inside.
#[derive(Debug, Clone, PartialEq)]
pub struct Outline {
    /// Corners of the outline in order, in the units of the axes.
    pub points: Vec<Point>,
    /// The state that the outline shows.
    pub state: State,
}

/// A circle, such as a contact sphere, drawn to scale.
#[derive(Debug, Clone, PartialEq)]
pub struct Ball {
    /// Text at the circle; an empty text is not drawn.
    pub name: String,
    /// Centre of the circle, in the units of the axes.
    pub centre: Point,
    /// Radius of the circle, in the units of the axes.
    pub radius: f64,
    /// The state that the circle shows.
    pub state: State,
    /// Whether the circle is far from the outlines to which it belongs; it is then drawn in a conspicuous colour.
    pub misplaced: bool,
}

/// A marked point with its name.
#[derive(Debug, Clone, PartialEq)]
pub struct Spot {
    /// Text at the point; an empty text is not drawn.
    pub name: String,
    /// Place of the point, in the units of the axes.
    pub at: Point,
    /// The state that the point shows.
    pub state: State,
}

/// The meaning of a level line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LevelKind {
    /// The ground: a line with short strokes below it.
    Ground,
    /// The lowest point of the objects: a dashed line.
    Lowest,
}

/// A horizontal line through a view.
#[derive(Debug, Clone, PartialEq)]
pub struct Level {
    /// Text at the end of the level line; an empty text is not drawn.
    pub name: String,
    /// Position of the level line on the vertical axis, in its units.
    pub at: f64,
    /// Meaning of the level line.
    pub kind: LevelKind,
}

/// A view of an object from one side.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct View {
    /// The direction from which the view is seen.
    pub title: String,
    /// Text along the horizontal axis, with its unit.
    pub x_label: String,
    /// Text along the vertical axis, with its unit.
    pub y_label: String,
    /// Whether values on the vertical axis grow downwards.
    pub y_down: bool,
    /// Outlines of the view, below everything else.
    pub outlines: Vec<Outline>,
    /// Circles of the view.
    pub balls: Vec<Ball>,
    /// Points of the view.
    pub spots: Vec<Spot>,
    /// Horizontal lines of the view.
    pub levels: Vec<Level>,
}

/// All views of one object, one below the other, with a common horizontal axis.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Block {
    /// Title of the block.
    pub title: String,
    /// Remarks below the views, a paragraph each.
    pub remarks: Vec<String>,
    /// Views of the block.
    pub views: Vec<View>,
}

/// Names for the legend of a scene.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct SceneNames {
    /// Name of circles of the present state.
    pub now: String,
    /// Name of circles of the earlier state.
    pub before: String,
    /// Name of circles that are far from their outlines.
    pub misplaced: String,
    /// The name that the legend gives to points.
    pub spot: String,
    /// The name that the legend gives to outlines.
    pub outline: String,
    /// Name of the line of the ground.
    pub ground: String,
    /// Name of the line at the lowest point.
    pub lowest: String,
}

/// A figure of objects in space, seen from several sides.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Scene {
    /// Title of the scene.
    pub title: String,
    /// Description of the scene in full sentences.
    pub description: String,
    /// The objects of the scene, arranged in pairs side by side.
    pub blocks: Vec<Block>,
    /// Names in the legend; an empty name has no entry.
    pub names: SceneNames,
}

impl Scene {
    /// Refuses a scene without content, or with numbers that are not finite.
    pub(super) fn check(&self) -> Result<(), PlotError> {
        if self.blocks.is_empty() || self.blocks.iter().any(|block| block.views.is_empty()) {
            return Err(PlotError::Empty("the figure has no view"));
        }
        self.blocks.iter().flat_map(|block| &block.views).try_for_each(View::check)
    }
}

impl View {
    fn check(&self) -> Result<(), PlotError> {
        let finite = |(x, y): Point| x.is_finite() && y.is_finite();
        let wrong_ball = self.balls.iter().find(|ball| !finite(ball.centre) || !ball.radius.is_finite());
        let wrong_spot = self.spots.iter().find(|spot| !finite(spot.at));
        let named = wrong_ball.map(|ball| &ball.name).or(wrong_spot.map(|spot| &spot.name));
        let outlines = self.outlines.iter().flat_map(|outline| &outline.points).all(|point| finite(*point));
        let of_view = !outlines || self.levels.iter().any(|level| !level.at.is_finite());
        let wrong = named.or(of_view.then_some(&self.title));
        wrong.map_or(Ok(()), |name| Err(PlotError::NotFinite(name.clone())))
    }

    /// Corners of boxes around all elements of the view.
    pub(super) fn corners(&self) -> impl Iterator<Item = Point> + '_ {
        let balls = self.balls.iter().flat_map(|ball| {
            let ((x, y), r) = (ball.centre, ball.radius);
            [(x - r, y - r), (x + r, y + r)]
        });
        let outlines = self.outlines.iter().flat_map(|outline| outline.points.iter().copied());
        balls.chain(outlines).chain(self.spots.iter().map(|spot| spot.at))
    }
}
