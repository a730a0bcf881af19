//! Every picture of the documentation is shown by a page, and every kind of plot is drawn by a command of a page.

use std::path::Path;

use crate::support::root;

/// The text of README.md and of all pages in docs/, folders included.
fn pages() -> String {
    let mut text = std::fs::read_to_string(root().join("README.md")).unwrap();
    gather(&root().join("docs"), &mut text);
    text
}

fn gather(folder: &Path, text: &mut String) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            gather(&path, text);
        } else if path.extension().is_some_and(|extension| extension == "md") {
            text.push_str(&std::fs::read_to_string(&path).unwrap());
        }
    }
}

#[test]
fn every_picture_is_shown_by_a_page() {
    let pages = pages();
    for folder in ["plots", "report"] {
        for entry in std::fs::read_dir(root().join("docs").join(folder)).unwrap() {
            let name = entry.unwrap().file_name().to_string_lossy().into_owned();
            assert!(pages.contains(&format!("{folder}/{name})")), "no page shows docs/{folder}/{name}");
        }
    }
}

#[test]
fn every_kind_of_plot_is_drawn_by_a_command_of_the_documentation() {
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
