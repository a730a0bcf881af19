//! One run of a changing verb over any number of models: compare all files, then load, plan, write and tell each.
//!
//! A [`Task`] is one model with its [`Order`]; tasks are independent of each other, so threads share them. What a
//! task did is an [`Outcome`], told in the order in which the models were named.

pub(crate) mod interrupt;
mod journal;
mod outcome;
mod progress;
mod record;
mod resume;
mod shard;
mod sights;
mod task;
mod writing;

use std::path::PathBuf;
use std::sync::Arc;

use anyhow::Result;

use crate::args::{RunArgs, RunFormat};
use crate::failure::Failure;
use crate::folders::Folders;
use crate::page::{self, About, Columns, Entry, Page, Replace};
use crate::place::{Ledger, Who};
use crate::terminal::{Exit, Terminal};
use crate::workers::{in_order, threads};

use journal::Journal;
use outcome::{Outcome, Said};
use resume::Done;

pub(crate) use progress::Progress;
pub(crate) use record::Record;
pub(crate) use shard::Shard;
pub(crate) use task::{Order, Planner, Task, Verb, tasks_of};

/// More models than this are told in a line each, unless a table is asked for.
const FEW: usize = 10;

/// What is to be done in one run.
#[derive(Default)]
pub(crate) struct Work {
    /// The verb, as on the command line.
    pub verb: &'static str,
    pub tasks: Vec<Task>,
    /// What could not even be listed.
    pub failures: Vec<Failure>,
    /// Things to say aloud before anything else.
    pub remarks: Vec<String>,
    /// Files that were read to know the tasks, such as a manifest.
    pub reads: Vec<PathBuf>,
    /// Replace an existing summary or report.
    pub force: bool,
}

/// How a run goes about its work, the same for all models.
pub(crate) struct Run<'r> {
    args: &'r RunArgs,
    format: RunFormat,
    folders: Folders,
    journal: Option<Journal>,
    done: Done,
    /// One model in all: its page is about it alone.
    alone: bool,
}

/// Does all of `work`.
///
/// # Errors
/// Wrong usage: found before anything is written.
pub(crate) fn run(mut work: Work, args: &RunArgs, terminal: &mut Terminal) -> Result<Exit> {
    check_files(&work, args)?;
    if let Some(shard) = args.shard {
        work.tasks.retain(|task| shard.has(task));
    }
    let mut exit = Exit::Done;
    let several = work.tasks.len() + work.failures.len() > 1;
    let few = if work.tasks.len() > FEW { RunFormat::Lines } else { RunFormat::Table };
    let format = args.format.unwrap_or(few);
    for failure in &work.failures {
        exit = exit.and(tell_failure(failure, format, terminal));
    }
    for remark in work.remarks.iter().filter(|_| !args.quiet) {
        terminal.note(&format!("note: {remark}\n"))?;
    }
    let done = Done::read(args)?;
    let mut page = begin_page(&work, args, &done)?;
    let journal = Journal::begin(args, work.force)?;
    let folders = look_at_folders(&work.tasks, args);
    interrupt::outlive_size_limit();
    let run = Run { args, format, folders, journal, done, alone: work.is_one() };
    if let Some(journal) = &run.journal {
        work.failures.iter().for_each(|failure| journal.tell(&Record::of_failure(failure)));
    }
    let count = run.work_off(&work.tasks, &mut page, terminal)?;
    if let Some(Err(error)) = run.journal.map(Journal::finish) {
        terminal.error(&format!("error: {error:#}\n"));
        exit = exit.and(Exit::Failed);
    }
    exit = exit.and(Page::end(page, terminal));
    if !args.quiet && several {
        terminal.note(&count.text(args))?;
    } else if !args.quiet && count.interrupted() {
        terminal.note("stopped\n")?;
    }
    Ok(exit.and(count.exit()))
}

impl Run<'_> {
    /// Does all tasks on as many threads as there are processors.
    fn work_off(
        &self,
        tasks: &[Task],
        page: &mut Option<Page>,
        terminal: &mut Terminal,
    ) -> Result<outcome::Count> {
        let progress = Progress::begin(tasks.len(), self.args.quiet);
        if tasks.len() > 1 {
            interrupt::listen();
        }
        let mut count = outcome::Count::default();
        let work = |task: &Task| {
            let outcome = self.one(task, tasks);
            progress.done(outcome.record.status == record::Status::Failed);
            outcome
        };
        let tell = |_: &Task, mut outcome: Outcome| {
            count.add(&outcome);
            if let Some(journal) = &self.journal {
                journal.tell(&outcome.record);
            }
            if let Some(page) = page {
                page.tell(outcome.entry());
            }
            // Results that cannot be shown are no reason to leave the other models undone.
            if let Err(error) = progress.suspended(|| tell(&outcome, terminal)) {
                terminal.error(&format!("error: cannot write to standard output: {error:#}\n"));
                count.untold();
            }
            Ok(())
        };
        in_order(tasks, threads(self.args.jobs, tasks.len()), work, tell)?;
        progress.end();
        Ok(count)
    }

    fn one(&self, task: &Task, tasks: &[Task]) -> Outcome {
        if interrupt::came() {
            let mut outcome = Outcome::not_begun(task);
            self.done.left_behind(&mut outcome.record);
            return outcome;
        }
        let frame = self.args.report.as_ref().map(|_| page::frame(tasks, task, self.alone));
        task.run(self, frame)
    }
}

impl Work {
    fn is_one(&self) -> bool {
        self.tasks.len() + self.failures.len() == 1
    }
}

fn begin_page(work: &Work, args: &RunArgs, done: &Done) -> Result<Option<Page>> {
    let Some(path) = &args.report else { return Ok(None) };
    let shown = || match (work.tasks.first(), work.failures.first()) {
        (Some(task), _) => task.source.shown(),
        (None, failure) => failure.map(|failure| failure.model.clone()).unwrap_or_default(),
    };
    let about = About { verb: work.verb, model: work.is_one().then(shown), columns: Columns::Changes };
    let replace = match (work.force, done.is_empty()) {
        (true, _) => Replace::Files,
        // A run that goes on writes its page anew, as it does its summary.
        (false, false) => Replace::Pages,
        (false, true) => Replace::Never,
    };
    let mut page = Page::begin(path, replace, about)?;
    work.failures.iter().for_each(|failure| page.tell(Entry::lost(failure)));
    Ok(Some(page))
}

/// Looks at every folder that the run writes into.
fn look_at_folders(tasks: &[Task], args: &RunArgs) -> Folders {
    let models = tasks.iter().filter_map(Task::output);
    let geometry = tasks.iter().filter_map(|task| task.geometry_output.as_deref());
    let beside = [&args.summary, &args.report].into_iter().filter_map(|path| path.as_deref());
    Folders::look(models.chain(geometry).chain(beside), !args.dry_run)
}

/// Nothing is written over what is read, and no file is written twice.
fn check_files(work: &Work, args: &RunArgs) -> Result<()> {
    let tasks = &work.tasks;
    let mut ledger = Ledger::default();
    work.reads.iter().for_each(|path| ledger.read(path.as_path()));
    let mut known: Option<&Arc<Order>> = None;
    for task in tasks {
        ledger.read_again(task.source.path.as_path());
        // The files of an order are looked at once for all of its models.
        if !known.is_some_and(|order| Arc::ptr_eq(order, &task.order)) {
            // A reference is read before the first model, so a folder's run may change it; rows may not lean on that.
            task.order.reads().into_iter().for_each(|path| {
                if task.row.is_some() { ledger.read_again(path) } else { ledger.read(path) }
            });
            known = Some(&task.order);
        }
    }
    for task in tasks {
        let who = task.who();
        match task.output() {
            Some(path) if task.order.in_place => ledger.change(path, who)?,
            Some(path) => ledger.write(path, who)?,
            None => {}
        }
        match (&task.order.parts.geometry, &task.geometry_output) {
            (Some(_), Some(path)) if task.order.in_place => ledger.change(path, who)?,
            (Some(geometry), Some(path)) => ledger.write(path, Who::Model(geometry, None))?,
            _ => {}
        }
    }
    if let Some(path) = &args.report {
        ledger.write(path, "the report")?;
    }
    args.summary.as_ref().map_or(Ok(()), |path| ledger.write(path, "the summary"))
}

fn tell_failure(failure: &Failure, format: RunFormat, terminal: &mut Terminal) -> Exit {
    // Scripts read one object per model, also of those that failed.
    if format == RunFormat::Json && terminal.print(&failure.json()).is_err() {
        return Exit::Failed;
    }
    terminal.error(&failure.text());
    Exit::Failed
}

fn tell(outcome: &Outcome, terminal: &mut Terminal) -> Result<()> {
    for said in &outcome.said {
        match said {
            Said::Result(bytes) => terminal.write_bytes(bytes)?,
            Said::Note(text) => terminal.note(text)?,
            Said::Error(text) => terminal.error(text),
        }
    }
    Ok(())
}
