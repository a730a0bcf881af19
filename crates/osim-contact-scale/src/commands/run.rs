//! One run of a changing verb: what is reported of it, and in which order.

use anyhow::Result;
use osim_library::page::{ReportPage, bare_entry};
use osim_library::run::{Counts, Outcome, Run, RunRequest, Task};
use osim_model::files::Failure;
use osim_model::messages::Input;
use osim_requests::options::{RunFormat, RunOptions};
use osim_view::html::DetailLevel;
use osim_view::report::json::{FailureRecord, line};

use super::asked::asked;
use super::page::end_page;
use super::shown::{Output, Shower, Shown};
use crate::exit::Exit;
use crate::progress::Progress;
use crate::session::Session;
use crate::words::Words;
use crate::{failure, interrupt};

/// More models than this are reported in a line each, unless a table is asked for.
const FEW: usize = 10;

/// Does all of `request`.
///
/// # Errors
/// Wrong usage: found before anything is written.
pub(super) fn run(request: RunRequest, options: &RunOptions, session: &mut Session) -> Result<Exit> {
    let mut run = Run::new(request, options).map_err(|fault| session.refused(&fault))?;
    let tasks = run.request().tasks.len();
    let several = tasks + run.request().failures.len() > 1;
    let few = if tasks > FEW { RunFormat::Lines } else { RunFormat::Table };
    let format = options.format.unwrap_or(few);
    let mut exit = Exit::Done;
    for failure in &run.request().failures {
        exit = exit.and(tell_failure(failure, format, session));
    }
    for remark in run.request().remarks.iter().filter(|_| !options.quiet) {
        session.terminal.note_line(remark)?;
    }
    run.read_previous().map_err(|fault| session.refused(&fault))?;
    let mut page =
        ReportPage::of_run(&run, options, asked(), session.words).map_err(|fault| session.refused(&fault))?;
    run.begin().map_err(|fault| session.refused(&fault))?;
    for kept in run.kept() {
        session.terminal.note_line(kept)?;
    }
    let counts = work_off(&run, options, format, &mut page, session)?;
    if let Err(fault) = run.finish() {
        session.terminal.error_line(&fault.spelled(session.words));
        exit = exit.and(Exit::Failed);
    }
    exit = exit.and(end_page(page, session));
    let (counts, untold) = counts;
    if !options.quiet && several {
        session.terminal.note(&summary(&counts, options, session.words))?;
    } else if !options.quiet && counts.interrupted() {
        session.terminal.note("stopped\n")?;
    }
    Ok(exit.and(exit_of(&counts, untold)))
}

/// Does all tasks and reports each in its turn; also whether something could not be shown.
fn work_off(
    run: &Run<'_>,
    options: &RunOptions,
    format: RunFormat,
    page: &mut Option<ReportPage>,
    session: &mut Session,
) -> Result<(Counts, bool)> {
    let tasks = run.request().tasks.len();
    if tasks > 1 {
        interrupt::listen();
    }
    let shower = Shower {
        words: session.words,
        options,
        format,
        detail: DetailLevel::of(tasks + run.request().failures.len()),
        progress: Progress::begin(tasks, options.quiet),
    };
    let mut untold = false;
    let report = |_: &Task, outcome: Outcome<Shown>| {
        let Outcome { record, earlier, shown, failure, .. } = outcome;
        let Shown { outputs, entry } = shown.unwrap_or_default();
        if let Some(page) = page {
            page.add(entry.unwrap_or_else(|| bare_entry(&record, earlier)));
        }
        // Results that cannot be shown are no reason to leave the other models undone.
        let reported = shower.progress.suspended(|| match &failure {
            Some(failure) => say_failure(failure, format, session),
            None => say(&outputs, session),
        });
        if let Err(error) = reported {
            session.terminal.error_line(&format!("cannot write to standard output: {error:#}"));
            untold = true;
        }
    };
    let counts = run.work_off(&shower, report);
    shower.progress.end();
    match counts {
        Ok(counts) => Ok((counts, untold)),
        Err(fault) => Err(session.refused(&fault)),
    }
}

fn tell_failure(failure: &Failure, format: RunFormat, session: &mut Session) -> Exit {
    // Scripts read one object per model, also of those that failed.
    let record = || line(&FailureRecord::new(failure, session.words));
    if format == RunFormat::Json {
        let record = record();
        if session.terminal.print_records(&record).is_err() {
            return Exit::Failed;
        }
    }
    failure::report(failure, session.words, &mut session.terminal);
    Exit::Failed
}

fn say_failure(failure: &Failure, format: RunFormat, session: &mut Session) -> Result<()> {
    if format == RunFormat::Json {
        session.terminal.print_records(&line(&FailureRecord::new(failure, session.words)))?;
    }
    failure::report(failure, session.words, &mut session.terminal);
    Ok(())
}

fn say(all: &[Output], session: &mut Session) -> Result<()> {
    for output in all {
        match output {
            Output::Result(text) => session.terminal.print(text)?,
            Output::Record(text) => session.terminal.print_records(text)?,
            Output::Diff(text) => session.terminal.print_diff(text)?,
            Output::Model(bytes) => session.terminal.write_bytes(bytes)?,
            Output::Note(text) => session.terminal.note(text)?,
            Output::Aside(text) => session.terminal.aside(text)?,
        }
    }
    Ok(())
}

fn exit_of(counts: &Counts, untold: bool) -> Exit {
    match (counts.interrupted(), counts.failed) {
        (true, _) => Exit::Interrupted,
        (false, 0) if !untold => Exit::Done,
        (false, _) => Exit::Failed,
    }
}

/// The last line of a run over several models.
fn summary(counts: &Counts, options: &RunOptions, words: Words) -> String {
    let parts = [
        (counts.written, "written"),
        (counts.dry, "planned (dry run)"),
        (counts.unchanged, "unchanged"),
        (counts.earlier, "done before"),
        (counts.no_contacts, "skipped (no contacts)"),
        (counts.failed, "failed"),
        (counts.not_begun, "not begun"),
    ];
    let all: usize = parts.iter().map(|(count, _)| count).sum();
    let parts: Vec<String> =
        parts.iter().filter(|(count, _)| *count > 0).map(|(count, what)| format!("{count} {what}")).collect();
    let stopped = match (counts.interrupted(), &options.summary) {
        (false, _) => String::new(),
        (true, Some(_)) => {
            format!("; stopped: go on with the same call and {}", words.input(Input::Resume, None))
        }
        (true, None) => "; stopped".to_owned(),
    };
    let parts = if parts.is_empty() { "none done".to_owned() } else { parts.join(", ") };
    let models = if all == 1 { "model" } else { "models" };
    format!("note: {all} {models}: {parts}{stopped}\n")
}
