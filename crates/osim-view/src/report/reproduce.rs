//! Table 1 of the paper beside the results of its equations: as text, CSV and a record; and the data that Fig. 1 needs.

use contact_scaling::drop_test::DropError;
use contact_scaling::table1::{self, Animal, Column, ComparedNumber};
use osim_inspect::SCHEMA_VERSION;
use osim_model::files::Failure;
use osim_model::messages::{Dialect, counted, four_significant, readable, shortest};
use osim_requests::fig1;

use crate::report::layout::{WIDTH, csv_text, filled, table, wrapped};

// The comparison as data.

osim_inspect::json_records! {
    /// Table 1 of the paper, printed and computed, as the JSON has it.
    ReproductionRecord from (table1, dialect): (&[AnimalRecord], &dyn Dialect) {
        /// Version of this JSON, which rises when a field changes its meaning or goes away.
        schema_version: u32 = SCHEMA_VERSION,
        /// The rows of Table 1, in its order.
        table1: Vec<AnimalRecord> = table1.to_vec(),
        /// How many numbers were compared.
        numbers: usize = numbers_of(table1).count(),
        /// The number of values within half a unit of the last printed digit.
        within_last_digit: usize = numbers_of(table1).filter(|number| number.within_last_digit).count(),
        /// What Fig. 1 shows and needs, in words: the figure is not computed.
        fig1: Vec<String> = fig1().iter().map(|paragraph| paragraph.spelled(dialect)).collect(),
    }

    /// An animal of Table 1.
    AnimalRecord from (animal, values): (&Animal, Vec<NumberRecord>) {
        /// Name of the animal.
        taxon: &'static str = animal.taxon(),
        /// Mass of the body, kg.
        mass_kg: f64 = animal.scale().mass_kg(),
        /// Number n of spheres that share the animal's weight.
        sphere_count: f64 = animal.scale().sphere_count(),
        /// Radius of the contact spheres of the animal, m.
        radius_m: f64 = animal.scale().radius_m(),
        /// The numbers in the animal's row of the table.
        values: Vec<NumberRecord> = values,
    }

    /// A number of Table 1.
    NumberRecord from compared: &ComparedNumber {
        /// Name of the column; it ends in the unit, which is the paper's.
        name: &'static str = compared.column.name(),
        /// Label of the column.
        #[serde(skip)]
        label: &'static str = compared.column.label(),
        /// Unit of the column, for people; empty for a pure number.
        unit: &'static str = compared.column.unit(),
        /// Number of the equation; empty where it is given, or the result of the drop test.
        equation: &'static str = compared.column.equation(),
        /// The number as the paper prints it, with all digits.
        printed: &'static str = compared.printed,
        /// The number as this program computes it.
        computed: f64 = compared.computed,
        /// The computed number minus the printed one.
        difference: f64 = compared.difference(),
        /// The difference over the printed number.
        relative_difference: f64 = compared.relative_difference(),
        /// Whether the computed number is within half a unit of the last printed digit.
        within_last_digit: bool = compared.is_within_last_digit(),
        /// The number that gives the printed digits, computed from the rounded E* that the paper prints for the human; null where
        /// the exact one gives them, too.
        computed_from_rounded: Option<f64> = compared.from_rounded.filter(|_| compared.is_from_rounded()),
    }
}

fn numbers_of(animals: &[AnimalRecord]) -> impl Iterator<Item = &NumberRecord> {
    animals.iter().flat_map(|animal| &animal.values)
}

impl ReproductionRecord {
    /// Computes the numbers of Table 1 and compares them with the paper.
    ///
    /// # Errors
    /// None with the numbers of the table.
    pub fn new(dialect: &dyn Dialect) -> Result<Self, Failure> {
        let failed = |error: DropError| Failure::outside("Table 1", "out-of-domain", error.to_string());
        let row = |animal: Animal| -> Result<AnimalRecord, Failure> {
            let values = animal.compared().map_err(failed)?.iter().map(NumberRecord::from).collect();
            Ok((&animal, values).into())
        };
        let table1 = table1::animals().map(row).collect::<Result<Vec<AnimalRecord>, Failure>>()?;
        Ok((table1.as_slice(), dialect).into())
    }

    /// E* of the human, as the paper prints it.
    fn rounded_base(&self) -> Option<&'static str> {
        let human = self.table1.first()?;
        let base = human.values.iter().find(|number| number.name == Column::CompositeModulus.name());
        base.map(|number| number.printed)
    }
}

// The comparison for people and for spreadsheets.

/// Number of digits that are shown beyond the digits of the paper.
const DIGITS_BEYOND_PAPER: usize = 3;
/// The columns of a terminal that Table 1 needs with its absolute differences.
const LEAST_COLUMNS_OF_TABLE: usize = 72;

/// Table 1, number by number, and the count of numbers in which the paper and its equations agree, for a terminal with this many
/// columns. A narrow one shows the differences only as relative ones.
pub fn reproduction_text(record: &ReproductionRecord, columns: Option<usize>) -> String {
    let is_narrow = columns.is_some_and(|columns| columns < LEAST_COLUMNS_OF_TABLE);
    let mut table = table(&["Table 1", "paper", "computed", "difference", "relative", "agrees"]);
    for number in numbers_of(&record.table1) {
        table.add_row(cells_of_number(number, is_narrow));
    }
    table.right_aligned(&[1, 2, 3, 4]);
    let formatted = table.trim_fmt();
    let mut lines = formatted.lines();
    let mut text = format!("{}\n", lines.next().unwrap_or_default());
    for animal in &record.table1 {
        text.push_str(&format!("{}\n", heading_of_animal(animal)));
        for line in lines.by_ref().take(animal.values.len()) {
            text.push_str(&format!("{line}\n"));
        }
    }
    text.push_str(&format!("\n{}", summary_in_words(record, columns.unwrap_or(WIDTH))));
    text
}

/// Sentences about what Fig. 1 shows, and which data it needs.
pub fn fig1_text(record: &ReproductionRecord, columns: Option<usize>) -> String {
    let fill = |paragraph: &String| filled(paragraph, columns.unwrap_or(WIDTH));
    let paragraphs: Vec<String> = record.fig1.iter().map(fill).collect();
    format!("{}\n", paragraphs.join("\n"))
}

/// Table 1 as CSV, with a row for each number: the animal, the printed number and the computed number.
///
/// # Errors
/// None in practice: the rows are written into memory.
pub fn reproduction_csv(record: &ReproductionRecord) -> Result<String, csv::Error> {
    let header = "taxon mass_kg sphere_count radius_m quantity unit equation printed computed difference \
                  relative_difference within_last_digit computed_from_rounded";
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
    csv_text(std::iter::once(header.split(' ').map(str::to_owned).collect()).chain(rows))
}

fn heading_of_animal(animal: &AnimalRecord) -> String {
    let [mass, spheres, radius] = [animal.mass_kg, animal.sphere_count, animal.radius_m].map(readable);
    format!("{}: {mass} kg on {} of R = {radius} m", animal.taxon, counted(spheres, "sphere"))
}

fn cells_of_number(number: &NumberRecord, is_narrow: bool) -> Vec<String> {
    let decimals =
        number.printed.split_once('.').map_or(0, |(_, decimals)| decimals.len()) + DIGITS_BEYOND_PAPER;
    let unit = if number.unit.is_empty() { String::new() } else { format!(", {}", number.unit) };
    vec![
        format!(" {}{unit}", number.label),
        number.printed.to_owned(),
        format!("{:.decimals$}", number.computed),
        if is_narrow { String::new() } else { format!("{:+.decimals$}", number.difference) },
        format!("{:+.2} %", 100.0 * number.relative_difference),
        if number.within_last_digit { "yes" } else { "no" }.to_owned(),
    ]
}

/// How many numbers agree, why others do not agree, and how they were computed.
fn summary_in_words(record: &ReproductionRecord, width: usize) -> String {
    let (agree, all) = (record.within_last_digit, record.numbers);
    let mut text = filled(
        &format!(
            "{agree} of {all} numbers agree: computed and printed are within half a unit of the last printed digit of each other."
        ),
        width,
    );
    text.push('\n');
    let numbers =
        record.table1.iter().flat_map(|animal| animal.values.iter().map(move |number| (animal, number)));
    for (animal, number) in numbers.filter(|(_, number)| !number.within_last_digit) {
        let why = match (number.computed_from_rounded, record.rounded_base()) {
            (Some(value), Some(base)) => format!(
                "the paper multiplies the rounded {base} {} of its human, which gives {}",
                number.unit,
                four_significant(value)
            ),
            _ => "no rounding explains it".to_owned(),
        };
        text.push_str(&wrapped(&format!("- {}, {}: {why}.", animal.taxon, number.label), "  ", width));
    }
    text.push_str(&filled(
        "E1*, E* and alpha follow from the 62 kg human by (10), (A.4) and (14). The final x/R is that of a drop test by our own \
         integrator, from a quarter of the radius and for 2 s at 9.81 m/s2 on a HuntCrossleyForce, and k is (B.2) there.",
        width,
    ));
    text.push('\n');
    text
}
