//! Each damage gives the finding with its name on every model that can have it, and no undamaged model gets such a finding.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use osim_model::{FindingCode, Model};
use serde_json::json;

use super::cases::{NAME, models};
use super::damage::damages;
use super::folder_in_memory::FolderInMemory;

/// For each damage, the codes that may be found. Damages that only some models can have wrongly are left out: three times the mass is right
/// for contacts that were made for it.
const NAMES: [(&str, &[&str]); 18] = [
    ("left ten times stiffer", &["left-right-differ"]),
    ("right ten times stiffer", &["left-right-differ"]),
    ("one ten times stiffer", &["left-right-differ"]),
    ("one larger", &["left-right-differ"]),
    ("one missing", &["left-right-missing", "one-side-only"]),
    ("one doubled", &["sphere-in-two-forces"]),
    ("one on the other side", &["left-right-missing", "left-right-off", "left-right-places", "odd-place"]),
    ("smoothed by 0", &["zero-constant-contact-force"]),
    ("gravity up", &["gravity-not-down"]),
    ("gravity tilted", &["gravity-not-down"]),
    ("gravity in mm/s2", &["gravity-too-large"]),
    ("floor upside down", &["floor-upside-down"]),
    ("floor upright", &["floor-upright"]),
    ("floor sloping", &["floor-slopes"]),
    ("floor in degrees", &["angle-in-degrees"]),
    ("floor on a limb", &["floor-on-limb"]),
    ("radii in millimetres", &["odd-radius"]),
    ("places in millimetres", &["odd-place"]),
];

/// Models of published feet, on which damage to feet makes sense.
fn feet() -> Vec<(String, String)> {
    let mut all = models();
    all.retain(|(name, text)| {
        let is_published =
            name.starts_with("corpus/") || name.starts_with("table1/") || name.starts_with("walks/");
        is_published && Model::parse(text.as_str()).is_ok_and(|model| is_foot(&model))
    });
    all
}

/// Whether a model has contacts under both sides of a body that stands on a level floor.
fn is_foot(model: &Model) -> bool {
    let sided =
        |side| model.forces().iter().any(|force| osim_model::Side::of_name(&force.name) == Some(side));
    sided(osim_model::Side::Left) && sided(osim_model::Side::Right)
}

fn codes_found(text: &str) -> BTreeSet<FindingCode> {
    let found = FolderInMemory::of(text, &json!({})).check(Path::new(NAME));
    found
        .into_iter()
        .flat_map(|found| found.findings.iter().map(|one| one.code()).collect::<Vec<_>>())
        .collect()
}

#[test]
fn every_damage_of_a_model_has_a_finding() {
    let mut table: BTreeMap<&str, (usize, BTreeMap<String, usize>)> = BTreeMap::new();
    let mut wrong = Vec::new();
    let feet = feet();
    for (name, text) in &feet {
        let model = Model::parse(text.as_str()).unwrap();
        let before = codes_found(text);
        for damaged in damages(text, &model) {
            let Some((what, names)) = NAMES.iter().find(|(what, _)| *what == damaged.what) else { continue };
            let after = codes_found(&damaged.text);
            let own: Vec<_> =
                after.iter().map(|code| code.as_str()).filter(|code| names.contains(code)).collect();
            let row = table.entry(what).or_default();
            row.0 += 1;
            own.iter().for_each(|code| *row.1.entry((*code).to_owned()).or_default() += 1);
            if own.is_empty() {
                wrong.push(format!("{name} [{what}]: only {after:?}"));
            }
        }
        let named = NAMES.iter().flat_map(|(_, names)| *names).copied();
        let found_before = named.filter(|code| before.iter().any(|found| found.as_str() == *code));
        // A slope is one: a remark.
        let found_before: Vec<_> = found_before.filter(|code| *code != "floor-slopes").collect();
        assert!(found_before.is_empty(), "{name}: {found_before:?}");
    }
    println!("{} models; damage: how many have it, and what it is called", feet.len());
    for (what, (count, names)) in &table {
        println!("  {what}: {count}, {names:?}");
    }
    assert!(wrong.is_empty(), "{} are not named:\n{}", wrong.len(), wrong.join("\n"));
}
