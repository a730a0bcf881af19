//! `check`: what it prints, its exit status, and what it says of published models.

use std::collections::BTreeSet;

use crate::check::check_report;
use crate::support::{HUMAN, TestDir, corpus_folder, fixture};

#[test]
fn the_exit_status_is_that_of_the_worst_finding() {
    let dir_with = |fixture: &str| TestDir::with(&[(fixture, "model.osim")]);
    let (remark, warning, error) = (
        dir_with("check/beyond_hertz_at_two.osim"),
        dir_with("check/wide_transition.osim"),
        dir_with("check/floats.osim"),
    );
    dir_with("check/within_limits.osim").run("check model.osim --deny warning").succeeded();
    remark.run("check model.osim --deny warning").succeeded();
    warning.run("check model.osim").succeeded();
    warning.run("check model.osim --deny warning").failed();
    error.run("check model.osim").failed();
    error.run("check model.osim --deny sometimes").usage_error();
}

#[test]
fn check_prints_tables_json_and_csv() {
    let dir = TestDir::with(&[
        HUMAN,
        ("check/within_limits.osim", "lib/good.osim"),
        ("check/floats.osim", "lib/floats.osim"),
        ("check/wide_transition.osim", "lib/wide.osim"),
        ("bad/no_contacts.osim", "lib/bones.osim"),
        ("bad/not_xml.osim", "lib/broken.osim"),
    ]);
    dir.run("check human.osim").succeeded().wrote_nothing().matches_snapshot("check");
    dir.run("check human.osim --format json").succeeded().matches_snapshot("check_json");
    dir.run("check lib").failed().wrote_nothing().matches_snapshot("check_folder");
    dir.run("check lib --format csv").failed().matches_snapshot("check_csv");
    dir.run("check lib --format json").failed().matches_snapshot("check_folder_json");
    dir.run("check lib/good.osim --deny warning").succeeded().matches_snapshot("check_good");
    dir.run("check lib/bones.osim").succeeded().matches_snapshot("check_no_contacts");
}

#[test]
fn a_folder_names_the_model_with_the_largest_fault() {
    let dir = TestDir::with(&[HUMAN, ("check/within_limits.osim", "level.osim")]);
    for (name, times) in [("a", "1.5"), ("b", "5"), ("c", "2")] {
        let call = format!("set human.osim stiffness=x{times} --select *_l --no-note -o {name}.osim");
        dir.run(&call).succeeded();
    }
    let (level, human) = (dir.text("level.osim"), dir.text("human.osim"));
    for (name, floor) in [("d", "0 -0.1 0"), ("e", "0 -1 0"), ("f", "0 -0.5 0")] {
        dir.write(&format!("{name}.osim"), level.replacen("0 -0.05 0", floor, 1));
    }
    for (name, radius) in [("g", "32"), ("h", "320")] {
        dir.write(&format!("{name}.osim"), human.replacen("0.032000000000000001<", &format!("{radius}<"), 1));
    }
    let out = dir.run("check a.osim b.osim c.osim d.osim e.osim f.osim g.osim h.osim").failed().out();
    for (code, worst) in [("left-right-differ", "b"), ("not-on-floor", "h"), ("odd-radius", "h")] {
        let row = out.lines().find(|line| line.split_ascii_whitespace().nth(2) == Some(code));
        assert!(row.is_some_and(|row| row.ends_with(&format!("  {worst}.osim"))), "{code}: {out}");
    }
    let heights = dir.run("check d.osim e.osim f.osim").succeeded().out();
    assert!(heights.contains("     3  remark   not-on-floor  e.osim\n"), "{heights}");
}

#[test]
fn a_scaled_model_beside_its_original_is_asked_for_it() {
    let dir = TestDir::with(&[
        ("scale_tool/scaled_smooth.osim", "scaled.osim"),
        ("scale_tool/generic_smooth.osim", "generic.osim"),
    ]);
    let next = "What to do: osim-contact-scale check MODEL --from GENERIC compares";
    dir.run("check scaled.osim generic.osim").succeeded().says(&["spheres-not-compared", next]);
    dir.run("check scaled.osim generic.osim --from generic.osim").failed().says_not(&[next]);
    dir.run("check .").says(&["osim-contact-scale check . --from GENERIC compares each"]);
}

#[test]
fn calls_in_texts_name_the_files_of_this_check() {
    let dir = TestDir::with(&[
        ("scale_tool/scaled_smooth.osim", "scaled model.osim"),
        ("follows_size/generic.osim", "generic.osim"),
        ("check/spheres_misplaced.osim", "other.osim"),
    ]);
    let alone = dir.run("check \"scaled model.osim\" --format json").succeeded();
    // In JSON, a quotation mark has a backslash.
    let name = r#"\"scaled model.osim\""#;
    let compared = format!("seen here: check {name} --from GENERIC compares with the model that was scaled");
    let advice = format!("model that was scaled: check {name} --from GENERIC\"");
    alone.says(&[&compared, &advice, &format!("the value that inspect {name} says")]).says_not(&["MODEL"]);
    let named = "check other.osim --from generic.osim says where each belongs";
    let compared = dir.run("check other.osim --from generic.osim --format json").failed();
    compared.says(&[named]).says_not(&["MODEL"]);
    dir.run("explain spheres-misplaced --format json").says(&["check MODEL --from ORIGINAL says where"]);
}

/// How far a sphere is from its place is known in millimetres only where the original can be compared.
#[test]
fn the_worst_model_of_a_folder_is_chosen_among_sizes_of_one_unit() {
    let dir = TestDir::with(&[
        ("follows_size/generic.osim", "generic.osim"),
        ("follows_size/scaled.osim", "scaled.osim"),
        ("check/spheres_misplaced.osim", "other.osim"),
    ]);
    dir.run("transfer scaled.osim --from generic.osim --follow-bodies --level -o right.osim").succeeded();
    let right = dir.text("right.osim");
    let moved = right.replacen("<location>-0.0068000000000000005 ", "<location>-0.0038 ", 1);
    assert_ne!(moved, right);
    dir.write("moved.osim", moved);
    for models in ["moved.osim other.osim", "other.osim moved.osim"] {
        let out = dir.run(&format!("check {models} --from generic.osim")).failed().out();
        assert!(out.contains("     2  warning  spheres-misplaced         3 mm, moved.osim\n"), "{out}");
    }
}

/// The commands in what `check` printed, without the name of the program.
fn printed_commands(out: &str) -> Vec<&str> {
    out.lines().filter_map(|line| line.strip_prefix("$ osim-contact-scale ")).collect()
}

#[test]
fn models_with_the_same_name_get_a_folder_of_results_each() {
    let dir = TestDir::with(&[("follows_size/generic.osim", "generic.osim")]);
    (1..=6).for_each(|number| dir.write(&format!("s{number}/m.osim"), fixture("follows_size/scaled.osim")));
    let run = dir.run("check s1 s2 --from generic.osim").failed().wrote_nothing();
    let out = run.says(&["2 models, all with errors; these commands put both right:\n$ "]).out();
    let options = "--from generic.osim --follow-bodies --level -d";
    let expected = [1, 2].map(|number| format!("transfer s{number} {options} RESULTS-{number}"));
    assert_eq!(printed_commands(&out), expected);
    for (number, command) in (1..).zip(&expected) {
        dir.run(command).succeeded().wrote(&[&format!("RESULTS-{number}/m.osim")]);
    }
    // The next call finds other names.
    let out = dir.run("check s1/m.osim s2/m.osim --from generic.osim").out();
    let expected = [1, 2].map(|number| format!("transfer s{number}/m.osim {options} RESULTS-{}", number + 2));
    assert_eq!(printed_commands(&out), expected);
    // There would be too many commands.
    dir.run("check s1 s2 s3 s4 s5 s6 --from generic.osim")
        .says(&["6 models, all with errors\n", "What to do: rename models, or check fewer at a time"])
        .says_not(&["RESULTS"]);
}

#[test]
fn a_fix_of_models_with_the_same_name_is_refused_as_any_change() {
    let dir = TestDir::with(&[
        ("follows_size/generic.osim", "generic.osim"),
        ("follows_size/scaled.osim", "s1/m.osim"),
        ("follows_size/scaled.osim", "s2/m.osim"),
    ]);
    for (verb, fix) in [("check", " --fix"), ("transfer", "")] {
        let call = format!("{verb} s1 s2 --from generic.osim{fix} -d same");
        let run = dir.run(&call).usage_error().wrote_nothing();
        let refused = "error: s1/m.osim and s2/m.osim would both be written to same/m.osim";
        assert_eq!(run.err(), format!("{refused}: give them different names or folders\n"));
    }
    // Beside the models there is room for all.
    let beside = ["s1/m.scaled.osim", "s2/m.scaled.osim"];
    dir.run("check s1 s2 --from generic.osim --fix").succeeded().wrote(&beside);
}

#[test]
fn a_proposed_folder_of_results_is_new() {
    let dir = TestDir::with(&[
        ("follows_size/generic.osim", "generic.osim"),
        ("follows_size/scaled.osim", "lib/a.osim"),
        ("follows_size/scaled.osim", "lib/b.osim"),
    ]);
    for folder in ["RESULTS", "RESULTS-1"] {
        let out = dir.run("check lib --from generic.osim").failed().out();
        let expected = format!("transfer lib --from generic.osim --follow-bodies --level -d {folder}");
        assert_eq!(printed_commands(&out), [expected.as_str()]);
        dir.run(&expected).succeeded().wrote(&[&format!("{folder}/a.osim"), &format!("{folder}/b.osim")]);
    }
}

#[test]
fn tables_fit_80_columns() {
    for fixture in ["check/floats.osim", "format/mixed_radii.osim", "format/terrain_welded.osim"] {
        let dir = TestDir::with(&[(fixture, "model.osim"), ("check/within_limits.osim", "other.osim")]);
        for arguments in ["check model.osim", "check model.osim other.osim"] {
            let text = dir.run(arguments).out();
            assert!(!text.contains('\u{1b}'));
            for line in text.lines().filter(|line| !line.starts_with("$ ")) {
                assert!(line.chars().count() <= 80, "{line}");
            }
        }
    }
}

#[test]
fn published_models_have_the_documented_findings() {
    let Some(folder) = corpus_folder("published_models_have_the_documented_findings") else { return };
    let report_of = |model: &str| {
        let dir = TestDir::new();
        dir.write("model.osim", std::fs::read(folder.join(format!("{model}.osim"))).unwrap());
        check_report(&dir, "model.osim")
            .findings
            .into_iter()
            .map(|finding| finding.code)
            .collect::<BTreeSet<_>>()
    };
    // Falisse's smoothing "does not have the issue" of the paper's Fig. C.5; its indentation and damping are beyond both laws.
    assert_eq!(
        report_of("v40000_falisse_2022_human"),
        BTreeSet::from(
            ["beyond-hertz", "beyond-hunt-crossley", "known-contacts", "not-on-floor"].map(String::from)
        )
    );
    // The same contacts under 78 kg.
    assert!(report_of("v40000_opencap_lai_arnold_crlf").contains("contacts-of-another-mass"));
    let dhondt = report_of("v40000_dhondt_2024_3seg_human");
    assert!(dhondt.contains("force-before-contact") && dhondt.contains("large-constant-indentation"));
    assert!(report_of("v40000_moco_2d_gait").contains("dead-derivative-smoothing"));
    // None of them has a warning, and `check` says so in one line.
    for model in [
        "v40000_falisse_2022_human",
        "v40000_dhondt_2024_3seg_human",
        "v40000_human_12_hunt_crossley",
        "v40000_opencap_lai_arnold_crlf",
        "v40000_moco_2d_gait",
        "v30000_osim_rl_gait9dof18musc_crlf",
        "v30000_scone_h0914m",
        "v40000_scone_h0914m",
        "v40000_toy_landing",
        "v20302_dynamic_jumper",
        "v40000_dynamic_jumper",
        "v20001_bouncing_ball_hunt_crossley",
        "v40000_bouncing_ball_smooth",
        "v30000_bouncing_block",
        "v20303_bouncing_block",
    ] {
        let dir = TestDir::new();
        dir.write("m.osim", std::fs::read(folder.join(format!("{model}.osim"))).unwrap());
        let out = dir.run("check m.osim --deny warning").succeeded().out();
        // What the published contacts have is in no row of its own; a pose, a mass or a floor of this model is.
        let start = out.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(start.contains("; the contact parameters are those of"), "{model}: {out}");
        let is_good = start.starts_with("m.osim: nothing is wrong;");
        let is_bad = |line: &str| ["error ", "warning "].iter().any(|sign| line.starts_with(sign));
        assert!(!out.lines().any(is_bad), "{model}: {out}");
        assert_eq!(is_good, !out.lines().any(|line| line.starts_with("remark ")), "{model}: {out}");
    }
    let landing = report_of("v40000_toy_landing");
    assert!(landing.contains("mixed-radii") && !landing.contains("beyond-hertz"));
    let dir = TestDir::new();
    dir.write("m.osim", std::fs::read(folder.join("v40000_toy_landing.osim")).unwrap());
    let out = dir.run("check m.osim").succeeded().out();
    let words = out.split_whitespace().collect::<Vec<_>>().join(" ");
    for code in ["mixed-radii", "several-spheres-one-force"] {
        assert!(words.contains(&format!("(and 1 more), as published [{code}]")), "{out}");
    }
}

/// D'Hondt's forefoot is in 0.2392 R deep under two body weights, in the publication, too, but not under 20 % more.
#[test]
fn a_published_depth_at_two_body_weights_is_as_published() {
    let Some(folder) = corpus_folder("a_published_depth_at_two_body_weights_is_as_published") else { return };
    let dir = TestDir::new();
    dir.write("model.osim", std::fs::read(folder.join("v40000_dhondt_2024_3seg_human.osim")).unwrap());
    let run = dir.run("check model.osim").succeeded();
    run.says(&["floor, sides, sizes; mass, solver as published"]).says_not(&["beyond-hertz-at-two"]);
    let full = dir.run("check model.osim --full").succeeded();
    full.says(&["good     mass     as published: ", "remark beyond-hertz-at-two"]);
    dir.run("check model.osim --mass 74.4").says(&["beyond-hertz-at-two", "solver as published"]);
}

#[test]
fn a_finding_without_a_command_leads_to_its_explanation() {
    let dir = TestDir::new();
    dir.write("model.osim", fixture("check/doubled_spheres.osim"));
    let run = dir.run("check model.osim").failed();
    assert!(
        run.out().ends_with("\n\nWhat to do: osim-contact-scale explain doubled-spheres\n"),
        "{}",
        run.out()
    );
}
