//! Limits of an axis, in words.

use std::fmt;
use std::str::FromStr;

use osim_model::messages::shortest;
#[cfg(feature = "schemas")]
use schemars::JsonSchema;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::serial::from_text;
use crate::values::typed::{plain, trimmed};

/// From one number to a larger one: `FROM..TO`.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "schemas", derive(JsonSchema), schemars(inline, with = "String"))]
pub struct Span {
    from: f64,
    to: f64,
}

impl Span {
    /// Both ends, the smaller one first.
    #[must_use]
    pub const fn ends(self) -> (f64, f64) {
        (self.from, self.to)
    }
}

impl FromStr for Span {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let ends =
            text.split_once("..").and_then(|(from, to)| Some((plain(trimmed(from))?, plain(trimmed(to))?)));
        match ends {
            Some((from, to)) if from.is_finite() && to.is_finite() && from < to => Ok(Self { from, to }),
            _ => Err("expected FROM..TO like -0.1..0.5, the smaller number first".to_owned()),
        }
    }
}

impl fmt::Display for Span {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}..{}", shortest(self.from), shortest(self.to))
    }
}

impl Serialize for Span {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

impl<'d> Deserialize<'d> for Span {
    fn deserialize<D: Deserializer<'d>>(deserializer: D) -> Result<Self, D::Error> {
        from_text(deserializer)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_span_rises() {
        let span: Span = " -0.1 .. 0.5".parse().unwrap();
        assert_eq!((span.ends(), span.to_string().as_str()), ((-0.1, 0.5), "-0.1..0.5"));
        for refused in
            ["0.5..0.1", "1..1", "1", "..1", "1..", "a..b", "1..inf", "0..1e999", "1..2..3", "1..2/3"]
        {
            assert!(refused.parse::<Span>().is_err(), "{refused}");
        }
    }
}
