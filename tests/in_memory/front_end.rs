//! A front end for tests that changes models in memory, without a disk.

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

use crate::support::TestDir;

/// The request of a JSON object. The pattern names the verb that the request must have.
macro_rules! request {
    ($verb:ident, $($json:tt)+) => {
        match $crate::front_end::request_from_json(&serde_json::json!($($json)+)) {
            osim_requests::Request::$verb(request) => *request,
            other => panic!("{other:?}"),
        }
    };
}
pub(crate) use request;

#[track_caller]
pub(crate) fn request_from_json(json: &Value) -> Request {
    Request::from_json(json.to_string().as_bytes()).unwrap()
}

/// The date that all runs of the command use in these tests.
pub(crate) const TODAY: &str = "2025-11-26";

/// The files of a folder, read into memory, by their names in the folder.
pub(crate) fn files_in_memory(dir: &TestDir) -> InMemory {
    let mut files = InMemory::from_iter(dir.files());
    files.set_today(TODAY);
    files
}

/// A model that was changed in memory.
pub(crate) struct Changed {
    pub(crate) opened: OpenModel,
    /// The plan, spelled for the command line.
    pub(crate) plan: Plan,
    /// The new bytes of each changed file, the model first.
    pub(crate) results: Vec<NewFile>,
}

/// A file that a change makes, with its new bytes.
pub(crate) struct NewFile {
    /// The file of the old model that this file replaces.
    from: FileId,
    pub(crate) name: PathBuf,
    pub(crate) bytes: Vec<u8>,
}

impl Changed {
    /// Makes `change` in the model at `path`.
    pub(crate) fn new(change: &PreparedChange, path: &Path, files: &InMemory) -> Result<Self, Failure> {
        let opened = change.open(path, files)?;
        let mut plan = change.plan(&opened, files)?;
        plan.spell(&CommandLine);
        let model = &opened.model;
        let output = change.output.output.clone().unwrap_or_else(|| OutputOptions::result_beside(path));
        let geometry = change.set_files.geometry.as_deref().map(|path| change.output.of_geometry(path));
        let names = std::iter::once(output).chain(geometry);
        let file = |(from, name)| {
            let bytes = plan.patched(model, from).map_err(|fault| opened.failure(fault))?;
            Ok(NewFile { from, name, bytes })
        };
        let results = plan.files(model).zip(names).map(file).collect::<Result<_, Failure>>()?;
        Ok(Self { opened, plan, results })
    }

    /// Names of the files that the change wrote.
    pub(crate) fn names(&self) -> Vec<String> {
        self.results.iter().map(|file| file.name.display().to_string()).collect()
    }

    /// The files of the model after the change; `before` has the files before the change.
    pub(crate) fn as_files(&self, before: &ModelFiles) -> ModelFiles {
        let mut after = before.clone();
        for file in &self.results {
            match file.from {
                FileId::MAIN => {
                    after = after.with_bytes(file.bytes.clone()).with_name(file.name.display().to_string());
                }
                other => after.replace_companion(other, file.bytes.clone()),
            }
        }
        after
    }

    /// The table that the command prints.
    fn table(&self) -> String {
        plan::text(&self.plan, self.opened.name(), &format!("written: {}", self.names().join(", ")), None)
    }

    /// The diff that the command prints.
    fn diff(&self) -> String {
        let each = self.results.iter().map(|file| {
            let old = self.opened.model.file(file.from).bytes();
            let old_name = self.opened.name_of(file.from);
            let new_name = file.name.display().to_string();
            let new_name = if file.from == FileId::MAIN { &new_name } else { old_name };
            plan::unified_diff(old, &file.bytes, old_name, new_name)
        });
        each.collect()
    }
}

/// Makes the change `json` in memory, and the change with arguments `words` by the command. Table, JSON, diff and files must be equal.
#[track_caller]
pub(crate) fn assert_same_change(dir: &TestDir, words: &str, json: &Value) -> Changed {
    let files = files_in_memory(dir);
    let change = prepare(request_from_json(json), &files).unwrap();
    let [path] = change.models.as_slice() else { panic!("not one model: {json}") };
    let changed = Changed::new(&change, path, &files).unwrap();

    let run = dir.run(&format!("{words} --dry-run --format json")).succeeded();
    assert_eq!(
        line(&PlanRecord::new(&changed.plan, &changed.opened.model, path, None, None)),
        run.out(),
        "{words}"
    );
    let run = dir.run(&format!("{words} --dry-run --quiet --diff")).succeeded();
    assert_eq!(changed.diff(), run.out(), "{words}");

    let mut names = changed.names();
    names.sort();
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    let run = dir.run(words).succeeded().wrote(&names);
    assert_eq!(changed.table(), run.out(), "{words}");
    for file in &changed.results {
        assert!(dir.read(&file.name.to_string_lossy()) == file.bytes, "{words}: {}", file.name.display());
    }
    changed
}

/// Asserts that a model that cannot be changed gives the same failure in memory as by the command.
#[track_caller]
pub(crate) fn assert_same_failure(dir: &TestDir, words: &str, json: &Value) {
    let files = files_in_memory(dir);
    let change = prepare(request_from_json(json), &files).unwrap();
    let failed = change.models.iter().filter_map(|path| Changed::new(&change, path, &files).err());
    let records = failed.map(|failure| line(&FailureRecord::new(&failure, &CommandLine)));
    let run = dir.run(&format!("{words} --format json")).failed().wrote_nothing();
    assert_eq!(records.collect::<String>(), run.out(), "{words}");
}
