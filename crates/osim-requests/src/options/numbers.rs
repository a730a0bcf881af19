//! Numbers of contacts that are new, where no reference gives them.

use osim_model::Property;
#[cfg(feature = "schemas")]
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::WantedOptions;
use crate::relation::Relation;
use crate::values::{
    ConstantIndentation, NotNegative, PoissonRatio, Positive, RelativeIndentation, RestitutionCoefficient,
    Threshold,
};

/// What is wanted of contacts that are new.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema))]
#[cfg_attr(feature = "clap", derive(clap::Args), command(next_help_heading = "Numbers without a reference"))]
#[serde(default)]
pub struct NumberOptions {
    /// Relative indentation x/R under the load, 0 to 1 (11)
    #[cfg_attr(feature = "clap", arg(long, value_name = "X"))]
    pub indentation: Option<RelativeIndentation>,
    /// Young's modulus, N/m2 (A.1, A.5)
    #[cfg_attr(feature = "clap", arg(long, value_name = "E"))]
    pub young: Option<Positive>,
    /// Poisson's ratio
    #[cfg_attr(feature = "clap", arg(long, value_name = "NU", allow_hyphen_values = true))]
    pub poisson: Option<PoissonRatio>,
    /// Coefficient of restitution, 0 to 1 (13)
    #[cfg_attr(feature = "clap", arg(long, value_name = "CR"))]
    pub restitution: Option<RestitutionCoefficient>,
    /// Impact speed, m/s [default: sqrt(gR/2), a fall from a quarter of the radius]
    #[cfg_attr(feature = "clap", arg(long, value_name = "M/S", hide_short_help = true))]
    pub impact_speed: Option<Positive>,
    /// Constant indentation over radius, for constant_contact_force (C.2)
    #[cfg_attr(feature = "clap", arg(long, value_name = "X", hide_short_help = true))]
    pub constant_indentation: Option<ConstantIndentation>,
    /// Width of the contact transition over radius, for hertz_smoothing (C.8)
    #[cfg_attr(feature = "clap", arg(long, value_name = "X", hide_short_help = true))]
    pub state_width: Option<Positive>,
    /// Width of the transition in speed, m/s, for hunt_crossley_smoothing (C.10)
    #[cfg_attr(feature = "clap", arg(long, value_name = "M/S", hide_short_help = true))]
    pub speed_width: Option<Positive>,
    /// Threshold t that the widths refer to: from t to 1 - t
    #[cfg_attr(feature = "clap", arg(long, value_name = "T", default_value_t = Threshold::OF_THE_PAPER, hide_short_help = true))]
    pub threshold: Threshold,
    /// Static friction of the new forces [default: the reference's, else OpenSim's]
    #[cfg_attr(feature = "clap", arg(long, value_name = "MU", allow_hyphen_values = true))]
    pub static_friction: Option<NotNegative>,
    /// Their dynamic friction [default: the reference's, else OpenSim's]
    #[cfg_attr(feature = "clap", arg(long, value_name = "MU", allow_hyphen_values = true))]
    pub dynamic_friction: Option<NotNegative>,
    /// Their viscous friction, s/m [default: the reference's, else OpenSim's]
    #[cfg_attr(feature = "clap", arg(long, value_name = "S_PER_M", hide_short_help = true))]
    pub viscous_friction: Option<NotNegative>,
    /// Their transition velocity, m/s [default: the reference's, else OpenSim's]
    #[cfg_attr(feature = "clap", arg(long, value_name = "M/S", hide_short_help = true))]
    pub transition_velocity: Option<Positive>,
}

impl Default for NumberOptions {
    fn default() -> Self {
        Self {
            indentation: None,
            young: None,
            poisson: None,
            restitution: None,
            impact_speed: None,
            constant_indentation: None,
            state_width: None,
            speed_width: None,
            threshold: Threshold::OF_THE_PAPER,
            static_friction: None,
            dynamic_friction: None,
            viscous_friction: None,
            transition_velocity: None,
        }
    }
}

impl NumberOptions {
    /// Which of its fields need or exclude others.
    pub const RELATIONS: &'static [Relation] = &[
        Relation::Needs("young", "poisson"),
        Relation::Needs("poisson", "young"),
        Relation::Excludes("indentation", "young"),
        Relation::Needs("impact_speed", "restitution"),
        // A reference has numbers of its own.
        Relation::Excludes("indentation", "from"),
        Relation::Excludes("young", "from"),
        Relation::Excludes("restitution", "from"),
        Relation::Excludes("constant_indentation", "from"),
        Relation::Excludes("state_width", "from"),
        Relation::Excludes("speed_width", "from"),
    ];

    /// The same as a design has it.
    pub fn wanted(&self) -> WantedOptions {
        WantedOptions {
            indentation: self.indentation,
            young: self.young,
            poisson: self.poisson,
            restitution: self.restitution,
            impact_speed: self.impact_speed,
            constant_indentation: self.constant_indentation,
            state_width: self.state_width,
            speed_width: self.speed_width,
            threshold: self.threshold,
            ..WantedOptions::default()
        }
    }

    /// Each friction property with its value, if given.
    pub fn friction(&self) -> [(Property, Option<f64>); 4] {
        [
            (Property::StaticFriction, self.static_friction.map(NotNegative::get)),
            (Property::DynamicFriction, self.dynamic_friction.map(NotNegative::get)),
            (Property::ViscousFriction, self.viscous_friction.map(NotNegative::get)),
            (Property::TransitionVelocity, self.transition_velocity.map(Positive::get)),
        ]
    }
}
