//! Remarks beside a picture of feet.

use std::collections::HashSet;

use osim_model::feet::{FeetFault, FootFrame};
use osim_model::messages::{Dialect, Input, listed, phrase, shown};
use osim_planning::ModelFeet;

/// What is drawn of each state, one line each; what was not available, and what is wrong with the places of spheres.
#[must_use]
pub fn feet_notes(states: &[ModelFeet], dialect: &dyn Dialect) -> String {
    states.iter().map(|state| of_state(state, dialect)).collect()
}

fn of_state(state: &ModelFeet, dialect: &dyn Dialect) -> String {
    let name = &state.name;
    let spheres: usize = state.feet.iter().map(|foot| foot.spheres.len()).sum();
    let in_ground = state.feet.iter().all(|foot| foot.frame == FootFrame::Ground);
    let pose = if in_ground { ", at the default pose" } else { "" };
    let mut text = format!(
        "{name}: {}, {}{pose}\n",
        count(state.feet.len(), "foot", "feet"),
        count(spheres, "sphere", "spheres")
    );
    if let Some(finding) = &state.misplaced {
        text.push_str(&format!(
            "{name}: {}: {}\n",
            finding.code().as_str(),
            finding.message.spelled(dialect)
        ));
    }
    if let Some(missing) = missing(state, dialect) {
        text.push_str(&format!("{name}: {missing}\n"));
    }
    text
}

fn count(number: usize, one: &str, many: &str) -> String {
    format!("{number} {}", if number == 1 { one } else { many })
}

/// Meshes that are listed; more are counted.
const LISTED: usize = 12;

/// Bones that are not drawn: meshes that were not found in one sentence, others each with what is wrong.
fn missing(state: &ModelFeet, dialect: &dyn Dialect) -> Option<String> {
    let names = missing_meshes(state);
    let mut reasons: Vec<String> = Vec::new();
    if !names.is_empty() {
        let text = phrase![
            format!("no bones are drawn of {}: name the folder of the meshes with ", listed(&names, LISTED)),
            Input::GeometryDir.like("DIR"),
        ];
        reasons.push(text.spelled(dialect));
    }
    let others = state.missing.iter().filter(|fault| !matches!(fault, FeetFault::MeshMissing { .. }));
    reasons.extend(others.map(|fault| shown(&fault.to_string()).to_string()));
    (!reasons.is_empty()).then(|| reasons.join("; "))
}

/// Meshes that were not found, each once, as the model spells them.
#[must_use]
pub fn missing_meshes(state: &ModelFeet) -> Vec<String> {
    let mut known = HashSet::new();
    let missing = state.missing.iter().filter_map(|fault| match fault {
        FeetFault::MeshMissing { mesh, .. } => Some(shown(mesh).to_string()),
        _ => None,
    });
    missing.filter(|name| known.insert(name.clone())).collect()
}
