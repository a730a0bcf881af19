//! Figures, and how they look.

use std::path::PathBuf;

use osim_model::messages::{Input, Phrase, phrase};
#[cfg(feature = "schemas")]
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::motion::AngleChoice;
use crate::fault::{Relation, RequestFault};
use crate::options::{AnswerOptions, CountOptions, FallOptions, ForceOptions, MassOptions, SetFiles};
use crate::request::knowledge::no_fig1;
use crate::values::serial::{self, choices};
use crate::values::{Acceleration, Dpi, FigureWidth, FontSize, Grid, Kilograms, Span, path};

/// How a figure looks.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema))]
#[cfg_attr(feature = "clap", derive(clap::Args), command(next_help_heading = "The figure"))]
#[serde(default)]
pub struct FigureOptions {
    /// Title of the figure; "" for none
    #[cfg_attr(feature = "clap", arg(long, value_name = "TEXT"))]
    pub title: Option<String>,
    /// Name of a curve, in the order of the legend; once for each
    #[cfg_attr(feature = "clap", arg(long, value_name = "NAME"))]
    #[serde(deserialize_with = "serial::from_texts")]
    pub label: Vec<String>,
    /// Width on paper, mm [default: 90, one column of a journal; 190 for several panels side by side]
    #[cfg_attr(feature = "clap", arg(long, value_name = "MM"))]
    pub width: Option<FigureWidth>,
    /// Size of the letters on paper, points; everything else grows with them
    #[cfg_attr(feature = "clap", arg(long, value_name = "PT", default_value_t))]
    pub font_size: FontSize,
    /// Limits of the horizontal axis, in its unit: FROM..TO
    #[cfg_attr(feature = "clap", arg(long, value_name = "RANGE", allow_hyphen_values = true))]
    pub x_range: Option<Span>,
    /// Limits of the vertical axis, in its unit: FROM..TO
    #[cfg_attr(feature = "clap", arg(long, value_name = "RANGE", allow_hyphen_values = true))]
    pub y_range: Option<Span>,
    /// Pixels to the inch of a PNG
    #[cfg_attr(feature = "clap", arg(long, value_name = "N", default_value_t, hide_short_help = true))]
    pub dpi: Dpi,
}

choices! {
    /// What the colours of a heat map show.
    QuantityChoice: Indentation {
        /// x̂ at rest.
        Indentation = "indentation", "Relative indentation at rest under body weight, by the Hertz law";
        /// c_r, exact.
        Restitution = "restitution", "Coefficient of restitution at the impact speed of the fall, exact";
        /// Peak force over body weight.
        PeakForce = "peak-force", "Peak force over body weight in the fall";
    }
}

/// What is computed.
///
/// Exhaustive: code that draws it needs a title and a scale for each quantity.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum HeatQuantity {
    /// Relative indentation at rest under body weight, by the Hertz law.
    Indentation,
    /// Coefficient of restitution at the impact speed of the fall, exact.
    Restitution,
    /// Peak force over body weight in the fall.
    PeakForce,
}

impl QuantityChoice {
    /// The quantity.
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
#[cfg_attr(feature = "schemas", derive(JsonSchema))]
#[cfg_attr(feature = "clap", derive(clap::Args), command(next_help_heading = "The sweep"))]
#[serde(default)]
pub struct HeatOptions {
    /// What the colours show
    #[cfg_attr(feature = "clap", arg(long, value_enum, default_value_t))]
    pub quantity: QuantityChoice,
    /// Values of stiffness: FROM..TO/COUNT in N/m2, or factors like x0.1..x10/25
    #[cfg_attr(feature = "clap", arg(long, value_name = "GRID", default_value_t = STIFFNESS))]
    pub stiffness: Grid,
    /// Values of dissipation: FROM..TO/COUNT in s/m, or factors
    #[cfg_attr(feature = "clap", arg(long, value_name = "GRID", default_value_t = DISSIPATION))]
    pub dissipation: Grid,
    /// Draw a column of this table (CSV) instead, such as a sweep's with your results in it
    #[cfg_attr(feature = "clap", arg(long, value_name = "FILE"))]
    #[serde(with = "path::optional")]
    #[cfg_attr(feature = "schemas", schemars(with = "Option<path::PathSchema>"))]
    pub table: Option<PathBuf>,
    /// The table's column that is drawn
    #[cfg_attr(feature = "clap", arg(long, value_name = "NAME"))]
    pub value_column: Option<String>,
    /// The table's column along the horizontal axis [default: the first grid_ column]
    #[cfg_attr(feature = "clap", arg(long, value_name = "NAME"))]
    pub x_column: Option<String>,
    /// The table's column along the vertical axis [default: the second grid_ column]
    #[cfg_attr(feature = "clap", arg(long, value_name = "NAME"))]
    pub y_column: Option<String>,
    /// From which value to which colours change: FROM..TO
    #[cfg_attr(feature = "clap", arg(long, value_name = "RANGE", allow_hyphen_values = true))]
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
    /// What is drawn.
    PlotKind {
        /// Force against indentation.
        Force = "force", "Force against indentation: Hertz, with cf, smoothed";
        /// Contact state against indentation.
        State = "state", "Contact state against indentation";
        /// Force while a sphere goes in and out.
        Loop = "loop", "Dissipation: force while a sphere goes in and out";
        /// A drop test.
        Drop = "drop", "Drop test: force against time and non-dimensional time";
        /// A heat map.
        Sweep = "sweep", "A quantity over stiffness and dissipation, as a heat map";
        /// Feet from the side and from above.
        Feet = "feet", "Feet from the side and from above: bones, joints, spheres to scale";
        /// Contacts along a recorded motion.
        Motion = "motion", "Along a recorded motion: force beside the plates', x/R of each sphere";
        /// The paper's Fig. 1, which cannot be drawn.
        Fig1 = "fig1", "The paper's Fig. 1: not drawn; the output says what it needs";
        /// The paper's Fig. 4.
        Fig4 = "fig4", "The paper's Fig. 4";
        /// The paper's Fig. C.5.
        FigC5 = "fig-c5", "The paper's Fig. C.5";
    }
}

choices! {
    /// Units of indentation and force.
    AxesChoice {
        /// Without dimensions.
        Dimensionless = "dimensionless", "x/R, and force over the weight's share of one sphere";
        /// In SI units.
        Real = "real", "mm and N";
    }
}

/// Draws what contacts do.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema))]
#[cfg_attr(feature = "clap", derive(clap::Args))]
#[serde(default)]
pub struct PlotRequest {
    /// What to draw
    #[cfg_attr(feature = "clap", arg(value_enum))]
    pub kind: Option<PlotKind>,
    /// Models (.osim) or presets, overlaid in one figure; none for fig4 and fig-c5
    #[cfg_attr(feature = "clap", arg(value_name = "MODEL|PRESET"))]
    #[serde(with = "path::list")]
    #[cfg_attr(feature = "schemas", schemars(with = "Vec<path::PathSchema>"))]
    pub models: Vec<PathBuf>,
    /// Write to this file: .svg, .pdf or .png (- is SVG on standard output)
    #[cfg_attr(feature = "clap", arg(short, long, value_name = "FILE"))]
    #[serde(with = "path::optional")]
    #[cfg_attr(feature = "schemas", schemars(with = "Option<path::PathSchema>"))]
    pub output: Option<PathBuf>,
    /// Write the numbers that are drawn to this file, too (CSV)
    #[cfg_attr(feature = "clap", arg(long, value_name = "FILE"))]
    #[serde(with = "path::optional")]
    #[cfg_attr(feature = "schemas", schemars(with = "Option<path::PathSchema>"))]
    pub data: Option<PathBuf>,
    /// Replace existing files
    #[cfg_attr(feature = "clap", arg(long))]
    pub force: bool,
    /// Draw each contact also as it is after scaling to this mass, kg
    #[cfg_attr(feature = "clap", arg(long, value_name = "KG", allow_hyphen_values = true))]
    pub target_mass: Option<Kilograms>,
    /// Units of indentation and force [default: x/R and N; x/R and shares of the weight for several]
    #[cfg_attr(feature = "clap", arg(long, value_enum))]
    pub axes: Option<AxesChoice>,
    /// Of feet: a folder with the bones' meshes, beside the model's own and its Geometry
    #[cfg_attr(feature = "clap", arg(long, value_name = "DIR"))]
    #[serde(with = "path::optional")]
    #[cfg_attr(feature = "schemas", schemars(with = "Option<path::PathSchema>"))]
    pub geometry_dir: Option<PathBuf>,
    /// Of motion: coordinates over time (.mot, .sto)
    #[cfg_attr(feature = "clap", arg(long, value_name = "FILE", hide_short_help = true))]
    #[serde(with = "path::optional")]
    #[cfg_attr(feature = "schemas", schemars(with = "Option<path::PathSchema>"))]
    pub motion: Option<PathBuf>,
    /// Of motion: the ground reactions that force plates measured (.mot, .sto)
    #[cfg_attr(feature = "clap", arg(long, value_name = "FILE", hide_short_help = true))]
    #[serde(with = "path::optional")]
    #[cfg_attr(feature = "schemas", schemars(with = "Option<path::PathSchema>"))]
    pub plates: Option<PathBuf>,
    /// Of motion: OpenSim's ExternalLoads (.xml)
    #[cfg_attr(feature = "clap", arg(long, value_name = "FILE", hide_short_help = true))]
    #[serde(with = "path::optional")]
    #[cfg_attr(feature = "schemas", schemars(with = "Option<path::PathSchema>"))]
    pub loads: Option<PathBuf>,
    /// Of motion: the unit of its angles, where its header does not say it
    #[cfg_attr(feature = "clap", arg(long, value_enum, hide_short_help = true))]
    pub angles: Option<AngleChoice>,
    /// A file with presets of your own (TOML)
    #[cfg_attr(feature = "clap", arg(long, value_name = "FILE", hide_short_help = true))]
    #[serde(with = "path::optional")]
    #[cfg_attr(feature = "schemas", schemars(with = "Option<path::PathSchema>"))]
    pub presets: Option<PathBuf>,
    /// Gravity, m/s2 [default: the model's]
    #[cfg_attr(feature = "clap", arg(long, value_name = "G", hide_short_help = true))]
    pub gravity: Option<Acceleration>,
    /// The fall.
    #[cfg_attr(feature = "clap", command(flatten))]
    #[serde(flatten)]
    pub fall: FallOptions,
    /// The grid of a heat map.
    #[cfg_attr(feature = "clap", command(flatten))]
    #[serde(flatten)]
    pub heat: HeatOptions,
    /// How the figure looks.
    #[cfg_attr(feature = "clap", command(flatten))]
    #[serde(flatten)]
    pub looks: FigureOptions,
    /// How many spheres share the weight.
    #[cfg_attr(feature = "clap", command(flatten))]
    #[serde(flatten)]
    pub counts: CountOptions,
    /// Which mass is meant.
    #[cfg_attr(feature = "clap", command(flatten))]
    #[serde(flatten)]
    pub masses: MassOptions,
    /// Which forces.
    #[cfg_attr(feature = "clap", command(flatten))]
    #[serde(flatten)]
    pub choice: ForceOptions,
    /// Files of a standalone set.
    #[cfg_attr(feature = "clap", command(flatten))]
    #[serde(flatten)]
    pub set_files: SetFiles,
    /// Answers to questions.
    #[cfg_attr(feature = "clap", command(flatten))]
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
    /// Whether it is a figure of the paper, which shows its own animals.
    pub(crate) fn is_of_paper(&self) -> bool {
        matches!(self.kind, Some(PlotKind::Fig4 | PlotKind::FigC5))
    }

    /// Refuses models too many, or none, and the figure that cannot be drawn.
    ///
    /// # Errors
    /// They are.
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
                "a figure of motion, and no other, has a recording: say ",
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

    /// Refuses what has no meaning beside a table.
    ///
    /// # Errors
    /// A model, or a figure of another kind.
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

    /// Whether it is a figure of a recorded motion.
    pub fn is_of_motion(&self) -> bool {
        self.kind == Some(PlotKind::Motion)
    }

    /// Whether it is a figure of feet, which shows where spheres are and not what they do.
    pub fn is_of_feet(&self) -> bool {
        self.kind == Some(PlotKind::Feet)
    }

    /// The mass to which contacts are drawn scaled, kg.
    pub fn target_mass_kg(&self) -> Option<f64> {
        self.target_mass.map(Kilograms::get)
    }
}
