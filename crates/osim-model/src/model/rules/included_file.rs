//! Contacts are in a file that the model includes.

use foldhash::{HashSet, HashSetExt};

use crate::model::fault::FileId;
use crate::model::finding::{Example, Finding, FindingCode, Repair, Rule, Seen, Severity};
use crate::model::typed_model::Model;

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::IncludedFile,
    severity: Severity::Info,
    seen: Seen::Model,
    verdict: None,
    what: "Contacts are in a file that the model includes.",
    why: "The contacts were read from the file that the model names; a change would have to go into that file too.",
    advice: "Save the model in OpenSim as one file before rescaling it",
    repair: Repair::NotPossible("the file may serve other models, too"),
    example: Example::Models { good: "format/v40000.osim", bad: "format/file_forceset.osim" },
};

/// Contacts that are in included files can be read but not changed.
pub(super) fn find(model: &Model) -> Vec<Finding> {
    let mut found = Vec::new();
    let forces = model.forces().iter().map(|force| (force.file, &force.path));
    let spheres = model.spheres().iter().map(|sphere| (sphere.file, &sphere.path));
    let mut said: HashSet<FileId> = HashSet::new();
    for (file, path) in forces.chain(spheres) {
        if let (Some(name), false) = (model.included_file(file), said.contains(&file)) {
            let text = format!("{path} and others are in the file '{name}' that the model includes");
            found.push(Finding::new(&RULE, text));
            said.insert(file);
        }
    }
    found
}
