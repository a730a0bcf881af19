//! A plan as a table: equal changes share a row.

use std::collections::HashSet;

use osim_model::messages::{listed, one_line, readable};
use osim_patch::{Change, Deed, Move, ObjectChange, Plan};

use super::groups::{groups, names, several_groups, whose};
use super::object_groups::object_groups;
use crate::report::layout::table;
use crate::report::messages::warnings;

/// What was taken, changed and noticed; `output` says the outcome. What the plan says is taken as it is spelled.
#[must_use]
pub fn text(plan: &Plan, model: &str, output: &str) -> String {
    let mut text = format!("{}\n", one_line(format!("{model}: {}", plan.taken)));
    if plan.is_empty() {
        text.push_str("nothing to change\n");
    } else {
        text.push('\n');
        for table in [objects(plan.objects()), changes(plan), new_spheres(plan), moves(plan)] {
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
    let masses = plan.masses.as_ref().map(|masses| {
        format!("{} -> {} kg, ", readable(masses.contacts_mass.kg), readable(masses.target_mass_kg))
    });
    let mut codes: Vec<&str> = plan.warnings.iter().map(|warning| warning.code().as_str()).collect();
    codes.dedup();
    let warnings = if codes.is_empty() { String::new() } else { format!(" [{}]", codes.join(", ")) };
    let numbers = plan.changes.len() + plan.moves.len();
    let changes = match (plan.objects().len(), numbers) {
        (0, _) => format!("{numbers} changes"),
        (objects, 0) => format!("{objects} objects"),
        (objects, _) => format!("{objects} objects and {numbers} changes"),
    };
    let line = format!("{model}: {}{changes}; {output}{warnings}", masses.unwrap_or_default());
    format!("{}\n", one_line(line))
}

/// Names of objects that are listed, before they are counted: a row is one line.
const NAMED: usize = 3;
/// The same in a table that has more columns.
const NAMED_IN_ROW: usize = 2;

/// Whole objects, one row for each class.
fn objects(objects: &[ObjectChange]) -> String {
    if objects.is_empty() {
        return String::new();
    }
    let mut table = table(&["objects", "", "class", "names"]);
    for group in object_groups(objects) {
        let count = group.names.len().to_string();
        table.add_row([group.deed.as_str(), &count, group.class, &listed(&group.names, NAMED)]);
    }
    table.right_aligned(&[1]);
    format!("{}\n", table.trim_fmt())
}

/// Whether the numbers that change are those of new objects: what they change from is the contact that they are made from.
pub fn is_new(plan: &Plan) -> bool {
    plan.objects().iter().any(|object| object.deed == Deed::Added)
}

fn changes(plan: &Plan) -> String {
    let changes: &[Change] = &plan.changes;
    if changes.is_empty() {
        return String::new();
    }
    let before = if is_new(plan) { "from" } else { "now" };
    let mut table = table(&["property", "of", before, "new", "factor", "equation"]);
    let groups = groups(changes);
    let several = several_groups(&groups);
    for group in &groups {
        let Some(first) = group.first() else { continue };
        let of = if several.contains(&first.property) {
            listed(&names(group), NAMED_IN_ROW)
        } else {
            whose(group)
        };
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
            of,
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

/// Spheres that are added, one row each, as they are written.
fn new_spheres(plan: &Plan) -> String {
    let spheres = plan.new_spheres();
    if spheres.is_empty() {
        return String::new();
    }
    let mut table = table(&["new sphere", "on", "radius", "x", "y", "z"]);
    for sphere in spheres {
        let mut cells = vec![sphere.name.to_owned(), sphere.body.to_owned(), readable(sphere.radius_m)];
        cells.extend(sphere.centre_m.map(centre));
        table.add_row(cells);
    }
    table.right_aligned(&[2, 3, 4, 5]);
    format!("{}\n  (m, in the frame of the body)\n", table.trim_fmt())
}

/// Sphere centres that move, one row each: they are rarely alike. Those of new spheres are in a table of their own.
fn moves(plan: &Plan) -> String {
    let moves = moves_of_others(plan);
    if moves.is_empty() {
        return String::new();
    }
    let mut table = table(&["centre of", "x", "y", "z", "new x", "new y", "new z", "by"]);
    for moved in moves {
        let mut cells = vec![moved.sphere.clone()];
        cells.extend(moved.from.iter().chain(&moved.to).copied().map(centre));
        cells.push(moved.equation.to_owned());
        table.add_row(cells);
    }
    table.right_aligned(&[1, 2, 3, 4, 5, 6]);
    format!("{}\n", table.trim_fmt())
}

/// Centres that move of spheres that were there before.
pub fn moves_of_others(plan: &Plan) -> Vec<&Move> {
    let new = plan.new_spheres();
    let new: HashSet<&str> = new.iter().map(|sphere| sphere.path).collect();
    plan.moves.iter().filter(|place| !new.contains(place.path.as_str())).collect()
}

/// A coordinate of a centre, in metres to a hundredth of a millimetre, and 0 without a minus.
pub fn centre(metres: f64) -> String {
    format!("{:.5}", (metres * 1e5).round() / 1e5 + 0.0)
}
