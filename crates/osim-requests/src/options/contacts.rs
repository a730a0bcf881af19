//! Options with numbers of a contact: wanted or known numbers, numbers of new contacts, and numbers of a fall.

use contact_scaling::SmoothingValues;
use osim_model::messages::{Input, phrase};
use osim_model::{Property, RadiusRule};
use serde::{Deserialize, Serialize};

use crate::fault::{Relation, RequestFault};
use crate::values::{
    Acceleration, ConstantIndentation, Height, NotNegative, PoissonRatio, Positive, Radius,
    RelativeIndentation, RestitutionCoefficient, Threshold,
};

/// Options for the contact that is wanted, or for what is known of it.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[serde(default)]
pub struct WantedOptions {
    pub radius: Option<Radius>,
    pub indentation: Option<RelativeIndentation>,
    pub contact_stiffness: Option<Positive>,
    pub young: Option<Positive>,
    pub poisson: Option<PoissonRatio>,
    pub stiffness: Option<Positive>,
    pub restitution: Option<RestitutionCoefficient>,
    pub impact_speed: Option<Positive>,
    pub constant_indentation: Option<ConstantIndentation>,
    pub state_width: Option<Positive>,
    pub speed_width: Option<Positive>,
    pub threshold: Threshold,
}

impl WantedOptions {
    /// Conditions between the options for a wanted contact.
    pub(crate) const RELATIONS: &'static [Relation] = &[
        Relation::Needs("young", "poisson"),
        Relation::Needs("poisson", "young"),
        Relation::Excludes("stiffness", "young"),
        Relation::Needs("impact_speed", "restitution"),
    ];

    /// The rule for the radius, if given.
    pub fn radius(&self) -> Option<RadiusRule> {
        self.radius.map(Radius::rule)
    }

    /// Whether an option is given from which a contact can be computed.
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

/// Options for the numbers of new contacts.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[serde(default)]
pub struct NumberOptions {
    pub indentation: Option<RelativeIndentation>,
    pub young: Option<Positive>,
    pub poisson: Option<PoissonRatio>,
    pub restitution: Option<RestitutionCoefficient>,
    pub impact_speed: Option<Positive>,
    pub constant_indentation: Option<ConstantIndentation>,
    pub state_width: Option<Positive>,
    pub speed_width: Option<Positive>,
    pub threshold: Threshold,
    pub static_friction: Option<NotNegative>,
    pub dynamic_friction: Option<NotNegative>,
    pub viscous_friction: Option<NotNegative>,
    pub transition_velocity: Option<Positive>,
}

impl NumberOptions {
    /// Conditions between the options for the numbers of new contacts.
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
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[serde(default)]
pub struct ContactNumbers {
    pub radius: Option<Positive>,
    pub stiffness: Option<Positive>,
    pub dissipation: Option<NotNegative>,
    pub constant_contact_force: Option<NotNegative>,
    pub hertz_smoothing: Option<Positive>,
    pub hunt_crossley_smoothing: Option<Positive>,
    pub gravity: Option<Acceleration>,
}

impl ContactNumbers {
    /// The given inputs that describe the contact itself, without gravity.
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

    /// The smoothing of the contact, if given.
    ///
    /// # Errors
    /// Only one or two of the three smoothing numbers are given.
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

    /// Gravity in the contact's numbers, if given.
    pub fn gravity(&self) -> Option<f64> {
        self.gravity.map(Acceleration::get)
    }
}

/// The fall that drops and heat maps are about.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[serde(default)]
pub struct FallOptions {
    pub height: Height,
    pub duration: Option<Positive>,
}
