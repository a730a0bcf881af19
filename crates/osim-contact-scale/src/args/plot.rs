//! Options of `plot`.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

use super::CountArgs;
use super::groups::{ForceChoice, MassArgs, PartArgs};
use super::values::{Grid, Length, acceleration, grid, length, mass, positive_number};

#[derive(Debug, Args)]
pub(crate) struct PlotArgs {
    /// What to draw
    #[arg(value_enum)]
    pub kind: PlotKind,
    /// Models (.osim) or presets, overlaid in one figure; none for fig4 and fig-c5
    #[arg(value_name = "MODEL|PRESET")]
    pub models: Vec<PathBuf>,
    /// Write to this file: .svg or .png (- is SVG on standard output)
    #[arg(short, long, value_name = "FILE", required = true)]
    pub output: PathBuf,
    /// Replace an existing file
    #[arg(long)]
    pub force: bool,
    /// Draw each contact also as it is after scaling to this mass, kg
    #[arg(long, value_name = "KG", value_parser = mass, allow_hyphen_values = true)]
    pub target_mass: Option<f64>,
    /// Units of indentation and force [default: x/R and N; x/R and shares of the weight for several]
    #[arg(long, value_enum)]
    pub axes: Option<AxesArg>,
    /// Title of the figure
    #[arg(long, value_name = "TEXT")]
    pub title: Option<String>,
    /// Pixels to the inch of a PNG
    #[arg(long, value_name = "N", default_value = "600", value_parser = clap::value_parser!(u16).range(50..=2400), hide_short_help = true)]
    pub dpi: u16,
    /// A file with presets of your own (TOML)
    #[arg(long, value_name = "FILE", hide_short_help = true)]
    pub presets: Option<PathBuf>,
    /// Gravity, m/s2 [default: the model's]
    #[arg(long, value_name = "G", value_parser = acceleration, hide_short_help = true)]
    pub gravity: Option<f64>,
    #[command(flatten)]
    pub fall: FallArgs,
    #[command(flatten)]
    pub sweep: SweepArgs,
    #[command(flatten)]
    pub counts: CountArgs,
    #[command(flatten)]
    pub masses: MassArgs,
    #[command(flatten)]
    pub choice: ForceChoice,
    #[command(flatten)]
    pub parts: PartArgs,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum PlotKind {
    /// Force against indentation: Hertz, with cf, smoothed
    Force,
    /// Contact state against indentation
    State,
    /// Dissipation: force while a sphere goes in and out
    Loop,
    /// Drop test: force against time and non-dimensional time
    Drop,
    /// A quantity over stiffness and dissipation, as a heat map
    Sweep,
    /// The paper's Fig. 4
    Fig4,
    /// The paper's Fig. C.5
    FigC5,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum AxesArg {
    /// x/R, and force over the weight's share of one sphere
    Dimensionless,
    /// mm and N
    Real,
}

/// The fall that drop and sweep are about.
#[derive(Debug, Args)]
#[command(next_help_heading = "The fall (drop, loop, sweep)")]
pub(crate) struct FallArgs {
    /// Height of the sphere bottoms at the start: metres, or a factor of the radius like x0.25
    #[arg(long, value_name = "HEIGHT", value_parser = length, default_value = "x0.25")]
    pub height: Length,
    /// How long to follow the body, s [default: 20 sqrt(R/g), of the slowest]
    #[arg(long, value_name = "S", value_parser = positive_number)]
    pub duration: Option<f64>,
}

/// The grid of a sweep.
#[derive(Debug, Args)]
#[command(next_help_heading = "The sweep")]
pub(crate) struct SweepArgs {
    /// What the colours show
    #[arg(long, value_enum, default_value = "indentation")]
    pub quantity: Quantity,
    /// Values of stiffness: FROM..TO/COUNT in N/m2, or factors like x0.1..x10/25
    #[arg(long, value_name = "GRID", value_parser = grid, default_value = "x0.1..x10/25")]
    pub stiffness: Grid,
    /// Values of dissipation: FROM..TO/COUNT in s/m, or factors
    #[arg(long, value_name = "GRID", value_parser = grid, default_value = "x0.1..x4/25")]
    pub dissipation: Grid,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum Quantity {
    /// Relative indentation at rest under body weight, by the contact's own law
    Indentation,
    /// Coefficient of restitution at the impact speed of the fall, exact
    Restitution,
    /// Peak force over body weight in the fall
    PeakForce,
}
