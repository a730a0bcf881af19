//! Axes: what is written along them, where they begin and end, where their ticks are.

use std::ops::Range;

use plotters::coord::ranged1d::{DefaultFormatting, KeyPointHint, Ranged};
use plotters::coord::types::RangedCoordf64;

/// An axis.
#[derive(Debug, Clone, PartialEq)]
pub struct Axis {
    /// What is written along it, with its unit.
    pub label: String,
    /// What it covers at least; it grows to hold all points.
    pub range: Option<(f64, f64)>,
}

impl Axis {
    /// An axis that covers its points.
    #[must_use]
    pub fn new(label: impl Into<String>) -> Self {
        Self { label: label.into(), range: None }
    }

    /// An axis that covers at least this range.
    #[must_use]
    pub fn over(label: impl Into<String>, from: f64, to: f64) -> Self {
        Self { label: label.into(), range: Some((from, to)) }
    }

    /// From where to where it goes: all values and the wanted range. `room` leaves some room above the values.
    pub(crate) fn span(&self, values: impl Iterator<Item = f64>, room: bool) -> (f64, f64) {
        let (mut low, mut high) = self.range.unwrap_or((f64::INFINITY, f64::NEG_INFINITY));
        for value in values {
            low = low.min(value);
            high = high.max(value);
        }
        if room {
            // Forces and states begin at 0; a curve that goes a little below keeps its own lowest point.
            low = low.min(0.0);
            if self.range.is_none_or(|(_, to)| high > to) {
                high += 0.06 * (high - low);
            }
        }
        if high > low { (low, high) } else { (low - 0.5, low + 0.5) }
    }
}

/// Positions of ticks and what is written at them.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Ticks {
    pub(crate) at: Vec<f64>,
    decimals: usize,
    power: i32,
}

impl Ticks {
    /// About `count` ticks of a linear axis.
    pub(crate) fn linear((low, high): (f64, f64), count: usize) -> Self {
        let coord: RangedCoordf64 = (low..high).into();
        let at: Vec<f64> = coord.key_points(count);
        let largest = at.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
        let step = at.windows(2).map(|pair| pair[1] - pair[0]).fold(largest, f64::min);
        // What rounding leaves of 0 is 0.
        let at: Vec<f64> =
            at.into_iter().map(|value| if value.abs() < 1e-9 * step { 0.0 } else { value }).collect();
        let power = if (1e-3..1e5).contains(&largest) || largest == 0.0 { 0 } else { exponent(largest) };
        Self { decimals: decimals(step / 10_f64.powi(power)), at, power }
    }

    pub(crate) fn label(&self, value: f64) -> String {
        if self.power == 0 || value == 0.0 {
            return plain(value, if value == 0.0 { 0 } else { self.decimals });
        }
        format!("{}×{}", plain(value / 10_f64.powi(self.power), self.decimals), power_of_ten(self.power))
    }

    /// The widest label, in letters' stead.
    pub(crate) fn longest(&self) -> String {
        let labels = self.at.iter().map(|&value| self.label(value));
        labels.max_by_key(|label| label.chars().count()).unwrap_or_default()
    }
}

/// A linear coordinate with ticks where we want them.
pub(crate) struct Scale {
    coord: RangedCoordf64,
    ticks: Vec<f64>,
}

impl Scale {
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

#[expect(clippy::cast_possible_truncation, reason = "an exponent of ten")]
fn exponent(value: f64) -> i32 {
    value.abs().log10().floor() as i32
}

/// Digits after the point that distinguish values that are `step` apart.
fn decimals(step: f64) -> usize {
    (0..12)
        .find(|&digits| {
            let scaled = step * 10_f64.powi(digits);
            scaled >= 0.5 && (scaled - scaled.round()).abs() < 1e-6 * scaled.max(1.0)
        })
        .map_or(3, |digits| digits.unsigned_abs() as usize)
}

fn plain(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    match text.strip_prefix('-') {
        Some(rest) if rest.bytes().any(|byte| (b'1'..=b'9').contains(&byte)) => format!("−{rest}"),
        Some(rest) => rest.to_owned(),
        None => text,
    }
}

/// 10 with a raised exponent.
pub(crate) fn power_of_ten(power: i32) -> String {
    let raised = |c: char| match c {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        '0' => '⁰',
        digit => char::from_u32(0x2070 + digit.to_digit(10).unwrap_or(0)).unwrap_or(digit),
    };
    format!("10{}", power.to_string().chars().map(raised).collect::<String>())
}

/// Ticks of a logarithmic axis: 1, 2 and 5 of each decade where there is room for them, else the decades.
pub(crate) fn log_ticks(low: f64, high: f64) -> Vec<(f64, String)> {
    let decades = (high / low).log10();
    let steps: &[f64] = if decades < 1.8 { &[1.0, 2.0, 5.0] } else { &[1.0] };
    let mut ticks = Vec::new();
    for power in exponent(low)..=exponent(high) {
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
        -3..=3 => plain(step * 10_f64.powi(power), usize::try_from(-power).unwrap_or(0)),
        _ if step == 1.0 => power_of_ten(power),
        _ => format!("{step:.0}×{}", power_of_ten(power)),
    }
}

/// The unlabelled ticks of a logarithmic axis: 1 to 9 of each decade.
pub(crate) fn minor_log_ticks(low: f64, high: f64) -> Vec<f64> {
    (exponent(low)..=exponent(high))
        .flat_map(|power| (1..10).map(move |step| f64::from(step) * 10_f64.powi(power)))
        .filter(|at| (low..=high).contains(at))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(low: f64, high: f64) -> Vec<String> {
        let ticks = Ticks::linear((low, high), 6);
        ticks.at.iter().map(|&at| ticks.label(at)).collect()
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
        assert_eq!(Axis::over("x", 0.0, 2.0).span([1.0, 3.0].into_iter(), false), (0.0, 3.0));
        let (low, high) = Axis::new("F").span([2.0, 10.0].into_iter(), true);
        assert!(low == 0.0 && high > 10.0);
    }
}
