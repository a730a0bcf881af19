//! The pictures in docs/ are equal to those that the commands on the pages draw. Every picture is on a page, and every kind of plot has
//! a command.

use std::path::Path;

use crate::support::{TestDir, root};

/// Fixtures that the commands on the pages read.
const FIXTURES: [&str; 7] = [
    "fixtures/table1",
    "fixtures/drawn_feet",
    "fixtures/feet",
    "fixtures/feet/Geometry",
    "fixtures/contact_tables",
    "fixtures/scale_tool",
    "fixtures/plots",
];

/// Calls in `page` that write a figure: the name of the picture, and the arguments of the call.
fn calls_that_draw(page: &str) -> Vec<(String, String)> {
    let lines = page.lines().filter_map(|line| line.strip_prefix("$ osim-contact-scale "));
    lines
        .filter_map(|call| call.split_once(" -o "))
        .map(|(call, rest)| {
            let (name, more) = rest.split_once(' ').unwrap_or((rest, ""));
            (name.to_owned(), format!("{call} {more}"))
        })
        .collect()
}

/// Asserts that both pictures are equal. Numbers may differ by one drawing unit (1/20 pt), because sines differ between systems.
#[track_caller]
fn assert_same_picture(drawn_svg: &str, committed: &str, name: &str) {
    let pieces_of = |text: &str| -> Vec<String> {
        text.split(|c: char| " \"<>,M\n".contains(c))
            .filter(|piece| !piece.is_empty())
            .map(str::to_owned)
            .collect()
    };
    let (drawn_svg, committed) = (pieces_of(drawn_svg), pieces_of(committed));
    assert_eq!(drawn_svg.len(), committed.len(), "{name} is not what the command draws");
    for (new, old) in drawn_svg.iter().zip(&committed) {
        let close = || Some((new.parse::<f64>().ok()? - old.parse::<f64>().ok()?).abs() <= 1.0);
        assert!(new == old || close() == Some(true), "{name}: {new}, but {old} in docs/plots");
    }
}

/// To draw the pictures again: `PLOTS=overwrite cargo test --test plots`, then look at the pictures.
#[test]
fn the_pictures_are_those_that_the_commands_draw() {
    let dir = TestDir::new();
    for folder in FIXTURES {
        let entries = std::fs::read_dir(root().join(folder)).unwrap().map(|entry| entry.unwrap().path());
        for path in entries.filter(|path| path.is_file()) {
            let name = format!("{folder}/{}", path.file_name().unwrap().to_string_lossy());
            dir.write(&name, std::fs::read(&path).unwrap());
        }
    }
    for (page, least) in [("docs/plots.md", 8), ("docs/add.md", 2), ("docs/tutorial.md", 2)] {
        let count = assert_pictures_of_page_are_current(&dir, page);
        assert!(count >= least, "{page} draws {count} figures");
    }
}

/// Runs the calls of a page that write files, in their order, compares the pictures with those in the documentation, and counts them.
#[track_caller]
fn assert_pictures_of_page_are_current(dir: &TestDir, page: &str) -> usize {
    let text = std::fs::read_to_string(root().join(page)).unwrap();
    let overwrite = std::env::var("PLOTS").is_ok_and(|value| value == "overwrite");
    let mut count = 0;
    for (name, call) in calls_that_draw(&text) {
        let is_picture = name.ends_with(".svg");
        let run = dir.run(&format!("{call} -o {name}"));
        if !is_picture {
            continue; // Models are compared elsewhere; a call that is refused is text of the page.
        }
        run.succeeded();
        assert!(dir.path(&name).is_file(), "{name}");
        count += 1;
        let drawn_svg = dir.text(&name);
        assert!(drawn_svg.len() < 200_000, "{name} has {} bytes", drawn_svg.len());
        let committed = root().join("docs/plots").join(Path::new(&name));
        if overwrite {
            std::fs::write(&committed, &drawn_svg).unwrap();
        }
        let committed_svg =
            std::fs::read_to_string(&committed).unwrap_or_else(|error| panic!("docs/plots/{name}: {error}"));
        assert_same_picture(&drawn_svg, &committed_svg, &name);
        assert!(text.contains(&format!("](plots/{name})")), "{page} does not show {name}");
    }
    count
}

/// The text of README.md and of all pages in docs/, folders included.
fn text_of_all_pages() -> String {
    let mut text = std::fs::read_to_string(root().join("README.md")).unwrap();
    append_pages(&root().join("docs"), &mut text);
    text
}

fn append_pages(folder: &Path, text: &mut String) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            append_pages(&path, text);
        } else if path.extension().is_some_and(|extension| extension == "md") {
            text.push_str(&std::fs::read_to_string(&path).unwrap());
        }
    }
}

#[test]
fn every_picture_is_on_a_page() {
    let pages = text_of_all_pages();
    for folder in ["plots", "report"] {
        for entry in std::fs::read_dir(root().join("docs").join(folder)).unwrap() {
            let name = entry.unwrap().file_name().to_string_lossy().into_owned();
            assert!(pages.contains(&format!("{folder}/{name})")), "no page shows docs/{folder}/{name}");
        }
    }
}

#[test]
fn every_kind_of_plot_has_a_command_in_the_documentation() {
    let schema = std::fs::read_to_string(root().join("schemas/requests/plot.schema.json")).unwrap();
    let schema: serde_json::Value = serde_json::from_str(&schema).unwrap();
    let kinds = schema.to_string();
    let page = std::fs::read_to_string(root().join("docs/plots.md")).unwrap();
    for kind in ["force", "state", "loop", "drop", "sweep", "feet", "fig4", "fig-c5"] {
        assert!(kinds.contains(&format!("\"{kind}\"")), "{kind} is a kind no more");
        assert!(
            page.contains(&format!("$ osim-contact-scale plot {kind} ")),
            "docs/plots.md does not draw {kind}"
        );
    }
}
