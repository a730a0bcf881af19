//! `check`: what the limits of the paper and the traps of the format say about models.

use anyhow::Result;
use osim_inspect::CheckResult;
use osim_library::page::Survey;
use osim_library::{Disk, Folders, Source, Sources, in_order, threads};
use osim_model::files::Failure;
use osim_model::messages::Verb;
use osim_planning::Inspector;
use osim_requests::CheckRequest;
use osim_requests::options::SheetFormat;
use osim_view::html::Entry;
use osim_view::report::check;
use osim_view::report::json::line;
use osim_view::report::layout::Colour;

use crate::commands::inspect::Stop;
use crate::commands::output::{asked, end_page};
use crate::exit::{self, Exit};
use crate::session::Session;

/// Checks all models.
///
/// # Errors
/// Wrong usage.
pub(super) fn run(request: &CheckRequest, session: &mut Session) -> Result<Exit> {
    let sources = Sources::find(&request.models, None);
    let inspector = Inspector::of_check(request, &Disk);
    let (words, report) = (session.words, &request.report);
    let survey = Survey { verb: Verb::Check, sources: &sources, inspector: &inspector, report, words };
    exit::outlive_size_limit();
    let mut page = survey.begin_page(asked()).map_err(|fault| session.refused(&fault))?;
    let json = request.format == SheetFormat::Json;
    let mut exit = Exit::Done;
    for failure in &sources.failures {
        exit = exit.and(session.fail(failure, json)?);
    }
    for remark in &sources.remarks {
        session.terminal.note_line(remark)?;
    }
    let folders = Folders::list(sources.models.iter().map(|source| source.path.as_path()), false);
    let deny = request.deny.severity();
    // One model in full; a library as one table, printed when all of it is known.
    let mut library = (sources.models.len() > 1).then(check::LibraryTable::default);
    let (mut without_contacts, mut first, mut untold) = (0, true, None);
    let with_page = page.is_some();
    in_order(
        &sources.models,
        threads(None, sources.models.len()),
        |source| one(&survey, &folders, source, with_page),
        |source, found| -> Result<(), Stop> {
            match found {
                Ok((found, entry)) => {
                    if let Some((page, entry)) = page.as_mut().zip(entry) {
                        page.add(*entry);
                    }
                    if found.reaches(deny) {
                        exit = exit.and(Exit::Failed);
                    }
                    let reported = match (request.format, &mut library) {
                        (SheetFormat::Table, Some(library)) => {
                            library.add(&found);
                            Ok(())
                        }
                        (format, _) => print(&found, format, first, session),
                    };
                    // What cannot be printed is no reason to leave a page without its models.
                    match (reported, &page) {
                        (Err(error), Some(_)) => untold = untold.take().or(Some(error)),
                        (reported, _) => reported.map_err(Stop)?,
                    }
                    first = false;
                }
                Err(failure) if source.is_skipped(&failure) => {
                    without_contacts += 1;
                    if let Some(page) = &mut page {
                        page.add(Entry::without_contacts(&failure.model));
                    }
                }
                Err(failure) => {
                    exit = exit.and(session.fail(&failure, json).map_err(Stop)?);
                    if let Some(page) = &mut page {
                        page.add(Entry::failed(&failure, words));
                    }
                    if let Some(library) = &mut library {
                        library.add_failed(&source.shown(), failure.code);
                    }
                }
            }
            Ok(())
        },
    )
    .map_err(|stop| stop.0)?;
    exit = exit.and(end_page(page, session));
    untold.map_or(Ok(()), Err)?;
    if let Some(library) = library.filter(|_| request.format == SheetFormat::Table) {
        let whole_names = session.terminal.columns().is_none();
        session.terminal.print_painted(&library.text(whole_names, words, Colour::Ansi))?;
    }
    if without_contacts > 0 {
        session.terminal.note(&format!("note: models without contacts skipped: {without_contacts}\n"))?;
    }
    Ok(exit)
}

fn print(found: &CheckResult, format: SheetFormat, first: bool, session: &mut Session) -> Result<()> {
    match format {
        SheetFormat::Json => session.terminal.print_records(&line(found))?,
        SheetFormat::Csv => session.terminal.print_records(&check::csv_rows(found, first)?)?,
        _ => session.terminal.print_painted(&check::text(found, session.words.prompt(), Colour::Ansi))?,
    }
    Ok(())
}

/// Everything found in one model, and its entry on the page where one is asked for.
fn one(
    survey: &Survey<'_>,
    folders: &Folders,
    source: &Source,
    with_page: bool,
) -> Result<(CheckResult, Option<Box<Entry>>), Failure> {
    let mut seen = survey.inspect(source)?;
    if source.folder.is_some() {
        survey.inspector.refuse_without_contacts(&seen.opened, &seen.inspection)?;
    }
    let beside = (!source.is_stdin()).then(|| folders.compiled_beside(&source.path)).flatten();
    let found = survey.check(&mut seen, beside.as_ref(), &Disk);
    let entry = with_page.then(|| {
        seen.inspection.spell(survey.words);
        Box::new(survey.entry(&seen, &found))
    });
    Ok((found, entry))
}
