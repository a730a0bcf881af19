//! The models on which every remedy is tried.

use std::path::{Path, PathBuf};

use serde_json::{Value, json};

use osim_model::Model;

pub const NAME: &str = "model.osim";

/// The models of the project that are one file each, and the models in the folder OSIM_CORPUS, if this variable is set.
pub fn models() -> Vec<(String, String)> {
    let fixtures = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures");
    let mut found = Vec::new();
    for folder in ["check", "table1", "format", "scale_tool", "walks", "drawn_feet"] {
        found.extend(of_folder(&fixtures.join(folder), folder));
    }
    assert!(found.len() > 100, "{}", found.len());
    if let Some(corpus) = std::env::var_os("OSIM_CORPUS") {
        found.extend(of_folder(Path::new(&corpus), "corpus"));
    }
    found
}

fn of_folder(folder: &Path, name: &str) -> Vec<(String, String)> {
    let mut paths: Vec<PathBuf> = std::fs::read_dir(folder)
        .expect("a folder of models")
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|end| end == "osim"))
        .filter(|path| !path.to_string_lossy().ends_with(".scaled.osim"))
        .collect();
    paths.sort();
    let named = |path: PathBuf| {
        // Some fixtures are no UTF-8; what those show, others show, too.
        let text = std::fs::read_to_string(&path).ok()?;
        Some((format!("{name}/{}", path.file_name()?.to_string_lossy()), text))
    };
    paths.into_iter().filter_map(named).collect()
}

/// Options of `check` with which it finds different faults in this model. The first entry has no options.
pub fn options(model: &Model) -> Vec<Value> {
    let mut all = vec![
        json!({}),
        json!({"spheres": 3}),
        json!({"stance_limbs": 2}),
        json!({"mass": 40.0}),
        json!({"gravity": 1.62}),
        json!({"mass": 900.0, "stance_limbs": 4, "gravity": 20.0}),
        json!({"impact_speed": 1.5}),
    ];
    if let Some(body) = model.bodies().last() {
        all.push(json!({"exclude_body": [body.name]}));
    }
    if let Some(first) = model.forces().first().map(|force| force.name.as_str()) {
        all.push(json!({"select": [first]}));
        all.push(json!({"select": [first], "stance_limbs": 2, "mass": 100.0}));
        all.push(json!({"exclude": [first]}));
        all.push(json!({"exclude": [first], "spheres": 2, "gravity": 5.0}));
    }
    all
}
