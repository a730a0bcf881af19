//! What else follows the size of a body, as text.

use osim_inspect::{SizeList, SizeRow, SizeSpread};
use osim_model::messages::{four_significant, listed, three_significant};

use crate::report::layout::{table, wrapped};

/// Names that are listed; more are counted.
const NAMED: usize = 6;

/// What the list is, in sentences for any page.
pub fn about(list: &SizeList) -> Vec<String> {
    let mut sentences = vec![ratios(list)];
    sentences.push(
        "\"similar\" is the factor of geometric similarity at equal gravity, which is one choice among several: nothing here is changed"
            .to_owned(),
    );
    if list.is_of_two_models() {
        sentences.push(
            "\"follows\": changed so; \"left\": still at the old size, as the Scale Tool leaves all but lengths, masses and inertia".to_owned(),
        );
    }
    sentences
}

/// What the list leaves out, in sentences for any page.
pub fn gaps(list: &SizeList) -> Vec<String> {
    let mut sentences = Vec::new();
    let pairs = [(&list.only_in_model, "the original"), (&list.only_in_original, "the model")];
    for (names, other) in pairs.into_iter().filter(|(names, _)| !names.is_empty()) {
        sentences.push(format!("no counterpart in {other}: {}", listed(names, NAMED)));
    }
    for unread in &list.not_read {
        sentences.push(format!("not read: {} {} ({})", unread.count, unread.class, unread.why));
    }
    sentences
}

/// The list, a line a kind.
pub fn text(list: &SizeList) -> String {
    let mut text = "What else follows size:\n".to_owned();
    for sentence in about(list) {
        text.push_str(&wrapped(&format!("  {sentence}"), "    "));
    }
    let mut rows = table(&headings(list));
    for row in &list.kinds {
        rows.add_row(cells(list, row));
    }
    rows.right_aligned(&[1]);
    text.push_str(&rows.trim_fmt());
    text.push('\n');
    for sentence in gaps(list) {
        text.push_str(&wrapped(&format!("  {sentence}"), "    "));
    }
    text
}

pub fn headings(list: &SizeList) -> [&'static str; 5] {
    if list.is_of_two_models() {
        ["property", "count", "found", "similar", "verdict"]
    } else {
        ["property", "count", "median now", "similar", "formula"]
    }
}

pub fn cells(list: &SizeList, row: &SizeRow) -> [String; 5] {
    let similar = row.similarity_factor.map_or_else(|| "?".to_owned(), three_significant);
    let (name, count) = (row.description.to_owned(), row.count.to_string());
    if list.is_of_two_models() {
        [name, count, found(row), similar, row.verdict_words.to_owned()]
    } else {
        let now = format!("{} {}", three_significant(row.value.median), row.unit);
        [name, count, now, similar, row.similarity_formula.clone()]
    }
}

/// By what factor numbers changed: `same`, or the median and the range.
fn found(row: &SizeRow) -> String {
    match (row.pairs, row.same, &row.factor) {
        (Some(pairs), Some(same), _) if pairs > 0 && same == pairs => "same".to_owned(),
        (_, _, Some(factor)) => spread(factor),
        (Some(1..), ..) => "0 before".to_owned(),
        _ => "-".to_owned(),
    }
}

fn spread(SizeSpread { median, min, max, .. }: &SizeSpread) -> String {
    let [median, min, max] = [median, min, max].map(|value| three_significant(*value));
    if min == max { median } else { format!("{median} ({min} to {max})") }
}

fn ratios(list: &SizeList) -> String {
    let (Some(mass), Some(length)) = (list.mass_ratio, list.length_ratio) else {
        return "masses are not known: what similarity would give is not known".to_owned();
    };
    let kg = |mass: Option<f64>| mass.map_or_else(|| "?".to_owned(), four_significant);
    let from = match list.compared_bodies {
        0 => "its cube root".to_owned(),
        1 => "by the joints of 1 body".to_owned(),
        bodies => format!("by the joints of {bodies} bodies"),
    };
    let mut text = format!(
        "masses M = {} ({} to {} kg), lengths L = {} ({from})",
        three_significant(mass),
        kg(list.original_mass_kg),
        kg(list.mass_kg),
        three_significant(length)
    );
    if let Some(gravity) = list.gravity_ratio.filter(|ratio| (ratio - 1.0).abs() > 1e-3) {
        text.push_str(&format!("; gravity times {}, which is counted", three_significant(gravity)));
    }
    text
}
