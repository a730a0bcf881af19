//! One model: load, plan, write, and what to tell about it.

use std::path::{Path, PathBuf};

use anyhow::{Context, Result, anyhow, bail};
use osim_patch::{Model, Patch, Plan};

use super::Run;
use super::outcome::{Outcome, Said};
use super::record::{Record, Status};
use super::resume::Earlier;
use super::sights::Sights;
use super::task::{Order, Task};
use crate::args::RunFormat;
use crate::digest::{sha256, sha256_of_parts};
use crate::failure::Failure;
use crate::folders;
use crate::load::{Loaded, Stamp};
use crate::page::{Entry, Frame};
use crate::place::Place;
use crate::report::{changes, diff, json};
use crate::write::{Mode, Prepared, backup};

impl Task {
    /// Does this model. Whatever goes wrong is in the outcome.
    pub(super) fn run(&self, run: &Run<'_>, frame: Option<Frame>) -> Outcome {
        let mut record = Record::of_task(self);
        match self.attempt(run, frame, &mut record) {
            Ok(outcome) => outcome,
            // A folder may hold models without contacts; one that was named may not.
            Err(failure) if failure.code == "no-contacts" && self.source.folder.is_some() => {
                record.status = Status::NoContacts;
                Outcome { said: Vec::new(), record, earlier: false, entry: None }
            }
            Err(failure) => {
                let failure = self.located(failure);
                let mut outcome = Outcome::failed(&failure, record, run.format == RunFormat::Json);
                run.done.left_behind(&mut outcome.record);
                outcome
            }
        }
    }

    fn attempt(&self, run: &Run<'_>, frame: Option<Frame>, record: &mut Record) -> Result<Outcome, Failure> {
        let loaded = Loaded::read(&self.source, &self.order.parts)?;
        let mut force = self.order.force;
        if run.journal.is_some() {
            let input = sha256(&loaded.bytes);
            record.recipe = Some(self.recipe(&loaded));
            if !run.done.is_empty() {
                match run.done.of(self, &input, record) {
                    Earlier::Holds(mut record) => {
                        record.row = self.row;
                        let record = *record;
                        let entry = frame.and_then(|frame| self.seen_again(run, &loaded, &record, frame));
                        return Ok(Outcome { said: Vec::new(), record, earlier: true, entry });
                    }
                    Earlier::Outdated => force = true,
                    Earlier::Edited(path) if !force && !run.args.dry_run => {
                        return Err(edited(&loaded.shown, &path));
                    }
                    Earlier::Edited(_) | Earlier::Unknown => {}
                }
            }
            record.sha256_input = Some(input);
        } else if frame.is_some() {
            record.sha256_input = Some(sha256(&loaded.bytes));
        }
        loaded.with_model(|model| {
            let mut job = Job { task: self, run, loaded: &loaded, force, record };
            let plan = job.plan(model)?;
            let outside = |error: anyhow::Error| Failure::outside(&loaded.shown, "output", &error);
            let results = job.results(&plan, model)?;
            let sights = frame.map(|frame| Sights::of(self, &loaded, &plan, model, &results, frame));
            let sights = sights.transpose()?;
            let written = job.write(&plan, &results).map_err(outside)?;
            let said = job.tell(&plan, &results, &written).map_err(outside)?;
            let became = (written.told(), written.paths());
            let entry = sights.map(|sights| sights.entry(&plan, &loaded, job.record, became));
            Ok(Outcome { said, record: record.clone(), earlier: false, entry })
        })
    }

    /// A model that an earlier run has done, on the page. None where it was changed itself: what it was before is gone.
    fn seen_again(&self, run: &Run<'_>, loaded: &Loaded, record: &Record, frame: Frame) -> Option<Entry> {
        if self.order.in_place {
            return None;
        }
        let seen = loaded.with_model(|model| {
            let mut job = Job { task: self, run, loaded, force: false, record: &mut record.clone() };
            let plan = job.plan(model)?;
            let results = job.results(&plan, model)?;
            let sights = Sights::of(self, loaded, &plan, model, &results, frame)?;
            let wrote = record.status == Status::Written;
            let outputs = [self.output(), self.geometry_output.as_deref()].into_iter().flatten();
            let outputs: Vec<PathBuf> = outputs.filter(|_| wrote).map(Path::to_owned).collect();
            let result = format!("done by an earlier run: {}", record.status.told());
            Ok(sights.entry(&plan, loaded, record, (result, &outputs)).of_earlier_run())
        });
        seen.ok()
    }

    /// Digest of everything the output follows from but for the model: with the files that the model includes.
    fn recipe(&self, loaded: &Loaded) -> String {
        let own = self.order.recipe();
        if loaded.parts.is_empty() {
            return own.to_owned();
        }
        let parts = (1..=loaded.parts.len()).map(|file| sha256(loaded.file(file).1));
        sha256(std::iter::once(own.to_owned()).chain(parts).collect::<Vec<_>>().join("\n").as_bytes())
    }

    /// In a manifest, the row is what the user can mend.
    fn located(&self, failure: Failure) -> Failure {
        match self.row {
            Some(row) => Failure { message: format!("{} (row {row})", failure.message), ..failure },
            None => failure,
        }
    }
}

/// Nobody's work is replaced in passing.
fn edited(shown: &str, output: &Path) -> Failure {
    let error = anyhow!(
        "{} is not what an earlier run wrote, so it stays: move it away, or replace it with --force",
        output.display()
    );
    Failure::outside(shown, "output", &error)
}

/// A model that is loaded.
struct Job<'j> {
    task: &'j Task,
    run: &'j Run<'j>,
    loaded: &'j Loaded,
    force: bool,
    record: &'j mut Record,
}

/// The bytes that a plan makes.
pub(super) struct Results<'m> {
    pub model: Patch<'m>,
    pub geometry: Option<Geometry<'m>>,
}

/// The changed bytes of a standalone geometry set.
pub(super) struct Geometry<'m> {
    pub file: usize,
    path: PathBuf,
    pub patch: Patch<'m>,
}

/// What was written.
enum Written {
    /// Nothing, and why.
    Nothing(&'static str),
    /// The model goes to standard output.
    Stdout,
    /// The model, then its geometry set; and the backups of both.
    Files { paths: Vec<PathBuf>, kept: Vec<PathBuf> },
}

impl Written {
    /// In words.
    fn told(&self) -> String {
        match self {
            Self::Nothing(why) => (*why).to_owned(),
            Self::Stdout => "model written to standard output".to_owned(),
            Self::Files { paths, kept } => {
                let listed = |paths: &[PathBuf]| {
                    paths.iter().map(|path| path.display().to_string()).collect::<Vec<_>>().join(", ")
                };
                let kept = if kept.is_empty() { String::new() } else { format!(" (old: {})", listed(kept)) };
                format!("written: {}{kept}", listed(paths))
            }
        }
    }

    fn paths(&self) -> &[PathBuf] {
        match self {
            Self::Files { paths, .. } => paths,
            Self::Nothing(_) | Self::Stdout => &[],
        }
    }
}

impl Job<'_> {
    fn order(&self) -> &Order {
        &self.task.order
    }

    fn plan(&mut self, model: &Model) -> Result<Plan, Failure> {
        let planned = self.order().planner().plan(model);
        let mut plan = planned.map_err(|fault| self.loaded.failure(fault))?;
        if self.order().no_note {
            plan.without_note();
            if model.note.is_some() && !plan.is_empty() {
                let text = "the note is removed: the next run cannot know what the contacts stand for";
                plan.remarks.push(text.to_owned());
            }
        }
        plan.warnings.splice(0..0, model.warnings.iter().cloned());
        let compiled = self.task.output().and_then(|path| self.run.folders.compiled_beside(path));
        plan.warnings.extend(compiled);
        self.record.planned(&plan);
        Ok(plan)
    }

    fn results<'m>(&self, plan: &Plan, model: &'m Model) -> Result<Results<'m>, Failure> {
        let patched = |file| plan.patch(model, file).map_err(|fault| self.loaded.failure(fault));
        let mut geometry = None;
        // The standalone geometry set that changes with the force set.
        let mut parts = 1..=self.loaded.parts.len();
        let changed = parts.find(|&file| !plan.edits(model, file).is_empty());
        if let (Some(path), Some(file)) = (&self.task.geometry_output, changed) {
            geometry = Some(Geometry { file, path: path.clone(), patch: patched(file)? });
        }
        Ok(Results { model: patched(0)?, geometry })
    }

    /// Writes what is to be written; where it went.
    fn write(&mut self, plan: &Plan, results: &Results<'_>) -> Result<Written> {
        if self.run.args.dry_run {
            self.record.status = Status::DryRun;
            return Ok(Written::Nothing("dry run: nothing written"));
        }
        let to_stdout = self.task.place == Place::Stdout;
        if plan.is_empty() && !self.task.asked && !to_stdout {
            self.record.status = Status::Unchanged;
            return Ok(Written::Nothing("nothing written"));
        }
        self.record.status = Status::Written;
        let mut files = Files::default();
        if let Some(path) = self.task.output() {
            self.loaded.find_included_from(path)?;
            self.prepare(&mut files, path, &results.model, 0)?;
        }
        if let Some(geometry) = &results.geometry {
            self.prepare(&mut files, &geometry.path, &geometry.patch, geometry.file)?;
        }
        if self.run.journal.is_some() || self.run.args.report.is_some() {
            self.record.sha256_output = Some(sha256_of_parts(results.model.parts()));
            let geometry = results.geometry.as_ref();
            self.record.sha256_geometry_output =
                geometry.map(|geometry| sha256_of_parts(geometry.patch.parts()));
        }
        if let Some(journal) = self.run.journal.as_ref().filter(|_| !to_stdout) {
            journal.about_to_finish(self.record)?;
        }
        let Files { backups, successors, paths, kept } = files;
        // Two files that belong together, and a file whose old contents are about to go: all on the disk first.
        let together = successors.len() > 1 || successors.iter().any(Prepared::replaces);
        let all: Vec<Prepared> = backups.into_iter().chain(successors).collect();
        if together {
            all.iter().try_for_each(Prepared::sync)?;
        }
        if self.order().in_place {
            let geometry = results.geometry.as_ref().map(|geometry| (geometry.file, geometry.path.as_path()));
            let model = (0, self.task.source.path.as_path());
            for (file, path) in std::iter::once(model).chain(geometry) {
                self.loaded.stamp_of(file).map_or(Ok(()), |stamp| stamp.still_holds(path))?;
            }
        }
        for prepared in all {
            prepared.commit()?;
        }
        Ok(if to_stdout { Written::Stdout } else { Written::Files { paths, kept } })
    }

    /// A complete successor of `path`, made from file number `file` of the model.
    fn prepare(&self, files: &mut Files, path: &Path, patch: &Patch<'_>, file: usize) -> Result<()> {
        if self.order().in_place {
            self.refuse_protected(path)?;
            if !self.order().no_backup {
                let (prepared, kept) = backup(path, self.loaded.file(file).1)
                    .context("the backup could not be kept, so nothing was changed")?;
                files.backups.extend(prepared);
                // As the model was named; behind a link, the backup lies where the model really is.
                let beside = kept.file_name().filter(|_| !path.is_symlink());
                files.kept.push(beside.map(|name| path.with_file_name(name)).unwrap_or(kept));
            }
        }
        folders::make(path)?;
        let mode = if self.force || self.order().in_place { Mode::Replace } else { Mode::New };
        let stamp = self.loaded.stamp_of(file);
        let like = stamp.map(|stamp: &Stamp| &stamp.metadata);
        files.successors.push(Prepared::of_parts(path, patch.parts(), like, mode)?);
        files.paths.push(path.to_owned());
        Ok(())
    }

    /// A model that somebody protected is not changed in passing.
    fn refuse_protected(&self, path: &Path) -> Result<()> {
        let protected = std::fs::metadata(path).is_ok_and(|metadata| metadata.permissions().readonly());
        if protected && !self.order().force {
            bail!("{} is write-protected: change it all the same with --force", path.display());
        }
        Ok(())
    }

    fn tell(&self, plan: &Plan, results: &Results<'_>, written: &Written) -> Result<Vec<Said>> {
        let mut said = Vec::new();
        let to_stdout = matches!(written, Written::Stdout);
        let args = self.run.args;
        if let Some(text) = self.report(plan, written) {
            said.push(if to_stdout { Said::Note(text) } else { Said::Result(text.into_bytes()) });
        }
        if args.diff {
            let text = self.diff(results);
            // With JSON on standard output, the diff would not be JSON.
            let aside = self.run.format == RunFormat::Json;
            said.push(if aside { Said::Note(text) } else { Said::Result(text.into_bytes()) });
        }
        if to_stdout {
            said.push(Said::Result(results.model.to_vec()));
        }
        Ok(said)
    }

    /// What changed, as the run is told; nothing with `--quiet`.
    fn report(&self, plan: &Plan, written: &Written) -> Option<String> {
        let paths: Vec<String> = written.paths().iter().map(|path| path.display().to_string()).collect();
        let shown = &self.loaded.shown;
        let format = self.run.format;
        if format == RunFormat::Json {
            let output = paths.first().map(String::as_str);
            return Some(json::plan(plan, shown, output, paths.get(1).map(String::as_str)));
        }
        if self.run.args.quiet {
            return None;
        }
        let result = written.told();
        Some(match format {
            RunFormat::Lines => changes::line(plan, shown, &result),
            _ => changes::text(plan, shown, &result),
        })
    }

    fn diff(&self, results: &Results<'_>) -> String {
        let loaded = self.loaded;
        let target =
            self.task.output().map_or_else(|| loaded.shown.clone(), |path| path.display().to_string());
        let mut text = diff::unified(&loaded.bytes, &results.model.to_vec(), &loaded.shown, &target);
        if let Some(geometry) = &results.geometry {
            let (name, bytes) = loaded.file(geometry.file);
            text.push_str(&diff::unified(bytes, &geometry.patch.to_vec(), name, name));
        }
        text
    }
}

/// Files that are complete under temporary names.
#[derive(Default)]
struct Files {
    backups: Vec<Prepared>,
    successors: Vec<Prepared>,
    paths: Vec<PathBuf>,
    kept: Vec<PathBuf>,
}
