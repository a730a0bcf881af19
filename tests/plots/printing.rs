//! What journals and other programs are given: PDF in its true size, names, limits, and the numbers that are drawn.

use std::process::Command;

use crate::document::Svg;
use crate::support::{Bench, HUMAN, skipped};

/// What a program of poppler says of a file; `None` where the program is missing, which is said.
fn poppler(test: &str, program: &str, bench: &Bench, arguments: &[&str]) -> Option<String> {
    match Command::new(program).args(arguments).current_dir(bench.path("")).output() {
        Ok(output) => {
            assert!(output.status.success(), "{program}: {}", String::from_utf8_lossy(&output.stderr));
            Some(String::from_utf8(output.stdout).unwrap())
        }
        Err(_) => {
            skipped(test, &format!("{program} is missing: dev/install.sh programs"));
            None
        }
    }
}

#[test]
fn a_pdf_of_85_mm_is_85_mm_wide_with_its_fonts_and_its_text() {
    let test = "a PDF in readers of PDF";
    let bench = Bench::with(&[HUMAN]);
    for (kind, words) in [
        ("force human.osim --width 85", "smoothed, at rest (C.9)"),
        ("drop human.osim --width 85 --font-size 9", "body weight"),
        ("sweep human.osim --quantity peak-force --width 85", "human now"),
        ("feet human.osim --width 85", "sphere"),
    ] {
        bench.run(&format!("plot {kind} -o figure.pdf --force")).done().wrote(&["figure.pdf"]);
        let Some(info) = poppler(test, "pdfinfo", &bench, &["figure.pdf"]) else { return };
        let size = info.lines().find_map(|line| line.strip_prefix("Page size:")).unwrap();
        let width: f64 = size.split_whitespace().next().unwrap().parse().unwrap();
        // 85 mm in points of 1/72 inch.
        assert!((width - 85.0 / 25.4 * 72.0).abs() < 0.05, "{kind}: {size}");
        assert!(info.contains("Pages:           1"), "{info}");
        let Some(fonts) = poppler(test, "pdffonts", &bench, &["figure.pdf"]) else { return };
        let fonts: Vec<&str> = fonts.lines().skip(2).collect();
        // Columns: name, type of two words, encoding, embedded, subset, unicode.
        let is_there = |font: &&str| font.contains("Arimo") && font.contains("yes yes yes");
        assert!(!fonts.is_empty() && fonts.iter().all(is_there), "{kind}: {fonts:?}");
        let Some(text) = poppler(test, "pdftotext", &bench, &["figure.pdf", "-"]) else { return };
        assert!(text.contains(words), "{kind}: {text}");
    }
}

#[test]
fn names_limits_and_paper_are_those_asked_for() {
    let bench = Bench::with(&[HUMAN, ("table1/mouse_smooth_sphere.osim", "mouse.osim")]);
    let looks = "--label Human --label Mouse --x-range -0.1..0.3 --y-range 0..2 --width 120 --title \"\"";
    bench.run(&format!("plot force human.osim mouse.osim --stance-limbs 1 {looks} -o a.svg")).done();
    let text = bench.text("a.svg");
    let svg = Svg::read(&text);
    svg.says(&["Human", "Mouse", "0.3", "2.0"]);
    assert!(!svg.texts.iter().any(|text| text == "Contact force" || text == "mouse"), "{:?}", svg.texts);
    assert_eq!(svg.attribute("width"), "120mm");
    assert!(!text.contains(" id=") && !text.contains("url("));
    let refused = |arguments: &str, words: &[&str]| {
        let ran = bench.run(&format!("plot {arguments} -o b.svg"));
        ran.wrote_nothing().says(words);
    };
    refused("force human.osim --label a --label b --label c --label d", &["3 curves", "'Hertz (1)'"]);
    refused("drop human.osim --x-range 0..1", &["no single horizontal axis", "--duration"]);
    refused("force human.osim --x-range 1..0", &["FROM..TO"]);
    refused("force human.osim --width 5", &["20 to 1000"]);
    refused("force human.osim --width 30 --font-size 20", &["too narrow", "at least"]);
    refused("force human.osim --data numbers.txt", &["ends in .csv"]);
}

/// Rows of the table that belong to a curve, as numbers.
fn curve(table: &str, name: &str) -> Vec<(f64, f64)> {
    let mut reader = csv::Reader::from_reader(table.as_bytes());
    let header: Vec<String> = reader.headers().unwrap().iter().map(str::to_owned).collect();
    let of = |record: &csv::StringRecord, column: &str| {
        record[header.iter().position(|known| known == column).unwrap()].to_owned()
    };
    let records = reader.records().map(|record| record.unwrap());
    records
        .filter(|record| of(record, "kind") == "curve" && of(record, "name") == name)
        .map(|record| (of(&record, "x").parse().unwrap(), of(&record, "y").parse().unwrap()))
        .collect()
}

/// Where a curve of straight lines is at `x`.
fn at(curve: &[(f64, f64)], x: f64) -> f64 {
    let pair = curve.windows(2).find(|pair| pair[0].0 <= x && x <= pair[1].0).unwrap();
    let [(x0, y0), (x1, y1)] = *pair else { unreachable!() };
    if x1 == x0 { y1 } else { y0 + (y1 - y0) * (x - x0) / (x1 - x0) }
}

#[test]
fn the_table_of_a_figure_holds_the_numbers_of_theory() {
    let bench = Bench::new();
    bench.run("plot force falisse2022 -o a.svg --data a.csv").done().wrote(&["a.csv", "a.svg"]);
    let table = bench.text("a.csv");
    let near = |seen: f64, expected: f64, within: f64| {
        assert!((seen - expected).abs() < within, "{seen}, expected {expected}");
    };
    // tests/plots/reference.py. Between two points the line is up to 2e-4 of the figure beside the curve: more, up and down,
    // where that is steep.
    near(at(&curve(&table, "Hertz (1)"), 0.4999), 170.667, 0.1);
    near(at(&curve(&table, "smoothed, at rest (C.9)"), 0.0), 7.498, 1e-3);
    near(at(&curve(&table, "Hertz with cf (C.1)"), 0.0), 14.996, 1e-3);
    bench.run("plot fig4 -o b.svg --data b.csv").done();
    let table = bench.text("b.csv");
    let mouse = curve(&table, "mouse");
    let peak = mouse.iter().map(|(_, force)| *force).fold(0.0, f64::max);
    // The mouse with the human's dissipation, with scaled dissipation in the other panels.
    near(peak, 2.8396, 1e-3);
    near(curve(&table, "giraffe").iter().map(|(_, force)| *force).fold(0.0, f64::max), 2.6490, 1e-3);
    bench.run("plot sweep falisse2022 --quantity restitution -o c.svg --data c.csv").done();
    near(at(&curve(&bench.text("c.csv"), "exact, at the impact speed"), 2.0), 0.549_401, 5e-5);
}

#[test]
fn peaks_of_a_drop_are_peaks_and_no_corners() {
    let bench = Bench::with(&[HUMAN]);
    bench.run("plot drop human.osim -o a.svg --data a.csv").done();
    let drawn = curve(&bench.text("a.csv"), "human").iter().map(|(_, force)| *force).fold(0.0, f64::max);
    let report = bench.run("drop-test human.osim --format json").done();
    // The integrator finds the peak by itself, between its steps.
    let json: serde_json::Value = serde_json::from_str(report.out().lines().next().unwrap()).unwrap();
    let peak = find(&json, "peak_force_bw").unwrap();
    assert!((drawn / peak - 1.0).abs() < 1e-4, "{drawn}, peak {peak}");
}

fn find(json: &serde_json::Value, name: &str) -> Option<f64> {
    match json {
        serde_json::Value::Object(fields) => fields
            .get(name)
            .and_then(serde_json::Value::as_f64)
            .or_else(|| fields.values().find_map(|one| find(one, name))),
        serde_json::Value::Array(items) => items.iter().find_map(|one| find(one, name)),
        _ => None,
    }
}

#[test]
fn a_body_that_rests_deeper_than_its_radius_does_not_stretch_the_figure() {
    // A horse on the contacts of a mouse.
    let bench = Bench::with(&[("table1/mouse_smooth_sphere.osim", "mouse.osim")]);
    bench.run("plot force mouse.osim --mass 2 --stance-limbs 1 -o a.svg --data a.csv").done();
    let table = bench.text("a.csv");
    assert!(table.contains("outside the figure"), "{table}");
    let end = curve(&table, "Hertz (1)").last().unwrap().0;
    assert!((end - 1.0).abs() < 1e-9, "{end}");
}

#[test]
fn a_column_of_a_table_becomes_a_map_or_a_curve() {
    let bench = Bench::new();
    let mut table = "file,grid_stiffness,grid_dissipation,speed\n".to_owned();
    for (i, stiffness) in [1e5, 1e6, 1e7].into_iter().enumerate() {
        for (j, dissipation) in [0.5, 1.0, 2.0].into_iter().enumerate() {
            let speed = if i == 2 && j == 2 { String::new() } else { format!("{}", i + 10 * j) };
            table.push_str(&format!("m{i}{j}.osim,{stiffness},{dissipation},{speed}\n"));
        }
    }
    bench.write("sweep.csv", &table);
    let ran = bench.run("plot sweep --table sweep.csv --value-column speed -o map.svg --data map.csv").done();
    ran.wrote(&["map.csv", "map.svg"]);
    let svg = Svg::read(&bench.text("map.svg"));
    svg.says(&["speed: sweep", "grid_stiffness", "grid_dissipation", "speed", "no value", "10⁶"]);
    assert!(bench.text("map.csv").contains("cell,,grid_stiffness,1000000,grid_dissipation,2,speed,21"));
    bench.run("plot sweep --table sweep.csv --value-column speed --value-range 5..15 -o limited.svg").done();
    Svg::read(&bench.text("limited.svg")).says(&["15 and more", "5 and less"]);
    bench.write("one.csv", "grid_radius,speed\n0.03,2\n0.01,1\n0.02,1.5\n");
    bench.run("plot sweep --table one.csv --value-column speed -o curve.svg --data curve.csv").done();
    assert_eq!(curve(&bench.text("curve.csv"), ""), [(0.01, 1.0), (0.02, 1.5), (0.03, 2.0)]);
    let refused = |arguments: &str, words: &[&str]| {
        bench.run(&format!("plot {arguments} -o b.svg")).wrote_nothing().says(words);
    };
    refused("sweep --table sweep.csv", &["--value-column"]);
    refused("sweep --table sweep.csv --value-column cost", &["no column 'cost'", "'speed'"]);
    refused("force --table sweep.csv --value-column speed", &["plot sweep"]);
    refused("sweep falisse2022 --table sweep.csv --value-column speed", &["leave out models"]);
    refused("sweep --table missing.csv --value-column speed", &["missing.csv"]);
    bench.write("twice.csv", "grid_a,grid_b,grid_c,speed\n1,1,1,2\n1,1,2,3\n2,2,2,3\n");
    refused(
        "sweep --table twice.csv --value-column speed --x-column grid_a --y-column grid_b",
        &["several rows are about grid_a = 1, 1"],
    );
}
