//! A figure of any kind, and its numbers as rows of a table.

use crate::panels_svg::{figure, letter};
use crate::{Axis, Direction, Figure, HeatMap, Panel, Paper, PlotError, Scene, heat_map, scene};

/// A figure of any kind, before it is drawn.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Drawing {
    /// Curves in panels, each with a pair of axes.
    Panels(Figure),
    /// A quantity over two parameters, shown by colours.
    HeatMap(HeatMap),
    /// Circles, outlines and points in space, seen from several sides.
    Scene(Scene),
}

/// One number or place of a figure, as a row of a table. A column that does not apply is empty.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Datum {
    /// The panel's letter and title, or the title of the view.
    pub panel: String,
    /// The element of the figure to which the number belongs: `curve`, `point`, `limit`, `cell`, `outline`, `sphere`, or
    /// `level`.
    pub kind: &'static str,
    /// The name of the curve, limit, block or other element to which the number belongs.
    pub name: String,
    /// The quantity on the horizontal axis, with its unit.
    pub x_axis: String,
    /// The value on the horizontal axis, in the unit of `x_axis`.
    pub x: Option<f64>,
    /// The quantity on the vertical axis, with its unit.
    pub y_axis: String,
    /// The value on the vertical axis, in the unit of `y_axis`.
    pub y: Option<f64>,
    /// The name of a third quantity with its unit: the quantity of a heat map, or the radius of a sphere.
    pub value_name: String,
    /// The value of this third quantity; `None` if it is not known.
    pub value: Option<f64>,
}

impl Drawing {
    /// Title of the drawing.
    pub fn title(&self) -> &str {
        match self {
            Self::Panels(figure) => &figure.title,
            Self::HeatMap(map) => &map.title,
            Self::Scene(scene) => &scene.title,
        }
    }

    /// Draws the figure as an SVG document.
    ///
    /// # Errors
    /// [`PlotError`]: there is nothing to draw, a number is not finite, or the paper is too narrow.
    pub fn svg(&self, paper: Paper) -> Result<String, PlotError> {
        match self {
            Self::Panels(panels) => figure(panels, paper),
            Self::HeatMap(map) => heat_map(map, paper),
            Self::Scene(things) => scene(things, paper),
        }
    }

    /// The names of the figure's curves, in the order of the legend; equal names once.
    pub fn curves(&self) -> Vec<&str> {
        let Self::Panels(figure) = self else { return Vec::new() };
        let mut names: Vec<&str> = Vec::new();
        for curve in figure.panels.iter().flat_map(|panel| &panel.curves) {
            if !curve.label.is_empty() && !names.contains(&curve.label.as_str()) {
                names.push(&curve.label);
            }
        }
        names
    }

    /// Gives curves new names, in the order of the legend; further curves keep their names.
    ///
    /// # Errors
    /// [`PlotError::Names`]: there are more names than curves.
    pub fn rename(&mut self, names: &[String]) -> Result<(), PlotError> {
        let old: Vec<String> = self.curves().into_iter().map(str::to_owned).collect();
        if names.len() > old.len() {
            return Err(PlotError::Names { wanted: names.len(), curves: old });
        }
        if let Self::Panels(figure) = self {
            for curve in figure.panels.iter_mut().flat_map(|panel| &mut panel.curves) {
                let renamed = old.iter().zip(names).find(|(old, _)| **old == curve.label);
                if let Some((_, new)) = renamed {
                    curve.label.clone_from(new);
                }
            }
        }
        Ok(())
    }

    /// Limits the horizontal axis of all panels.
    ///
    /// # Errors
    /// [`PlotError::NoAxis`]: the panels have several horizontal axes, or the figure has no curves.
    pub fn limit_x(&mut self, limits: (f64, f64)) -> Result<(), PlotError> {
        self.limit(limits, "horizontal", |panel| &mut panel.x)
    }

    /// Limits the vertical axis of all panels.
    ///
    /// # Errors
    /// [`PlotError::NoAxis`]: the panels have several vertical axes, or the figure has no curves.
    pub fn limit_y(&mut self, limits: (f64, f64)) -> Result<(), PlotError> {
        self.limit(limits, "vertical", |panel| &mut panel.y)
    }

    /// Gives the axis that `axis` takes of each panel these limits; an error if the panels have axes of different quantities.
    fn limit(
        &mut self,
        limits: (f64, f64),
        which: &'static str,
        axis: impl Fn(&mut Panel) -> &mut Axis,
    ) -> Result<(), PlotError> {
        let Self::Panels(figure) = self else { return Err(PlotError::NoAxis { which, found: vec![] }) };
        let mut found: Vec<String> = Vec::new();
        for axis in figure.panels.iter_mut().map(&axis) {
            axis.limits = Some(limits);
            if !found.contains(&axis.label) {
                found.push(axis.label.clone());
            }
        }
        if found.len() == 1 { Ok(()) } else { Err(PlotError::NoAxis { which, found }) }
    }

    /// All numbers of the figure, in the order of drawing, also those outside the limits of an axis.
    pub fn data(&self) -> Vec<Datum> {
        match self {
            Self::Panels(figure) => data_of_panels(figure),
            Self::HeatMap(map) => data_of_cells(map),
            Self::Scene(scene) => data_of_scene(scene),
        }
    }
}

impl Datum {
    /// A row about the element `name` of a panel, without values yet.
    fn new(kind: &'static str, panel: &str, name: &str, (x_axis, y_axis): (&str, &str)) -> Self {
        Self {
            panel: panel.to_owned(),
            kind,
            name: name.to_owned(),
            x_axis: x_axis.to_owned(),
            x: None,
            y_axis: y_axis.to_owned(),
            y: None,
            value_name: String::new(),
            value: None,
        }
    }

    fn at_point(self, (x, y): (f64, f64)) -> Self {
        Self { x: Some(x), y: Some(y), ..self }
    }

    /// The row with a value, and the name of this value.
    fn with(self, value_name: &str, value: Option<f64>) -> Self {
        Self { value_name: value_name.to_owned(), value, ..self }
    }
}

fn data_of_panels(figure: &Figure) -> Vec<Datum> {
    let mut data = Vec::new();
    for (index, panel) in figure.panels.iter().enumerate() {
        let name = if figure.panels.len() > 1 {
            format!("{} {}", letter(index), panel.title).trim_end_matches(' ').to_owned()
        } else {
            panel.title.clone()
        };
        let row = |kind, label: &str| Datum::new(kind, &name, label, (&panel.x.label, &panel.y.label));
        for curve in &panel.curves {
            data.extend(curve.points.iter().map(|&point| row("curve", &curve.label).at_point(point)));
        }
        data.extend(panel.marks.iter().map(|mark| row("point", &mark.label).at_point(mark.at)));
        data.extend(panel.limits.iter().map(|limit| match limit.direction {
            Direction::Vertical => Datum { x: Some(limit.at), ..row("limit", &limit.label) },
            Direction::Horizontal => Datum { y: Some(limit.at), ..row("limit", &limit.label) },
        }));
    }
    data
}

fn data_of_cells(map: &HeatMap) -> Vec<Datum> {
    let row = |kind, label: &str| Datum::new(kind, "", label, (&map.x_axis.label, &map.y_axis.label));
    let mut data = Vec::new();
    for (values, &y) in map.values.iter().zip(&map.y) {
        for (value, &x) in values.iter().zip(&map.x) {
            data.push(row("cell", "").at_point((x, y)).with(&map.value_axis.label, *value));
        }
    }
    data.extend(map.mark.iter().map(|(label, at)| row("point", label).at_point(*at)));
    let limit = map.limit.iter();
    data.extend(limit.map(|limit| row("limit", &limit.label).with(&map.value_axis.label, Some(limit.at))));
    data
}

fn data_of_scene(scene: &Scene) -> Vec<Datum> {
    let mut data = Vec::new();
    for block in &scene.blocks {
        for view in &block.views {
            let panel = format!("{}, {}", block.title, view.title);
            let row = |kind, label: &str| Datum::new(kind, &panel, label, (&view.x_label, &view.y_label));
            for (index, outline) in view.outlines.iter().enumerate() {
                // Outlines have no names; their numbers keep their corners apart.
                let name = format!("outline {}", index + 1);
                data.extend(outline.points.iter().map(|&point| row("outline", &name).at_point(point)));
            }
            let radius = |label: &str| {
                label.rsplit_once('(').map_or("radius".to_owned(), |(_, unit)| format!("radius ({unit}"))
            };
            data.extend(view.balls.iter().map(|ball| {
                row("sphere", &ball.name)
                    .at_point(ball.centre)
                    .with(&radius(&view.x_label), Some(ball.radius))
            }));
            data.extend(view.spots.iter().map(|spot| row("point", &spot.name).at_point(spot.at)));
            let levels = view.levels.iter();
            data.extend(levels.map(|level| Datum { y: Some(level.at), ..row("level", &level.name) }));
        }
    }
    data
}
