//! The outcome for one model, ready to be reported in its turn.

use osim_model::files::Failure;

use super::record::{Record, Status};
use super::task::Task;

/// The outcome for one model; `S` is what a front end shows of it.
#[derive(Debug)]
#[non_exhaustive]
pub struct Outcome<S> {
    /// The same in one line of a summary.
    pub record: Record,
    /// Whether it was done by an earlier run.
    pub earlier: bool,
    /// What the front end shows of it; `None` if there is only the record.
    pub shown: Option<S>,
    /// What went wrong.
    pub failure: Option<Failure>,
}

impl<S> Outcome<S> {
    pub(super) fn not_begun(task: &Task) -> Self {
        Self { record: Record::of_task(task), earlier: false, shown: None, failure: None }
    }

    pub(super) fn without_contacts(mut record: Record) -> Self {
        record.status = Status::NoContacts;
        Self { record, earlier: false, shown: None, failure: None }
    }

    pub(super) fn failed(failure: Failure, mut record: Record) -> Self {
        record.failed(&failure);
        Self { record, earlier: false, shown: None, failure: Some(failure) }
    }
}

/// How many models ended how.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Counts {
    /// New files.
    pub written: usize,
    /// Nothing had to change.
    pub unchanged: usize,
    /// Planned only.
    pub dry: usize,
    /// Models of folders without contacts.
    pub no_contacts: usize,
    /// Something went wrong.
    pub failed: usize,
    /// The run was stopped before their turn.
    pub not_begun: usize,
    /// Done by an earlier run.
    pub earlier: usize,
}

impl Counts {
    pub(super) fn add<S>(&mut self, outcome: &Outcome<S>) {
        if outcome.earlier {
            self.earlier += 1;
            return;
        }
        let count = match outcome.record.status {
            Status::Written => &mut self.written,
            Status::Unchanged => &mut self.unchanged,
            Status::DryRun => &mut self.dry,
            Status::NoContacts => &mut self.no_contacts,
            Status::Failed => &mut self.failed,
            Status::NotBegun => &mut self.not_begun,
        };
        *count += 1;
    }

    /// Whether the run was stopped.
    #[must_use]
    pub fn interrupted(&self) -> bool {
        self.not_begun > 0
    }
}
