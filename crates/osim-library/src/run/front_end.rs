//! Who asks for a run: what it wants of each model, and in whose words messages are.

use osim_model::files::OpenModel;
use osim_patch::Plan;
use osim_planning::BeforeAfter;
use osim_requests::spell::Speller;

use super::record::Record;
use super::task::Task;
use super::writing::{Results, Written};

/// What is wanted of a model beside its result.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Detail {
    /// Nothing.
    Result,
    /// Figures and findings of both states.
    BeforeAfter {
        /// Whether with the feet of both.
        feet: bool,
    },
}

/// The caller of a run. Its methods are called on the threads that do the work.
pub trait FrontEnd: Sync {
    /// What is kept of a model until its turn to be shown.
    type Shown: Send;

    /// The words of all messages.
    fn dialect(&self) -> &dyn Speller;

    /// What is wanted of each model.
    fn detail(&self) -> Detail;

    /// What is shown of a model that was changed.
    fn show(&self, changed: ChangedModel<'_>) -> Self::Shown;

    /// Whether no further model should be started.
    fn is_interrupted(&self) -> bool;

    /// One more model is done.
    fn done(&self, failed: bool);
}

/// A model that was changed, with everything about it.
#[non_exhaustive]
pub struct ChangedModel<'c> {
    /// The model and where its result goes.
    pub task: &'c Task,
    /// The model as it was.
    pub opened: &'c OpenModel,
    /// SHA-256 of each of its files, in order; empty where neither a summary nor details are wanted.
    pub inputs: &'c [String],
    /// What changes, spelled.
    pub plan: &'c Plan,
    /// The bytes that result.
    pub results: &'c Results<'c>,
    /// What was written.
    pub written: &'c Written,
    /// The same in one line of a summary.
    pub record: &'c Record,
    /// Both states, where they were wanted.
    pub before_after: Option<BeforeAfter>,
    /// Whether it was done by an earlier run: then nothing was written now.
    pub earlier: bool,
}
