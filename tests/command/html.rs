//! Reads an HTML page as a browser would, and checks its structure.

use std::collections::BTreeSet;

use quick_xml::Reader;
use quick_xml::events::{BytesStart, Event};

/// Names of elements without an end tag.
const ELEMENTS_WITHOUT_END: [&str; 3] = ["meta", "br", "wbr"];
/// Names of elements that begin a new line of text.
const ELEMENTS_ON_NEW_LINE: [&str; 18] = [
    "h1",
    "h2",
    "h3",
    "h4",
    "h5",
    "p",
    "li",
    "tr",
    "caption",
    "pre",
    "dt",
    "dd",
    "figcaption",
    "figure",
    "details",
    "summary",
    "section",
    "title",
];

/// The text of an HTML page, and the parts of the page that tests count.
#[derive(Debug, Default)]
pub(crate) struct Html {
    /// Text of the page: a line for each block, with titles of plots in brackets.
    pub(crate) text: String,
    /// Levels of the page's headings.
    pub(crate) headings: Vec<u8>,
    pub(crate) plots: usize,
    pub(crate) details: usize,
    ids: BTreeSet<String>,
    links: Vec<String>,
    labels: Vec<String>,
}

impl Html {
    /// Reads a page and fails if it is not well formed, or if a browser would load something.
    #[track_caller]
    pub(crate) fn parse_and_check(page: &str) -> Self {
        let mut html = Self::default();
        let mut open: Vec<String> = Vec::new();
        let mut reader = Reader::from_str(page);
        reader.config_mut().check_end_names = false;
        reader.config_mut().allow_unmatched_ends = true;
        loop {
            match reader.read_event().expect("the page can be read") {
                Event::Start(tag) => {
                    let name = html.begin_element(&tag, &open);
                    if !ELEMENTS_WITHOUT_END.contains(&name.as_str()) {
                        open.push(name);
                    }
                }
                Event::Empty(tag) => {
                    html.begin_element(&tag, &open);
                }
                Event::End(tag) => {
                    let name = tag.name().into_inner().to_owned();
                    assert_eq!(open.pop().as_deref(), Some(name.as_str()), "crossed: {open:?}");
                    if name == "svg" {
                        html.text.push(']');
                    }
                    if matches!(name.as_str(), "th" | "td") {
                        html.text.push_str(" | ");
                    }
                }
                Event::Text(text) => html.add_text(&text, &open),
                Event::GeneralRef(name) => {
                    let letter = match &*name {
                        "amp" => "&",
                        "lt" => "<",
                        "gt" => ">",
                        "quot" => "\"",
                        other => panic!("&{other};"),
                    };
                    html.add_text(letter, &open);
                }
                Event::Eof => break,
                _ => {}
            }
        }
        assert!(open.is_empty(), "left open: {open:?}");
        html.check_structure();
        html
    }

    fn begin_element(&mut self, tag: &BytesStart<'_>, open: &[String]) -> String {
        let name = tag.name().into_inner().to_owned();
        let mut attribute_names = BTreeSet::new();
        for attribute in tag.html_attributes() {
            let attribute = attribute.expect("attributes are well formed");
            let (key, value) = (attribute.key.into_inner(), attribute.value.to_string());
            attribute_names.insert(key.to_owned());
            match key {
                "id" => assert!(self.ids.insert(value.clone()), "the id {value} is there twice"),
                "href" if name == "a" => self.links.push(value),
                "aria-labelledby" => self.labels.push(value),
                "href" | "src" | "srcset" | "poster" | "data" => panic!("<{name}> would load {value}"),
                _ => assert!(!key.starts_with("on"), "<{name}> has a script"),
            }
        }
        assert!(
            !["script", "link", "iframe", "object", "img"].contains(&name.as_str()),
            "there is a <{name}>"
        );
        if name == "th" {
            assert!(attribute_names.contains("scope"), "a header of a table without scope");
        }
        if name == "html" {
            assert!(attribute_names.contains("lang"));
        }
        if let Some(level) = name.strip_prefix('h').and_then(|level| level.parse().ok()) {
            self.headings.push(level);
        }
        if name == "svg" {
            self.plots += 1;
            self.text.push_str("\n[plot ");
        } else if name == "details" {
            self.details += 1;
        }
        if ELEMENTS_ON_NEW_LINE.contains(&name.as_str()) && !open.iter().any(|outer| outer == "svg") {
            self.text.push('\n');
        }
        name
    }

    fn add_text(&mut self, text: &str, open: &[String]) {
        let inside = |name: &str| open.iter().any(|outer| outer == name);
        if inside("style") || (inside("svg") && open.last().is_none_or(|name| name != "title")) {
            return;
        }
        self.text.push_str(text);
    }

    fn check_structure(&mut self) {
        assert_eq!(self.headings.iter().filter(|level| **level == 1).count(), 1, "one h1");
        for pair in self.headings.windows(2) {
            assert!(pair[1] <= pair[0] + 1, "a heading is left out: {:?}", self.headings);
        }
        for link in &self.links {
            match link.strip_prefix('#') {
                Some(id) => assert!(self.ids.contains(id), "the link {link} leads nowhere"),
                None => assert!(link.starts_with("https://doi.org/"), "a link to {link}"),
            }
        }
        for label in &self.labels {
            assert!(self.ids.contains(label), "the label {label} is not there");
        }
        let lines = self.text.lines().map(|line| line.trim_end().trim_end_matches('|').trim_end());
        self.text = lines.filter(|line| !line.is_empty()).collect::<Vec<_>>().join("\n");
    }
}
