//! Messages that suggest a correction of a nearly right call.

use crate::support::{CommandRun, HUMAN, TestDir};

/// Asserts that a wrong call prints one line with the suggested correction.
#[track_caller]
fn assert_suggests(run: CommandRun, name: &str) {
    let run = run.usage_error().wrote_nothing();
    assert_eq!(run.err().lines().count(), 1, "{}", run.err());
    run.matches_snapshot(&format!("suggestion_{name}"));
}

#[test]
fn a_misspelled_verb_is_refused_with_a_suggestion() {
    let dir = TestDir::with_human();
    assert_suggests(dir.run("help drop_test"), "help_drop_test");
    assert_suggests(dir.run("rescal human.osim --target-mass 80"), "rescal");
    assert_suggests(dir.run("inspct human.osim --stance-limbs 2"), "verb_with_options");
    assert_suggests(dir.run("Check human.osim"), "capital");
    assert_suggests(dir.run("droptest human.osim"), "droptest");
    assert_suggests(dir.run("--hlep"), "hlep");
    // Nothing is like it.
    assert_suggests(dir.run("xyzzy"), "xyzzy");
}

#[test]
fn help_and_version_work_as_verbs() {
    let dir = TestDir::new();
    let assert_same_output = |verb: &str, option: &str| {
        let (verb, option) = (dir.run(verb).succeeded(), dir.run(option).succeeded());
        assert_eq!(verb.out(), option.out());
        assert!(verb.err().is_empty());
    };
    assert_same_output("help", "-h");
    assert_same_output("help rescale", "rescale --help");
    assert_same_output("help drop-test", "drop-test --help");
    assert_same_output("version", "--version");
    // A file of that name is named with its folder.
    dir.write("help", crate::support::fixture(HUMAN.0));
    dir.run("./help").succeeded().says(&["human_62kg"]);
}

#[test]
fn the_examples_in_the_help_work() {
    for help in ["-h", "--help"] {
        let dir = TestDir::with(&[
            (HUMAN.0, "MODEL.osim"),
            ("scale_tool/scaled_smooth.osim", "SCALED.osim"),
            ("scale_tool/generic_smooth.osim", "GENERIC.osim"),
        ]);
        let help = dir.run(help).succeeded().out();
        let (_, examples) = help.split_once("\nExamples:\n").unwrap();
        let calls = examples
            .lines()
            .map_while(|line| line.trim_ascii_start().strip_prefix("osim-contact-scale "))
            .map(|line| line.split("  ").next().unwrap());
        let calls: Vec<&str> = calls.collect();
        assert_eq!(calls.len(), 3, "{help}");
        dir.run(calls[0]).failed().says(&["$ osim-contact-scale transfer SCALED.osim --from GENERIC.osim"]);
        dir.run(calls[1]).succeeded().wrote(&["MODEL.scaled.osim"]);
        let dir =
            TestDir::with(&[("feet/human_40000.osim", "MODEL.osim"), ("contact_tables/own.csv", "own.csv")]);
        dir.run("add MODEL.osim --from falisse2022 --contacts own.csv -o OTHER.osim").succeeded();
        dir.run(calls[2]).succeeded().wrote(&["MODEL.scaled.osim"]);
    }
}

#[test]
fn unquoted_names_with_blanks_are_refused_with_quotes() {
    let dir = TestDir::with(&[(HUMAN.0, "Trex digits.osim"), (HUMAN.0, "human.osim")]);
    assert_suggests(dir.run("Trex digits.osim"), "blank");
    assert_suggests(dir.run("Trex digits.osim --target-mass 80"), "blank_rescaled");
    assert_suggests(dir.run("drop-test Trex digits.osim"), "blank_drop_test");
    for call in
        ["inspect Trex digits.osim", "check human.osim Trex digits.osim", "set Trex digits.osim stiffness=x2"]
    {
        let run = dir.run(call).failed().wrote_nothing();
        let errors: Vec<String> =
            run.err().lines().filter(|line| line.starts_with("error: ")).map(str::to_owned).collect();
        assert_eq!(errors.len(), 1, "{errors:?}");
        assert!(errors[0].contains("needs quotes, \"Trex digits.osim\""), "{errors:?}");
    }
    // No file of the whole name is there either.
    assert_suggests(dir.run("Tyranno saurus.osim"), "blank_unknown");
}

#[test]
fn unquoted_folders_with_blanks_are_refused_with_quotes() {
    let dir = TestDir::with(&[(HUMAN.0, "sp ace/my lib/human.osim"), (HUMAN.0, "lib/human.osim")]);
    // `lib` is there by itself, too.
    assert_suggests(dir.run("sp ace/my lib --target-mass 3"), "blanks");
    for verb in ["check", "inspect"] {
        let run = dir.run(&format!("{verb} sp ace")).failed().wrote_nothing();
        run.matches_snapshot(&format!("suggestion_blank_folder_{verb}"));
    }
    // What is there by itself is part of no name that is not there.
    dir.run("inspect no lib").failed().says(&["no: there is no such file"]);
}

#[test]
fn a_misspelled_verb_before_a_missing_model_gets_a_suggestion() {
    let dir = TestDir::new();
    assert_suggests(dir.run("resclae x.osim"), "verb_without_model");
    assert_suggests(dir.run("scale x.osim"), "scale_without_model");
    for (verb, words) in [
        ("info", "'inspect'"),
        ("validate", "'check'"),
        ("lint", "'check'"),
        ("fix", "'check --fix'"),
        ("Scale", "'rescale'"),
        ("show", "'inspect'"),
        ("verify", "'check'"),
    ] {
        dir.run(&format!("{verb} x.osim")).usage_error().wrote_nothing().says(&[words]);
    }
}

#[test]
fn a_verb_after_its_model_and_an_option_of_another_verb_get_a_suggestion() {
    let dir = TestDir::with_human();
    dir.write("my model.osim", crate::support::fixture(HUMAN.0));
    for (call, message) in [
        ("human.osim check", "'check' is not a file: did you mean 'check human.osim'?"),
        ("human.osim stiffness=1e6", "did you mean 'set human.osim stiffness=1e6'?"),
        ("rescale help", "'help' is not a file; as a verb it would be the first word"),
        ("set human.osim stiffness 1e6", "a property and its value are one word: write stiffness=1e6"),
        ("add human.osim --feet toes_r toes_l --count 4", "did you mean --feet toes_r,toes_l?"),
        ("set human.osim stiffness = 1e6", "a property and its value are one word: write stiffness=1e6"),
        ("add human.osim --preset falisse2022", "did you mean --from?"),
        // `-d ry-run` would be a folder.
        (
            "human.osim --target-mass 80 -dry-run",
            "'-dry-run' does not begin with two hyphens: did you mean --dry-run?",
        ),
        ("human.osim -target-mass=80", "did you mean --target-mass?"),
        // As word processors write it, and pages that are printed.
        ("check human.osim –from g.osim", "'–from' does not begin with two hyphens: did you mean --from?"),
        ("/?", "the help is printed by 'help'"),
        ("osim-contact-scale check human.osim", "the name of the program is typed once"),
        ("help check transfer", "unexpected argument 'transfer' found"),
        ("$ osim-contact-scale check human.osim", "leave out the sign of the terminal"),
        ("osim-contact-scale check human.osim --from x", "the name of the program is typed once"),
        ("plot human.osim -o f.svg", "name one before the model, as in 'plot force human.osim'"),
        ("motion human.osim walk.mot plates.sto", "did you mean --plates plates.sto?"),
        ("human.osim --target-mass 80 --overwrite", "did you mean --force?"),
        ("check human.osim --json", "did you mean --format json?"),
        ("check human.osim --generic human.osim", "did you mean --from?"),
        ("convert human.osim --to HuntCrossleyForce", "did you mean 'hunt-crossley'?"),
        ("completions tcsh", "[possible values: bash, elvish, fish, powershell, zsh]"),
        ("human.osim --from g.osim", "'--from' found: it is an option of transfer, add, inspect, check"),
        ("motion human.osim --target-mass 80", "it is an option of rescale, inspect, plot"),
    ] {
        dir.run(call).usage_error().wrote_nothing().says(&[message]);
    }
    dir.run("completions tcsh").usage_error().says_not(&["did you mean", "similar"]);
    let run = dir.run("transfer human.osim --to human.osim").usage_error();
    run.says(&["it is an option of convert"]).says_not(&["a verb is the first word"]);
    let blank = dir.run_words(&["my model.osim", "check"]);
    assert!(String::from_utf8(blank.stderr).unwrap().contains("'check \"my model.osim\"'"));
}

#[test]
fn a_number_beside_a_model_suggests_target_mass() {
    let dir = TestDir::with_human();
    assert_suggests(dir.run("human.osim 20"), "number");
    assert_suggests(dir.run("human.osim 20.5kg"), "number_kg");
    assert_suggests(dir.run("rescale human.osim 20"), "number_rescale");
    dir.run("human.osim --mass 80").succeeded().says(&["nothing was scaled", "--target-mass 80"]);
    // 20 g are 0.02 kg; a pound is 0.45359237 kg.
    assert_suggests(dir.run("human.osim 20g"), "number_g");
    assert_suggests(dir.run("human.osim 1lb"), "number_lb");
}

#[test]
fn drop_test_and_plot_refuse_a_folder() {
    let dir = TestDir::with(&[(HUMAN.0, "lib/human.osim"), (HUMAN.0, "sp ace/human.osim")]);
    assert_suggests(dir.run("drop-test lib"), "drop_test_folder");
    let blank = dir.run_words(&["drop-test", "sp ace"]);
    let message = String::from_utf8(blank.stderr).unwrap();
    // To be copied into any shell.
    assert!(message.contains("`osim-contact-scale inspect \"sp ace\"`"), "{message}");
    assert_suggests(dir.run("plot force lib -o x.svg"), "plot_folder");
}

#[test]
fn a_sweep_axis_without_grid_gets_a_suggestion() {
    let dir = TestDir::with_human();
    assert_suggests(dir.run("sweep human.osim stiffness=1e5:1e6:10"), "axis_assigned");
    assert_suggests(dir.run("sweep human.osim --stiffness 1e5:1e6:3"), "axis_option");
    assert_suggests(dir.run("sweep human.osim --stiffness=x0.1..x10/5"), "axis_option_joined");
    assert_suggests(dir.run("sweep human.osim --target-mass 10:20:90 --dry-run"), "axis_mass");
}

#[test]
fn a_note_without_changes_prints_no_empty_table() {
    let dir = TestDir::with_human();
    dir.run("note human.osim --contacts-mass 62 -o noted.osim")
        .succeeded()
        .matches_snapshot("suggestion_note");
}

#[test]
fn explain_knows_kinds_of_errors_and_short_names() {
    let dir = TestDir::new();
    for name in ["NeedsAnswer", "needs-answer"] {
        dir.run(&format!("explain {name}")).succeeded().says(&[
            "implausible-mass",
            "implausible-radius",
            "many-models",
        ]);
    }
    dir.run("explain E1").succeeded().says(&["stiffness (quantity)"]);
    dir.run("explain indentation").succeeded().says(&["indentation_m (quantity)"]);
    dir.run("explain gravity").succeeded().says(&["gravity_m_s2 (quantity)"]);
}

#[test]
fn a_range_in_matlab_syntax_gets_a_suggestion() {
    let dir = TestDir::with_human();
    assert_suggests(dir.run("plot sweep human.osim -o f.svg --stiffness 1e5:1e6:10"), "range_plot");
    assert_suggests(dir.run("sweep human.osim --grid stiffness=1e5:1e6:10"), "range_count");
    assert_suggests(dir.run("sweep human.osim --grid stiffness=1e5:1e5:1e6"), "range_steps");
}

#[test]
fn a_number_with_a_unit_is_refused_with_the_converted_number() {
    let dir = TestDir::with_human();
    for (unit, number) in [("g", "44g"), ("lb", "44lb"), ("kg", "44kg"), ("unknown", "44stone")] {
        assert_suggests(dir.run(&format!("human.osim --target-mass {number}")), &format!("mass_{unit}"));
    }
    for (unit, number) in [("mm", "32mm"), ("cm", "3.2cm"), ("m", "0.032m")] {
        assert_suggests(
            dir.run(&format!("human.osim --target-mass 62 --radius {number}")),
            &format!("radius_{unit}"),
        );
    }
    assert_suggests(dir.run("set human.osim radius=32mm"), "radius_set");
}

#[test]
fn explain_describes_every_quantity_with_a_common_mistake() {
    let dir = TestDir::new();
    for name in ["stiffness", "radius", "alpha", "hertz_smoothing", "x/R"] {
        dir.run(&format!("explain {name}"))
            .succeeded()
            .matches_snapshot(&format!("explain_quantity_{}", name.replace('/', "_")));
    }
    dir.run("explain alpha --format json").succeeded().matches_snapshot("explain_quantity_json");
    // Whatever a table of figures has as a name.
    let columns = dir.run("drop-test falisse2022 --format csv").succeeded().out();
    for column in columns.lines().next().unwrap().split(',') {
        dir.run(&format!("explain {column}")).succeeded().says(&["Trap:"]);
    }
}

#[test]
fn an_empty_file_is_reported_as_empty() {
    let dir = TestDir::with_human();
    dir.write("empty.osim", "");
    dir.write("blank.osim", "\u{feff} \r\n");
    for name in ["empty.osim", "blank.osim"] {
        dir.run(name).failed().says(&["the file is empty"]);
    }
}

#[test]
fn a_broken_generic_model_is_reported_once() {
    let dir = TestDir::with(&[HUMAN, (HUMAN.0, "other.osim"), ("bad/truncated.osim", "generic.osim")]);
    for verb in ["inspect", "check"] {
        let run = dir.run(&format!("{verb} human.osim other.osim --from generic.osim")).failed();
        assert_eq!(run.err().matches("error: ").count(), 1, "{}", run.err());
        // The fault is described once.
        assert_eq!(run.err().matches("truncated").count(), 1, "{}", run.err());
    }
    // A recording that is named has to be there, and is a file.
    for (motion, says) in
        [("none.mot", "there is no such file"), (".", "this is a folder, expected an ordinary file")]
    {
        let run = dir.run(&format!("check human.osim --motion {motion} --plates none.sto")).failed();
        assert!(run.err().contains(&format!("error: {motion}: {says}")), "{}", run.err());
    }
}

#[test]
fn masses_are_short_for_people_and_exact_for_programs() {
    // Sums of masses end like this one; it has one body.
    let dir = TestDir::with(&[("format/parameters_named.osim", "one.osim")]);
    let text = dir.text("one.osim");
    let (before, rest) = text.split_once("<mass>").unwrap();
    let (_, after) = rest.split_once("</mass>").unwrap();
    dir.write("one.osim", format!("{before}<mass>20.000000000000018</mass>{after}"));
    for call in ["inspect", "check"] {
        let out = dir.run(&format!("{call} one.osim --contacts-mass 30")).out();
        assert!(!out.contains("20.0000"), "{out}");
    }
    dir.run("one.osim --target-mass 30 --contacts-mass 25 --dry-run").succeeded().says(&[" says 20 kg"]);
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
        let run = dir.run(call);
        let message = format!("{}{}", run.out(), run.err());
        assert!(!message.contains("20.0000"), "{call}: {message}");
    }
    let json = dir.run("inspect one.osim --format json").succeeded().out();
    assert!(json.contains("20.000000000000018"), "{json}");
}

/// A pattern that matches no force is probably a mistake. A remark names the pattern, and the run continues.
#[test]
fn a_pattern_that_matches_no_force_is_named() {
    let dir = TestDir::with(&[("check/known_contacts.osim", "human.osim")]);
    let call = "rescale human.osim --target-mass 70 --dry-run";
    let words = "--exclude \"balls_*\": no contact force of the model has such a name";
    dir.run(&format!("{call} --exclude balls_*")).succeeded().says(&[words]);
    let words = "--select \"typo_*\": no contact force of the model has such a name";
    dir.run(&format!("{call} --select contact_* --select typo_*")).succeeded().says(&[words]);
    dir.run(&format!("{call} --select contact_*")).succeeded().says_not(&["no contact force of the model"]);
}

/// Every verb with patterns reports a pattern without a match, for forces and for bodies.
#[test]
fn every_verb_names_a_pattern_without_a_match() {
    let dir = TestDir::with(&[
        ("check/known_contacts.osim", "human.osim"),
        ("motion/walker.osim", "walker.osim"),
        ("motion/walk.mot", "walk.mot"),
    ]);
    let forces = "--exclude \"balls_*\": no contact force of the model has such a name";
    let bodies = "--exclude-body \"props_*\": no body of the model has such a name";
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
        let output_with = |words: &str| {
            let run = dir.run(&format!("{call} {words}"));
            let text = format!("{}{}", run.out(), run.err());
            text.split_whitespace().collect::<Vec<_>>().join(" ")
        };
        let text = output_with("--exclude balls_* --exclude-body props_*");
        for words in [forces, bodies] {
            assert!(text.contains(words), "{call}: {text}");
        }
        let text = output_with("");
        assert!(!text.contains("has such a name"), "{call}: {text}");
    }
}
