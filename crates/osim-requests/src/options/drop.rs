//! A fall, and a contact that is given by its numbers.

use contact_scaling::SmoothingValues;
use osim_model::messages::{Input, phrase};
#[cfg(feature = "schemas")]
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::fault::RequestFault;
use crate::values::{Acceleration, Height, NotNegative, Positive};

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
