//! Snapshots of what each verb prints if it succeeds.

use crate::support::{HUMAN, TestDir};

const MOUSE_MODEL: (&str, &str) = ("table1/mouse_hunt_crossley.osim", "mouse.osim");
const CALLS_OF_ALL_VERBS: [&str; 23] = [
    "",
    "rescale",
    "transfer",
    "add",
    "remove",
    "convert",
    "design",
    "set",
    "note",
    "batch",
    "sweep",
    "inspect",
    "check",
    "drop-test",
    "motion",
    "plot",
    "fit",
    "reproduce",
    "presets",
    "explain",
    "request",
    "completions",
    "man",
];
const TWO_FEET_MODEL: (&str, &str) = ("format/v30000_two_feet.osim", "feet.osim");

#[test]
fn rescale_prints_a_table_of_changes() {
    let dir = TestDir::with_human();
    dir.run("human.osim --target-mass 1190")
        .succeeded()
        .wrote(&["human.scaled.osim"])
        .matches_snapshot("rescale");
    dir.run("human.osim --target-mass 1190 --force --quiet").succeeded().matches_snapshot("rescale_quiet");
}

#[test]
fn rescale_prints_a_diff() {
    let dir = TestDir::with(&[("format/left_out_in_the_middle.osim", "foot.osim")]);
    dir.run("foot.osim --target-mass 492 --diff -o big.osim")
        .succeeded()
        .wrote(&["big.osim"])
        .matches_snapshot("rescale_diff");
    dir.run("foot.osim --target-mass 492 --diff --dry-run")
        .succeeded()
        .wrote_nothing()
        .matches_snapshot("rescale_dry_run");
}

#[test]
fn rescale_prints_json() {
    let dir = TestDir::with(&[("format/left_out_in_the_middle.osim", "foot.osim")]);
    let run = dir.run("foot.osim --target-mass 492 --format json").succeeded().wrote(&["foot.scaled.osim"]);
    assert!(run.stdout.ends_with(b"}\n") && run.stderr.is_empty());
    run.matches_snapshot("rescale_json");
}

#[test]
fn rescale_prints_partial_changes() {
    let dir = TestDir::with(&[TWO_FEET_MODEL]);
    dir.run("feet.osim --target-mass 424 --select *_r --dry-run")
        .succeeded()
        .matches_snapshot("rescale_select");
    dir.run("feet.osim --target-mass 424 --only stiffness --dry-run")
        .succeeded()
        .matches_snapshot("rescale_only_stiffness");
    dir.run("feet.osim --target-mass 424 --radius 0.05 --dry-run")
        .succeeded()
        .matches_snapshot("rescale_radius_metres");
    dir.run("feet.osim --target-mass 424 --radius keep --dissipation-by mass --dry-run")
        .succeeded()
        .matches_snapshot("rescale_dissipation_by_mass");
    dir.run("feet.osim --target-mass 424 --friction --target-gravity 3.71 --dry-run")
        .succeeded()
        .matches_snapshot("rescale_friction_gravity");
}

#[test]
fn rescale_reports_disagreeing_masses_and_contacts_at_the_target() {
    let dir = TestDir::with_human();
    dir.run("human.osim --target-mass 62").succeeded().wrote_nothing().matches_snapshot("already_at_target");
    dir.run("human.osim --target-mass 62 --contacts-mass 75 --dry-run")
        .succeeded()
        .matches_snapshot("masses_disagree");
}

#[test]
fn transfer_prints_a_table_of_changes() {
    let dir = TestDir::with(&[HUMAN, MOUSE_MODEL]);
    dir.run("transfer mouse.osim --from human.osim --reference-spheres 6 --stance-limbs 2 --dry-run")
        .succeeded()
        .matches_snapshot("transfer_same");
    dir.run("transfer mouse.osim --from falisse2022 --spheres 4 -o out.osim")
        .succeeded()
        .wrote(&["out.osim"])
        .matches_snapshot("transfer_preset");
    dir.run("transfer human.osim --from mouse.osim --radius isometric --dry-run")
        .succeeded()
        .matches_snapshot("transfer_isometric");
}

#[test]
fn set_prints_a_table_of_changes() {
    let dir = TestDir::with(&[TWO_FEET_MODEL]);
    dir.run("set feet.osim stiffness=x2 dissipation=1.5 --dry-run")
        .succeeded()
        .wrote_nothing()
        .matches_snapshot("set");
    dir.run("set feet.osim radius=-1").usage_error().wrote_nothing().matches_snapshot("set_out_of_domain");
}

#[test]
fn design_prints_a_sheet_without_a_model() {
    let dir = TestDir::new();
    dir.run(
        "design --mass 62 --spheres 6 --radius 0.032 --indentation 0.16 --restitution 0.8 --impact-speed 0.4",
    )
    .succeeded()
    .matches_snapshot("design");
    dir.run("presets").succeeded().matches_snapshot("presets");
    dir.run("presets falisse2022 --format json").succeeded().matches_snapshot("presets_json");
}

#[test]
fn inspect_prints_tables_json_and_csv() {
    let dir =
        TestDir::with(&[MOUSE_MODEL, TWO_FEET_MODEL, ("format/three_materials.osim", "materials.osim")]);
    dir.run("inspect mouse.osim").succeeded().wrote_nothing().matches_snapshot("inspect");
    dir.run("inspect feet.osim materials.osim").succeeded().matches_snapshot("inspect_several");
    dir.run("inspect feet.osim materials.osim --full").succeeded().matches_snapshot("inspect_several_full");
    let run = dir.run("inspect feet.osim --format json").succeeded();
    assert!(run.stdout.ends_with(b"}\n") && run.stderr.is_empty());
    run.matches_snapshot("inspect_json");
    dir.run("inspect mouse.osim feet.osim --format csv").succeeded().matches_snapshot("inspect_csv");
}

#[test]
fn csv_rows_have_each_code_once() {
    // Four forces of several spheres: four findings of one code, which each row would repeat.
    let dir = TestDir::with(&[("table1/horse_hunt_crossley.osim", "horse.osim")]);
    let run = dir.run("inspect horse.osim --format csv").succeeded();
    let rows = String::from_utf8(run.stdout.clone()).unwrap();
    assert!(rows.lines().count() > 4);
    for row in rows.lines().skip(1) {
        assert_eq!(row.rsplit(',').next(), Some("several-spheres-one-force"), "{row}");
    }
}

#[test]
fn inspect_reports_faults_and_continues() {
    let dir = TestDir::with(&[
        ("bad/number_decimal_comma.osim", "comma.osim"),
        ("bad/mass_missing.osim", "massless.osim"),
        ("format/unequal_stiffness.osim", "unequal.osim"),
        ("format/no_sides.osim", "no_sides.osim"),
    ]);
    for name in ["comma", "massless", "unequal", "no_sides"] {
        dir.run(&format!("inspect {name}.osim")).succeeded().matches_snapshot(&format!("inspect_{name}"));
    }
}

#[test]
fn a_model_without_a_verb_is_inspected_with_a_hint() {
    let dir = TestDir::with(&[TWO_FEET_MODEL]);
    dir.run("feet.osim").succeeded().wrote_nothing().matches_snapshot("model_alone");
}

#[test]
fn a_folder_is_rescaled_and_skipped_files_are_listed() {
    let dir = TestDir::with(&[
        ("format/v40000.osim", "lib/a/foot.osim"),
        ("format/v30000.osim", "lib/b/foot.osim"),
        ("bad/no_contacts.osim", "lib/none.osim"),
        ("format/v40000.osim", "lib/old.scaled.osim"),
    ]);
    dir.run("lib --target-mass 123 -d lib/out")
        .succeeded()
        .wrote(&["lib/out/a/foot.osim", "lib/out/b/foot.osim"])
        .matches_snapshot("folder");
}

#[test]
fn explain_prints_topics() {
    let dir = TestDir::new();
    dir.run("explain").succeeded().matches_snapshot("explain");
    dir.run("explain already-at-target").succeeded().matches_snapshot("explain_code");
    dir.run("explain no-such-code").usage_error().matches_snapshot("explain_unknown");
    dir.run("explain (C.10)").succeeded().matches_snapshot("explain_equation");
    dir.run("explain 11, B.2 --ascii").succeeded().matches_snapshot("explain_ascii");
    dir.run("explain given out-of-domain --format json").succeeded().matches_snapshot("explain_json");
}

#[test]
fn help_of_every_verb_is_printed() {
    let dir = TestDir::new();
    for verb in CALLS_OF_ALL_VERBS {
        let name =
            if verb.is_empty() { "help".to_owned() } else { format!("help_{}", verb.replace('-', "_")) };
        let run = dir.run(format!("{verb} -h").trim()).succeeded().matches_snapshot(&name);
        assert!(run.stderr.is_empty());
        dir.run(format!("{verb} --help").trim()).succeeded().matches_snapshot(&format!("{name}_long"));
    }
    dir.run("--version").succeeded().matches_snapshot("version");
}

/// Options in the help of a verb.
fn options_in_help(verb: &str, help: &str) -> Vec<String> {
    let text = TestDir::new().run(&format!("{verb} {help}")).succeeded().out();
    let words = text.lines().map(str::trim_start).filter(|line| line.starts_with('-'));
    let options = words.filter_map(|line| line.split([' ', ',']).find(|word| word.starts_with("--")));
    options.map(str::to_owned).collect()
}

#[test]
fn help_lists_only_options_of_the_verb_and_rare_ones_only_in_the_long_form() {
    for (verb, absent_options) in [
        ("transfer", &["--contacts-mass", "--contacts-gravity"][..]),
        ("design", &["--contacts-mass"]),
        ("drop-test", &["--contacts-mass"]),
        ("sweep", &["--stiffness"]),
        ("batch", &["--output", "--geometry-output"]),
    ] {
        for help in ["-h", "--help"] {
            let options = options_in_help(verb, help);
            assert!(
                !options.iter().any(|option| absent_options.contains(&option.as_str())),
                "{verb}: {options:?}"
            );
        }
    }
    // A refused option is explained.
    let dir = TestDir::with_human();
    dir.run("transfer human.osim --from falisse2022 --contacts-mass 62")
        .usage_error()
        .says(&["has no effect here"]);
    for verb in CALLS_OF_ALL_VERBS {
        let (short, long) = (options_in_help(verb, "-h"), options_in_help(verb, "--help"));
        assert!(short.iter().all(|option| long.contains(option)), "{verb}: {short:?} {long:?}");
    }
    for rare in ["--yes", "--exclude", "--jobs"] {
        assert!(!options_in_help("rescale", "-h").contains(&rare.to_owned()));
        assert!(options_in_help("rescale", "--help").contains(&rare.to_owned()));
    }
}

#[test]
fn help_fits_a_screen() {
    let dir = TestDir::new();
    let mut too_long = Vec::new();
    for verb in CALLS_OF_ALL_VERBS {
        let text = dir.run(format!("{verb} -h").trim()).succeeded().out();
        let widest = text.lines().map(|line| line.chars().count()).max().unwrap();
        if text.lines().count() > 60 || widest > 100 {
            too_long.push(format!("'{verb} -h': {} lines of up to {widest} columns", text.lines().count()));
        }
    }
    assert!(too_long.is_empty(), "{too_long:#?}");
}
