//! One call of the program: data that all verbs share, and functions for the end of verbs that change no model.

use std::path::Path;
use std::time::SystemTime;

use annotate_snippets::{AnnotationKind, Group, Level, Renderer, Snippet};
use anyhow::Result;
use clap::ValueEnum;
use osim_inspect::describe_unmatched_patterns;
use osim_library::report_page::{ReportPage, Words};
use osim_library::{Disk, FaultCause, LibraryFault};
use osim_model::files::{CompanionPaths, Failure};
use osim_model::messages::Input;
use osim_planning::open_with;
use osim_requests::options::{ForceOptions, MassOptions};
use osim_requests::spell::{CommandLine, shell_quoted};
use osim_requests::{RequestError, RequestFault};
use osim_view::report::extent::{Extent, Layout};
use osim_view::report::json::{FailureRecord, line};
use osim_view::report::layout::Colour;

use crate::exit::{Exit, ExitError};
use crate::terminal::Terminal;

/// One call of the command: its terminal, and the spelling of options in messages.
pub(crate) struct Session {
    /// Standard output and error of the call.
    pub terminal: Terminal,
    /// The language in which the call spells options and calls.
    pub words: Words,
    pub start: SystemTime,
}

impl Session {
    /// The layout of results for this terminal.
    pub(crate) fn layout(&self, full: bool) -> Layout {
        Layout { columns: self.terminal.columns(), colour: Colour::Ansi, extent: Extent::new(full) }
    }

    /// Reports a failure on standard error: one sentence, then the faulty line of the file, if there is one, with carets below the
    /// fault; with `json`, also as a record on standard output.
    pub(crate) fn report_failure(&mut self, failure: &Failure, json: bool) -> Result<Exit> {
        if json {
            self.terminal.print_records(&line(&FailureRecord::new(failure, self.words)))?;
        }
        let place = match (failure.line, failure.column) {
            (Some(line), Some(column)) => format!("{}:{line}:{column}", failure.model),
            _ => failure.model.to_string(),
        };
        let message = failure.message.spelled(self.words);
        // Some messages name their file. If that is the model, it is named already.
        let after_name = |mark: &str| message.strip_prefix(&format!("{}{mark} ", failure.model));
        let message = after_name("").or_else(|| after_name(":")).unwrap_or(&message);
        self.terminal.error(&format!("error: {place}: {message}\n"));
        if let Some(excerpt) = &failure.excerpt {
            let columns = self.terminal.columns_of_errors();
            let excerpt = columns.map_or_else(|| excerpt.clone(), |columns| excerpt.fitted(columns));
            let source = Snippet::source(excerpt.text.as_str()).line_start(excerpt.line);
            let marked = source.annotation(AnnotationKind::Primary.span(excerpt.marked.clone()));
            let snippet = Renderer::plain().render(&[Group::with_level(Level::ERROR).element(marked)]);
            let _ = self.terminal.print_to_stderr_unbroken(&format!("{snippet}\n"));
        }
        Ok(Exit::Failed)
    }

    /// The error of a request that cannot be done, because of wrong usage or of a file that it needs. What is wrong with a file is
    /// reported at once, and the error has no text any more.
    pub(crate) fn refuse(&mut self, error: impl Into<RequestError>, json: bool) -> anyhow::Error {
        match error.into() {
            RequestError::Fault(fault) => self.usage_error(&fault),
            RequestError::Failure(failure) => match self.report_failure(&failure, json) {
                Ok(exit) => ExitError { text: String::new(), exit }.into(),
                Err(error) => error,
            },
        }
    }

    /// Makes the error for a wrong request.
    pub(crate) fn usage_error(&self, fault: &RequestFault) -> anyhow::Error {
        anyhow::anyhow!(fault.spelled(self.words))
    }

    /// The error of the command for a file that could not be read or written.
    pub(crate) fn file_error(&self, fault: &LibraryFault) -> anyhow::Error {
        let exit = match fault.cause {
            FaultCause::Call => Exit::Usage,
            FaultCause::System => Exit::Failed,
            FaultCause::Busy => Exit::Busy,
        };
        ExitError { text: fault.spelled(self.words), exit }.into()
    }

    /// The error for a file of the option `input` whose name has none of the `endings`.
    pub(crate) fn wrong_ending(&self, input: Input, path: &Path, endings: &str) -> anyhow::Error {
        let option = self.words.input(input, None);
        anyhow::anyhow!("{option} '{}': expected a name that ends in {endings}", path.display())
    }
}

// The words in which this program names its options: those of its command line, of a request in JSON, or of the functions
// that send one.

/// Spells options in messages as a user types them.
pub(crate) static COMMAND_LINE_WORDS: Words = &CommandLine;

/// The language of the caller whose request the messages are about.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum Language {
    Json,
    Matlab,
}

// What verbs without a change print and write in the end.

/// Completes the report page, if there is one; reports a page that cannot be written.
pub(super) fn end_page(page: Option<ReportPage>, session: &mut Session) -> Exit {
    match page.map_or(Ok(()), ReportPage::finish) {
        Ok(()) => Exit::Done,
        Err(fault) => {
            let why = session.file_error(&fault);
            session.terminal.error_line(&format!("the report: {why:#}"));
            Exit::Failed
        }
    }
}

// The call as it was typed, for reports.

/// The command line of this call, each argument quoted where a shell needs it.
pub(super) fn typed_command_line() -> String {
    let words = std::env::args_os().skip(1).map(|word| shell_quoted(&word.to_string_lossy()));
    std::iter::once("osim-contact-scale".to_owned()).chain(words).collect::<Vec<_>>().join(" ")
}

// Choices of forces or bodies that fit nothing, for verbs whose results do not say it.

/// Prints a remark for each choice of forces or bodies that fits nothing in the models at `paths`. Unreadable models are skipped,
/// because the verb itself reports them.
///
/// # Errors
/// Standard error is closed.
pub(super) fn remark_unmatched<'p>(
    paths: impl IntoIterator<Item = &'p Path>,
    beside: CompanionPaths<'_>,
    choice: &ForceOptions,
    masses: &MassOptions,
    session: &mut Session,
) -> Result<()> {
    let (selection, masses) = (choice.selection(), masses.request());
    if selection.select.is_empty() && selection.exclude.is_empty() && masses.exclude_bodies.is_empty() {
        return Ok(());
    }
    // Standard input was read already.
    for path in paths.into_iter().filter(|path| path.as_os_str() != "-") {
        let Ok(open) = open_with(path, beside, &Disk) else { continue };
        for message in describe_unmatched_patterns(&selection, &masses, &open.model) {
            session.terminal.remark(&message.spelled(session.words))?;
        }
    }
    Ok(())
}
