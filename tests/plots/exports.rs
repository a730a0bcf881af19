//! Figures for journals and other programs: PDF in its true size, labels, ranges, and tables of the drawn numbers.

use std::process::Command;

use crate::document::Svg;
use crate::support::{HUMAN, TestDir, report_skip};

/// The output of a program of the package poppler; `None` after reporting that the program is missing.
fn run_poppler(test: &str, program: &str, dir: &TestDir, arguments: &[&str]) -> Option<String> {
    match Command::new(program).args(arguments).current_dir(dir.path("")).output() {
        Ok(output) => {
            assert!(output.status.success(), "{program}: {}", String::from_utf8_lossy(&output.stderr));
            Some(String::from_utf8(output.stdout).unwrap())
        }
        Err(_) => {
            report_skip(test, &format!("{program} is missing: dev/install.sh programs"));
            None
        }
    }
}

#[test]
fn a_pdf_has_its_true_width_embedded_fonts_and_text() {
    let test = "a PDF in readers of PDF";
    let dir = TestDir::with(&[HUMAN]);
    for (kind, words) in [
        ("force human.osim --width 85", "smoothed, at rest (C.9)"),
        ("drop human.osim --width 85 --font-size 9", "body weight"),
        ("sweep human.osim --quantity peak-force --width 85", "human now"),
        ("feet human.osim --width 85", "sphere"),
    ] {
        dir.run(&format!("plot {kind} -o figure.pdf --force")).succeeded().wrote(&["figure.pdf"]);
        let Some(info) = run_poppler(test, "pdfinfo", &dir, &["figure.pdf"]) else { return };
        let size = info.lines().find_map(|line| line.strip_prefix("Page size:")).unwrap();
        let width: f64 = size.split_whitespace().next().unwrap().parse().unwrap();
        // 85 mm in points of 1/72 inch.
        assert!((width - 85.0 / 25.4 * 72.0).abs() < 0.05, "{kind}: {size}");
        assert!(info.contains("Pages:           1"), "{info}");
        let Some(fonts) = run_poppler(test, "pdffonts", &dir, &["figure.pdf"]) else { return };
        let fonts: Vec<&str> = fonts.lines().skip(2).collect();
        // Columns: name, type of two words, encoding, embedded, subset, unicode.
        let is_embedded = |font: &&str| font.contains("Arimo") && font.contains("yes yes yes");
        assert!(!fonts.is_empty() && fonts.iter().all(is_embedded), "{kind}: {fonts:?}");
        let Some(text) = run_poppler(test, "pdftotext", &dir, &["figure.pdf", "-"]) else { return };
        assert!(text.contains(words), "{kind}: {text}");
    }
}

#[test]
fn labels_ranges_and_width_follow_the_options() {
    let dir = TestDir::with(&[HUMAN, ("table1/mouse_smooth_sphere.osim", "mouse.osim")]);
    let looks = "--label Human --label Mouse --x-range -0.1..0.3 --y-range 0..2 --width 120 --title \"\"";
    dir.run(&format!("plot force human.osim mouse.osim --stance-limbs 1 {looks} -o a.svg")).succeeded();
    let text = dir.text("a.svg");
    let svg = Svg::read(&text);
    svg.says(&["Human", "Mouse", "0.3", "2.0"]);
    assert!(!svg.texts.iter().any(|text| text == "Contact force" || text == "mouse"), "{:?}", svg.texts);
    assert_eq!(svg.attribute("width"), "120mm");
    assert!(!text.contains(" id=") && !text.contains("url("));
    let assert_refused = |arguments: &str, words: &[&str]| {
        let run = dir.run(&format!("plot {arguments} -o b.svg"));
        run.wrote_nothing().says(words);
    };
    assert_refused("force human.osim --label a --label b --label c --label d", &["3 curves", "'Hertz (1)'"]);
    assert_refused("drop human.osim --x-range 0..1", &["no single horizontal axis", "--duration"]);
    assert_refused("force human.osim --x-range 1..0", &["FROM..TO"]);
    assert_refused("force human.osim --width 5", &["20 to 1000"]);
    assert_refused("force human.osim --width 30 --font-size 20", &["too narrow", "at least"]);
    assert_refused("force human.osim --data numbers.txt", &["ends in .csv"]);
}

/// The points of the curve `name` in the table of a figure.
fn curve_in_table(table: &str, name: &str) -> Vec<(f64, f64)> {
    let mut reader = csv::Reader::from_reader(table.as_bytes());
    let header: Vec<String> = reader.headers().unwrap().iter().map(str::to_owned).collect();
    let cell = |record: &csv::StringRecord, column: &str| {
        record[header.iter().position(|name_in_header| name_in_header == column).unwrap()].to_owned()
    };
    let records = reader.records().map(|record| record.unwrap());
    records
        .filter(|record| cell(record, "kind") == "curve" && cell(record, "name") == name)
        .map(|record| (cell(&record, "x").parse().unwrap(), cell(&record, "y").parse().unwrap()))
        .collect()
}

/// The height of a curve at `x`, between the two nearest points.
fn value_at(curve: &[(f64, f64)], x: f64) -> f64 {
    let pair = curve.windows(2).find(|pair| pair[0].0 <= x && x <= pair[1].0).unwrap();
    let [(x0, y0), (x1, y1)] = *pair else { unreachable!() };
    if x1 == x0 { y1 } else { y0 + (y1 - y0) * (x - x0) / (x1 - x0) }
}

#[test]
fn the_data_of_a_figure_agree_with_theory() {
    let dir = TestDir::new();
    dir.run("plot force falisse2022 -o a.svg --data a.csv").succeeded().wrote(&["a.csv", "a.svg"]);
    let table = dir.text("a.csv");
    let assert_near = |value: f64, expected: f64, within: f64| {
        assert!((value - expected).abs() < within, "{value}, expected {expected}");
    };
    // tests/plots/reference.py. Between two points the line is up to 2e-4 of the figure beside the curve: more, up and down,
    // where that is steep.
    assert_near(value_at(&curve_in_table(&table, "Hertz (1)"), 0.4999), 170.667, 0.1);
    assert_near(value_at(&curve_in_table(&table, "smoothed, at rest (C.9)"), 0.0), 7.498, 1e-3);
    assert_near(value_at(&curve_in_table(&table, "Hertz with cf (C.1)"), 0.0), 14.996, 1e-3);
    dir.run("plot fig4 -o b.svg --data b.csv").succeeded();
    let table = dir.text("b.csv");
    let mouse = curve_in_table(&table, "mouse");
    let peak = mouse.iter().map(|(_, force)| *force).fold(0.0, f64::max);
    // The mouse with the human's dissipation, with scaled dissipation in the other panels.
    assert_near(peak, 2.8396, 1e-3);
    assert_near(
        curve_in_table(&table, "giraffe").iter().map(|(_, force)| *force).fold(0.0, f64::max),
        2.6490,
        1e-3,
    );
    dir.run("plot sweep falisse2022 --quantity restitution -o c.svg --data c.csv").succeeded();
    assert_near(
        value_at(&curve_in_table(&dir.text("c.csv"), "exact, at the impact speed"), 2.0),
        0.549_401,
        5e-5,
    );
}

#[test]
fn the_drawn_peak_of_a_drop_is_the_computed_peak() {
    let dir = TestDir::with(&[HUMAN]);
    dir.run("plot drop human.osim -o a.svg --data a.csv").succeeded();
    let drawn =
        curve_in_table(&dir.text("a.csv"), "human").iter().map(|(_, force)| *force).fold(0.0, f64::max);
    let report = dir.run("drop-test human.osim --format json").succeeded();
    // The integrator finds the peak by itself, between its steps.
    let json: serde_json::Value = serde_json::from_str(report.out().lines().next().unwrap()).unwrap();
    let peak = find_number(&json, "peak_force_bw").unwrap();
    assert!((drawn / peak - 1.0).abs() < 1e-4, "{drawn}, peak {peak}");
}

fn find_number(json: &serde_json::Value, name: &str) -> Option<f64> {
    match json {
        serde_json::Value::Object(fields) => fields
            .get(name)
            .and_then(serde_json::Value::as_f64)
            .or_else(|| fields.values().find_map(|one| find_number(one, name))),
        serde_json::Value::Array(items) => items.iter().find_map(|one| find_number(one, name)),
        _ => None,
    }
}

#[test]
fn a_body_that_rests_deeper_than_its_radius_does_not_stretch_the_figure() {
    // A horse on the contacts of a mouse.
    let dir = TestDir::with(&[("table1/mouse_smooth_sphere.osim", "mouse.osim")]);
    dir.run("plot force mouse.osim --mass 2 --stance-limbs 1 -o a.svg --data a.csv").succeeded();
    let table = dir.text("a.csv");
    assert!(table.contains("outside the figure"), "{table}");
    let end = curve_in_table(&table, "Hertz (1)").last().unwrap().0;
    assert!((end - 1.0).abs() < 1e-9, "{end}");
}

#[test]
fn a_column_of_a_table_becomes_a_map_or_a_curve() {
    let dir = TestDir::new();
    let mut table = "file,grid_stiffness,grid_dissipation,speed\n".to_owned();
    for (i, stiffness) in [1e5, 1e6, 1e7].into_iter().enumerate() {
        for (j, dissipation) in [0.5, 1.0, 2.0].into_iter().enumerate() {
            let speed = if i == 2 && j == 2 { String::new() } else { format!("{}", i + 10 * j) };
            table.push_str(&format!("m{i}{j}.osim,{stiffness},{dissipation},{speed}\n"));
        }
    }
    dir.write("sweep.csv", &table);
    let run =
        dir.run("plot sweep --table sweep.csv --value-column speed -o map.svg --data map.csv").succeeded();
    run.wrote(&["map.csv", "map.svg"]);
    let svg = Svg::read(&dir.text("map.svg"));
    svg.says(&["speed: sweep", "grid_stiffness", "grid_dissipation", "speed", "no value", "10⁶"]);
    assert!(dir.text("map.csv").contains("cell,,grid_stiffness,1000000,grid_dissipation,2,speed,21"));
    dir.run("plot sweep --table sweep.csv --value-column speed --value-range 5..15 -o limited.svg")
        .succeeded();
    Svg::read(&dir.text("limited.svg")).says(&["15 and more", "5 and less"]);
    dir.write("one.csv", "grid_radius,speed\n0.03,2\n0.01,1\n0.02,1.5\n");
    dir.run("plot sweep --table one.csv --value-column speed -o curve.svg --data curve.csv").succeeded();
    assert_eq!(curve_in_table(&dir.text("curve.csv"), ""), [(0.01, 1.0), (0.02, 1.5), (0.03, 2.0)]);
    let assert_refused = |arguments: &str, words: &[&str]| {
        dir.run(&format!("plot {arguments} -o b.svg")).wrote_nothing().says(words);
    };
    assert_refused("sweep --table sweep.csv", &["--value-column"]);
    assert_refused("sweep --table sweep.csv --value-column cost", &["no column 'cost'", "'speed'"]);
    assert_refused("force --table sweep.csv --value-column speed", &["plot sweep"]);
    assert_refused("sweep falisse2022 --table sweep.csv --value-column speed", &["leave out models"]);
    assert_refused("sweep --table missing.csv --value-column speed", &["missing.csv"]);
    dir.write("twice.csv", "grid_a,grid_b,grid_c,speed\n1,1,1,2\n1,1,2,3\n2,2,2,3\n");
    assert_refused(
        "sweep --table twice.csv --value-column speed --x-column grid_a --y-column grid_b",
        &["several rows are about grid_a = 1, 1"],
    );
}
