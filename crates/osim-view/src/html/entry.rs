//! The entry of one model on a page: a row in the table of models, and sections.

use osim_inspect::Inspection;
use osim_model::Property;
use osim_model::files::Failure;
use osim_model::messages::{Dialect, four_significant, readable};
use osim_patch::{NumberChange, Plan};

use crate::html::explained::marked_outside;
use crate::html::fragment::Fragment;
use crate::html::special_models::{DrawnStates, Indentation, ModelFacts, is_too_deep};
use crate::report::explain::{ErrorCode, error};

/// The mark of models that an earlier run has already changed.
pub(super) const DONE_EARLIER_MARK: &str = " †";
/// The text in a cell if the factors of a property are not equal.
const UNEQUAL_WORD: &str = "unequal";
/// Properties whose old and new values are columns of the table.
const PROPERTIES_SHOWN: [Property; 3] = [Property::Radius, Property::Stiffness, Property::Dissipation];

/// The entry of one model on a page.
#[derive(Default)]
pub struct Entry {
    pub(super) model: String,
    pub(super) outcome: String,
    /// Whether an earlier run has already changed the model.
    pub(super) earlier: bool,
    /// Whether the model could not be read or changed.
    pub(super) failed: bool,
    /// The cells after the cell with the outcome, in the order of the columns; empty if the row has only the outcome.
    pub(super) cells: Vec<Cell>,
    /// The text after the name of the model, in the line that opens its folded sections.
    pub(super) summary: String,
    /// Sections about the model; `None` if it could not be read or changed.
    pub(super) fragment: Option<Box<Fragment>>,
    /// The error, if the model could not be read or changed.
    pub(super) error: Option<&'static ErrorCode>,
    /// Numbers about the model for the summary of the page.
    pub(super) facts: Option<ModelFacts>,
    /// The states of the model for plots, which are drawn if the page chooses this model.
    pub(super) drawn: Option<DrawnStates>,
}

impl Entry {
    pub(super) fn of_changed_model(
        row: &RunRow,
        plan: &Plan,
        facts: ModelFacts,
        drawn: DrawnStates,
        fragment: Fragment,
    ) -> Self {
        let mut cells = row.cells();
        cells.extend(PROPERTIES_SHOWN.map(|property| cell_of_property(plan, property)));
        cells.push(cell_of_indentation(facts.indentation));
        cells.push(cell_of_count(plan.findings.len()));
        let found = facts.counts.describe("no findings");
        cells.push(Cell::with_words(facts.counts.describe("–")));
        let summary = format!("{}; {found} in the new model", row.status);
        Self {
            cells,
            fragment: Some(Box::new(fragment)),
            facts: Some(facts),
            drawn: Some(drawn),
            summary,
            ..Self::with_outcome_only(&row.name(), row.status.clone())
        }
    }

    pub(super) fn of_inspected_model(
        inspected: &Inspection,
        facts: ModelFacts,
        drawn: DrawnStates,
        fragment: Fragment,
    ) -> Self {
        let cells: Vec<Cell> = vec![
            inspected.mass_kg.map(readable).unwrap_or_default().into(),
            inspected.contacts_mass_kg.as_ref().map(|mass| readable(mass.value)).unwrap_or_default().into(),
            inspected.spheres_per_limb.map(|count| count.to_string()).unwrap_or_default().into(),
            cell_of_indentation(facts.indentation),
            Cell::with_words(facts.counts.describe("–")),
        ];
        let summary = facts.counts.describe("no findings");
        Self {
            cells,
            fragment: Some(Box::new(fragment)),
            facts: Some(facts),
            drawn: Some(drawn),
            summary,
            ..Self::with_outcome_only(&inspected.model, "read".to_owned())
        }
    }

    /// Marks the entry as one that an earlier run has made.
    pub fn marked_as_earlier(self) -> Self {
        Self { earlier: true, ..self }
    }

    /// The entry of a model that an earlier run has changed, from its line in the summary of that run: new over old radius, stiffness and
    /// dissipation, OpenSim's names of properties for which this ratio differs between contacts, and the number of different codes of findings.
    pub fn of_earlier_run(row: &RunRow, factors: [Option<f64>; 3], unequal: &str, findings: usize) -> Self {
        let factor = |(factor, property): (Option<f64>, Property)| {
            let second_line = match factor {
                Some(factor) => format!("×{}", four_significant(factor)),
                None if unequal.split(' ').any(|name| name == property.as_str()) => UNEQUAL_WORD.to_owned(),
                None => String::new(),
            };
            Cell { second_line, ..Cell::default() }
        };
        let mut cells = row.cells();
        cells.extend(factors.into_iter().zip(PROPERTIES_SHOWN).map(factor));
        cells.extend([Cell::default(), cell_of_count(findings)]);
        Self { cells, earlier: true, ..Self::with_outcome_only(&row.name(), row.status.clone()) }
    }

    /// The entry of a model in a run, from its row alone.
    pub fn of_row(row: &RunRow) -> Self {
        Self::with_outcome_only(&row.name(), row.status.clone())
    }

    /// The entry of a model that failed in a run: with the code, the message, and the line and column of the error, from 1.
    pub fn failed_row(row: &RunRow, code: &str, message: &str, at: (Option<usize>, Option<usize>)) -> Self {
        let outcome = format!("{}: {}{message}", row.status, place_in_words(at.0, at.1));
        Self { error: error(code), failed: true, ..Self::with_outcome_only(&row.name(), outcome) }
    }

    /// The entry of a model that could not be read.
    pub fn failed(failure: &Failure, dialect: &dyn Dialect) -> Self {
        let message = failure.message.spelled(dialect);
        let outcome = format!("failed: {}{message}", place_in_words(failure.line, failure.column));
        Self { error: error(failure.code), failed: true, ..Self::with_outcome_only(&failure.model, outcome) }
    }

    /// The entry of a model in a folder, if the model has no contacts.
    pub fn without_contacts(model: &str) -> Self {
        Self::with_outcome_only(model, "skipped: no contacts".to_owned())
    }

    fn with_outcome_only(model: &str, outcome: String) -> Self {
        Self { model: model.to_owned(), outcome: outcome.clone(), summary: outcome, ..Self::default() }
    }
}

/// The place of an error in words, before its message.
fn place_in_words(line: Option<usize>, column: Option<usize>) -> String {
    match (line, column) {
        (Some(line), Some(column)) => format!("line {line}, column {column}: "),
        _ => String::new(),
    }
}

/// The cell with old and new values of a property, and its factor.
fn cell_of_property(plan: &Plan, property: Property) -> Cell {
    let changes: Vec<&NumberChange> =
        plan.changes.iter().filter(|change| change.property == property).collect();
    let mut ratios = changes.iter().map(|change| change.to / change.from);
    let Some(first) = ratios.next() else { return Cell::default() };
    let same = |ratio: f64| four_significant(ratio) == four_significant(first);
    let factor =
        if ratios.all(same) { format!("×{}", four_significant(first)) } else { UNEQUAL_WORD.to_owned() };
    let from = range_in_words(changes.iter().map(|change| change.from));
    let to = range_in_words(changes.iter().map(|change| change.to));
    Cell { text: format!("{from} → {to}"), second_line: factor, ..Cell::default() }
}

/// One number, or the smallest and the largest number if there are several.
fn range_in_words(values: impl Iterator<Item = f64> + Clone) -> String {
    let low = four_significant(values.clone().fold(f64::INFINITY, f64::min));
    let high = four_significant(values.fold(f64::NEG_INFINITY, f64::max));
    if low == high { low } else { format!("{low}–{high}") }
}

/// The cell with x/R in equilibrium; before and after the change if both are known.
fn cell_of_indentation(indentation: Indentation) -> Cell {
    let Some(after) = indentation.now else { return Cell::default() };
    let outside = is_too_deep(after);
    let mut text = match indentation.before {
        Some(before) => format!("{} → {}", four_significant(before), four_significant(after)),
        None => four_significant(after),
    };
    if outside {
        text = marked_outside(&text);
    }
    Cell { text, outside, ..Cell::default() }
}

/// A cell with a number of findings; a dash for 0.
fn cell_of_count(count: usize) -> Cell {
    if count == 0 { "–".to_owned().into() } else { count.to_string().into() }
}

/// A cell in the row of a model.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(super) struct Cell {
    pub(super) text: String,
    /// A second line in the cell, such as the factor below the old and the new value.
    pub(super) second_line: String,
    /// Whether the figure is outside its limit.
    pub(super) outside: bool,
    /// Whether the cell has words, not numbers.
    pub(super) words: bool,
}

impl Cell {
    /// Class of the cell in the style sheet of the page.
    pub(super) fn class(&self) -> Option<&'static str> {
        match (self.words, self.outside, self.text.contains(' ')) {
            (true, ..) => Some("words"),
            (false, true, _) => Some("values outside"),
            (false, false, true) => Some("values"),
            (false, false, false) => None,
        }
    }

    /// A cell of the table that has words instead of numbers.
    pub(super) fn with_words(text: String) -> Self {
        Self { text, words: true, ..Self::default() }
    }
}

impl From<String> for Cell {
    fn from(text: String) -> Self {
        Self { text, ..Self::default() }
    }
}

/// The numbers about one model of a run for its row in the table.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct RunRow {
    /// Row of the model in the manifest, from 1.
    pub row: Option<usize>,
    pub model: String,
    pub output: Option<String>,
    pub status: String,
    /// The mass that the old contacts were made for, kg.
    pub contacts_mass_kg: Option<f64>,
    /// The mass that the new contacts are made for, kg.
    pub target_mass_kg: Option<f64>,
    /// Number of values and sphere locations that the run changed in the model.
    pub changes: usize,
}

impl RunRow {
    /// The row of a model without changes.
    pub fn new(model: impl Into<String>, status: impl Into<String>) -> Self {
        Self { model: model.into(), status: status.into(), ..Self::default() }
    }

    /// The name of the model; in a manifest, where several rows can have the same model, with its row and output.
    pub(super) fn name(&self) -> String {
        match (self.row, &self.output) {
            (Some(row), Some(output)) => format!("row {row}: {} → {output}", self.model),
            (Some(row), None) => format!("row {row}: {}", self.model),
            (None, _) => self.model.clone(),
        }
    }

    /// The cells with the mass of the old contacts, the mass of the new contacts and the number of changes.
    pub(super) fn cells(&self) -> Vec<Cell> {
        let masses = match (self.contacts_mass_kg, self.target_mass_kg) {
            (Some(from), Some(to)) => format!("{} → {}", readable(from), readable(to)),
            (one, other) => one.or(other).map(readable).unwrap_or_default(),
        };
        vec![masses.into(), self.changes.to_string().into()]
    }
}
