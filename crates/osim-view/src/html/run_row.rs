//! What a run knows of one model, for the table.

use osim_model::messages::readable;

use super::cell::Cell;

/// The outcome for one model in a run.
#[derive(Debug, Clone, Default, PartialEq)]
#[non_exhaustive]
pub struct RunRow {
    /// Row of the manifest, from 1.
    pub row: Option<usize>,
    /// The model, as it was named.
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
#[non_exhaustive]
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
#[non_exhaustive]
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

    /// The same at a place.
    #[must_use]
    pub fn at(self, line: Option<usize>, column: Option<usize>) -> Self {
        Self { line, column, ..self }
    }
}
