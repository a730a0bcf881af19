//! The figures of a design, as data.

use std::borrow::Cow;

use osim_inspect::SCHEMA_VERSION;
#[cfg(feature = "schemas")]
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::Serialize;

use super::register::DesignQuantity;

/// Every figure that follows from what is known. Serialised it is the JSON contract of `design` without a model;
/// `docs/reference/json.md` describes it.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema), schemars(deny_unknown_fields))]
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
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema), schemars(deny_unknown_fields))]
#[non_exhaustive]
pub struct DesignFigure {
    /// What it is.
    #[serde(skip)]
    pub quantity: DesignQuantity,
    /// Its name, with its unit.
    #[cfg_attr(feature = "schemas", schemars(schema_with = "names"))]
    pub name: &'static str,
    /// Its value.
    #[cfg_attr(feature = "schemas", schemars(with = "Option<f64>"))]
    pub value: f64,
    /// Its unit, for people.
    pub unit: &'static str,
    /// Number of the equation in the paper, or a word where there is none.
    pub equation: Cow<'static, str>,
    /// It was given, and does not follow from other numbers.
    pub given: bool,
    /// Its limit, where it has one.
    pub limit: Option<DesignLimit>,
}

/// The limit of a figure.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema), schemars(deny_unknown_fields))]
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

    /// A figure by the equation of its quantity.
    pub(super) fn add(&mut self, quantity: DesignQuantity, value: f64, given: bool) {
        self.add_by(quantity.info().equation, quantity, value, given);
    }

    /// A figure that depends on the force at rest: by (C.9), too, if that is not the Hertz force.
    pub(super) fn add_at_rest(&mut self, smoothed: bool, quantity: DesignQuantity, value: f64, given: bool) {
        let equation = quantity.info().equation;
        let equation = if smoothed { format!("{equation}, C.9").into() } else { Cow::from(equation) };
        self.add_by(equation, quantity, value, given);
    }

    /// A figure by another equation than its quantity has as a rule.
    pub(super) fn add_by(
        &mut self,
        equation: impl Into<Cow<'static, str>>,
        quantity: DesignQuantity,
        value: f64,
        given: bool,
    ) {
        let info = quantity.info();
        let limit =
            info.limit.map(|limit| DesignLimit { text: limit.in_words(), within_limit: limit.admits(value) });
        let (name, unit, equation) = (info.name, info.unit, equation.into());
        self.figures.push(DesignFigure { quantity, name, value, unit, equation, given, limit });
    }
}

/// A name from the register.
#[cfg(feature = "schemas")]
fn names(_: &mut SchemaGenerator) -> Schema {
    let names: Vec<&str> = DesignQuantity::ALL.iter().map(|quantity| quantity.info().name).collect();
    json_schema!({"type": "string", "enum": names})
}
