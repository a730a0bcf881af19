//! Axes: their labels, their ends, and their ticks.

use std::ops::Range;

use plotters::coord::ranged1d::{DefaultFormatting, KeyPointHint, Ranged};
use plotters::coord::types::RangedCoordf64;

use crate::error::PlotError;
use crate::style::TEXT_PT;
use crate::text_width::width_pt;

/// An axis of a figure.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Axis {
    /// The label along the axis: a quantity with its unit.
    pub label: String,
    /// The range that the axis covers at least, in the unit of the axis. The axis grows if points lie outside.
    pub range: Option<(f64, f64)>,
    /// The limits of the axis, in the unit of the axis, if it must cover exactly these; points outside are not drawn.
    pub limits: Option<(f64, f64)>,
    /// Whether the axis is logarithmic: equal ratios are equally far apart.
    pub logarithmic: bool,
}

impl Axis {
    /// A linear axis that covers all its points.
    pub fn new(label: impl Into<String>) -> Self {
        Self { label: label.into(), range: None, limits: None, logarithmic: false }
    }

    /// A linear axis that covers all its points and at least the range from `from` to `to`.
    pub fn covering(label: impl Into<String>, from: f64, to: f64) -> Self {
        Self { range: Some((from, to)), ..Self::new(label) }
    }

    /// A logarithmic axis that covers all its points.
    pub fn logarithmic(label: impl Into<String>) -> Self {
        Self { logarithmic: true, ..Self::new(label) }
    }

    /// Position of a value along the axis: the value, or its decimal logarithm on a logarithmic axis.
    pub(crate) fn place(&self, value: f64) -> f64 {
        if self.logarithmic { value.log10() } else { value }
    }

    /// Start and end of the axis as positions: its limits, or the range of all values and the wanted range. With `room`, the
    /// axis begins at 0 and ends some way above the largest value.
    pub(crate) fn span(&self, values: impl Iterator<Item = f64>, room: bool) -> (f64, f64) {
        if let Some((from, to)) = self.limits {
            return (self.place(from), self.place(to));
        }
        let range = self.range.map(|(from, to)| (self.place(from), self.place(to)));
        let (mut low, mut high) = range.unwrap_or((f64::INFINITY, f64::NEG_INFINITY));
        for value in values.map(|value| self.place(value)) {
            low = low.min(value);
            high = high.max(value);
        }
        if room && !self.logarithmic {
            // Forces and states begin at 0; a curve that goes a little below keeps its own lowest point.
            low = low.min(0.0);
            if range.is_none_or(|(_, to)| high > to) {
                high += 0.06 * (high - low);
            }
        }
        if high > low { (low, high) } else { (low - 0.5, low + 0.5) }
    }

    /// Ticks over a span of positions, about `count` of them.
    pub(crate) fn ticks(&self, span: (f64, f64), count: usize) -> Ticks {
        if self.logarithmic { Ticks::logarithmic(span) } else { Ticks::linear(span, count) }
    }

    /// Refuses limits that do not go from a smaller to a larger number, and values without a logarithm on a logarithmic axis.
    pub(crate) fn check(&self, mut values: impl Iterator<Item = f64>) -> Result<(), PlotError> {
        let wrong = |(from, to): (f64, f64)| !from.is_finite() || !to.is_finite() || from >= to;
        if self.limits.is_some_and(wrong) {
            return Err(PlotError::Limits(self.label.clone()));
        }
        let ends = self.limits.into_iter().chain(self.range).flat_map(|(from, to)| [from, to]);
        if self.logarithmic && values.by_ref().chain(ends).any(|value| value <= 0.0) {
            return Err(PlotError::NotPositive(self.label.clone()));
        }
        Ok(())
    }
}

/// Positions of ticks, and the texts at them.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Ticks {
    /// Positions of the ticks with a label, each with its label.
    pub(crate) marks: Vec<(f64, String)>,
    /// Positions of the ticks without a label.
    pub(crate) minor: Vec<f64>,
}

impl Ticks {
    /// Ticks of a linear axis, about `count` of them.
    pub(crate) fn linear((low, high): (f64, f64), count: usize) -> Self {
        let coord: RangedCoordf64 = (low..high).into();
        let at: Vec<f64> = coord.key_points(count);
        let largest = at.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
        let step = at.windows(2).map(|pair| pair[1] - pair[0]).fold(largest, f64::min);
        let power =
            if (1e-3..1e5).contains(&largest) || largest == 0.0 { 0 } else { decimal_exponent(largest) };
        let decimals = decimals_for_step(step / 10_f64.powi(power));
        let marks = at.into_iter().map(|value| {
            // What rounding leaves of 0 is 0.
            let value = if value.abs() < 1e-9 * step { 0.0 } else { value };
            (value, linear_label(value, power, decimals))
        });
        Self { marks: marks.collect(), minor: vec![] }
    }

    /// The ticks of a logarithmic axis from `low` to `high`; all positions are decimal logarithms.
    pub(crate) fn logarithmic((low, high): (f64, f64)) -> Self {
        let (low, high) = (10_f64.powf(low), 10_f64.powf(high));
        let marks = log_ticks(low, high).into_iter().map(|(at, label)| (at.log10(), label));
        // 1 to 9 of each decade.
        let minor = (decimal_exponent(low)..=decimal_exponent(high))
            .flat_map(|power| (1..10).map(move |step| f64::from(step) * 10_f64.powi(power)))
            .filter(|at| (low..=high).contains(at))
            .map(f64::log10);
        Self { marks: marks.collect(), minor: minor.collect() }
    }

    /// Positions of the ticks with a label.
    pub(crate) fn at(&self) -> Vec<f64> {
        self.marks.iter().map(|(at, _)| *at).collect()
    }

    pub(crate) fn label(&self, at: f64) -> &str {
        self.marks.iter().find(|(tick, _)| *tick == at).map_or("", |(_, label)| label)
    }

    /// The width of the widest label, pt.
    pub(crate) fn width_pt(&self) -> f64 {
        self.marks.iter().map(|(_, label)| width_pt(label, TEXT_PT)).fold(0.0, f64::max)
    }
}

fn linear_label(value: f64, power: i32, decimals: usize) -> String {
    if power == 0 || value == 0.0 {
        return fixed_decimals(value, if value == 0.0 { 0 } else { decimals });
    }
    format!("{}×{}", fixed_decimals(value / 10_f64.powi(power), decimals), power_of_ten(power))
}

/// A linear coordinate for the library `plotters`, with ticks at given positions.
pub(crate) struct Scale {
    coord: RangedCoordf64,
    ticks: Vec<f64>,
}

impl Scale {
    /// A coordinate from `low` to `high`, with ticks at these positions.
    pub(crate) fn new((low, high): (f64, f64), ticks: Vec<f64>) -> Self {
        Self { coord: (low..high).into(), ticks }
    }
}

impl Ranged for Scale {
    type FormatOption = DefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, limit: (i32, i32)) -> i32 {
        self.coord.map(value, limit)
    }

    fn key_points<Hint: KeyPointHint>(&self, hint: Hint) -> Vec<f64> {
        if hint.weight().allow_light_points() { Vec::new() } else { self.ticks.clone() }
    }

    fn range(&self) -> Range<f64> {
        self.coord.range()
    }
}

fn decimal_exponent(value: f64) -> i32 {
    value.abs().log10().floor() as i32
}

/// Number of digits after the decimal point that are needed to distinguish values with a distance of `step`.
fn decimals_for_step(step: f64) -> usize {
    (0..12)
        .find(|&digits| {
            let scaled = step * 10_f64.powi(digits);
            scaled >= 0.5 && (scaled - scaled.round()).abs() < 1e-6 * scaled.max(1.0)
        })
        .map_or(3, |digits| digits.unsigned_abs() as usize)
}

fn fixed_decimals(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    match text.strip_prefix('-') {
        Some(rest) if rest.bytes().any(|byte| (b'1'..=b'9').contains(&byte)) => format!("−{rest}"),
        Some(rest) => rest.to_owned(),
        None => text,
    }
}

/// 10 with its exponent as superscript.
fn power_of_ten(power: i32) -> String {
    let raised = |c: char| match c {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        digit => char::from_u32(0x2070 + digit.to_digit(10).unwrap_or(0)).unwrap_or(digit),
    };
    format!("10{}", power.to_string().chars().map(raised).collect::<String>())
}

/// The labelled ticks of a logarithmic axis: 1, 2 and 5 of each decade if there is room for them, else the decades.
fn log_ticks(low: f64, high: f64) -> Vec<(f64, String)> {
    let decades = (high / low).log10();
    let steps: &[f64] = if decades < 1.8 { &[1.0, 2.0, 5.0] } else { &[1.0] };
    let mut ticks = Vec::new();
    for power in decimal_exponent(low)..=decimal_exponent(high) {
        for &step in steps {
            let at = step * 10_f64.powi(power);
            if at >= low * (1.0 - 1e-9) && at <= high * (1.0 + 1e-9) {
                ticks.push((at, log_label(step, power)));
            }
        }
    }
    ticks
}

fn log_label(step: f64, power: i32) -> String {
    match power {
        -3..=3 => fixed_decimals(step * 10_f64.powi(power), usize::try_from(-power).unwrap_or(0)),
        _ if step == 1.0 => power_of_ten(power),
        _ => format!("{step:.0}×{}", power_of_ten(power)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(low: f64, high: f64) -> Vec<String> {
        let ticks = Ticks::linear((low, high), 6);
        ticks.marks.into_iter().map(|(_, label)| label).collect()
    }

    #[test]
    fn ticks_are_round_and_equally_long() {
        assert_eq!(labels(-0.5, 0.5), ["−0.4", "−0.2", "0", "0.2", "0.4"]);
        assert_eq!(labels(0.0, 0.6).first().map(String::as_str), Some("0"));
        assert!(labels(0.0, 3e6).iter().any(|label| label == "2×10⁶"), "{:?}", labels(0.0, 3e6));
    }

    #[test]
    fn decades_are_written_as_powers() {
        let ticks: Vec<String> = log_ticks(1e5, 1e7).into_iter().map(|(_, label)| label).collect();
        assert_eq!(ticks, ["10⁵", "10⁶", "10⁷"]);
        let ticks: Vec<String> = log_ticks(0.2, 4.0).into_iter().map(|(_, label)| label).collect();
        assert_eq!(ticks, ["0.2", "0.5", "1", "2"]);
        assert_eq!(power_of_ten(-12), "10⁻¹²");
    }

    #[test]
    fn an_axis_holds_all_its_values() {
        assert_eq!(Axis::new("x").span([1.0, 3.0].into_iter(), false), (1.0, 3.0));
        assert_eq!(Axis::covering("x", 0.0, 2.0).span([1.0, 3.0].into_iter(), false), (0.0, 3.0));
        let (low, high) = Axis::new("F").span([2.0, 10.0].into_iter(), true);
        assert!(low == 0.0 && high > 10.0);
    }

    #[test]
    fn limits_are_kept_and_must_go_from_a_smaller_to_a_larger_number() {
        let limited = Axis { limits: Some((0.0, 2.0)), ..Axis::new("F") };
        assert_eq!(limited.span([1.0, 30.0].into_iter(), true), (0.0, 2.0));
        assert!(limited.check(std::iter::empty()).is_ok());
        let empty = Axis { limits: Some((2.0, 2.0)), ..Axis::new("F") };
        assert!(matches!(empty.check(std::iter::empty()), Err(PlotError::Limits(_))));
    }

    #[test]
    fn places_of_a_logarithmic_axis_are_logarithms() {
        let axis = Axis::logarithmic("E");
        assert_eq!(axis.span([10.0, 1000.0].into_iter(), true), (1.0, 3.0));
        let labels: Vec<String> =
            axis.ticks((1.0, 3.0), 5).marks.into_iter().map(|(_, label)| label).collect();
        assert_eq!(labels, ["10", "100", "1000"]);
        assert!(matches!(axis.check([0.0].into_iter()), Err(PlotError::NotPositive(_))));
    }
}
