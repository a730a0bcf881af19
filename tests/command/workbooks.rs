//! An Excel workbook instead of a CSV table gives the same bytes; a wrong cell is named.

use crate::add_table::human_with_meshes;
use crate::support::{TestDir, fixture};

fn write_workbook(dir: &TestDir, name: &str) {
    dir.write(name, fixture(&format!("workbooks/{name}")));
}

#[test]
fn a_workbook_of_places_gives_the_model_of_its_csv() {
    let dir = human_with_meshes();
    write_workbook(&dir, "places.xlsx");
    for (table, output) in [("own.csv", "csv.osim"), ("places.xlsx", "xlsx.osim")] {
        dir.run(&format!("add human.osim --contacts {table} --from falisse2022 -o {output}")).succeeded();
    }
    // The notes name the tables.
    assert_eq!(dir.text("csv.osim").replace("own.csv", "places.xlsx"), dir.text("xlsx.osim"));
}

#[test]
fn a_workbook_of_rows_gives_the_models_of_its_csv() {
    let dir = TestDir::with_human();
    write_workbook(&dir, "subjects.xlsx");
    dir.run("batch subjects.xlsx").succeeded().wrote(&["heavy.osim", "light.osim"]);
    let from_workbook = [dir.read("heavy.osim"), dir.read("light.osim")];
    dir.write(
        "subjects.csv",
        "model,target-mass,output\nhuman.osim,80,heavy.osim\nhuman.osim,41.5,light.osim\n",
    );
    dir.run("batch subjects.csv --force").succeeded();
    assert_eq!(from_workbook, [dir.read("heavy.osim"), dir.read("light.osim")]);
}

#[test]
fn a_cell_that_is_neither_number_nor_text_is_named() {
    let dir = TestDir::with_human();
    for (book, says) in [
        ("broken_formula.xlsx", "cell B3 (#REF!) is a broken formula of the spreadsheet: repair it there"),
        ("date.xlsx", "cell B2 is a date or a time, expected a number or a text"),
        ("truth.xlsx", "cell B3 is true or false, expected a number or a text, such as yes"),
        ("overflow.xlsx", "a sheet of this workbook has a cell or row 'B4294967298'"),
    ] {
        write_workbook(&dir, book);
        dir.run(&format!("batch {book}")).usage_error().wrote_nothing().says(&[book, says]);
        let failed = dir.run(&format!("add human.osim --contacts {book} --from falisse2022 -o out.osim"));
        assert!(!failed.err().is_empty() && failed.err().contains(says), "{}", failed.err());
    }
}
