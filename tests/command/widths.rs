//! Output on terminals of 60, 80 and 120 columns, and `check` with `fix`.

use crate::support::{HUMAN, TestDir, assert_snapshot};
use crate::terminal::terminal_output;

/// Calls whose outputs people read most.
const CALLS_MOST_READ: [(&str, &str); 16] = [
    ("good", "check good.osim"),
    ("scaled", "check scaled.osim --from generic.osim"),
    ("broken", "check broken.osim"),
    ("folder", "check subjects --from generic.osim"),
    ("rescale", "human.osim --target-mass 80 --dry-run"),
    ("transfer", "transfer scaled.osim --from generic.osim --follow-bodies --level --dry-run"),
    (
        "add",
        "add bones.osim --from falisse2022 --feet calcn_r,toes_r,calcn_l,toes_l --count 6 --pad 0.02 --dry-run",
    ),
    ("inspect", "inspect scaled.osim"),
    ("motion", "motion walker.osim walk.mot --plates plates.sto"),
    ("design", "design human.osim --indentation 0.16 --constant-indentation 0.05 --dry-run"),
    (
        "design_sheet",
        "design --mass 62 --spheres 6 --radius 0.032 --indentation 0.16 --restitution 0.8 --constant-indentation 0.05",
    ),
    ("drop_test", "drop-test falisse2022 --compare moco-2d-gait"),
    ("explain", "explain C.8 spheres-left-behind stiffness output"),
    ("fit", "fit heel_pad.csv --radius 0.03 --indentation-unit mm --time-column time --onset fit"),
    ("presets", "presets"),
    ("reproduce", "reproduce"),
];

fn folder_of_models() -> TestDir {
    TestDir::with(&[
        HUMAN,
        ("check/within_limits.osim", "good.osim"),
        ("check/floats.osim", "broken.osim"),
        ("scale_tool/generic_smooth.osim", "generic.osim"),
        ("scale_tool/scaled_smooth.osim", "scaled.osim"),
        ("scale_tool/scaled_smooth.osim", "subjects/subject01.osim"),
        ("scale_tool/scaled_smooth.osim", "subjects/subject02.osim"),
        ("bad/no_contacts.osim", "subjects/bones.osim"),
        ("feet/human_40000.osim", "bones.osim"),
        ("feet/Geometry/r_human_foot.vtp", "Geometry/r_human_foot.vtp"),
        ("feet/Geometry/r_human_toes.vtp", "Geometry/r_human_toes.vtp"),
        ("feet/Geometry/l_human_foot.vtp", "Geometry/l_human_foot.vtp"),
        ("feet/Geometry/l_human_toes.vtp", "Geometry/l_human_toes.vtp"),
        ("motion/walker.osim", "walker.osim"),
        ("motion/walk.mot", "walk.mot"),
        ("motion/plates.sto", "plates.sto"),
        ("measured/heel_pad.csv", "heel_pad.csv"),
    ])
}

#[test]
fn outputs_fit_terminals_of_60_80_and_120_columns() {
    let dir = folder_of_models();
    for (name, call) in CALLS_MOST_READ {
        let mut all = format!("$ osim-contact-scale {call}\n");
        for columns in [60, 80, 120] {
            let (out, _) = terminal_output(dir.command(call), columns);
            let text = out.lines().filter(|line| !line.starts_with("$ "));
            let longest = text.map(|line| line.chars().count()).max().unwrap_or_default();
            all.push_str(&format!("----- {columns} columns\n{out}"));
            assert!(
                !out.is_empty() && longest <= usize::from(columns),
                "{name} at {columns}: {longest}\n{out}"
            );
        }
        assert_snapshot(&format!("width_{name}"), &all);
    }
    let (topics, _) = terminal_output(dir.command("explain"), 60);
    assert!(
        topics.lines().count() > 200 && topics.lines().all(|line| line.chars().count() <= 62),
        "{topics}"
    );
}

/// Only names that are longer than a line are cut, and they stay different.
#[test]
fn at_60_columns_numbers_and_codes_of_a_folder_are_whole() {
    let names = [1, 2].map(|number| format!("s/{}_{number}.osim", "a".repeat(60)));
    let dir = TestDir::with(&[
        ("scale_tool/scaled_smooth.osim", names[0].as_str()),
        ("check/floats.osim", names[1].as_str()),
    ]);
    let (out, _) = terminal_output(dir.command("check s"), 60);
    let (before, after) = ("a".repeat(25), "a".repeat(19));
    let [one, two] = [1, 2].map(|number| format!("        {before}~{after}_{number}.osim"));
    let table = format!(
        "\
models  finding                              worst
     1  error    floats
{two}
     1  warning  large-constant-indentation
{two}
     1  warning  force-before-contact
{two}
     1  warning  contacts-of-another-mass
        62 for 52 kg,
{one}
     1  remark   not-on-floor
{one}
     1  remark   spheres-not-compared
{one}
"
    );
    assert!(out.contains(&table), "{out}");
}

#[test]
fn fix_does_what_check_prints_and_ends_with_the_status_of_the_result() {
    let dir = folder_of_models();
    let printed = dir.run("check scaled.osim --from generic.osim").failed().out();
    let command = printed.lines().find_map(|line| line.strip_prefix("$ osim-contact-scale ")).unwrap();
    dir.run(&format!("{command} -o by_command.osim")).succeeded();
    let fix = "check scaled.osim --from generic.osim --fix -o fixed.osim";
    let said = ["fixed.osim: ", "written: fixed.osim; before: 1 error, 1 warning; 1 command done"];
    dir.run(fix).succeeded().wrote(&["fixed.osim"]).says(&said);
    assert_eq!(dir.text("fixed.osim"), dir.text("by_command.osim"));
    // What exists stays.
    dir.run(fix).failed().wrote_nothing().says(&["exists already"]);
    // Several steps, one after the other.
    dir.run("check broken.osim --fix -o whole.osim").succeeded().wrote(&["whole.osim"]);
    assert!(dir.run("check whole.osim --deny warning").succeeded().out().contains("whole.osim: "));
    // A model that is named itself is without contacts, too.
    dir.run("check bones.osim good.osim").says(&["1 without contacts: bones.osim"]);
    // A folder: the command that `check` prints for it.
    let folder = dir.run("check subjects --from generic.osim").failed().out();
    assert_eq!(folder.lines().filter(|line| line.starts_with("$ ")).count(), 1, "{folder}");
    let fix = "check subjects --from generic.osim --fix -d results";
    dir.run(fix)
        .succeeded()
        .wrote(&["results/subject01.osim", "results/subject02.osim"])
        .says(&["2 of 2 models changed and written into results"]);
    // A second time it is one line, as in other runs.
    let refused = dir.run(fix).usage_error().wrote_nothing();
    assert_eq!(refused.err().lines().count(), 1, "{}", refused.err());
    refused.says(&["2 of 3 results exist already", "(--force)", "another folder with -d"]);
    assert_eq!(dir.text("results/subject02.osim"), dir.text("fixed.osim"));
}

#[test]
fn fix_without_a_command_or_with_a_wrong_call_writes_nothing() {
    let dir = folder_of_models();
    dir.run("check good.osim --fix -o new.osim").succeeded().wrote_nothing().says(&["nothing to correct"]);
    dir.run_with_stdin("check - --fix -o new.osim", &dir.read("broken.osim"))
        .failed()
        .wrote_nothing()
        .says(&["nothing written: standard input is read only once: name a file"]);
    dir.run("check good.osim -o new.osim").usage_error().says(&["-o needs --fix"]);
    let several = dir.run("check good.osim broken.osim --fix -o new.osim").usage_error().wrote_nothing();
    several.says(&["-o names one file", "name a folder with -d DIR"]);
    dir.run("check good.osim human.osim --fix -d new")
        .succeeded()
        .says(&["0 of 2 models changed and written"]);
    let text = dir.text("scaled.osim");
    dir.run("check scaled.osim --from generic.osim --fix --in-place").succeeded();
    assert!(dir.text("scaled.osim") != text && dir.text("scaled.osim.bak") == text);
}
