//! A figure beside its limit.

use contact_scaling::limits;
use schemars::JsonSchema;
use serde::Serialize;

/// One figure and its limit.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
#[non_exhaustive]
pub struct LimitCheck {
    /// Which figure.
    pub figure: Figure,
    /// Its value; `None` where (13) is below 0.
    pub value: Option<f64>,
    /// The limit, in the figure's own unit.
    pub limit: f64,
    /// Whether the figure is within it.
    #[serde(rename = "holds")]
    pub within_limit: bool,
}

/// A figure that has a limit.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
#[non_exhaustive]
pub enum Figure {
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
    #[must_use]
    pub fn limit_text(self) -> String {
        match self {
            Self::Restitution => format!(">= {}", limits::HUNT_CROSSLEY_RESTITUTION),
            Self::ConstantIndentation => format!("<= {}", limits::CONSTANT_INDENTATION),
            Self::TransitionWidth => format!("<= {}", limits::TRANSITION_WIDTH),
            Self::TouchingShare => format!("<= {}", limits::TOUCHING_SHARE),
            _ => format!("<= {}", limits::HERTZ_RELATIVE_INDENTATION),
        }
    }
}
