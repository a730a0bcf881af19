//! `inspect`: what contacts a model has, and what they do under its weight.

use anyhow::Result;
use osim_inspect::{Counts, Inspection};
use osim_library::page::Survey;
use osim_library::{Disk, Folders, Source, Sources, in_order, threads};
use osim_model::files::Failure;
use osim_model::messages::{Call, Input, Verb};
use osim_planning::Inspector;
use osim_requests::InspectRequest;
use osim_requests::options::SheetFormat;
use osim_view::html::Entry;
use osim_view::report::inspection::{self, ModelsTable};
use osim_view::report::json::line;
use osim_view::report::layout::Colour;

use crate::commands::output::{asked, end_page};
use crate::exit::{self, Exit};
use crate::session::Session;

/// Inspects all models; `hint` where the reader should see what to do next.
///
/// # Errors
/// Wrong usage.
pub(super) fn run(request: &InspectRequest, hint: bool, session: &mut Session) -> Result<Exit> {
    let sources = Sources::find(&request.models, None);
    let inspector = Inspector::of_inspect(request, &Disk);
    let json = request.format == SheetFormat::Json;
    if let Some(failure) = inspector.generic_failure() {
        // Once, not for every model.
        return session.fail(failure, json);
    }
    let (words, report) = (session.words, &request.report);
    let mut exit = Exit::Done;
    let survey = Survey { verb: Verb::Inspect, sources: &sources, inspector: &inspector, report, words };
    exit::outlive_size_limit();
    let mut page = survey.begin_page(asked()).map_err(|fault| session.refused(&fault))?;
    for failure in &sources.failures {
        exit = exit.and(session.fail(failure, json)?);
    }
    for remark in &sources.remarks {
        session.terminal.note_line(remark)?;
    }
    let (mut first, mut has_contacts, mut untold) = (true, false, None);
    let with_page = page.is_some();
    // One model in full; several as one table, printed when all of it is known. Factors of bodies have no room in it.
    let several = sources.models.len() + sources.failures.len() > 1 && request.from.is_none();
    let is_table = several && !request.full && request.format == SheetFormat::Table;
    let mut table = is_table.then(ModelsTable::default);
    for failure in sources.failures.iter().filter(|_| is_table) {
        table.iter_mut().for_each(|table| table.add_failed(&failure.model.to_string(), failure.code));
    }
    let folders =
        is_table.then(|| Folders::list(sources.models.iter().map(|source| source.path.as_path()), false));
    in_order(
        &sources.models,
        threads(None, sources.models.len()),
        |source| one(&survey, folders.as_ref(), source, with_page),
        |source, seen| -> Result<(), Stop> {
            match seen {
                Ok(Inspected { inspection, counts, entry }) => {
                    has_contacts |= !inspection.forces.is_empty();
                    // What cannot be printed is no reason to leave a page without its models.
                    let reported = match table.as_mut().zip(counts) {
                        Some((table, counts)) => {
                            table.add(&inspection, counts);
                            Ok(())
                        }
                        None => print(&inspection, request.format, first, session),
                    };
                    match (reported, &page) {
                        (Err(error), Some(_)) => untold = untold.take().or(Some(error)),
                        (reported, _) => reported.map_err(Stop)?,
                    }
                    first = false;
                    if let Some((page, entry)) = page.as_mut().zip(entry) {
                        page.add(*entry);
                    }
                }
                Err(failure) => {
                    exit = exit.and(session.fail(&failure, json).map_err(Stop)?);
                    if let Some(page) = &mut page {
                        page.add(Entry::failed(&failure, words));
                    }
                    if let Some(table) = &mut table {
                        table.add_failed(&source.shown(), failure.code);
                    }
                }
            }
            Ok(())
        },
    )
    .map_err(|stop| stop.0)?;
    exit = exit.and(end_page(page, session));
    untold.map_or(Ok(()), Err)?;
    if let Some(table) = table {
        let text = table.text(session.terminal.columns(), words, Colour::Ansi);
        session.terminal.print_painted(&text)?;
    }
    if hint && !first && request.format == SheetFormat::Table {
        session.terminal.print(&next_steps(session, has_contacts))?;
    }
    Ok(exit)
}

/// An error that ends the work.
pub(super) struct Stop(pub(super) anyhow::Error);

impl From<osim_library::LibraryFault> for Stop {
    fn from(fault: osim_library::LibraryFault) -> Self {
        Self(anyhow::anyhow!(fault.to_string()))
    }
}

/// A model that was looked at.
struct Inspected {
    inspection: Inspection,
    /// How much is wrong with it, if the call asks for that.
    counts: Option<Counts>,
    /// Its entry on the page, where there is one.
    entry: Option<Box<Entry>>,
}

/// Looks at a model. What is wrong with it is found only for a table, for which `folders` is known, and for a page.
fn one(
    survey: &Survey<'_>,
    folders: Option<&Folders>,
    source: &Source,
    with_page: bool,
) -> Result<Inspected, Failure> {
    let mut seen = survey.inspect(source)?;
    let beside = folders.filter(|_| !source.is_stdin()).and_then(|known| known.compiled_beside(&source.path));
    let found = (with_page || folders.is_some()).then(|| survey.check(&mut seen, beside.as_ref(), &Disk));
    seen.inspection.spell(survey.words);
    let counts = found.as_ref().map(|found| found.counts);
    let entry = found.filter(|_| with_page).map(|found| Box::new(survey.entry(&seen, &found)));
    Ok(Inspected { inspection: seen.inspection, counts, entry })
}

fn print(seen: &Inspection, format: SheetFormat, first: bool, session: &mut Session) -> Result<()> {
    match format {
        SheetFormat::Json => session.terminal.print_records(&line(seen))?,
        SheetFormat::Csv => session.terminal.print_records(&inspection::csv_rows(seen, first)?)?,
        _ => {
            let gap = if first { "" } else { "\n" };
            let text = inspection::text(seen, session.words, Colour::Ansi);
            session.terminal.print_painted(&format!("{gap}{text}"))?;
        }
    }
    Ok(())
}

/// What to do next, once, after all models: without contacts in any of them, how they get some.
fn next_steps(session: &Session, has_contacts: bool) -> String {
    let words = session.words;
    let row = |call: &Call, what: &str| format!("  {:<50}{what}\n", words.command(call));
    let steps = if has_contacts {
        let rescale = Verb::Rescale.of_model().with(Input::TargetMass, "KG");
        let transfer = Verb::Transfer.of_model().with(Input::From, "OTHER");
        [
            row(&Verb::Check.of_model(), "what to fix, and how"),
            row(&rescale, "scale its contacts to another mass"),
            row(&transfer, "take the contacts of a known model"),
        ]
        .concat()
    } else {
        let add = Verb::Add.of_model().with(Input::From, "OTHER");
        row(&add, "give it the contacts of another model")
    };
    format!(
        "\nNothing was changed. Next (MODEL is the name of the file, in quotes where it has blanks):\n{steps}{}",
        "  osim-contact-scale --help                         everything else\n"
    )
}
