//! The points of a grid: every combination of the values of its axes.

use std::collections::HashSet;
use std::fmt;
use std::str::FromStr;

use osim_patch::{Assignment, Property, shortest};

use crate::args::{assignment, positive_number};

/// What varies along an axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Name {
    /// A property, by OpenSim's name.
    Property(Property),
    /// Relative indentation under the load (11).
    Indentation,
    /// Coefficient of restitution (13).
    Restitution,
    /// Mass the contacts stand for, kg.
    TargetMass,
}

impl Name {
    pub(crate) fn as_str(self) -> &'static str {
        match self {
            Self::Property(property) => property.name(),
            Self::Indentation => "indentation",
            Self::Restitution => "restitution",
            Self::TargetMass => "target-mass",
        }
    }
}

/// One value of an axis.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct GridValue {
    /// In names of files and in notes: as typed, or to six digits.
    pub label: String,
    pub number: f64,
    /// A factor of what the model has.
    pub is_factor: bool,
}

impl GridValue {
    /// The exact number, with `x` before a factor.
    pub(crate) fn exact(&self) -> String {
        format!("{}{}", if self.is_factor { "x" } else { "" }, shortest(self.number))
    }
}

/// `NAME=V,V,...`
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Axis {
    pub name: Name,
    pub values: Vec<GridValue>,
}

impl FromStr for Axis {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let expected = "expected NAME=V,V,... such as stiffness=x0.1,x1,x10 or stiffness=x0.1..x10/9";
        let (name, list) = text.split_once('=').ok_or(expected)?;
        let name = match name.trim() {
            "indentation" => Name::Indentation,
            "restitution" => Name::Restitution,
            "target-mass" => Name::TargetMass,
            other => Name::Property(
                other
                    .parse()
                    .map_err(|why: String| format!("{why}; or indentation, restitution, target-mass"))?,
            ),
        };
        let mut values = Vec::new();
        for item in list.split(',') {
            match item.split_once("..") {
                Some((first, rest)) => values.extend(range(name, first, rest)?),
                None => values.push(value(name, item.trim())?),
            }
        }
        // Two values that differ only behind the sixth digit would have one file.
        let (mut exact, mut labels) = (HashSet::new(), HashSet::new());
        for value in &values {
            if !exact.insert(value.exact()) || !labels.insert(value.label.as_str()) {
                return Err(format!("{} is there twice", value.label));
            }
        }
        Ok(Self { name, values })
    }
}

fn value(name: Name, text: &str) -> Result<GridValue, String> {
    let (number, is_factor) = match name {
        Name::Property(property) => match assignment(property.name(), text)?.1 {
            Assignment::Value(number) => (number, false),
            Assignment::Factor(number) => (number, true),
        },
        // What design and rescale take is checked by them; here it must be a number.
        _ => (positive_number(text)?, false),
    };
    Ok(GridValue { label: text.to_owned(), number, is_factor })
}

/// `A..B/N`: N numbers from A to B, equally far apart in their logarithms, both ends exact.
fn range(name: Name, first: &str, rest: &str) -> Result<Vec<GridValue>, String> {
    let expected =
        "expected a range FIRST..LAST/COUNT with numbers above 0 and 2 or more, such as x0.1..x10/9";
    let (last, count) = rest.split_once('/').ok_or(expected)?;
    let (first, last) = (value(name, first.trim())?, value(name, last.trim())?);
    let count =
        count.trim().parse::<u32>().ok().filter(|count| (2..=100_000).contains(count)).ok_or(expected)?;
    let unlike = first.is_factor != last.is_factor;
    if unlike || first.number <= 0.0 || last.number <= 0.0 {
        return Err(expected.to_owned());
    }
    let steps = f64::from(count - 1);
    let between = |index: u32| {
        let part = f64::from(index) / steps;
        let number = first.number * (last.number / first.number).powf(part);
        let label = format!("{}{}", if first.is_factor { "x" } else { "" }, six_digits(number));
        GridValue { label, number, is_factor: first.is_factor }
    };
    let inner = (1..count - 1).map(between);
    Ok(std::iter::once(first.clone()).chain(inner).chain(std::iter::once(last.clone())).collect())
}

/// Enough to tell points apart in a file's name.
fn six_digits(number: f64) -> String {
    let rounded: f64 = format!("{number:.5e}").parse().unwrap_or(number);
    shortest(rounded)
}

/// One combination of values.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Point<'g> {
    pub values: Vec<(Name, &'g GridValue)>,
}

impl fmt::Display for Point<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let each: Vec<String> =
            self.values.iter().map(|(name, value)| format!("{}={}", name.as_str(), value.label)).collect();
        f.write_str(&each.join(" "))
    }
}

impl Point<'_> {
    /// The point in a file's name.
    pub(crate) fn file_part(&self) -> String {
        let each = self.values.iter().map(|(name, value)| format!("{}-{}", name.as_str(), value.label));
        each.collect::<Vec<_>>().join("_")
    }
}

/// Number of points; `None` beyond counting.
pub(crate) fn count(axes: &[Axis]) -> Option<usize> {
    axes.iter().try_fold(1_usize, |count, axis| count.checked_mul(axis.values.len()))
}

/// Point `index` of all, the last axis fastest.
pub(crate) fn point(axes: &[Axis], index: usize) -> Point<'_> {
    let mut rest = index;
    let mut values = Vec::with_capacity(axes.len());
    for axis in axes.iter().rev() {
        let count = axis.values.len().max(1);
        if let Some(value) = axis.values.get(rest % count) {
            values.push((axis.name, value));
        }
        rest /= count;
    }
    values.reverse();
    Point { values }
}

/// Points at the ends of every axis, the others at their first value: where one value makes no sense, one of these does
/// not, because what a value may be is an interval.
pub(crate) fn ends(axes: &[Axis]) -> Vec<usize> {
    let mut indices = Vec::new();
    let mut stride = 1_usize;
    for axis in axes.iter().rev() {
        let numbers = || axis.values.iter().map(|value| value.number).enumerate();
        let least = numbers().min_by(|a, b| a.1.total_cmp(&b.1));
        let most = numbers().max_by(|a, b| a.1.total_cmp(&b.1));
        let ends = [least, most].into_iter().flatten();
        indices.extend(ends.map(|(place, _)| place.saturating_mul(stride)));
        stride = stride.saturating_mul(axis.values.len().max(1));
    }
    indices.sort_unstable();
    indices.dedup();
    indices
}

#[cfg(test)]
mod tests {
    use super::*;

    fn axis(text: &str) -> Axis {
        text.parse().unwrap()
    }

    #[test]
    fn the_ends_of_every_axis_are_among_its_points() {
        let axes = [axis("stiffness=3,1,2"), axis("dissipation=0.5,4,1")];
        let ends: Vec<String> =
            ends(&axes).into_iter().map(|index| point(&axes, index).to_string()).collect();
        for wanted in ["stiffness=1", "stiffness=3", "dissipation=0.5", "dissipation=4"] {
            assert!(ends.iter().any(|point| point.contains(wanted)), "{wanted}: {ends:?}");
        }
    }

    #[test]
    fn a_grid_is_every_combination() {
        let axes = [axis("stiffness=x0.1,x1"), axis("dissipation=0.5,1,2")];
        assert_eq!(count(&axes), Some(6));
        let names: Vec<String> = (0..6).map(|index| point(&axes, index).file_part()).collect();
        assert_eq!(names[0], "stiffness-x0.1_dissipation-0.5");
        assert_eq!(names[5], "stiffness-x1_dissipation-2");
        assert_eq!(point(&axes, 1).to_string(), "stiffness=x0.1 dissipation=1");
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
    fn what_is_no_axis_is_refused() {
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
}
