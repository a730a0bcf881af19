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

use crate::front_end::{Changed, files_of, read, request};
use crate::support::Bench;

fn digest(bytes: &[u8]) -> String {
    Sha256::digest(bytes).iter().map(|byte| format!("{byte:02x}")).collect()
}

fn digests(opened: &OpenModel) -> Vec<NamedDigest> {
    opened.files().map(|(name, bytes)| NamedDigest { name: name.to_owned(), sha256: digest(bytes) }).collect()
}

/// The page about one model.
fn page(verb: Verb, model: &str, columns: Columns, words: &str, entry: Entry) -> String {
    let about = About::new(verb, Some(model.to_owned()), columns, format!("osim-contact-scale {words}"));
    let mut page = Page::new(about, DeferredParts::<Texts>::default(), &CommandLine);
    page.add(entry);
    let mut bytes = Vec::new();
    page.finish(&mut bytes).unwrap();
    String::from_utf8(bytes).unwrap()
}

#[test]
fn of_an_inspection() {
    let bench = Bench::human();
    let files = files_of(&bench);
    let request = request!(Inspect, {"verb": "inspect", "models": "human.osim"});
    let inspector = Inspector::for_inspect(&request, &files);
    let opened = open_with(&request.models[0], inspector.set_files().companion_paths(), &files).unwrap();
    let mut inspected = inspector.inspect(&opened).unwrap();
    let mut found = inspector.check(&opened.model, &inspected, None, &files);
    inspected.spell(&CommandLine);
    found.spell(&CommandLine);
    let mut feet = ModelFeet::of_selection(opened.name(), &opened, &inspector.options().selection).unwrap();
    feet.add_bones(&opened.model, &request.models[0], None, &files);
    let shown = InspectedModelOnPage {
        recording: None,
        options: inspector.options(),
        model: &opened,
        examined: InspectedAndChecked { inspection: &inspected, check: &found },
        files: &digests(&opened),
        feet: Some(feet),
    };
    let entry = osim_view::html::entry_of_inspected_model(shown, DetailLevel::Alone, &CommandLine);
    let words = "inspect human.osim --report page.html";
    bench.run(words).done().wrote(&["page.html"]);
    assert_eq!(
        page(Verb::Inspect, "human.osim", Columns::Inspections, words, entry),
        bench.text("page.html")
    );
}

/// The page of a change, made in memory and by the command.
#[track_caller]
fn same_page(bench: &Bench, verb: Verb, words: &str, json: &serde_json::Value) {
    let files = files_of(bench);
    let change = prepare(read(json), &files).unwrap();
    let path = change.models[0].as_path();
    let changed = Changed::new(&change, path, &files).unwrap();
    let new_files = || changed_files(path, &change.set_files.companion_paths(), &files, &changed);
    let both =
        BeforeAfter::of_plan(&change, &changed.opened, &changed.plan, new_files, &CommandLine, true).unwrap();

    let (shown, names) = (changed.opened.name().to_string(), changed.names());
    let mut row = RunRow::new(shown.as_str(), "written");
    row.output = names.first().cloned();
    row.contacts_mass_kg = changed.plan.masses.as_ref().map(|masses| masses.contacts_mass.kg);
    row.target_mass_kg = changed.plan.masses.as_ref().map(|masses| masses.target_mass_kg);
    row.changes = changed.plan.changes.len() + changed.plan.moves.len();
    let outputs = changed
        .results
        .iter()
        .zip(&names)
        .map(|(made, name)| NamedDigest { name: name.clone(), sha256: digest(&made.bytes) });
    let told = Files {
        inputs: digests(&changed.opened),
        result: format!("written: {}", names.join(", ")),
        outputs: outputs.collect(),
    };
    let mut shows = osim_view::html::ChangedModelOnPage::of_states(&changed.plan, &both, told);
    if let Some(feet) = shows.feet.last_mut() {
        feet.add_bones(&changed.opened.model, path, None, &files);
    }
    shows.in_file = true;
    let entry = osim_view::html::entry_of_changed_model(&row, shows, DetailLevel::Alone, &CommandLine);

    let words = format!("{words} --report page.html");
    bench.run(&words).done();
    assert_eq!(page(verb, &shown, Columns::Changes, &words, entry), bench.text("page.html"), "{words}");
}

/// The files of the model as they are after the change.
fn changed_files(
    path: &Path,
    beside: &CompanionPaths<'_>,
    files: &InMemory,
    changed: &Changed,
) -> ModelFiles {
    let bytes = changed.opened.files().next().unwrap().1.to_vec();
    let before = ModelFiles::read(path, bytes, *beside, files).unwrap();
    changed.as_files(&before)
}

#[test]
fn of_a_change() {
    same_page(
        &Bench::human(),
        Verb::Rescale,
        "rescale human.osim --target-mass 500",
        &json!({"verb": "rescale", "models": "human.osim", "target_mass": 500}),
    );
    same_page(
        &Bench::human(),
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
fn of_a_change_to_a_standalone_force_set() {
    let bench = Bench::with(&[
        ("format/standalone_ForceSet.xml", "forces.xml"),
        ("format/standalone_ContactGeometrySet.xml", "geometry.xml"),
    ]);
    same_page(
        &bench,
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
