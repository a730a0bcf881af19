//! Axes of a grid as texts, such as `stiffness=x0.1,x1,x10`, with their values and limits.

use std::collections::HashSet;
use std::fmt;
use std::str::FromStr;

use osim_model::messages::shortest;
use osim_model::{Assignment, Property};
use serde::de::Error;
use serde::{Deserialize, Deserializer};
use serde_json::Value;

use crate::values::assignment::assignment;
use crate::values::serial::{Texts, values_as_text};
use crate::values::typed_numbers::{
    TypedRange, advice_about_colons, factor, log_spaced, plain_number, positive_number, respell_colons,
    trimmed,
};

/// The largest number of values of a grid.
const MOST_GRID_VALUES: u32 = 100_000;

/// The quantity that varies along an axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum AxisName {
    /// A property of contacts, by OpenSim's name.
    Property(Property),
    /// Relative indentation under the load (11).
    Indentation,
    /// Coefficient of restitution (13).
    Restitution,
    /// Mass that the contacts are made for, kg.
    TargetMass,
}

impl AxisName {
    /// The axis in the form `NAME=FROM..TO/COUNT` that the caller probably meant by the option or argument `name`; `None` if
    /// `values` is not a range, or `name` is not an axis.
    pub fn suggested_axis(name: &str, values: &str) -> Option<String> {
        let name: Self = name.replace('-', "_").parse().ok()?;
        let is_axis = TypedRange::is_meant(values) || values.contains(',');
        let values = respell_colons(values).or_else(|| is_axis.then(|| values.to_owned()))?;
        let axis = format!("{}={values}", name.as_str());
        axis.parse::<Axis>().is_ok().then_some(axis)
    }

    pub fn as_str(self) -> &'static str {
        match self {
            Self::Property(property) => property.as_str(),
            Self::Indentation => "indentation",
            Self::Restitution => "restitution",
            Self::TargetMass => "target_mass",
        }
    }
}

impl FromStr for AxisName {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text {
            "indentation" => Ok(Self::Indentation),
            "restitution" => Ok(Self::Restitution),
            "target-mass" | "target_mass" => Ok(Self::TargetMass),
            other => other.parse().map(Self::Property).map_err(|why: String| match why.ends_with('?') {
                true => why,
                false => format!("{why}; or indentation, restitution, target_mass"),
            }),
        }
    }
}

/// One value of an axis.
#[derive(Debug, Clone, PartialEq)]
pub struct GridValue {
    /// The value in file names and notes: as typed, or with six digits.
    pub label: String,
    /// The value as a number.
    pub number: f64,
    /// Whether the value is a factor for the present value of the model.
    pub is_factor: bool,
}

impl GridValue {
    /// The exact number, with `x` before a factor.
    pub fn exact(&self) -> String {
        format!("{}{}", if self.is_factor { "x" } else { "" }, shortest(self.number))
    }
}

/// An axis of a grid: `NAME=V,V,...`; each `V` is a value, a factor or a range `FROM..TO/COUNT`.
#[derive(Debug, Clone, PartialEq)]
pub struct Axis {
    /// The quantity that varies.
    pub name: AxisName,
    /// Values of the axis, each once.
    pub values: Vec<GridValue>,
    /// The axis as the caller wrote it.
    text: String,
}

impl FromStr for Axis {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let expected = "expected NAME=V,V,... such as stiffness=x0.1,x1,x10 or stiffness=x0.1..x10/9";
        let (name, list) = text.split_once('=').ok_or(expected)?;
        let name: AxisName = trimmed(name).parse()?;
        let mut values = Vec::new();
        for item in list.split(',') {
            if let Some(answer) = advice_about_colons(item) {
                return Err(answer);
            }
            if TypedRange::is_meant(item) {
                values.extend(axis_range(name, item)?);
            } else {
                values.push(axis_value(name, trimmed(item))?);
            }
        }
        // Two values that differ only after the sixth digit would have one file.
        let (mut exact, mut labels) = (HashSet::new(), HashSet::new());
        for value in &values {
            if !exact.insert(value.exact()) || !labels.insert(value.label.as_str()) {
                return Err(format!("{} appears twice", value.label));
            }
        }
        Ok(Self { name, values, text: text.to_owned() })
    }
}

impl fmt::Display for Axis {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

fn axis_value(name: AxisName, text: &str) -> Result<GridValue, String> {
    let (number, is_factor) = match name {
        AxisName::Property(property) => match assignment(property.as_str(), text)?.1 {
            Assignment::Factor(number) => (number, true),
            Assignment::Value(number) => (number, false),
        },
        // What design and rescale take is checked by them; here it must be a number.
        _ => (positive_number(text)?, false),
    };
    Ok(GridValue { label: text.to_owned(), number, is_factor })
}

/// All values of a range; both ends keep the digits that were typed.
fn axis_range(name: AxisName, text: &str) -> Result<Vec<GridValue>, String> {
    let expected = || {
        format!(
            "expected a range FROM..TO/COUNT with numbers above 0 and a COUNT from 2 to {MOST_GRID_VALUES}, such as x0.1..x10/9"
        )
    };
    let range = TypedRange::read(text, MOST_GRID_VALUES)
        .filter(|range| range.are_factors().is_some())
        .ok_or_else(expected)?;
    let (first, last) = (axis_value(name, range.first)?, axis_value(name, range.last)?);
    if first.number <= 0.0 || last.number <= 0.0 {
        return Err(expected());
    }
    let x = if first.is_factor { "x" } else { "" };
    let mut values: Vec<GridValue> = log_spaced(first.number, last.number, range.count)
        .map(|number| GridValue {
            label: format!("{x}{}", six_digits(number)),
            number,
            is_factor: first.is_factor,
        })
        .collect();
    if let [begin, .., end] = values.as_mut_slice() {
        (*begin, *end) = (first, last);
    }
    Ok(values)
}

/// A number with six digits, which are enough to distinguish grid points in file names.
fn six_digits(number: f64) -> String {
    let rounded: f64 = format!("{number:.5e}").parse().unwrap_or(number);
    shortest(rounded)
}

/// Reads axes from texts, or from a map of axis names to a value, several values, or a range.
///
/// # Errors
/// A text or value that is not an axis.
pub fn deserialize<'d, D: Deserializer<'d>>(deserializer: D) -> Result<Vec<Axis>, D::Error> {
    let item = |value: &Value| match value {
        Value::String(text) => text.clone(),
        Value::Number(number) => number.as_f64().map(shortest).unwrap_or_default(),
        other => other.to_string(),
    };
    let axis = |(name, values): (String, Value)| -> Result<Axis, String> {
        let list = match &values {
            Value::Array(values) => values.iter().map(item).collect::<Vec<_>>().join(","),
            one => item(one),
        };
        format!("{name}={list}").parse()
    };
    match Value::deserialize(deserializer)? {
        Value::Object(axes) => axes.into_iter().map(axis).collect::<Result<_, _>>().map_err(D::Error::custom),
        texts => Texts::deserialize(texts).map_err(D::Error::custom),
    }
}

/// The schema of axes.
#[cfg(feature = "schemas")]
pub(crate) fn axes_schema(_generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
    schemars::json_schema!({"anyOf": [
        {"type": "string", "pattern": "="},
        {"type": "array", "items": {"type": "string", "pattern": "="}},
        {
            "type": "object",
            "additionalProperties": {"anyOf": [
                {"type": ["string", "number"]},
                {"type": "array", "items": {"type": ["string", "number"]}},
            ]},
        },
    ]})
}

// Values along an axis, and its limits, in words.

/// Values equally spaced on a logarithmic axis, as numbers or as factors of what is there: `FROM..TO/COUNT`, both ends with
/// an `x` for factors.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Grid {
    from: f64,
    to: f64,
    count: u32,
    factors: bool,
}

/// The largest number of points along an axis: more make a figure slow and show nothing more.
const MOST_VALUES_OF_PLOT_AXIS: u32 = 200;

impl Grid {
    /// An axis of factors from `from` to `to`.
    pub const fn factors(from: f64, to: f64, count: u32) -> Self {
        Self { from, to, count, factors: true }
    }

    /// The values of the axis; if they are factors, multiplied by the present value `now`.
    pub fn values(self, now: f64) -> Vec<f64> {
        let unit = if self.factors { now } else { 1.0 };
        log_spaced(self.from, self.to, self.count).map(|value| unit * value).collect()
    }
}

impl FromStr for Grid {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let expected = || {
            format!(
                "expected FROM..TO/COUNT like 1e5..1e7/25, or factors like x0.1..x10/25, and a COUNT from 2 to {MOST_VALUES_OF_PLOT_AXIS}"
            )
        };
        let range = TypedRange::read(text, u32::MAX)
            .ok_or_else(|| advice_about_colons(text).unwrap_or_else(expected))?;
        let Some(factors) = range.are_factors() else {
            return Err("both ends are numbers, or both are factors like x0.1..x10/25".to_owned());
        };
        let end = |text| positive_number(factor(text).unwrap_or(text));
        let (from, to, count) = (end(range.first)?, end(range.last)?, range.count);
        if from >= to {
            return Err("the first value must be below the last".to_owned());
        }
        if count > MOST_VALUES_OF_PLOT_AXIS {
            return Err(format!("expected 2 to {MOST_VALUES_OF_PLOT_AXIS} values"));
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

/// The range of numbers that an axis or the colours of a plot show, from one number to a larger one: `FROM..TO`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Span {
    from: f64,
    to: f64,
}

impl Span {
    /// Both ends of the range, the smaller one first.
    pub const fn ends(self) -> (f64, f64) {
        (self.from, self.to)
    }
}

impl FromStr for Span {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let ends = text
            .split_once("..")
            .and_then(|(from, to)| Some((plain_number(trimmed(from))?, plain_number(trimmed(to))?)));
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

values_as_text! {
    Grid = {"type": "string"};
    Span = {"type": "string"};
}

#[cfg(test)]
mod tests {
    use super::*;

    fn axis(text: &str) -> Axis {
        text.parse().unwrap()
    }

    #[test]
    fn a_range_is_equally_spaced_in_its_logarithm() {
        let axis = axis("stiffness=x0.1..x10/5");
        let labels: Vec<&str> = axis.values.iter().map(|value| value.label.as_str()).collect();
        assert_eq!(labels, ["x0.1", "x0.316228", "x1", "x3.16228", "x10"]);
        // sqrt(0.1) to 17 digits.
        assert!((axis.values[1].number - 0.316_227_766_016_837_94).abs() < 1e-16);
        assert_eq!((axis.values[0].number, axis.values[4].number), (0.1, 10.0));
        assert_eq!(axis.values[4].exact(), "x10");
    }

    #[test]
    fn a_text_that_is_not_an_axis_is_refused() {
        for text in [
            "stiffness",
            "stifness=1",
            "stiffness=1kPa",
            "stiffness=1,1",
            "stiffness=1e5,100000",
            "stiffness=x1..2/3",
            "stiffness=1..2/1",
            "stiffness=0..2/3",
            "stiffness=1..2",
            "indentation=x2",
            "stiffness=",
        ] {
            assert!(text.parse::<Axis>().is_err(), "{text}");
        }
    }

    #[test]
    fn json_names_axes_with_their_values() {
        let json = serde_json::json!({"stiffness": "x0.1..x10/5", "dissipation": [0.5, 1, "2"]});
        let axes = deserialize(json).unwrap();
        assert_eq!(axes, [axis("stiffness=x0.1..x10/5"), axis("dissipation=0.5,1,2")]);
    }

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
    fn a_span_has_its_start_below_its_end() {
        let span: Span = " -0.1 .. 0.5".parse().unwrap();
        assert_eq!((span.ends(), span.to_string().as_str()), ((-0.1, 0.5), "-0.1..0.5"));
        for refused in
            ["0.5..0.1", "1..1", "1", "..1", "1..", "a..b", "1..inf", "0..1e999", "1..2..3", "1..2/3"]
        {
            assert!(refused.parse::<Span>().is_err(), "{refused}");
        }
    }
}
