//! The rule by which two surfaces make one modulus, as a word.

use contact_scaling::modulus::MixingRule;

/// The words for a rule; the first is OpenSim's, and what is meant where none is given.
pub(crate) const RULES: [(&str, MixingRule); 2] =
    [("sherman", MixingRule::Sherman), ("johnson", MixingRule::Johnson)];

/// The rule of this name.
pub(crate) fn rule(name: &str) -> Option<MixingRule> {
    RULES.iter().find(|(known, _)| *known == name).map(|(_, rule)| *rule)
}
