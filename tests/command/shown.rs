//! What people see when all goes well.

use crate::support::{Bench, HUMAN};

const MOUSE: (&str, &str) = ("table1/mouse_hunt_crossley.osim", "mouse.osim");
const VERBS: [&str; 23] = [
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
const TWO_FEET: (&str, &str) = ("format/v30000_two_feet.osim", "feet.osim");

#[test]
fn rescaling() {
    let bench = Bench::human();
    bench.run("human.osim --target-mass 1190").done().wrote(&["human.scaled.osim"]).looks_like("rescale");
    bench.run("human.osim --target-mass 1190 --force --quiet").done().looks_like("rescale_quiet");
}

#[test]
fn rescaling_with_a_diff() {
    let bench = Bench::with(&[("format/left_out_in_the_middle.osim", "foot.osim")]);
    bench
        .run("foot.osim --target-mass 492 --diff -o big.osim")
        .done()
        .wrote(&["big.osim"])
        .looks_like("rescale_diff");
    bench
        .run("foot.osim --target-mass 492 --diff --dry-run")
        .done()
        .wrote_nothing()
        .looks_like("rescale_dry_run");
}

#[test]
fn rescaling_as_json() {
    let bench = Bench::with(&[("format/left_out_in_the_middle.osim", "foot.osim")]);
    let ran = bench.run("foot.osim --target-mass 492 --format json").done().wrote(&["foot.scaled.osim"]);
    assert!(ran.stdout.ends_with(b"}\n") && ran.stderr.is_empty());
    ran.looks_like("rescale_json");
}

#[test]
fn rescaling_part_of_it() {
    let bench = Bench::with(&[TWO_FEET]);
    bench.run("feet.osim --target-mass 424 --select *_r --dry-run").done().looks_like("rescale_select");
    bench
        .run("feet.osim --target-mass 424 --only stiffness --dry-run")
        .done()
        .looks_like("rescale_only_stiffness");
    bench
        .run("feet.osim --target-mass 424 --radius 0.05 --dry-run")
        .done()
        .looks_like("rescale_radius_metres");
    bench
        .run("feet.osim --target-mass 424 --radius keep --dissipation-by mass --dry-run")
        .done()
        .looks_like("rescale_dissipation_by_mass");
    bench
        .run("feet.osim --target-mass 424 --friction --target-gravity 3.71 --dry-run")
        .done()
        .looks_like("rescale_friction_gravity");
}

#[test]
fn masses_that_disagree_and_contacts_already_there() {
    let bench = Bench::human();
    bench.run("human.osim --target-mass 62").done().wrote_nothing().looks_like("already_at_target");
    bench
        .run("human.osim --target-mass 62 --contacts-mass 75 --dry-run")
        .done()
        .looks_like("masses_disagree");
}

#[test]
fn transferring() {
    let bench = Bench::with(&[HUMAN, MOUSE]);
    bench
        .run("transfer mouse.osim --from human.osim --reference-spheres 6 --stance-limbs 2 --dry-run")
        .done()
        .looks_like("transfer_same");
    bench
        .run("transfer mouse.osim --from falisse2022 --spheres 4 -o out.osim")
        .done()
        .wrote(&["out.osim"])
        .looks_like("transfer_preset");
    bench
        .run("transfer human.osim --from mouse.osim --radius isometric --dry-run")
        .done()
        .looks_like("transfer_isometric");
}

#[test]
fn setting() {
    let bench = Bench::with(&[TWO_FEET]);
    bench
        .run("set feet.osim stiffness=x2 dissipation=1.5 --dry-run")
        .done()
        .wrote_nothing()
        .looks_like("set");
    bench.run("set feet.osim radius=-1").usage().wrote_nothing().looks_like("set_out_of_domain");
}

#[test]
fn designing_without_a_model() {
    let bench = Bench::new();
    bench
        .run("design --mass 62 --spheres 6 --radius 0.032 --indentation 0.16 --restitution 0.8 --impact-speed 0.4")
        .done()
        .looks_like("design");
    bench.run("presets").done().looks_like("presets");
    bench.run("presets falisse2022 --format json").done().looks_like("presets_json");
}

#[test]
fn inspecting() {
    let bench = Bench::with(&[MOUSE, TWO_FEET, ("format/three_materials.osim", "materials.osim")]);
    bench.run("inspect mouse.osim").done().wrote_nothing().looks_like("inspect");
    bench.run("inspect feet.osim materials.osim").done().looks_like("inspect_several");
    bench.run("inspect feet.osim materials.osim --full").done().looks_like("inspect_several_full");
    let ran = bench.run("inspect feet.osim --format json").done();
    assert!(ran.stdout.ends_with(b"}\n") && ran.stderr.is_empty());
    ran.looks_like("inspect_json");
    bench.run("inspect mouse.osim feet.osim --format csv").done().looks_like("inspect_csv");
}

#[test]
fn every_row_has_each_code_once() {
    // Four forces of several spheres: four warnings of one code, which each row would repeat.
    let bench = Bench::with(&[("table1/horse_hunt_crossley.osim", "horse.osim")]);
    let ran = bench.run("inspect horse.osim --format csv").done();
    let rows = String::from_utf8(ran.stdout.clone()).unwrap();
    assert!(rows.lines().count() > 4);
    for row in rows.lines().skip(1) {
        assert_eq!(row.rsplit(',').next(), Some("several-spheres-one-force"), "{row}");
    }
}

#[test]
fn inspecting_says_what_is_wrong_and_goes_on() {
    let bench = Bench::with(&[
        ("bad/number_decimal_comma.osim", "comma.osim"),
        ("bad/mass_missing.osim", "massless.osim"),
        ("format/unequal_stiffness.osim", "unequal.osim"),
        ("format/no_sides.osim", "no_sides.osim"),
    ]);
    for name in ["comma", "massless", "unequal", "no_sides"] {
        bench.run(&format!("inspect {name}.osim")).done().looks_like(&format!("inspect_{name}"));
    }
}

#[test]
fn a_model_alone_is_shown_with_a_hint() {
    let bench = Bench::with(&[TWO_FEET]);
    bench.run("feet.osim").done().wrote_nothing().looks_like("model_alone");
}

#[test]
fn a_folder_and_what_is_passed_over() {
    let bench = Bench::with(&[
        ("format/v40000.osim", "lib/a/foot.osim"),
        ("format/v30000.osim", "lib/b/foot.osim"),
        ("bad/no_contacts.osim", "lib/none.osim"),
        ("format/v40000.osim", "lib/old.scaled.osim"),
    ]);
    bench
        .run("lib --target-mass 123 -d lib/out")
        .done()
        .wrote(&["lib/out/a/foot.osim", "lib/out/b/foot.osim"])
        .looks_like("folder");
}

#[test]
fn explaining() {
    let bench = Bench::new();
    bench.run("explain").done().looks_like("explain");
    bench.run("explain already-at-target").done().looks_like("explain_code");
    bench.run("explain no-such-code").usage().looks_like("explain_unknown");
    bench.run("explain (C.10)").done().looks_like("explain_equation");
    bench.run("explain 11, B.2 --ascii").done().looks_like("explain_ascii");
    bench.run("explain given out-of-domain --format json").done().looks_like("explain_json");
}

#[test]
fn help() {
    let bench = Bench::new();
    for verb in VERBS {
        let name =
            if verb.is_empty() { "help".to_owned() } else { format!("help_{}", verb.replace('-', "_")) };
        let ran = bench.run(format!("{verb} -h").trim()).done().looks_like(&name);
        assert!(ran.stderr.is_empty());
        bench.run(format!("{verb} --help").trim()).done().looks_like(&format!("{name}_long"));
    }
    bench.run("--version").done().looks_like("version");
}

/// Options that the help of a verb offers.
fn offered(verb: &str, help: &str) -> Vec<String> {
    let text = Bench::new().run(&format!("{verb} {help}")).done().out();
    let words = text.lines().map(str::trim_start).filter(|line| line.starts_with('-'));
    let options = words.filter_map(|line| line.split([' ', ',']).find(|word| word.starts_with("--")));
    options.map(str::to_owned).collect()
}

#[test]
fn help_offers_what_a_verb_takes_and_rare_options_only_at_length() {
    for (verb, refused) in [
        ("transfer", &["--contacts-mass", "--contacts-gravity"][..]),
        ("design", &["--contacts-mass"]),
        ("drop-test", &["--contacts-mass"]),
        ("sweep", &["--stiffness"]),
        ("batch", &["--output", "--geometry-output"]),
    ] {
        for help in ["-h", "--help"] {
            let offered = offered(verb, help);
            assert!(!offered.iter().any(|option| refused.contains(&option.as_str())), "{verb}: {offered:?}");
        }
    }
    // Who types one is told why it is refused.
    let bench = Bench::human();
    bench
        .run("transfer human.osim --from falisse2022 --contacts-mass 62")
        .usage()
        .says(&["says nothing here"]);
    for verb in VERBS {
        let (short, long) = (offered(verb, "-h"), offered(verb, "--help"));
        assert!(short.iter().all(|option| long.contains(option)), "{verb}: {short:?} {long:?}");
    }
    for rare in ["--yes", "--exclude", "--jobs"] {
        assert!(!offered("rescale", "-h").contains(&rare.to_owned()));
        assert!(offered("rescale", "--help").contains(&rare.to_owned()));
    }
}

#[test]
fn help_fits_a_screen() {
    let bench = Bench::new();
    let mut too_long = Vec::new();
    for verb in VERBS {
        let text = bench.run(format!("{verb} -h").trim()).done().out();
        let widest = text.lines().map(|line| line.chars().count()).max().unwrap();
        if text.lines().count() > 60 || widest > 100 {
            too_long.push(format!("'{verb} -h': {} lines of up to {widest} columns", text.lines().count()));
        }
    }
    assert!(too_long.is_empty(), "{too_long:#?}");
}
