//! Options of the verbs that work with the paper's equations: design, drop-test, fit, presets; and of set.

use std::ffi::OsString;
use std::path::PathBuf;

use clap::{Args, ValueEnum};
use osim_patch::RadiusRule;

use super::groups::{ForceChoice, MassArgs, OutputArgs, PartArgs, RunArgs};
use super::values::{
    Length, acceleration, count, fraction, indentation, length, number, poisson, positive_number, radius,
    restitution,
};
use super::{CountArgs, Format};

#[derive(Debug, Args)]
pub(crate) struct DesignArgs {
    /// Models to write the design into; without one, a calculator
    #[arg(value_name = "MODEL")]
    pub models: Vec<PathBuf>,
    #[command(flatten)]
    pub wanted: WantedArgs,
    #[command(flatten)]
    pub load: LoadArgs,
    #[command(flatten)]
    pub masses: MassArgs,
    #[command(flatten)]
    pub counts: CountArgs,
    #[command(flatten)]
    pub choice: ForceChoice,
    #[command(flatten)]
    pub output: OutputArgs,
    #[command(flatten)]
    pub run: RunArgs,
    #[command(flatten)]
    pub parts: PartArgs,
}

/// What is wanted or known of the contact.
#[derive(Debug, Clone, Args)]
#[command(next_help_heading = "What is wanted or known")]
pub(crate) struct WantedArgs {
    /// Sphere radius in metres (with models also keep or a factor like x1.5)
    #[arg(long, value_name = "RULE", value_parser = radius)]
    pub radius: Option<RadiusRule>,
    /// Relative indentation x/R under the load, 0 to 1 (11)
    #[arg(long, value_name = "X", value_parser = indentation)]
    pub indentation: Option<f64>,
    /// Stiffness of one sphere at that load, N/m (11 with B.2)
    #[arg(long, value_name = "N/M", value_parser = positive_number)]
    pub contact_stiffness: Option<f64>,
    /// Young's modulus, N/m2 (A.1, A.5)
    #[arg(long, value_name = "E", value_parser = positive_number, requires = "poisson")]
    pub young: Option<f64>,
    /// Poisson's ratio
    #[arg(long, value_name = "NU", value_parser = poisson, requires = "young", allow_hyphen_values = true)]
    pub poisson: Option<f64>,
    /// OpenSim's stiffness (plane strain modulus of one surface), N/m2
    #[arg(long, value_name = "E1", value_parser = positive_number, conflicts_with = "young")]
    pub stiffness: Option<f64>,
    /// Coefficient of restitution, 0 to 1 (13)
    #[arg(long, value_name = "CR", value_parser = restitution)]
    pub restitution: Option<f64>,
    /// Impact speed, m/s [default: sqrt(gR/2), a fall from a quarter of the radius]
    #[arg(long, value_name = "M/S", value_parser = positive_number, requires = "restitution")]
    pub impact_speed: Option<f64>,
    /// Constant indentation over radius, for constant_contact_force (C.2)
    #[arg(long, value_name = "X", value_parser = positive_number)]
    pub constant_indentation: Option<f64>,
    /// Width of the contact transition over radius, for hertz_smoothing (C.8)
    #[arg(long, value_name = "X", value_parser = positive_number)]
    pub state_width: Option<f64>,
    /// Width of the transition in speed, m/s, for hunt_crossley_smoothing (C.10)
    #[arg(long, value_name = "M/S", value_parser = positive_number)]
    pub speed_width: Option<f64>,
    /// Threshold t that the widths refer to: from t to 1 - t
    #[arg(long, value_name = "T", value_parser = fraction, default_value = "0.05")]
    pub threshold: f64,
}

/// The load on the spheres.
#[derive(Debug, Clone, Args)]
#[command(next_help_heading = "The load")]
pub(crate) struct LoadArgs {
    /// Total load on all spheres, N
    #[arg(long, value_name = "N", value_parser = positive_number, conflicts_with = "body_weights")]
    pub load: Option<f64>,
    /// The load in body weights [default: 1 where a mass is known]
    #[arg(long, value_name = "B", value_parser = positive_number)]
    pub body_weights: Option<f64>,
    /// Gravity, m/s2 [default: the model's, else 9.80665]
    #[arg(long, value_name = "G", value_parser = acceleration)]
    pub gravity: Option<f64>,
}

#[derive(Debug, Args)]
pub(crate) struct SetArgs {
    /// Models, and what to set: PROPERTY=VALUE or PROPERTY=xFACTOR
    #[arg(value_name = "MODEL|PROPERTY=VALUE|PROPERTY=xFACTOR", required = true)]
    pub items: Vec<OsString>,
    #[command(flatten)]
    pub masses: MassArgs,
    #[command(flatten)]
    pub choice: ForceChoice,
    #[command(flatten)]
    pub output: OutputArgs,
    #[command(flatten)]
    pub run: RunArgs,
    #[command(flatten)]
    pub parts: PartArgs,
}

#[derive(Debug, Args)]
pub(crate) struct DropArgs {
    /// The model to drop (.osim), or a preset; without one, give the numbers
    #[arg(value_name = "MODEL|PRESET")]
    pub subject: Option<PathBuf>,
    /// Height of the sphere bottoms at the start: metres, or a factor of the radius like x0.25
    #[arg(long, value_name = "HEIGHT", value_parser = length, default_value = "x0.25")]
    pub height: Length,
    /// How long to follow the body, s
    #[arg(long, value_name = "S", value_parser = positive_number, default_value = "2")]
    pub duration: f64,
    /// Points of the series
    #[arg(long, value_name = "N", default_value = "1001", value_parser = clap::value_parser!(u32).range(2..=1_000_000))]
    pub samples: u32,
    /// Say how far this drop and that of OTHER (a model or preset) lie apart in dimensionless form
    #[arg(long, value_name = "OTHER")]
    pub compare: Option<PathBuf>,
    /// With --compare: the spheres that share OTHER's weight [default: as found on one limb]
    #[arg(long, value_name = "N", value_parser = count, requires = "compare")]
    pub compare_spheres: Option<f64>,
    /// A file with presets of your own (TOML)
    #[arg(long, value_name = "FILE", hide_short_help = true)]
    pub presets: Option<PathBuf>,
    /// How to print
    #[arg(long, value_enum, default_value_t)]
    pub format: SeriesFormat,
    #[command(flatten)]
    pub numbers: DropNumbers,
    #[command(flatten)]
    pub counts: CountArgs,
    #[command(flatten)]
    pub masses: MassArgs,
    #[command(flatten)]
    pub choice: ForceChoice,
    #[command(flatten)]
    pub parts: PartArgs,
}

/// A contact given by its numbers.
#[derive(Debug, Args)]
#[command(next_help_heading = "Without a model (with --mass and --spheres)")]
pub(crate) struct DropNumbers {
    /// Sphere radius, m
    #[arg(long, value_name = "M", value_parser = positive_number)]
    pub radius: Option<f64>,
    /// OpenSim's stiffness (plane strain modulus of one surface), N/m2
    #[arg(long, value_name = "E1", value_parser = positive_number)]
    pub stiffness: Option<f64>,
    /// OpenSim's dissipation, s/m
    #[arg(long, value_name = "A", value_parser = number)]
    pub dissipation: Option<f64>,
    /// With the next two: SmoothSphereHalfSpaceForce's law, m2
    #[arg(long, value_name = "CF", value_parser = number)]
    pub constant_contact_force: Option<f64>,
    /// 1/m
    #[arg(long, value_name = "BD", value_parser = positive_number)]
    pub hertz_smoothing: Option<f64>,
    /// s/m
    #[arg(long, value_name = "BV", value_parser = positive_number)]
    pub hunt_crossley_smoothing: Option<f64>,
    /// Gravity, m/s2 [default: the model's, else 9.80665]
    #[arg(long, value_name = "G", value_parser = acceleration)]
    pub gravity: Option<f64>,
}

#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum SeriesFormat {
    /// Figures (and a chart on a terminal)
    #[default]
    Table,
    /// One JSON object
    Json,
    /// The series, one row per moment
    Csv,
}

#[derive(Debug, Args)]
pub(crate) struct FitArgs {
    /// Measured indentation and force (.csv; - is standard input)
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// Sphere radius, m
    #[arg(long, value_name = "M", value_parser = positive_number)]
    pub radius: f64,
    /// Spheres that share the measured force
    #[arg(long, value_name = "N", value_parser = count, default_value = "1")]
    pub spheres: f64,
    /// Where contact begins, in metres, or fit to find it
    #[arg(long, value_name = "M|fit", default_value = "0", allow_hyphen_values = true)]
    pub onset: String,
    /// Which part of the measurement
    #[arg(long, value_enum, default_value = "both")]
    pub branch: BranchArg,
    /// How to print
    #[arg(long, value_enum, default_value_t)]
    pub format: Format,
    #[command(flatten)]
    pub columns: ColumnArgs,
}

#[derive(Debug, Clone, Copy, ValueEnum)]
pub(crate) enum BranchArg {
    Both,
    Loading,
    Unloading,
}

/// Columns of the file and their units.
#[derive(Debug, Args)]
#[command(next_help_heading = "Columns and units")]
pub(crate) struct ColumnArgs {
    /// Column of the indentation
    #[arg(long, value_name = "NAME", default_value = "indentation")]
    pub indentation_column: String,
    /// Column of the force
    #[arg(long, value_name = "NAME", default_value = "force")]
    pub force_column: String,
    /// Column of the speed of indentation; without it and without a time, dissipation is not fitted
    #[arg(long, value_name = "NAME", conflicts_with = "time_column")]
    pub speed_column: Option<String>,
    /// Column of the time, from which the speed is taken
    #[arg(long, value_name = "NAME")]
    pub time_column: Option<String>,
    /// Unit of the indentation
    #[arg(long, value_enum, default_value = "m")]
    pub indentation_unit: LengthUnit,
    /// Unit of the force
    #[arg(long, value_enum, default_value = "N")]
    pub force_unit: ForceUnit,
    /// Unit of the speed
    #[arg(long, value_enum, default_value = "m/s")]
    pub speed_unit: SpeedUnit,
    /// Unit of the time
    #[arg(long, value_enum, default_value = "s")]
    pub time_unit: TimeUnit,
}

#[derive(Debug, Clone, Copy, ValueEnum)]
pub(crate) enum LengthUnit {
    M,
    Mm,
    Um,
}

#[derive(Debug, Clone, Copy, ValueEnum)]
pub(crate) enum ForceUnit {
    #[value(name = "N")]
    Newton,
    #[value(name = "kN")]
    Kilonewton,
    #[value(name = "mN")]
    Millinewton,
}

#[derive(Debug, Clone, Copy, ValueEnum)]
pub(crate) enum SpeedUnit {
    #[value(name = "m/s")]
    MetresPerSecond,
    #[value(name = "mm/s")]
    MillimetresPerSecond,
}

#[derive(Debug, Clone, Copy, ValueEnum)]
pub(crate) enum TimeUnit {
    S,
    Ms,
}

#[derive(Debug, Args)]
pub(crate) struct PresetsArgs {
    /// One preset (without it: list them all)
    pub name: Option<String>,
    /// A file with presets of your own (TOML)
    #[arg(long, value_name = "FILE")]
    pub presets: Option<PathBuf>,
    /// How to print
    #[arg(long, value_enum, default_value_t)]
    pub format: Format,
}

impl DropArgs {
    /// `--mass`, for a body given by its numbers.
    pub(crate) fn mass_kg(&self) -> Option<f64> {
        self.masses.mass
    }
}
