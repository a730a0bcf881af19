//! `inspect`: what contacts a model has, and what they do under its weight.

use anyhow::Result;
use osim_inspect::Inspection;
use osim_library::{Disk, Source, Sources, in_order, threads};
use osim_model::files::Failure;
use osim_model::wording::{Call, Input, Verb};
use osim_report::html::Entry;
use osim_report::inspection;
use osim_report::json::line;
use osim_report::layout::Colour;
use osim_requests::InspectRequest;
use osim_requests::options::SheetFormat;

use super::survey::Survey;
use crate::report_page::ReportPage;
use crate::session::Session;
use crate::terminal::Exit;

/// Inspects all models; `hint` where the reader should see what to do next.
///
/// # Errors
/// Wrong usage.
pub(super) fn run(request: &InspectRequest, hint: bool, session: &mut Session) -> Result<Exit> {
    let sources = Sources::find(&request.models, None);
    let inspector = request.inspector(&Disk);
    let json = request.format == SheetFormat::Json;
    if let Some(failure) = inspector.generic_failure() {
        // Once, not for every model.
        return session.fail(failure, json);
    }
    let (words, report) = (session.words, &request.report);
    let mut exit = Exit::Done;
    let survey = Survey { verb: Verb::Inspect, sources: &sources, inspector: &inspector, report, words };
    let mut page = survey.begin_page(session)?;
    for failure in &sources.failures {
        exit = exit.and(session.fail(failure, json)?);
    }
    for remark in &sources.remarks {
        session.terminal.note_line(remark)?;
    }
    let (mut first, mut untold) = (true, None);
    let with_page = page.is_some();
    in_order(
        &sources.models,
        threads(None, sources.models.len()),
        |source| one(&survey, source, with_page),
        |_, seen| -> Result<(), Stop> {
            match seen {
                Ok((seen, entry)) => {
                    // What cannot be printed is no reason to leave a page without its models.
                    let reported = print(&seen, request.format, first, session);
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
                }
            }
            Ok(())
        },
    )
    .map_err(|stop| stop.0)?;
    exit = exit.and(ReportPage::end(page, session));
    untold.map_or(Ok(()), Err)?;
    if hint && !first && request.format == SheetFormat::Table {
        session.terminal.print(&next_steps(session))?;
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

/// A model, and its entry on the page where one is asked for.
fn one(
    survey: &Survey<'_>,
    source: &Source,
    with_page: bool,
) -> Result<(Inspection, Option<Box<Entry>>), Failure> {
    let mut seen = survey.see(source)?;
    let found = with_page.then(|| survey.check(&mut seen, None));
    seen.inspection.spell(survey.words);
    let entry = found.map(|found| Box::new(survey.entry(&seen, &found)));
    Ok((seen.inspection, entry))
}

fn print(seen: &Inspection, format: SheetFormat, first: bool, session: &mut Session) -> Result<()> {
    match format {
        SheetFormat::Json => session.terminal.print(&line(seen))?,
        SheetFormat::Csv => session.terminal.print(&inspection::csv_rows(seen, first)?)?,
        _ => {
            let gap = if first { "" } else { "\n" };
            let text = inspection::text(seen, session.words, Colour::Ansi);
            session.terminal.print_painted(&format!("{gap}{text}"))?;
        }
    }
    Ok(())
}

/// What to do next, once, after all models.
fn next_steps(session: &Session) -> String {
    let words = session.words;
    let rescale = Verb::Rescale.of_model().with(Input::TargetMass, "KG");
    let transfer = Verb::Transfer.of_model().with(Input::From, "OTHER");
    let row = |call: &Call, what: &str| format!("  {:<50}{what}\n", words.command(call));
    format!(
        "\nNothing was changed. Next (MODEL is the name of the file, in quotes where it has blanks):\n{}{}{}{}",
        row(&Verb::Check.of_model(), "what to fix, and how"),
        row(&rescale, "scale its contacts to another mass"),
        row(&transfer, "take the contacts of a known model"),
        "  osim-contact-scale --help                         everything else\n"
    )
}
