//! `inspect` and `check`: the contacts of models, their indentation under the body's weight, and their faults.

use std::collections::BTreeMap;
use std::path::PathBuf;

use anyhow::{Result, bail};
use osim_library::{Disk, Sources, Survey, SurveyedModel, resolved};
use osim_model::Severity;
use osim_model::messages::{Call, Input, Verb};
use osim_planning::{Inspector, unreadable_recording};
use osim_requests::options::SheetFormat;
use osim_requests::{CheckRequest, InspectRequest};
use osim_view::report::json::line;
use osim_view::report::{check, inspection};

use crate::exit::{self, Exit};
use crate::one_call::{Session, end_page, typed_command_line};

/// Inspects all models; with `hint`, also prints the calls to make next.
///
/// # Errors
/// Wrong usage.
pub(crate) fn inspect(request: &InspectRequest, hint: bool, session: &mut Session) -> Result<Exit> {
    let inspector = Inspector::for_inspect(request, &Disk);
    let format = request.format;
    if let Some(failure) = inspector.generic_failure() {
        // Once, not for every model.
        return session.report_failure(failure, format == SheetFormat::Json);
    }
    let survey = Survey {
        verb: Verb::Inspect,
        sources: &Sources::find(&request.models, None),
        memory: &BTreeMap::new(),
        inspector: &inspector,
        report: &request.report,
        // Factors of bodies have no room in a table.
        shows_each: request.from.is_some() || format != SheetFormat::Table,
        check: None,
        layout: session.layout(request.full),
        words: session.words,
    };
    let shown = show_models(&survey, format, session)?;
    if hint && shown.is_any && format == SheetFormat::Table {
        session.terminal.print(&calls_to_make_next(session, &request.models, shown.has_contacts))?;
    }
    Ok(shown.exit)
}

/// Checks all models.
///
/// # Errors
/// Wrong usage.
pub(crate) fn check(request: &CheckRequest, session: &mut Session) -> Result<Exit> {
    if let ([model], Some(from)) = (request.models.as_slice(), &request.from)
        && resolved(model) == resolved(from)
    {
        let from = session.words.input(Input::From, None);
        bail!("{} is the model itself: name the one that it was scaled from with {from}", model.display());
    }
    let json = request.format == SheetFormat::Json;
    if let Some(failure) = unreadable_recording(request, &Disk) {
        return session.report_failure(&failure, json);
    }
    let inspector = Inspector::for_check(request, &Disk);
    if let Some(failure) = inspector.generic_failure() {
        return session.report_failure(failure, json);
    }
    let survey = Survey {
        verb: Verb::Check,
        sources: &Sources::find(&request.models, request.output_dir.as_deref()),
        memory: &BTreeMap::new(),
        inspector: &inspector,
        report: &request.report,
        shows_each: request.format != SheetFormat::Table,
        check: Some(request),
        layout: session.layout(request.full),
        words: session.words,
    };
    let shown = show_models(&survey, request.format, session)?;
    // The table of findings says it itself.
    if shown.without_contacts > 0 && (request.full || request.format != SheetFormat::Table) {
        let text = format!("remark: models without contacts skipped: {}\n", shown.without_contacts);
        session.terminal.print_to_stderr(&text)?;
    }
    let is_denied = shown.worst >= Some(request.deny.severity());
    Ok(if is_denied { shown.exit.plus(Exit::Failed) } else { shown.exit })
}

/// Counts and findings over all models that were shown.
struct Totals {
    exit: Exit,
    /// Whether at least one model could be read.
    is_any: bool,
    has_contacts: bool,
    /// Number of models that were skipped because they have no contacts.
    without_contacts: usize,
    /// The severity of the worst finding in all models.
    worst: Option<Severity>,
}

/// Shows all models, and writes the report page.
///
/// # Errors
/// Wrong usage, or standard output cannot be written.
fn show_models(survey: &Survey<'_>, format: SheetFormat, session: &mut Session) -> Result<Totals> {
    exit::outlive_size_limit();
    let mut page = survey.begin_page(typed_command_line()).map_err(|fault| session.file_error(&fault))?;
    let json = format == SheetFormat::Json;
    let mut shown =
        Totals { exit: Exit::Done, is_any: false, has_contacts: false, without_contacts: 0, worst: None };
    for failure in &survey.sources.failures {
        shown.exit = shown.exit.plus(session.report_failure(failure, json)?);
    }
    for remark in &survey.sources.remarks {
        session.terminal.remark(remark)?;
    }
    let mut text = survey.begin_text();
    let each = |name: &str, surveyed: SurveyedModel| -> Result<()> {
        let header = !shown.is_any;
        match &surveyed {
            SurveyedModel::Inspected(inspected, _) => shown.has_contacts |= !inspected.forces.is_empty(),
            SurveyedModel::Checked(found, _) => {
                let worst = found.findings.iter().map(|finding| finding.severity).max();
                shown.worst = shown.worst.max(worst);
            }
            SurveyedModel::WithoutContacts => shown.without_contacts += 1,
            SurveyedModel::Failed(failure) => {
                shown.exit = shown.exit.plus(session.report_failure(failure, json)?);
            }
        }
        shown.is_any |= matches!(surveyed, SurveyedModel::Inspected(..) | SurveyedModel::Checked(..));
        let terminal = &mut session.terminal;
        match (format, &surveyed) {
            (SheetFormat::Json, SurveyedModel::Inspected(inspected, _)) => {
                terminal.print_records(&line(inspected))?;
            }
            (SheetFormat::Json, SurveyedModel::Checked(found, _)) => terminal.print_records(&line(found))?,
            (SheetFormat::Csv, SurveyedModel::Inspected(inspected, _)) => {
                terminal.print_records(&inspection::csv_rows(inspected, header)?)?;
            }
            (SheetFormat::Csv, SurveyedModel::Checked(found, _)) => {
                terminal.print_records(&check::csv_rows(found, header)?)?;
            }
            _ => terminal.print_painted(&text.add(name, &surveyed))?,
        }
        Ok(())
    };
    let not_printed = survey.run(&mut page, None, || false, each)?;
    shown.exit = shown.exit.plus(end_page(page, session));
    not_printed.map_or(Ok(()), Err)?;
    session.terminal.print_painted(&text.end())?;
    Ok(shown)
}

/// Calls to make next, shown once after all models. If no model has contacts, calls that add contacts.
fn calls_to_make_next(session: &Session, models: &[PathBuf], has_contacts: bool) -> String {
    // Where there are many, they are not named.
    let few = Some(models).filter(|models| models.len() <= 3).unwrap_or_default();
    let files: Vec<String> = few.iter().map(|path| path.display().to_string()).collect();
    let command = |call: Call| session.words.command(&Call { files: files.clone(), ..call });
    let mut rows = if has_contacts {
        let rescale = Verb::Rescale.call_with_model().with_placeholder(Input::TargetMass, "KG");
        let transfer = Verb::Transfer.call_with_model().with_placeholder(Input::From, "OTHER");
        vec![
            (command(Verb::Check.call_with_model()), "what to fix, and how"),
            (command(rescale), "scale its contacts to another mass"),
            (command(transfer), "take the contacts of a known model"),
        ]
    } else {
        let add = Verb::Add.call_with_model().with_placeholder(Input::From, "OTHER");
        vec![(command(add), "give it the contacts of another model")]
    };
    rows.push(("osim-contact-scale --help".to_owned(), "everything else"));
    let width = rows.iter().map(|(call, _)| call.chars().count()).max().unwrap_or_default();
    let steps: String = rows.iter().map(|(call, what)| format!("  {call:<width$}  {what}\n")).collect();
    format!("\nNothing was changed. Next:\n{steps}")
}
