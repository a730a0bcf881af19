//! A plan as a table: equal changes share a row.

use osim_model::readable;
use osim_model::wording::one_line;
use osim_patch::{Change, Move, Plan};

use super::groups::{groups, whose};
use crate::layout::table;
use crate::messages::warnings;

/// What was taken, changed and noticed; `output` says the outcome. What the plan says is taken as it is spelled.
#[must_use]
pub fn text(plan: &Plan, model: &str, output: &str) -> String {
    let mut text = format!("{}\n", one_line(format!("{model}: {}", plan.taken)));
    if plan.is_empty() {
        text.push_str("nothing to change\n");
    } else {
        text.push('\n');
        for table in [changes(&plan.changes), moves(&plan.moves)] {
            if !table.is_empty() {
                text.push_str(&format!("{table}\n"));
            }
        }
    }
    for remark in &plan.remarks {
        text.push_str(&format!("note: {}\n", one_line(remark.to_string())));
    }
    text.push_str(&warnings(&plan.warnings));
    text.push_str(&format!("{}\n", one_line(output.to_owned())));
    text
}

/// The same in one line, for a run over many models.
#[must_use]
pub fn line(plan: &Plan, model: &str, output: &str) -> String {
    let masses = plan
        .masses
        .as_ref()
        .map(|masses| format!("{} -> {} kg, ", readable(masses.from.kg), readable(masses.target_mass_kg)));
    let mut codes: Vec<&str> = plan.warnings.iter().map(|warning| warning.code.as_str()).collect();
    codes.dedup();
    let warnings = if codes.is_empty() { String::new() } else { format!(" [{}]", codes.join(", ")) };
    let changes = plan.changes.len() + plan.moves.len();
    let line = format!("{model}: {}{changes} changes; {output}{warnings}", masses.unwrap_or_default());
    format!("{}\n", one_line(line))
}

fn changes(changes: &[Change]) -> String {
    if changes.is_empty() {
        return String::new();
    }
    let mut table = table(&["property", "of", "now", "new", "factor", "equation"]);
    for group in groups(changes) {
        let Some(first) = group.first() else { continue };
        let factor = first.factor.map(|factor| format!("x{}", readable(factor))).unwrap_or_default();
        let equation = if first.equation.starts_with(|c: char| c.is_ascii_digit() || c == 'A' || c == 'C') {
            format!("({})", first.equation)
        } else {
            first.equation.to_owned()
        };
        let new = if first.inserted {
            format!("{} +", readable(first.to))
        } else {
            format!("{}  ", readable(first.to))
        };
        table.add_row(vec![
            first.property.name().to_owned(),
            whose(&group),
            readable(first.from),
            new,
            factor,
            equation,
        ]);
    }
    table.right_aligned(&[2, 3, 4]);
    let mut text = table.trim_fmt();
    text.push('\n');
    if changes.iter().any(|change| change.inserted) {
        text.push_str("  (+ was not in the file: OpenSim's default applied; it is written out now)\n");
    }
    text
}

/// Sphere centres, one row each: they are rarely alike.
fn moves(moves: &[Move]) -> String {
    if moves.is_empty() {
        return String::new();
    }
    let mut table = table(&["centre of", "x", "y", "z", "new x", "new y", "new z", "by"]);
    for moved in moves {
        let mut cells = vec![moved.sphere.clone()];
        cells.extend(moved.from.iter().chain(&moved.to).map(|value| format!("{value:.5}")));
        cells.push(moved.equation.to_owned());
        table.add_row(cells);
    }
    table.right_aligned(&[1, 2, 3, 4, 5, 6]);
    format!("{}\n", table.trim_fmt())
}
