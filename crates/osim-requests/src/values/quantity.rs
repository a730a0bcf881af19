//! Numbers with a domain; each is checked once, when it is read.

use std::fmt;
use std::str::FromStr;

use osim_model::messages::shortest;
use serde::Serialize;

use crate::values::serial::{values_as_text, values_from_text};
use crate::values::typed_numbers::{
    LENGTH_UNITS, MASS_UNITS, UnitSpelling, converted, not_negative, plain_number, positive, positive_number,
    trimmed,
};

macro_rules! quantities {
    ($($(#[doc = $doc:literal])+ $name:ident = $read:expr, $schema:tt $(, $default:expr)?;)+) => {$(
        $(#[doc = $doc])+
        ///
        /// Read from a plain number, or from the text of one; anything else is refused with what to write.
        #[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
        pub struct $name(f64);

        impl $name {
            pub const fn get(self) -> f64 {
                self.0
            }

            /// The quantity of this number, if the number is in its domain.
            ///
            /// # Errors
            /// The number is outside the domain; the message has the expected range.
            pub fn new(value: f64) -> Result<Self, String> {
                shortest(value).parse()
            }
        }

        $(impl Default for $name {
            fn default() -> Self {
                Self($default)
            }
        })?

        impl FromStr for $name {
            type Err = String;

            fn from_str(text: &str) -> Result<Self, String> {
                let read: fn(&str) -> Result<f64, String> = $read;
                read(text).map(Self)
            }
        }

        impl fmt::Display for $name {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str(&shortest(self.0))
            }
        }

        values_as_text! { $name = $schema; }
    )+};
}

/// A plain number for which `is_in` is true.
fn plain_number_within(text: &str, expected: &str, is_in: fn(f64) -> bool) -> Result<f64, String> {
    plain_number(trimmed(text)).filter(|value| is_in(*value)).ok_or_else(|| format!("expected {expected}"))
}

/// A number above 0 for which `is_in` is true.
fn positive_number_within(
    text: &str,
    expected: &str,
    units: &[UnitSpelling],
    is_in: fn(f64) -> bool,
) -> Result<f64, String> {
    let value = positive(text, expected, units)?;
    if is_in(value) { Ok(value) } else { Err(format!("expected {expected}")) }
}

quantities! {
    /// A mass in kg, above 0.
    Kilograms = |text| positive(text, "a mass in kg", MASS_UNITS),
        {"type": "number", "exclusiveMinimum": 0};

    /// An acceleration in m/s², above 0.
    Acceleration = |text| {
        positive(text, "an acceleration in m/s2", &[("m/s2", 1.0), ("m/s^2", 1.0), ("g", 9.80665)])
    }, {"type": "number", "exclusiveMinimum": 0};

    /// A number above 0, in the unit of its field.
    Positive = positive_number, {"type": "number", "exclusiveMinimum": 0};

    /// A number, 0 or more, in the unit of its field.
    NotNegative = |text| not_negative(text, "a number", &[]), {"type": "number", "minimum": 0};

    /// A length in m, 0 or more.
    Metres = |text| not_negative(text, "metres", LENGTH_UNITS), {"type": "number", "minimum": 0};

    /// A number of either sign, in the unit of its field.
    Signed = |text| plain_number_within(text, "a number", f64::is_finite), {"type": "number"};

    /// x̂, an indentation over the radius: above 0, at most 1.
    RelativeIndentation = |text| {
        positive_number_within(text, "a relative indentation (x/R) above 0, at most 1", &[], |x| x <= 1.0)
    }, {"type": "number", "exclusiveMinimum": 0, "maximum": 1};

    /// √cf/R: above 0, for OpenSim computes nothing from a cf of 0.
    ConstantIndentation = |text| match plain_number(trimmed(text)) {
        Some(0.0) => Err(format!(
            "expected a number above 0, such as {}: it would make constant_contact_force 0, and OpenSim computes NaN with 0 \
             whenever the sphere does not slip",
            contact_scaling::limits::SUGGESTED_CONSTANT_INDENTATION
        )),
        _ => positive_number(text),
    }, {"type": "number", "exclusiveMinimum": 0};

    /// t, the share of a transition that counts as outside it: between 0 and 0.5.
    Threshold = |text| positive_number_within(text, "a threshold between 0 and 0.5", &[], |t| t < 0.5),
        {"type": "number", "exclusiveMinimum": 0, "exclusiveMaximum": 0.5}, contact_scaling::limits::TRANSITION_SHARE;

    /// c_r, a coefficient of restitution: 0 to 1.
    RestitutionCoefficient = |text| {
        plain_number_within(text, "a coefficient of restitution from 0 to 1", |value| (0.0..=1.0).contains(&value))
    }, {"type": "number", "minimum": 0, "maximum": 1};

    /// ν, Poisson's ratio: above -1, at most 0.5.
    PoissonRatio = |text| {
        plain_number_within(text, "a Poisson's ratio above -1, at most 0.5", |value| value > -1.0 && value <= 0.5)
    }, {"type": "number", "exclusiveMinimum": -1, "maximum": 0.5};

    /// A width of a figure in mm, 20 to 1000.
    FigureWidth = |text| {
        let units = [("mm", 1.0), ("cm", 10.0)];
        positive_number_within(text, "a width in mm from 20 to 1000", &units, |mm| (20.0..=1000.0).contains(&mm))
    }, {"type": "number", "minimum": 20, "maximum": 1000};

    /// A size of letters in points of 1/72 inch, 4 to 40.
    FontSize = |text| {
        let expected = "a size of letters in points from 4 to 40";
        positive_number_within(text, expected, &[("pt", 1.0)], |points| (4.0..=40.0).contains(&points))
    }, {"type": "number", "minimum": 4, "maximum": 40}, 7.0;

    /// A number of things, 1 to a million.
    Count = |text| match trimmed(text).parse::<u32>() {
        Ok(count) if (1..=1_000_000).contains(&count) => Ok(f64::from(count)),
        _ => Err("expected a whole number from 1 to 1000000".to_owned()),
    }, {"type": "integer", "minimum": 1, "maximum": 1_000_000}, 1.0;
}

impl Kilograms {
    /// A number, with its unit or without, such as `20`, `20kg` or `20g`.
    pub fn with_unit(text: &str) -> Option<Self> {
        converted(text, MASS_UNITS).map(Self).or_else(|| text.parse().ok())
    }
}

impl Positive {
    /// The default duration of a drop, s.
    pub(crate) const DROP_DURATION_S: Self = Self(2.0);
    /// The default k̂ at the start of a ladder (a sweep from soft to stiff contacts): k̂ of the softest contacts in the
    /// paper's Fig. 1(C).
    pub(crate) const SOFT_STIFFNESS: Self = Self(1.2);
}

// Whole numbers with bounds.

macro_rules! whole_numbers {
    ($($(#[doc = $doc:literal])+ $name:ident($type:ty) = $least:literal to $most:literal, $default:literal;)+) => {$(
        $(#[doc = $doc])+
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
        #[serde(transparent)]
        pub struct $name($type);

        impl $name {
            pub const fn get(self) -> $type {
                self.0
            }
        }

        impl Default for $name {
            fn default() -> Self {
                Self($default)
            }
        }

        impl FromStr for $name {
            type Err = String;

            fn from_str(text: &str) -> Result<Self, String> {
                match trimmed(text).parse::<$type>() {
                    Ok(number) if ($least..=$most).contains(&number) => Ok(Self(number)),
                    _ => Err(format!("expected a whole number from {} to {}", $least, $most)),
                }
            }
        }

        impl fmt::Display for $name {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                self.0.fmt(f)
            }
        }

        values_from_text! { $name = {"type": "integer", "minimum": $least, "maximum": $most}; }
    )+};
}

whole_numbers! {
    /// Points of a series.
    Samples(u32) = 2 to 1_000_000, 1001;
    /// Spheres under one foot.
    SpheresOfFoot(u8) = 1 to 60, 4;
    /// Steps of a ladder.
    Steps(u32) = 2 to 100_000, 5;
    /// Models to work on at once.
    Jobs(u16) = 1 to 4096, 1;
    /// Pixels to the inch.
    Dpi(u16) = 50 to 2400, 600;
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantities_are_read_from_decimal_numbers() {
        assert_eq!("1190".parse::<Kilograms>().map(Kilograms::get), Ok(1190.0));
        assert_eq!(" 2.09e-2 ".parse::<Kilograms>().map(Kilograms::get), Ok(0.0209));
        assert_eq!(Count::new(4.0).map(Count::get), Ok(4.0));
    }

    #[test]
    fn anything_else_is_refused_with_what_to_type() {
        for (text, hint) in [
            ("1190kg", "type 1190"),
            ("20.9g", "type 0.0209"),
            ("20.9 g", "type 0.0209"),
            ("20.9G", "type 0.0209"),
            ("1500mg", "type 0.0015"),
            ("2.5t", "type 2500"),
            // 44 times 0.45359237 is 19.95806428, 100 times 45.359237, both exact.
            ("44lb", "type 19.95806428"),
            ("44 lbs", "type 19.95806428"),
            ("100LB", "type 45.359237"),
            // 16 oz are 1 lb.
            ("16oz", "type 0.45359237"),
            ("7 stone", "here, expected a mass in kg"),
            ("3Mg", "here, expected a mass in kg"),
            ("0,0209", "type 0.0209"),
            ("1,190", "1190"),
            ("-3", "above 0"),
            ("0", "above 0"),
            ("inf", "a mass in kg"),
            ("nan", "a mass in kg"),
            ("heavy", "a mass in kg"),
            ("1e999", "above 0"),
        ] {
            let refused = text.parse::<Kilograms>().unwrap_err();
            assert!(refused.contains(hint), "{text}: {refused}");
        }
        assert_eq!("-0.1".parse::<NotNegative>().unwrap_err(), "expected a number, 0 or more");
        assert_eq!("0".parse::<NotNegative>().unwrap().get(), 0.0);
        assert_eq!("-0.1".parse::<Metres>().unwrap_err(), "expected metres, 0 or more");
        assert!("5 mm".parse::<Metres>().unwrap_err().ends_with("type 0.005"));
        assert_eq!("1000000".parse::<Count>().map(Count::get), Ok(1e6));
        for refused in ["0", "1.5", "1000001", "1e9", "99999999999"] {
            assert_eq!(refused.parse::<Count>().unwrap_err(), "expected a whole number from 1 to 1000000");
        }
        assert!("0.5".parse::<Threshold>().is_err());
        assert!("1.01".parse::<RelativeIndentation>().is_err());
    }

    #[test]
    fn json_has_the_number_or_its_text() {
        assert_eq!(serde_json::from_str::<Kilograms>("62").unwrap().get(), 62.0);
        assert_eq!(serde_json::from_str::<Kilograms>("\"62\"").unwrap().get(), 62.0);
        assert_eq!(serde_json::to_string(&Count::new(4.0).unwrap()).unwrap(), "4.0");
        let refused = serde_json::from_str::<Kilograms>("\"62kg\"").unwrap_err().to_string();
        assert!(refused.contains("type 62"), "{refused}");
        assert!(serde_json::from_str::<Kilograms>("-1").is_err());
    }

    /// For each type, the largest allowed value is accepted, and one more is refused with both bounds in the message.
    #[test]
    fn every_count_has_a_largest_value() {
        macro_rules! bounds {
        ($($name:ident $least:literal $most:literal;)+) => {$(
            let expected = format!("expected a whole number from {} to {}", $least, $most);
            for taken in [$least, $most] {
                assert_eq!(taken.to_string().parse::<$name>().map(|count| count.to_string()), Ok(taken.to_string()));
            }
            for refused in [$least - 1, $most + 1] {
                assert_eq!(refused.to_string().parse::<$name>(), Err(expected.clone()));
            }
            for refused in ["1e9", "1000000000", "99999999999999999999", "-1", "2.5", ""] {
                assert_eq!(refused.parse::<$name>(), Err(expected.clone()), "{refused}");
            }
        )+};
    }
        bounds! {
            Samples 2 1_000_000;
            SpheresOfFoot 1 60;
            Steps 2 100_000;
            Jobs 1 4096;
            Dpi 50 2400;
        }
        assert_eq!("100000".parse::<Steps>().map(Steps::get), Ok(contact_scaling::continuation::MOST_STEPS));
    }
}
