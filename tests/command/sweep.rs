//! `sweep`: grids and ladders of variants, and their manifests.

use std::collections::BTreeMap;

use serde_json::Value;

use crate::support::{TestDir, fixture};

const EMU_MODEL: (&str, &str) = ("table1/emu_10_spheres_smooth_sphere.osim", "emu.osim");

/// Rows of a manifest, as column to cell.
fn manifest_rows(dir: &TestDir, name: &str) -> Vec<BTreeMap<String, String>> {
    let bytes = dir.read(name);
    let mut reader = csv::Reader::from_reader(bytes.as_slice());
    reader.deserialize().collect::<Result<_, _>>().unwrap()
}

/// A value that all forces (or spheres) of a model have.
fn common_value(dir: &TestDir, model: &str, property: &str) -> f64 {
    let inspection: Value =
        serde_json::from_str(&dir.run(&format!("inspect {model} --format json")).succeeded().out()).unwrap();
    let values: Vec<f64> = if property == "radius" {
        inspection["spheres"]
            .as_array()
            .unwrap()
            .iter()
            .map(|sphere| sphere["radius_m"].as_f64().unwrap())
            .collect()
    } else {
        let forces = inspection["forces"].as_array().unwrap().iter();
        forces.map(|force| force["parameters"][property].as_f64().unwrap()).collect()
    };
    assert!(values.iter().all(|value| *value == values[0]), "{values:?}");
    values[0]
}

#[test]
fn a_grid_has_one_file_per_point_and_the_manifest_lists_its_values() {
    let dir = TestDir::with(&[EMU_MODEL]);
    let run = dir.run("sweep emu.osim --grid stiffness=x0.1,x1,x10 --grid dissipation=0.5,1,2").succeeded();
    assert_eq!(run.changed.len(), 10);
    let rows = manifest_rows(&dir, "emu.sweep/emu_sweep.csv");
    assert_eq!(rows.len(), 9);
    let stiffness_before = common_value(&dir, "emu.osim", "stiffness");
    for row in &rows {
        let file = format!("emu.sweep/{}", row["file"]);
        for property in ["radius", "stiffness", "dissipation", "constant_contact_force", "hertz_smoothing"] {
            assert_eq!(row[property].parse::<f64>().unwrap(), common_value(&dir, &file, property), "{file}");
        }
        let factor: f64 = row["grid_stiffness"].trim_start_matches('x').parse().unwrap();
        assert_eq!(row["stiffness"].parse::<f64>().unwrap(), stiffness_before * factor, "{file}");
        assert_eq!(row["dissipation"], row["grid_dissipation"], "{file}");
        let point =
            format!("by sweep stiffness={} dissipation={};", row["grid_stiffness"], row["grid_dissipation"]);
        assert!(dir.text(&file).contains(&point), "{file}");
    }
    // The point x1 with the model's own α changes nothing but the note.
    let own_value = common_value(&dir, "emu.osim", "dissipation");
    dir.run(&format!("sweep emu.osim --grid stiffness=x1 --grid dissipation={own_value} -d own --no-note"))
        .succeeded();
    let file = format!("own/emu_1_stiffness-x1_dissipation-{own_value}.osim");
    assert_eq!(dir.read(&file), fixture(EMU_MODEL.0));
}

#[test]
fn a_grid_of_indentations_equals_a_design_for_each() {
    let dir = TestDir::with(&[EMU_MODEL]);
    dir.run("sweep emu.osim --grid indentation=0.05,0.16 --grid restitution=0.8,0.9 -d out --no-note")
        .succeeded();
    for (index, x, restitution) in
        [(1, "0.05", "0.8"), (2, "0.05", "0.9"), (3, "0.16", "0.8"), (4, "0.16", "0.9")]
    {
        let design = format!(
            "design emu.osim --indentation {x} --restitution {restitution} --no-note -o one.osim --force"
        );
        dir.run(&design).succeeded();
        let file = format!("out/emu_{index}_indentation-{x}_restitution-{restitution}.osim");
        assert_eq!(dir.read(&file), dir.read("one.osim"), "{file}");
    }
    for row in manifest_rows(&dir, "out/emu_sweep.csv") {
        let (wanted, computed) =
            (row["grid_indentation"].parse::<f64>(), row["relative_indentation_hertz"].parse::<f64>());
        assert!((computed.unwrap() / wanted.unwrap() - 1.0).abs() < 1e-14);
    }
}

#[test]
fn a_grid_may_combine_masses_properties_and_designs() {
    let dir = TestDir::with(&[EMU_MODEL]);
    dir.run("sweep emu.osim --grid target-mass=5,500 --no-note -d out").succeeded();
    dir.run("emu.osim --target-mass 500 --no-note -o one.osim").succeeded();
    assert_eq!(dir.read("out/emu_2_target-mass-500.osim"), dir.read("one.osim"));
    let of_grid: Vec<String> =
        manifest_rows(&dir, "out/emu_sweep.csv").iter().map(|row| row["grid_target_mass"].clone()).collect();
    assert_eq!(of_grid, ["5", "500"]);
    // Similar contacts have equal relative indentations under the weight that they are made for.
    let computed: Vec<f64> = manifest_rows(&dir, "out/emu_sweep.csv")
        .iter()
        .map(|row| row["relative_indentation_hertz"].parse().unwrap())
        .collect();
    assert!((computed[0] / computed[1] - 1.0).abs() < 1e-12, "{computed:?}");
    dir.run("sweep emu.osim --grid radius=x2 --grid indentation=0.16 -d mixed").succeeded();
    let row = &manifest_rows(&dir, "mixed/emu_sweep.csv")[0];
    assert_eq!(row["radius"], "0.03");
    assert!((row["relative_indentation_hertz"].parse::<f64>().unwrap() / 0.16 - 1.0).abs() < 1e-14);
}

/// Expected indentations are solutions of (C.9) without speed for a tenth of 37.8 kg * 9.81 m/s2, by bisection outside of this
/// project (mpmath), with sqrt(cf)/R at most 0.3 x/R and bd in proportion to its inverse. The second model has OpenSim's own smoothing.
#[test]
fn a_ladder_lists_indentations_by_both_laws() {
    let dir = TestDir::with(&[EMU_MODEL]);
    dir.run("set emu.osim constant_contact_force=1e-5 hertz_smoothing=300 hunt_crossley_smoothing=50 -o default.osim").succeeded();
    for (model, expected) in [
        ("emu", [1.246_087_627_370_075, 0.436_229_094_854_055_8, 0.152_895_455_875_332_97]),
        ("default", [1.232_106_890_389_454_3, 0.427_355_790_985_080_2, 0.152_895_455_875_332_97]),
    ] {
        let run = dir.run(&format!("sweep {model}.osim --ladder 3 --indentation 0.16 -d out"));
        run.succeeded().says(&["steps are equal in k R n/F by the Hertz law (B.3)"]);
        for (row, expected) in manifest_rows(&dir, &format!("out/{model}_ladder.csv")).iter().zip(expected) {
            let number = |column: &str| row[column].parse::<f64>().unwrap();
            assert!((number("relative_indentation_model_law") / expected - 1.0).abs() < 1e-8, "{row:?}");
            // (B.3) by the Hertz law: 3/(2 x/R).
            let hertz = 1.5 / number("wanted_dimensionless_stiffness");
            assert!((number("relative_indentation_hertz") / hertz - 1.0).abs() < 1e-8, "{row:?}");
        }
    }
}

/// (11) of the emu is 0.3533 at its own stiffness, and 100^(2/3) times that at a hundredth: a whole radius and more.
#[test]
fn new_faults_of_a_point_are_in_the_manifest_and_counted() {
    let dir = TestDir::with(&[EMU_MODEL]);
    let run = dir.run("sweep emu.osim --grid stiffness=x0.001,x0.01,x1 -d out").succeeded();
    run.says(&["2 of 3 models have errors or warnings that the original model does not have"]);
    let worse: Vec<String> =
        manifest_rows(&dir, "out/emu_sweep.csv").iter().map(|row| row["worse"].clone()).collect();
    assert_eq!(worse, ["sunk-in", "sunk-in", ""]);
}

/// Each kind of sphere is named after its first sphere. A class without smoothing has the indentation of the Hertz law.
#[test]
fn spheres_of_several_kinds_have_a_value_each() {
    let dir = TestDir::with(&[("format/mixed_radii.osim", "two.osim")]);
    dir.run("sweep two.osim --grid stiffness=x1,x2 -d out").succeeded();
    for row in manifest_rows(&dir, "out/two_sweep.csv") {
        let cell = &row["relative_indentation_hertz"];
        let names: Vec<&str> = cell.split(' ').filter_map(|one| Some(one.split_once('=')?.0)).collect();
        assert_eq!(names, ["heel_r", "toe_r"]);
        assert_eq!(&row["relative_indentation_model_law"], cell);
    }
}

#[test]
fn the_largest_counts_are_accepted_and_larger_ones_refused() {
    let dir = TestDir::with(&[EMU_MODEL]);
    let ladder = |steps: &str| format!("sweep emu.osim --ladder {steps} --indentation 0.16 --dry-run");
    dir.run(&ladder("100000")).succeeded().says(&["100000 models"]);
    for steps in ["1", "100001", "1e9", "1000000000", "99999999999999999999"] {
        dir.run(&ladder(steps)).usage_error().says(&["expected a whole number from 2 to 100000"]);
    }
    let grid = |count: u32| {
        let grid = format!("--grid stiffness=x0.1..x10/1000 --grid dissipation=1..2/{count}");
        format!("sweep emu.osim {grid} --yes many-models -d out")
    };
    dir.run(&format!("{} --point 1000000", grid(1000))).succeeded().says(&["point 1000000 of 1000000"]);
    dir.run(&format!("{} --point 1000001", grid(1000))).usage_error();
    dir.run(&grid(1001)).usage_error().says(&["1001000 models", "1,000,000, the most that one sweep makes"]);
    dir.run("sweep emu.osim --grid stiffness=x1 --jobs 4096 -d one").succeeded();
    dir.run("sweep emu.osim --grid stiffness=x1 --jobs 4097 -d one").usage_error().says(&["from 1 to 4096"]);
    dir.run("inspect emu.osim --spheres 1000000").succeeded();
    dir.run("inspect emu.osim --spheres 1000001").usage_error().says(&["from 1 to 1000000"]);
    dir.run("drop-test emu.osim --samples 1000000 --duration 0.01 --format json").succeeded();
    dir.run("drop-test emu.osim --samples 1000001").usage_error().says(&["from 2 to 1000000"]);
}

#[test]
fn a_ladder_goes_from_soft_to_the_designed_contact() {
    let dir = TestDir::with(&[EMU_MODEL]);
    let call = "sweep emu.osim --ladder 4 --indentation 0.16 --restitution 0.9 -d out";
    dir.run(call).succeeded().wrote(&[
        "out/emu_ladder-1-of-4.osim",
        "out/emu_ladder-2-of-4.osim",
        "out/emu_ladder-3-of-4.osim",
        "out/emu_ladder-4-of-4.osim",
        "out/emu_ladder.csv",
    ]);
    dir.run("design emu.osim --indentation 0.16 --restitution 0.9 -o end.osim").succeeded();
    let rows = manifest_rows(&dir, "out/emu_ladder.csv");
    let column = |name: &str| -> Vec<f64> { rows.iter().map(|row| row[name].parse().unwrap()).collect() };
    let (stiffness, dissipation, k) =
        (column("stiffness"), column("dissipation"), column("dimensionless_stiffness"));
    assert!(stiffness.is_sorted() && dissipation.is_sorted_by(|a, b| a > b), "{stiffness:?} {dissipation:?}");
    // The paper's softest contact; 9.375 is 3/(2 · 0.16), and the steps between are 7.8125^(1/3) apart (mpmath).
    for (computed, expected) in k.iter().zip([1.2, 2.381_101_577_952_3, 4.724_703_937_105_8, 9.375]) {
        assert!((computed / expected - 1.0).abs() < 1e-12, "{k:?}");
    }
    assert_eq!(dissipation[0], common_value(&dir, "emu.osim", "dissipation"));
    for property in ["stiffness", "dissipation", "radius"] {
        assert_eq!(rows[3][property].parse::<f64>().unwrap(), common_value(&dir, "end.osim", property));
    }
    assert!(dir.text("out/emu_ladder-2-of-4.osim").contains("by ladder step 2 of 4;"));
    // sqrt(cf)/R and bd R are 0.098821 and 9.6; in the last step 0.3 * 0.16, and 9.6 * 0.098821/0.048 (mpmath).
    let smoothing = [column("constant_contact_force"), column("hertz_smoothing")];
    for (computed, expected) in smoothing.iter().flat_map(|values| [values[0], values[3]]).zip([
        2.197_265_625e-6,
        5.184e-7,
        640.0,
        1_317.615_691_74,
    ]) {
        assert!((computed / expected - 1.0).abs() < 1e-8, "{computed} {expected}");
    }
    // The caller's own constant indentation stays.
    dir.run("sweep emu.osim --ladder 2 --indentation 0.16 --constant-indentation 0.1 -d own").succeeded();
    let cf = common_value(&dir, "own/emu_ladder-2-of-2.osim", "constant_contact_force");
    assert!((cf / 2.25e-6 - 1.0).abs() < 1e-12, "{cf}");
}

#[test]
fn a_sweep_reports_its_size_first_and_many_models_need_yes() {
    let dir = TestDir::with(&[EMU_MODEL]);
    let many = "sweep emu.osim --grid stiffness=x0.1..x10/101 --grid dissipation=0.1..10/100";
    dir.run(many).usage_error().wrote_nothing().says(&["more than 10,000", "--yes"]);
    dir.run("sweep emu.osim --grid stiffness=x0.1..x10/9 --dry-run")
        .succeeded()
        .wrote_nothing()
        .says(&["9 models of"]);
    let huge = "sweep emu.osim --grid stiffness=1e6..9e6/1000 --grid dissipation=1..9/1000 --grid radius=0.01..0.09/1000 --dry-run";
    dir.run(huge).succeeded().wrote_nothing().says(&["1000000000 models of"]);
    dir.run("sweep emu.osim --grid stiffness=x1,x2 -d out").succeeded().matches_snapshot("sweep");
    dir.run("sweep emu.osim --grid stiffness=x1,x2 -d out")
        .usage_error()
        .wrote_nothing()
        .says(&["3 of these files exist"]);
    dir.run("sweep emu.osim --grid stiffness=x1,x2 -d out --force --format json")
        .succeeded()
        .matches_snapshot("sweep_json");
}

#[test]
fn wrong_calls_are_refused_before_anything_is_written() {
    let dir = TestDir::with(&[EMU_MODEL, ("bad/no_contacts.osim", "bare.osim")]);
    for (arguments, says) in [
        ("emu.osim", "--grid"),
        ("emu.osim --grid stifness=x2", "there is no property"),
        ("emu.osim --grid stiffness=x2,x2", "appears twice"),
        ("emu.osim --grid stiffness=x2 --grid stiffness=x3", "given twice"),
        ("emu.osim --grid stiffness=x0.1..x10", "expected a range"),
        ("emu.osim --grid indentation=0.1 --grid stiffness=x2", "both say"),
        ("emu.osim --grid indentation=0.1 --grid target_mass=2", "contradict"),
        ("emu.osim --grid indentation=0.1 --indentation 0.2", "both say"),
        ("emu.osim --ladder 1 --indentation 0.16", "from 2 to 100000"),
        ("emu.osim --ladder 3 --indentation 0.16 --soft 20", "the last step has 9.375"),
        ("emu.osim --ladder 3 --indentation 0.16 --soft 0.7", "expected 0.75 or more"),
        ("emu.osim --ladder 3", "--indentation"),
        ("- --grid stiffness=x2", "one model"),
    ] {
        dir.run(&format!("sweep {arguments}")).usage_error().wrote_nothing().says(&[says]);
    }
    dir.run("sweep nowhere.osim --grid stiffness=x2").failed().says(&["no such file"]);
    dir.run("sweep bare.osim --grid stiffness=x2").failed().wrote_nothing().says(&["bare.osim"]);
    for bad in ["stiffness_zero", "number_word", "number_nan", "number_comment_inside"] {
        dir.write("bad.osim", fixture(&format!("bad/{bad}.osim")));
        dir.run("sweep bad.osim --grid stiffness=x1,x2 -d out")
            .failed()
            .wrote_nothing()
            .says(&["bad.osim:", "stiffness is"]);
    }
    for bad in ["socket_of_joint", "body_without_joint"] {
        dir.write("bad.osim", fixture(&format!("bad/{bad}.osim")));
        dir.run("sweep bad.osim --grid stiffness=x1,x2 -d out").failed().wrote_nothing();
    }
    let human = String::from_utf8(fixture("table1/human_62kg_smooth_sphere.osim")).unwrap();
    dir.write("bad.osim", human.replacen("<socket_frame>/bodyset/", "<socket_frame>", 1));
    dir.run("sweep bad.osim --grid stiffness=x1,x2 -d out").failed().wrote_nothing().says(&["leads nowhere"]);
    // A number that the sweep leaves alone would be wrong in all variants.
    dir.write("bad.osim", human.replacen("<location>", "<location>,", 1));
    dir.run("sweep bad.osim --grid stiffness=x1,x2 -d out")
        .failed()
        .wrote_nothing()
        .says(&["bad.osim:", "location of"]);
    // A value that cannot be shows before the first file, in a dry run, too.
    for grid in ["indentation=0.1,2", "stiffness=1e5,0,x2", "dissipation=1,2 --grid restitution=1.5"] {
        for dry in ["", " --dry-run"] {
            let call = format!("sweep emu.osim --grid {grid} -d out{dry}");
            dir.run(&call).usage_error().wrote_nothing();
        }
    }
    dir.run("sweep emu.osim --grid indentation=0.1,2 -d out").usage_error().says(&["indentation=2"]);
    let many = "sweep emu.osim --grid stiffness=x0.1..x10/200 --grid dissipation=0.1..2/200 -d out --dry-run";
    dir.run(many).succeeded().wrote_nothing().says(&["--yes"]);
}

#[test]
fn folders_of_sweeps_are_skipped_with_a_remark() {
    let dir = TestDir::with(&[(EMU_MODEL.0, "lib/emu.osim")]);
    dir.run("sweep lib/emu.osim --grid stiffness=x1,x2").succeeded();
    let run =
        dir.run("lib --target-mass 5 -d out").succeeded().says(&["folders of sweeps (*.sweep) skipped: 1"]);
    assert_eq!(run.changed, ["out/emu.osim"]);
}

#[test]
fn a_model_is_not_written_where_its_included_files_are_missing() {
    let dir = TestDir::with(&[
        ("format/file_forceset.osim", "in/file_forceset.osim"),
        ("format/standalone_ForceSet.xml", "in/standalone_ForceSet.xml"),
    ]);
    dir.run("in/file_forceset.osim --target-mass 5 --only radius -d out")
        .failed()
        .says(&["includes file=", "copy it there"]);
    dir.run("sweep in/file_forceset.osim --grid radius=x2 -d out")
        .failed()
        .says(&["includes file=", "no model was made"]);
    assert!(!dir.has("out/file_forceset.osim") && !dir.has("out/file_forceset_sweep.csv"));
    dir.run("in/file_forceset.osim --target-mass 5 --only radius").succeeded();
}

#[test]
fn file_names_sort_in_the_order_of_the_points() {
    let dir = TestDir::with(&[EMU_MODEL]);
    dir.run("sweep emu.osim --grid stiffness=x10,x9 --grid dissipation=0.1..5/6 -d out --no-note")
        .succeeded();
    let rows = manifest_rows(&dir, "out/emu_sweep.csv");
    let names: Vec<&str> = rows.iter().map(|row| row["file"].as_str()).collect();
    assert!(names.is_sorted() && names.len() == 12, "{names:?}");
    assert!(names[0].starts_with("emu_01_stiffness-x10_dissipation-0.1."), "{names:?}");
    assert!(names[11].starts_with("emu_12_stiffness-x9_dissipation-5."), "{names:?}");
    let numbers: Vec<usize> = rows.iter().map(|row| row["index"].parse().unwrap()).collect();
    assert_eq!(numbers, (1..=12).collect::<Vec<_>>());
}

#[test]
fn a_point_writes_one_model_and_its_row() {
    let dir = TestDir::with(&[EMU_MODEL]);
    let call = "sweep emu.osim --grid stiffness=x1,x2 --grid dissipation=1..2/6 -d out";
    let json = |words: &str| -> Value {
        serde_json::from_str(&dir.run(&format!("{call} {words} --format json")).succeeded().out()).unwrap()
    };
    let planned = json("--point 7 --dry-run");
    assert_eq!((&planned["points"], &planned["models"]), (&12.into(), &1.into()), "{planned}");
    let file = "emu_07_stiffness-x2_dissipation-1.osim";
    assert_eq!(planned["file"], file);
    dir.run(&format!("{call} --point 7")).succeeded().matches_snapshot("sweep_point");
    let resumed = json("--point 7 --resume");
    assert_eq!((&resumed["file"], &resumed["done_before"]), (&file.into(), &1.into()), "{resumed}");
    assert_eq!(resumed["manifest"], "out/emu_sweep.point-7.csv");
    let rows = manifest_rows(&dir, "out/emu_sweep.point-7.csv");
    assert_eq!(rows.len(), 1);
    assert_eq!((rows[0]["index"].as_str(), rows[0]["file"].as_str()), ("7", file));
    assert_eq!(
        rows[0]["stiffness"].parse::<f64>().unwrap(),
        common_value(&dir, &format!("out/{file}"), "stiffness")
    );
    dir.run(&format!("{call} --shard 3/5")).succeeded().matches_snapshot("sweep_share");
    dir.run(&format!("{call} --shard 3/5 --resume --format json"))
        .succeeded()
        .matches_snapshot("sweep_share_json");
    // Many models need a yes, but one point alone does not.
    let many = "sweep emu.osim --grid stiffness=x0.1..x10/101 --grid dissipation=0.1..10/100 -d many";
    dir.run(&format!("{many} --point 10100"))
        .succeeded()
        .says(&["emu_10100_stiffness-x10_dissipation-10.osim"]);
    dir.run(&format!("{many} --shard 1/5000"))
        .usage_error()
        .wrote_nothing()
        .says(&["more than 10,000", "--yes"]);
}

#[test]
fn points_and_shares_out_of_range_are_refused() {
    let dir = TestDir::with(&[EMU_MODEL]);
    let call = "sweep emu.osim --grid stiffness=x1,x2,x3 --grid dissipation=1,2 -d out";
    for (words, says) in [
        ("--point 0", "--point 0: the points of the grid are counted from 1 to 6"),
        ("--point 7", "--point 7: the points of the grid are counted from 1 to 6"),
        ("--point one", "expected the number of one point, counted from 1"),
        ("--point 1.5", "expected the number of one point, counted from 1"),
        ("--point 99999999999999999999", "expected the number of one point, counted from 1"),
        ("--shard 1/1000000001", "n up to 1000000000"),
        ("--point 1 --shard 1/2", "cannot be used with"),
        ("--shard 0/2", "expected i/n with i from 1 to n"),
        ("--shard 3/2", "expected i/n with i from 1 to n"),
    ] {
        dir.run(&format!("{call} {words}")).usage_error().wrote_nothing().says(&[says]);
    }
    let ladder = "sweep emu.osim --ladder 3 --indentation 0.16 --point 4 -d out";
    dir.run(ladder)
        .usage_error()
        .wrote_nothing()
        .says(&["--point 4: the steps of the ladder are counted from 1 to 3"]);
}

/// The factor x1 and the unchanged stiffness give two variants with the same contacts. A remark names them.
#[test]
fn points_with_the_same_contacts_are_named() {
    let dir = TestDir::with(&[EMU_MODEL]);
    let own_value = common_value(&dir, "emu.osim", "stiffness");
    let call = format!("sweep emu.osim --grid stiffness=x1,{own_value},x2 -d out");
    dir.run(&call)
        .succeeded()
        .says(&["remark: 1 of 3 models has the same contacts as an earlier one: 2 and 1"]);
    let run = dir.run("sweep emu.osim --grid stiffness=x1,x2 -d other").succeeded();
    assert!(!run.err().contains("same contacts"), "{}", run.err());
}

/// Models of an earlier sweep stay in the folder. A remark names them, because a loop over all files would use them, too.
#[test]
fn models_of_another_sweep_in_the_folder_are_named() {
    let dir = TestDir::with(&[EMU_MODEL]);
    let errors_of = |call: &str| dir.run(call).succeeded().err();
    assert!(!errors_of("sweep emu.osim --grid stiffness=x1,x2 -d out").contains("another sweep"));
    let err = errors_of("sweep emu.osim --grid stiffness=x1,x3 -d out --force");
    let expected =
        "remark: out has a model of another sweep, which the table does not list: emu_2_stiffness-x2.osim";
    assert!(err.contains(expected), "{err}");
    // A ladder has another table, and other files in the folder do not matter.
    dir.write("out/emu_walks.osim", "mine");
    let err = errors_of("sweep emu.osim --ladder 3 --indentation 0.16 -d out");
    assert!(!err.contains("another sweep"), "{err}");
    let err = errors_of("sweep emu.osim --ladder 2 --indentation 0.16 -d out --force");
    assert!(err.contains("remark: out has 3 models of another sweep"), "{err}");
}
