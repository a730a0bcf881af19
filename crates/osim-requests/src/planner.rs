//! What a request plans for each of its models.

use std::path::{Path, PathBuf};

use osim_model::{Fault, Model};
use osim_patch::Plan;

use crate::options::{InspectionOptions, OutputOptions, SetFiles};

/// Plans the change of one model after the other, on any thread.
pub trait Planner: Send + Sync {
    /// Plans the change of a model.
    ///
    /// # Errors
    /// What only the caller can know, or what cannot be done with this model.
    fn plan(&self, model: &Model) -> Result<Plan, Fault>;

    /// Files that were read beside the models.
    fn reads(&self) -> Vec<PathBuf> {
        Vec::new()
    }

    /// Name of the verb, as notes and reports have it.
    fn name(&self) -> &'static str;

    /// How a model would be inspected with the same options.
    fn inspection(&self) -> InspectionOptions;

    /// Gravity that the contacts are scaled to, m/s², where that is asked for.
    fn target_gravity_m_s2(&self) -> Option<f64> {
        None
    }

    /// Everything its plans follow from but for the files: equal texts, equal plans.
    fn settings(&self) -> String;
}

/// A request that was checked: where its models are, what it plans, and where results go.
#[non_exhaustive]
pub struct Change {
    /// Files and folders.
    pub models: Vec<PathBuf>,
    /// Where results go.
    pub output: OutputOptions,
    /// Files of a standalone set.
    pub set_files: SetFiles,
    /// What is planned for each model.
    pub planner: Box<dyn Planner>,
}

impl Change {
    pub(crate) fn new(
        models: Vec<PathBuf>,
        output: OutputOptions,
        set_files: SetFiles,
        planner: impl Planner + 'static,
    ) -> Self {
        Self { models, output, set_files, planner: Box::new(planner) }
    }
}

/// The file's name without its folders, for notes and messages.
pub(crate) fn file_name(path: &Path) -> String {
    path.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned())
}
