//! The judged cases of [`cases`](crate::cases) about the terminal: folders, tables, files that are not models, and words of the command.

use crate::cases::dir_of_case;
use crate::support::{HUMAN, TestDir, fixture, report_skip};

#[test]
fn a_printed_command_works_for_a_name_with_a_line_end_or_a_tab() {
    let Some(dir) = dir_of_case("remedy_name_with_newline") else { return };
    for name in ["a\nb.osim", "a\tb's.osim"] {
        dir.write(name, dir.read("model.osim"));
        let out = String::from_utf8(dir.run_words(&["check", name]).stdout).unwrap();
        let line = out.lines().find_map(|line| line.trim_start().strip_prefix("$ ")).unwrap();
        let script = format!("osim-contact-scale() {{ \"$COMMAND\" \"$@\"; }}; {line}");
        let output = std::process::Command::new("bash")
            .args(["-c", &script])
            .current_dir(dir.path(""))
            .env("COMMAND", env!("CARGO_BIN_EXE_osim-contact-scale"))
            .output();
        let Ok(output) = output else { return report_skip("a printed command", "there is no bash") };
        assert!(output.status.success(), "{line}: {}", String::from_utf8_lossy(&output.stderr));
    }
}

#[test]
fn a_second_run_over_a_folder_is_refused_in_one_line() {
    let dir = TestDir::new();
    (0..30).for_each(|number| dir.write(&format!("lib/s{number:02}.osim"), fixture(HUMAN.0)));
    dir.run("lib --target-mass 80 -d out").succeeded();
    let run = dir.run("lib --target-mass 80 -d out").usage_error().wrote_nothing();
    assert_eq!((run.out().as_str(), run.err().lines().count()), ("", 1), "{}", run.err());
    run.says(&["30 of 30 results exist already", "--force", "--summary FILE --resume", "-d DIR"]);
    // A run that kept a summary can be resumed.
    dir.run("lib --target-mass 80 -d kept --summary kept.csv").succeeded();
    dir.run("lib --target-mass 80 -d kept --summary kept.csv --resume").succeeded();
    // One model names its own result; a dry run writes nothing, and `--force` replaces all.
    dir.run("lib/s00.osim --target-mass 80 -d out")
        .failed()
        .says(&["out/s00.osim exists already: choose another name (-o) or folder (-d)"]);
    dir.run("lib --target-mass 80 -d out --dry-run").succeeded();
    dir.run("lib --target-mass 80 -d out --force").succeeded();
}

#[test]
fn models_that_failed_or_were_skipped_are_named_at_the_end() {
    let dir = TestDir::with(&[
        (HUMAN.0, "lib/s00.osim"),
        ("bad/truncated.osim", "lib/a_broken.osim"),
        ("bad/no_contacts.osim", "lib/c_bare.osim"),
    ]);
    dir.write("lib/b_text.osim", "mass 62");
    let err = dir.run("lib --target-mass 80 -d out").failed().err();
    let lines: Vec<&str> = err.lines().collect();
    let last = &lines[lines.len() - 3..];
    assert!(last[0].starts_with("remark: 4 models: 1 written, 1 skipped (no contacts), 2 failed"), "{err}");
    assert_eq!(
        &last[1..],
        ["remark: failed: lib/a_broken.osim, lib/b_text.osim", "remark: skipped: lib/c_bare.osim"]
    );
    (0..12).for_each(|number| dir.write(&format!("many/s{number:02}.osim"), "mass 62"));
    dir.run("many --target-mass 80 -d out").failed().says(&["many/s08.osim, many/s09.osim and 2 more\n"]);
}

#[test]
fn files_that_are_not_models_are_named_by_what_they_are() {
    let dir = TestDir::with(&[("motion/walk.mot", "walk.mot"), ("motion/plates.sto", "plates.sto")]);
    dir.write("m.zip", b"PK\x03\x04\0\0");
    dir.write("m.osim.gz", b"\x1F\x8B\x08\0\0");
    for (name, what) in [("m.zip", "a ZIP"), ("m.osim.gz", "a gzip")] {
        let text = format!("this is {what} archive, expected an OpenSim model: unpack it first");
        dir.run(&format!("inspect {name}")).failed().says(&[&text]);
    }
    dir.write("subjects.csv", "model,target-mass\nhuman.osim,70\n");
    dir.run("check subjects.csv").failed().says(&["this is a table", "tables of models go with batch"]);
    // The shells of Windows hand them over as they are.
    dir.run("check *.osim")
        .failed()
        .says(&["there is no such file, and * is not expanded: name the folder or a file"]);
    dir.run("check https://example.org/m.osim").failed().says(&["but an address: download it first"]);
    for name in ["walk.mot", "plates.sto"] {
        dir.run(&format!("check {name}"))
            .failed()
            .says(&["this is a motion", "check MODEL --motion FILE --plates FORCES"]);
    }
}

#[test]
fn presets_are_all_listed() {
    let dir = TestDir::with_human();
    dir.run("presets").succeeded().says(&["falisse2022", "moco-2d-gait"]);
    let out = dir.run("presets moco-2d-gait").succeeded().says_not(&["dhondt2024"]).out();
    assert!(out.starts_with("moco-2d-gait\nspheres with radii and places of their own"), "{out}");
    // One that is misspelled or cut off is named, and so is a model without its ending.
    for (call, near) in [
        ("presets Falisse2022", "falisse2022"),
        ("presets falisse", "falisse2022"),
        ("presets moco-2d", "moco-2d-gait"),
        ("transfer human.osim --from falise2022", "falisse2022"),
        ("transfer human.osim --from human", "human.osim"),
    ] {
        dir.run(call).usage_error().wrote_nothing().says(&[&format!("did you mean '{near}'?")]);
    }
    let run = dir.run("presets nobody2022").usage_error();
    run.says(&["osim-rl, dhondt2024, moco-2d-gait"]).says_not(&["did you mean"]);
    let missing = ["check human.osim --from human", "check human.osim --from “human.osim”"];
    for call in ["check human", "inspect humn.osim"].into_iter().chain(missing) {
        dir.run(call).failed().says(&["there is no such file: did you mean human.osim?"]);
    }
    // The name of another subject is not near, nor one that has little more in common than the ending.
    dir.write("s12.osim", "");
    for other in ["s13.osim", "bb12.osim"] {
        dir.run(&format!("check {other}")).failed().says_not(&["did you mean"]);
    }
}

#[test]
fn every_verb_can_be_quiet() {
    let dir = TestDir::with_human();
    for call in [
        "check human.osim",
        "inspect human.osim",
        "human.osim --target-mass 80",
        "presets",
        "explain stiffness",
    ] {
        let run = dir.run(&format!("{call} -q")).succeeded();
        assert_eq!((run.out().as_str(), run.err().as_str()), ("", ""), "{call}");
    }
    dir.write("broken.osim", "mass 62");
    dir.run("check broken.osim --quiet").failed().says(&["error: "]);
    assert!(dir.run("check human.osim -q --format json").succeeded().out().starts_with('{'));
}

#[test]
fn an_output_without_an_ending_causes_a_warning() {
    let dir = TestDir::with_human();
    let words = ["warning: out: the name of a model ends in .osim; to write into a folder, say -d"];
    dir.run("human.osim --target-mass 80 -o out").succeeded().wrote(&["out"]).says(&words);
    dir.run("human.osim --target-mass 80 -o out.osim").succeeded().says_not(&["warning: out"]);
    dir.run("human.osim --target-mass 80 -o no/such/x.osim")
        .usage_error()
        .wrote_nothing()
        .says(&["the folder no/such is not there", "-d DIR"]);
    dir.run("human.osim --target-mass 80 -o new/")
        .usage_error()
        .wrote_nothing()
        .says(&["the folder new/ is not there", "-d DIR"]);
}

#[test]
fn files_beside_results_ask_for_their_folder_as_an_output_does() {
    let dir = TestDir::with(&[HUMAN, ("motion/walker.osim", "walker.osim"), ("motion/walk.mot", "walk.mot")]);
    for call in [
        "human.osim --target-mass 80 --report no/such/r.html",
        "human.osim --target-mass 80 --dry-run --summary no/such/s.csv",
        "human.osim --target-mass 80 -d out --summary no/such/s.csv",
        "check human.osim --report no/such/r.html",
        "inspect human.osim --report no/such/r.html",
        "plot force human.osim -o no/such/f.svg",
        "plot force human.osim -o f.svg --data no/such/f.csv",
        "motion walker.osim walk.mot -o no/such/forces.sto",
    ] {
        let message = "error: the folder no/such is not there: make it first";
        dir.run(call).usage_error().wrote_nothing().says(&[message]);
    }
    // The run makes this one for its results.
    let call = "human.osim --target-mass 80 -d out/kg80 --report out/r.html --summary ./out/s.csv";
    dir.run(call).succeeded().wrote(&["out/kg80/human.osim", "out/r.html", "out/s.csv"]);
    dir.run("check human.osim --report r.html").succeeded().wrote(&["r.html"]);
}

#[test]
fn other_columns_of_a_table_are_in_the_summary() {
    let Some(dir) = dir_of_case("batch_carries_other_columns") else { return };
    dir.write("m.osim", fixture(HUMAN.0));
    dir.run("batch t.csv -d out --summary s.csv")
        .succeeded()
        .says(&["these columns are not options", "subject, age"]);
    let summary = dir.text("s.csv");
    let mut lines = summary.lines();
    assert!(
        lines.next().unwrap().ends_with(",subject,age") && lines.next().unwrap().ends_with(",P01,31"),
        "{summary}"
    );
    // They are read again when a run goes on, and changed ones are taken over.
    dir.write("t.csv", dir.text("t.csv").replace("31", "32"));
    dir.run("batch t.csv -d out --summary s.csv --resume").succeeded().wrote(&["s.csv"]);
    assert!(dir.text("s.csv").contains(",P01,32\n"));
    for (header, words) in [
        ("model,target-mas", "did you mean 'target-mass'?"),
        ("model,status", "the summary has a column 'status' of its own"),
    ] {
        dir.write("t.csv", format!("{header}\nm.osim,80\n"));
        dir.run("batch t.csv -d out2").usage_error().wrote_nothing().says(&[words]);
    }
}

#[test]
fn common_headers_of_tables_are_understood() {
    let Some(dir) = dir_of_case("batch_column_file") else { return };
    dir.write("m.osim", fixture(HUMAN.0));
    dir.run("batch t.csv -d out").succeeded().wrote(&["out/m.osim"]);
    dir.write("t.csv", "Path,Target mass (kg)\nm.osim,80\n");
    dir.run("batch t.csv -d out2").succeeded().wrote(&["out2/m.osim"]);
    assert_eq!(dir.read("out/m.osim"), dir.read("out2/m.osim"));
}
