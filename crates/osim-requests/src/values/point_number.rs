//! The number of one point of a grid, or step of a ladder.

use std::str::FromStr;

use serde::Deserializer;

use super::serial;
use crate::values::typed::trimmed;

/// The number of one point, from 1. There is none beyond counting.
struct PointNumber(usize);

impl FromStr for PointNumber {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let expected = || "expected the number of one point, counted from 1".to_owned();
        trimmed(text).parse().map(Self).map_err(|_| expected())
    }
}

/// Reads one from a word of the command line.
#[cfg(feature = "clap")]
pub(crate) fn of_word(text: &str) -> Result<usize, String> {
    text.parse().map(|PointNumber(number)| number)
}

/// Reads one from JSON.
pub(crate) fn deserialize<'d, D: Deserializer<'d>>(deserializer: D) -> Result<Option<usize>, D::Error> {
    let number: Option<PointNumber> = serial::optional_from_text(deserializer)?;
    Ok(number.map(|PointNumber(number)| number))
}
