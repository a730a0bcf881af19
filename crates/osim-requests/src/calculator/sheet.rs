//! The figures of a design, as data.

use contact_scaling::limits::Limit;
use osim_inspect::SCHEMA_VERSION;
use schemars::JsonSchema;
use serde::Serialize;

/// Every figure that follows from what is known. Serialised it is the JSON contract of `design` without a model;
/// `docs/json.md` describes it.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
#[non_exhaustive]
pub struct DesignSheet {
    /// Raised when a field changes its meaning or goes away.
    pub schema_version: u32,
    /// The figures, in the order in which they follow.
    pub figures: Vec<DesignFigure>,
    /// Things to know about them.
    pub notes: Vec<String>,
}

/// One figure.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
#[non_exhaustive]
pub struct DesignFigure {
    /// Its name, with its unit.
    pub name: &'static str,
    /// Its value.
    #[schemars(with = "Option<f64>")]
    pub value: f64,
    /// Its unit, for people.
    pub unit: &'static str,
    /// Number of the equation in the paper, or a word where there is none.
    pub equation: &'static str,
    /// It was said, and does not follow.
    pub given: bool,
    /// Its limit, where it has one.
    pub limit: Option<DesignLimit>,
}

/// The limit of a figure.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
#[non_exhaustive]
pub struct DesignLimit {
    /// In words.
    pub text: String,
    /// Whether the figure is within it.
    pub within_limit: bool,
}

impl DesignSheet {
    pub(super) fn new() -> Self {
        Self { schema_version: SCHEMA_VERSION, figures: Vec::new(), notes: Vec::new() }
    }

    pub(super) fn add(
        &mut self,
        name: &'static str,
        value: f64,
        unit: &'static str,
        equation: &'static str,
        given: bool,
    ) {
        self.figures.push(DesignFigure { name, value, unit, equation, given, limit: None });
    }

    /// Gives the last figure a limit.
    pub(super) fn limited(&mut self, limit: &Limit) {
        if let Some(figure) = self.figures.last_mut() {
            let within_limit = limit.admits(figure.value);
            figure.limit = Some(DesignLimit { text: limit.in_words(), within_limit });
        }
    }
}
