//! Shows a plan as text.

use std::collections::HashSet;
use std::fmt;

use imara_diff::{Algorithm, Diff, InternedInput, Interner, Token, UnifiedDiffConfig, UnifiedDiffPrinter};
use indexmap::IndexMap;
use osim_model::Property;
use osim_model::messages::{four_significant, four_significant_apart, listed, one_line};
use osim_patch::{ChangedBy, NumberChange, ObjectAction, ObjectChange, PlaceChange, Plan};

use crate::report::layout::table;
use crate::report::messages::finding_lines;

// A plan as a table: equal changes share a row.

/// A plan as tables for a terminal of `columns` columns, with its remarks and findings. `output` says which files were written. The texts
/// of the plan are already in the words of the front end.
pub fn text(plan: &Plan, model: &str, output: &str, columns: Option<usize>) -> String {
    let mut text = format!("{}\n", one_line(format!("{model}: {}", plan.taken)));
    if plan.is_empty() {
        text.push_str("nothing to change\n");
    } else {
        text.push('\n');
        for table in [
            table_of_objects(plan.objects(), columns),
            table_of_changes(plan, columns),
            table_of_new_spheres(plan, columns),
            table_of_moves(plan, columns),
        ] {
            if !table.is_empty() {
                text.push_str(&format!("{table}\n"));
            }
        }
    }
    for remark in &plan.remarks {
        text.push_str(&format!("remark: {}\n", one_line(remark.to_string())));
    }
    text.push_str(&finding_lines(&plan.findings));
    text.push_str(&format!("{}\n", one_line(output.to_owned())));
    text
}

/// A plan in one line, for a run over many models.
pub fn line(plan: &Plan, model: &str, output: &str) -> String {
    let masses = plan.masses.as_ref().map(|masses| {
        let [from, to] = four_significant_apart([masses.contacts_mass.kg, masses.target_mass_kg]);
        format!("{from} -> {to} kg, ")
    });
    let new = plan.findings.iter().filter(|finding| !finding.had_before);
    let mut codes: Vec<&str> = new.map(|finding| finding.code().as_str()).collect();
    codes.dedup();
    let in_brackets = if codes.is_empty() { String::new() } else { format!(" [{}]", codes.join(", ")) };
    let numbers = plan.changes.len() + plan.moves.len();
    let changes = match (plan.objects().len(), numbers) {
        (0, _) => format!("{numbers} changes"),
        (objects, 0) => format!("{objects} objects"),
        (objects, _) => format!("{objects} objects and {numbers} changes"),
    };
    let line = format!("{model}: {}{changes}; {output}{in_brackets}", masses.unwrap_or_default());
    format!("{}\n", one_line(line))
}

/// If all places of spheres are nearer to the origins of their bodies than this, m, the animal is small. In every human, some are farther.
const SMALL_FOOT_LENGTH_M: f64 = 0.02;

/// The largest number of names in a row of the table of objects, so that it fits into one line. The row ends with the number of others.
const MOST_OBJECTS_NAMED: usize = 3;
/// The largest number of names of spheres or forces in a row of the table of changes, which has more columns.
const MOST_NAMES_IN_CHANGE: usize = 2;

/// The table of added and removed objects, with a row for each class.
fn table_of_objects(objects: &[ObjectChange], columns: Option<usize>) -> String {
    let mut table = table(&["objects", "", "class", "names"]);
    for ((action, class), names) in object_groups(objects) {
        let count = names.len().to_string();
        table.add_row([action.as_str(), &count, class, &listed(&names, MOST_OBJECTS_NAMED)]);
    }
    table.right_aligned(&[1]);
    table.text_if_any(columns, "")
}

/// Whether the numbers that change belong to new objects. Then the old numbers are those of the contact from which the new one was made.
pub fn is_new(plan: &Plan) -> bool {
    plan.objects().iter().any(|object| object.action == ObjectAction::Added)
}

fn table_of_changes(plan: &Plan, columns: Option<usize>) -> String {
    let changes: &[NumberChange] = &plan.changes;
    let before = if is_new(plan) { "from" } else { "now" };
    let mut table = table(&["property", "of", before, "new", "factor", "equation"]);
    let groups = equal_changes(changes);
    let several = properties_in_several_groups(&groups);
    for group in &groups {
        let Some(first) = group.first() else { continue };
        let of = if several.contains(&first.property) {
            listed(&names(group), MOST_NAMES_IN_CHANGE)
        } else {
            name_or_count(group)
        };
        let factor = first.factor.map(|factor| format!("x{}", number(factor))).unwrap_or_default();
        let equation = match first.by {
            ChangedBy::Equation(numbers) => format!("({numbers})"),
            rule => rule.as_str().to_owned(),
        };
        // A blank keeps digits below digits.
        let mark = if first.inserted { '*' } else { ' ' };
        let [from, to] = first.values(number);
        table.add_row(vec![first.name().to_owned(), of, format!("{from}{mark}"), to, factor, equation]);
    }
    table.right_aligned(&[2, 3, 4]);
    let inserted = changes.iter().any(|change| change.inserted);
    let note = "  (* not in the file: OpenSim's default applied; it is written out now)\n";
    table.text_if_any(columns, if inserted { note } else { "" })
}

/// The table of added spheres, with a row for each sphere and its final numbers.
fn table_of_new_spheres(plan: &Plan, columns: Option<usize>) -> String {
    let spheres = plan.new_spheres();
    let largest = spheres.iter().flat_map(|sphere| sphere.centre_m).fold(0.0, largest_of);
    let mut table = table(&["new sphere", "on", "radius", "x", "y", "z"]);
    for sphere in spheres {
        let mut cells = vec![sphere.name.to_owned(), sphere.body.to_owned(), number(sphere.radius_m)];
        cells.extend(sphere.centre_m.map(|metres| coordinate_text(metres, largest)));
        table.add_row(cells);
    }
    table.right_aligned(&[2, 3, 4, 5]);
    table.text_if_any(columns, "  (m, in the frame of the body)\n")
}

/// The table of sphere centres that move, with a row for each sphere, because moves are rarely alike. New spheres are in another table.
fn table_of_moves(plan: &Plan, columns: Option<usize>) -> String {
    let moves = moves_of_others(plan);
    let largest = moves.iter().flat_map(|moved| moved.to).fold(0.0, largest_of);
    let mut table = table(&["centre of", "x", "y", "z", "new x", "new y", "new z", "by"]);
    for moved in moves {
        let mut cells = vec![moved.geometry.clone()];
        cells.extend(moved.from.iter().chain(&moved.to).map(|&metres| coordinate_text(metres, largest)));
        cells.push(moved.by.as_str().to_owned());
        table.add_row(cells);
    }
    table.right_aligned(&[1, 2, 3, 4, 5, 6]);
    table.text_if_any(columns, "  (m, in the frame of the body)\n")
}

fn largest_of(largest: f64, coordinate: f64) -> f64 {
    largest.max(coordinate.abs())
}

/// A coordinate in metres, with four decimals; with six if the `largest` coordinate is that of a small animal.
fn coordinate_text(metres: f64, largest: f64) -> String {
    let (decimals, unit) = if largest < SMALL_FOOT_LENGTH_M { (6, 1e6) } else { (4, 1e4) };
    format!("{:.decimals$}", (metres * unit).round() / unit + 0.0)
}

/// A number with four significant digits; with an exponent if it is small.
fn number(value: f64) -> String {
    let text = four_significant(value);
    match text.parse::<f64>() {
        Ok(rounded) if rounded != 0.0 && rounded.abs() < 1e-3 => format!("{rounded:e}"),
        _ => text,
    }
}

/// The centres that move, except the centres of new spheres.
pub(crate) fn moves_of_others(plan: &Plan) -> Vec<&PlaceChange> {
    let new = plan.new_spheres();
    let new: HashSet<&str> = new.iter().map(|sphere| sphere.path).collect();
    plan.moves.iter().filter(|place| !new.contains(place.path.as_str())).collect()
}

/// A coordinate of a centre, in metres to a hundredth of a millimetre. Zero has no minus sign.
pub fn centre(metres: f64) -> String {
    format!("{:.5}", (metres * 1e5).round() / 1e5 + 0.0)
}

// Equal changes together, so that twelve spheres are one line.

/// Groups of equal changes, in the order of the first change of each group.
pub(crate) fn equal_changes(changes: &[NumberChange]) -> Vec<Vec<&NumberChange>> {
    let mut groups: IndexMap<_, Vec<&NumberChange>> = IndexMap::new();
    for change in changes {
        // What a group has in common.
        let radii = change.radii_m.map(|[old, _]| old.map(f64::to_bits));
        let numbers = (change.from.to_bits(), change.to.to_bits(), radii);
        let key = (change.property, numbers, change.by, change.inserted);
        groups.entry(key).or_default().push(change);
    }
    groups.into_values().collect()
}

/// The name of the only force or sphere of a group, or how many forces or spheres it has.
pub(crate) fn name_or_count(group: &[&NumberChange]) -> String {
    let name = group.first().and_then(|change| change.sphere.clone().or_else(|| change.force.clone()));
    match (group.len(), group.first().is_some_and(|change| change.sphere.is_some())) {
        (1, _) => name.unwrap_or_default(),
        (count, true) => format!("{count} spheres"),
        (count, false) => format!("{count} forces"),
    }
}

/// The properties whose changes are in several groups. Their rows need the names of spheres or forces.
pub(crate) fn properties_in_several_groups(groups: &[Vec<&NumberChange>]) -> HashSet<Property> {
    let mut seen = HashSet::new();
    let properties = groups.iter().filter_map(|group| group.first()).map(|change| change.property);
    properties.filter(|&property| !seen.insert(property)).collect()
}

/// The spheres or forces of a group.
pub fn names<'c>(group: &[&'c NumberChange]) -> Vec<&'c str> {
    group.iter().filter_map(|change| change.sphere.as_deref().or(change.force.as_deref())).collect()
}

// Objects of one class together, so that twelve spheres are one line.

/// The names of objects by whether they are added or removed, and by OpenSim's class, in the order of the first object of each group.
pub(crate) fn object_groups(objects: &[ObjectChange]) -> IndexMap<(ObjectAction, &'static str), Vec<&str>> {
    let mut groups: IndexMap<_, Vec<&str>> = IndexMap::new();
    for object in objects {
        groups.entry((object.action, object.class)).or_default().push(&object.name);
    }
    groups
}

// The change as a unified diff, as version control shows it.

/// Number of unchanged lines that are shown before and after each change.
const CONTEXT_LINES: u32 = 1;

/// The differences between the bytes of a model before and after a change, with these names for the two files.
pub fn unified_diff(old: &[u8], new: &[u8], old_name: &str, new_name: &str) -> String {
    // Bytes that are not UTF-8 are the same on both sides; a diff is for reading, so they may be shown as replacements.
    let (old, new) = (String::from_utf8_lossy(old), String::from_utf8_lossy(new));
    let input = InternedInput::new(old.as_ref(), new.as_ref());
    let mut diff = Diff::compute(Algorithm::Myers, &input);
    diff.postprocess_no_heuristic(&input);
    if diff.count_additions() + diff.count_removals() == 0 {
        return String::new();
    }
    let mut config = UnifiedDiffConfig::default();
    config.context_len(CONTEXT_LINES);
    let lines = diff.unified_diff(&DiffLines(&input.interner), config, &input).to_string();
    format!("--- {old_name}\n+++ {new_name}\n{lines}")
}

/// Prints lines as `diff -u` does.
struct DiffLines<'i>(&'i Interner<&'i str>);

impl DiffLines<'_> {
    fn line(&self, f: &mut impl fmt::Write, sign: char, token: Token) -> fmt::Result {
        let line = self.0[token];
        write!(f, "{sign}{line}")?;
        if line.ends_with('\n') { Ok(()) } else { writeln!(f, "\n\\ No newline at end of file") }
    }
}

/// The index of the first line and the number of lines. A diff shows line numbers from 1; for a range without lines, it shows the line
/// before.
fn line_range(start: u32, lines: u32) -> String {
    match lines {
        0 => format!("{start},0"),
        1 => format!("{}", start + 1),
        _ => format!("{},{lines}", start + 1),
    }
}

impl UnifiedDiffPrinter for DiffLines<'_> {
    fn display_header(
        &self,
        mut f: impl fmt::Write,
        start_before: u32,
        start_after: u32,
        len_before: u32,
        len_after: u32,
    ) -> fmt::Result {
        writeln!(f, "@@ -{} +{} @@", line_range(start_before, len_before), line_range(start_after, len_after))
    }

    fn display_context_token(&self, mut f: impl fmt::Write, token: Token) -> fmt::Result {
        self.line(&mut f, ' ', token)
    }

    fn display_hunk(&self, mut f: impl fmt::Write, before: &[Token], after: &[Token]) -> fmt::Result {
        before.iter().try_for_each(|token| self.line(&mut f, '-', *token))?;
        after.iter().try_for_each(|token| self.line(&mut f, '+', *token))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_that_change_stand_between_their_neighbours() {
        let old = b"a\nb\nc\nd\ne\nf\ng\n";
        let new = b"a\nB\nc\nd\ne\nF\ng\n";
        let expected = "--- x\n+++ y\n@@ -1,3 +1,3 @@\n a\n-b\n+B\n c\n@@ -5,3 +5,3 @@\n e\n-f\n+F\n g\n";
        assert_eq!(unified_diff(old, new, "x", "y"), expected);
    }

    #[test]
    fn an_end_without_a_line_end_is_told_and_equal_files_say_nothing() {
        let expected =
            "--- x\n+++ y\n@@ -1 +1 @@\n-a\n\\ No newline at end of file\n+b\n\\ No newline at end of file\n";
        assert_eq!(unified_diff(b"a", b"b", "x", "y"), expected);
        assert_eq!(unified_diff(b"a\r\n", b"a\r\n", "x", "y"), "");
    }

    #[test]
    fn a_line_added_at_the_end_of_a_file_of_one_line() {
        assert_eq!(unified_diff(b"", b"a\n", "x", "y"), "--- x\n+++ y\n@@ -0,0 +1 @@\n+a\n");
    }
}
