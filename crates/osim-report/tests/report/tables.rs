//! Tables and CSV.

use osim_inspect::InspectOptions;
use osim_model::FileId;
use osim_report::dialect::{CommandLine, FrontEnd, Python};
use osim_report::layout::Colour;
use osim_report::{check, inspection, plan};

use crate::support::{inspected, open, rescaled};

const SMOOTH: &str = "table1/human_62kg_smooth_sphere.osim";
const MIXED: &str = "format/mixed_radii.osim";

#[test]
fn a_model_is_told_in_80_columns() {
    let model = open(SMOOTH);
    let (seen, _) = inspected(&InspectOptions::default(), &model, &CommandLine);
    let text = inspection::text(&seen, &CommandLine, Colour::Plain);
    assert!(text.lines().all(|line| line.chars().count() <= 80), "{text}");
    insta::assert_snapshot!("inspection", text);
}

#[test]
fn a_table_says_what_to_do_next_in_the_words_of_its_front_end() {
    let model = open("check/beyond_hertz.osim");
    let (seen, _) = inspected(&InspectOptions::default(), &model, &Python);
    let text = inspection::text(&seen, &Python, Colour::Plain);
    assert!(text.contains("(! outside the limit: ocs.check(\"model.osim\") says more)"), "{text}");
}

#[test]
fn colours_are_all_that_they_add() {
    let model = open("check/beyond_hertz.osim");
    let (seen, found) = inspected(&InspectOptions::default(), &model, &CommandLine);
    for [plain, painted] in [
        [Colour::Plain, Colour::Ansi].map(|colour| inspection::text(&seen, &CommandLine, colour)),
        [Colour::Plain, Colour::Ansi].map(|colour| check::text(&found, CommandLine.prompt(), colour)),
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

#[test]
fn csv_has_one_row_for_each_sphere_that_stands() {
    let model = open(SMOOTH);
    let (seen, found) = inspected(&InspectOptions::default(), &model, &CommandLine);
    let rows = inspection::csv_rows(&seen, true).unwrap();
    let spheres: usize = seen.figures.limbs.iter().map(|limb| limb.spheres.len()).sum();
    assert_eq!(rows.lines().count(), 1 + spheres);
    assert!(rows.starts_with("model,name,mass_kg,contacts_mass_kg,gravity_m_s2,"), "{rows}");
    let without = inspection::csv_rows(&seen, false).unwrap();
    assert_eq!(rows.split_once('\n').unwrap().1, without);
    let rows = check::csv_rows(&found, true).unwrap();
    assert_eq!(rows.lines().count(), 1 + found.findings.len());
}

#[test]
fn findings_are_told_with_what_to_do() {
    let model = open(MIXED);
    let (_, found) = inspected(&InspectOptions::default(), &model, &CommandLine);
    insta::assert_snapshot!("check", check::text(&found, CommandLine.prompt(), Colour::Plain));
}

#[test]
fn a_library_is_one_table() {
    let mut library = check::LibraryTable::default();
    for name in [SMOOTH, MIXED, "check/sunk_in.osim", "check/floats.osim"] {
        library.add(&inspected(&InspectOptions::default(), &open(name), &CommandLine).1);
    }
    library.add_failed("broken.osim");
    insta::assert_snapshot!("library", library.text(true, &CommandLine, Colour::Plain));
}

#[test]
fn a_plan_is_told_in_full_in_a_line_and_as_a_diff() {
    let model = open(SMOOTH);
    let plan = rescaled(&model.model, 500.0, &CommandLine);
    let dry = "dry run: nothing written";
    insta::assert_snapshot!("plan", plan::text(&plan, SMOOTH, dry));
    insta::assert_snapshot!("plan_line", plan::line(&plan, SMOOTH, dry));
    let new = plan.patched(&model.model, FileId::MAIN).unwrap();
    let diff = plan::unified_diff(model.model.document().bytes(), &new, "old.osim", "new.osim");
    let (added, removed) = (diff.matches("\n+").count(), diff.matches("\n-").count());
    let inserted = plan.changes.iter().filter(|change| change.inserted).count();
    // The note is in the line of the credits.
    assert_eq!(removed, plan.changes.len() - inserted + 1, "{diff}");
    // The header has one, and the line of the credits is another.
    assert_eq!(added, plan.changes.len() + 2, "{diff}");
}
