//! Figures against the limits of the paper.

use contact_scaling::limits;
use serde::Serialize;

use super::figures::SphereFigures;

/// One figure and its limit.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct Verdict {
    /// Which figure.
    pub figure: Figure,
    /// Its value; `None` where (13) is below 0.
    pub value: Option<f64>,
    /// The limit, in the figure's own unit.
    pub limit: f64,
    /// Whether the figure is within it.
    pub holds: bool,
}

/// A figure that has a limit.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum Figure {
    /// x̂ under its share of one body weight (Hertz): at most 0.16.
    Hertz,
    /// The same by the law of the file.
    Own,
    /// x̂ under two body weights (Hertz).
    HertzAtTwo,
    /// The same by the law of the file.
    OwnAtTwo,
    /// x̂ with all spheres level, one body weight (Hertz).
    LevelHertz,
    /// The same by the law of the file.
    LevelOwn,
    /// x̂ with all spheres level, two body weights (Hertz).
    LevelHertzAtTwo,
    /// The same by the law of the file.
    LevelOwnAtTwo,
    /// c_r by (13): at least 0.8.
    Restitution,
    /// √cf / R: at most 0.1.
    ConstantIndentation,
    /// Δx̂: at most 0.31.
    TransitionWidth,
    /// Force just touching over the share of the weight: at most 0.1.
    TouchingShare,
}

impl Figure {
    /// `>=` or `<=` and the limit, as the table shows it.
    pub(crate) fn limit_text(self) -> String {
        match self {
            Self::Restitution => format!(">= {}", limits::HUNT_CROSSLEY_RESTITUTION),
            Self::ConstantIndentation => format!("<= {}", limits::CONSTANT_INDENTATION),
            Self::TransitionWidth => format!("<= {}", limits::TRANSITION_WIDTH),
            Self::TouchingShare => format!("<= {}", limits::TOUCHING_SHARE),
            _ => format!("<= {}", limits::HERTZ_RELATIVE_INDENTATION),
        }
    }
}

/// A design that asks for a limit lands on it but for the last bits, which is within.
const LAST_BITS: f64 = 1e-9;

fn at_most(figure: Figure, value: Option<f64>, limit: f64) -> Option<Verdict> {
    value.map(|value| Verdict {
        figure,
        value: Some(value),
        limit,
        holds: value <= limit * (1.0 + LAST_BITS),
    })
}

/// Every figure of a sphere that has a limit, where it is known.
pub(super) fn verdicts(sphere: &SphereFigures, impact_speed: Option<f64>) -> Vec<Verdict> {
    let hertz = limits::HERTZ_RELATIVE_INDENTATION;
    let (one, two) = (sphere.load(1.0), sphere.load(2.0));
    let restitution = impact_speed.zip(sphere.dissipation_s_m).map(|_| {
        let (limit, value) = (limits::HUNT_CROSSLEY_RESTITUTION, sphere.restitution_approximate);
        let holds = value.is_some_and(|value| value >= limit * (1.0 - LAST_BITS));
        Verdict { figure: Figure::Restitution, value, limit, holds }
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

impl SphereFigures {
    /// Whether `figure` is within its limit; `None` where it is not known.
    pub(crate) fn holds(&self, figure: Figure) -> Option<bool> {
        self.limits.iter().find(|verdict| verdict.figure == figure).map(|verdict| verdict.holds)
    }
}
