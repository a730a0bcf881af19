//! One call of the program: data that all verbs share, and functions for the end of verbs that change no model.

use std::path::Path;
use std::time::SystemTime;

use anyhow::Result;
use clap::ValueEnum;
use osim_inspect::describe_unmatched_patterns;
use osim_library::report_page::{ReportPage, Words};
use osim_library::{Disk, LibraryFault};
use osim_model::files::{CompanionPaths, Failure};
use osim_model::messages::Input;
use osim_planning::open_with;
use osim_requests::options::{ForceOptions, MassOptions};
use osim_requests::spell::{CommandLine, JsonRequest, Matlab, shell_quoted};
use osim_requests::{RequestError, RequestFault};
use osim_view::report::extent::{Extent, Layout};
use osim_view::report::json::{FailureRecord, line};
use osim_view::report::layout::Colour;

use crate::exit::{self, Exit, ExitError, exit_of_cause};
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

    /// Reports a failure on standard error; with `json`, also as a record on standard output.
    pub(crate) fn report_failure(&mut self, failure: &Failure, json: bool) -> Result<Exit> {
        if json {
            self.terminal.print_records(&line(&FailureRecord::new(failure, self.words)))?;
        }
        exit::report_failure(failure, self.words, &mut self.terminal);
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
        ExitError { text: fault.spelled(self.words), exit: exit_of_cause(fault.cause) }.into()
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

/// Spells options as the caller wrote them: as fields of the request, or as arguments of the function that made the request.
pub(crate) fn words_of_language(language: Language) -> Words {
    match language {
        Language::Json => &JsonRequest,
        Language::Matlab => &Matlab,
    }
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
