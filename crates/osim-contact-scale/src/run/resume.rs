//! `--resume`: what an earlier run has done, and whether that still holds.

use std::collections::HashMap;
use std::path::Path;

use anyhow::{Context, Result};

use super::journal::{Form, partial, whole_lines};
use super::record::{Record, Status, sha256};
use super::task::Task;
use crate::args::RunArgs;

/// Records of an earlier run.
#[derive(Default)]
pub(super) struct Done {
    records: HashMap<Key, Record>,
}

type Key = (Option<usize>, String, Option<String>);

/// What an earlier run means for a model now.
pub(super) enum Earlier {
    /// Nothing is known of it, or it was not finished.
    Unknown,
    /// All is as it was recorded.
    Holds(Box<Record>),
    /// The output is what that run wrote, but it would be another now.
    Outdated,
}

impl Done {
    /// Reads the summary, whole or partial, that `--resume` goes on with.
    pub(super) fn read(args: &RunArgs) -> Result<Self> {
        let mut done = Self::default();
        let Some(path) = args.summary.as_ref().filter(|_| args.resume) else { return Ok(done) };
        let form = Form::of(path)?;
        for path in [path.clone(), partial(path)] {
            if path.exists() {
                done.add(&path, form).with_context(|| format!("cannot go on with {}", path.display()))?;
            }
        }
        Ok(done)
    }

    fn add(&mut self, path: &Path, form: Form) -> Result<()> {
        let bytes = std::fs::read(path)?;
        let whole = whole_lines(&bytes);
        let records: Vec<Record> = match form {
            Form::Ndjson => {
                let lines = whole.split(|&byte| byte == b'\n').filter(|line| !line.is_empty());
                lines.map(serde_json::from_slice).collect::<Result<_, _>>()?
            }
            Form::Csv => {
                let mut reader = csv::Reader::from_reader(whole);
                reader.deserialize().collect::<Result<_, _>>()?
            }
        };
        let key = |record: &Record| (record.row, record.model.clone(), record.output.clone());
        self.records.extend(records.into_iter().map(|record| (key(&record), record)));
        Ok(())
    }

    pub(super) fn is_empty(&self) -> bool {
        self.records.is_empty()
    }

    /// What was recorded for `task`, compared with `now`: the model's digest and its recipe.
    pub(super) fn of(&self, task: &Task, input: &str, now: &Record) -> Earlier {
        let key = (now.row, now.model.clone(), now.output.clone());
        let Some(record) = self.records.get(&key) else { return Earlier::Unknown };
        let same_recipe = record.recipe == now.recipe && record.tool_version == now.tool_version;
        let same_input = record.sha256_input.as_deref() == Some(input);
        match record.status {
            Status::Unchanged | Status::NoContacts if same_recipe && same_input => {
                Earlier::Holds(Box::new(record.clone()))
            }
            Status::Written => {
                let wrote = record.sha256_output.as_deref();
                if task.order.in_place {
                    let done = same_recipe && wrote == Some(input);
                    return if done { Earlier::Holds(Box::new(record.clone())) } else { Earlier::Unknown };
                }
                let there = task.output().and_then(|path| std::fs::read(path).ok());
                match there.map(|bytes| sha256(&bytes)) {
                    Some(there) if Some(there.as_str()) != wrote => Earlier::Unknown,
                    Some(_) if same_recipe && same_input => Earlier::Holds(Box::new(record.clone())),
                    Some(_) => Earlier::Outdated,
                    None => Earlier::Unknown,
                }
            }
            _ => Earlier::Unknown,
        }
    }
}
