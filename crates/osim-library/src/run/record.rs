//! One line of a summary: the outcome for one model. `docs/libraries.md` describes every column.

use std::collections::BTreeMap;

use osim_model::Property;
use osim_model::files::{Failure, FileName};
use osim_patch::{NumberChange, Plan};
use osim_planning::{cell, from_cell, with_text_mark, without_text_mark};
use serde::{Deserialize, Serialize};

use crate::run::task::Task;

/// The outcome for a model.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum Status {
    /// A new file is there.
    Written,
    /// Nothing had to change, and nothing was written.
    Unchanged,
    /// The change was only planned, in a dry run.
    DryRun,
    /// A folder's model without contacts.
    NoContacts,
    /// The error says why.
    Failed,
    /// The run was stopped before its turn.
    #[default]
    NotBegun,
}

impl Status {
    /// The status in words.
    pub const fn describe(self) -> &'static str {
        match self {
            Self::Written => "written",
            Self::Unchanged => "unchanged",
            Self::DryRun => "dry run: nothing written",
            Self::NoContacts => "skipped: no contacts",
            Self::Failed => "failed",
            Self::NotBegun => "not begun: the run was stopped",
        }
    }
}

/// Columns of a summary. Masses in kg; factors are new over old.
///
/// A table without `model`, `status` and the other columns that are never empty is not a summary: a run that goes on refuses it
/// rather than replace it.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
pub struct Record {
    /// Row of the manifest, from 1.
    pub row: Option<usize>,
    /// The model, as the caller named it.
    pub model: String,
    /// The model's name in bytes, if it is not UTF-8; in NDJSON only.
    #[serde(skip)]
    pub model_bytes: Option<Vec<u8>>,
    /// The user's own columns, as the table of the batch has them; in a summary table they come last.
    #[serde(skip)]
    pub user_columns: Vec<(String, String)>,
    /// The file that is written.
    pub output: Option<String>,
    /// The output's name in bytes, if it is not UTF-8; in NDJSON only.
    #[serde(skip)]
    pub output_bytes: Option<Vec<u8>>,
    /// Outcome for the model.
    pub status: Status,
    /// The mass that the contacts were made for before the change.
    pub contacts_mass_kg: Option<f64>,
    /// Source of the mass that the contacts were made for.
    pub contacts_mass_source: Option<String>,
    /// The mass that the contacts are made for after the change.
    pub target_mass_kg: Option<f64>,
    /// How many whole objects are added or removed.
    pub objects: usize,
    /// How many numbers and places change.
    pub changes: usize,
    /// What the radii were, m, where they changed and were the same everywhere.
    pub radius_from_m: Option<f64>,
    /// What the radii became, m, where they changed and became the same everywhere.
    pub radius_to_m: Option<f64>,
    /// Factor of the radii.
    pub radius_factor: Option<f64>,
    /// What `stiffness` was, where it changed and was the same everywhere.
    pub stiffness_from: Option<f64>,
    /// What `stiffness` became, where it changed and became the same everywhere.
    pub stiffness_to: Option<f64>,
    /// Factor of `stiffness`.
    pub stiffness_factor: Option<f64>,
    /// What `dissipation` was, where it changed and was the same everywhere.
    pub dissipation_from: Option<f64>,
    /// What `dissipation` became, where it changed and became the same everywhere.
    pub dissipation_to: Option<f64>,
    /// Factor of `dissipation`.
    pub dissipation_factor: Option<f64>,
    /// What `static_friction` was, where it changed and was the same everywhere.
    pub static_friction_from: Option<f64>,
    /// What `static_friction` became, where it changed and became the same everywhere.
    pub static_friction_to: Option<f64>,
    /// Factor of `static_friction`.
    pub static_friction_factor: Option<f64>,
    /// What `dynamic_friction` was, where it changed and was the same everywhere.
    pub dynamic_friction_from: Option<f64>,
    /// What `dynamic_friction` became, where it changed and became the same everywhere.
    pub dynamic_friction_to: Option<f64>,
    /// Factor of `dynamic_friction`.
    pub dynamic_friction_factor: Option<f64>,
    /// What `viscous_friction` was, where it changed and was the same everywhere.
    pub viscous_friction_from: Option<f64>,
    /// What `viscous_friction` became, where it changed and became the same everywhere.
    pub viscous_friction_to: Option<f64>,
    /// Factor of `viscous_friction`.
    pub viscous_friction_factor: Option<f64>,
    /// What `transition_velocity` was, where it changed and was the same everywhere.
    pub transition_velocity_from: Option<f64>,
    /// What `transition_velocity` became, where it changed and became the same everywhere.
    pub transition_velocity_to: Option<f64>,
    /// Factor of `transition_velocity`.
    pub transition_velocity_factor: Option<f64>,
    /// What `constant_contact_force` was, where it changed and was the same everywhere.
    pub constant_contact_force_from: Option<f64>,
    /// What `constant_contact_force` became, where it changed and became the same everywhere.
    pub constant_contact_force_to: Option<f64>,
    /// Factor of `constant_contact_force`.
    pub constant_contact_force_factor: Option<f64>,
    /// What `hertz_smoothing` was, where it changed and was the same everywhere.
    pub hertz_smoothing_from: Option<f64>,
    /// What `hertz_smoothing` became, where it changed and became the same everywhere.
    pub hertz_smoothing_to: Option<f64>,
    /// Factor of `hertz_smoothing`.
    pub hertz_smoothing_factor: Option<f64>,
    /// What `hunt_crossley_smoothing` was, where it changed and was the same everywhere.
    pub hunt_crossley_smoothing_from: Option<f64>,
    /// What `hunt_crossley_smoothing` became, where it changed and became the same everywhere.
    pub hunt_crossley_smoothing_to: Option<f64>,
    /// Factor of `hunt_crossley_smoothing`.
    pub hunt_crossley_smoothing_factor: Option<f64>,
    /// Properties whose factor is not the same everywhere.
    pub unequal_factors: String,
    /// Codes of the findings.
    pub findings: String,
    /// Code of the error.
    pub error_code: Option<String>,
    /// The error, in words.
    pub error: Option<String>,
    /// Line of the error.
    pub line: Option<usize>,
    /// Column of the error.
    pub column: Option<usize>,
    /// SHA-256 of the model.
    pub sha256_input: Option<String>,
    /// SHA-256 of what was written.
    pub sha256_output: Option<String>,
    /// SHA-256 of the geometry set that was written with a standalone force set.
    pub sha256_geometry_output: Option<String>,
    /// SHA-256 of everything else that the output follows from: options, version, other files.
    pub sha256_settings: Option<String>,
    /// Version of the program.
    pub tool_version: String,
    /// The folder where the names of model and output begin, seen from the folder of the summary.
    pub folder: Option<String>,
}

/// A record as NDJSON has it: beside it the bytes of names that are not text.
#[derive(Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[serde(expecting = "a JSON object with the outcome for a model")]
#[cfg_attr(feature = "schemas", schemars(deny_unknown_fields))]
pub struct JsonRecord {
    /// The columns of the table.
    #[serde(flatten)]
    pub record: Record,
    /// `model` in bytes, if it is not UTF-8.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub model_bytes: Option<Vec<u8>>,
    /// `output` in bytes, if it is not UTF-8.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub output_bytes: Option<Vec<u8>>,
    /// The user's own columns of the table: those that are not options, and those whose names begin with #.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub columns: BTreeMap<String, String>,
}

impl From<Record> for JsonRecord {
    fn from(mut record: Record) -> Self {
        let (model_bytes, output_bytes) = (record.model_bytes.take(), record.output_bytes.take());
        let columns = std::mem::take(&mut record.user_columns).into_iter().collect();
        Self { record, model_bytes, output_bytes, columns }
    }
}

impl From<JsonRecord> for Record {
    fn from(line: JsonRecord) -> Self {
        Self {
            model_bytes: line.model_bytes,
            output_bytes: line.output_bytes,
            user_columns: line.columns.into_iter().collect(),
            ..line.record
        }
    }
}

impl Record {
    /// The line of a task that was not begun.
    pub(crate) fn not_begun(task: &Task) -> Self {
        let (model, model_bytes) = FileName::from(task.source.path.as_path()).into_parts();
        let (output, output_bytes) = task.output().map(|path| FileName::from(path).into_parts()).unzip();
        Self {
            row: task.row,
            model,
            model_bytes,
            output,
            output_bytes: output_bytes.flatten(),
            user_columns: task.user_columns.clone(),
            tool_version: env!("CARGO_PKG_VERSION").to_owned(),
            ..Self::default()
        }
    }

    /// The line of a model that could not be listed.
    pub fn of_failure(failure: &Failure) -> Self {
        let (model, model_bytes) = failure.model.clone().into_parts();
        let tool_version = env!("CARGO_PKG_VERSION").to_owned();
        let mut record = Self { model, model_bytes, tool_version, ..Self::default() };
        record.add_failure(failure);
        record
    }

    /// Adds the masses, changes and findings of a plan.
    pub(super) fn add_plan(&mut self, plan: &Plan) {
        if let Some(masses) = &plan.masses {
            self.contacts_mass_kg = Some(masses.contacts_mass.kg);
            self.contacts_mass_source = Some(masses.contacts_mass.source.as_str().to_owned());
            self.target_mass_kg = Some(masses.target_mass_kg);
        }
        self.objects = plan.objects().len();
        self.changes = plan.changes.len() + plan.moves.len();
        let mut unequal_factors = Vec::new();
        for property in Property::changeable() {
            let changed = common_numbers(plan, property);
            if changed.is_some_and(|[.., factor]| factor.is_none()) {
                unequal_factors.push(property.as_str());
            }
            if let Some([from, to, factor]) = self.columns_of(property) {
                [*from, *to, *factor] = changed.unwrap_or_default();
            }
        }
        self.unequal_factors = unequal_factors.join(" ");
        let mut codes: Vec<&str> = plan.findings.iter().map(|finding| finding.code().as_str()).collect();
        codes.dedup();
        self.findings = codes.join(" ");
    }

    /// The columns of a property: old value, new value and factor.
    fn columns_of(&mut self, property: Property) -> Option<[&mut Option<f64>; 3]> {
        macro_rules! columns {
            ($($from:ident $to:ident $factor:ident: $property:ident),+ $(,)?) => {
                match property {
                    $(Property::$property => Some([&mut self.$from, &mut self.$to, &mut self.$factor]),)+
                    _ => None,
                }
            };
        }
        columns! {
            radius_from_m radius_to_m radius_factor: Radius,
            stiffness_from stiffness_to stiffness_factor: Stiffness,
            dissipation_from dissipation_to dissipation_factor: Dissipation,
            static_friction_from static_friction_to static_friction_factor: StaticFriction,
            dynamic_friction_from dynamic_friction_to dynamic_friction_factor: DynamicFriction,
            viscous_friction_from viscous_friction_to viscous_friction_factor: ViscousFriction,
            transition_velocity_from transition_velocity_to transition_velocity_factor: TransitionVelocity,
            constant_contact_force_from constant_contact_force_to constant_contact_force_factor: ConstantContactForce,
            hertz_smoothing_from hertz_smoothing_to hertz_smoothing_factor: HertzSmoothing,
            hunt_crossley_smoothing_from hunt_crossley_smoothing_to hunt_crossley_smoothing_factor: HuntCrossleySmoothing,
        }
    }

    /// The record with names and messages as cells of a CSV table, see [`cell`].
    pub(super) fn with_texts_as_cells(&self) -> Self {
        // A message has no control characters.
        let error = self.error.as_deref().map(|text| with_text_mark(text).into_owned());
        Self { error, ..self.with_changed_names(|name| cell(name).into_owned()) }
    }

    /// The record with its names and messages as they were before [`with_texts_as_cells`](Self::with_texts_as_cells).
    pub(super) fn with_texts_from_cells(&self) -> Self {
        let error = self.error.as_deref().map(|text| without_text_mark(text).to_owned());
        Self { error, ..self.with_changed_names(|name| from_cell(name).into_owned()) }
    }

    /// The record with its names of files changed by `change`.
    fn with_changed_names(&self, change: impl Fn(&str) -> String) -> Self {
        Self { model: change(&self.model), output: self.output.as_deref().map(&change), ..self.clone() }
    }

    /// The outcome in this earlier record, with the names and the row of the record `current`.
    pub(super) fn with_names_of(self, current: &Self) -> Self {
        Self {
            row: current.row,
            model: current.model.clone(),
            model_bytes: current.model_bytes.clone(),
            user_columns: current.user_columns.clone(),
            output: current.output.clone(),
            output_bytes: current.output_bytes.clone(),
            folder: current.folder.clone(),
            ..self
        }
    }

    /// The record of an output that was written by an earlier run and still exists.
    pub(super) fn into_written_record(self) -> Self {
        let status = if self.sha256_output.is_some() { Status::Written } else { self.status };
        Self { status, error_code: None, error: None, line: None, column: None, ..self }
    }

    /// The digests in this earlier record, with the outcome of the record `current`.
    pub(super) fn with_outcome_of(self, current: &Self) -> Self {
        Self {
            status: current.status,
            error_code: current.error_code.clone(),
            error: current.error.clone(),
            line: current.line,
            column: current.column,
            ..self.with_names_of(current)
        }
    }

    /// Records that the model failed, and why.
    pub(super) fn add_failure(&mut self, failure: &Failure) {
        self.status = Status::Failed;
        self.error_code = Some(failure.code.to_owned());
        self.error = Some(failure.message.to_string());
        self.line = failure.line;
        self.column = failure.column;
        self.sha256_output = None;
        self.sha256_geometry_output = None;
    }
}

/// Factors whose relative difference is smaller than this differ only by rounding.
const ROUNDING_ERROR: f64 = 1e-12;

/// The old value, the new value and the factor of a property, each if it is the same in all contacts that change; `None` if none changes.
fn common_numbers(plan: &Plan, property: Property) -> Option<[Option<f64>; 3]> {
    let changes: Vec<&NumberChange> =
        plan.changes.iter().filter(|change| change.property == property).collect();
    let first = changes.first()?;
    let common = |value: fn(&NumberChange) -> f64| {
        let first = value(first);
        changes.iter().all(|change| value(change) == first).then_some(first)
    };
    Some([common(|change| change.from), common(|change| change.to), common_factor(&changes)])
}

/// The factor that all changes have in common; `None` if they differ.
fn common_factor(changes: &[&NumberChange]) -> Option<f64> {
    let factor = |change: &NumberChange| change.factor.unwrap_or(change.to / change.from);
    let first = factor(changes.first()?);
    // A value that was 0 has no factor.
    let same = |change: &&NumberChange| (factor(change) - first).abs() <= ROUNDING_ERROR * first.abs();
    (first.is_finite() && changes.iter().all(same)).then_some(first)
}
