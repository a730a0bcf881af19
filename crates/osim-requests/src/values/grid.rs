//! Values along an axis, and its limits, in words.

use std::fmt;
use std::str::FromStr;

use osim_model::messages::shortest;
#[cfg(feature = "schemas")]
use schemars::JsonSchema;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use crate::values::serial::from_text;
use crate::values::typed::{Range, factor, plain, positive_number, spaced, trimmed, with_colons};

/// Values equally spaced on a logarithmic axis, as numbers or as factors of what is there: `FROM..TO/COUNT`, both ends with
/// an `x` for factors.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "schemas", derive(JsonSchema), schemars(inline, with = "String"))]
pub struct Grid {
    from: f64,
    to: f64,
    count: u32,
    factors: bool,
}

/// More values than this make a figure slow and show nothing more.
const MOST: u32 = 200;

impl Grid {
    /// Factors from `from` to `to`.
    pub const fn factors(from: f64, to: f64, count: u32) -> Self {
        Self { from, to, count, factors: true }
    }

    /// The values; factors are multiplied by `now`.
    pub fn values(self, now: f64) -> Vec<f64> {
        let unit = if self.factors { now } else { 1.0 };
        spaced(self.from, self.to, self.count).map(|value| unit * value).collect()
    }
}

impl FromStr for Grid {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let expected = || {
            format!(
                "expected FROM..TO/COUNT like 1e5..1e7/25, or factors like x0.1..x10/25, and a COUNT from 2 to {MOST}"
            )
        };
        let range = Range::read(text, u32::MAX).ok_or_else(|| with_colons(text).unwrap_or_else(expected))?;
        let Some(factors) = range.are_factors() else {
            return Err("both ends are numbers, or both are factors like x0.1..x10/25".to_owned());
        };
        let end = |text| positive_number(factor(text).unwrap_or(text));
        let (from, to, count) = (end(range.first)?, end(range.last)?, range.count);
        if from >= to {
            return Err("the first value must be below the last".to_owned());
        }
        if count > MOST {
            return Err(format!("expected 2 to {MOST} values"));
        }
        Ok(Self { from, to, count, factors })
    }
}

impl fmt::Display for Grid {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let x = if self.factors { "x" } else { "" };
        write!(f, "{x}{}..{x}{}/{}", shortest(self.from), shortest(self.to), self.count)
    }
}

impl Serialize for Grid {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

impl<'d> Deserialize<'d> for Grid {
    fn deserialize<D: Deserializer<'d>>(deserializer: D) -> Result<Self, D::Error> {
        from_text(deserializer)
    }
}

/// From one number to a larger one: `FROM..TO`.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "schemas", derive(JsonSchema), schemars(inline, with = "String"))]
pub struct Span {
    from: f64,
    to: f64,
}

impl Span {
    /// Both ends, the smaller one first.
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

    fn grid(text: &str) -> Result<Grid, String> {
        text.parse()
    }

    #[test]
    fn a_grid_is_equally_spaced_on_a_logarithmic_axis() {
        let values = grid("x0.1..x10/3").unwrap().values(2e6);
        for (seen, expected) in values.iter().zip([2e5, 2e6, 2e7]) {
            assert!((seen / expected - 1.0).abs() < 1e-12, "{values:?}");
        }
        assert_eq!(values.len(), 3);
        assert_eq!(grid("1..4/2").unwrap().values(9.0).first(), Some(&1.0));
        assert_eq!(grid(" x0.1 .. x10/25").unwrap().to_string(), "x0.1..x10/25");
        for refused in
            ["1..4", "1/3", "4..1/3", "x1..4/3", "0..4/3", "1..4/1", "1..4/x", "1kg..4/3", "1..4/9999"]
        {
            assert!(grid(refused).is_err(), "{refused}");
        }
    }

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
