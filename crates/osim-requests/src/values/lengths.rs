//! Radii, heights of a fall, and the indentation at the begin of contact, as texts.

use std::fmt;
use std::str::FromStr;

use contact_scaling::fit::Onset;
use osim_model::RadiusRule;
use osim_model::messages::{readable, shortest};

use crate::values::serial::values_as_text;
use crate::values::typed_numbers::{LENGTH_UNITS, factor, not_negative, plain_number, positive, trimmed};

/// `isometric`, `keep`, `follow`, metres, or a factor such as `x1.5`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Radius(Option<RadiusRule>);

impl Radius {
    /// Radii follow the factors of bodies. Only a transfer whose spheres follow their bodies has such radii.
    pub const FOLLOW: Self = Self(None);

    /// The rule that gives the new radii; `None` if they follow the factors of bodies.
    pub const fn rule(self) -> Option<RadiusRule> {
        self.0
    }
}

impl From<RadiusRule> for Radius {
    fn from(rule: RadiusRule) -> Self {
        Self(Some(rule))
    }
}

impl FromStr for Radius {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        if text == "follow" {
            return Ok(Self::FOLLOW);
        }
        let rule = match (text, factor(text)) {
            ("isometric", _) => Ok(RadiusRule::Isometric),
            ("keep", _) => Ok(RadiusRule::Keep),
            (_, Some(number)) => positive(number, "a factor like x1.5", &[]).map(RadiusRule::Factor),
            (_, None) => {
                let expected = "isometric, keep, follow, a radius in metres or a factor like x1.5";
                positive(text, expected, LENGTH_UNITS).map(RadiusRule::Metres)
            }
        };
        rule.map(Self::from)
    }
}

impl fmt::Display for Radius {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            None => f.write_str("follow"),
            Some(RadiusRule::Isometric) => f.write_str("isometric"),
            Some(RadiusRule::Keep) => f.write_str("keep"),
            Some(RadiusRule::Metres(metres)) => f.write_str(&shortest(metres)),
            Some(RadiusRule::Factor(factor)) => write!(f, "x{}", shortest(factor)),
        }
    }
}

/// The expected form of a radius, for messages.
const EXPECTED_RADIUS: &str = "isometric, follow or a radius in metres";
/// The largest accepted radius, m.
const LARGEST_LENGTH_M: f64 = 1e9;

/// The new radius of spheres: `isometric`, `follow` or a length in m.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum NewRadius {
    /// The reference's radius times the cube root of the ratio of masses (8).
    #[default]
    Isometric,
    /// The reference's radius times the geometric mean of the scale factors of the sphere's body.
    Follow,
    /// One radius for all spheres, m.
    Metres(f64),
}

impl FromStr for NewRadius {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text {
            "isometric" => Ok(Self::Isometric),
            "follow" => Ok(Self::Follow),
            _ => match positive(text, EXPECTED_RADIUS, LENGTH_UNITS)? {
                metres if metres <= LARGEST_LENGTH_M => Ok(Self::Metres(metres)),
                _ => Err(format!("expected {EXPECTED_RADIUS}, at most 1e9")),
            },
        }
    }
}

impl fmt::Display for NewRadius {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Isometric => f.write_str("isometric"),
            Self::Follow => f.write_str("follow"),
            Self::Metres(metres) => f.write_str(&shortest(*metres)),
        }
    }
}

/// Height of the sphere bottoms at the start of a fall: metres, or a multiple of the radius such as `x0.25`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum DropHeight {
    Metres(f64),
    /// A multiple of the sphere's radius.
    Radii(f64),
}

impl DropHeight {
    /// The length in m, for a sphere of this radius.
    pub fn metres(self, radius_m: f64) -> f64 {
        match self {
            Self::Metres(metres) => metres,
            Self::Radii(radii) => radii * radius_m,
        }
    }

    /// The length for readers: the number, and `metre` or `radius` as its unit.
    pub fn describe(self, metre: &str, radius: &str) -> String {
        match self {
            Self::Metres(metres) => format!("{} {metre}", readable(metres)),
            Self::Radii(radii) => format!("{} {radius}", readable(radii)),
        }
    }
}

impl Default for DropHeight {
    /// A quarter of the radius, as in the paper's drop tests.
    fn default() -> Self {
        Self::Radii(0.25)
    }
}

impl FromStr for DropHeight {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let expected = "a length in metres, or a multiple of the radius like x0.25";
        let parse = |text: &str| not_negative(text, expected, LENGTH_UNITS);
        match factor(text) {
            Some(number) => parse(number).map(Self::Radii),
            None => parse(text).map(Self::Metres),
        }
    }
}

impl fmt::Display for DropHeight {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Metres(metres) => f.write_str(&shortest(*metres)),
            Self::Radii(radii) => write!(f, "x{}", shortest(*radii)),
        }
    }
}

/// An indentation in m at which contact begins, or `fit` to find it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactOnset(Onset);

impl ContactOnset {
    pub const fn get(self) -> Onset {
        self.0
    }
}

impl Default for ContactOnset {
    fn default() -> Self {
        Self(Onset::At(0.0))
    }
}

impl FromStr for ContactOnset {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        if text == "fit" {
            return Ok(Self(Onset::Fitted));
        }
        match trimmed(text).parse::<f64>() {
            Ok(metres) if metres.is_finite() => Ok(Self(Onset::At(metres))),
            _ => Err("expected an indentation in metres, or fit to find it".to_owned()),
        }
    }
}

impl fmt::Display for ContactOnset {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            Onset::At(metres) => f.write_str(&shortest(metres)),
            Onset::Fitted => f.write_str("fit"),
        }
    }
}

/// Usual errors of a motion: of places (m), and of angles (degrees), typed as `6mm,2deg`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct UsualErrors {
    pub length_m: f64,
    angle_deg: f64,
}

impl UsualErrors {
    pub fn angle_rad(self) -> f64 {
        self.angle_deg.to_radians()
    }
}

impl FromStr for UsualErrors {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let number = |part: &str, unit: &str| {
            let value = plain_number(trimmed(trimmed(part).strip_suffix(unit)?))?;
            Some(value).filter(|value| *value > 0.0 && value.is_finite())
        };
        let both = text.split_once(',');
        both.and_then(|(length, angle)| Some((number(length, "mm")?, number(angle, "deg")?)))
            .map(|(length_mm, angle_deg)| Self { length_m: length_mm / 1e3, angle_deg })
            .ok_or_else(|| "expected a length in mm and an angle in degrees, like 6mm,2deg".to_owned())
    }
}

impl fmt::Display for UsualErrors {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}mm,{}deg", readable(1e3 * self.length_m), shortest(self.angle_deg))
    }
}

values_as_text! {
    UsualErrors = {"type": "string", "pattern": "^[0-9.eE+-]+mm,[0-9.eE+-]+deg$"};
    Radius = {
        "description": "`isometric`, `keep`, `follow`, metres, or a factor such as `x1.5`.",
        "anyOf": [
            {"type": "number", "exclusiveMinimum": 0, "description": "metres"},
            {"type": "string", "pattern": "^(isometric|keep|follow|[xX][0-9.eE+-]+)$"},
        ],
    };
    NewRadius = {"anyOf": [
        {"type": "number", "exclusiveMinimum": 0, "maximum": 1e9, "description": "metres"},
        {"type": "string", "pattern": "^(isometric|follow)$"},
    ]};
    DropHeight = {"anyOf": [
        {"type": "number", "minimum": 0, "description": "metres"},
        {"type": "string", "pattern": "^[xX][0-9.eE+-]+$"},
    ]};
    ContactOnset = {"anyOf": [{"type": "number", "description": "metres"}, {"const": "fit"}]};
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn usual_errors_have_their_units() {
        let errors: UsualErrors = "6mm, 2.5deg".parse().unwrap();
        assert_eq!((errors.length_m, errors.to_string().as_str()), (0.006, "6mm,2.5deg"));
        for text in ["6mm", "6,2", "0.006,2deg", "0mm,2deg", "6cm,2deg"] {
            assert!(text.parse::<UsualErrors>().unwrap_err().contains("like 6mm,2deg"), "{text}");
        }
    }

    #[test]
    fn a_radius_is_a_word_metres_or_a_factor() {
        for (text, rule) in [
            ("follow", None),
            ("isometric", Some(RadiusRule::Isometric)),
            ("keep", Some(RadiusRule::Keep)),
            ("x1.5", Some(RadiusRule::Factor(1.5))),
            ("0.032", Some(RadiusRule::Metres(0.032))),
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
