//! What the spheres do, with a column for each group of spheres that do the same.

use std::collections::HashMap;

use osim_inspect::{Figure, Inspection, SphereFigures};
use osim_model::messages::{Dialect, Phrase, listed};

use super::rows::{FigureText, Spheres, exact_key, heading, key, limit, value};
use super::standing::{CAPTION, equally_deep};
use crate::report::layout::{OUTSIDE, table, wrapped};

/// Figures of more groups of spheres than this go into a further table.
const GROUPS_ABREAST: usize = 4;

/// Names that are listed; more are counted.
const NAMED: usize = 6;

/// In place of a figure that is not known; its two blanks keep digits below digits.
const NOTHING: &str = "-  ";

/// Spheres that do the same, wherever they are.
struct Alike<'a> {
    names: Vec<&'a str>,
    first: &'a SphereFigures,
    mixed: bool,
}

/// The figures; empty if there are none and no reason is to be given.
pub(super) fn text(inspected: &Inspection, dialect: &dyn Dialect) -> String {
    let groups = groups(inspected);
    let mut text = String::new();
    if let Some(why) = &inspected.figures.why_no_body_weight {
        text.push_str(&wrapped(&format!("no figures under body weight: {why}"), ""));
    }
    if !groups.is_empty() {
        text.push_str("What the spheres do (BW: body weight, on one limb unless you say otherwise):\n");
    }
    for (number, chunk) in groups.chunks(GROUPS_ABREAST).enumerate() {
        for (index, group) in chunk.iter().enumerate() {
            let label = format!("S{}", number * GROUPS_ABREAST + index + 1);
            text.push_str(&wrapped(&format!("{label}  {}", listed(&group.names, NAMED)), "    "));
        }
        text.push('\n');
        text.push_str(&sheet(inspected, chunk, number * GROUPS_ABREAST));
    }
    text.push_str(&standing(inspected));
    if text.contains(OUTSIDE) {
        let more = Phrase::template("outside the limit: `check MODEL` says more").spelled(dialect);
        text.push_str(&format!("  ({OUTSIDE} {more})\n"));
    }
    text
}

/// The spheres at their own heights, where these differ.
fn standing(inspected: &Inspection) -> String {
    let rows = equally_deep(&inspected.figures);
    if rows.is_empty() {
        return String::new();
    }
    let mut table = table(&["limb", "Hertz", "model's law", "spheres"]);
    for row in rows {
        let [hertz, model_law] = &row.indentation;
        table.add_row([row.limb, hertz, model_law, &listed(&row.spheres, NAMED)]);
    }
    table.right_aligned(&[1, 2]);
    format!("\n{}{}\n", wrapped(&format!("{CAPTION}:"), ""), table.trim_fmt())
}

fn groups(inspected: &Inspection) -> Vec<Alike<'_>> {
    let mut groups: Vec<Alike<'_>> = Vec::new();
    let (mut places, mut exact) = (HashMap::new(), HashMap::new());
    for limb in &inspected.figures.limbs {
        let mixed = limb.is_mixed();
        for sphere in &limb.spheres {
            let found = || *places.entry(key(sphere)).or_insert(groups.len());
            let place = *exact.entry(exact_key(sphere)).or_insert_with(found);
            match groups.get_mut(place) {
                Some(group) => group.names.push(&sphere.sphere),
                None => groups.push(Alike { names: vec![&sphere.sphere], first: sphere, mixed }),
            }
        }
    }
    groups
}

fn sheet(inspected: &Inspection, groups: &[Alike<'_>], before: usize) -> String {
    let labels = (1..=groups.len()).map(|index| format!("S{}", before + index));
    let header: Vec<String> = ["figure".to_owned(), "limit".to_owned()].into_iter().chain(labels).collect();
    let mut table = table(&header.iter().map(String::as_str).collect::<Vec<_>>());
    let mixed = groups.iter().any(|group| group.mixed);
    for figure in Spheres::new(mixed, groups.iter().map(|group| group.first)).figures() {
        let values: Vec<String> = groups.iter().map(|group| cell(figure, group.first)).collect();
        if values.iter().all(|value| value == NOTHING) {
            continue;
        }
        let name = heading(figure, inspected.figures.impact_speed_m_s);
        table.add_row([vec![name, limit(figure)], values].concat());
    }
    table.right_aligned(&(2..2 + groups.len()).collect::<Vec<_>>());
    format!("{}\n", table.trim_fmt())
}

fn cell(figure: Figure, sphere: &SphereFigures) -> String {
    match value(figure, sphere) {
        None => NOTHING.to_owned(),
        Some(FigureText { text, outside: false }) => format!("{text}  "),
        Some(FigureText { text, outside: true }) => format!("{text} {OUTSIDE}"),
    }
}
