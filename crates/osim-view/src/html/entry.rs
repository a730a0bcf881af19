//! The outcome for one model: its row in the table, and everything else about it.

use osim_inspect::Inspection;
use osim_model::Property;
use osim_model::files::Failure;
use osim_model::messages::{Dialect, four_significant, readable};
use osim_patch::{NumberChange, Plan};

use crate::html::explained::marked_outside;
use crate::html::fragment::Fragment;
use crate::html::special::{Drawn, Facts, Indentation, is_too_deep};
use crate::report::explain::{ErrorCode, error};

/// Marks models that an earlier run has done.
pub(super) const EARLIER: &str = " †";
/// Factors that differ from place to place.
const UNEQUAL: &str = "unequal";
/// Properties whose old and new values are in the table.
const SHOWN: [Property; 3] = [Property::Radius, Property::Stiffness, Property::Dissipation];

/// The outcome for one model.
#[derive(Debug)]
pub struct Entry {
    pub(super) model: String,
    pub(super) outcome: String,
    /// Whether an earlier run has done it.
    pub(super) earlier: bool,
    /// Whether it could not be done.
    pub(super) failed: bool,
    /// The cells after the outcome, in the order of the columns; empty if there is only the outcome.
    pub(super) cells: Vec<Cell>,
    /// After its name where its details are closed.
    pub(super) summary: String,
    /// Everything else about it; `None` where it could not be done.
    pub(super) fragment: Option<Box<Fragment>>,
    /// What was wrong, if it could not be done.
    pub(super) error: Option<&'static ErrorCode>,
    /// What the page counts.
    pub(super) facts: Option<Facts>,
    /// What is drawn of it, if it is chosen.
    pub(super) drawn: Option<Drawn>,
}

impl Entry {
    pub(super) fn of_change(
        row: &RunRow,
        plan: &Plan,
        facts: Facts,
        drawn: Drawn,
        fragment: Fragment,
    ) -> Self {
        let mut cells = row.cells();
        cells.extend(SHOWN.map(|property| change(plan, property)));
        cells.push(indentation(facts.indentation));
        cells.push(some(plan.warnings.len()));
        let found = facts.counts.describe("no findings");
        cells.push(Cell::of_words(facts.counts.describe("–")));
        let summary = format!("{}; {found} in the new model", row.status);
        Self {
            cells,
            fragment: Some(Box::new(fragment)),
            facts: Some(facts),
            drawn: Some(drawn),
            summary,
            ..Self::not_done(&row.name(), row.status.clone())
        }
    }

    pub(super) fn of_inspection(
        inspected: &Inspection,
        facts: Facts,
        drawn: Drawn,
        fragment: Fragment,
    ) -> Self {
        let mut cells: Vec<Cell> = vec![
            inspected.mass_kg.map(readable).unwrap_or_default().into(),
            inspected.contacts_mass_kg.as_ref().map(|mass| readable(mass.value)).unwrap_or_default().into(),
            inspected.spheres_per_limb.map(|count| count.to_string()).unwrap_or_default().into(),
            indentation(facts.indentation),
        ];
        cells.push(Cell::of_words(facts.counts.describe("–")));
        let summary = facts.counts.describe("no findings");
        Self {
            cells,
            fragment: Some(Box::new(fragment)),
            facts: Some(facts),
            drawn: Some(drawn),
            summary,
            ..Self::not_done(&inspected.model, "read".to_owned())
        }
    }

    /// Marks the entry of a model that an earlier run has done.
    pub fn of_earlier_run(self) -> Self {
        Self { earlier: true, ..self }
    }

    /// A model that an earlier run has done, with only what that run has left.
    pub fn left_by_earlier_run(row: &RunRow, earlier: &EarlierRun) -> Self {
        let factor = |factor: Option<f64>, property: Property| {
            let below = match factor {
                Some(factor) => format!("×{}", four_significant(factor)),
                None if earlier.unequal_factors.iter().any(|name| name == property.name()) => {
                    UNEQUAL.to_owned()
                }
                None => String::new(),
            };
            Cell { below, ..Cell::default() }
        };
        let mut cells = row.cells();
        cells.extend([
            factor(earlier.radius_factor, Property::Radius),
            factor(earlier.stiffness_factor, Property::Stiffness),
            factor(earlier.dissipation_factor, Property::Dissipation),
            Cell::default(),
            some(earlier.warnings),
        ]);
        Self { cells, earlier: true, ..Self::not_done(&row.name(), row.status.clone()) }
    }

    /// A model that was to be changed, with only its row, and what was wrong if it failed.
    pub fn of_row(row: &RunRow, failed: Option<&RowError>) -> Self {
        let became = match failed {
            Some(failed) => {
                format!("{}: {}{}", row.status, place(failed.line, failed.column), failed.message)
            }
            None => row.status.clone(),
        };
        let error = failed.and_then(|failed| error(&failed.code));
        Self { error, failed: failed.is_some(), ..Self::not_done(&row.name(), became) }
    }

    /// A model that could not be read.
    pub fn failed(failure: &Failure, dialect: &dyn Dialect) -> Self {
        let message = failure.message.spelled(dialect);
        let became = format!("failed: {}{message}", place(failure.line, failure.column));
        Self { error: error(failure.code), failed: true, ..Self::not_done(&failure.model, became) }
    }

    /// A model of a folder that has no contacts.
    pub fn without_contacts(model: &str) -> Self {
        Self::not_done(model, "skipped: no contacts".to_owned())
    }

    /// A model with only the outcome.
    fn not_done(model: &str, became: String) -> Self {
        Self {
            model: model.to_owned(),
            outcome: became.clone(),
            earlier: false,
            failed: false,
            cells: Vec::new(),
            summary: became,
            fragment: None,
            error: None,
            facts: None,
            drawn: None,
        }
    }
}

/// Where in the model something is wrong.
fn place(line: Option<usize>, column: Option<usize>) -> String {
    match (line, column) {
        (Some(line), Some(column)) => format!("line {line}, column {column}: "),
        _ => String::new(),
    }
}

/// Old and new values with the factor between them.
fn change(plan: &Plan, property: Property) -> Cell {
    let changes: Vec<&NumberChange> =
        plan.changes.iter().filter(|change| change.property == property).collect();
    let mut ratios = changes.iter().map(|change| change.to / change.from);
    let Some(first) = ratios.next() else { return Cell::default() };
    let same = |ratio: f64| four_significant(ratio) == four_significant(first);
    let factor = if ratios.all(same) { format!("×{}", four_significant(first)) } else { UNEQUAL.to_owned() };
    let from = range(changes.iter().map(|change| change.from));
    let to = range(changes.iter().map(|change| change.to));
    Cell { text: format!("{from} → {to}"), below: factor, ..Cell::default() }
}

/// One number, or the smallest and the largest of several.
fn range(values: impl Iterator<Item = f64> + Clone) -> String {
    let low = four_significant(values.clone().fold(f64::INFINITY, f64::min));
    let high = four_significant(values.fold(f64::NEG_INFINITY, f64::max));
    if low == high { low } else { format!("{low}–{high}") }
}

/// x/R at rest, before and after where both are known.
fn indentation(indentation: Indentation) -> Cell {
    let Some(now) = indentation.now else { return Cell::default() };
    let outside = is_too_deep(now);
    let mut text = match indentation.before {
        Some(before) => format!("{} → {}", four_significant(before), four_significant(now)),
        None => four_significant(now),
    };
    if outside {
        text = marked_outside(&text);
    }
    Cell { text, outside, ..Cell::default() }
}

fn some(count: usize) -> Cell {
    if count == 0 { "–".to_owned().into() } else { count.to_string().into() }
}

/// A cell of the table of models.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(super) struct Cell {
    pub(super) text: String,
    /// A second line: the factor below old and new values.
    pub(super) below: String,
    /// Whether it is a figure outside its limit.
    pub(super) outside: bool,
    /// Whether it has words, not numbers.
    pub(super) words: bool,
}

impl Cell {
    /// Its class in the style sheet.
    pub(super) fn class(&self) -> Option<&'static str> {
        match (self.words, self.outside, self.text.contains(' ')) {
            (true, ..) => Some("words"),
            (false, true, _) => Some("values outside"),
            (false, false, true) => Some("values"),
            (false, false, false) => None,
        }
    }

    pub(super) fn of_words(text: String) -> Self {
        Self { text, words: true, ..Self::default() }
    }
}

impl From<String> for Cell {
    fn from(text: String) -> Self {
        Self { text, ..Self::default() }
    }
}

// What a run knows of one model, for the table.

/// The outcome for one model in a run.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct RunRow {
    /// Row of the manifest, from 1.
    pub row: Option<usize>,
    pub model: String,
    /// The file that results.
    pub output: Option<String>,
    /// The outcome, in words.
    pub status: String,
    /// What its contacts were made for, kg.
    pub contacts_mass_kg: Option<f64>,
    /// The mass they are made for afterwards, kg.
    pub target_mass_kg: Option<f64>,
    /// How many numbers and places changed.
    pub changes: usize,
}

/// What an earlier run has left of a model that it did.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct EarlierRun {
    /// New over old radius, where it is the same everywhere.
    pub radius_factor: Option<f64>,
    /// New over old stiffness, likewise.
    pub stiffness_factor: Option<f64>,
    /// New over old dissipation, likewise.
    pub dissipation_factor: Option<f64>,
    /// OpenSim's names of the properties whose factor is not the same everywhere.
    pub unequal_factors: Vec<String>,
    /// How many kinds of warnings there were.
    pub warnings: usize,
}

/// What was wrong with a model that could not be done.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct RowError {
    /// Stable short name.
    pub code: String,
    /// What is wrong, in the reader's words.
    pub message: String,
    /// Line of the place, from 1.
    pub line: Option<usize>,
    /// Column of the place, from 1.
    pub column: Option<usize>,
}

impl RunRow {
    /// A model in which nothing changed yet.
    pub fn new(model: impl Into<String>, status: impl Into<String>) -> Self {
        Self { model: model.into(), status: status.into(), ..Self::default() }
    }

    /// The model; in a manifest, where several rows may use one, with its row and the result.
    pub(super) fn name(&self) -> String {
        match (self.row, &self.output) {
            (Some(row), Some(output)) => format!("row {row}: {} → {output}", self.model),
            (Some(row), None) => format!("row {row}: {}", self.model),
            (None, _) => self.model.clone(),
        }
    }

    /// The cells that any change has: both masses, and how many changes.
    pub(super) fn cells(&self) -> Vec<Cell> {
        let masses = match (self.contacts_mass_kg, self.target_mass_kg) {
            (Some(contacts_mass_kg), Some(target_mass_kg)) => {
                format!("{} → {}", readable(contacts_mass_kg), readable(target_mass_kg))
            }
            (contacts_mass_kg, target_mass_kg) => {
                contacts_mass_kg.or(target_mass_kg).map(readable).unwrap_or_default()
            }
        };
        vec![masses.into(), self.changes.to_string().into()]
    }
}

impl RowError {
    /// An error without a place.
    pub fn new(code: impl Into<String>, message: impl Into<String>) -> Self {
        Self { code: code.into(), message: message.into(), line: None, column: None }
    }

    pub fn at(self, line: Option<usize>, column: Option<usize>) -> Self {
        Self { line, column, ..self }
    }
}
