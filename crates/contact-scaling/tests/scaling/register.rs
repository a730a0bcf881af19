//! Tests that the register of equations has the same content as `docs/reference/equations.md`, row by row.

#![allow(clippy::disallowed_methods, reason = "tests cut their own texts")]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use std::path::Path;

use contact_scaling::equations;

/// A row of a table of equations: label, variant, formula (with a remark after it, if any), functions, unit.
#[derive(Debug, PartialEq)]
struct EquationRow {
    label: String,
    variant: String,
    formula: String,
    function: String,
    unit: String,
}

fn rows_of_the_page() -> Vec<EquationRow> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/reference/equations.md");
    let page = std::fs::read_to_string(path).unwrap();
    page.lines().filter_map(row).collect()
}

fn row(line: &str) -> Option<EquationRow> {
    let cells: Vec<&str> = line.strip_prefix('|')?.split('|').map(str::trim).collect();
    if cells[0] == "number" || cells[0].starts_with("---") {
        return None;
    }
    let (label, variant) = cells[0].split_once(", ").unwrap_or((cells[0], ""));
    let formula = cells[1].replace("\\*", "*").replace('`', "");
    let function = cells[2].split('`').skip(1).step_by(2).find(|name| name.contains("::")).unwrap_or("");
    Some(EquationRow {
        label: label.strip_prefix('(').and_then(|l| l.strip_suffix(')')).unwrap_or(label).to_owned(),
        variant: variant.replace("\\*", "*"),
        formula: formula.split(" (and ").next().unwrap().to_owned(),
        function: function.to_owned(),
        unit: cells[3].to_owned(),
    })
}

fn rows_of_the_register() -> Vec<EquationRow> {
    let rows = equations::all().flat_map(|equation| {
        equation.forms.iter().map(|form| EquationRow {
            label: equation.label.to_owned(),
            variant: form.variant.to_owned(),
            formula: form.formula.to_owned(),
            function: form.function.to_owned(),
            unit: form.unit.to_owned(),
        })
    });
    rows.collect()
}

#[test]
fn the_register_and_the_page_agree() {
    let (mut page, mut register) = (rows_of_the_page(), rows_of_the_register());
    assert!(page.len() > 50, "the tables of docs/reference/equations.md were not understood");
    let key = |row: &EquationRow| (row.label.clone(), row.variant.clone(), row.formula.clone());
    page.sort_by_key(key);
    register.sort_by_key(key);
    for (page, register) in page.iter().zip(&register) {
        assert_eq!(page, register);
    }
    assert_eq!(page.len(), register.len());
}

#[test]
fn every_number_of_the_paper_is_in_the_register() {
    let count = |prefix: &str| equations::all().filter(|e| e.label.starts_with(prefix)).count();
    let numbered = equations::all().filter(|e| e.label.parse::<u32>().is_ok()).count();
    // (1) to (15), (A.1) to (A.5), (B.1) to (B.5), (C.1) to (C.10).
    assert_eq!([numbered, count("A."), count("B."), count("C.")], [15, 5, 5, 10]);
}
