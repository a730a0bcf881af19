//! Figures against the limits of the paper.

use contact_scaling::limits;

use super::data::SphereFigures;
use super::limit_check::{Figure, LimitCheck};

/// A design that asks for a limit lands on it but for the last bits, which is within.
const LAST_BITS: f64 = 1e-9;

fn at_most(figure: Figure, value: Option<f64>, limit: f64) -> Option<LimitCheck> {
    value.map(|value| LimitCheck {
        figure,
        value: Some(value),
        limit,
        within_limit: value <= limit * (1.0 + LAST_BITS),
    })
}

/// Every figure of a sphere that has a limit, where it is known.
pub(super) fn limit_checks(sphere: &SphereFigures, impact_speed: Option<f64>) -> Vec<LimitCheck> {
    let hertz = limits::HERTZ_RELATIVE_INDENTATION;
    let (one, two) = (sphere.load(1.0), sphere.load(2.0));
    let restitution = impact_speed.zip(sphere.dissipation_s_m).map(|_| {
        let (limit, value) = (limits::HUNT_CROSSLEY_RESTITUTION, sphere.restitution_approximate);
        let within_limit = value.is_some_and(|value| value >= limit * (1.0 - LAST_BITS));
        LimitCheck { figure: Figure::Restitution, value, limit, within_limit }
    });
    let all = [
        at_most(Figure::Hertz, one.and_then(|load| load.hertz), hertz),
        at_most(Figure::Own, one.and_then(|load| load.own), hertz),
        at_most(Figure::LevelHertz, one.and_then(|load| load.level_hertz), hertz),
        at_most(Figure::LevelOwn, one.and_then(|load| load.level_own), hertz),
        at_most(Figure::HertzAtTwo, two.and_then(|load| load.hertz), hertz),
        at_most(Figure::OwnAtTwo, two.and_then(|load| load.own), hertz),
        at_most(Figure::LevelHertzAtTwo, two.and_then(|load| load.level_hertz), hertz),
        at_most(Figure::LevelOwnAtTwo, two.and_then(|load| load.level_own), hertz),
        restitution,
        at_most(Figure::ConstantIndentation, sphere.constant_indentation, limits::CONSTANT_INDENTATION),
        at_most(Figure::TransitionWidth, sphere.transition_width, limits::TRANSITION_WIDTH),
        at_most(Figure::TouchingShare, sphere.touching_share, limits::TOUCHING_SHARE),
    ];
    all.into_iter().flatten().collect()
}
