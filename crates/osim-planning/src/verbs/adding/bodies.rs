//! Names of bodies as people write them.

use osim_model::messages::{Input, phrase, shown};
use osim_requests::RequestFault;
use osim_requests::values::typed::trimmed;

/// Where OpenSim has bodies, in its paths.
const BODY_SET: &str = "/bodyset/";
/// Names that differ in at most this many letters are probably one.
const NEAR: usize = 2;

/// The bodies of a list, each once: names with commas or semicolons between them, in one text or in several.
///
/// # Errors
/// A name is missing.
pub(super) fn listed(texts: &[String]) -> Result<Vec<String>, RequestFault> {
    let mut bodies: Vec<String> = Vec::new();
    for text in texts.iter().flat_map(|text| text.split([',', ';'])).map(trimmed) {
        if text.is_empty() {
            let message = phrase![
                Input::Feet,
                ": a name is missing; expected the bodies that touch the ground with commas between them, as in ",
                Input::Feet.like("calcn_r,calcn_l"),
            ];
            return Err(RequestFault::refused(Input::Feet, message));
        }
        for body in text.split(' ').filter(|name| !name.is_empty()).map(plain) {
            if !bodies.iter().any(|known| known == body) {
                bodies.push(body.to_owned());
            }
        }
    }
    Ok(bodies)
}

/// The name of a body that is written with OpenSim's path.
pub(super) fn plain(body: &str) -> &str {
    body.strip_prefix(BODY_SET).unwrap_or(body)
}

/// `: did you mean calcn_r?`, where one of `bodies` is nearly called `body`.
pub(super) fn meant(body: &str, bodies: &[String]) -> String {
    let flat = |name: &str| name.to_lowercase();
    let apart = |known: &&String| strsim::osa_distance(&flat(known), &flat(body));
    match bodies.iter().min_by_key(apart).filter(|known| apart(known) <= NEAR) {
        Some(known) => format!(": did you mean {}?", shown(known)),
        None => String::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bodies_are_listed_with_any_separator_and_each_once() {
        for texts in [
            &["calcn_r", "calcn_l"][..],
            &["calcn_r,calcn_l"],
            &["calcn_r, calcn_l"],
            &["calcn_r;calcn_l"],
            &["calcn_r calcn_l"],
            &["/bodyset/calcn_r", " calcn_l "],
            &["calcn_r", "calcn_r", "calcn_l"],
        ] {
            let texts: Vec<String> = texts.iter().map(|text| (*text).to_owned()).collect();
            assert_eq!(listed(&texts).unwrap(), ["calcn_r", "calcn_l"], "{texts:?}");
        }
        for texts in [&["calcn_r", ""][..], &[""], &["calcn_r,,calcn_l"], &[" "]] {
            let texts: Vec<String> = texts.iter().map(|text| (*text).to_owned()).collect();
            assert!(listed(&texts).is_err(), "{texts:?}");
        }
        assert!(listed(&[]).unwrap().is_empty());
    }

    #[test]
    fn names_that_are_nearly_right_are_proposed() {
        let bodies = ["pelvis", "calcn_r", "calcn_l"].map(str::to_owned);
        assert_eq!(meant("Calcn_R", &bodies), ": did you mean calcn_r?");
        assert_eq!(meant("calc_l", &bodies), ": did you mean calcn_l?");
        assert_eq!(meant("hoof_r", &bodies), "");
    }
}
