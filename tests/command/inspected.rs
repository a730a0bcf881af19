//! `inspect` with several models: a row for each.

use serde_json::Value;

use crate::support::Bench;

fn library() -> Bench {
    Bench::with(&[
        ("table1/human_62kg_smooth_sphere.osim", "lib/human.osim"),
        ("table1/emu_10_spheres_hunt_crossley.osim", "lib/animals/emu.osim"),
        ("bad/no_contacts.osim", "lib/none.osim"),
        ("bad/truncated.osim", "lib/damaged.osim"),
    ])
}

/// The row of a model, by what its name ends in.
fn row<'t>(table: &'t str, name: &str) -> &'t str {
    table.lines().find(|line| line.contains(name)).unwrap_or_else(|| panic!("no {name} in\n{table}"))
}

#[test]
fn a_folder_is_a_row_for_each_model_and_counts_at_the_end() {
    let bench = library();
    let ran = bench.run("inspect lib").failed().wrote_nothing().looks_like("inspect_folder");
    let out = ran.out();
    // Paper, Table 1: an emu of 37.80 kg with n = 10 on each foot, E1* = 1.66 MPa, R = 0.015 m, x/R = 0.353.
    let emu: Vec<&str> = row(&out, "emu").split_ascii_whitespace().collect();
    for cell in ["37.8", "10", "20", "HuntCrossley", "1.66e6", "0.015", "0.353"] {
        assert!(emu.contains(&cell), "{cell}: {emu:?}");
    }
    assert!(row(&out, "damaged").ends_with("not read"), "{out}");
    assert!(out.ends_with(", 1 without contacts, 1 not read\n") && out.contains("4 models, "), "{out}");
    assert!(ran.err().contains("damaged.osim"), "{}", ran.err());
}

#[test]
fn findings_are_as_many_as_check_has() {
    let bench = library();
    let out = bench.run("inspect lib").failed().out();
    for (name, file) in [("human.osim", "lib/human.osim"), ("emu", "lib/animals/emu.osim")] {
        let found: Value =
            serde_json::from_str(&bench.run(&format!("check {file} --deny error --format json")).out())
                .unwrap();
        let words = ["error", "warning", "remark"];
        let counts = words.map(|severity| found["counts"][severity].as_u64().unwrap());
        let worst = counts.iter().position(|count| *count > 0).unwrap();
        let cell = format!("{} {}", counts[worst], words[worst]);
        assert!(row(&out, name).trim_end_matches('s').ends_with(&cell), "{cell}:\n{out}");
    }
}

#[test]
fn in_full_it_is_what_each_model_alone_is() {
    let bench = library();
    let full = bench.run("inspect lib/human.osim lib/animals/emu.osim --full").done().out();
    for model in ["lib/human.osim", "lib/animals/emu.osim"] {
        let alone = bench.run(&format!("inspect {model} --full")).done().out();
        assert!(full.contains(&alone), "{model}:\n{full}");
    }
    // A folder with one model is that model.
    let alone = bench.run("inspect lib/animals").done().out();
    assert_eq!(alone, bench.run("inspect lib/animals/emu.osim").done().out());
}
