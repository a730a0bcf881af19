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

use anyhow::Result;
use osim_patch::{Assignment, Model, Property, Set, Severity, set};

use crate::args::{CheckArgs, SheetFormat};
use crate::failure::Failure;
use crate::folders::Folders;
use crate::look::{Inspection, Look};
use crate::report::json;
use crate::sources::{Source, Sources};
use crate::terminal::{Exit, Terminal};
use crate::workers::{in_order, threads};

use finding::{Finding, Report};
use mend::Mend;
use table::Library;

/// Checks all models.
///
/// # Errors
/// Wrong usage.
pub(crate) fn run(args: &CheckArgs, terminal: &mut Terminal) -> Result<Exit> {
    let sources = Sources::find(&args.models, None);
    let mut exit = Exit::Done;
    for failure in &sources.failures {
        exit = exit.and(fail(failure, args, terminal)?);
    }
    for remark in &sources.remarks {
        terminal.note(&format!("note: {remark}\n"))?;
    }
    let check = Check {
        look: Look::of_check(args)?,
        folders: Folders::look(sources.models.iter().map(|source| source.path.as_path()), false),
        args,
    };
    let deny = args.deny.severity();
    // One model in full; a library as one table, told when all of it is known.
    let mut library = (sources.models.len() > 1).then(Library::default);
    let (mut without_contacts, mut first) = (0, true);
    let threads = threads(None, sources.models.len());
    in_order(
        &sources.models,
        threads,
        |source| check.one(source),
        |source, report| {
            match report {
                Ok(report) => {
                    if report.reaches(deny) {
                        exit = exit.and(Exit::Failed);
                    }
                    match (args.format, &mut library) {
                        (SheetFormat::Json, _) => terminal.print(&json::line(&report))?,
                        (SheetFormat::Csv, _) => terminal.print(&csv::rows(&report, first)?)?,
                        (SheetFormat::Table, None) => terminal.print_painted(&table::text(&report))?,
                        (SheetFormat::Table, Some(library)) => library.add(report),
                    }
                    first = false;
                }
                // A folder may hold models without contacts; one that was named may not.
                Err(failure) if failure.code == "no-contacts" && source.folder.is_some() => {
                    without_contacts += 1;
                }
                Err(failure) => {
                    exit = exit.and(fail(&failure, args, terminal)?);
                    if let Some(library) = &mut library {
                        library.add_failed(&source.shown());
                    }
                }
            }
            Ok(())
        },
    )?;
    if let Some(library) = library.filter(|_| args.format == SheetFormat::Table) {
        terminal.print_painted(&library.text())?;
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
    args: &'c CheckArgs,
}

impl Check<'_> {
    /// Everything found in one model.
    fn one(&self, source: &Source) -> Result<Report, Failure> {
        self.look.with(source, |loaded, model, seen| {
            if let Err(fault) = self.look.selection.apply(model)
                && fault.code() == "no-contacts"
                && !seen.warnings.iter().any(|warning| warning.code.severity() == Severity::Error)
            {
                return Err(loaded.failure(fault));
            }
            Ok(self.report(source, model, &seen))
        })
    }

    /// `true` where the numbers of `model` can be changed: a command that would be refused is no help.
    fn changes(&self, model: &Model<'_, '_>) -> bool {
        let assignments = vec![
            (Property::Dissipation, Assignment::Value(0.0)),
            (Property::Stiffness, Assignment::Value(1.0)),
        ];
        let trial = Set { assignments, contacts_mass: None, again: true };
        let plan = self.look.selection.apply(model).and_then(|selected| set(model, &selected, &trial));
        plan.and_then(|plan| plan.patched(model, 0)).is_ok()
    }

    fn report(&self, source: &Source, model: &Model<'_, '_>, seen: &Inspection) -> Report {
        let joined = |force| traps::mixed_radii(model, force).is_some() || force.sets.len() > 1;
        let joined = model.forces.iter().any(joined);
        let mend = Mend::new(seen, joined, self.changes(model), self.args);
        let mut findings = traps::findings(model, seen, &mend);
        findings.extend(limits::findings(seen, &mend));
        if !source.is_stdin() {
            let compiled = self.folders.compiled_beside(&source.path);
            findings.extend(compiled.iter().map(Finding::from));
        }
        Report::new(seen.model.clone(), findings)
    }
}
