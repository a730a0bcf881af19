//! Options for the columns of a measurement, and their units.

use serde::{Deserialize, Serialize};

use crate::fault::Relation;
use crate::values::serial::choices;

choices! {
    /// Unit of a length.
    LengthUnit: M {
        M = "m";
        Mm = "mm";
        Um = "um";
    }
}

choices! {
    /// Unit of a force.
    ForceUnit: Newton {
        Newton = "N";
        Kilonewton = "kN";
        Millinewton = "mN";
    }
}

choices! {
    /// Unit of a speed.
    SpeedUnit: MetresPerSecond {
        MetresPerSecond = "m/s";
        MillimetresPerSecond = "mm/s";
    }
}

choices! {
    /// Unit of a time.
    TimeUnit: S {
        S = "s";
        Ms = "ms";
    }
}

impl LengthUnit {
    /// Length of the unit in m.
    pub const fn metres(self) -> f64 {
        match self {
            Self::M => 1.0,
            Self::Mm => 1e-3,
            Self::Um => 1e-6,
        }
    }
}

impl ForceUnit {
    /// Size of the unit in N.
    pub const fn newtons(self) -> f64 {
        match self {
            Self::Newton => 1.0,
            Self::Kilonewton => 1e3,
            Self::Millinewton => 1e-3,
        }
    }
}

impl SpeedUnit {
    /// Size of the unit in m/s.
    pub const fn metres_per_second(self) -> f64 {
        match self {
            Self::MetresPerSecond => 1.0,
            Self::MillimetresPerSecond => 1e-3,
        }
    }
}

impl TimeUnit {
    /// Size of the unit in s.
    pub const fn seconds(self) -> f64 {
        match self {
            Self::S => 1.0,
            Self::Ms => 1e-3,
        }
    }
}

/// Columns of the file and their units.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[serde(default)]
pub struct ColumnOptions {
    pub indentation_column: String,
    pub force_column: String,
    pub speed_column: Option<String>,
    pub time_column: Option<String>,
    pub indentation_unit: LengthUnit,
    pub force_unit: ForceUnit,
    pub speed_unit: SpeedUnit,
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
    /// Conditions between the column options.
    pub(crate) const RELATIONS: &'static [Relation] = &[Relation::Excludes("speed_column", "time_column")];
}
