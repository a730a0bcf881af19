//! How figures look, and what heat maps show.

use std::path::PathBuf;

#[cfg(feature = "schemas")]
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::choice::choices;
use crate::values::{Dpi, FigureWidth, FontSize, Grid, Span, path, serial};

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
    #[must_use]
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
