//! A plan as a table: equal changes share a row, so that twelve spheres are one line.

use osim_patch::{Change, Move, Plan, Warning};

use super::{number, right, table};

/// What a run took, changed and noticed.
pub(crate) fn text(plan: &Plan, model: &str, output: &str) -> String {
    let mut text = format!("{model}: {}\n", plan.taken);
    if plan.is_empty() {
        text.push_str("nothing to change\n");
    } else {
        text.push('\n');
        text.push_str(&rows(&plan.changes));
        if !plan.moves.is_empty() {
            text.push('\n');
            text.push_str(&moves(&plan.moves));
        }
        text.push('\n');
    }
    for remark in &plan.remarks {
        text.push_str(&format!("note: {remark}\n"));
    }
    text.push_str(&warnings(&plan.warnings));
    text.push_str(&format!("{output}\n"));
    text
}

/// The same in one line, for a run over many models.
pub(crate) fn line(plan: &Plan, model: &str, output: &str) -> String {
    let masses = plan
        .masses
        .as_ref()
        .map(|masses| format!("{} -> {} kg, ", number(masses.from.kg), number(masses.to_kg)));
    let mut codes: Vec<&str> = plan.warnings.iter().map(|warning| warning.code.as_str()).collect();
    codes.dedup();
    let warnings = if codes.is_empty() { String::new() } else { format!(" [{}]", codes.join(", ")) };
    let changes = plan.changes.len() + plan.moves.len();
    format!("{model}: {}{changes} changes; {output}{warnings}\n", masses.unwrap_or_default())
}

/// Warnings, one line each.
pub(crate) fn warnings(warnings: &[Warning]) -> String {
    let mut text = String::new();
    for warning in warnings {
        let line = warning.line.map(|line| format!("line {line}: ")).unwrap_or_default();
        text.push_str(&format!("warning: {line}{} [{}]\n", warning.message, warning.code));
    }
    text
}

fn rows(changes: &[Change]) -> String {
    if changes.is_empty() {
        return String::new();
    }
    let mut table = table(&["property", "of", "now", "new", "factor", "equation"]);
    for group in groups(changes) {
        let Some(first) = group.first() else { continue };
        let factor = first.factor.map(|factor| format!("x{}", number(factor))).unwrap_or_default();
        let equation = if first.equation.starts_with(|c: char| c.is_ascii_digit() || c == 'A' || c == 'C') {
            format!("({})", first.equation)
        } else {
            first.equation.to_owned()
        };
        let new = if first.inserted {
            format!("{} +", number(first.to))
        } else {
            format!("{}  ", number(first.to))
        };
        table.add_row(vec![
            first.property.name().to_owned(),
            whose(&group),
            number(first.from),
            new,
            factor,
            equation,
        ]);
    }
    right(&mut table, &[2, 3, 4]);
    let mut text = table.trim_fmt();
    text.push('\n');
    if changes.iter().any(|change| change.inserted) {
        text.push_str("  (+ was not in the file: OpenSim's default applied; it is written out now)\n");
    }
    text
}

/// Sphere centres, one row each: they are rarely alike.
fn moves(moves: &[Move]) -> String {
    let mut table = table(&["centre of", "x", "y", "z", "new x", "new y", "new z", "by"]);
    for place in moves {
        let mut cells = vec![place.sphere.clone()];
        cells.extend(place.from.iter().chain(&place.to).map(|value| format!("{value:.5}")));
        cells.push(place.equation.to_owned());
        table.add_row(cells);
    }
    right(&mut table, &[1, 2, 3, 4, 5, 6]);
    format!("{}\n", table.trim_fmt())
}

/// Equal changes together.
pub(crate) fn groups(changes: &[Change]) -> Vec<Vec<&Change>> {
    let mut groups: Vec<Vec<&Change>> = Vec::new();
    for change in changes {
        match groups.iter_mut().find(|group| group.first().is_some_and(|first| alike(first, change))) {
            Some(group) => group.push(change),
            None => groups.push(vec![change]),
        }
    }
    groups
}

fn alike(a: &Change, b: &Change) -> bool {
    (a.property, a.from.to_bits(), a.to.to_bits(), a.equation, a.inserted)
        == (b.property, b.from.to_bits(), b.to.to_bits(), b.equation, b.inserted)
}

/// The force or sphere of a group, or how many there are.
pub(crate) fn whose(group: &[&Change]) -> String {
    let one = group.first().and_then(|change| change.sphere.clone().or_else(|| change.force.clone()));
    match (group.len(), group.first().is_some_and(|change| change.sphere.is_some())) {
        (1, _) => one.unwrap_or_default(),
        (count, true) => format!("{count} spheres"),
        (count, false) => format!("{count} forces"),
    }
}
