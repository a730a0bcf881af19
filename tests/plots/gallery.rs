//! All pictures of the documentation on one page, made from the pages that explain them.

use crate::support::root;

const HEAD: &str = "\
# All figures and reports

Every kind of picture that the program makes, as small as it fits here; each leads to the page with the command that draws it
and what to look for. Those of `plot` are drawn again by each run of the tests, which fail if one is not what its command draws;
the pictures of reports are taken by a browser (`tests/browser`).

";

/// Pages with pictures, in the order of the gallery.
const PAGES: [&str; 3] = ["plots.md", "add.md", "report.md"];

struct Picture<'p> {
    alt: &'p str,
    path: &'p str,
    /// The heading above it.
    heading: &'p str,
}

/// The pictures of a page.
fn pictures(page: &str) -> Vec<Picture<'_>> {
    let mut heading = "";
    let mut pictures = Vec::new();
    for line in page.lines() {
        if let Some(text) = line.strip_prefix("## ").or(line.strip_prefix("### ")) {
            heading = text;
        }
        if let Some((alt, path)) =
            line.strip_prefix("![").and_then(|rest| rest.strip_suffix(')')?.split_once("]("))
        {
            pictures.push(Picture { alt, path, heading });
        }
    }
    pictures
}

/// How GitHub calls a heading in a link.
fn anchor(heading: &str) -> String {
    let plain = heading.chars().filter(|c| c.is_alphanumeric() || matches!(c, ' ' | '-' | '_'));
    plain.collect::<String>().to_lowercase().replace(' ', "-")
}

fn gallery() -> String {
    let mut text = HEAD.to_owned();
    for page in PAGES {
        let content = std::fs::read_to_string(root().join("docs").join(page)).unwrap();
        let title = content.lines().next().unwrap().trim_start_matches("# ");
        text.push_str(&format!("## {title}\n\n"));
        let found = pictures(&content);
        assert!(!found.is_empty(), "docs/{page} has no picture");
        for Picture { alt, path, heading } in found {
            let link =
                if heading.is_empty() { page.to_owned() } else { format!("{page}#{}", anchor(heading)) };
            assert!(root().join("docs").join(path).is_file(), "docs/{path}");
            text.push_str(&format!(
                "[{alt}]({link}):\n\n[<img src=\"{path}\" width=\"480\" alt=\"{alt}\">]({link})\n\n"
            ));
        }
    }
    format!("{}\n", text.trim_end())
}

/// To write it again: `PLOTS=overwrite cargo test --test plots`.
#[test]
fn the_gallery_has_every_picture() {
    let path = root().join("docs/gallery.md");
    let expected = gallery();
    if std::env::var("PLOTS").is_ok_and(|value| value == "overwrite") {
        std::fs::write(&path, &expected).unwrap();
    }
    let known = std::fs::read_to_string(&path).unwrap_or_default();
    assert_eq!(known.replace("\r\n", "\n"), expected, "docs/gallery.md is not made from the pages");
    for entry in std::fs::read_dir(root().join("docs/plots")).unwrap() {
        let name = entry.unwrap().file_name().to_string_lossy().into_owned();
        assert!(expected.contains(&format!("plots/{name}\"")), "no page shows docs/plots/{name}");
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
