//! `batch`: changes models by a table (manifest) with a row for each model.

use serde_json::Value;

use crate::support::TestDir;

const MANIFEST_TEXT: &str = include_str!("../../fixtures/libraries/table1.csv");
/// The path of the manifest in the project.
const MANIFEST_OF_TABLE_1: &str = "fixtures/libraries/table1.csv";
/// Numbers that the paper prints in Table 1, in the order of the rows of the manifest.
const PRINTED_TABLE_1: &str = include_str!("../../crates/contact-scaling/src/table1/printed.csv");

/// A folder with the animals of Table 1, which all have the contacts of the 62 kg human.
fn unscaled_animals() -> TestDir {
    let names: Vec<&str> = MANIFEST_TEXT.lines().skip(1).map(|row| row.split(',').nth(1).unwrap()).collect();
    let dir = TestDir::new();
    // As in the project: the manifest in one folder of fixtures, its models in another.
    let models: Vec<String> = names.iter().map(|name| name.replacen("..", "fixtures", 1)).collect();
    for model in &models {
        dir.write(model, std::fs::read(crate::support::root().join(model)).unwrap());
    }
    let models = models.join(" ");
    dir.run(&format!("set {models} stiffness=1e6 dissipation=2 --in-place --no-backup --no-note --quiet"))
        .succeeded();
    dir
}

/// The value of `property` that all forces or spheres of a model have in common.
fn common_value(dir: &TestDir, model: &str, property: &str) -> f64 {
    let inspection: Value =
        serde_json::from_str(&dir.run(&format!("inspect {model} --format json")).succeeded().out()).unwrap();
    let forces = inspection["forces"].as_array().unwrap();
    let values: Vec<f64> =
        forces.iter().map(|force| force["parameters"][property].as_f64().unwrap()).collect();
    assert!(values.iter().all(|value| *value == values[0]), "{values:?}");
    values[0]
}

/// Runs the command from the documentation at the top of the project, with the project's own files.
#[test]
fn the_documented_command_works_from_the_project_folder() {
    let output = std::process::Command::new(env!("CARGO_BIN_EXE_osim-contact-scale"))
        .args(["batch", MANIFEST_OF_TABLE_1, "--dry-run", "--format", "lines"])
        .current_dir(crate::support::root())
        .output()
        .unwrap();
    let (out, err) = (String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
    assert!(output.status.success(), "{out}{err}");
    assert_eq!(out.lines().count(), MANIFEST_TEXT.lines().count() - 1, "{out}{err}");
}

#[test]
fn a_manifest_reproduces_table_1_of_the_paper() {
    let dir = unscaled_animals();
    dir.write(MANIFEST_OF_TABLE_1, MANIFEST_TEXT);
    dir.run("batch fixtures/libraries/table1.csv --quiet").succeeded();
    for (row, printed) in MANIFEST_TEXT.lines().skip(1).zip(PRINTED_TABLE_1.lines().skip(2)) {
        let output = &format!("fixtures/libraries/{}", row.rsplit(',').next().unwrap());
        let printed: Vec<&str> = printed.split(',').collect();
        for (property, unit, printed) in [("stiffness", 1e6, printed[5]), ("dissipation", 1.0, printed[7])] {
            let value = common_value(&dir, output, property) / unit;
            let decimals = printed.split_once('.').map_or(0, |(_, decimals)| decimals.len());
            assert_eq!(format!("{value:.decimals$}"), printed, "{output}: {property}");
        }
    }
}

#[test]
fn spreadsheets_of_other_countries_give_the_same_models() {
    let plain = unscaled_animals();
    plain.write(MANIFEST_OF_TABLE_1, MANIFEST_TEXT);
    plain.run("batch fixtures/libraries/table1.csv --quiet").succeeded();
    let european =
        format!("\u{feff}{}", MANIFEST_TEXT.replace(',', ";").replace("0.0", "0,0").replace('\n', "\r\n"));
    let tabs = MANIFEST_TEXT.replace(',', "\t").replace("37.80", "37,80");
    for manifest in [european, tabs] {
        let dir = unscaled_animals();
        dir.write(MANIFEST_OF_TABLE_1, manifest);
        dir.run("batch fixtures/libraries/table1.csv --quiet").succeeded();
        for name in plain.files().keys().filter(|name| name.starts_with("fixtures/libraries/table1/")) {
            assert_eq!(dir.read(name), plain.read(name), "{name}");
        }
    }
}

#[test]
fn all_rows_are_read_before_the_first_file_is_written() {
    let dir = TestDir::with_human();
    dir.write(
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
    dir.run("batch wrong.csv").usage_error().matches_snapshot("batch_wrong_rows");
    dir.run("batch wrong.csv --format json").usage_error().matches_snapshot("batch_wrong_rows_json");
}

#[test]
fn a_table_that_is_not_a_manifest_is_refused_with_a_correction() {
    let dir = TestDir::with_human();
    for (manifest, says) in [
        ("model,targt-mass\nhuman.osim,5\n", "did you mean 'target-mass'"),
        ("#file,target-mass\nhuman.osim,5\n", "no column 'model'"),
        ("Study 3,\nmodel,target-mass\nhuman.osim,5\n", "it has to name the columns"),
        ("name,target-mass\nhuman.osim,5\n", "call that of the files 'model' or 'file'"),
        ("model,target-mass\nhuman,5\n", "there is no such file: human: did you mean human.osim?"),
        ("model,target-mass\nhumn.osim,5\n", "there is no such file: humn.osim: did you mean human.osim?"),
        ("model,Target mass (lb)\nhuman.osim,180\n", "expected kg, not lb"),
        ("model,weight (lb)\nhuman.osim,180\n", "is 'weight (lb)' that mass? Call it target-mass, in kg"),
        ("model,model\nhuman.osim,5\n", "appears twice"),
        ("model,target-mass,dry-run\nhuman.osim,5,yes\n", "after the table's name"),
        ("model,target-mass\nhuman.osim\n", "line 2: 1 cell, expected 2"),
        ("Study 3\nmodel,target-mass\nhuman.osim,5\n", "has to name all columns: remove it if it is a title"),
        ("model\nhuman.osim,5\n", "line 2: 2 cells, expected 1 as in the first row: the first row has to"),
        ("model,target-mass\n", "no rows"),
        ("m\0o\0", "UTF-16"),
    ] {
        dir.write("m.csv", manifest);
        dir.run("batch m.csv").usage_error().wrote_nothing().says(&[says]);
    }
    dir.run("batch nowhere.csv").usage_error().says(&["nowhere.csv: there is no such file"]);
    dir.run("batch m.csv -o x.osim").usage_error().says(&["column 'output'"]);
    std::fs::create_dir(dir.path("lib")).unwrap();
    let folder = dir.run("batch lib").usage_error();
    folder.says(&[
        "'lib' is a folder, expected a table",
        "'osim-contact-scale lib --target-mass KG -d RESULTS'",
    ]);
}

#[test]
fn rows_may_share_a_model_but_not_an_output() {
    let dir = TestDir::with_human();
    dir.write("m.csv", "model,target-mass,output\nhuman.osim,5,mouse.osim\nhuman.osim,500,Mouse.osim\n");
    dir.run("batch m.csv").usage_error().wrote_nothing().says(&[
        "row 2",
        "row 3",
        "would both be written",
        "different names or folders in the column output",
    ]);
    dir.write("m.csv", "model,target-mass,output\nhuman.osim,5,a.osim\nhuman.osim,500,b.osim\n");
    dir.run("batch m.csv").succeeded().wrote(&["a.osim", "b.osim"]);
    dir.run("human.osim --target-mass 5 -o c.osim").succeeded();
    assert_eq!(dir.read("a.osim"), dir.read("c.osim"));
}

#[test]
fn paths_begin_at_the_manifest_and_options_fill_empty_cells() {
    let dir = TestDir::with(&[("table1/human_62kg_smooth_sphere.osim", "lib/human.osim")]);
    let rows = "model,target-mass,output,no-note\nhuman.osim,5,,\nhuman.osim,500,big/b.osim,yes\n";
    dir.write("lib/m.csv", rows);
    dir.run("batch lib/m.csv -d out --allow-outside")
        .succeeded()
        .wrote(&["lib/big/b.osim", "out/human.osim"]);
    assert!(!dir.text("lib/big/b.osim").contains("[contacts made for "));
    assert!(dir.text("out/human.osim").contains("[contacts made for "));
    // For a table on standard input, paths begin at the working directory.
    dir.run_with_stdin("batch - -d out2", b"model,target-mass\nlib/human.osim,5\n")
        .succeeded()
        .wrote(&["out2/human.osim"]);
}

#[test]
fn each_row_may_have_another_verb() {
    let dir = TestDir::with_human();
    dir.write(
        "m.csv",
        "model,verb,target-mass,set,indentation,select,output\n\
         human.osim,,5,,,,rescale.osim\n\
         human.osim,,,stiffness=x2 dissipation=1,,,set.osim\n\
         human.osim,design,,,0.16,,design.osim\n\
         human.osim,set,,stiffness=x2,,contact_s1_r;contact_s2_*,some.osim\n",
    );
    dir.run("batch m.csv").succeeded();
    for (name, call) in [
        ("rescale.osim", "human.osim --target-mass 5"),
        ("set.osim", "set human.osim stiffness=x2 dissipation=1"),
        ("design.osim", "design human.osim --indentation 0.16"),
        ("some.osim", "set human.osim stiffness=x2 --select contact_s1_r --select contact_s2_*"),
    ] {
        dir.run(&format!("{call} -o same.osim --force")).succeeded();
        assert_eq!(dir.read(name), dir.read("same.osim"), "{name}");
    }
}

/// `--feet` takes a list with commas. Other lists in a table have semicolons, and the list of feet may have semicolons, too.
#[test]
fn feet_in_a_cell_may_have_commas_or_semicolons() {
    let dir = TestDir::with(&[("feet/human_40000.osim", "human.osim")]);
    for mesh in ["l_human_foot", "l_human_toes", "r_human_foot", "r_human_toes"] {
        let file = format!("Geometry/{mesh}.vtp");
        dir.write(&file, crate::support::fixture(&format!("feet/{file}")));
    }
    dir
        .run("add human.osim --feet calcn_r,toes_r,calcn_l,toes_l --count 6 --pad 0.02 --from falisse2022 -o typed.osim")
        .succeeded();
    dir.write(
        "table.csv",
        "model,verb,from,feet,count,pad,output\n\
         human.osim,add,falisse2022,\"calcn_r,toes_r,calcn_l,toes_l\",6,0.02,commas.osim\n\
         human.osim,add,falisse2022,calcn_r;toes_r; calcn_l;toes_l,6,0.02,semicolons.osim\n",
    );
    dir.run("batch table.csv").succeeded();
    assert_eq!(dir.text("commas.osim"), dir.text("typed.osim"));
    assert_eq!(dir.text("semicolons.osim"), dir.text("typed.osim"));
}

#[test]
fn a_failed_model_names_its_row_and_the_others_are_written() {
    let dir = TestDir::with(&[
        ("table1/human_62kg_smooth_sphere.osim", "human.osim"),
        ("bad/truncated.osim", "bad.osim"),
    ]);
    dir.write("m.csv", "model,target-mass\nbad.osim,5\nhuman.osim,5\n");
    dir.run("batch m.csv -d out --summary s.csv").failed().wrote(&["out/human.osim", "s.csv"]).says(&[
        "bad.osim:37:6",
        "(row 2)",
        "2 models: 1 written, 1 failed",
    ]);
    let summary = dir.text("s.csv");
    let rows: Vec<&str> = summary.lines().map(|line| line.split(',').next().unwrap()).collect();
    assert_eq!(rows, ["row", "2", "3"]);
}

#[test]
fn two_rows_may_not_change_and_read_one_model() {
    let dir = TestDir::with_human();
    for rows in [
        "human.osim,stiffness=x2,yes,,\nhuman.osim,stiffness=x3,,,b.osim\n",
        "human.osim,stiffness=x2,yes,,\nother.osim,,,human.osim,b.osim\n",
    ] {
        dir.write("other.osim", crate::support::fixture("table1/mouse_smooth_sphere.osim"));
        dir.write("m.csv", format!("model,set,in-place,from,output\n{rows}"));
        dir.run("batch m.csv")
            .usage_error()
            .wrote_nothing()
            .says(&["row 2", "would change human.osim in place"]);
    }
}

#[test]
fn the_manifest_is_never_overwritten() {
    let dir = TestDir::with_human();
    dir.write("m.csv", "model,target-mass,output\nhuman.osim,5,m.csv\n");
    dir.run("batch m.csv --force").usage_error().wrote_nothing().says(&["is an input of this run"]);
    dir.write("m.csv", "model,target-mass,output\nhuman.osim,5,a.osim\n");
    dir.run("batch m.csv --summary m.csv --force")
        .usage_error()
        .wrote_nothing()
        .says(&["is an input of this run"]);
}

#[test]
fn a_point_that_may_separate_thousands_is_refused_if_commas_are_decimal() {
    let dir = TestDir::with_human();
    let refused = "'1.190' may be 1190 or 1.190: write 1190 or 1.1900";
    for manifest in
        ["model;target-mass\nhuman.osim;1.190\n", "model\ttarget-mass\tradius\nhuman.osim\t1.190\t0,04\n"]
    {
        dir.write("m.csv", manifest);
        dir.run("batch m.csv").usage_error().wrote_nothing().says(&[refused]);
    }
    for (manifest, mass) in [
        ("model,target-mass\nhuman.osim,1.190\n", "1.19 kg"),
        ("model\ttarget-mass\nhuman.osim\t1.190\n", "1.19 kg"),
        ("model;target-mass\nhuman.osim;1.1900\n", "1.19 kg"),
        ("model;target-mass\nhuman.osim;1190\n", "1190 kg"),
    ] {
        dir.write("m.csv", manifest);
        dir.run("batch m.csv --dry-run").succeeded().says(&[mass]);
    }
}

#[test]
fn rows_with_too_many_cells_report_the_probable_separator() {
    let dir = TestDir::with_human();
    dir.write("m.csv", "model,target-mass\nhuman.osim,0,0209\n");
    dir.run("batch m.csv").usage_error().wrote_nothing().says(&["line 2: 3 cells", "decimal comma"]);
    dir.write("m.csv", "model;target-mass;select\nhuman.osim;62;*_r;*_l\n");
    dir.run("batch m.csv").usage_error().wrote_nothing().says(&["line 2: 4 cells", "quotation marks"]);
}

#[test]
fn a_comma_that_may_separate_thousands_is_always_refused() {
    let dir = TestDir::with_human();
    for manifest in ["model;target-mass\nhuman.osim;1,190\n", "model\ttarget-mass\nhuman.osim\t1,190\n"] {
        dir.write("m.csv", manifest);
        dir.run("batch m.csv").usage_error().wrote_nothing().says(&["'1,190' may be 1190 or 1.190"]);
    }
}

#[test]
fn rows_write_outside_the_folder_only_with_permission() {
    let table = |row: &str| format!("model,target-mass,output,in-place,no-backup,yes\n{row}\n");
    for (row, column, call) in [
        ("../human.osim,100,../a.osim,,,", "output", "batch t/rows.csv"),
        ("../human.osim,100,,yes,yes,", "in-place", "batch t/rows.csv"),
        ("../human.osim,100,away/../../a.osim,,,", "output", "batch t/rows.csv"),
        ("../human.osim,100,other/a.osim,,,", "output", "batch t/rows.csv -d out"),
    ] {
        let dir = TestDir::with_human();
        dir.write("t/rows.csv", table(row));
        dir.write("t/away/x", "");
        let column = format!("row 2, column '{column}'");
        dir.run(call).usage_error().wrote_nothing().says(&[
            &column,
            "is outside the folder",
            "--allow-outside",
        ]);
        assert_eq!(dir.run(&format!("{call} --allow-outside")).succeeded().changed.len(), 1, "{row}");
    }
    // The message names the column. A row may not replace a result beside its model either.
    for (header, row, column) in [
        ("model,target-mass,output-dir", "../human.osim,100,..", "output-dir"),
        ("model,target-mass,output,output-dir", "../human.osim,100,,..", "output-dir"),
        ("model,target-mass,force", "../human.osim,100,yes", "force"),
    ] {
        let dir = TestDir::with_human();
        dir.write("t/rows.csv", format!("{header}\n{row}\n"));
        dir.write("human.scaled.osim", "my work");
        let column = format!("row 2, column '{column}'");
        let refused = dir.run("batch t/rows.csv");
        refused.usage_error().wrote_nothing().says(&[&column, "is outside the folder", "--allow-outside"]);
    }
    let dir = TestDir::with_human();
    dir.write("t/rows.csv", "model,target-mass,force\n../human.osim,100,yes\n");
    dir.write("human.scaled.osim", "my work");
    dir.run("batch t/rows.csv --allow-outside").succeeded().wrote(&["human.scaled.osim"]);
    // An option of the call may replace results beside the models, and a row may replace files below the table's folder.
    dir.write("t/rows.csv", "model,target-mass\n../human.osim,110\n");
    dir.run("batch t/rows.csv").failed().wrote_nothing();
    dir.run("batch t/rows.csv --force").succeeded().wrote(&["human.scaled.osim"]);
    dir.write("t/rows.csv", "model,target-mass,force,output\n../human.osim,100,yes,a.osim\n");
    dir.write("t/a.osim", "my work");
    dir.run("batch t/rows.csv").succeeded().wrote(&["t/a.osim"]);
    // Below the table's folder, below -d, and beside the model where no row names a file.
    for (row, call, written) in [
        ("../human.osim,100,new/a.osim,,,", "batch t/rows.csv", "t/new/a.osim"),
        ("../human.osim,100,,,,", "batch t/rows.csv", "human.scaled.osim"),
        ("../human.osim,100,,,,", "batch t/rows.csv -d out", "out/human.osim"),
        ("../human.osim,100,../out/b.osim,,,", "batch t/rows.csv -d out", "out/b.osim"),
    ] {
        let dir = TestDir::with_human();
        dir.write("t/rows.csv", table(row));
        dir.run(call).succeeded().wrote(&[written]);
    }
}

#[cfg(unix)]
#[test]
fn a_link_that_leads_outside_the_folder_is_refused() {
    let dir = TestDir::with_human();
    dir.write("t/rows.csv", "model,target-mass,output\n../human.osim,100,link/a.osim\n");
    dir.write("elsewhere/x", "");
    std::os::unix::fs::symlink("../elsewhere", dir.path("t/link")).unwrap();
    dir.run("batch t/rows.csv").usage_error().wrote_nothing().says(&["is outside the folder"]);
}

/// A spreadsheet writes an error such as `#REF!` into the cell of a broken formula: neither a number, nor a name, nor empty.
#[test]
fn a_broken_formula_of_the_spreadsheet_is_reported() {
    let dir = TestDir::with(&[("check/known_contacts.osim", "human.osim")]);
    for (cell, column) in
        [("#REF!", "target-mass"), ("#N/A", "target-mass"), ("#DIV/0!", "output"), ("Err:502", "target-mass")]
    {
        let row = if column == "output" { format!("70,{cell}") } else { format!("{cell},out.osim") };
        dir.write("table.csv", format!("model,target-mass,output\nhuman.osim,{row}\n"));
        let expected = format!("row 2, column '{column}': '{cell}' is a broken formula of the spreadsheet");
        dir.run("batch table.csv").usage_error().wrote_nothing().says(&[&expected]);
    }
    // The program does not read the user's own columns.
    dir.write("table.csv", "model,target-mass,output,#why\nhuman.osim,70,out.osim,#N/A\n");
    dir.run("batch table.csv").succeeded();
}

#[test]
fn a_zip_archive_as_a_table_is_named_by_what_it_is() {
    let dir = TestDir::new();
    dir.write("table.csv", b"PK\x03\x04\0\0");
    dir.run("batch table.csv -d out").usage_error().says(&["a ZIP archive", "unpack it"]);
}

#[test]
fn a_model_instead_of_a_table_is_refused_in_one_line() {
    let dir = TestDir::with_human();
    let run = dir.run("batch human.osim -d out").usage_error().wrote_nothing();
    assert!(run.err().len() < 150, "{}", run.err());
    run.says(&["such as an OpenSim model", "table (.csv or .xlsx)"]);
}
