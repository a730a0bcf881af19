//! Excel's own .xlsx in the place of a CSV table: the same bytes come of it, and what is no number is named by its cell.

use crate::placed::human;
use crate::support::{Bench, fixture};

fn with_book(bench: &Bench, name: &str) {
    bench.write(name, fixture(&format!("workbooks/{name}")));
}

#[test]
fn a_workbook_of_places_says_what_its_csv_says() {
    let bench = human();
    with_book(&bench, "places.xlsx");
    for (table, output) in [("own.csv", "csv.osim"), ("places.xlsx", "xlsx.osim")] {
        bench.run(&format!("add human.osim --contacts {table} --from falisse2022 -o {output}")).done();
    }
    // The notes name the tables.
    assert_eq!(bench.text("csv.osim").replace("own.csv", "places.xlsx"), bench.text("xlsx.osim"));
}

#[test]
fn a_workbook_of_rows_says_what_its_csv_says() {
    let bench = Bench::human();
    with_book(&bench, "subjects.xlsx");
    bench.run("batch subjects.xlsx").done().wrote(&["heavy.osim", "light.osim"]);
    let of_workbook = [bench.read("heavy.osim"), bench.read("light.osim")];
    bench.write(
        "subjects.csv",
        "model,target-mass,output\nhuman.osim,80,heavy.osim\nhuman.osim,41.5,light.osim\n",
    );
    bench.run("batch subjects.csv --force").done();
    assert_eq!(of_workbook, [bench.read("heavy.osim"), bench.read("light.osim")]);
}

#[test]
fn a_cell_that_is_no_number_and_no_text_is_named() {
    let bench = Bench::human();
    for (book, says) in [
        ("broken_formula.xlsx", "cell B3 (#REF!) is a broken formula of the spreadsheet: repair it there"),
        ("date.xlsx", "cell B2 is a date or a time, expected a number or a text"),
        ("truth.xlsx", "cell B3 is true or false, expected a number or a text"),
    ] {
        with_book(&bench, book);
        bench.run(&format!("batch {book}")).usage().wrote_nothing().says(&[book, says]);
        let failed = bench.run(&format!("add human.osim --contacts {book} --from falisse2022 -o out.osim"));
        assert!(!failed.err().is_empty() && failed.err().contains(says), "{}", failed.err());
    }
}
