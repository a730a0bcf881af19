//! `--resume`: what still holds is passed over, what changed is done again, what somebody edited is left alone.

use crate::library::{column, library, model, no_temporary_files};
use crate::support::{Bench, Ran};

const CALL: &str = "lib --target-mass 500 -d out --summary done.csv";

fn resume(bench: &Bench) -> Ran {
    bench.run(&format!("{CALL} --resume"))
}

/// Five models, done.
fn done() -> Bench {
    let bench = library(5);
    bench.run(CALL).done().says(&["5 models: 5 written"]);
    bench
}

#[test]
fn what_holds_is_passed_over() {
    let bench = done();
    let before = bench.files();
    resume(&bench).done().wrote_nothing().says(&["5 models: 5 done before"]);
    assert!(bench.files() == before);
}

#[test]
fn a_model_that_changed_is_done_again() {
    let bench = done();
    bench.write("lib/odd/model03.osim", model(8));
    resume(&bench).done().wrote(&["done.csv", "out/odd/model03.osim"]).says(&["1 written", "4 done before"]);
    let calm = library(5);
    calm.write("lib/odd/model03.osim", model(8));
    calm.run(CALL).done();
    assert!(bench.files() == calm.files());
}

#[test]
fn other_options_do_all_again() {
    let bench = done();
    let other = "lib --target-mass 600 -d out --summary done.csv";
    bench.run(&format!("{other} --resume")).done().says(&["5 written"]);
    bench.run(&format!("{other} --no-note --resume")).done().says(&["5 written"]);
    // Options that change no output do nothing again.
    bench.run(&format!("{other} --no-note --jobs 1 --format json --resume")).done().says(&["5 done before"]);
    let calm = library(5);
    calm.run(&format!("{other} --no-note")).done();
    assert!(bench.files() == calm.files());
}

#[test]
fn another_reference_does_all_again() {
    let bench = library(3);
    bench.write("reference.osim", model(1));
    let call = "transfer lib --from reference.osim --spheres 2 -d out --summary done.ndjson --resume";
    let first = bench.run(call);
    let text = first.out() + &first.err();
    assert!(text.contains("written"), "{text}");
    let again = bench.run(call);
    assert!((again.out() + &again.err()).contains("done before"));
    bench.write("reference.osim", model(6));
    let ran = bench.run(call);
    let text = ran.out() + &ran.err();
    assert!(text.contains("written") && !text.contains("done before"), "{text}");
}

#[test]
fn an_output_that_is_gone_is_made_again() {
    let bench = done();
    let wanted = bench.files();
    std::fs::remove_file(bench.path("out/even/model02.osim")).unwrap();
    resume(&bench).done().wrote(&["out/even/model02.osim"]).says(&["1 written", "4 done before"]);
    assert!(bench.files() == wanted);
}

#[test]
fn an_output_that_somebody_edited_is_left_alone() {
    let bench = done();
    bench.write("out/even/model02.osim", "my work");
    resume(&bench).failed().says(&[
        "out/even/model02.osim is not what an earlier run wrote",
        "4 done before",
        "1 failed",
    ]);
    assert_eq!(bench.read("out/even/model02.osim"), b"my work");
    // Also where the model changed since.
    bench.write("lib/even/model02.osim", model(9));
    resume(&bench).failed().says(&["not what an earlier run wrote"]);
    assert_eq!(bench.read("out/even/model02.osim"), b"my work");
    bench.run(&format!("{CALL} --resume --force")).done().says(&["1 written", "4 done before"]);
}

#[test]
fn models_that_failed_are_tried_again() {
    let bench = library(3);
    bench.write("lib/odd/model01.osim", "<OpenSimDocument>");
    bench.run(CALL).failed().says(&["2 written, 1 failed"]);
    let summary = bench.text("done.csv");
    assert_eq!(column(&summary, "status")["model01.osim"], "failed");
    assert_eq!(column(&summary, "error_code")["model01.osim"], "malformed-xml");
    bench.write("lib/odd/model01.osim", model(1));
    resume(&bench).done().says(&["1 written", "2 done before"]);
    let calm = library(3);
    calm.run(CALL).done();
    assert!(bench.files() == calm.files());
}

/// A run that replaced an output was killed after it had said what it was about to write.
#[test]
fn an_output_of_the_run_before_the_last_is_known_too() {
    let bench = done();
    let old = bench.read("out/odd/model01.osim");
    bench.write("lib/odd/model01.osim", model(11));
    resume(&bench).done();
    // As it was left: the whole summary of the first run, a line of the second, the output not yet replaced.
    let (new, whole) = (bench.text("done.csv"), library(5));
    whole.run(CALL).done();
    let line = new.lines().find(|line| line.contains("odd/model01.osim")).unwrap();
    let header = new.lines().next().unwrap();
    bench.write("done.csv", whole.read("done.csv"));
    bench.write("done.csv.partial", format!("{header}\n{line}\n,lib/odd/model03.o"));
    bench.write("out/odd/model01.osim", old);
    // The file of a run that goes on is gone at its end.
    let mut command = bench.command(&format!("{CALL} --resume --quiet"));
    assert!(command.status().unwrap().success());
    assert_eq!(bench.text("done.csv"), new);
    assert!(!bench.has("done.csv.partial"));
    no_temporary_files(&bench);
}

#[test]
fn in_place_a_factor_is_applied_once() {
    let bench = library(4);
    let call = "set lib stiffness=x2 --in-place --no-backup --summary done.csv";
    bench.run(call).done();
    let once = bench.files();
    bench.run(&format!("{call} --resume")).done().wrote_nothing().says(&["4 done before"]);
    assert!(bench.files() == once);
}

/// The geometry of a standalone force set is an output like the forces.
#[test]
fn a_geometry_that_is_gone_is_made_again() {
    let bench = Bench::with(&[
        ("format/standalone_ForceSet.xml", "forces.xml"),
        ("format/standalone_ContactGeometrySet.xml", "geometry.xml"),
        ("format/standalone_model_without_contacts.osim", "bones.osim"),
    ]);
    let call =
        "forces.xml --geometry geometry.xml --model bones.osim --target-mass 500 -d out --summary done.csv";
    bench.run(call).done();
    let wanted = bench.files();
    std::fs::remove_file(bench.path("out/geometry.xml")).unwrap();
    bench.run(&format!("{call} --resume")).done().wrote(&["out/geometry.xml"]);
    assert!(bench.files() == wanted);
    std::fs::remove_file(bench.path("out/forces.xml")).unwrap();
    bench.run(&format!("{call} --resume")).done().wrote(&["out/forces.xml"]);
    bench.write("out/geometry.xml", "my work");
    bench
        .run(&format!("{call} --resume"))
        .failed()
        .wrote(&["done.csv"])
        .says(&["out/geometry.xml is not what an earlier run wrote"]);
}

#[test]
fn a_file_that_is_no_summary_is_neither_believed_nor_replaced() {
    for (name, text) in [
        ("done.csv", "frame,radius\n1,0.03\n"),
        ("done.csv", "frame,radius\n"),
        ("done.csv", "model,status\nlib/a.osim,written\n"),
        ("done.csv", "my notes"),
        ("done.ndjson", "{\"frame\": 1}\n"),
        ("done.ndjson", "[1, 2]\n"),
        ("done.ndjson", "my notes"),
    ] {
        let bench = library(2);
        bench.write(name, text);
        let call = format!("lib --target-mass 500 -d out --summary {name}");
        bench.run(&format!("{call} --resume")).usage().wrote_nothing().says(&["cannot go on with", name]);
        bench.run(&call).usage().wrote_nothing().says(&["exists already", "--resume", "--force"]);
    }
}

#[test]
fn a_summary_that_is_torn_or_was_saved_by_a_spreadsheet_is_refused() {
    let bench = done();
    let whole = bench.text("done.csv");
    for damaged in [&whole[..whole.len() - 30], &whole.replace(',', ";"), &whole.replace("written", "writ")] {
        bench.write("done.csv", damaged);
        resume(&bench).usage().wrote_nothing().says(&["cannot go on with done.csv"]);
    }
}

#[test]
fn what_a_spreadsheet_made_of_a_summary_is_refused_also_with_commas() {
    for name in ["done.csv", "done.csv.partial"] {
        let bench = done();
        let whole = bench.text("done.csv");
        let added = |column: &str| {
            let (header, rows) = whole.split_once('\n').unwrap();
            format!("{header},{column}\n{}", rows.replace('\n', ",good\n"))
        };
        let saved =
            [whole.replace('\n', "\r\n"), format!("\u{feff}{whole}"), added("my notes"), added("#my notes")];
        for saved in saved {
            bench.write(name, &saved);
            resume(&bench).usage().wrote_nothing().says(&["cannot go on with done.csv", "summary"]);
        }
    }
}

#[test]
fn own_columns_of_a_table_may_be_added_and_not_lost() {
    let bench = library(1);
    let model = bench.files().into_keys().find(|name| name.ends_with(".osim")).unwrap();
    let mut tables = Vec::new();
    for own in ["", ",#sex", ",#sex,#age"] {
        let cells = own.replace('#', "");
        tables.push(format!("model,target-mass,output{own}\n{model},500,a.osim{cells}\n"));
    }
    bench.write("m.csv", &tables[1]);
    bench.run("batch m.csv --summary done.csv").done().says(&["written: a.osim"]);
    bench.write("m.csv", &tables[2]);
    bench.run("batch m.csv --summary done.csv --resume").done().wrote(&["done.csv"]);
    assert!(bench.text("done.csv").lines().next().unwrap().ends_with(",folder,#sex,#age"));
    bench.write("m.csv", &tables[0]);
    let refused = bench.run("batch m.csv --summary done.csv --resume");
    refused.usage().wrote_nothing().says(&["cannot go on with done.csv", "'#sex'"]);
}

#[test]
fn what_a_killed_run_left_is_not_overwritten_unasked() {
    let bench = library(2);
    bench.write("done.csv.partial", "");
    bench.run(CALL).usage().wrote_nothing().says(&["left by a run that was stopped", "--resume", "--force"]);
}

#[test]
fn the_summary_is_no_output_and_no_input() {
    let bench = library(1);
    bench.write("reference.csv", model(0));
    bench
        .run("transfer lib --from reference.csv -d out --summary reference.csv --force")
        .usage()
        .wrote_nothing()
        .says(&["reference.csv"]);
    bench
        .run("lib/even/model00.osim --target-mass 500 -o x.csv --summary x.csv --force")
        .usage()
        .wrote_nothing()
        .says(&["x.csv"]);
    bench
        .run("lib --target-mass 500 -d out --summary done.txt")
        .usage()
        .wrote_nothing()
        .says(&[".csv or .ndjson"]);
}

#[test]
fn what_an_earlier_run_wrote_is_still_ours_after_a_run_in_which_the_model_failed() {
    let bench = done();
    let good = bench.read("lib/odd/model03.osim");
    bench.write("lib/odd/model03.osim", &good[..good.len() / 2]);
    let at = |mass: &str| format!("lib --target-mass {mass} -d out --summary done.csv --resume");
    bench.run(&at("600")).failed().says(&["4 written", "1 failed"]);
    bench.write("lib/odd/model03.osim", &good);
    bench.run(&at("700")).done().says(&["5 models: 5 written"]);
    let calm = library(5);
    calm.run("lib --target-mass 700 -d out --summary done.csv").done();
    assert!(bench.files() == calm.files());
}

#[test]
fn rows_of_a_manifest_may_move() {
    let bench = library(2);
    let rows = "lib/model00.osim,a.osim\nlib/model02.osim,b.osim\n";
    let files = bench.files();
    let names: Vec<&String> = files.keys().filter(|name| name.ends_with(".osim")).collect();
    let rows = rows.replace("lib/model00.osim", names[0]).replace("lib/model02.osim", names[1]);
    bench.write("m.csv", format!("model,output,target-mass\n{}", rows.replace(".osim\n", ".osim,500\n")));
    bench.run("batch m.csv --summary done.csv").done().says(&["2 written"]);
    let new = format!("{},c.osim,500\n", names[0]);
    bench
        .write("m.csv", format!("model,output,target-mass\n{new}{}", rows.replace(".osim\n", ".osim,500\n")));
    bench.run("batch m.csv --summary done.csv --resume").done().says(&["1 written", "2 done before"]);
    let summary = bench.text("done.csv");
    let rows: Vec<&str> = summary.lines().skip(1).map(|line| line.split(',').next().unwrap()).collect();
    assert_eq!(rows, ["2", "3", "4"]);
}

/// One model is one model, however its name, its output or the folder of the call is spelled.
#[test]
fn what_was_done_is_known_by_any_spelling_and_from_any_folder() {
    let bench = done();
    let root = bench.path("").display().to_string();
    let root = root.trim_end_matches('/');
    for (input, output) in [
        ("./lib", "./out"),
        ("lib/../lib", "lib/../out"),
        (&format!("{root}/lib") as &str, "out"),
        ("lib", &format!("{root}/out") as &str),
    ] {
        let call = format!("{input} --target-mass 500 -d {output} --summary done.csv --resume");
        bench.run(&call).done().says(&["5 models: 5 done before"]);
    }
    let outside = bench.path("elsewhere");
    std::fs::create_dir(&outside).unwrap();
    let call = "../lib --target-mass 500 -d ../out --summary ../done.csv --resume";
    let ran = bench.command(call).current_dir(&outside).output().unwrap();
    let text = String::from_utf8_lossy(&ran.stderr).into_owned();
    assert!(ran.status.success() && text.contains("5 done before"), "{text}");
    resume(&bench).done().says(&["5 done before"]);
}

#[cfg(unix)]
#[test]
fn in_place_a_factor_is_applied_once_by_any_spelling() {
    let bench = library(3);
    let call = |folder: &str, more: &str| {
        format!("set {folder} stiffness=x2 --no-note --no-backup --in-place --summary s.csv{more}")
    };
    bench.run(&call("lib", "")).done();
    std::os::unix::fs::symlink(bench.path("lib"), bench.path("link")).unwrap();
    let once = crate::library::below(&bench.files(), "lib/");
    for folder in ["./lib", "link", "lib/odd/../../lib"] {
        bench.run(&call(folder, " --resume")).done().says(&["3 done before"]);
        assert!(crate::library::below(&bench.files(), "lib/") == once, "{folder}");
    }
}

/// A run over fewer models says nothing about the others: their lines stay.
#[test]
fn lines_of_models_that_are_not_in_this_run_stay() {
    let bench = done();
    let before = bench.text("done.csv");
    let lines = |text: &str| {
        let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
        lines.sort();
        lines
    };
    let part = "lib/even --target-mass 500 -d out/even --summary done.csv --resume";
    bench.run(part).done().says(&["3 models: 3 done before"]);
    assert_eq!(lines(&bench.text("done.csv")), lines(&before));
    // Nothing is known of this output: it fails, and costs no line.
    bench.write("new/model02.osim", "my work");
    bench.run("lib/even/model02.osim --target-mass 500 -d new --summary done.csv --resume").failed();
    let text = bench.text("done.csv");
    assert!(lines(&before)[..5].iter().all(|line| text.contains(line.as_str())), "{text}");
    resume(&bench).done().wrote(&["done.csv"]).says(&["5 done before"]);
}

#[test]
fn a_share_that_is_not_this_summarys_costs_no_line() {
    let bench = library(6);
    let call = |share: &str| format!("lib --target-mass 500 -d out --shard {share} --summary s1.csv");
    bench.run(&call("1/2")).done();
    let of_first: Vec<String> = bench.text("s1.csv").lines().skip(1).map(str::to_owned).collect();
    assert!(!of_first.is_empty() && of_first.len() < 6, "{of_first:?}");
    bench.run(&format!("{} --resume", call("2/2"))).done();
    let text = bench.text("s1.csv");
    assert_eq!(text.lines().count(), 7, "{text}");
    assert!(of_first.iter().all(|line| text.contains(line.as_str())), "{text}");
    let before = format!("{} done before", of_first.len());
    bench.run(&format!("{} --resume", call("1/2"))).done().says(&[&before]);
}

/// Rows are removed, come back, and change places; the columns of the user's own with them.
#[test]
fn rows_of_a_manifest_may_go_and_come_back_and_exchange_their_outputs() {
    for summary in ["done.csv", "done.ndjson"] {
        let bench = Bench::with(&[
            ("table1/human_62kg_smooth_sphere.osim", "a.osim"),
            ("table1/human_62kg_hunt_crossley.osim", "b.osim"),
        ]);
        let call = format!("batch m.csv --summary {summary}");
        let table = |rows: &str| bench.write("m.csv", format!("#who,model,output,target-mass\n{rows}"));
        table("me,a.osim,o/x.osim,70\nyou,b.osim,o/y.osim,70\n");
        bench.run(&call).done().says(&["2 written"]);
        table("me,a.osim,o/x.osim,70\n");
        bench.run(&format!("{call} --resume")).done();
        assert!(bench.text(summary).contains("you"), "{summary}");
        table("me,a.osim,o/x.osim,70\nyou,b.osim,o/y.osim,70\n");
        bench.run(&format!("{call} --resume")).done().wrote(&[summary]).says(&["2 done before"]);
        table("me,a.osim,o/y.osim,70\nyou,b.osim,o/x.osim,70\n");
        bench.run(&format!("{call} --resume")).done().says(&["2 written"]);
        bench.run(&format!("{call} --resume")).done().says(&["2 done before"]);
        let calm = Bench::with(&[("table1/human_62kg_smooth_sphere.osim", "a.osim")]);
        calm.run("a.osim --target-mass 70 -o o/y.osim").done();
        assert_eq!(bench.read("o/y.osim"), calm.read("o/y.osim"));
    }
}

/// A corrected factor would come on top of the one before.
#[test]
fn in_place_another_factor_is_not_applied_on_top() {
    let bench = Bench::with(&[("table1/human_62kg_smooth_sphere.osim", "a.osim")]);
    let table =
        |factor: &str| bench.write("m.csv", format!("model,verb,set\na.osim,set,stiffness={factor}\n"));
    let call = "batch m.csv --in-place --summary done.csv";
    table("x2");
    bench.run(call).done();
    let (twice, backup) = (bench.read("a.osim"), bench.read("a.osim.bak"));
    table("x3");
    for _ in 0..2 {
        bench
            .run(&format!("{call} --resume"))
            .failed()
            .says(&["an earlier run changed this model", "--force"]);
        assert_eq!(bench.read("a.osim"), twice);
    }
    // Back to what it was: the same change has its line still.
    table("x2");
    bench.run(&format!("{call} --resume")).done();
    table("x3");
    bench.write("a.osim", backup);
    bench.run(&format!("{call} --resume")).done();
    let text = bench.text("a.osim");
    // The fixture's stiffness is 1e6 N/m2.
    assert!(text.contains("<stiffness>3000000</stiffness>"), "{text}");
}
