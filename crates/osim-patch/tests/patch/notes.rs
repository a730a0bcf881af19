//! Tests of the note in a model: its place, its content after later changes, and its removal without a trace.

#![allow(clippy::disallowed_methods, reason = "tests cut their own texts")]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

use crate::given::{fixture, fixtures, given, given_fixture};
use osim_model::compare::ScaleFile;
use osim_model::{FileId, MassRequest, MassSource, Model, Selection};
use osim_patch::{Plan, Rescale, note, rescale};

fn patched_text(plan: &Plan, model: &Model) -> String {
    String::from_utf8_lossy(&plan.patched(model, FileId::MAIN).unwrap()).into_owned()
}

/// The fixture with a note that its contacts were made for 62 kg.
fn fixture_with_note(name: &str) -> String {
    let model = Model::parse(fixture(name)).unwrap();
    patched_text(&note(&model, 62.0, Some(9.81), None).unwrap(), &model)
}

fn credits_fixtures() -> Vec<String> {
    let names: Vec<String> =
        fixtures("format").into_iter().filter(|name| name.contains("/credits_")).collect();
    assert!(names.len() >= 13, "{names:?}");
    names
}

#[test]
fn the_text_of_the_credits_stays_and_the_note_ends_it() {
    let note = |text: &str| {
        let (_, rest) = text.split_once("[contacts made for ").unwrap();
        format!("[contacts made for {}", &rest[..rest.find(")]").unwrap() + 2])
    };
    for (name, before, after) in [
        ("some", "A. Author; B. Author<", "A. Author; B. Author; NOTE<"),
        ("empty", "<credits></credits>", "<credits>NOTE</credits>"),
        ("self_closing", "<credits/>", "<credits>NOTE</credits>"),
        ("blank", "<credits>  </credits>", "<credits>NOTE  </credits>"),
        ("twice", "A. Author</credits><credits>B. Author<", "A. Author; NOTE</credits><credits>B. Author<"),
        ("semicolon", "A. Author;<", "A. Author;; NOTE<"),
        ("comment_behind", "A. Author <!-- checked --><", "A. Author; NOTE <!-- checked --><"),
        ("comment_before", "<!-- checked --> A. Author<", "<!-- checked --> A. Author; NOTE<"),
        ("comment_only", "<credits><!-- none --><", "<credits>NOTE<!-- none --><"),
        ("cdata", "A. Author & Co.]]>", "A. Author & Co.; NOTE]]>"),
        ("brackets", "[contacts made for fun]<", "[contacts made for fun]; NOTE<"),
    ] {
        let name = format!("format/credits_{name}.osim");
        let with = fixture_with_note(&name);
        let text = String::from_utf8_lossy(&fixture(&name)).into_owned();
        let last = with.rfind("[contacts made for ").unwrap();
        let expected = text.replacen(before, after, 1);
        assert_ne!(expected, text, "{name}");
        assert_eq!(with.replacen(&note(&with[last..]), "NOTE", 1), expected, "{name}");
    }
    let in_defaults = fixture_with_note("format/credits_in_defaults.osim");
    assert!(in_defaults.contains("<credits>A. Default</credits></Model></defaults>"), "{in_defaults}");
    assert!(in_defaults.contains("</gravity>\n\t\t<credits>[contacts made for 62 kg"), "{in_defaults}");
}

#[test]
fn removing_the_note_restores_the_file() {
    for name in credits_fixtures().into_iter().chain(["format/v40600.osim".to_owned()]) {
        let there = given_fixture(&name).with_note().standing_for(10.0).rescaled_to(80.0);
        // Rescaled back by 1/8 every number is what it was, up to its last bits and its spelling.
        let back = given(there.bytes()).rescaled_to(10.0);
        let without_rounding = |bytes: &[u8]| {
            let text = String::from_utf8_lossy(bytes).into_owned();
            let lines = text.lines().filter(|line| {
                !["dissipation>", "_smoothing>", "_force>"].iter().any(|tag| line.contains(tag))
            });
            lines.map(str::to_owned).collect::<Vec<_>>()
        };
        assert_eq!(without_rounding(back.bytes()), without_rounding(&fixture(&name)), "{name}");
    }
}

#[test]
fn a_replaced_note_keeps_its_content() {
    for name in credits_fixtures() {
        let once = fixture_with_note(&name);
        let model = Model::parse(once.as_str()).unwrap();
        let (mass, _) = MassRequest::default().contacts_mass(&model).unwrap();
        assert_eq!((mass.kg, mass.source), (62.0, MassSource::Note), "{name}");
        // The same mass again: nothing to change.
        let again = note(&model, 62.0, Some(9.81), None).unwrap();
        assert!(again.is_empty() && again.findings.iter().any(|w| w.code().as_str() == "nothing-to-change"));
        assert_eq!(patched_text(&again, &model), once, "{name}");
        // Another one: the note is replaced, and only that.
        let other = patched_text(&note(&model, 70.0, Some(9.81), None).unwrap(), &model);
        assert_eq!(other.replace("made for 70 kg", "made for 62 kg"), once, "{name}");
    }
}

#[test]
fn a_note_keeps_the_body_sizes_for_which_spheres_are_placed() {
    let generic = fixture_with_note("scale_tool/generic_smooth.osim");
    let sizes = |text: &str| Model::parse(text).unwrap().note.unwrap().sizes;
    assert!(!sizes(&generic).is_empty());
    // What OpenSim's scaling does to meshes: the note and the spheres stay.
    let scaled = generic
        .replace("<scale_factors>1.01 1 1.02</scale_factors>", "<scale_factors>0.5 0.6 0.7</scale_factors>");
    assert_ne!(scaled, generic);
    assert_eq!(sizes(&scaled), sizes(&generic));
    // Rescaling parameters does not move spheres, so the new note says the old sizes.
    let rescaled = given(scaled).with_note().rescaled_to(20.0);
    assert_eq!(sizes(&String::from_utf8_lossy(rescaled.bytes())), sizes(&generic));
}

#[test]
fn a_file_that_open_sim_refuses_is_refused_with_the_place_of_the_error() {
    for name in ["text_and_cdata", "two_cdata", "comment_inside", "element_inside"] {
        let fault = Model::parse(fixture(&format!("bad/credits_{name}.osim"))).unwrap_err();
        assert_eq!(fault.code(), "broken-text", "{name}");
        assert!(fault.to_string().contains("credits"), "{fault}");
        assert!(fault.position.is_some(), "{name}");
    }
}

#[test]
fn a_note_has_a_new_size_only_for_bodies_whose_spheres_all_followed() {
    let scaled = fixture_with_note("scale_tool/generic_smooth.osim").replace(
        "<scale_factors>1.01 1 1.02</scale_factors>",
        "<scale_factors>0.505 0.5 0.51</scale_factors>",
    );
    let model = Model::parse(scaled.as_str()).unwrap();
    let factors = model.scaled_since_note().unwrap().factors;
    assert!(
        factors.values().all(|factors| factors.iter().all(|factor| (factor - 0.5).abs() < 1e-15)),
        "{factors:?}"
    );
    let follow = |glob: &str| {
        let selection = Selection { select: vec![glob.parse().unwrap()], ..Selection::default() };
        let selected = selection.apply(&model).unwrap();
        let (mass, _) = MassRequest::default().contacts_mass(&model).unwrap();
        let mut wanted = Rescale::new(20.0, mass);
        wanted.bodies = Some(ScaleFile::from_factors(factors.clone()));
        rescale(&model, &selected, &wanted).unwrap()
    };
    let size = |plan: &Plan, body: &str| {
        let note = plan.note().unwrap().clone();
        note.sizes.into_iter().find(|size| size.body == body).map(|size| size.factors)
    };
    let right = follow("*_r");
    assert_eq!(size(&right, "calcn_r"), Some([0.505, 0.5, 0.51]));
    assert_eq!(size(&right, "calcn_l"), Some([1.01, 1.0, 1.02]), "its spheres are where they were");
    assert!(!right.note().unwrap().has_placed_spheres());
    // A body of which only some spheres followed has no one size.
    assert_eq!(size(&follow("*heel_r"), "calcn_r"), None);
    assert!(follow("*").note().unwrap().has_placed_spheres());
    // What was placed stays so while spheres stay, whatever is done to parameters.
    let all = patched_text(&follow("*"), &model);
    let again = given(all).with_note().rescaled_to(25.0);
    assert!(again.plan().note().unwrap().has_placed_spheres());
}

#[test]
fn bytes_outside_the_note_stay_in_any_encoding() {
    // What Windows writes for an umlaut and for a dash, where the file says UTF-8.
    const NOT_UTF8: &[u8] = b"M\xFCller \x96";
    let position = |bytes: &[u8], part: &[u8]| bytes.windows(part.len()).position(|window| window == part);
    let text = fixture("format/credits_some.osim");
    let at = position(&text, b"A. Author").unwrap();
    let odd = [&text[..at], NOT_UTF8, b"; ", &text[at..]].concat();
    let noted = |bytes: &[u8], contacts_mass_kg: f64| {
        let model = Model::parse(bytes).unwrap();
        note(&model, contacts_mass_kg, Some(9.81), None).unwrap().patched(&model, FileId::MAIN).unwrap()
    };
    let with = noted(&odd, 62.0);
    assert!(position(&with, NOT_UTF8).is_some(), "{}", String::from_utf8_lossy(&with));

    // A note in the middle is replaced by one at the end.
    let note_at = position(&with, b"; [contacts").unwrap();
    let end = note_at + position(&with[note_at..], b")]").unwrap() + 2;
    let again = noted(&[&with[..end], b"; B. ", NOT_UTF8, &with[end..]].concat(), 70.0);
    let shown = String::from_utf8_lossy(&again).into_owned();
    let first = position(&again, NOT_UTF8).unwrap();
    assert!(position(&again[first + 1..], NOT_UTF8).is_some(), "{shown}");
    assert_eq!(shown.matches("[contacts made for 70 kg").count(), 1, "{shown}");
    assert!(!shown.contains("62 kg at"), "{shown}");
}

// The steps that a note records.

/// `text` after its contacts are rescaled to `kg`.
fn rescaled_again(text: &str, kg: f64) -> String {
    String::from_utf8(given(text.to_owned()).with_note().rescaled_to(kg).bytes().to_vec()).unwrap()
}

fn noted_operations(text: &str) -> Vec<String> {
    let model = Model::parse(text).unwrap();
    let steps = model.note.unwrap().steps.into_iter();
    steps
        .map(|step| match step.from_mass_kg {
            Some(kg) => format!("{} from {kg}", step.operation),
            None => step.operation,
        })
        .collect()
}

#[test]
fn a_note_lists_every_operation_and_changes_by_others() {
    let text = rescaled_again(&fixture_with_note("table1/human_62kg_smooth_sphere.osim"), 124.0);
    assert_eq!(noted_operations(&text), ["note", "rescale from 62"]);
    let edited = text.replacen("<dissipation>", "<dissipation>1", 1);
    let model = Model::parse(edited).unwrap();
    let again = patched_text(&note(&model, 124.0, Some(9.81), Some(2.0)).unwrap(), &model);
    assert_eq!(noted_operations(&again), ["note", "rescale from 62", "others", "note"]);
    assert_eq!(Model::parse(again).unwrap().noted_stance_limbs(), Some(2.0));
}

#[test]
fn the_first_and_the_latest_of_many_steps_are_kept() {
    let first = fixture_with_note("table1/human_62kg_smooth_sphere.osim");
    let text = (1..=12).fold(first, |text, step| rescaled_again(&text, 62.0 + f64::from(step)));
    let kept = noted_operations(&text);
    assert_eq!((kept.len(), kept[0].as_str(), kept[7].as_str()), (8, "note", "rescale from 73"));
}
