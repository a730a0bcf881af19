//! The outcome for one model: its row in the table, and everything else about it.

use osim_inspect::{Counts, Figure, Inspection, SphereFigures};
use osim_model::files::Failure;
use osim_model::wording::Dialect;
use osim_model::{Property, four_significant, readable};
use osim_patch::Plan;

use super::fragment::Fragment;
use super::run_row::{EarlierRun, RowError, RunRow};
use crate::explain::{ErrorCode, error};

/// Factors that differ from place to place.
const UNEQUAL: &str = "unequal";

/// The outcome for one model.
#[derive(Debug)]
pub struct Entry {
    pub(super) model: String,
    /// In the order of the columns.
    pub(super) cells: Vec<String>,
    /// After its name where its details are closed.
    pub(super) summary: String,
    /// Everything else about it; `None` where it could not be done.
    pub(super) fragment: Option<Box<Fragment>>,
    /// What was wrong, where it could not be done.
    pub(super) error: Option<&'static ErrorCode>,
}

impl Entry {
    /// A model that was changed; `found` in the new one.
    pub(super) fn of_change(row: &RunRow, plan: &Plan, found: Counts, fragment: Fragment) -> Self {
        let became = row.status.clone();
        let mut cells = row.cells(&became);
        cells.extend([
            ratio(plan, Property::Radius),
            ratio(plan, Property::Stiffness),
            ratio(plan, Property::Dissipation),
            some(plan.warnings.len()),
        ]);
        cells.extend(counts(found));
        let summary = format!("{became}; {} in the new model", found.describe("no findings"));
        Self { model: row.name(), cells, summary, fragment: Some(Box::new(fragment)), error: None }
    }

    /// A model that was inspected.
    pub(super) fn of_inspection(inspected: &Inspection, found: Counts, fragment: Fragment) -> Self {
        let hertz = |sphere: &SphereFigures| sphere.value(Figure::Indentation);
        let deepest = inspected.figures.spheres().filter_map(hertz).reduce(f64::max);
        let mut cells = vec![
            "read".to_owned(),
            inspected.mass_kg.map(readable).unwrap_or_default(),
            inspected.contacts_mass_kg.as_ref().map(|mass| readable(mass.value)).unwrap_or_default(),
            inspected.spheres_per_limb.map(|count| count.to_string()).unwrap_or_default(),
            deepest.map(four_significant).unwrap_or_default(),
        ];
        cells.extend(counts(found));
        let summary = found.describe("no findings");
        Self {
            model: inspected.model.clone(),
            cells,
            summary,
            fragment: Some(Box::new(fragment)),
            error: None,
        }
    }

    /// The same of a model that an earlier run has done.
    #[must_use]
    pub fn of_earlier_run(mut self) -> Self {
        for text in self.cells.first_mut().into_iter().chain([&mut self.summary]) {
            text.insert_str(0, "done by an earlier run: ");
        }
        self
    }

    /// A model that an earlier run has done, of which there is nothing but what that run has left.
    #[must_use]
    pub fn left_by_earlier_run(row: &RunRow, earlier: &EarlierRun) -> Self {
        let factor = |factor: Option<f64>, property: Property| match factor {
            Some(factor) => four_significant(factor),
            None if earlier.unequal_factors.iter().any(|name| name == property.name()) => UNEQUAL.to_owned(),
            None => String::new(),
        };
        let became = format!("done by an earlier run: {}", row.status);
        let mut cells = row.cells(&became);
        cells.extend([
            factor(earlier.radius_factor, Property::Radius),
            factor(earlier.stiffness_factor, Property::Stiffness),
            factor(earlier.dissipation_factor, Property::Dissipation),
            some(earlier.warnings),
        ]);
        Self { model: row.name(), cells, summary: became, fragment: None, error: None }
    }

    /// A model that was to be changed, of which there is nothing but its row, and what was wrong where it failed.
    #[must_use]
    pub fn of_row(row: &RunRow, failed: Option<&RowError>) -> Self {
        let became = match failed {
            Some(failed) => {
                format!("{}: {}{}", row.status, place(failed.line, failed.column), failed.message)
            }
            None => row.status.clone(),
        };
        let error = failed.and_then(|failed| error(&failed.code));
        Self { error, ..Self::not_done(&row.name(), became) }
    }

    /// A model that could not be read.
    #[must_use]
    pub fn failed(failure: &Failure, dialect: &dyn Dialect) -> Self {
        let message = failure.message.spelled(dialect);
        let became = format!("failed: {}{message}", place(failure.line, failure.column));
        Self { error: error(failure.code), ..Self::not_done(&failure.model, became) }
    }

    /// A model of a folder that has no contacts.
    #[must_use]
    pub fn without_contacts(model: &str) -> Self {
        Self::not_done(model, "skipped: no contacts".to_owned())
    }

    /// A model of which there is nothing but the outcome.
    fn not_done(model: &str, became: String) -> Self {
        Self {
            model: model.to_owned(),
            cells: vec![became.clone()],
            summary: became,
            fragment: None,
            error: None,
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

/// New over old, where it is the same everywhere.
fn ratio(plan: &Plan, property: Property) -> String {
    let mut ratios = plan.changes.iter().filter(|change| change.property == property).map(|c| c.to / c.from);
    let Some(first) = ratios.next() else { return String::new() };
    let same = |ratio: f64| four_significant(ratio) == four_significant(first);
    if ratios.all(same) { four_significant(first) } else { UNEQUAL.to_owned() }
}

fn counts(found: Counts) -> [String; 3] {
    [found.error, found.warn, found.info].map(some)
}

fn some(count: usize) -> String {
    if count == 0 { "–".to_owned() } else { count.to_string() }
}
