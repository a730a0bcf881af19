//! A call of the program: what all verbs share; what verbs without a change print and write in the end.

use std::path::Path;

use anyhow::Result;
use clap::ValueEnum;
use osim_inspect::describe_unmatched_patterns;
use osim_library::report_page::{ReportPage, Words};
use osim_library::{Disk, LibraryFault};
use osim_model::files::{CompanionPaths, Failure};
use osim_planning::open_with;
use osim_requests::options::{ForceOptions, MassOptions};
use osim_requests::spell::{CommandLine, JsonRequest, Matlab, shell_quoted};
use osim_requests::{RequestError, RequestFault};
use osim_view::report::extent::{Extent, Layout};
use osim_view::report::json::{FailureRecord, line};
use osim_view::report::layout::Colour;

use crate::exit::{self, Exit, ExitError, exit_of_cause};
use crate::terminal::Terminal;

/// One call of the program.
pub(crate) struct Session {
    /// Standard output and error of the call.
    pub terminal: Terminal,
    /// The language in which the call spells options and calls.
    pub words: Words,
}

impl Session {
    /// How results are laid out on this terminal.
    pub(crate) fn layout(&self, full: bool) -> Layout {
        Layout { columns: self.terminal.columns(), colour: Colour::Ansi, extent: Extent::new(full) }
    }

    /// Reports a failure; scripts that read JSON get it there, too.
    pub(crate) fn fail(&mut self, failure: &Failure, json: bool) -> Result<Exit> {
        if json {
            self.terminal.print_records(&line(&FailureRecord::new(failure, self.words)))?;
        }
        exit::report(failure, self.words, &mut self.terminal);
        Ok(Exit::Failed)
    }

    /// A request that cannot be begun: wrong usage, or a file that it needs.
    ///
    /// # Errors
    /// Wrong usage.
    pub(crate) fn refuse(&mut self, error: RequestError, json: bool) -> Result<Exit> {
        match error {
            RequestError::Fault(fault) => Err(self.usage(&fault)),
            RequestError::Failure(failure) => self.fail(&failure, json),
        }
    }

    /// The error of a request that was wrong.
    pub(crate) fn usage(&self, fault: &RequestFault) -> anyhow::Error {
        anyhow::anyhow!(fault.spelled(self.words))
    }

    /// The error for files that were refused.
    pub(crate) fn refused(&self, fault: &LibraryFault) -> anyhow::Error {
        ExitError { text: fault.spelled(self.words), exit: exit_of_cause(fault.cause()) }.into()
    }
}

// The words in which this program names its options: those of its command line, of a request in JSON, or of the functions
// that send one.

/// Spells options in messages as a user types them.
pub(crate) static WORDS: Words = &CommandLine;

/// The language of those who read messages about a request.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum Language {
    Json,
    Matlab,
}

/// The words of a request for those who wrote it: fields, or the arguments of the function that made them.
pub(crate) fn of_request(language: Language) -> Words {
    match language {
        Language::Json => &JsonRequest,
        Language::Matlab => &Matlab,
    }
}

// What verbs without a change print and write in the end.

/// Ends the page, if there is one; what cannot be written is reported.
pub(super) fn end_page(page: Option<ReportPage>, session: &mut Session) -> Exit {
    match page.map_or(Ok(()), ReportPage::finish) {
        Ok(()) => Exit::Done,
        Err(fault) => {
            let why = session.refused(&fault);
            session.terminal.error_line(&format!("the report: {why:#}"));
            Exit::Failed
        }
    }
}

// The call as it was typed, for reports.

/// The command line, each word quoted where a shell asks for it.
pub(super) fn asked() -> String {
    let words = std::env::args_os().skip(1).map(|word| shell_quoted(&word.to_string_lossy()));
    std::iter::once("osim-contact-scale".to_owned()).chain(words).collect::<Vec<_>>().join(" ")
}

// Choices of forces or bodies that fit nothing, for verbs whose results do not say it.

/// A remark on each of them for the models at `paths`. What cannot be read is named by the verb itself.
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
