//! Numbers of a contact: those that are wanted or known, those of new contacts, and those of a fall.

use contact_scaling::SmoothingValues;
use osim_model::messages::{Input, phrase};
use osim_model::{Property, RadiusRule};
#[cfg(feature = "schemas")]
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::fault::{Relation, RequestFault};
use crate::values::{
    Acceleration, ConstantIndentation, Height, NotNegative, PoissonRatio, Positive, Radius,
    RelativeIndentation, RestitutionCoefficient, Threshold,
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
    pub(crate) const RELATIONS: &'static [Relation] = &[
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

// Numbers of contacts that are new, where no reference gives them.

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
    pub(crate) const RELATIONS: &'static [Relation] = &[
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

// A fall, and a contact that is given by its numbers.

/// A contact given by its numbers.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema))]
#[cfg_attr(
    feature = "clap",
    derive(clap::Args),
    command(next_help_heading = "Without a model (with `mass` and `spheres`)")
)]
#[serde(default)]
pub struct ContactNumbers {
    /// Sphere radius, m
    #[cfg_attr(feature = "clap", arg(long, value_name = "M"))]
    pub radius: Option<Positive>,
    /// OpenSim's stiffness (plane strain modulus of one surface), N/m2
    #[cfg_attr(feature = "clap", arg(long, value_name = "E1"))]
    pub stiffness: Option<Positive>,
    /// OpenSim's dissipation, s/m
    #[cfg_attr(feature = "clap", arg(long, value_name = "A"))]
    pub dissipation: Option<NotNegative>,
    /// With the next two: SmoothSphereHalfSpaceForce's law, m2
    #[cfg_attr(feature = "clap", arg(long, value_name = "CF"))]
    pub constant_contact_force: Option<NotNegative>,
    /// 1/m
    #[cfg_attr(feature = "clap", arg(long, value_name = "BD"))]
    pub hertz_smoothing: Option<Positive>,
    /// s/m
    #[cfg_attr(feature = "clap", arg(long, value_name = "BV"))]
    pub hunt_crossley_smoothing: Option<Positive>,
    /// Gravity, m/s2 [default: the model's, else 9.80665]
    #[cfg_attr(feature = "clap", arg(long, value_name = "G"))]
    pub gravity: Option<Acceleration>,
}

impl ContactNumbers {
    /// The numbers that are given of the contact itself.
    pub fn given(&self) -> Vec<Input> {
        let all = [
            (Input::Radius, self.radius.is_some()),
            (Input::Stiffness, self.stiffness.is_some()),
            (Input::Dissipation, self.dissipation.is_some()),
            (Input::ConstantContactForce, self.constant_contact_force.is_some()),
            (Input::HertzSmoothing, self.hertz_smoothing.is_some()),
            (Input::HuntCrossleySmoothing, self.hunt_crossley_smoothing.is_some()),
        ];
        all.into_iter().filter(|(_, given)| *given).map(|(input, _)| input).collect()
    }

    /// The smoothing, where it is given.
    ///
    /// # Errors
    /// Some of its three numbers are missing.
    pub fn smoothing(&self) -> Result<Option<SmoothingValues>, RequestFault> {
        match (self.constant_contact_force, self.hertz_smoothing, self.hunt_crossley_smoothing) {
            (None, None, None) => Ok(None),
            (Some(cf), Some(bd), Some(bv)) => Ok(Some(SmoothingValues {
                constant_contact_force: cf.get(),
                hertz_smoothing: bd.get(),
                hunt_crossley_smoothing: bv.get(),
            })),
            _ => Err(RequestFault::general(phrase![
                "the smoothed law needs all of ",
                Input::ConstantContactForce,
                ", ",
                Input::HertzSmoothing,
                ", ",
                Input::HuntCrossleySmoothing,
            ])),
        }
    }

    /// Gravity, if given.
    pub fn gravity(&self) -> Option<f64> {
        self.gravity.map(Acceleration::get)
    }
}

/// The fall that drops and heat maps are about.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema))]
#[cfg_attr(feature = "clap", derive(clap::Args), command(next_help_heading = "The fall (drop, loop, sweep)"))]
#[serde(default)]
pub struct FallOptions {
    /// Height of the sphere bottoms at the start: metres, or a factor of the radius like x0.25
    #[cfg_attr(feature = "clap", arg(long, value_name = "HEIGHT", default_value_t))]
    pub height: Height,
    /// How long to follow the body, s [default: 20 sqrt(R/g), of the slowest]
    #[cfg_attr(feature = "clap", arg(long, value_name = "S"))]
    pub duration: Option<Positive>,
}
