//! `batch`: a manifest with a row per model.

use serde_json::Value;

use crate::support::Bench;

const MANIFEST: &str = include_str!("../../fixtures/libraries/table1.csv");
/// Where it is in the project.
const TABLE_1: &str = "fixtures/libraries/table1.csv";
/// What the paper prints, row by row as in the manifest.
const PRINTED: &str = include_str!("../../crates/contact-scaling/src/table1/printed.csv");

/// The animals of Table 1, every one with the contacts of the 62 kg human.
fn unscaled_animals() -> Bench {
    let names: Vec<&str> = MANIFEST.lines().skip(1).map(|row| row.split(',').nth(1).unwrap()).collect();
    let bench = Bench::new();
    // As in the project: the manifest in one folder of fixtures, its models in another.
    let models: Vec<String> = names.iter().map(|name| name.replacen("..", "fixtures", 1)).collect();
    for model in &models {
        bench.write(model, std::fs::read(crate::support::root().join(model)).unwrap());
    }
    let models = models.join(" ");
    bench
        .run(&format!("set {models} stiffness=1e6 dissipation=2 --in-place --no-backup --no-note --quiet"))
        .done();
    bench
}

/// Every value of `property` in a model, which are all alike.
fn common(bench: &Bench, model: &str, property: &str) -> f64 {
    let seen: Value =
        serde_json::from_str(&bench.run(&format!("inspect {model} --format json")).done().out()).unwrap();
    let forces = seen["forces"].as_array().unwrap();
    let values: Vec<f64> =
        forces.iter().map(|force| force["parameters"][property].as_f64().unwrap()).collect();
    assert!(values.iter().all(|value| *value == values[0]), "{values:?}");
    values[0]
}

/// The documented command as it is documented, from the top of the project, with the files that are there.
#[test]
fn the_documented_command_works_where_it_stands() {
    let output = std::process::Command::new(env!("CARGO_BIN_EXE_osim-contact-scale"))
        .args(["batch", TABLE_1, "--dry-run", "--format", "lines"])
        .current_dir(crate::support::root())
        .output()
        .unwrap();
    let (out, err) = (String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
    assert!(output.status.success(), "{out}{err}");
    assert_eq!(out.lines().count(), MANIFEST.lines().count() - 1, "{out}{err}");
}

#[test]
fn table_1_of_the_paper_is_a_manifest() {
    let bench = unscaled_animals();
    bench.write(TABLE_1, MANIFEST);
    bench.run("batch fixtures/libraries/table1.csv --quiet").done();
    for (row, printed) in MANIFEST.lines().skip(1).zip(PRINTED.lines().skip(2)) {
        let output = &format!("fixtures/libraries/{}", row.rsplit(',').next().unwrap());
        let printed: Vec<&str> = printed.split(',').collect();
        for (property, unit, printed) in [("stiffness", 1e6, printed[5]), ("dissipation", 1.0, printed[7])] {
            let value = common(&bench, output, property) / unit;
            let decimals = printed.split_once('.').map_or(0, |(_, decimals)| decimals.len());
            assert_eq!(format!("{value:.decimals$}"), printed, "{output}: {property}");
        }
    }
}

#[test]
fn spreadsheets_of_other_countries_mean_the_same() {
    let plain = unscaled_animals();
    plain.write(TABLE_1, MANIFEST);
    plain.run("batch fixtures/libraries/table1.csv --quiet").done();
    let european =
        format!("\u{feff}{}", MANIFEST.replace(',', ";").replace("0.0", "0,0").replace('\n', "\r\n"));
    let tabs = MANIFEST.replace(',', "\t").replace("37.80", "37,80");
    for manifest in [european, tabs] {
        let bench = unscaled_animals();
        bench.write(TABLE_1, manifest);
        bench.run("batch fixtures/libraries/table1.csv --quiet").done();
        for name in plain.files().keys().filter(|name| name.starts_with("fixtures/libraries/table1/")) {
            assert_eq!(bench.read(name), plain.read(name), "{name}");
        }
    }
}

#[test]
fn all_rows_are_read_before_the_first_file_is_written() {
    let bench = Bench::human();
    bench.write(
        "wrong.csv",
        "model,target-mass,from,spheres,radius,friction,verb,set,output\n\
         human.osim,1190,,,,,,,good.osim\n\
         human.osim,1190kg,,,,,,,a.osim\n\
         human.osim,\"0,0209\",,,,,,,b.osim\n\
         nowhere.osim,5,,,,,,,c.osim\n\
         human.osim,,,,,,,,d.osim\n\
         human.osim,5,,2,,,,,e.osim\n\
         human.osim,5,,,wide,,,,f.osim\n\
         human.osim,5,,,,maybe,,,g.osim\n\
         human.osim,,nobody2020,,,,,,h.osim\n\
         human.osim,,,,,,scale,,i.osim\n\
         human.osim,,,,,,,stifness=2,j.osim\n\
         ,5,,,,,,,k.osim\n\
         human.osim,5,,,,,,,-\n",
    );
    bench.run("batch wrong.csv").usage().looks_like("batch_wrong_rows");
    bench.run("batch wrong.csv --format json").usage().looks_like("batch_wrong_rows_json");
}

#[test]
fn a_table_that_is_no_manifest_is_refused_with_what_to_mend() {
    let bench = Bench::human();
    for (manifest, says) in [
        ("model,targt-mass\nhuman.osim,5\n", "did you mean 'target-mass'"),
        ("file,target-mass\nhuman.osim,5\n", "'file' is not an option"),
        ("#file,target-mass\nhuman.osim,5\n", "no column 'model'"),
        ("model,model\nhuman.osim,5\n", "appears twice"),
        ("model,target-mass,dry-run\nhuman.osim,5,yes\n", "after the manifest's name"),
        ("model,target-mass\nhuman.osim\n", "line 2: 1 cells, expected 2"),
        ("model,target-mass\n", "no rows"),
        ("m\0o\0", "UTF-16"),
    ] {
        bench.write("m.csv", manifest);
        bench.run("batch m.csv").usage().wrote_nothing().says(&[says]);
    }
    bench.run("batch nowhere.csv").usage().says(&["nowhere.csv: there is no such file"]);
    bench.run("batch m.csv -o x.osim").usage().says(&["column 'output'"]);
}

#[test]
fn rows_may_share_a_model_but_not_an_output() {
    let bench = Bench::human();
    bench.write("m.csv", "model,target-mass,output\nhuman.osim,5,mouse.osim\nhuman.osim,500,Mouse.osim\n");
    bench.run("batch m.csv").usage().wrote_nothing().says(&["row 2", "row 3", "would both be written"]);
    bench.write("m.csv", "model,target-mass,output\nhuman.osim,5,a.osim\nhuman.osim,500,b.osim\n");
    bench.run("batch m.csv").done().wrote(&["a.osim", "b.osim"]);
    bench.run("human.osim --target-mass 5 -o c.osim").done();
    assert_eq!(bench.read("a.osim"), bench.read("c.osim"));
}

#[test]
fn paths_begin_at_the_manifest_and_options_of_the_call_fill_what_rows_leave_open() {
    let bench = Bench::with(&[("table1/human_62kg_smooth_sphere.osim", "lib/human.osim")]);
    let rows = "model,target-mass,output,no-note\nhuman.osim,5,,\nhuman.osim,500,big/b.osim,yes\n";
    bench.write("lib/m.csv", rows);
    bench.run("batch lib/m.csv -d out --allow-outside").done().wrote(&["lib/big/b.osim", "out/human.osim"]);
    assert!(!bench.text("lib/big/b.osim").contains("[contacts made for "));
    assert!(bench.text("out/human.osim").contains("[contacts made for "));
    // From standard input, paths begin where the call is made.
    bench
        .run_with("batch - -d out2", b"model,target-mass\nlib/human.osim,5\n")
        .done()
        .wrote(&["out2/human.osim"]);
}

#[test]
fn every_verb_has_its_rows() {
    let bench = Bench::human();
    bench.write(
        "m.csv",
        "model,verb,target-mass,set,indentation,select,output\n\
         human.osim,,5,,,,rescale.osim\n\
         human.osim,,,stiffness=x2 dissipation=1,,,set.osim\n\
         human.osim,design,,,0.16,,design.osim\n\
         human.osim,set,,stiffness=x2,,contact_s1_r;contact_s2_*,some.osim\n",
    );
    bench.run("batch m.csv").done();
    for (name, call) in [
        ("rescale.osim", "human.osim --target-mass 5"),
        ("set.osim", "set human.osim stiffness=x2 dissipation=1"),
        ("design.osim", "design human.osim --indentation 0.16"),
        ("some.osim", "set human.osim stiffness=x2 --select contact_s1_r --select contact_s2_*"),
    ] {
        bench.run(&format!("{call} -o same.osim --force")).done();
        assert_eq!(bench.read(name), bench.read("same.osim"), "{name}");
    }
}

/// `--feet` takes commas; between the items of other lists a table has semicolons, and `feet` may have those, too.
#[test]
fn feet_of_a_row_have_commas_as_on_the_command_line() {
    let bench = Bench::with(&[("feet/human_40000.osim", "human.osim")]);
    for mesh in ["l_human_foot", "l_human_toes", "r_human_foot", "r_human_toes"] {
        let file = format!("Geometry/{mesh}.vtp");
        bench.write(&file, crate::support::fixture(&format!("feet/{file}")));
    }
    bench
        .run("add human.osim --feet calcn_r,toes_r,calcn_l,toes_l --count 6 --pad 0.02 --from falisse2022 -o typed.osim")
        .done();
    bench.write(
        "table.csv",
        "model,verb,from,feet,count,pad,output\n\
         human.osim,add,falisse2022,\"calcn_r,toes_r,calcn_l,toes_l\",6,0.02,commas.osim\n\
         human.osim,add,falisse2022,calcn_r;toes_r; calcn_l;toes_l,6,0.02,semicolons.osim\n",
    );
    bench.run("batch table.csv").done();
    assert_eq!(bench.text("commas.osim"), bench.text("typed.osim"));
    assert_eq!(bench.text("semicolons.osim"), bench.text("typed.osim"));
}

#[test]
fn a_model_that_fails_names_its_row_and_the_others_are_done() {
    let bench = Bench::with(&[
        ("table1/human_62kg_smooth_sphere.osim", "human.osim"),
        ("bad/truncated.osim", "bad.osim"),
    ]);
    bench.write("m.csv", "model,target-mass\nbad.osim,5\nhuman.osim,5\n");
    bench.run("batch m.csv -d out --summary s.csv").failed().wrote(&["out/human.osim", "s.csv"]).says(&[
        "bad.osim:37:6",
        "(row 2)",
        "2 models: 1 written, 1 failed",
    ]);
    let summary = bench.text("s.csv");
    let rows: Vec<&str> = summary.lines().map(|line| line.split(',').next().unwrap()).collect();
    assert_eq!(rows, ["row", "2", "3"]);
}

#[test]
fn a_row_that_changes_a_model_itself_and_one_that_reads_it_are_refused() {
    let bench = Bench::human();
    for rows in [
        "human.osim,stiffness=x2,yes,,\nhuman.osim,stiffness=x3,,,b.osim\n",
        "human.osim,stiffness=x2,yes,,\nother.osim,,,human.osim,b.osim\n",
    ] {
        bench.write("other.osim", crate::support::fixture("table1/mouse_smooth_sphere.osim"));
        bench.write("m.csv", format!("model,set,in-place,from,output\n{rows}"));
        bench.run("batch m.csv").usage().wrote_nothing().says(&["row 2", "would change human.osim itself"]);
    }
}

#[test]
fn the_manifest_is_never_written_over() {
    let bench = Bench::human();
    bench.write("m.csv", "model,target-mass,output\nhuman.osim,5,m.csv\n");
    bench.run("batch m.csv --force").usage().wrote_nothing().says(&["is an input of this run"]);
    bench.write("m.csv", "model,target-mass,output\nhuman.osim,5,a.osim\n");
    bench
        .run("batch m.csv --summary m.csv --force")
        .usage()
        .wrote_nothing()
        .says(&["is an input of this run"]);
}

#[test]
fn a_point_that_may_part_thousands_is_refused_where_commas_are_decimal() {
    let bench = Bench::human();
    let refused = "'1.190' may be 1190 or 1.190: write 1190 or 1.1900";
    for manifest in
        ["model;target-mass\nhuman.osim;1.190\n", "model\ttarget-mass\tradius\nhuman.osim\t1.190\t0,04\n"]
    {
        bench.write("m.csv", manifest);
        bench.run("batch m.csv").usage().wrote_nothing().says(&[refused]);
    }
    for (manifest, mass) in [
        ("model,target-mass\nhuman.osim,1.190\n", "1.19 kg"),
        ("model\ttarget-mass\nhuman.osim\t1.190\n", "1.19 kg"),
        ("model;target-mass\nhuman.osim;1.1900\n", "1.19 kg"),
        ("model;target-mass\nhuman.osim;1190\n", "1190 kg"),
    ] {
        bench.write("m.csv", manifest);
        bench.run("batch m.csv --dry-run").done().says(&[mass]);
    }
}

#[test]
fn rows_with_too_many_cells_say_what_may_have_parted_them() {
    let bench = Bench::human();
    bench.write("m.csv", "model,target-mass\nhuman.osim,0,0209\n");
    bench.run("batch m.csv").usage().wrote_nothing().says(&["line 2: 3 cells", "decimal comma"]);
    bench.write("m.csv", "model;target-mass;select\nhuman.osim;62;*_r;*_l\n");
    bench.run("batch m.csv").usage().wrote_nothing().says(&["line 2: 4 cells", "quotation marks"]);
}

#[test]
fn a_comma_that_may_part_thousands_is_refused_everywhere() {
    let bench = Bench::human();
    for manifest in ["model;target-mass\nhuman.osim;1,190\n", "model\ttarget-mass\nhuman.osim\t1,190\n"] {
        bench.write("m.csv", manifest);
        bench.run("batch m.csv").usage().wrote_nothing().says(&["'1,190' may be 1190 or 1.190"]);
    }
}

#[test]
fn rows_write_outside_only_where_that_is_allowed() {
    let table = |row: &str| format!("model,target-mass,output,in-place,no-backup,yes\n{row}\n");
    for (row, column, call) in [
        ("../human.osim,100,../a.osim,,,", "output", "batch t/rows.csv"),
        ("../human.osim,100,,yes,yes,", "in-place", "batch t/rows.csv"),
        ("../human.osim,100,away/../../a.osim,,,", "output", "batch t/rows.csv"),
        ("../human.osim,100,other/a.osim,,,", "output", "batch t/rows.csv -d out"),
    ] {
        let bench = Bench::human();
        bench.write("t/rows.csv", table(row));
        bench.write("t/away/x", "");
        let column = format!("row 2, column '{column}'");
        bench.run(call).usage().wrote_nothing().says(&[&column, "is outside the folder", "--allow-outside"]);
        assert_eq!(bench.run(&format!("{call} --allow-outside")).done().changed.len(), 1, "{row}");
    }
    // By the column that says it, and a result beside its model is not replaced either because a row says so.
    for (header, row, column) in [
        ("model,target-mass,output-dir", "../human.osim,100,..", "output-dir"),
        ("model,target-mass,output,output-dir", "../human.osim,100,,..", "output-dir"),
        ("model,target-mass,force", "../human.osim,100,yes", "force"),
    ] {
        let bench = Bench::human();
        bench.write("t/rows.csv", format!("{header}\n{row}\n"));
        bench.write("human.scaled.osim", "my work");
        let column = format!("row 2, column '{column}'");
        let refused = bench.run("batch t/rows.csv");
        refused.usage().wrote_nothing().says(&[&column, "is outside the folder", "--allow-outside"]);
    }
    let bench = Bench::human();
    bench.write("t/rows.csv", "model,target-mass,force\n../human.osim,100,yes\n");
    bench.write("human.scaled.osim", "my work");
    bench.run("batch t/rows.csv --allow-outside").done().wrote(&["human.scaled.osim"]);
    // Who calls may replace what is beside the models, and a row below its own folder.
    bench.write("t/rows.csv", "model,target-mass\n../human.osim,110\n");
    bench.run("batch t/rows.csv").failed().wrote_nothing();
    bench.run("batch t/rows.csv --force").done().wrote(&["human.scaled.osim"]);
    bench.write("t/rows.csv", "model,target-mass,force,output\n../human.osim,100,yes,a.osim\n");
    bench.write("t/a.osim", "my work");
    bench.run("batch t/rows.csv").done().wrote(&["t/a.osim"]);
    // Below the table's folder, below -d, and beside the model where no row names a file.
    for (row, call, written) in [
        ("../human.osim,100,new/a.osim,,,", "batch t/rows.csv", "t/new/a.osim"),
        ("../human.osim,100,,,,", "batch t/rows.csv", "human.scaled.osim"),
        ("../human.osim,100,,,,", "batch t/rows.csv -d out", "out/human.osim"),
        ("../human.osim,100,../out/b.osim,,,", "batch t/rows.csv -d out", "out/b.osim"),
    ] {
        let bench = Bench::human();
        bench.write("t/rows.csv", table(row));
        bench.run(call).done().wrote(&[written]);
    }
}

#[cfg(unix)]
#[test]
fn a_link_below_the_folder_leads_outside_like_any_path() {
    let bench = Bench::human();
    bench.write("t/rows.csv", "model,target-mass,output\n../human.osim,100,link/a.osim\n");
    bench.write("elsewhere/x", "");
    std::os::unix::fs::symlink("../elsewhere", bench.path("t/link")).unwrap();
    bench.run("batch t/rows.csv").usage().wrote_nothing().says(&["is outside the folder"]);
}

/// What a spreadsheet writes where a formula has no value is no number, no name and not nothing.
#[test]
fn a_broken_formula_of_the_spreadsheet_is_called_that() {
    let bench = Bench::with(&[("check/known_contacts.osim", "human.osim")]);
    for (cell, column) in
        [("#REF!", "target-mass"), ("#N/A", "target-mass"), ("#DIV/0!", "output"), ("Err:502", "target-mass")]
    {
        let row = if column == "output" { format!("70,{cell}") } else { format!("{cell},out.osim") };
        bench.write("table.csv", format!("model,target-mass,output\nhuman.osim,{row}\n"));
        let expected = format!("row 2, column '{column}': '{cell}' is a broken formula of the spreadsheet");
        bench.run("batch table.csv").usage().wrote_nothing().says(&[&expected]);
    }
    // A remark of the user's own is not read.
    bench.write("table.csv", "model,target-mass,output,#why\nhuman.osim,70,out.osim,#N/A\n");
    bench.run("batch table.csv").done();
}
