//! Options of contacts that follow a scaled body.

use std::collections::BTreeMap;
use std::path::PathBuf;

use clap::{Args, ValueEnum};
use osim_patch::{LevelAxis, MovedSpheres, RadiusAxis};

use super::values::{body_scale, positive_number};

/// Spheres follow their bodies.
#[derive(Debug, Args)]
#[command(next_help_heading = "A model that OpenSim scaled (--from is the generic model)")]
pub(crate) struct FollowArgs {
    /// Spheres take place and size from their bodies, which OpenSim has scaled
    #[arg(long)]
    pub follow_bodies: bool,
    /// The ScaleSet that the Scale Tool applied (its output_scale_file)
    #[arg(long, value_name = "FILE", requires = "follow_bodies")]
    pub body_scale_file: Option<PathBuf>,
    /// Factors of a body that the files do not tell; may be repeated
    #[arg(long, value_name = "BODY=x,y,z", value_parser = body_scale, requires = "follow_bodies")]
    pub body_scale: Vec<(String, [f64; 3])>,
    /// How a radius follows from three factors
    #[arg(long, value_enum, default_value = "geomean", requires = "follow_bodies", hide_short_help = true)]
    pub radius_axis: RadiusAxisArg,
    /// Spheres that were moved or resized already: keep them, or place them anew
    #[arg(long, value_enum, requires = "follow_bodies")]
    pub moved_spheres: Option<MovedArg>,
    /// Refuse where spheres of one force follow bodies with different factors
    #[arg(long, requires = "follow_bodies", hide_short_help = true)]
    pub strict: bool,
    /// The paper's scaling, or PredSim's (stiffness by mass/height^2, dissipation by 1/height)
    #[arg(long, value_enum, default_value = "paper")]
    pub rule: RuleArg,
    /// Height of this model over that of the reference [default: mean of the body factors]
    #[arg(long, value_name = "RATIO", value_parser = positive_number, requires = "rule", hide_short_help = true)]
    pub height_ratio: Option<f64>,
}

impl FollowArgs {
    pub(crate) fn given(&self) -> BTreeMap<String, [f64; 3]> {
        self.body_scale.iter().cloned().collect()
    }

    pub(crate) fn moved(&self) -> MovedSpheres {
        match self.moved_spheres {
            None => MovedSpheres::Refuse,
            Some(MovedArg::Keep) => MovedSpheres::Keep,
            Some(MovedArg::Replace) => MovedSpheres::Replace,
        }
    }

    pub(crate) fn radius_axis(&self) -> RadiusAxis {
        match self.radius_axis {
            RadiusAxisArg::X => RadiusAxis::X,
            RadiusAxisArg::Y => RadiusAxis::Y,
            RadiusAxisArg::Z => RadiusAxis::Z,
            RadiusAxisArg::Geomean => RadiusAxis::GeometricMean,
            RadiusAxisArg::Min => RadiusAxis::Min,
            RadiusAxisArg::Max => RadiusAxis::Max,
        }
    }
}

#[derive(Debug, Clone, Copy, ValueEnum)]
pub(crate) enum RadiusAxisArg {
    X,
    Y,
    Z,
    Geomean,
    Min,
    Max,
}

#[derive(Debug, Clone, Copy, ValueEnum)]
pub(crate) enum MovedArg {
    Keep,
    Replace,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum RuleArg {
    Paper,
    Predsim,
}

/// The axis of a sphere's frame that points away from the ground.
#[derive(Debug, Clone, Copy, ValueEnum)]
pub(crate) enum AxisArg {
    X,
    Y,
    Z,
    #[value(name = "-x")]
    MinusX,
    #[value(name = "-y")]
    MinusY,
    #[value(name = "-z")]
    MinusZ,
}

impl AxisArg {
    pub(crate) fn axis(self) -> LevelAxis {
        let (axis, down) = match self {
            Self::X => (0, false),
            Self::Y => (1, false),
            Self::Z => (2, false),
            Self::MinusX => (0, true),
            Self::MinusY => (1, true),
            Self::MinusZ => (2, true),
        };
        LevelAxis { axis, down, of_body: false }
    }
}
