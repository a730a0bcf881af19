//! The HTML page: of a model that was inspected, and of one that was changed.

use std::path::Path;

use osim_model::files::{CompanionPaths, InMemory, ModelFiles, OpenModel};
use osim_model::messages::Verb;
use osim_planning::{BeforeAfter, Inspector, ModelFeet, open_with, prepare};
use osim_requests::spell::CommandLine;
use osim_view::html::{
    About, Columns, DeferredParts, DetailLevel, Entry, Files, InMemory as Texts, InspectedAndChecked,
    InspectedModelOnPage, NamedDigest, Page, RunRow,
};
use serde_json::json;
use sha2::{Digest, Sha256};

use crate::front_end::{Changed, files_in_memory, request, request_from_json};
use crate::support::TestDir;

fn digest(bytes: &[u8]) -> String {
    Sha256::digest(bytes).iter().map(|byte| format!("{byte:02x}")).collect()
}

fn digests(opened: &OpenModel) -> Vec<NamedDigest> {
    opened.files().map(|(name, bytes)| NamedDigest { name: name.to_owned(), sha256: digest(bytes) }).collect()
}

/// The page about one model.
fn write_page(verb: Verb, model: &str, columns: Columns, words: &str, entry: Entry) -> String {
    let about = About::new(verb, Some(model.to_owned()), columns, format!("osim-contact-scale {words}"));
    let mut page = Page::new(about, DeferredParts::<Texts>::default(), &CommandLine);
    page.add(entry);
    let mut bytes = Vec::new();
    page.finish(&mut bytes).unwrap();
    String::from_utf8(bytes).unwrap()
}

#[test]
fn the_page_of_an_inspection_equals_the_command() {
    let dir = TestDir::with_human();
    let files = files_in_memory(&dir);
    let request = request!(Inspect, {"verb": "inspect", "models": "human.osim"});
    let inspector = Inspector::for_inspect(&request, &files);
    let opened = open_with(&request.models[0], inspector.set_files().companion_paths(), &files).unwrap();
    let mut inspected = inspector.inspect(&opened).unwrap();
    let mut check = inspector.check(&opened.model, &inspected, None, &files);
    inspected.spell(&CommandLine);
    check.spell(&CommandLine);
    let mut feet = ModelFeet::of_selection(opened.name(), &opened, &inspector.options().selection).unwrap();
    feet.add_bones(&opened.model, &request.models[0], None, &files);
    let examined = InspectedModelOnPage {
        recording: None,
        options: inspector.options(),
        model: &opened,
        examined: InspectedAndChecked { inspection: &inspected, check: &check },
        files: &digests(&opened),
        feet: Some(feet),
    };
    let entry = osim_view::html::entry_of_inspected_model(examined, DetailLevel::Alone, &CommandLine);
    let words = "inspect human.osim --report page.html";
    dir.run(words).succeeded().wrote(&["page.html"]);
    assert_eq!(
        write_page(Verb::Inspect, "human.osim", Columns::Inspections, words, entry),
        dir.text("page.html")
    );
}

/// Writes the page of a change in memory and by the command: both must be equal.
#[track_caller]
fn assert_same_page(dir: &TestDir, verb: Verb, words: &str, json: &serde_json::Value) {
    let files = files_in_memory(dir);
    let change = prepare(request_from_json(json), &files).unwrap();
    let path = change.models[0].as_path();
    let changed = Changed::new(&change, path, &files).unwrap();
    let new_files = || changed_files(path, &change.set_files.companion_paths(), &files, &changed);
    let before_after =
        BeforeAfter::of_plan(&change, &changed.opened, &changed.plan, new_files, &CommandLine, true).unwrap();

    let (examined, names) = (changed.opened.name().to_string(), changed.names());
    let mut row = RunRow::new(examined.as_str(), "written");
    row.output = names.first().cloned();
    row.contacts_mass_kg = changed.plan.masses.as_ref().map(|masses| masses.contacts_mass.kg);
    row.target_mass_kg = changed.plan.masses.as_ref().map(|masses| masses.target_mass_kg);
    row.changes = changed.plan.changes.len() + changed.plan.moves.len();
    let outputs = changed
        .results
        .iter()
        .zip(&names)
        .map(|(file, name)| NamedDigest { name: name.clone(), sha256: digest(&file.bytes) });
    let files_of_page = Files {
        inputs: digests(&changed.opened),
        result: format!("written: {}", names.join(", ")),
        outputs: outputs.collect(),
    };
    let mut changed_entry =
        osim_view::html::ChangedModelOnPage::of_states(&changed.plan, &before_after, files_of_page);
    if let Some(feet) = changed_entry.feet.last_mut() {
        feet.add_bones(&changed.opened.model, path, None, &files);
    }
    changed_entry.in_file = true;
    let entry =
        osim_view::html::entry_of_changed_model(&row, changed_entry, DetailLevel::Alone, &CommandLine);

    let words = format!("{words} --report page.html");
    dir.run(&words).succeeded();
    assert_eq!(
        write_page(verb, &examined, Columns::Changes, &words, entry),
        dir.text("page.html"),
        "{words}"
    );
}

/// The files of the model after the change.
fn changed_files(
    path: &Path,
    companions: &CompanionPaths<'_>,
    files: &InMemory,
    changed: &Changed,
) -> ModelFiles {
    let bytes = changed.opened.files().next().unwrap().1.to_vec();
    let before = ModelFiles::read(path, bytes, *companions, files).unwrap();
    changed.as_files(&before)
}

#[test]
fn the_page_of_a_change_equals_the_command() {
    assert_same_page(
        &TestDir::with_human(),
        Verb::Rescale,
        "rescale human.osim --target-mass 500",
        &json!({"verb": "rescale", "models": "human.osim", "target_mass": 500}),
    );
    assert_same_page(
        &TestDir::with_human(),
        Verb::Rescale,
        "rescale human.osim --target-mass 500 --target-gravity 1.62 --no-note",
        &json!({
            "verb": "rescale",
            "models": "human.osim",
            "target_mass": 500,
            "target_gravity": 1.62,
            "no_note": true,
        }),
    );
}

#[test]
fn the_page_of_a_changed_force_set_equals_the_command() {
    let dir = TestDir::with(&[
        ("format/standalone_ForceSet.xml", "forces.xml"),
        ("format/standalone_ContactGeometrySet.xml", "geometry.xml"),
    ]);
    assert_same_page(
        &dir,
        Verb::Design,
        "design forces.xml --geometry geometry.xml --mass 61.5 --spheres 1 --gravity 9.81 --indentation 0.16 \
         --radius 0.04",
        &json!({
            "verb": "design",
            "models": "forces.xml",
            "geometry": "geometry.xml",
            "mass": 61.5,
            "spheres": 1,
            "gravity": 9.81,
            "indentation": 0.16,
            "radius": 0.04,
        }),
    );
}
