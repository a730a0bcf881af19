//! What is wanted or known of a contact.

use osim_model::RadiusRule;
#[cfg(feature = "schemas")]
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::relation::Relation;
use crate::values::{
    ConstantIndentation, PoissonRatio, Positive, Radius, RelativeIndentation, RestitutionCoefficient,
    Threshold,
};

/// What is wanted or known of the contact.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema))]
#[cfg_attr(feature = "clap", derive(clap::Args), command(next_help_heading = "What is wanted or known"))]
#[serde(default)]
pub struct WantedOptions {
    /// Sphere radius in metres (with models also keep or a factor like x1.5)
    #[cfg_attr(feature = "clap", arg(long, value_name = "RULE"))]
    pub radius: Option<Radius>,
    /// Relative indentation x/R under the load, 0 to 1 (11)
    #[cfg_attr(feature = "clap", arg(long, value_name = "X"))]
    pub indentation: Option<RelativeIndentation>,
    /// Stiffness of one sphere at that load, N/m (11 with B.2)
    #[cfg_attr(feature = "clap", arg(long, value_name = "N/M"))]
    pub contact_stiffness: Option<Positive>,
    /// Young's modulus, N/m2 (A.1, A.5)
    #[cfg_attr(feature = "clap", arg(long, value_name = "E"))]
    pub young: Option<Positive>,
    /// Poisson's ratio
    #[cfg_attr(feature = "clap", arg(long, value_name = "NU", allow_hyphen_values = true))]
    pub poisson: Option<PoissonRatio>,
    /// OpenSim's stiffness (plane strain modulus of one surface), N/m2
    #[cfg_attr(feature = "clap", arg(long, value_name = "E1"))]
    pub stiffness: Option<Positive>,
    /// Coefficient of restitution, 0 to 1 (13)
    #[cfg_attr(feature = "clap", arg(long, value_name = "CR"))]
    pub restitution: Option<RestitutionCoefficient>,
    /// Impact speed, m/s [default: sqrt(gR/2), a fall from a quarter of the radius]
    #[cfg_attr(feature = "clap", arg(long, value_name = "M/S"))]
    pub impact_speed: Option<Positive>,
    /// Constant indentation over radius, for constant_contact_force (C.2)
    #[cfg_attr(feature = "clap", arg(long, value_name = "X"))]
    pub constant_indentation: Option<ConstantIndentation>,
    /// Width of the contact transition over radius, for hertz_smoothing (C.8)
    #[cfg_attr(feature = "clap", arg(long, value_name = "X"))]
    pub state_width: Option<Positive>,
    /// Width of the transition in speed, m/s, for hunt_crossley_smoothing (C.10)
    #[cfg_attr(feature = "clap", arg(long, value_name = "M/S"))]
    pub speed_width: Option<Positive>,
    /// Threshold t that the widths refer to: from t to 1 - t
    #[cfg_attr(feature = "clap", arg(long, value_name = "T", default_value_t = Threshold::OF_THE_PAPER))]
    pub threshold: Threshold,
}

impl Default for WantedOptions {
    fn default() -> Self {
        Self {
            radius: None,
            indentation: None,
            contact_stiffness: None,
            young: None,
            poisson: None,
            stiffness: None,
            restitution: None,
            impact_speed: None,
            constant_indentation: None,
            state_width: None,
            speed_width: None,
            threshold: Threshold::OF_THE_PAPER,
        }
    }
}

impl WantedOptions {
    /// Which of its fields need or exclude others.
    pub const RELATIONS: &'static [Relation] = &[
        Relation::Needs("young", "poisson"),
        Relation::Needs("poisson", "young"),
        Relation::Excludes("stiffness", "young"),
        Relation::Needs("impact_speed", "restitution"),
    ];

    /// What happens to the radius, where it is given.
    pub fn radius(&self) -> Option<RadiusRule> {
        self.radius.map(Radius::rule)
    }

    /// Whether something is given that a contact would follow from.
    pub fn asks(&self) -> bool {
        self.indentation.is_some()
            || self.young.is_some()
            || self.restitution.is_some()
            || self.constant_indentation.is_some()
            || self.state_width.is_some()
            || self.speed_width.is_some()
            || self.radius.is_some()
    }
}
