//! What is left of the Hertz force at rest, if a design gives enough of a smoothed contact.

use contact_scaling::sizing::{Known, Sizing, SizingError};
use contact_scaling::{SmoothingValues, restitution, smoothing};
use osim_model::messages::readable;
use osim_requests::options::WantedOptions;
use osim_requests::{Positive, RequestFault, RestitutionCoefficient};

use super::given::{Given, refused};

/// Turns in which a radius is found that dissipation and sizing both depend on; each brings it at least three times closer.
const TURNS: u32 = 60;

/// A smoothed contact at rest, as (C.9) has it at speed 0.
#[derive(Clone, Copy)]
pub(super) struct AtRest {
    /// The share of the Hertz force.
    pub(super) speed_state: f64,
    dissipation_s_m: f64,
    smoothing_s_m: f64,
    /// Whether the smoothing is OpenSim's, because none was given.
    is_default: bool,
}

impl AtRest {
    /// `None` where no smoothing is wanted, or no dissipation is known.
    fn of(
        wanted: &WantedOptions,
        radius_m: Option<f64>,
        gravity_m_s2: f64,
    ) -> Result<Option<Self>, RequestFault> {
        let width = wanted.speed_width.map(Positive::get);
        if width.is_none() && wanted.constant_indentation.is_none() && wanted.state_width.is_none() {
            return Ok(None);
        }
        let fall = || radius_m.map(|radius| restitution::drop_speed(gravity_m_s2, radius)).transpose();
        let speed = match wanted.impact_speed.map(Positive::get) {
            Some(speed) => Some(speed),
            None => fall().map_err(refused)?,
        };
        let target = wanted.restitution.map(RestitutionCoefficient::get);
        let Some((target, speed)) = target.zip(speed) else { return Ok(None) };
        let dissipation_s_m = restitution::dissipation(target, speed).map_err(refused)?;
        let threshold = wanted.threshold.get();
        let smoothing_s_m = match width {
            Some(width) => {
                smoothing::hunt_crossley_smoothing_for_speed_width(threshold, width).map_err(refused)?
            }
            None => SmoothingValues::OPENSIM_DEFAULT.hunt_crossley_smoothing,
        };
        let speed_state = smoothing::speed_state_at_rest(dissipation_s_m, smoothing_s_m).map_err(refused)?;
        Ok(Some(Self { speed_state, dissipation_s_m, smoothing_s_m, is_default: width.is_none() }))
    }

    /// Whether a number follows from it.
    pub(super) fn matters(self) -> bool {
        self.speed_state != 1.0
    }

    /// What to know about it where it is shown.
    pub(super) fn note(self) -> Option<String> {
        let share = readable(self.speed_state);
        let default = if self.is_default { " (OpenSim's default)" } else { "" };
        (share != "1").then(|| {
            format!(
                "at rest the smoothed force is {share} of the Hertz force, by (C.9) at speed 0 with dissipation {} and \
                 hunt_crossley_smoothing {}{default}; load, modulus and stiffness are made for that",
                readable(self.dissipation_s_m),
                readable(self.smoothing_s_m),
            )
        })
    }
}

/// The sizing, where enough is known for one, and the law at rest that it was made with.
///
/// # Errors
/// A number outside its domain, or numbers that contradict each other.
pub(super) fn solve(
    known: &Known,
    given: &Given,
    wanted: &WantedOptions,
) -> Result<(Option<Sizing>, Option<AtRest>), RequestFault> {
    let mut radius = given.radius_m;
    let mut found = (None, None);
    for _ in 0..TURNS {
        let at_rest = AtRest::of(wanted, radius, given.gravity_m_s2)?;
        let sizing = match known.solve_smoothed(at_rest.map_or(1.0, |known| known.speed_state)) {
            Ok(sizing) => Some(sizing),
            // Some figures need no sizing; whether anything is left to say is seen at the end.
            Err(SizingError::Insufficient { .. }) => None,
            Err(SizingError::Contradictory { quantity, given: said, follows }) => {
                return Err(given.contradiction(quantity, said, follows));
            }
            Err(error) => return Err(refused(error)),
        };
        found = (sizing, at_rest);
        let next = sizing.map(|sizing| sizing.radius_m).or(radius);
        if next == radius {
            break;
        }
        radius = next;
    }
    Ok(found)
}
