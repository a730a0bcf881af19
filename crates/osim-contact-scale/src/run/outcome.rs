//! What became of one model, ready to be told in its turn.

use super::record::{Record, Status};
use super::task::Task;
use crate::args::RunArgs;
use crate::failure::Failure;
use crate::page::Entry;
use crate::terminal::Exit;

/// One thing to tell.
pub(super) enum Said {
    /// On standard output.
    Result(Vec<u8>),
    /// On standard error, beside the results.
    Note(String),
    /// A failure, on standard error.
    Error(String),
}

/// What became of one model.
pub(super) struct Outcome {
    pub said: Vec<Said>,
    pub record: Record,
    /// Done by an earlier run.
    pub earlier: bool,
    /// The model on the page; none where no page is asked for, or there is nothing but the record.
    pub entry: Option<Entry>,
}

impl Outcome {
    /// What the page says; it can be had once.
    pub(super) fn entry(&mut self) -> Entry {
        let bare = || match self.earlier {
            true => Entry::of_earlier_record(&self.record),
            false => Entry::of_record(&self.record),
        };
        self.entry.take().unwrap_or_else(bare)
    }

    pub(super) fn not_begun(task: &Task) -> Self {
        Self { said: Vec::new(), record: Record::of_task(task), earlier: false, entry: None }
    }

    pub(super) fn failed(failure: &Failure, mut record: Record, json: bool) -> Self {
        record.failed(failure);
        let mut said = Vec::new();
        if json {
            said.push(Said::Result(failure.json().into_bytes()));
        }
        said.push(Said::Error(failure.text()));
        Self { said, record, earlier: false, entry: None }
    }
}

/// How many models ended how.
#[derive(Debug, Default)]
pub(super) struct Count {
    written: usize,
    unchanged: usize,
    dry: usize,
    no_contacts: usize,
    failed: usize,
    not_begun: usize,
    earlier: usize,
    untold: bool,
}

impl Count {
    pub(super) fn add(&mut self, outcome: &Outcome) {
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

    /// Something could not be shown.
    pub(super) fn untold(&mut self) {
        self.untold = true;
    }

    pub(super) fn interrupted(&self) -> bool {
        self.not_begun > 0
    }

    pub(super) fn exit(&self) -> Exit {
        match (self.interrupted(), self.failed) {
            (true, _) => Exit::Interrupted,
            (false, 0) if !self.untold => Exit::Done,
            (false, _) => Exit::Failed,
        }
    }

    /// The last line of a run over several models.
    pub(super) fn text(&self, args: &RunArgs) -> String {
        let parts = [
            (self.written, "written"),
            (self.dry, "planned (dry run)"),
            (self.unchanged, "unchanged"),
            (self.earlier, "done before"),
            (self.no_contacts, "passed over (no contacts)"),
            (self.failed, "failed"),
            (self.not_begun, "not begun"),
        ];
        let all: usize = parts.iter().map(|(count, _)| count).sum();
        let parts: Vec<String> = parts
            .iter()
            .filter(|(count, _)| *count > 0)
            .map(|(count, what)| format!("{count} {what}"))
            .collect();
        let stopped = match (self.interrupted(), &args.summary) {
            (false, _) => "",
            (true, Some(_)) => "; stopped: go on with the same call and --resume",
            (true, None) => "; stopped",
        };
        let parts = if parts.is_empty() { "none done".to_owned() } else { parts.join(", ") };
        format!("note: {all} models: {parts}{stopped}\n")
    }
}
