//! `inspect` with several models prints a row for each model.

use serde_json::Value;

use crate::support::TestDir;

fn folder_of_models() -> TestDir {
    TestDir::with(&[
        ("table1/human_62kg_smooth_sphere.osim", "lib/human.osim"),
        ("table1/emu_10_spheres_hunt_crossley.osim", "lib/animals/emu.osim"),
        ("bad/no_contacts.osim", "lib/none.osim"),
        ("bad/truncated.osim", "lib/damaged.osim"),
    ])
}

/// The row of `table` that contains `name`.
fn row_of<'t>(table: &'t str, name: &str) -> &'t str {
    table.lines().find(|line| line.contains(name)).unwrap_or_else(|| panic!("no {name} in\n{table}"))
}

#[test]
fn inspect_prints_a_row_for_each_model_and_counts() {
    let dir = folder_of_models();
    let run = dir.run("inspect lib").failed().wrote_nothing().matches_snapshot("inspect_folder");
    let out = run.out();
    // Paper, Table 1: an emu of 37.80 kg with n = 10 on each foot, E1* = 1.66 MPa, R = 0.015 m, x/R = 0.353.
    let emu: Vec<&str> = row_of(&out, "emu").split_ascii_whitespace().collect();
    for cell in ["37.8", "10", "20", "HuntCrossley", "1.66e6", "0.015", "0.353"] {
        assert!(emu.contains(&cell), "{cell}: {emu:?}");
    }
    assert!(row_of(&out, "damaged").ends_with("not read"), "{out}");
    assert!(out.ends_with(", 1 without contacts, 1 not read\n") && out.contains("4 models, "), "{out}");
    assert!(run.err().contains("damaged.osim"), "{}", run.err());
}

#[test]
fn the_row_counts_findings_as_check_does() {
    let dir = folder_of_models();
    let out = dir.run("inspect lib").failed().out();
    for (name, file) in [("human.osim", "lib/human.osim"), ("emu", "lib/animals/emu.osim")] {
        let check: Value =
            serde_json::from_str(&dir.run(&format!("check {file} --deny error --format json")).out())
                .unwrap();
        let words = ["error", "warning", "remark"];
        let counts = words.map(|severity| check["counts"][severity].as_u64().unwrap());
        let worst = counts.iter().position(|count| *count > 0).unwrap();
        let cell = format!("{} {}", counts[worst], words[worst]);
        assert!(row_of(&out, name).trim_end_matches('s').ends_with(&cell), "{cell}:\n{out}");
    }
}

#[test]
fn full_output_of_a_folder_has_the_output_of_each_model() {
    let dir = folder_of_models();
    let full = dir.run("inspect lib/human.osim lib/animals/emu.osim --full").succeeded().out();
    for model in ["lib/human.osim", "lib/animals/emu.osim"] {
        let alone = dir.run(&format!("inspect {model} --full")).succeeded().out();
        assert!(full.contains(&alone), "{model}:\n{full}");
    }
    // A folder with one model is that model.
    let alone = dir.run("inspect lib/animals").succeeded().out();
    assert_eq!(alone, dir.run("inspect lib/animals/emu.osim").succeeded().out());
}
