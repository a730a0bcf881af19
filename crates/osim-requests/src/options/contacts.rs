//! Options with numbers of a contact: wanted or known numbers, numbers of new contacts, and numbers of a fall.

use contact_scaling::SmoothingValues;
use osim_model::messages::{Input, phrase};
use osim_model::{Property, RadiusRule};

use crate::values::serial::fields;
use crate::{
    Acceleration, ConstantIndentation, DropHeight, NotNegative, PoissonRatio, Positive, Radius,
    RelativeIndentation, RequestFault, RestitutionCoefficient, Threshold,
};

fields! {
    /// Options for the contact that is wanted, or for what is known of it.
    struct WantedOptions {
        radius: Option<Radius>,
        indentation: Option<RelativeIndentation>,
        contact_stiffness: Option<Positive>,
        young: Option<Positive>,
        poisson: Option<PoissonRatio>,
        stiffness: Option<Positive>,
        restitution: Option<RestitutionCoefficient>,
        impact_speed: Option<Positive>,
        constant_indentation: Option<ConstantIndentation>,
        state_width: Option<Positive>,
        speed_width: Option<Positive>,
        threshold: Threshold,
    } where
        Needs("young", "poisson"), Needs("poisson", "young"), Excludes("stiffness", "young"),
        Needs("impact_speed", "restitution");

    /// Options for the numbers of new contacts.
    struct NumberOptions {
        indentation: Option<RelativeIndentation>,
        young: Option<Positive>,
        poisson: Option<PoissonRatio>,
        restitution: Option<RestitutionCoefficient>,
        impact_speed: Option<Positive>,
        constant_indentation: Option<ConstantIndentation>,
        state_width: Option<Positive>,
        speed_width: Option<Positive>,
        threshold: Threshold,
        static_friction: Option<NotNegative>,
        dynamic_friction: Option<NotNegative>,
        viscous_friction: Option<NotNegative>,
        transition_velocity: Option<NotNegative>,
    } where
        Needs("young", "poisson"), Needs("poisson", "young"), Excludes("indentation", "young"),
        Needs("impact_speed", "restitution"), Excludes("indentation", "from"), Excludes("young", "from"),
        Excludes("restitution", "from"), Excludes("constant_indentation", "from"),
        Excludes("state_width", "from"), Excludes("speed_width", "from");

    /// A contact given by its numbers.
    struct ContactNumbers {
        radius: Option<Positive>,
        stiffness: Option<Positive>,
        dissipation: Option<NotNegative>,
        constant_contact_force: Option<NotNegative>,
        hertz_smoothing: Option<Positive>,
        hunt_crossley_smoothing: Option<Positive>,
        gravity: Option<Acceleration>,
    }

    /// The fall that drops and heat maps are about.
    struct FallOptions {
        height: DropHeight,
        duration: Option<Positive>,
    }
}

impl WantedOptions {
    /// The rule for the radius, if one is given and it is not that radii follow bodies.
    pub fn radius(&self) -> Option<RadiusRule> {
        self.radius.and_then(Radius::rule)
    }

    /// Whether an option is given from which a contact can be computed.
    pub fn has_design(&self) -> bool {
        self.indentation.is_some()
            || self.young.is_some()
            || self.restitution.is_some()
            || self.constant_indentation.is_some()
            || self.state_width.is_some()
            || self.speed_width.is_some()
            || self.radius.is_some()
    }
}

impl NumberOptions {
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
            (Property::TransitionVelocity, self.transition_velocity.map(NotNegative::get)),
        ]
    }
}

impl ContactNumbers {
    /// The given inputs that describe the contact itself, without gravity.
    pub fn given_inputs(&self) -> Vec<Input> {
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
                "the smoothed law needs all of {}, {}, {}";
                Input::ConstantContactForce, Input::HertzSmoothing, Input::HuntCrossleySmoothing
            ])),
        }
    }

    /// Gravity in the contact's numbers, if given.
    pub fn gravity(&self) -> Option<f64> {
        self.gravity.map(Acceleration::get)
    }
}
