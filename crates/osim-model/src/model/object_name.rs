//! Names of objects: those that OpenSim takes.

use crate::messages::is_seen;

use crate::model::fault::Fault;

/// Letters with which OpenSim refuses a whole model.
const REFUSED: &str = "\\*+/ \t\r\n\u{b}\u{c}";
/// What a name may be.
const CHOOSE: &str = "choose letters, digits, '_' or '-'";

/// Refuses a name that OpenSim would, and one with letters that nobody sees.
///
/// ```
/// assert!(osim_model::refuse_name("heel_r").is_ok());
/// let fault = osim_model::refuse_name("right heel").unwrap_err();
/// assert!(fault.to_string().contains("has a blank in it"), "{fault}");
/// ```
///
/// # Errors
/// An empty name, one that is a step in OpenSim's paths, or one with a letter that OpenSim or XML refuses or that is not seen.
pub fn refuse_name(name: &str) -> Result<(), Fault> {
    refuse_name_in_paths(name)?;
    match name.chars().find(|&letter| !is_seen(letter)) {
        Some(letter) => Err(Fault::refused(format!(
            "the name '{name}' has a letter in it that is not seen (U+{:04X}), perhaps from copying: {CHOOSE}",
            u32::from(letter)
        ))),
        None => Ok(()),
    }
}

/// Refuses a name that cannot be in a path of OpenSim.
///
/// # Errors
/// An empty name, one that is a step in OpenSim's paths, or one with a letter that OpenSim refuses.
pub fn refuse_name_in_paths(name: &str) -> Result<(), Fault> {
    if name.is_empty() {
        return Err(Fault::refused(
            "a contact has no name: OpenSim finds contacts by their names, so give it one",
        ));
    }
    if [".", ".."].contains(&name) {
        return Err(Fault::refused(format!(
            "the name '{name}' is a step in OpenSim's paths, so that nothing would find what has it: {CHOOSE}"
        )));
    }
    match name.chars().find(|&letter| REFUSED.contains(letter)) {
        Some(letter) => Err(Fault::refused(format!(
            "the name '{name}' has {} in it, with which OpenSim refuses the model: {CHOOSE}",
            match letter {
                ' ' => "a blank".to_owned(),
                '\t' => "a tab".to_owned(),
                letter if letter.is_control() => "a line break".to_owned(),
                letter => format!("'{letter}'"),
            }
        ))),
        None => Ok(()),
    }
}
