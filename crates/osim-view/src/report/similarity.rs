//! Numbers besides contacts that follow the size of a body, as text.

use osim_inspect::{SizeList, SizeRow, SizeSpread};
use osim_model::messages::{four_significant, three_significant};

use crate::report::extent::{Extent, Layout};
use crate::report::layout::table;

/// The largest number of names that are listed. If there are more, the text has their number.
const MOST_NAMES_LISTED: usize = 6;

/// Sentences that describe the list, for a text or a page.
pub fn about(list: &SizeList, extent: Extent) -> Vec<String> {
    let mut sentences = vec![
        ratios_in_words(list, extent),
        "\"similar\" is the factor of geometric similarity at equal gravity, which is one choice among several: nothing here is changed"
            .to_owned(),
    ];
    if list.is_of_two_models() {
        sentences.push(
            "\"follows\": changed so; \"left\": still at the old size, as the Scale Tool leaves all but lengths, masses and inertia".to_owned(),
        );
    }
    sentences
}

/// Sentences about the gaps in the list: objects without a counterpart in the other model, and objects that could not be read.
pub fn gaps(list: &SizeList, extent: Extent) -> Vec<String> {
    let mut sentences = Vec::new();
    let pairs = [(&list.only_in_model, "the original"), (&list.only_in_original, "the model")];
    for (names, other) in pairs.into_iter().filter(|(names, _)| !names.is_empty()) {
        sentences.push(format!("no counterpart in {other}: {}", extent.names(names, MOST_NAMES_LISTED)));
    }
    for unread in &list.not_read {
        sentences.push(format!("not read: {} {} ({})", unread.count, unread.class, unread.why));
    }
    sentences
}

/// The list as text, one line for each kind of number.
pub fn text(list: &SizeList, layout: Layout) -> String {
    let extent = layout.extent;
    let mut text = "What else follows size:\n".to_owned();
    for sentence in about(list, extent) {
        text.push_str(&layout.wrapped(&format!("  {sentence}"), "    "));
    }
    let mut rows = table(&headings(list));
    for row in &list.kinds {
        rows.add_row(cells(list, row, extent));
    }
    rows.right_aligned(&[1]);
    text.push_str(&rows.into_lines(layout.columns));
    text.push('\n');
    for sentence in gaps(list, extent) {
        text.push_str(&layout.wrapped(&format!("  {sentence}"), "    "));
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

pub fn cells(list: &SizeList, row: &SizeRow, extent: Extent) -> [String; 5] {
    let three = |value| extent.number(value, three_significant);
    let similar = row.similarity_factor.map_or_else(|| "?".to_owned(), three);
    let (name, count) = (row.description.to_owned(), row.count.to_string());
    if list.is_of_two_models() {
        [name, count, factors_in_words(row, extent), similar, row.verdict_words.to_owned()]
    } else {
        let now = format!("{} {}", three(row.value.median), row.unit);
        [name, count, now, similar, row.similarity_formula.clone()]
    }
}

/// The factors by which numbers changed: `same`, or the median and the range of the factors.
fn factors_in_words(row: &SizeRow, extent: Extent) -> String {
    match (row.pairs, row.same, &row.factor) {
        (Some(pairs), Some(same), _) if pairs > 0 && same == pairs => "same".to_owned(),
        (_, _, Some(factor)) => spread_in_words(factor, extent),
        (Some(1..), ..) => "0 before".to_owned(),
        _ => "-".to_owned(),
    }
}

fn spread_in_words(SizeSpread { median, min, max, .. }: &SizeSpread, extent: Extent) -> String {
    let [median, min, max] = [median, min, max].map(|value| extent.number(*value, three_significant));
    if min == max { median } else { format!("{median} ({min} to {max})") }
}

fn ratios_in_words(list: &SizeList, extent: Extent) -> String {
    let three = |value| extent.number(value, three_significant);
    let (Some(mass), Some(length)) = (list.mass_ratio, list.length_ratio) else {
        return "masses are not known, so the factors of similarity cannot be computed".to_owned();
    };
    let kg =
        |mass: Option<f64>| mass.map_or_else(|| "?".to_owned(), |mass| extent.number(mass, four_significant));
    let from = match list.compared_bodies {
        0 => "its cube root".to_owned(),
        1 => "by the joints of 1 body".to_owned(),
        bodies => format!("by the joints of {bodies} bodies"),
    };
    let mut text = format!(
        "masses M = {} ({} to {} kg), lengths L = {} ({from})",
        three(mass),
        kg(list.original_mass_kg),
        kg(list.mass_kg),
        three(length)
    );
    if let Some(gravity) = list.gravity_ratio.filter(|ratio| (ratio - 1.0).abs() > 1e-3) {
        text.push_str(&format!("; gravity times {}, which is counted", three(gravity)));
    }
    text
}
