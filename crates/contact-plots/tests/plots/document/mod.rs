//! Test helper that reads the SVG of a figure with a strict XML reader.

use std::collections::HashSet;

use quick_xml::Reader;
use quick_xml::events::{BytesStart, Event};

/// The elements of a figure's SVG.
pub(crate) struct Svg {
    root: Vec<(String, String)>,
    pub(crate) title: String,
    pub(crate) description: String,
    /// The texts of the figure, without white space around them.
    pub(crate) texts: Vec<String>,
    places: Vec<(f64, f64)>,
    /// The lines of the figure, each with its colour.
    lines: Vec<(String, Vec<(f64, f64)>)>,
    /// Circles with the colour of their line; `None` for filled circles.
    circles: Vec<(Option<String>, Circle)>,
    /// Colours of filled shapes.
    pub(crate) fills: HashSet<String>,
}

impl Svg {
    #[track_caller]
    pub(crate) fn read(text: &str) -> Self {
        let mut reader = Reader::from_str(text);
        let mut svg = Self {
            root: vec![],
            title: String::new(),
            description: String::new(),
            texts: vec![],
            places: vec![],
            lines: vec![],
            circles: vec![],
            fills: HashSet::new(),
        };
        let mut open: Vec<String> = Vec::new();
        let mut content = String::new();
        loop {
            match reader.read_event().unwrap() {
                Event::Start(tag) => {
                    content.clear();
                    svg.element(&tag, open.is_empty());
                    open.push(name(&tag));
                }
                Event::Empty(tag) => svg.element(&tag, false),
                Event::Text(text) => content.push_str(text.as_ref()),
                Event::GeneralRef(entity) => content.push_str(match entity.as_ref() {
                    "lt" => "<",
                    "gt" => ">",
                    "amp" => "&",
                    "quot" => "\"",
                    "apos" => "'",
                    other => panic!("entity {other}"),
                }),
                Event::End(_) => {
                    let text = content.trim().to_owned();
                    match open.pop().as_deref() {
                        Some("title") => svg.title = text,
                        Some("desc") => svg.description = text,
                        Some("text") => svg.texts.push(text),
                        _ => {}
                    }
                }
                Event::Eof => break,
                other => panic!("unexpected {other:?}"),
            }
        }
        assert!(open.is_empty(), "unclosed: {open:?}");
        assert!(!svg.title.is_empty() && !svg.description.is_empty());
        svg
    }

    fn element(&mut self, tag: &BytesStart<'_>, is_root: bool) {
        let attributes: Vec<(String, String)> = tag
            .attributes()
            .map(|attribute| attribute.unwrap())
            .map(|a| (a.key.as_ref().to_owned(), a.value.to_string()))
            .collect();
        let get = |key: &str| attributes.iter().find(|(k, _)| k == key).map(|(_, v)| v.clone());
        match name(tag).as_str() {
            "svg" => assert!(is_root && get("viewBox").is_some()),
            "text" => self.places.push((number(&get("x").unwrap()), number(&get("y").unwrap()))),
            "polyline" => {
                let points = get("points").unwrap();
                let points = points.split_whitespace().map(|pair| pair.split_once(',').unwrap());
                let points = points.map(|(x, y)| (number(x), number(y))).collect();
                self.lines.push((get("stroke").unwrap(), points));
            }
            // Dashes of one curve, one after the other.
            "path" => {
                let pairs = get("d").unwrap().replace('M', " ");
                let points = pairs.split_whitespace().map(|pair| pair.split_once(',').unwrap());
                let points = points.map(|(x, y)| (number(x), number(y))).collect();
                self.lines.push((get("stroke").unwrap(), points));
            }
            "circle" => {
                let [x, y, radius] = ["cx", "cy", "r"].map(|key| number(&get(key).unwrap()));
                let stroke = get("stroke").filter(|stroke| stroke != "none");
                self.circles.push((stroke, Circle { centre: (x, y), radius }));
            }
            _ => {}
        }
        if let Some(fill) = get("fill").filter(|_| name(tag) == "rect") {
            self.fills.insert(fill);
        }
        if is_root {
            self.root = attributes;
        }
    }

    #[track_caller]
    pub(crate) fn says(&self, words: &[&str]) -> &Self {
        for word in words {
            assert!(self.texts.iter().any(|text| text == word), "'{word}' is not in {:?}", self.texts);
        }
        self
    }

    pub(crate) fn attribute(&self, key: &str) -> &str {
        self.root.iter().find(|(known, _)| known == key).map_or("", |(_, value)| value)
    }

    pub(crate) fn places_of(&self, text: &str) -> Vec<(f64, f64)> {
        let places = self.texts.iter().zip(&self.places);
        places.filter(|(known, _)| *known == text).map(|(_, place)| *place).collect()
    }

    #[track_caller]
    pub(crate) fn place_of(&self, text: &str) -> (f64, f64) {
        let index = self.texts.iter().position(|known| known == text).unwrap();
        self.places[index]
    }

    /// Circles whose line has this colour.
    pub(crate) fn circles(&self, colour: &str) -> Vec<Circle> {
        let circles = self.circles.iter().filter(|(stroke, _)| stroke.as_deref() == Some(colour));
        circles.map(|(_, circle)| *circle).collect()
    }

    /// The line of this colour with the most points.
    pub(crate) fn longest_line(&self, colour: &str) -> &[(f64, f64)] {
        let lines = self.lines.iter().filter(|(stroke, _)| stroke == colour);
        lines.map(|(_, points)| points.as_slice()).max_by_key(|points| points.len()).unwrap()
    }

    /// Curves of this colour in the order of the panels: lines of many points, dashed or not.
    pub(crate) fn curves(&self, colour: &str) -> Vec<&[(f64, f64)]> {
        let lines = self.lines.iter().filter(|(stroke, points)| stroke == colour && points.len() > 20);
        lines.map(|(_, points)| points.as_slice()).collect()
    }

    /// The scale of the horizontal axis, from its tick labels: the numbers in the lowest row.
    pub(crate) fn scale_of_x(&self) -> Scale {
        Scale::of(&self.ticks(|(_, y)| y, |(x, _)| x))
    }

    /// The scale of the vertical axis, from its tick labels.
    pub(crate) fn scale_of_y(&self) -> Scale {
        Scale::of(&self.ticks(|(x, _)| x, |(_, y)| y))
    }

    /// The numbers among the texts with the same coordinate `common`, each with its position along the axis.
    fn ticks(&self, common: fn((f64, f64)) -> f64, along: fn((f64, f64)) -> f64) -> Vec<(f64, f64)> {
        let number = |text: &String| text.replace('−', "-").parse::<f64>().ok();
        let all: Vec<((f64, f64), f64)> =
            self.texts.iter().zip(&self.places).filter_map(|(t, p)| number(t).map(|v| (*p, v))).collect();
        let row = all
            .iter()
            .map(|(place, _)| common(*place))
            .max_by_key(|at| all.iter().filter(|(place, _)| common(*place) == *at).count());
        all.iter().filter(|(p, _)| Some(common(*p)) == row).map(|(p, v)| (along(*p), *v)).collect()
    }
}

/// A circle on the page.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Circle {
    pub(crate) centre: (f64, f64),
    pub(crate) radius: f64,
}

/// Converts positions on the page to values.
pub(crate) struct Scale {
    pub(crate) from: (f64, f64),
    pub(crate) to: (f64, f64),
}

impl Scale {
    fn of(ticks: &[(f64, f64)]) -> Self {
        assert!(ticks.len() >= 3, "{ticks:?}");
        Self { from: ticks[0], to: ticks[ticks.len() - 1] }
    }

    pub(crate) fn value(&self, at: f64) -> f64 {
        let share = (at - self.from.0) / (self.to.0 - self.from.0);
        self.from.1 + share * (self.to.1 - self.from.1)
    }
}

fn name(tag: &BytesStart<'_>) -> String {
    tag.name().as_ref().to_owned()
}

fn number(text: &str) -> f64 {
    let value: f64 = text.parse().unwrap();
    assert!(value.is_finite());
    value
}
