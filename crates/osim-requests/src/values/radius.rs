//! What happens to radii, in words.

use std::fmt;
use std::str::FromStr;

use osim_model::RadiusRule;
use osim_model::messages::shortest;
#[cfg(feature = "schemas")]
use schemars::JsonSchema;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::serial::from_text;
use crate::values::typed::{LENGTHS, factor, positive};

/// `isometric`, `keep`, metres, or a factor such as `x1.5`.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "schemas", derive(JsonSchema), schemars(inline))]
pub struct Radius(#[cfg_attr(feature = "schemas", schemars(schema_with = "number_or_text"))] RadiusRule);

#[cfg(feature = "schemas")]
fn number_or_text(_generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
    schemars::json_schema!({"anyOf": [
        {"type": "number", "exclusiveMinimum": 0, "description": "metres"},
        {"type": "string", "pattern": "^(isometric|keep|[xX][0-9.eE+-]+)$"},
    ]})
}

impl Radius {
    /// The rule.
    #[must_use]
    pub const fn rule(self) -> RadiusRule {
        self.0
    }
}

impl From<RadiusRule> for Radius {
    fn from(rule: RadiusRule) -> Self {
        Self(rule)
    }
}

impl FromStr for Radius {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let rule = match (text, factor(text)) {
            ("isometric", _) => Ok(RadiusRule::Isometric),
            ("keep", _) => Ok(RadiusRule::Keep),
            (_, Some(number)) => positive(number, "a factor like x1.5", &[]).map(RadiusRule::Factor),
            (_, None) => positive(text, "isometric, keep, a radius in metres or a factor like x1.5", LENGTHS)
                .map(RadiusRule::Metres),
        };
        rule.map(Self)
    }
}

impl fmt::Display for Radius {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            RadiusRule::Isometric => f.write_str("isometric"),
            RadiusRule::Metres(metres) => f.write_str(&shortest(metres)),
            RadiusRule::Factor(factor) => write!(f, "x{}", shortest(factor)),
            _ => f.write_str("keep"),
        }
    }
}

impl Serialize for Radius {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self.0 {
            RadiusRule::Metres(metres) => serializer.serialize_f64(metres),
            _ => serializer.collect_str(self),
        }
    }
}

impl<'d> Deserialize<'d> for Radius {
    fn deserialize<D: Deserializer<'d>>(deserializer: D) -> Result<Self, D::Error> {
        from_text(deserializer)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_radius_is_a_word_metres_or_a_factor() {
        for (text, rule) in [
            ("isometric", RadiusRule::Isometric),
            ("keep", RadiusRule::Keep),
            ("x1.5", RadiusRule::Factor(1.5)),
            ("0.032", RadiusRule::Metres(0.032)),
        ] {
            let radius: Radius = text.parse().unwrap();
            assert_eq!((radius.rule(), radius.to_string().as_str()), (rule, text));
            let json = serde_json::to_string(&radius).unwrap();
            assert_eq!(serde_json::from_str::<Radius>(&json).unwrap(), radius);
        }
        for (text, hint) in [
            ("32mm", "type 0.032"),
            ("3.2cm", "type 0.032"),
            ("3.2 CM", "type 0.032"),
            ("0.032m", "type 0.032"),
            ("1500um", "type 0.0015"),
            // An inch is 0.0254 m.
            ("1.5in", "type 0.0381"),
            ("2ft", "units are not written here"),
        ] {
            let refused = text.parse::<Radius>().unwrap_err();
            assert!(refused.contains(hint), "{text}: {refused}");
        }
    }
}
