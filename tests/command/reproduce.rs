//! `reproduce`: the program computes the paper's Table 1 and its figures.

use crate::support::TestDir;

/// The numbers of Table 1, typed from the paper.
const PRINTED_TABLE_1: &str = include_str!("../../crates/contact-scaling/src/table1/printed.csv");

#[test]
fn reproduce_prints_the_table_and_what_fig_1_needs() {
    let run = TestDir::new().run("reproduce").succeeded().wrote_nothing().matches_snapshot("reproduce");
    assert!(run.stderr.is_empty());
    assert!(run.out().lines().all(|line| line.chars().count() <= 80), "{}", run.out());
}

#[test]
fn every_number_agrees_to_its_last_printed_digit_or_is_marked() {
    let dir = TestDir::new();
    dir.run("reproduce -d paper").succeeded().wrote(&[
        "paper/fig-c5.svg",
        "paper/fig4.svg",
        "paper/table1.csv",
    ]);
    let mut table = csv::Reader::from_reader(dir.text("paper/table1.csv").leak().as_bytes());
    let names = table.headers().unwrap().clone();
    let rows: Vec<csv::StringRecord> = table.records().map(Result::unwrap).collect();
    let cell = |row: usize, name: &str| {
        rows[row].get(names.iter().position(|one| one == name).unwrap()).unwrap().to_owned()
    };
    // Six numbers of each animal, in the order of the paper.
    let lines: Vec<Vec<&str>> =
        PRINTED_TABLE_1.lines().skip(2).map(|line| line.split(',').collect()).collect();
    assert_eq!(rows.len(), 6 * lines.len());
    for (index, line) in lines.iter().enumerate() {
        for (column, printed) in line.iter().skip(4).enumerate() {
            let row = 6 * index + column;
            assert_eq!(cell(row, "printed"), *printed, "{line:?}");
            let computed: f64 = cell(row, "computed").parse().unwrap();
            let decimals = printed.split_once('.').map_or(0, |(_, decimals)| decimals.len());
            let same_digits = format!("{computed:.decimals$}") == *printed;
            // E* of the mouse: the paper multiplies its rounded 0.354 MPa by 0.0209/62 * 6/2 * (0.032/0.002)^2 = 0.25889.
            let is_mouse = line[0] == "mouse" && column == 0;
            assert_eq!(same_digits, !is_mouse, "{line:?}: {computed}");
            assert_eq!(cell(row, "within_last_digit"), (!is_mouse).to_string(), "{line:?}");
            let from_rounded = cell(row, "computed_from_rounded");
            assert_eq!(from_rounded.is_empty(), !is_mouse, "{line:?}");
            if is_mouse {
                let by_hand = 0.354 * 0.0209 / 62.0 * 3.0 * 256.0;
                assert!(
                    (from_rounded.parse::<f64>().unwrap() / by_hand - 1.0).abs() < 1e-12,
                    "{from_rounded}"
                );
            }
            let difference: f64 = cell(row, "difference").parse().unwrap();
            assert!((computed - printed.parse::<f64>().unwrap() - difference).abs() < 1e-12);
        }
    }
}

#[test]
fn reproduce_writes_the_figures_of_plot() {
    let dir = TestDir::new();
    dir.run("reproduce --output-dir paper --format json").succeeded();
    for figure in ["fig4", "fig-c5"] {
        dir.run(&format!("plot {figure} -o {figure}.svg")).succeeded();
        assert_eq!(dir.read(&format!("paper/{figure}.svg")), dir.read(&format!("{figure}.svg")));
    }
}

#[test]
fn existing_files_are_replaced_only_with_force() {
    let dir = TestDir::new();
    // The last one of three: the others are not written either.
    dir.write("paper/fig-c5.svg", "mine");
    dir.run("reproduce -d paper")
        .usage_error()
        .wrote_nothing()
        .says(&["fig-c5.svg exists already: choose another folder with -d"]);
    dir.run("reproduce -d paper --force").succeeded();
    assert!(dir.text("paper/fig-c5.svg").starts_with("<svg") && dir.has("paper/table1.csv"));
    dir.run("reproduce --force").usage_error().says(&["--force needs -d"]);
}

#[test]
fn fig_1_is_not_drawn_and_the_message_says_what_it_needs() {
    let dir = TestDir::new();
    for call in ["plot fig1", "plot fig1 -o fig1.svg"] {
        let words = ["no equation gives", "sweep MODEL --grid", "docs/sweep.md"];
        dir.run(call).usage_error().wrote_nothing().says(&words);
    }
    dir.run("reproduce").succeeded().says(&["OpenSim Moco", "doi:10.5281/zenodo.20730121"]);
}
