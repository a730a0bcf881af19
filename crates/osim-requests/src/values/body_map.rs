//! Bodies that are called otherwise, in words.

use std::fmt;
use std::str::FromStr;

use crate::values::typed::trimmed;

/// `BODY=BODY`: a body of the reference, and the body of the model that takes its spheres.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct BodyMap {
    /// Name of the body of the reference.
    pub reference: String,
    /// Name of the body of the model.
    pub model: String,
}

impl FromStr for BodyMap {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let names = text.split_once('=').map(|(reference, model)| (trimmed(reference), trimmed(model)));
        match names {
            Some((reference, model)) if !reference.is_empty() && !model.is_empty() => {
                Ok(Self { reference: reference.to_owned(), model: model.to_owned() })
            }
            _ => Err("expected BODY=BODY, a body of the reference and one of the model, like toes_r=calcn_r"
                .to_owned()),
        }
    }
}

impl fmt::Display for BodyMap {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}={}", self.reference, self.model)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_names_with_an_equals_sign() {
        let map: BodyMap = "toes_r = calcn_r".parse().unwrap();
        assert_eq!((map.reference.as_str(), map.model.as_str()), ("toes_r", "calcn_r"));
        assert_eq!(map.to_string().parse::<BodyMap>(), Ok(map));
        for text in ["toes_r", "=calcn_r", "toes_r="] {
            assert!(text.parse::<BodyMap>().is_err(), "{text}");
        }
    }
}
