//! Names of new objects: those that OpenSim takes, each once.

use std::collections::HashSet;

use osim_model::wording::is_seen;
use osim_model::{Fault, FileId, Model};

/// Letters with which OpenSim refuses a whole model.
const REFUSED: &str = "\\*+/ \t\r\n\u{b}\u{c}";
/// What a name may be.
const CHOOSE: &str = "choose letters, digits, '_' or '-'";

/// Names that are taken in a model, or will be.
pub(super) struct Names(HashSet<String>);

impl Names {
    /// Those of the contact geometry and the forces of `model`: OpenSim renames the second of one name without a word.
    pub(super) fn of(model: &Model) -> Self {
        let geometry = model.spheres().iter().map(|sphere| sphere.name.clone());
        let planes = model.half_spaces().into_iter().map(|plane| plane.name);
        let members = ["ContactGeometrySet", "ForceSet"].into_iter().flat_map(|set| members(model, set));
        Self(geometry.chain(planes).chain(members).collect())
    }

    /// `name`, or followed by a number where it is taken.
    ///
    /// # Errors
    /// OpenSim refuses models in which something is called so.
    pub(super) fn take(&mut self, name: &str) -> Result<String, Fault> {
        refuse_in_paths(name)?;
        let free = |name: &String| !self.0.contains(name);
        let numbered = (2_u64..).map(|number| format!("{name}_{number}"));
        let taken = std::iter::once(name.to_owned()).chain(numbered).find(free).unwrap_or_default();
        self.0.insert(taken.clone());
        Ok(taken)
    }
}

/// Refuses a name that OpenSim would, and one with letters that nobody sees.
///
/// ```
/// assert!(osim_patch::refuse_name("heel_r").is_ok());
/// let fault = osim_patch::refuse_name("right heel").unwrap_err();
/// assert!(fault.to_string().contains("has a blank in it"), "{fault}");
/// ```
///
/// # Errors
/// An empty name, one that is a step in OpenSim's paths, or one with a letter that OpenSim or XML refuses or that is not seen.
pub fn refuse(name: &str) -> Result<(), Fault> {
    refuse_in_paths(name)?;
    match name.chars().find(|&letter| !is_seen(letter)) {
        Some(letter) => Err(Fault::refused(format!(
            "the name '{name}' has a letter in it that is not seen (U+{:04X}), perhaps from copying: {CHOOSE}",
            u32::from(letter)
        ))),
        None => Ok(()),
    }
}

/// Refuses a name that cannot be in a path of OpenSim.
fn refuse_in_paths(name: &str) -> Result<(), Fault> {
    if name.is_empty() {
        return Err(Fault::refused(
            "a contact has no name: OpenSim finds contacts by their names, so give it one",
        ));
    }
    if [".", ".."].contains(&name) {
        return Err(Fault::refused(format!(
            "the name '{name}' is a step in OpenSim's paths, so no force would find its contact: {CHOOSE}"
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

/// Refuses to call something of `model` by `name`, its name or path, where its bytes are not UTF-8: it was read with a question mark
/// for each of them, and OpenSim would not find it.
pub(super) fn refuse_misread(model: &Model, name: &str) -> Result<(), Fault> {
    if !name.contains('?') || std::str::from_utf8(model.file(FileId::MAIN).bytes()).is_ok() {
        return Ok(());
    }
    Err(Fault::refused(format!(
        "'{name}' is written with bytes that are not UTF-8, so new contacts could not be connected to it: save the model as UTF-8 in \
         a text editor, then do this again"
    )))
}

fn members(model: &Model, set: &str) -> Vec<String> {
    let document = model.document();
    let tree = document.tree();
    let objects = tree.child(document.data_root(), set).and_then(|set| tree.child(set, "objects"));
    let children = objects.into_iter().flat_map(|objects| tree.children(objects));
    children.filter_map(|id| Some(tree.attribute(id, "name")?.into_owned())).collect()
}
