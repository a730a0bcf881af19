//! The comparison as data.

use contact_scaling::table1::{self, Animal, Column, Compared};
use osim_inspect::SCHEMA_VERSION;
use osim_model::files::Failure;
use osim_model::messages::Dialect;
use osim_requests::fig1;
#[cfg(feature = "schemas")]
use schemars::JsonSchema;
use serde::Serialize;

/// Table 1 of the paper, printed and computed, as the JSON has it.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema), schemars(deny_unknown_fields))]
#[non_exhaustive]
pub struct ReproductionRecord {
    /// Raised when a field changes its meaning or goes away.
    pub schema_version: u32,
    /// The rows of Table 1, in its order.
    pub table1: Vec<AnimalRecord>,
    /// How many numbers were compared.
    pub numbers: usize,
    /// How many of them are within half a unit of the last printed digit.
    pub within_last_digit: usize,
    /// What Fig. 1 shows and needs, in words: it is not computed.
    pub fig1: Vec<String>,
}

/// An animal of Table 1.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema), schemars(deny_unknown_fields))]
#[non_exhaustive]
pub struct AnimalRecord {
    /// What it is called.
    pub taxon: &'static str,
    /// Its mass, kg.
    pub mass_kg: f64,
    /// Spheres n that share its weight.
    pub sphere_count: f64,
    /// Their radius, m.
    pub radius_m: f64,
    /// The numbers of its row.
    pub values: Vec<NumberRecord>,
}

/// A number of Table 1.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema), schemars(deny_unknown_fields))]
#[non_exhaustive]
pub struct NumberRecord {
    /// Its name; it ends in the unit, which is the paper's.
    pub name: &'static str,
    /// In words.
    #[serde(skip)]
    pub label: &'static str,
    /// Its unit, for people; empty for a pure number.
    pub unit: &'static str,
    /// Number of the equation; empty where it is given, or the result of the drop test.
    pub equation: &'static str,
    /// As the paper prints it, with all its digits.
    pub printed: &'static str,
    /// As it is computed.
    pub computed: f64,
    /// Computed minus printed.
    pub difference: f64,
    /// The difference over the printed number.
    pub relative_difference: f64,
    /// Whether the computed number is within half a unit of the last printed digit.
    pub within_last_digit: bool,
    /// The number that gives the printed digits, computed from the rounded E* that the paper prints for the human; null where
    /// the exact one gives them, too.
    pub computed_from_rounded: Option<f64>,
}

impl ReproductionRecord {
    /// Computes it.
    ///
    /// # Errors
    /// None with the numbers of the table.
    pub fn new(dialect: &dyn Dialect) -> Result<Self, Failure> {
        let rows: Result<Vec<AnimalRecord>, Failure> =
            table1::animals().map(|row| AnimalRecord::new(&row)).collect();
        let table1 = rows?;
        let numbers = || table1.iter().flat_map(|animal| &animal.values);
        Ok(Self {
            schema_version: SCHEMA_VERSION,
            numbers: numbers().count(),
            within_last_digit: numbers().filter(|number| number.within_last_digit).count(),
            fig1: fig1().iter().map(|paragraph| paragraph.spelled(dialect)).collect(),
            table1,
        })
    }

    /// E* of the human as the paper prints it.
    pub(super) fn rounded_base(&self) -> Option<&'static str> {
        let human = self.table1.first()?;
        let base = human.values.iter().find(|number| number.name == Column::CompositeModulus.name());
        base.map(|number| number.printed)
    }
}

impl AnimalRecord {
    fn new(animal: &Animal) -> Result<Self, Failure> {
        let failed = |error: contact_scaling::drop_test::DropError| {
            Failure::outside("Table 1", "out-of-domain", error.to_string())
        };
        let scale = animal.scale();
        Ok(Self {
            taxon: animal.taxon(),
            mass_kg: scale.mass_kg(),
            sphere_count: scale.sphere_count(),
            radius_m: scale.radius_m(),
            values: animal.compared().map_err(failed)?.iter().map(NumberRecord::from).collect(),
        })
    }
}

impl From<&Compared> for NumberRecord {
    fn from(compared: &Compared) -> Self {
        let column = compared.column;
        Self {
            name: column.name(),
            label: column.label(),
            unit: column.unit(),
            equation: column.equation(),
            printed: compared.printed,
            computed: compared.computed,
            difference: compared.difference(),
            relative_difference: compared.relative_difference(),
            within_last_digit: compared.is_within_last_digit(),
            computed_from_rounded: compared.from_rounded.filter(|_| compared.is_from_rounded()),
        }
    }
}
