//! Columns of a measurement, and their units.

#[cfg(feature = "schemas")]
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::fault::Relation;
use crate::values::serial::choices;

choices! {
    /// Unit of a length.
    LengthUnit: M {
        /// m.
        M = "m";
        /// mm.
        Mm = "mm";
        /// µm.
        Um = "um";
    }
}

choices! {
    /// Unit of a force.
    ForceUnit: Newton {
        /// N.
        Newton = "N";
        /// kN.
        Kilonewton = "kN";
        /// mN.
        Millinewton = "mN";
    }
}

choices! {
    /// Unit of a speed.
    SpeedUnit: MetresPerSecond {
        /// m/s.
        MetresPerSecond = "m/s";
        /// mm/s.
        MillimetresPerSecond = "mm/s";
    }
}

choices! {
    /// Unit of a time.
    TimeUnit: S {
        /// s.
        S = "s";
        /// ms.
        Ms = "ms";
    }
}

impl LengthUnit {
    /// In m.
    pub const fn metres(self) -> f64 {
        match self {
            Self::M => 1.0,
            Self::Mm => 1e-3,
            Self::Um => 1e-6,
        }
    }
}

impl ForceUnit {
    /// In N.
    pub const fn newtons(self) -> f64 {
        match self {
            Self::Newton => 1.0,
            Self::Kilonewton => 1e3,
            Self::Millinewton => 1e-3,
        }
    }
}

impl SpeedUnit {
    /// In m/s.
    pub const fn metres_per_second(self) -> f64 {
        match self {
            Self::MetresPerSecond => 1.0,
            Self::MillimetresPerSecond => 1e-3,
        }
    }
}

impl TimeUnit {
    /// In s.
    pub const fn seconds(self) -> f64 {
        match self {
            Self::S => 1.0,
            Self::Ms => 1e-3,
        }
    }
}

/// Columns of the file and their units.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema))]
#[cfg_attr(feature = "clap", derive(clap::Args), command(next_help_heading = "Columns and units"))]
#[serde(default)]
pub struct ColumnOptions {
    /// Column of the indentation
    #[cfg_attr(feature = "clap", arg(long, value_name = "NAME", default_value_t = indentation()))]
    pub indentation_column: String,
    /// Column of the force
    #[cfg_attr(feature = "clap", arg(long, value_name = "NAME", default_value_t = force()))]
    pub force_column: String,
    /// Column of the speed of indentation; without it and without a time, dissipation is not fitted
    #[cfg_attr(feature = "clap", arg(long, value_name = "NAME"))]
    pub speed_column: Option<String>,
    /// Column of the time, from which the speed is taken
    #[cfg_attr(feature = "clap", arg(long, value_name = "NAME"))]
    pub time_column: Option<String>,
    /// Unit of the indentation
    #[cfg_attr(feature = "clap", arg(long, value_enum, default_value_t))]
    pub indentation_unit: LengthUnit,
    /// Unit of the force
    #[cfg_attr(feature = "clap", arg(long, value_enum, default_value_t))]
    pub force_unit: ForceUnit,
    /// Unit of the speed
    #[cfg_attr(feature = "clap", arg(long, value_enum, default_value_t))]
    pub speed_unit: SpeedUnit,
    /// Unit of the time
    #[cfg_attr(feature = "clap", arg(long, value_enum, default_value_t))]
    pub time_unit: TimeUnit,
}

fn indentation() -> String {
    "indentation".to_owned()
}

fn force() -> String {
    "force".to_owned()
}

impl Default for ColumnOptions {
    fn default() -> Self {
        Self {
            indentation_column: indentation(),
            force_column: force(),
            speed_column: None,
            time_column: None,
            indentation_unit: LengthUnit::M,
            force_unit: ForceUnit::Newton,
            speed_unit: SpeedUnit::MetresPerSecond,
            time_unit: TimeUnit::S,
        }
    }
}

impl ColumnOptions {
    /// Which of its fields need or exclude others.
    pub(crate) const RELATIONS: &'static [Relation] = &[Relation::Excludes("speed_column", "time_column")];
}
