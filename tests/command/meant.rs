//! Words that help: what is said to a call that is nearly right.

use crate::support::{Bench, HUMAN, Ran};

/// A call that is wrong, in one line with what to write.
#[track_caller]
fn answered(ran: Ran, name: &str) {
    let ran = ran.usage().wrote_nothing();
    assert_eq!(ran.err().lines().count(), 1, "{}", ran.err());
    ran.looks_like(&format!("meant_{name}"));
}

#[test]
fn verbs_that_are_misspelled() {
    let bench = Bench::human();
    answered(bench.run("help drop_test"), "help_drop_test");
    answered(bench.run("rescal human.osim --target-mass 80"), "rescal");
    answered(bench.run("inspct human.osim --stance-limbs 2"), "verb_with_options");
    answered(bench.run("Check human.osim"), "capital");
    answered(bench.run("droptest human.osim"), "droptest");
    answered(bench.run("--hlep"), "hlep");
    // Nothing is like it.
    answered(bench.run("xyzzy"), "xyzzy");
}

#[test]
fn help_and_version_are_verbs_too() {
    let bench = Bench::new();
    let same = |verb: &str, option: &str| {
        let (verb, option) = (bench.run(verb).done(), bench.run(option).done());
        assert_eq!(verb.out(), option.out());
        assert!(verb.err().is_empty());
    };
    same("help", "-h");
    same("help rescale", "rescale --help");
    same("help drop-test", "drop-test --help");
    same("version", "--version");
    // A file of that name is named with its folder.
    bench.write("help", crate::support::fixture(HUMAN.0));
    bench.run("./help").done().says(&["human_62kg"]);
}

#[test]
fn help_shows_what_most_people_come_for_and_it_works() {
    for help in ["-h", "--help"] {
        let bench = Bench::with(&[(HUMAN.0, "MODEL.osim")]);
        let help = bench.run(help).done().out();
        let (_, examples) = help.split_once("\nExamples:\n").unwrap();
        let calls = examples
            .lines()
            .map_while(|line| line.trim_ascii_start().strip_prefix("osim-contact-scale "))
            .map(|line| line.split("  ").next().unwrap());
        let calls: Vec<&str> = calls.collect();
        assert_eq!(calls.len(), 3, "{help}");
        bench.run(calls[0]).done().says(&["nothing is wrong"]);
        bench.run(calls[1]).done().wrote(&["MODEL.scaled.osim"]);
        let bench =
            Bench::with(&[("feet/human_40000.osim", "MODEL.osim"), ("contact_tables/own.csv", "own.csv")]);
        bench.run("add MODEL.osim --from falisse2022 --contacts own.csv -o OTHER.osim").done();
        bench.run(calls[2]).done().wrote(&["MODEL.scaled.osim"]);
    }
}

#[test]
fn names_with_blanks_need_quotes() {
    let bench = Bench::with(&[(HUMAN.0, "Trex digits.osim"), (HUMAN.0, "human.osim")]);
    answered(bench.run("Trex digits.osim"), "blank");
    answered(bench.run("Trex digits.osim --target-mass 80"), "blank_rescaled");
    answered(bench.run("drop-test Trex digits.osim"), "blank_drop_test");
    for call in
        ["inspect Trex digits.osim", "check human.osim Trex digits.osim", "set Trex digits.osim stiffness=x2"]
    {
        let ran = bench.run(call).failed().wrote_nothing();
        let errors: Vec<String> =
            ran.err().lines().filter(|line| line.starts_with("error: ")).map(str::to_owned).collect();
        assert_eq!(errors.len(), 1, "{errors:?}");
        assert!(errors[0].contains("needs quotes, \"Trex digits.osim\""), "{errors:?}");
    }
    // No file of the whole name is there either.
    answered(bench.run("Tyranno saurus.osim"), "blank_unknown");
}

#[test]
fn names_with_two_blanks_and_folders_need_quotes() {
    let bench = Bench::with(&[(HUMAN.0, "sp ace/my lib/human.osim"), (HUMAN.0, "lib/human.osim")]);
    // `lib` is there by itself, too.
    answered(bench.run("sp ace/my lib --target-mass 3"), "blanks");
    for verb in ["check", "inspect"] {
        let ran = bench.run(&format!("{verb} sp ace")).failed().wrote_nothing();
        ran.looks_like(&format!("meant_blank_folder_{verb}"));
    }
    // What is there by itself is part of no name that is not there.
    bench.run("inspect no lib").failed().says(&["no: there is no such file"]);
}

#[test]
fn a_misspelled_verb_before_a_model_that_is_not_there() {
    let bench = Bench::new();
    answered(bench.run("resclae x.osim"), "verb_without_model");
    answered(bench.run("scale x.osim"), "scale_without_model");
}

#[test]
fn a_number_beside_a_model_is_its_target_mass() {
    let bench = Bench::human();
    answered(bench.run("human.osim 20"), "number");
    answered(bench.run("human.osim 20.5kg"), "number_kg");
    answered(bench.run("rescale human.osim 20"), "number_rescale");
    // 20 g are 0.02 kg; a pound is 0.45359237 kg.
    answered(bench.run("human.osim 20g"), "number_g");
    answered(bench.run("human.osim 1lb"), "number_lb");
}

#[test]
fn a_folder_does_not_fall() {
    let bench = Bench::with(&[(HUMAN.0, "lib/human.osim"), (HUMAN.0, "sp ace/human.osim")]);
    answered(bench.run("drop-test lib"), "drop_test_folder");
    let blank = bench.run_words(&["drop-test", "sp ace"]);
    let said = String::from_utf8(blank.stderr).unwrap();
    // To be copied into any shell.
    assert!(said.contains("`osim-contact-scale inspect \"sp ace\"`"), "{said}");
    answered(bench.run("plot force lib -o x.svg"), "plot_folder");
}

#[test]
fn axes_stand_behind_grid() {
    let bench = Bench::human();
    answered(bench.run("sweep human.osim stiffness=1e5:1e6:10"), "axis_assigned");
    answered(bench.run("sweep human.osim --stiffness 1e5:1e6:3"), "axis_option");
    answered(bench.run("sweep human.osim --stiffness=x0.1..x10/5"), "axis_option_joined");
    answered(bench.run("sweep human.osim --target-mass 10:20:90 --dry-run"), "axis_mass");
}

#[test]
fn a_note_alone_shows_no_empty_table() {
    let bench = Bench::human();
    bench.run("note human.osim --contacts-mass 62 -o noted.osim").done().looks_like("meant_note");
}

#[test]
fn kinds_of_errors_and_bare_names_are_explained() {
    let bench = Bench::new();
    for name in ["NeedsAnswer", "needs-answer"] {
        bench.run(&format!("explain {name}")).done().says(&[
            "implausible-mass",
            "implausible-radius",
            "many-models",
        ]);
    }
    bench.run("explain E1").done().says(&["stiffness (quantity)"]);
    bench.run("explain indentation").done().says(&["indentation_m (quantity)"]);
    bench.run("explain gravity").done().says(&["gravity_m_s2 (quantity)"]);
}

#[test]
fn ranges_of_matlab() {
    let bench = Bench::human();
    answered(bench.run("plot sweep human.osim -o f.svg --stiffness 1e5:1e6:10"), "range_plot");
    answered(bench.run("sweep human.osim --grid stiffness=1e5:1e6:10"), "range_count");
    answered(bench.run("sweep human.osim --grid stiffness=1e5:1e5:1e6"), "range_steps");
}

#[test]
fn numbers_with_units_are_converted() {
    let bench = Bench::human();
    for (unit, number) in [("g", "44g"), ("lb", "44lb"), ("kg", "44kg"), ("unknown", "44stone")] {
        answered(bench.run(&format!("human.osim --target-mass {number}")), &format!("mass_{unit}"));
    }
    for (unit, number) in [("mm", "32mm"), ("cm", "3.2cm"), ("m", "0.032m")] {
        answered(
            bench.run(&format!("human.osim --target-mass 62 --radius {number}")),
            &format!("radius_{unit}"),
        );
    }
    answered(bench.run("set human.osim radius=32mm"), "radius_set");
}

#[test]
fn every_quantity_is_explained_with_its_trap() {
    let bench = Bench::new();
    for name in ["stiffness", "radius", "alpha", "hertz_smoothing", "x/R"] {
        bench
            .run(&format!("explain {name}"))
            .done()
            .looks_like(&format!("explain_quantity_{}", name.replace('/', "_")));
    }
    bench.run("explain alpha --format json").done().looks_like("explain_quantity_json");
    // Whatever a table of figures has as a name.
    let columns = bench.run("drop-test falisse2022 --format csv").done().out();
    for column in columns.lines().next().unwrap().split(',') {
        bench.run(&format!("explain {column}")).done().says(&["Trap:"]);
    }
}

#[test]
fn an_empty_file_is_called_empty() {
    let bench = Bench::human();
    bench.write("empty.osim", "");
    bench.write("blank.osim", "\u{feff} \r\n");
    for name in ["empty.osim", "blank.osim"] {
        bench.run(name).failed().says(&["the file is empty"]);
    }
}

#[test]
fn a_broken_generic_model_is_reported_once() {
    let bench = Bench::with(&[HUMAN, (HUMAN.0, "other.osim"), ("bad/truncated.osim", "generic.osim")]);
    let ran = bench.run("inspect human.osim other.osim --from generic.osim").failed();
    assert_eq!(ran.err().matches("error: ").count(), 1, "{}", ran.err());
    // What is wrong is said in one way.
    assert_eq!(ran.err().matches("truncated").count(), 1, "{}", ran.err());
}

#[test]
fn masses_are_short_for_people_and_exact_for_programs() {
    // Sums of masses end like this one; it has one body.
    let bench = Bench::with(&[("format/parameters_named.osim", "one.osim")]);
    let text = bench.text("one.osim");
    let (before, rest) = text.split_once("<mass>").unwrap();
    let (_, after) = rest.split_once("</mass>").unwrap();
    bench.write("one.osim", format!("{before}<mass>20.000000000000018</mass>{after}"));
    for call in ["inspect", "check"] {
        let out = bench.run(&format!("{call} one.osim --contacts-mass 30")).out();
        assert!(!out.contains("20.0000"), "{out}");
    }
    bench.run("one.osim --target-mass 30 --contacts-mass 25 --dry-run").done().says(&[" says 20 kg"]);
    for call in [
        "one.osim --target-mass 30 --dry-run",
        "one.osim --target-mass 30 --dry-run --format lines",
        "one.osim --target-mass 20000 --dry-run",
        "one.osim --target-mass 20 --dry-run",
        "transfer one.osim --from one.osim --reference-mass 62 --dry-run",
        "note one.osim --contacts-mass 20.000000000000018 --dry-run",
        "design one.osim --indentation 0.1 --dry-run",
        "drop-test one.osim",
    ] {
        let ran = bench.run(call);
        let said = format!("{}{}", ran.out(), ran.err());
        assert!(!said.contains("20.0000"), "{call}: {said}");
    }
    let json = bench.run("inspect one.osim --format json").done().out();
    assert!(json.contains("20.000000000000018"), "{json}");
}

/// A choice that chooses nothing is probably a slip, and says so without standing in the way.
#[test]
fn a_pattern_that_matches_no_force_is_named() {
    let bench = Bench::with(&[("check/known_contacts.osim", "human.osim")]);
    let call = "rescale human.osim --target-mass 70 --dry-run";
    let words = "--exclude balls_*: no contact force of the model has such a name";
    bench.run(&format!("{call} --exclude balls_*")).done().says(&[words]);
    let words = "--select typo_*: no contact force of the model has such a name";
    bench.run(&format!("{call} --select contact_* --select typo_*")).done().says(&[words]);
    bench.run(&format!("{call} --select contact_*")).done().says_not(&["no contact force of the model"]);
}

/// So does every verb that takes such a choice, of forces and of bodies.
#[test]
fn every_verb_names_a_pattern_that_matches_nothing() {
    let bench = Bench::with(&[
        ("check/known_contacts.osim", "human.osim"),
        ("motion/walker.osim", "walker.osim"),
        ("motion/walk.mot", "walk.mot"),
    ]);
    let forces = "--exclude balls_*: no contact force of the model has such a name";
    let bodies = "--exclude-body props_*: no body of the model has such a name";
    for call in [
        "rescale human.osim --target-mass 70 --dry-run",
        "set human.osim stiffness=x2 --dry-run",
        "design human.osim --indentation 0.2 --dry-run",
        "inspect human.osim",
        "check human.osim",
        "drop-test human.osim --duration 0.01",
        "sweep human.osim --grid stiffness=x1,x2 --dry-run",
        "plot force human.osim -o force.svg --force",
        "plot feet human.osim -o feet.svg --force",
        "motion walker.osim walk.mot",
    ] {
        let said = |words: &str| {
            let ran = bench.run(&format!("{call} {words}"));
            let text = format!("{}{}", ran.out(), ran.err());
            text.split_whitespace().collect::<Vec<_>>().join(" ")
        };
        let text = said("--exclude balls_* --exclude-body props_*");
        for words in [forces, bodies] {
            assert!(text.contains(words), "{call}: {text}");
        }
        let text = said("");
        assert!(!text.contains("has such a name"), "{call}: {text}");
    }
}
