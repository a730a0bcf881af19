//! Option values, read strictly: a wrong number is refused with what to type instead.

use clap::error::{ContextKind, ContextValue, ErrorKind};
use globset::{Glob, GlobBuilder};
use osim_patch::{Assignment, Property, RadiusRule, shortest};

/// Metres, or a multiple of the sphere radius.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Length {
    Metres(f64),
    Radii(f64),
}

/// Values equally spaced on a logarithmic axis, as numbers or as factors of what is there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Grid {
    from: f64,
    to: f64,
    count: u32,
    factors: bool,
}

impl Grid {
    /// The values; factors are multiplied by `now`.
    pub(crate) fn values(self, now: f64) -> Vec<f64> {
        let unit = if self.factors { now } else { 1.0 };
        let step = (self.to / self.from).ln() / f64::from(self.count - 1);
        (0..self.count).map(|i| unit * self.from * (step * f64::from(i)).exp()).collect()
    }
}

/// `FROM..TO/COUNT`, both ends with an `x` for factors.
pub(super) fn grid(text: &str) -> Result<Grid, String> {
    const MOST: u32 = 200;
    let expected = "expected FROM..TO/COUNT like 1e5..1e7/25, or factors like x0.1..x10/25";
    let (ends, count) = text.trim().split_once('/').ok_or(expected)?;
    let (from, to) = ends.split_once("..").ok_or(expected)?;
    let factor = |end: &str| end.trim().strip_prefix(['x', 'X']).map(str::to_owned);
    let (from, to, factors) = match (factor(from), factor(to)) {
        (Some(from), Some(to)) => (from, to, true),
        (None, None) => (from.to_owned(), to.to_owned(), false),
        _ => return Err("both ends are numbers, or both are factors like x0.1..x10/25".to_owned()),
    };
    let (from, to) = (positive_number(&from)?, positive_number(&to)?);
    let count: u32 = count.trim().parse().map_err(|_| expected.to_owned())?;
    if from >= to {
        return Err("the first value must be below the last".to_owned());
    }
    if !(2..=MOST).contains(&count) {
        return Err(format!("expected 2 to {MOST} values"));
    }
    Ok(Grid { from, to, count, factors })
}

/// A mass in kg.
pub(super) fn mass(text: &str) -> Result<f64, String> {
    positive(text, "a mass in kg", &[("kg", 1.0), ("g", 1e-3), ("mg", 1e-6), ("t", 1e3)])
}

/// An acceleration in m/s².
pub(super) fn acceleration(text: &str) -> Result<f64, String> {
    positive(text, "an acceleration in m/s2", &[("m/s2", 1.0), ("m/s^2", 1.0), ("g", 9.80665)])
}

/// Any finite number, 0 or more.
pub(super) fn number(text: &str) -> Result<f64, String> {
    if plain(text.trim()) == Some(0.0) {
        return Ok(0.0);
    }
    positive(text, "a number", &[])
}

/// A finite number above 0.
pub(crate) fn positive_number(text: &str) -> Result<f64, String> {
    positive(text, "a number", &[])
}

/// x̂: above 0, at most 1.
pub(super) fn indentation(text: &str) -> Result<f64, String> {
    let expected = "a relative indentation (x/R) above 0, at most 1";
    positive(text, expected, &[])
        .and_then(|x| if x <= 1.0 { Ok(x) } else { Err(format!("expected {expected}")) })
}

/// t: between 0 and 0.5.
pub(super) fn fraction(text: &str) -> Result<f64, String> {
    let expected = "a threshold between 0 and 0.5";
    positive(text, expected, &[])
        .and_then(|t| if t < 0.5 { Ok(t) } else { Err(format!("expected {expected}")) })
}

/// c_r: 0 to 1.
pub(super) fn restitution(text: &str) -> Result<f64, String> {
    match plain(text.trim()) {
        Some(value) if (0.0..=1.0).contains(&value) => Ok(value),
        _ => Err("expected a coefficient of restitution from 0 to 1".to_owned()),
    }
}

/// ν: above -1, at most 0.5.
pub(super) fn poisson(text: &str) -> Result<f64, String> {
    match plain(text.trim()) {
        Some(value) if value > -1.0 && value <= 0.5 => Ok(value),
        _ => Err("expected a Poisson's ratio above -1, at most 0.5".to_owned()),
    }
}

/// Metres, or a multiple of the radius like `x0.25`.
pub(super) fn length(text: &str) -> Result<Length, String> {
    let expected = "a length in metres, or a multiple of the radius like x0.25";
    let parse = |text: &str| {
        if plain(text.trim()) == Some(0.0) {
            Ok(0.0)
        } else {
            positive(text, expected, &[("mm", 1e-3), ("m", 1.0)])
        }
    };
    match text.strip_prefix(['x', 'X']) {
        Some(factor) => parse(factor).map(Length::Radii),
        None => parse(text).map(Length::Metres),
    }
}

/// `BODY=x,y,z`.
pub(super) fn body_scale(text: &str) -> Result<(String, [f64; 3]), String> {
    let expected = "expected BODY=x,y,z with three factors above 0, like calcn_r=1.1,1.05,1.1";
    let (body, factors) = text.split_once('=').ok_or(expected)?;
    let values: Vec<f64> =
        factors.split(',').map(positive_number).collect::<Result<_, _>>().map_err(|_| expected.to_owned())?;
    let values: [f64; 3] = values.try_into().map_err(|_| expected.to_owned())?;
    Ok((body.trim().to_owned(), values))
}

/// `PROPERTY=VALUE` or `PROPERTY=xFACTOR`.
pub(crate) fn assignment(name: &str, text: &str) -> Result<(Property, Assignment), String> {
    let property: Property = name.trim().parse()?;
    let value = match text.trim().strip_prefix(['x', 'X']) {
        Some(factor) => number(factor).map(Assignment::Factor),
        None => number(text).map(Assignment::Value),
    };
    value.map(|value| (property, value)).map_err(|why| format!("{name}={text}: {why}"))
}

/// A number of things, 1 or more.
pub(super) fn count(text: &str) -> Result<f64, String> {
    match text.trim().parse::<u32>() {
        Ok(count) if count >= 1 => Ok(f64::from(count)),
        _ => Err("expected a whole number, 1 or more".to_owned()),
    }
}

/// `isometric`, `keep`, metres or `xFACTOR`.
pub(super) fn radius(text: &str) -> Result<RadiusRule, String> {
    match text {
        "isometric" => Ok(RadiusRule::Isometric),
        "keep" => Ok(RadiusRule::Keep),
        _ => match text.strip_prefix(['x', 'X']) {
            Some(factor) => positive(factor, "a factor like x1.5", &[]).map(RadiusRule::Factor),
            None => positive(
                text,
                "isometric, keep, a radius in metres or a factor like x1.5",
                &[("mm", 1e-3), ("cm", 1e-2), ("m", 1.0)],
            )
            .map(RadiusRule::Metres),
        },
    }
}

/// OpenSim's name of a property.
pub(super) fn property(text: &str) -> Result<Property, String> {
    text.trim().parse()
}

/// A pattern such as `*_r`.
pub(super) fn glob(text: &str) -> Result<Glob, String> {
    GlobBuilder::new(text).literal_separator(false).build().map_err(|error| error.kind().to_string())
}

/// A finite number above 0. `units` are spellings with a unit that are refused with the number to type.
fn positive(text: &str, expected: &str, units: &[(&str, f64)]) -> Result<f64, String> {
    let text = text.trim();
    if let Some(value) = plain(text) {
        return if value > 0.0 && value.is_finite() {
            Ok(value)
        } else {
            Err(format!("expected {expected}, above 0"))
        };
    }
    if let Some(value) = plain(&text.replacen(',', ".", 1)).filter(|_| text.matches(',').count() == 1) {
        // `1,190` may be a thousand and something: then the comma is not a decimal one.
        let grouped = |tail: &str| tail.len() == 3 && tail.bytes().all(|byte| byte.is_ascii_digit());
        return Err(match text.split_once(',') {
            Some((head, tail)) if head != "0" && grouped(tail) => {
                format!("it has a comma: type {} (or {head}{tail}, if it parts thousands)", shortest(value))
            }
            _ => format!("it has a decimal comma: type {}", shortest(value)),
        });
    }
    for (unit, factor) in units {
        let number = text.strip_suffix(unit).map(str::trim_end).and_then(plain);
        if let Some(value) = number {
            // Multiplying by 1e-3 would show 0.020900000000000002; dividing is exact enough to type.
            let value = if *factor < 1.0 { value / (1.0 / factor).round() } else { value * factor };
            return Err(format!("units are not written here, expected {expected}: type {}", shortest(value)));
        }
    }
    let number = text.trim_end_matches(|c: char| !c.is_ascii_digit() && c != '.').trim_end();
    match plain(number) {
        Some(value) if number.len() < text.len() => {
            Err(format!("units are not written here, expected {expected} such as {}", shortest(value)))
        }
        _ => Err(format!("expected {expected}")),
    }
}

/// A decimal number without words such as `inf` or `nan`.
fn plain(text: &str) -> Option<f64> {
    let digits = text.bytes().all(|byte| byte.is_ascii_digit() || b"+-.eE".contains(&byte));
    if digits { text.parse().ok() } else { None }
}

/// A usage error in two parts: the option it is about, and what is wrong with its value.
pub(crate) fn usage_parts(error: &clap::Error) -> (Option<String>, String) {
    let option = context(error, ContextKind::InvalidArg);
    let reason = std::error::Error::source(error).map(ToString::to_string);
    let message = match (context(error, ContextKind::InvalidValue), reason) {
        (Some(value), Some(reason)) if error.kind() == ErrorKind::ValueValidation => {
            format!("'{value}': {reason}")
        }
        _ => usage_line(error),
    };
    (option, message)
}

fn context(error: &clap::Error, kind: ContextKind) -> Option<String> {
    match error.get(kind) {
        Some(ContextValue::String(text)) => Some(text.clone()),
        Some(ContextValue::Strings(texts)) => texts.first().cloned(),
        _ => None,
    }
}

/// A usage error in one line: what is wrong and what was expected.
pub(crate) fn usage_line(error: &clap::Error) -> String {
    let context = |kind| match error.get(kind) {
        Some(ContextValue::String(text)) => Some(text.clone()),
        _ => None,
    };
    let from_parser = std::error::Error::source(error).map(ToString::to_string);
    if error.kind() == ErrorKind::ValueValidation
        && let (Some(value), Some(option), Some(reason)) =
            (context(ContextKind::InvalidValue), context(ContextKind::InvalidArg), from_parser)
    {
        let option = option.split(' ').next().unwrap_or_default().to_owned();
        return format!("{option} '{value}': {reason}");
    }
    let text = error.to_string();
    let mut lines = text.lines().map(str::trim).filter(|line| !line.is_empty());
    let first = lines.next().unwrap_or_default().trim_start_matches("error: ").to_owned();
    let rest: Vec<&str> = lines
        .take_while(|line| !line.starts_with("Usage:") && !line.starts_with("For more"))
        .map(|line| line.trim_start_matches("tip: "))
        // Nobody who misspells an option wants it to be a file.
        .filter(|line| !line.contains("as a value, use '--"))
        .collect();
    let joint = if first.ends_with(':') { " " } else { "; " };
    if rest.is_empty() { first } else { format!("{first}{joint}{}", rest.join(", ")) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn plain_numbers_are_taken() {
        assert_eq!(mass("1190"), Ok(1190.0));
        assert_eq!(mass(" 2.09e-2 "), Ok(0.0209));
        assert_eq!(radius("x1.5"), Ok(RadiusRule::Factor(1.5)));
        assert_eq!(radius("0.032"), Ok(RadiusRule::Metres(0.032)));
    }

    #[test]
    fn a_grid_is_equally_spaced_on_a_logarithmic_axis() {
        let values = grid("x0.1..x10/3").unwrap().values(2e6);
        for (seen, expected) in values.iter().zip([2e5, 2e6, 2e7]) {
            assert!((seen / expected - 1.0).abs() < 1e-12, "{values:?}");
        }
        assert_eq!(values.len(), 3);
        assert_eq!(grid("1..4/2").unwrap().values(9.0).first(), Some(&1.0));
        for refused in
            ["1..4", "1/3", "4..1/3", "x1..4/3", "0..4/3", "1..4/1", "1..4/x", "1kg..4/3", "1..4/9999"]
        {
            assert!(grid(refused).is_err(), "{refused}");
        }
    }

    #[test]
    fn anything_else_is_refused_with_what_to_type() {
        for (text, hint) in [
            ("1190kg", "type 1190"),
            ("20.9g", "type 0.0209"),
            ("20.9 g", "type 0.0209"),
            ("0,0209", "type 0.0209"),
            ("1,190", "1190"),
            ("-3", "above 0"),
            ("0", "above 0"),
            ("inf", "a mass in kg"),
            ("nan", "a mass in kg"),
            ("heavy", "a mass in kg"),
            ("1e999", "above 0"),
        ] {
            assert!(mass(text).unwrap_err().contains(hint), "{text}: {:?}", mass(text));
        }
        assert!(radius("32mm").unwrap_err().contains("type 0.032"));
        assert!(count("1.5").is_err());
        assert!(property("stifness").unwrap_err().contains("stiffness"));
    }
}
