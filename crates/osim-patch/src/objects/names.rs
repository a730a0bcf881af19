//! Names of new objects: those that OpenSim takes, each once.

use foldhash::HashSet;
use osim_model::{Fault, FileId, Model, refuse_name_in_paths};

use super::references::{names, references};

/// Names that are taken in a model, or will be.
pub(super) struct Names(HashSet<String>);

impl Names {
    /// Those of the contact geometry and the forces of `model`: OpenSim renames the second of one name without a warning. Also
    /// names of geometry that it lacks and something uses: that would meet what is new.
    pub(super) fn of(model: &Model) -> Self {
        let geometry = model.spheres().iter().map(|sphere| sphere.name.clone());
        let planes = model.half_spaces().into_iter().map(|plane| plane.name);
        let members = ["ContactGeometrySet", "ForceSet"].into_iter().flat_map(|set| members(model, set));
        let mut taken: HashSet<String> = geometry.chain(planes).chain(members).collect();
        let document = model.document();
        for element in references(document) {
            taken.extend(names(&document.tree().text_of(element)).map(str::to_owned));
        }
        Self(taken)
    }

    /// `name`, or followed by a number where it is taken.
    ///
    /// # Errors
    /// OpenSim refuses models in which something is called so.
    pub(super) fn take(&mut self, name: &str) -> Result<String, Fault> {
        refuse_name_in_paths(name)?;
        let free = |name: &String| !self.0.contains(name);
        let numbered = (2_u64..).map(|number| format!("{name}_{number}"));
        let taken = std::iter::once(name.to_owned()).chain(numbered).find(free).unwrap_or_default();
        self.0.insert(taken.clone());
        Ok(taken)
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
