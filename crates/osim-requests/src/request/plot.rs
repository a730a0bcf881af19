//! Requests for figures, and their style.

use std::path::PathBuf;

use osim_model::messages::{Input, Phrase, phrase};
use serde::{Deserialize, Serialize};

use crate::fault::{Relation, RequestFault};
use crate::options::{AnswerOptions, CountOptions, FallOptions, ForceOptions, MassOptions, SetFiles};
use crate::request::inspect::AngleChoice;
use crate::request::knowledge::no_fig1;
use crate::values::serial::{self, choices};
use crate::values::{Acceleration, Dpi, FigureWidth, FontSize, Grid, Kilograms, Span, path};

/// How a figure looks.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[serde(default)]
pub struct FigureOptions {
    pub title: Option<String>,
    #[serde(deserialize_with = "serial::from_texts")]
    pub label: Vec<String>,
    pub width: Option<FigureWidth>,
    pub font_size: FontSize,
    pub x_range: Option<Span>,
    pub y_range: Option<Span>,
    pub dpi: Dpi,
}

choices! {
    /// The quantity that the colours of a heat map show.
    QuantityChoice: Indentation {
        Indentation = "indentation", "Relative indentation at rest under body weight, by the Hertz law";
        Restitution = "restitution", "Coefficient of restitution at the impact speed of the fall, exact";
        PeakForce = "peak-force", "Peak force over body weight in the fall";
    }
}

/// The quantity of a heat map.
///
/// The enum is exhaustive, because each quantity needs a title and a scale in the code that draws it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum HeatQuantity {
    /// Relative indentation at equilibrium under body weight, by the Hertz law.
    Indentation,
    /// Coefficient of restitution at the impact speed of the fall, by the exact equation.
    Restitution,
    /// Peak force over body weight in the fall.
    PeakForce,
}

impl QuantityChoice {
    pub const fn quantity(self) -> HeatQuantity {
        match self {
            Self::Indentation => HeatQuantity::Indentation,
            Self::Restitution => HeatQuantity::Restitution,
            Self::PeakForce => HeatQuantity::PeakForce,
        }
    }
}

/// The grid of a heat map.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[serde(default)]
pub struct HeatOptions {
    pub quantity: QuantityChoice,
    pub stiffness: Grid,
    pub dissipation: Grid,
    #[serde(with = "path::Optional")]
    pub table: Option<PathBuf>,
    pub value_column: Option<String>,
    pub x_column: Option<String>,
    pub y_column: Option<String>,
    pub value_range: Option<Span>,
}

const STIFFNESS: Grid = Grid::factors(0.1, 10.0, 25);
const DISSIPATION: Grid = Grid::factors(0.1, 4.0, 25);

impl Default for HeatOptions {
    fn default() -> Self {
        Self {
            quantity: QuantityChoice::Indentation,
            stiffness: STIFFNESS,
            dissipation: DISSIPATION,
            table: None,
            value_column: None,
            x_column: None,
            y_column: None,
            value_range: None,
        }
    }
}

choices! {
    /// The kind of plot.
    PlotKind {
        Force = "force", "Force against indentation: Hertz, with cf, smoothed";
        State = "state", "Contact state against indentation";
        Loop = "loop", "Dissipation: force while a sphere goes in and out";
        Drop = "drop", "Drop test: force against time and non-dimensional time";
        Sweep = "sweep", "A quantity over stiffness and dissipation, as a heat map";
        Feet = "feet", "Feet from the side and from above: bones, joints, spheres to scale";
        Motion = "motion", "Along a recorded motion: force beside the plates', x/R of each sphere";
        Fig1 = "fig1", "The paper's Fig. 1: not drawn; the output says what it needs";
        Fig4 = "fig4", "The paper's Fig. 4";
        FigC5 = "fig-c5", "The paper's Fig. C.5";
    }
}

choices! {
    /// Units of indentation and force.
    AxesChoice {
        Dimensionless = "dimensionless", "x/R, and force over the sphere's share of the weight";
        Real = "real", "mm and N";
    }
}

/// Draws what contacts do.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[serde(default)]
pub struct PlotRequest {
    pub kind: Option<PlotKind>,
    #[serde(with = "path::List")]
    pub models: Vec<PathBuf>,
    #[serde(with = "path::Optional")]
    pub output: Option<PathBuf>,
    #[serde(with = "path::Optional")]
    pub data: Option<PathBuf>,
    pub force: bool,
    pub target_mass: Option<Kilograms>,
    pub axes: Option<AxesChoice>,
    #[serde(with = "path::Optional")]
    pub geometry_dir: Option<PathBuf>,
    #[serde(with = "path::Optional")]
    pub motion: Option<PathBuf>,
    #[serde(with = "path::Optional")]
    pub plates: Option<PathBuf>,
    #[serde(with = "path::Optional")]
    pub loads: Option<PathBuf>,
    pub angles: Option<AngleChoice>,
    #[serde(with = "path::Optional")]
    pub presets: Option<PathBuf>,
    pub gravity: Option<Acceleration>,
    #[serde(flatten)]
    pub fall: FallOptions,
    #[serde(flatten)]
    pub heat: HeatOptions,
    #[serde(flatten)]
    pub looks: FigureOptions,
    #[serde(flatten)]
    pub counts: CountOptions,
    #[serde(flatten)]
    pub masses: MassOptions,
    #[serde(flatten)]
    pub choice: ForceOptions,
    #[serde(flatten)]
    pub set_files: SetFiles,
    #[serde(flatten)]
    pub answers: AnswerOptions,
}

impl PlotRequest {
    pub(crate) const RELATIONS: &'static [&'static [Relation]] = &[&[
        Relation::Required("kind"),
        Relation::Required("output"),
        Relation::Needs("plates", "motion"),
        Relation::Needs("loads", "plates"),
        Relation::Needs("angles", "motion"),
        Relation::Needs("table", "value_column"),
        Relation::Needs("value_column", "table"),
        Relation::Needs("x_column", "table"),
        Relation::Needs("y_column", "table"),
    ]];
}

impl PlotRequest {
    /// Whether the plot is a figure of the paper, with the animals of the paper.
    pub(crate) fn is_of_paper(&self) -> bool {
        matches!(self.kind, Some(PlotKind::Fig4 | PlotKind::FigC5))
    }

    /// Refuses a wrong number of models for the plot, and the figure that cannot be drawn.
    ///
    /// # Errors
    /// Too many models, no model, or Fig. 1.
    pub fn check_models(&self) -> Result<(), RequestFault> {
        if self.kind == Some(PlotKind::Fig1) {
            return Err(RequestFault::general(no_fig1()));
        }
        if self.is_of_paper() && (!self.models.is_empty() || self.target_mass.is_some()) {
            return Err(RequestFault::general(phrase![
                "fig4 and fig-c5 redraw the paper's own animals: leave out models and ",
                Input::TargetMass,
            ]));
        }
        if (self.kind == Some(PlotKind::Motion)) != self.motion.is_some() {
            return Err(RequestFault::general(phrase![
                "only the plot of motion takes a recording: give ",
                Input::Motion.with_placeholder("FILE"),
            ]));
        }
        if self.heat.table.is_some() {
            return self.check_table();
        }
        if !self.is_of_paper() && self.models.is_empty() {
            return Err(RequestFault::general(
                "nothing to draw: name a model, or a preset such as falisse2022",
            ));
        }
        Ok(())
    }

    /// Refuses fields that have no meaning together with a table.
    ///
    /// # Errors
    /// A model, or another kind of figure.
    fn check_table(&self) -> Result<(), RequestFault> {
        if self.kind != Some(PlotKind::Sweep) || !self.models.is_empty() || self.target_mass.is_some() {
            return Err(RequestFault::refused(
                Input::Table,
                Phrase::template(
                    "a table is drawn by `plot kind=sweep`, without a model: leave out models and the target mass",
                ),
            ));
        }
        Ok(())
    }

    /// Whether the plot is a figure of a recorded motion.
    pub fn is_of_motion(&self) -> bool {
        self.kind == Some(PlotKind::Motion)
    }

    /// Whether the plot is a figure of feet: it shows the places of spheres, and no forces.
    pub fn is_of_feet(&self) -> bool {
        self.kind == Some(PlotKind::Feet)
    }

    /// The mass to which the drawn contacts are scaled, kg.
    pub fn target_mass_kg(&self) -> Option<f64> {
        self.target_mass.map(Kilograms::get)
    }
}
