//! What is shown of a model that was changed, made on the thread that changed it.

use osim_library::Disk;
use osim_library::run::{ChangedModel, Detail, FrontEnd, Record, Written};
use osim_model::FileId;
use osim_model::RemedyDialect;
use osim_report::html::{self, Changed, DetailLevel, EarlierRun, Entry, Files, RowError, RunRow};
use osim_report::json::{PlanRecord, line};
use osim_report::plan;
use osim_requests::BeforeAfter;
use osim_requests::options::{RunFormat, RunOptions};

use crate::interrupt;
use crate::progress::Progress;
use crate::words::Words;

/// What is shown of one model.
#[derive(Default)]
pub(super) struct Shown {
    pub outputs: Vec<Output>,
    /// The model on the page; none where no page is asked for.
    pub entry: Option<Entry>,
}

/// One thing to report.
pub(super) enum Output {
    /// On standard output.
    Result(String),
    /// On standard output, where programs take it as it is.
    Diff(String),
    /// On standard output, byte for byte.
    Model(Vec<u8>),
    /// On standard error, beside the results.
    Note(String),
}

/// Shows what a run does.
pub(super) struct Shower<'s> {
    pub words: Words,
    pub options: &'s RunOptions,
    pub format: RunFormat,
    /// How much of each model a page shows.
    pub detail: DetailLevel,
    pub progress: Progress,
}

impl FrontEnd for Shower<'_> {
    type Shown = Shown;

    fn dialect(&self) -> &dyn RemedyDialect {
        // A front end's words are words for remedies, too.
        self.words
    }

    fn detail(&self) -> Detail {
        match self.options.report {
            Some(_) => Detail::BeforeAfter { feet: self.detail.has_feet() },
            None => Detail::Result,
        }
    }

    fn show(&self, mut changed: ChangedModel<'_>) -> Shown {
        let both = changed.before_after.take();
        let entry = both.map(|both| self.entry(&changed, both));
        let outputs = if changed.earlier { Vec::new() } else { self.outputs(&changed) };
        Shown { outputs, entry }
    }

    fn is_interrupted(&self) -> bool {
        interrupt::came()
    }

    fn done(&self, failed: bool) {
        self.progress.done(failed);
    }
}

impl Shower<'_> {
    fn outputs(&self, changed: &ChangedModel<'_>) -> Vec<Output> {
        let mut outputs = Vec::new();
        let to_stdout = matches!(changed.written, Written::Stdout);
        if let Some(text) = self.text(changed) {
            outputs.push(if to_stdout { Output::Note(text) } else { Output::Result(text) });
        }
        if self.options.diff {
            let text = diff(changed);
            // With JSON on standard output, the diff would not be JSON.
            let aside = self.format == RunFormat::Json;
            outputs.push(if aside { Output::Note(text) } else { Output::Diff(text) });
        }
        if to_stdout {
            outputs.push(Output::Model(changed.results.model.to_vec()));
        }
        outputs
    }

    /// What changed, as the run reports it; nothing where only errors are.
    fn text(&self, changed: &ChangedModel<'_>) -> Option<String> {
        let ChangedModel { plan, task, opened, written, .. } = changed;
        if self.format == RunFormat::Json {
            let mut paths = written.paths().iter().map(std::path::PathBuf::as_path);
            let (output, geometry) = (paths.next(), paths.next());
            return Some(line(&PlanRecord::new(plan, &task.source.path, output, geometry)));
        }
        if self.options.quiet {
            return None;
        }
        let (shown, result) = (opened.name(), written.describe());
        Some(match self.format {
            RunFormat::Lines => plan::line(plan, shown, &result),
            _ => plan::text(plan, shown, &result),
        })
    }

    fn entry(&self, changed: &ChangedModel<'_>, both: BeforeAfter) -> Entry {
        let record = changed.record;
        let names = changed.opened.files().map(|(name, _)| name.to_owned());
        let inputs = names.zip(changed.inputs.iter().cloned());
        let digests = [&record.sha256_output, &record.sha256_geometry_output];
        let paths = changed.written.paths().iter().map(|path| path.display().to_string());
        let outputs: Vec<(String, String)> = paths.zip(digests.into_iter().flatten().cloned()).collect();
        let result = match changed.earlier {
            true => record.status.describe().to_owned(),
            false => changed.written.describe(),
        };
        let files = Files { inputs: inputs.collect(), result, outputs };
        let mut change = Changed::new(changed.plan, (&both.before.0, &both.before.1), files);
        change.before_under_new_weight = both.before_under_new_weight.as_ref();
        change.after = both.after.as_ref().map(|(after, found)| (after, found));
        change.bodies = both.bodies;
        change.feet = both.feet;
        if let Some(feet) = change.feet.last_mut() {
            feet.add_bones((&changed.opened.model, &changed.task.source.path), None, &Disk);
        }
        change.reference = both.reference.as_ref();
        change.in_file = !changed.written.paths().is_empty();
        change.target_gravity_m_s2 = both.target_gravity_m_s2;
        let entry = html::changed(&row(record), change, self.detail, self.words);
        if changed.earlier { entry.of_earlier_run() } else { entry }
    }
}

fn diff(changed: &ChangedModel<'_>) -> String {
    let ChangedModel { task, opened, results, .. } = changed;
    let shown = opened.name();
    let target = task.output().map_or_else(|| shown.to_string(), |path| path.display().to_string());
    let bytes = |file: FileId| opened.model.file(file).bytes();
    let mut text = plan::unified_diff(bytes(FileId::MAIN), &results.model.to_vec(), shown, &target);
    if let Some(geometry) = &results.geometry {
        let name = opened.name_of(geometry.file);
        text.push_str(&plan::unified_diff(bytes(geometry.file), &geometry.patch.to_vec(), name, name));
    }
    text
}

/// A model of which there is nothing but its line in the summary.
pub(super) fn bare_entry(record: &Record, earlier: bool) -> Entry {
    if !earlier {
        let error = record.error_code.as_ref().zip(record.error.as_ref());
        let error = error.map(|(code, message)| {
            RowError::new(code.as_str(), message.as_str()).at(record.line, record.column)
        });
        return Entry::of_row(&row(record), error.as_ref());
    }
    let mut left = EarlierRun::default();
    left.radius_factor = record.radius_factor;
    left.stiffness_factor = record.stiffness_factor;
    left.dissipation_factor = record.dissipation_factor;
    left.unequal_factors = record.unequal_factors.split(' ').map(str::to_owned).collect();
    left.warnings = record.warnings.split_ascii_whitespace().count();
    Entry::left_by_earlier_run(&row(record), &left)
}

fn row(record: &Record) -> RunRow {
    let mut row = RunRow::new(record.model.as_str(), record.status.describe());
    row.row = record.row;
    row.output.clone_from(&record.output);
    row.contacts_mass_from_kg = record.contacts_mass_from_kg;
    row.contacts_mass_to_kg = record.contacts_mass_to_kg;
    row.changes = record.changes;
    row
}
