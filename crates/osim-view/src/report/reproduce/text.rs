//! The comparison for people and for spreadsheets.

use osim_model::messages::{counted, readable, shortest};

use super::record::{AnimalRecord, NumberRecord, ReproductionRecord};
use crate::report::layout::{csv_text, filled, table, wrapped};

/// Digits that are shown beyond those of the paper.
const MORE_DIGITS: usize = 3;

/// Table 1, number by number, and in how many the paper and its equations agree.
#[must_use]
pub fn reproduction_text(record: &ReproductionRecord) -> String {
    let mut table = table(&["Table 1", "paper", "computed", "difference", "relative", "agrees"]);
    for number in record.table1.iter().flat_map(|animal| &animal.values) {
        table.add_row(cells(number));
    }
    table.right_aligned(&[1, 2, 3, 4]);
    let formatted = table.trim_fmt();
    let mut lines = formatted.lines();
    let mut text = format!("{}\n", lines.next().unwrap_or_default());
    for animal in &record.table1 {
        text.push_str(&format!("{}\n", heading(animal)));
        for line in lines.by_ref().take(animal.values.len()) {
            text.push_str(&format!("{line}\n"));
        }
    }
    text.push_str(&format!("\n{}", summary(record)));
    text
}

/// What Fig. 1 shows and what it needs.
#[must_use]
pub fn fig1_text(record: &ReproductionRecord) -> String {
    let paragraphs: Vec<String> = record.fig1.iter().map(|paragraph| filled(paragraph)).collect();
    format!("{}\n", paragraphs.join("\n"))
}

/// Table 1 with a row for each number: its animal, as printed, as computed.
///
/// # Errors
/// None in practice: the rows are written into memory.
pub fn reproduction_csv(record: &ReproductionRecord) -> Result<String, csv::Error> {
    let header = [
        "taxon",
        "mass_kg",
        "sphere_count",
        "radius_m",
        "quantity",
        "unit",
        "equation",
        "printed",
        "computed",
        "difference",
        "relative_difference",
        "within_last_digit",
        "computed_from_rounded",
    ];
    let rows = record.table1.iter().flat_map(|animal| {
        animal.values.iter().map(move |number| {
            vec![
                animal.taxon.to_owned(),
                shortest(animal.mass_kg),
                shortest(animal.sphere_count),
                shortest(animal.radius_m),
                number.name.to_owned(),
                number.unit.to_owned(),
                number.equation.to_owned(),
                number.printed.to_owned(),
                shortest(number.computed),
                shortest(number.difference),
                shortest(number.relative_difference),
                number.within_last_digit.to_string(),
                number.computed_from_rounded.map(shortest).unwrap_or_default(),
            ]
        })
    });
    csv_text(std::iter::once(header.map(str::to_owned).to_vec()).chain(rows))
}

fn heading(animal: &AnimalRecord) -> String {
    let [mass, spheres, radius] = [animal.mass_kg, animal.sphere_count, animal.radius_m].map(readable);
    format!("{}: {mass} kg on {} of R = {radius} m", animal.taxon, counted(spheres, "sphere"))
}

fn cells(number: &NumberRecord) -> Vec<String> {
    let decimals = number.printed.split_once('.').map_or(0, |(_, decimals)| decimals.len()) + MORE_DIGITS;
    let unit = if number.unit.is_empty() { String::new() } else { format!(", {}", number.unit) };
    vec![
        format!("  {}{unit}", number.label),
        number.printed.to_owned(),
        format!("{:.decimals$}", number.computed),
        format!("{:+.decimals$}", number.difference),
        format!("{:+.2} %", 100.0 * number.relative_difference),
        if number.within_last_digit { "yes" } else { "no" }.to_owned(),
    ]
}

/// How many agree, why others do not, and how it was computed.
fn summary(record: &ReproductionRecord) -> String {
    let (agree, all) = (record.within_last_digit, record.numbers);
    let mut text = filled(&format!(
        "{agree} of {all} numbers agree: computed and printed are within half a unit of the last printed digit of each other."
    ));
    text.push('\n');
    let numbers =
        record.table1.iter().flat_map(|animal| animal.values.iter().map(move |number| (animal, number)));
    for (animal, number) in numbers.filter(|(_, number)| !number.within_last_digit) {
        let why = match (number.computed_from_rounded, record.rounded_base()) {
            (Some(value), Some(base)) => format!(
                "the paper multiplies the rounded {base} {} of its human, which gives {}",
                number.unit,
                readable(value)
            ),
            _ => "no rounding explains it".to_owned(),
        };
        text.push_str(&wrapped(&format!("- {}, {}: {why}.", animal.taxon, number.label), "  "));
    }
    text.push_str(&filled(
        "E1*, E* and alpha follow from the 62 kg human by (10), (A.4) and (14). The final x/R is that of a drop test by our own \
         integrator, from a quarter of the radius and for 2 s at 9.81 m/s2 on a HuntCrossleyForce, and k is (B.2) there.",
    ));
    text.push('\n');
    text
}
