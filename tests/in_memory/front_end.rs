//! What a front end without a disk does with a request that changes a model.

use std::path::{Path, PathBuf};

use osim_model::FileId;
use osim_model::files::{Failure, InMemory, ModelFiles, OpenModel};
use osim_patch::Plan;
use osim_planning::{PreparedChange, prepare};
use osim_requests::Request;
use osim_requests::options::OutputOptions;
use osim_requests::spell::CommandLine;
use osim_view::report::json::{FailureRecord, PlanRecord, line};
use osim_view::report::plan;
use serde_json::Value;

use crate::support::Bench;

/// The request of a dictionary, which has to be one for the verb that is named first.
macro_rules! request {
    ($verb:ident, $($json:tt)+) => {
        match $crate::front_end::read(&serde_json::json!($($json)+)) {
            osim_requests::Request::$verb(request) => *request,
            other => panic!("{other:?}"),
        }
    };
}
pub(crate) use request;

#[track_caller]
pub(crate) fn read(json: &Value) -> Request {
    Request::from_json(json.to_string().as_bytes()).unwrap()
}

/// The files of a folder in memory, by their names there.
/// The date of the command's runs.
pub(crate) const TODAY: &str = "2025-11-26";

pub(crate) fn files_of(bench: &Bench) -> InMemory {
    let mut files = InMemory::from_iter(bench.files());
    files.set_today(TODAY);
    files
}

/// A model that was changed.
pub(crate) struct Changed {
    pub(crate) opened: OpenModel,
    /// Spelled in the words of the command.
    pub(crate) plan: Plan,
    /// What comes of each of its files that change: the model first.
    pub(crate) results: Vec<NewFile>,
}

/// A file that was made.
pub(crate) struct NewFile {
    /// The file that it comes from.
    from: FileId,
    pub(crate) name: PathBuf,
    pub(crate) bytes: Vec<u8>,
}

impl Changed {
    /// Does `change` to the model that is called `path`.
    pub(crate) fn new(change: &PreparedChange, path: &Path, files: &InMemory) -> Result<Self, Failure> {
        let opened = change.open(path, files)?;
        let mut plan = change.plan(&opened, files)?;
        plan.spell(&CommandLine);
        let model = &opened.model;
        let output = change.output.output.clone().unwrap_or_else(|| OutputOptions::beside(path));
        let geometry = change.set_files.geometry.as_deref().map(|path| change.output.of_geometry(path));
        let names = std::iter::once(output).chain(geometry);
        let made = |(from, name)| {
            let bytes = plan.patched(model, from).map_err(|fault| opened.failure(fault))?;
            Ok(NewFile { from, name, bytes })
        };
        let results = plan.files(model).zip(names).map(made).collect::<Result<_, Failure>>()?;
        Ok(Self { opened, plan, results })
    }

    /// Names of the files that were made.
    pub(crate) fn names(&self) -> Vec<String> {
        self.results.iter().map(|made| made.name.display().to_string()).collect()
    }

    /// The files of the model after the change, from those before it.
    pub(crate) fn as_files(&self, before: &ModelFiles) -> ModelFiles {
        let mut after = before.clone();
        for made in &self.results {
            match made.from {
                FileId::MAIN => {
                    after = after.with_bytes(made.bytes.clone()).with_name(made.name.display().to_string());
                }
                other => after.replace_companion(other, made.bytes.clone()),
            }
        }
        after
    }

    /// The table.
    fn table(&self) -> String {
        plan::text(&self.plan, self.opened.name(), &format!("written: {}", self.names().join(", ")))
    }

    /// What changes, line by line.
    fn diff(&self) -> String {
        let each = self.results.iter().map(|made| {
            let old = self.opened.model.file(made.from).bytes();
            let old_name = self.opened.name_of(made.from);
            let new_name = made.name.display().to_string();
            let new_name = if made.from == FileId::MAIN { &new_name } else { old_name };
            plan::unified_diff(old, &made.bytes, old_name, new_name)
        });
        each.collect()
    }
}

/// Does the change of `json` in memory, and that of `words` by the command: both give the same table, JSON, diff and files.
#[track_caller]
pub(crate) fn same_change(bench: &Bench, words: &str, json: &Value) -> Changed {
    let files = files_of(bench);
    let change = prepare(read(json), &files).unwrap();
    let [path] = change.models.as_slice() else { panic!("not one model: {json}") };
    let changed = Changed::new(&change, path, &files).unwrap();

    let shown = bench.run(&format!("{words} --dry-run --format json")).done();
    assert_eq!(
        line(&PlanRecord::new(&changed.plan, &changed.opened.model, path, None, None)),
        shown.out(),
        "{words}"
    );
    let shown = bench.run(&format!("{words} --dry-run --quiet --diff")).done();
    assert_eq!(changed.diff(), shown.out(), "{words}");

    let mut names = changed.names();
    names.sort();
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    let ran = bench.run(words).done().wrote(&names);
    assert_eq!(changed.table(), ran.out(), "{words}");
    for made in &changed.results {
        assert!(bench.read(&made.name.to_string_lossy()) == made.bytes, "{words}: {}", made.name.display());
    }
    changed
}

/// A model that cannot be changed fails in memory as the command has it.
#[track_caller]
pub(crate) fn same_failure(bench: &Bench, words: &str, json: &Value) {
    let files = files_of(bench);
    let change = prepare(read(json), &files).unwrap();
    let failed = change.models.iter().filter_map(|path| Changed::new(&change, path, &files).err());
    let records = failed.map(|failure| line(&FailureRecord::new(&failure, &CommandLine)));
    let ran = bench.run(&format!("{words} --format json")).failed().wrote_nothing();
    assert_eq!(records.collect::<String>(), ran.out(), "{words}");
}
