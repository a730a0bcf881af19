//! What is shown of a model that was changed, made on the thread that changed it.

use osim_library::page::entry;
use osim_library::run::{ChangedModel, Detail, FrontEnd, Written};
use osim_model::FileId;
use osim_requests::options::{RunFormat, RunOptions};
use osim_requests::spell::Speller;
use osim_view::html::{DetailLevel, Entry};
use osim_view::report::json::{PlanRecord, line};
use osim_view::report::plan;

use crate::interrupt;
use crate::progress::Progress;
use crate::words::Words;

/// What is shown of one model.
#[derive(Default)]
pub(super) struct Shown {
    pub outputs: Vec<Output>,
    /// The model on the page; `None` without a page.
    pub entry: Option<Entry>,
}

/// One thing to report.
pub(super) enum Output {
    /// On standard output.
    Result(String),
    /// On standard output, for programs.
    Record(String),
    /// On standard output, where programs take it as it is.
    Diff(String),
    /// On standard output, byte for byte.
    Model(Vec<u8>),
    /// On standard error, beside the results.
    Note(String),
    /// On standard error, where programs take it as it is.
    Aside(String),
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

    fn dialect(&self) -> &dyn Speller {
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
        let entry = both.map(|both| entry(&changed, &both, self.detail, self.words));
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
            outputs.push(match (to_stdout, self.format) {
                (true, RunFormat::Json) => Output::Aside(text),
                (true, _) => Output::Note(text),
                (false, RunFormat::Json) => Output::Record(text),
                (false, _) => Output::Result(text),
            });
        }
        if self.options.diff {
            let text = diff(changed);
            // With JSON on standard output, the diff would not be JSON.
            let aside = self.format == RunFormat::Json;
            outputs.push(if aside { Output::Aside(text) } else { Output::Diff(text) });
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
            return Some(line(&PlanRecord::new(plan, &opened.model, &task.source.path, output, geometry)));
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
