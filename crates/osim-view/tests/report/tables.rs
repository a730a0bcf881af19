//! Tests of tables and CSV.

use osim_inspect::{Figure, InspectOptions};
use osim_model::FileId;
use osim_model::messages::shortest;
use osim_requests::CheckRequest;
use osim_requests::spell::{CommandLine, Python};
use osim_view::report::extent::{Extent, Layout};
use osim_view::report::layout::Colour;
use osim_view::report::{check, inspection, plan};

use crate::support::{inspected, open, rescaled};

const SMOOTH_MODEL: &str = "table1/human_62kg_smooth_sphere.osim";
const MODEL_OF_MIXED_RADII: &str = "format/mixed_radii.osim";

#[test]
fn a_model_is_told_in_80_columns() {
    let model = open(SMOOTH_MODEL);
    let (seen, _) = inspected(&InspectOptions::default(), &model, &CommandLine);
    let text = inspection::text(&seen, &CommandLine, Layout::default());
    assert!(text.lines().all(|line| line.chars().count() <= 80), "{text}");
    insta::assert_snapshot!("inspection", text);
}

#[test]
fn a_table_says_what_to_do_next_in_the_words_of_its_front_end() {
    let model = open("check/beyond_hertz.osim");
    let (seen, _) = inspected(&InspectOptions::default(), &model, &Python);
    let text = inspection::text(&seen, &Python, Layout::default());
    assert!(text.contains("(! outside the limit: ocs.check(\"model.osim\") says more)"), "{text}");
}

#[test]
fn colours_are_all_that_they_add() {
    let model = open("check/wide_transition.osim");
    let (seen, found) = inspected(&InspectOptions::default(), &model, &CommandLine);
    for [plain, painted] in [
        [Colour::Plain, Colour::Ansi]
            .map(|colour| inspection::text(&seen, &CommandLine, Layout { colour, ..Layout::default() })),
        [Colour::Plain, Colour::Ansi]
            .map(|colour| check::text(&found, &CommandLine, Layout { colour, ..Layout::default() })),
    ] {
        assert!(!plain.contains('\u{1b}') && painted.contains('\u{1b}'));
        let stripped: String = painted
            .split('\u{1b}')
            .enumerate()
            .map(|(index, piece)| if index == 0 { piece } else { piece.split_once('m').unwrap().1 })
            .collect();
        assert_eq!(stripped, plain);
    }
}

/// The length of the longest line in letters, without blanks at its end.
fn longest_line(text: &str) -> usize {
    text.lines().map(|line| line.chars().count()).max().unwrap()
}

/// Three models in one folder, and one that could not be read.
fn models() -> inspection::ModelsTable {
    let mut table = inspection::ModelsTable::default();
    for (fixture, folder) in
        [(SMOOTH_MODEL, "adults"), (MODEL_OF_MIXED_RADII, "animals"), ("bad/no_contacts.osim", "animals")]
    {
        let (mut seen, found) = inspected(&InspectOptions::default(), &open(fixture), &CommandLine);
        seen.model = format!("/study/{folder}/{}", fixture.rsplit('/').next().unwrap());
        table.add(&seen, found.counts);
    }
    table.add_failed("/study/animals/damaged.osim", "malformed-xml");
    table
}

#[test]
fn many_models_fit_any_terminal() {
    let table = models();
    for width in [140, 100, 80, 60] {
        let text = table.text(Some(width), &CommandLine, Colour::Plain, true);
        assert!(longest_line(&text) <= width.max(80), "{width}:\n{text}");
        let rows: Vec<&str> = text.lines().filter(|line| line.contains(".osim")).collect();
        assert!(rows.iter().all(|row| row.chars().count() <= width), "{width}:\n{text}");
        // What a narrow terminal has no room for is named; findings never go.
        assert_eq!(text.contains("left out for want of room"), width < 100, "{width}:\n{text}");
        assert!(text.starts_with("/study/: \n") || text.starts_with("/study/:"), "{text}");
        assert!(text.contains("findings") && text.contains("not read"), "{text}");
    }
}

#[test]
fn a_pipe_gets_whole_names_and_all_columns() {
    let text = models().text(None, &CommandLine, Colour::Plain, true);
    assert!(text.contains("/study/adults/human_62kg_smooth_sphere.osim"), "{text}");
    for heading in ["kg", "n", "class", "E1*", " R ", "x/R", "c_r", "findings"] {
        assert!(text.lines().next().unwrap().contains(heading), "{heading}:\n{text}");
    }
    // One of the three has no contacts, and that is no finding.
    assert!(text.ends_with(", 1 without contacts, 1 not read\n") && text.contains("4 models, "), "{text}");
    insta::assert_snapshot!("models", text);
}

#[test]
fn every_column_has_a_name_of_its_own_that_matlab_takes() {
    let (seen, _) = inspected(&InspectOptions::default(), &open(SMOOTH_MODEL), &CommandLine);
    let rows = inspection::csv_rows(&seen, true).unwrap();
    let names: Vec<&str> = rows.lines().next().unwrap().split(',').collect();
    for (index, name) in names.iter().enumerate() {
        // A variable of MATLAB has at most 63 letters; longer ones are cut, and no longer found.
        assert!(name.len() <= 63 && name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_'), "{name}");
        assert!(!names[..index].contains(name), "{name} is there twice");
    }
    let first: Vec<&str> = rows.lines().nth(1).unwrap().split(',').collect();
    let value = |name: &str| first[names.iter().position(|one| *one == name).unwrap()];
    // The 62 kg human of Table 1: 62 kg on 6 spheres of 0.032 m, E1* = 1 MPa, 62 * 9.81 / 6 N on each sphere.
    for (name, expected) in [
        ("mass_kg", 62.0),
        ("spheres_sharing_body_weight", 6.0),
        ("radius_m", 0.032),
        ("stiffness_N_per_m2", 1e6),
        ("load_at_1_body_weight_N", 62.0 * 9.81 / 6.0),
    ] {
        let seen: f64 = value(name).parse().unwrap();
        assert!((seen / expected - 1.0).abs() < 1e-12, "{name}: {seen}");
    }
}

#[test]
fn csv_has_one_row_for_each_sphere_that_stands() {
    let model = open(SMOOTH_MODEL);
    let (seen, found) = inspected(&InspectOptions::default(), &model, &CommandLine);
    let rows = inspection::csv_rows(&seen, true).unwrap();
    let spheres: usize = seen.figures.limbs.iter().map(|limb| limb.spheres.len()).sum();
    assert_eq!(rows.lines().count(), 1 + spheres);
    assert!(
        rows.starts_with("model_file,model_name,mass_kg,mass_contacts_were_made_for_kg,gravity_m_per_s2,"),
        "{rows}"
    );
    let without = inspection::csv_rows(&seen, false).unwrap();
    assert_eq!(rows.split_once('\n').unwrap().1, without);
    let rows = check::csv_rows(&found, true).unwrap();
    assert_eq!(rows.lines().count(), 1 + found.findings.len());
}

#[test]
fn findings_are_told_with_what_to_do() {
    let model = open(MODEL_OF_MIXED_RADII);
    let (_, found) = inspected(&InspectOptions::default(), &model, &CommandLine);
    let text = check::text(&found, &CommandLine, Layout::default());
    insta::assert_snapshot!("check", text);
}

#[test]
fn a_library_of_models_is_shown_as_one_table() {
    let results = vec![check::RESULTS_FOLDER.into()];
    let call = CheckRequest { models: vec!["models".into()], ..CheckRequest::default() };
    let mut library = check::LibraryTable::new(call, results);
    for name in [SMOOTH_MODEL, MODEL_OF_MIXED_RADII, "check/sunk_in.osim", "check/floats.osim"] {
        library.add(&inspected(&InspectOptions::default(), &open(name), &CommandLine).1);
    }
    library.add_failed("broken.osim", "malformed-xml");
    insta::assert_snapshot!("library", library.text(&CommandLine, Layout::default()));
    // A name is shortened by the folder itself, not by the beginning of another folder's name.
    for (folder, shown) in [("check/", " floats.osim"), ("che", " check/floats.osim")] {
        let models = vec![folder.into()];
        let call = CheckRequest { models, ..CheckRequest::default() };
        let mut library = check::LibraryTable::new(call, Vec::new());
        library.add(&inspected(&InspectOptions::default(), &open("check/floats.osim"), &CommandLine).1);
        let text = library.text(&CommandLine, Layout::default());
        assert!(text.contains(shown), "{text}");
    }
}

#[test]
fn a_plan_is_told_in_full_in_a_line_and_as_a_diff() {
    let model = open(SMOOTH_MODEL);
    let plan = rescaled(&model.model, 500.0, &CommandLine);
    let dry = "dry run: nothing written";
    insta::assert_snapshot!("plan", plan::text(&plan, SMOOTH_MODEL, dry, None));
    insta::assert_snapshot!("plan_line", plan::line(&plan, SMOOTH_MODEL, dry));
    let new = plan.patched(&model.model, FileId::MAIN).unwrap();
    let diff = plan::unified_diff(model.model.document().bytes(), &new, "old.osim", "new.osim");
    let (added, removed) = (diff.matches("\n+").count(), diff.matches("\n-").count());
    let inserted = plan.changes.iter().filter(|change| change.inserted).count();
    // The note is in the line of the credits.
    assert_eq!(removed, plan.changes.len() - inserted + 1, "{diff}");
    // The header has one, and the line of the credits is another.
    assert_eq!(added, plan.changes.len() + 2, "{diff}");
}

#[test]
fn in_full_an_inspection_has_every_digit_and_every_name() {
    let (seen, _) = inspected(&InspectOptions::default(), &open(SMOOTH_MODEL), &CommandLine);
    let [brief, full] = [Extent::Brief, Extent::Full]
        .map(|extent| inspection::text(&seen, &CommandLine, Layout { extent, ..Layout::default() }));
    for sphere in seen.figures.spheres() {
        let values = Figure::ALL.iter().filter_map(|&figure| sphere.value(figure));
        for text in values.map(shortest).chain([sphere.sphere.clone()]) {
            assert!(full.contains(&text), "{text}:\n{full}");
        }
    }
    assert!(brief.contains(" more") && !full.contains(" more\n"), "{brief}\n{full}");
}

#[test]
fn in_full_a_check_explains_every_finding_and_names_its_spheres() {
    // What is outside limits in published contacts is in brief only counted.
    let (_, found) = inspected(&InspectOptions::default(), &open(SMOOTH_MODEL), &CommandLine);
    let [brief, full] = [Extent::Brief, Extent::Full]
        .map(|extent| check::text(&found, &CommandLine, Layout { extent, ..Layout::default() }));
    let explained = |text: &str| text.lines().filter(|line| line.starts_with("  Why: ")).count();
    let mut codes: Vec<_> = found.findings.iter().map(|finding| finding.code()).collect();
    codes.dedup();
    assert!(explained(&brief) < codes.len(), "{brief}");
    assert_eq!(explained(&full), codes.len(), "{full}");
    for sphere in found.findings.iter().flat_map(|finding| &finding.spheres) {
        assert!(full.contains(sphere.as_str()), "{sphere}:\n{full}");
    }
}
