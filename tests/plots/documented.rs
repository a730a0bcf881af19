//! The pictures in docs/ are those that the commands beside them draw.

use std::path::Path;

use crate::support::{Bench, root};

/// What the commands of the pages read.
const FIXTURES: [&str; 7] = [
    "fixtures/table1",
    "fixtures/drawn_feet",
    "fixtures/feet",
    "fixtures/feet/Geometry",
    "fixtures/contact_tables",
    "fixtures/scale_tool",
    "fixtures/plots",
];

/// Calls in `page` that write a figure: the name of the picture and the arguments before it.
fn calls(page: &str) -> Vec<(String, String)> {
    let lines = page.lines().filter_map(|line| line.strip_prefix("$ osim-contact-scale "));
    lines
        .filter_map(|call| call.split_once(" -o "))
        .map(|(call, rest)| {
            let (name, more) = rest.split_once(' ').unwrap_or((rest, ""));
            (name.to_owned(), format!("{call} {more}"))
        })
        .collect()
}

/// Numbers may differ by one drawing unit (1/20 pt): the last bit of a sine is the platform's.
#[track_caller]
fn assert_same_picture(seen: &str, committed: &str, name: &str) {
    let pieces = |text: &str| -> Vec<String> {
        text.split(|c: char| " \"<>,M\n".contains(c))
            .filter(|piece| !piece.is_empty())
            .map(str::to_owned)
            .collect()
    };
    let (seen, committed) = (pieces(seen), pieces(committed));
    assert_eq!(seen.len(), committed.len(), "{name} is not what the command draws");
    for (new, old) in seen.iter().zip(&committed) {
        let close = || Some((new.parse::<f64>().ok()? - old.parse::<f64>().ok()?).abs() <= 1.0);
        assert!(new == old || close() == Some(true), "{name}: {new}, but {old} in docs/plots");
    }
}

/// To draw them anew: `PLOTS=overwrite cargo test --test plots`, then look at them.
#[test]
fn pictures_are_current() {
    let bench = Bench::new();
    for folder in FIXTURES {
        let entries = std::fs::read_dir(root().join(folder)).unwrap().map(|entry| entry.unwrap().path());
        for path in entries.filter(|path| path.is_file()) {
            let name = format!("{folder}/{}", path.file_name().unwrap().to_string_lossy());
            bench.write(&name, std::fs::read(&path).unwrap());
        }
    }
    for (page, least) in [("docs/plots.md", 8), ("docs/add.md", 2), ("docs/tutorial.md", 2)] {
        let drawn = draws_its_pictures(&bench, page);
        assert!(drawn >= least, "{page} draws {drawn} figures");
    }
}

/// Runs the calls of a page that write something, in their order, and compares the pictures among it.
#[track_caller]
fn draws_its_pictures(bench: &Bench, page: &str) -> usize {
    let text = std::fs::read_to_string(root().join(page)).unwrap();
    let overwrite = std::env::var("PLOTS").is_ok_and(|value| value == "overwrite");
    let mut drawn = 0;
    for (name, call) in calls(&text) {
        let is_picture = name.ends_with(".svg");
        let ran = bench.run(&format!("{call} -o {name}"));
        if !is_picture {
            continue; // Models are compared elsewhere; a call that is refused is text of the page.
        }
        ran.done();
        assert!(bench.path(&name).is_file(), "{name}");
        drawn += 1;
        let seen = bench.text(&name);
        assert!(seen.len() < 200_000, "{name} has {} bytes", seen.len());
        let committed = root().join("docs/plots").join(Path::new(&name));
        if overwrite {
            std::fs::write(&committed, &seen).unwrap();
        }
        let known =
            std::fs::read_to_string(&committed).unwrap_or_else(|error| panic!("docs/plots/{name}: {error}"));
        assert_same_picture(&seen, &known, &name);
        assert!(text.contains(&format!("](plots/{name})")), "{page} does not show {name}");
    }
    drawn
}
