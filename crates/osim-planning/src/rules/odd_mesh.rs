//! The mesh of a foot does not fit the skeleton.

use std::collections::{BTreeSet, HashSet};
use std::path::Path;

use osim_model::feet::{DefaultPose, FootBodies, MeshFolders, odd_meshes};
use osim_model::files::Files;
use osim_model::{Anatomy, Example, Finding, FindingCode, Model, Repair, Rule, Seen, Severity, VerdictOn};

/// Bodies whose meshes are looked at: more than a model has feet. Each is a file to read.
const MOST_BODIES: usize = 40;
/// Among more bodies nobody looks for those near the ground, which takes longer than all other rules.
const MOST_BARE_BODIES: usize = 200;

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::OddMesh,
    severity: Severity::Warn,
    seen: Seen::Model,
    verdict: Some(VerdictOn::Sizes),
    what: "The mesh of a foot does not fit the skeleton.",
    why: "`add MODEL` with `feet` lays spheres under the lowest points of meshes, and factors between models come from them: with a file in millimetres, another animal's bone of the same name, or one broken vertex, spheres are far from where the foot is. Real feet, toes and tali are 0.136 to 0.6 of the longest bone of their limb, the longest distance between two joints of one body.",
    advice: "Correct the scale factors of the mesh, or put the file that is meant beside the model",
    repair: Repair::NotPossible("only numbers of contacts are changed"),
    example: Example::Models { good: "feet/human_40000.osim", bad: "feet/human_in_millimetres.osim" },
};

/// One finding, about the first mesh of a foot that does not fit; the model is the file at `path`.
pub(crate) fn find(model: &Model, path: &Path, files: &dyn Files) -> Option<Finding> {
    let feet = feet(model);
    if feet.is_empty() {
        return None;
    }
    let bodies: HashSet<&str> = feet.iter().take(MOST_BODIES).map(String::as_str).collect();
    let odd = odd_meshes(model, &bodies, &MeshFolders::of_model(path), files);
    let first = odd.first()?;
    let more = match odd.len() {
        1 => String::new(),
        2 => "; another mesh, too".to_owned(),
        count => format!("; {} other meshes, too", count - 1),
    };
    Some(Finding::new(&RULE, format!("{}{more}", first.text)))
}

/// The bodies of feet: those with spheres; in a model without spheres those near the ground.
fn feet(model: &Model) -> BTreeSet<String> {
    let moving = model.spheres().iter().filter(|sphere| !sphere.fixed);
    let carriers: BTreeSet<String> = moving.filter_map(|sphere| sphere.body.clone()).collect();
    if !carriers.is_empty() || model.bodies().len() > MOST_BARE_BODIES {
        return carriers;
    }
    let Ok(anatomy) = Anatomy::of(model) else { return carriers };
    let feet = FootBodies::find(model, &anatomy, &[], &[], &DefaultPose::of(model));
    feet.into_iter().flat_map(|foot| foot.bodies).collect()
}
