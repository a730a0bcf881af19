//! A run with `--resume` skips unchanged models, writes changed models again, and keeps edited outputs.

use crate::model_folder::{assert_no_temporary_files, column_by_model, folder_with_models, model_bytes};
use crate::support::{CommandRun, TestDir};

const CALL: &str = "lib --target-mass 500 -d out --summary done.csv";

fn resume_run(dir: &TestDir) -> CommandRun {
    dir.run(&format!("{CALL} --resume"))
}

/// A folder after a run over five models.
fn finished_run() -> TestDir {
    let dir = folder_with_models(5);
    dir.run(CALL).succeeded().says(&["5 models: 5 written"]);
    dir
}

#[test]
fn a_resumed_run_skips_unchanged_models() {
    let dir = finished_run();
    let before = dir.files();
    resume_run(&dir).succeeded().wrote_nothing().says(&["5 models: 5 done before"]);
    assert!(dir.files() == before);
}

#[test]
fn a_changed_model_is_written_again() {
    let dir = finished_run();
    dir.write("lib/odd/model03.osim", model_bytes(8));
    resume_run(&dir)
        .succeeded()
        .wrote(&["done.csv", "out/odd/model03.osim"])
        .says(&["1 written", "4 done before"]);
    let undisturbed = folder_with_models(5);
    undisturbed.write("lib/odd/model03.osim", model_bytes(8));
    undisturbed.run(CALL).succeeded();
    assert!(dir.files() == undisturbed.files());
}

#[test]
fn other_options_write_all_models_again() {
    let dir = finished_run();
    let other = "lib --target-mass 600 -d out --summary done.csv";
    dir.run(&format!("{other} --resume")).succeeded().says(&["5 written"]);
    dir.run(&format!("{other} --no-note --resume")).succeeded().says(&["5 written"]);
    // Options that change no output write nothing again.
    dir.run(&format!("{other} --no-note --jobs 1 --format json --resume"))
        .succeeded()
        .says(&["5 done before"]);
    let undisturbed = folder_with_models(5);
    undisturbed.run(&format!("{other} --no-note")).succeeded();
    assert!(dir.files() == undisturbed.files());
}

#[test]
fn another_reference_writes_all_models_again() {
    let dir = folder_with_models(3);
    dir.write("reference.osim", model_bytes(1));
    let call = "transfer lib --from reference.osim --spheres 2 -d out --summary done.ndjson --resume";
    let first = dir.run(call);
    let text = first.out() + &first.err();
    assert!(text.contains("written"), "{text}");
    let resumed = dir.run(call);
    assert!((resumed.out() + &resumed.err()).contains("done before"));
    dir.write("reference.osim", model_bytes(6));
    let run = dir.run(call);
    let text = run.out() + &run.err();
    assert!(text.contains("written") && !text.contains("done before"), "{text}");
}

#[test]
fn a_missing_output_is_written_again() {
    let dir = finished_run();
    let files_before = dir.files();
    std::fs::remove_file(dir.path("out/even/model02.osim")).unwrap();
    resume_run(&dir).succeeded().wrote(&["out/even/model02.osim"]).says(&["1 written", "4 done before"]);
    assert!(dir.files() == files_before);
}

#[test]
fn a_resumed_run_keeps_an_edited_output() {
    let dir = finished_run();
    dir.write("out/even/model02.osim", "my work");
    resume_run(&dir).failed().says(&[
        "out/even/model02.osim is not what an earlier run wrote",
        "4 done before",
        "1 failed",
    ]);
    assert_eq!(dir.read("out/even/model02.osim"), b"my work");
    // Also if the model was changed.
    dir.write("lib/even/model02.osim", model_bytes(9));
    resume_run(&dir).failed().says(&["not what an earlier run wrote"]);
    assert_eq!(dir.read("out/even/model02.osim"), b"my work");
    dir.run(&format!("{CALL} --resume --force")).succeeded().says(&["1 written", "4 done before"]);
}

#[test]
fn models_that_failed_are_tried_again() {
    let dir = folder_with_models(3);
    dir.write("lib/odd/model01.osim", "<OpenSimDocument>");
    dir.run(CALL).failed().says(&["2 written, 1 failed"]);
    let summary = dir.text("done.csv");
    assert_eq!(column_by_model(&summary, "status")["model01.osim"], "failed");
    assert_eq!(column_by_model(&summary, "error_code")["model01.osim"], "malformed-xml");
    dir.write("lib/odd/model01.osim", model_bytes(1));
    resume_run(&dir).succeeded().says(&["1 written", "2 done before"]);
    let undisturbed = folder_with_models(3);
    undisturbed.run(CALL).succeeded();
    assert!(dir.files() == undisturbed.files());
}

/// The last run was killed after it had written the summary line of an output and before it replaced the output.
#[test]
fn an_output_of_the_run_before_the_last_is_replaced() {
    let dir = finished_run();
    let old = dir.read("out/odd/model01.osim");
    dir.write("lib/odd/model01.osim", model_bytes(11));
    resume_run(&dir).succeeded();
    // The state after the kill: the whole summary of the first run, one line of the second, the output not yet replaced.
    let (new_summary, first_summary) = (dir.text("done.csv"), folder_with_models(5));
    first_summary.run(CALL).succeeded();
    let line = new_summary.lines().find(|line| line.contains("odd/model01.osim")).unwrap();
    let header = new_summary.lines().next().unwrap();
    dir.write("done.csv", first_summary.read("done.csv"));
    dir.write("done.csv.partial", format!("{header}\n{line}\n,lib/odd/model03.o"));
    dir.write("out/odd/model01.osim", old);
    // The partial summary is removed at the end of the resumed run, so `run` cannot be used.
    let mut command = dir.command(&format!("{CALL} --resume --quiet"));
    assert!(command.status().unwrap().success());
    assert_eq!(dir.text("done.csv"), new_summary);
    assert!(!dir.has("done.csv.partial"));
    assert_no_temporary_files(&dir);
}

#[test]
fn a_factor_in_place_is_applied_once() {
    let dir = folder_with_models(4);
    let call = "set lib stiffness=x2 --in-place --no-backup --summary done.csv";
    dir.run(call).succeeded();
    let files_before = dir.files();
    dir.run(&format!("{call} --resume")).succeeded().wrote_nothing().says(&["4 done before"]);
    assert!(dir.files() == files_before);
}

/// The geometry set of a standalone force set is an output, too.
#[test]
fn a_missing_geometry_is_written_again() {
    let dir = TestDir::with(&[
        ("format/standalone_ForceSet.xml", "forces.xml"),
        ("format/standalone_ContactGeometrySet.xml", "geometry.xml"),
        ("format/standalone_model_without_contacts.osim", "bones.osim"),
    ]);
    let call =
        "forces.xml --geometry geometry.xml --model bones.osim --target-mass 500 -d out --summary done.csv";
    dir.run(call).succeeded();
    let files_before = dir.files();
    std::fs::remove_file(dir.path("out/geometry.xml")).unwrap();
    dir.run(&format!("{call} --resume")).succeeded().wrote(&["out/geometry.xml"]);
    assert!(dir.files() == files_before);
    std::fs::remove_file(dir.path("out/forces.xml")).unwrap();
    dir.run(&format!("{call} --resume")).succeeded().wrote(&["out/forces.xml"]);
    dir.write("out/geometry.xml", "my work");
    dir.run(&format!("{call} --resume"))
        .failed()
        .wrote(&["done.csv"])
        .says(&["out/geometry.xml is not what an earlier run wrote"]);
}

#[test]
fn a_file_that_is_not_a_summary_is_refused() {
    for (name, text) in [
        ("done.csv", "frame,radius\n1,0.03\n"),
        ("done.csv", "frame,radius\n"),
        ("done.csv", "model,status\nlib/a.osim,written\n"),
        ("done.csv", "my notes"),
        ("done.ndjson", "{\"frame\": 1}\n"),
        ("done.ndjson", "[1, 2]\n"),
        ("done.ndjson", "my notes"),
    ] {
        let dir = folder_with_models(2);
        dir.write(name, text);
        let call = format!("lib --target-mass 500 -d out --summary {name}");
        dir.run(&format!("{call} --resume"))
            .usage_error()
            .wrote_nothing()
            .says(&["cannot continue with", name]);
        dir.run(&call).usage_error().wrote_nothing().says(&["exists already", "--resume", "--force"]);
    }
}

#[test]
fn a_truncated_or_reformatted_summary_is_refused() {
    let dir = finished_run();
    let first_summary = dir.text("done.csv");
    for damaged in [
        &first_summary[..first_summary.len() - 30],
        &first_summary.replace(',', ";"),
        &first_summary.replace("written", "writ"),
    ] {
        dir.write("done.csv", damaged);
        resume_run(&dir).usage_error().wrote_nothing().says(&["cannot continue with done.csv"]);
    }
}

#[test]
fn a_summary_saved_by_a_spreadsheet_with_commas_is_refused() {
    for name in ["done.csv", "done.csv.partial"] {
        let dir = finished_run();
        let first_summary = dir.text("done.csv");
        let added = |column: &str| {
            let (header, rows) = first_summary.split_once('\n').unwrap();
            format!("{header},{column}\n{}", rows.replace('\n', ",good\n"))
        };
        let saved = [
            first_summary.replace('\n', "\r\n"),
            format!("\u{feff}{first_summary}"),
            added("my notes"),
            added("#my notes"),
        ];
        for saved in saved {
            dir.write(name, &saved);
            resume_run(&dir)
                .usage_error()
                .wrote_nothing()
                .says(&["cannot continue with done.csv", "summary"]);
        }
    }
}

#[test]
fn user_columns_may_be_added_but_not_removed() {
    let dir = folder_with_models(1);
    let model = dir.files().into_keys().find(|name| name.ends_with(".osim")).unwrap();
    let mut tables = Vec::new();
    for user_columns in ["", ",#sex", ",#sex,#age"] {
        let cells = user_columns.replace('#', "");
        tables.push(format!("model,target-mass,output{user_columns}\n{model},500,a.osim{cells}\n"));
    }
    dir.write("m.csv", &tables[1]);
    dir.run("batch m.csv --summary done.csv").succeeded().says(&["written: a.osim"]);
    dir.write("m.csv", &tables[2]);
    dir.run("batch m.csv --summary done.csv --resume").succeeded().wrote(&["done.csv"]);
    assert!(dir.text("done.csv").lines().next().unwrap().ends_with(",folder,#sex,#age"));
    dir.write("m.csv", &tables[0]);
    let refused = dir.run("batch m.csv --summary done.csv --resume");
    refused.usage_error().wrote_nothing().says(&["cannot continue with done.csv", "'#sex'"]);
}

#[test]
fn a_partial_summary_is_overwritten_only_on_request() {
    let dir = folder_with_models(2);
    dir.write("done.csv.partial", "");
    dir.run(CALL).usage_error().wrote_nothing().says(&[
        "left by a run that was stopped",
        "--resume",
        "--force",
    ]);
}

#[test]
fn the_summary_may_not_be_an_input_or_output() {
    let dir = folder_with_models(1);
    dir.write("reference.csv", model_bytes(0));
    dir.run("transfer lib --from reference.csv -d out --summary reference.csv --force")
        .usage_error()
        .wrote_nothing()
        .says(&["reference.csv"]);
    dir.run("lib/even/model00.osim --target-mass 500 -o x.csv --summary x.csv --force")
        .usage_error()
        .wrote_nothing()
        .says(&["x.csv"]);
    dir.run("lib --target-mass 500 -d out --summary done.txt")
        .usage_error()
        .wrote_nothing()
        .says(&[".csv or .ndjson"]);
}

#[test]
fn an_output_may_be_replaced_after_a_run_in_which_its_model_failed() {
    let dir = finished_run();
    let good = dir.read("lib/odd/model03.osim");
    dir.write("lib/odd/model03.osim", &good[..good.len() / 2]);
    let at = |mass: &str| format!("lib --target-mass {mass} -d out --summary done.csv --resume");
    dir.run(&at("600")).failed().says(&["4 written", "1 failed"]);
    dir.write("lib/odd/model03.osim", &good);
    dir.run(&at("700")).succeeded().says(&["5 models: 5 written"]);
    let undisturbed = folder_with_models(5);
    undisturbed.run("lib --target-mass 700 -d out --summary done.csv").succeeded();
    assert!(dir.files() == undisturbed.files());
}

#[test]
fn rows_of_a_manifest_may_change_their_order() {
    let dir = folder_with_models(2);
    let rows = "lib/model00.osim,a.osim\nlib/model02.osim,b.osim\n";
    let files = dir.files();
    let names: Vec<&String> = files.keys().filter(|name| name.ends_with(".osim")).collect();
    let rows = rows.replace("lib/model00.osim", names[0]).replace("lib/model02.osim", names[1]);
    dir.write("m.csv", format!("model,output,target-mass\n{}", rows.replace(".osim\n", ".osim,500\n")));
    dir.run("batch m.csv --summary done.csv").succeeded().says(&["2 written"]);
    let new_summary = format!("{},c.osim,500\n", names[0]);
    dir.write(
        "m.csv",
        format!("model,output,target-mass\n{new_summary}{}", rows.replace(".osim\n", ".osim,500\n")),
    );
    dir.run("batch m.csv --summary done.csv --resume").succeeded().says(&["1 written", "2 done before"]);
    let summary = dir.text("done.csv");
    let rows: Vec<&str> = summary.lines().skip(1).map(|line| line.split(',').next().unwrap()).collect();
    assert_eq!(rows, ["2", "3", "4"]);
}

/// A model is recognised if its path, its output or the folder of the call is spelled in another way.
#[test]
fn models_done_before_are_found_by_any_path_and_from_any_folder() {
    let dir = finished_run();
    let root = dir.path("").display().to_string();
    let root = root.trim_end_matches('/');
    for (input, output) in [
        ("./lib", "./out"),
        ("lib/../lib", "lib/../out"),
        (&format!("{root}/lib") as &str, "out"),
        ("lib", &format!("{root}/out") as &str),
    ] {
        let call = format!("{input} --target-mass 500 -d {output} --summary done.csv --resume");
        dir.run(&call).succeeded().says(&["5 models: 5 done before"]);
    }
    let outside = dir.path("elsewhere");
    std::fs::create_dir(&outside).unwrap();
    let call = "../lib --target-mass 500 -d ../out --summary ../done.csv --resume";
    let run = dir.command(call).current_dir(&outside).output().unwrap();
    let text = String::from_utf8_lossy(&run.stderr).into_owned();
    assert!(run.status.success() && text.contains("5 done before"), "{text}");
    resume_run(&dir).succeeded().says(&["5 done before"]);
}

#[cfg(unix)]
#[test]
fn a_factor_in_place_is_applied_once_for_any_spelling_of_the_path() {
    let dir = folder_with_models(3);
    let call = |folder: &str, more: &str| {
        format!("set {folder} stiffness=x2 --no-note --no-backup --in-place --summary s.csv{more}")
    };
    dir.run(&call("lib", "")).succeeded();
    std::os::unix::fs::symlink(dir.path("lib"), dir.path("link")).unwrap();
    let files_before = crate::model_folder::files_below(&dir.files(), "lib/");
    for folder in ["./lib", "link", "lib/odd/../../lib"] {
        dir.run(&call(folder, " --resume")).succeeded().says(&["3 done before"]);
        assert!(crate::model_folder::files_below(&dir.files(), "lib/") == files_before, "{folder}");
    }
}

/// A resumed run over fewer models keeps the summary lines of the other models.
#[test]
fn summary_lines_of_models_outside_the_run_stay() {
    let dir = finished_run();
    let before = dir.text("done.csv");
    let lines = |text: &str| {
        let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
        lines.sort();
        lines
    };
    let part = "lib/even --target-mass 500 -d out/even --summary done.csv --resume";
    dir.run(part).succeeded().says(&["3 models: 3 done before"]);
    assert_eq!(lines(&dir.text("done.csv")), lines(&before));
    // The summary does not have this output: the run fails, and all lines stay.
    dir.write("new/model02.osim", "my work");
    dir.run("lib/even/model02.osim --target-mass 500 -d new --summary done.csv --resume").failed();
    let text = dir.text("done.csv");
    assert!(lines(&before)[..5].iter().all(|line| text.contains(line.as_str())), "{text}");
    resume_run(&dir).succeeded().wrote(&["done.csv"]).says(&["5 done before"]);
}

#[test]
fn another_share_keeps_the_lines_of_the_summary() {
    let dir = folder_with_models(6);
    let call = |share: &str| format!("lib --target-mass 500 -d out --shard {share} --summary s1.csv");
    dir.run(&call("1/2")).succeeded();
    let lines_of_first_share: Vec<String> = dir.text("s1.csv").lines().skip(1).map(str::to_owned).collect();
    assert!(!lines_of_first_share.is_empty() && lines_of_first_share.len() < 6, "{lines_of_first_share:?}");
    dir.run(&format!("{} --resume", call("2/2"))).succeeded();
    let text = dir.text("s1.csv");
    assert_eq!(text.lines().count(), 7, "{text}");
    assert!(lines_of_first_share.iter().all(|line| text.contains(line.as_str())), "{text}");
    let before = format!("{} done before", lines_of_first_share.len());
    dir.run(&format!("{} --resume", call("1/2"))).succeeded().says(&[&before]);
}

/// Rows are removed, restored and swapped, with the user's columns.
#[test]
fn rows_of_a_manifest_may_be_removed_restored_and_swapped() {
    for summary in ["done.csv", "done.ndjson"] {
        let dir = TestDir::with(&[
            ("table1/human_62kg_smooth_sphere.osim", "a.osim"),
            ("table1/human_62kg_hunt_crossley.osim", "b.osim"),
        ]);
        let call = format!("batch m.csv --summary {summary}");
        let table = |rows: &str| dir.write("m.csv", format!("#who,model,output,target-mass\n{rows}"));
        table("me,a.osim,o/x.osim,70\nyou,b.osim,o/y.osim,70\n");
        dir.run(&call).succeeded().says(&["2 written"]);
        table("me,a.osim,o/x.osim,70\n");
        dir.run(&format!("{call} --resume")).succeeded();
        assert!(dir.text(summary).contains("you"), "{summary}");
        table("me,a.osim,o/x.osim,70\nyou,b.osim,o/y.osim,70\n");
        dir.run(&format!("{call} --resume")).succeeded().wrote(&[summary]).says(&["2 done before"]);
        table("me,a.osim,o/y.osim,70\nyou,b.osim,o/x.osim,70\n");
        dir.run(&format!("{call} --resume")).succeeded().says(&["2 written"]);
        dir.run(&format!("{call} --resume")).succeeded().says(&["2 done before"]);
        let undisturbed = TestDir::with(&[("table1/human_62kg_smooth_sphere.osim", "a.osim")]);
        undisturbed.run("a.osim --target-mass 70 -o y.osim").succeeded();
        assert_eq!(dir.read("o/y.osim"), undisturbed.read("y.osim"));
    }
}

/// A second factor would multiply the result of the first factor.
#[test]
fn another_factor_in_place_is_refused() {
    let dir = TestDir::with(&[("table1/human_62kg_smooth_sphere.osim", "a.osim")]);
    let table = |factor: &str| dir.write("m.csv", format!("model,verb,set\na.osim,set,stiffness={factor}\n"));
    let call = "batch m.csv --in-place --summary done.csv";
    table("x2");
    dir.run(call).succeeded();
    let (twice, backup) = (dir.read("a.osim"), dir.read("a.osim.bak"));
    table("x3");
    for _ in 0..2 {
        dir.run(&format!("{call} --resume")).failed().says(&["an earlier run changed this model", "--force"]);
        assert_eq!(dir.read("a.osim"), twice);
    }
    // The first factor again: the summary still has its line.
    table("x2");
    dir.run(&format!("{call} --resume")).succeeded();
    table("x3");
    dir.write("a.osim", backup);
    dir.run(&format!("{call} --resume")).succeeded();
    let text = dir.text("a.osim");
    // The fixture's stiffness is 1e6 N/m2.
    assert!(text.contains("<stiffness>3000000</stiffness>"), "{text}");
}
