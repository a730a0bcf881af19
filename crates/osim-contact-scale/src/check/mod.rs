//! `check`: what the limits of the paper and the traps of the format say about models.
//!
//! One model gives a [`Report`], on any thread; renderers and the exit status only read it. Codes, severities and their
//! explanations are those of the one register, `osim_patch::WarningCode`.

mod csv;
mod finding;
mod limits;
mod mend;
mod table;
mod traps;

use std::io::IsTerminal;

use anyhow::Result;
use osim_patch::{Assignment, Model, Property, Set, Severity, Warning, WarningCode, set};

use crate::args::{CheckArgs, SheetFormat, ViewArgs};
use crate::failure::Failure;
use crate::folders::Folders;
use crate::look::{Inspection, Look, View};
use crate::page::{self, Entry, Page, entry_of_look};
use crate::report::json;
use crate::sources::{Source, Sources};
use crate::terminal::{Exit, Terminal};
use crate::weighed::Weighed;
use crate::workers::{in_order, threads};

pub(crate) use finding::{Counts, Finding, Report};
use mend::Mend;
use table::Library;

/// Checks all models.
///
/// # Errors
/// Wrong usage.
pub(crate) fn run(args: &CheckArgs, terminal: &mut Terminal) -> Result<Exit> {
    let sources = Sources::find(&args.models, None);
    let look = Look::of_check(args)?;
    let mut page = Page::of_looks(&look, &sources)?;
    let mut exit = Exit::Done;
    for failure in &sources.failures {
        exit = exit.and(fail(failure, args, terminal)?);
    }
    for remark in &sources.remarks {
        terminal.note(&format!("note: {remark}\n"))?;
    }
    let check = Check {
        look,
        folders: Folders::look(sources.models.iter().map(|source| source.path.as_path()), false),
    };
    let deny = args.deny.severity();
    // One model in full; a library as one table, told when all of it is known.
    let mut library = (sources.models.len() > 1).then(Library::default);
    let (mut without_contacts, mut first, mut untold) = (0, true, None);
    let threads = threads(None, sources.models.len());
    in_order(
        &sources.models,
        threads,
        |source| check.one(source, &sources),
        |source, report| {
            match report {
                Ok((report, entry)) => {
                    if let Some((page, entry)) = page.as_mut().zip(entry) {
                        page.tell(*entry);
                    }
                    if report.reaches(deny) {
                        exit = exit.and(Exit::Failed);
                    }
                    let told = match (args.format, &mut library) {
                        (SheetFormat::Json, _) => terminal.print(&json::line(&report)),
                        (SheetFormat::Csv, _) => terminal.print(&csv::rows(&report, first)?),
                        (SheetFormat::Table, None) => terminal.print_painted(&table::text(&report)),
                        (SheetFormat::Table, Some(library)) => {
                            library.add(report);
                            Ok(())
                        }
                    };
                    // What cannot be printed is no reason to leave a page without its models.
                    match (told, &page) {
                        (Err(error), Some(_)) => untold = untold.take().or(Some(error)),
                        (told, _) => told?,
                    }
                    first = false;
                }
                // A folder may hold models without contacts; one that was named may not.
                Err(failure) if failure.code == "no-contacts" && source.folder.is_some() => {
                    without_contacts += 1;
                    if let Some(page) = &mut page {
                        page.tell(Entry::passed_over(&failure.model));
                    }
                }
                Err(failure) => {
                    exit = exit.and(fail(&failure, args, terminal)?);
                    if let Some(page) = &mut page {
                        page.tell(Entry::lost(&failure));
                    }
                    if let Some(library) = &mut library {
                        library.add_failed(&source.shown());
                    }
                }
            }
            Ok(())
        },
    )?;
    exit = exit.and(Page::end(page, terminal));
    untold.map_or(Ok(()), Err)?;
    if let Some(library) = library.filter(|_| args.format == SheetFormat::Table) {
        terminal.print_painted(&library.text(!std::io::stdout().is_terminal()))?;
    }
    if without_contacts > 0 {
        terminal.note(&format!("note: models without contacts passed over: {without_contacts}\n"))?;
    }
    Ok(exit)
}

fn fail(failure: &Failure, args: &CheckArgs, terminal: &mut Terminal) -> Result<Exit> {
    if args.format == SheetFormat::Json {
        terminal.print(&failure.json())?;
    }
    terminal.error(&failure.text());
    Ok(Exit::Failed)
}

struct Check<'c> {
    look: Look<'c>,
    folders: Folders,
}

impl Check<'_> {
    /// Everything found in one model, and the page's entry of it where a page is asked for.
    fn one(&self, source: &Source, sources: &Sources) -> Result<(Report, Option<Box<Entry>>), Failure> {
        let Look { view, args, .. } = &self.look;
        self.look.with(source, |loaded, model, seen| {
            if let Err(fault) = view.selection.apply(model)
                && fault.code() == "no-contacts"
                && !seen.warnings.iter().any(|warning| warning.code.severity() == Severity::Error)
            {
                return Err(loaded.failure(fault));
            }
            let beside = (!source.is_stdin()).then(|| self.folders.compiled_beside(&source.path)).flatten();
            let report = judged(view, args, model, &seen, beside.as_ref());
            let entry = page::frame_of_look(&self.look, source, sources)
                .map(|frame| Box::new(entry_of_look(view, loaded, model, (&seen, &report), frame)));
            Ok((report, entry))
        })
    }
}

/// Everything found in a model that was looked at; `compiled` tells of files that OpenSim would read instead of it.
pub(crate) fn judged(
    view: &View,
    args: &ViewArgs,
    model: &Model,
    seen: &Inspection,
    compiled: Option<&Warning>,
) -> Report {
    let joined = |force| traps::mixed_radii(model, force).is_some() || force.sets.len() > 1;
    let joined = model.forces.iter().any(joined);
    let mut mend = Mend::new(seen, joined, changes(view, model), args);
    let weighed = Weighed::otherwise(model, &view.masses);
    let another_mass = limits::another_mass(seen, &mend);
    // Contacts that are made right for the body first need other commands afterwards.
    if weighed.is_some() || another_mass.is_some() {
        mend = mend.unsettled();
    }
    let mut findings = traps::findings(model, seen, &mend);
    if let Some(weighed) = weighed {
        let disagree = findings.iter_mut().filter(|finding| finding.code == WarningCode::MassSourcesDisagree);
        disagree.for_each(|finding| finding.message.push_str(&weighed.aside()));
    }
    findings.extend(limits::findings(seen, &mend));
    findings.extend(another_mass);
    findings.extend(compiled.map(Finding::from));
    Report::new(seen.model.clone(), findings)
}

/// `true` where the numbers of `model` can be changed: a command that would be refused is no help.
fn changes(view: &View, model: &Model) -> bool {
    let assignments =
        vec![(Property::Dissipation, Assignment::Value(0.0)), (Property::Stiffness, Assignment::Value(1.0))];
    let trial = Set { assignments, contacts_mass: None, again: true };
    let plan = view.selection.apply(model).and_then(|selected| set(model, &selected, &trial));
    plan.and_then(|plan| plan.patched(model, 0)).is_ok()
}
