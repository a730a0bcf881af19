//! `sweep`: makes variants of one model, and a table of the variants and their files.
//!
//! Count and size are reported first; then each variant is made, written, and read again from its own bytes for the table.

use anyhow::Result;
use osim_library::{SweepEnd, SweepRun};
use osim_model::YesQuestion;
use osim_model::files::Failure;
use osim_model::messages::Input;
use osim_requests::SweepRequest;
use osim_requests::options::Format;
use osim_view::report::json::line;
use osim_view::report::results::SweepRecord;

use crate::exit::{self, Exit};
use crate::one_call::Session;
use crate::terminal::Progress;

/// Makes all variants of the request.
///
/// # Errors
/// Wrong usage, found before anything is written.
pub(crate) fn run(request: &SweepRequest, session: &mut Session) -> Result<Exit> {
    let json = request.format == Format::Json;
    let sweep = SweepRun::new(request).map_err(|error| session.refuse(error, json))?;
    sweep.plan.check_ends().map_err(|error| session.refuse(error, json))?;
    let (count, points) = (sweep.count(), sweep.plan.count());
    let is_part = request.point.is_some() || request.shard.is_some();
    let of = if is_part { format!(" of {points}") } else { String::new() };
    let megabytes = sweep.plan.model().bytes().len() as f64 / 1e6;
    let (all, folder) = (megabytes * count as f64, sweep.folder.display());
    let text = format!("{count}{of} models of {megabytes:.2} MB each, {all:.1} MB together, into {folder}");
    session.terminal.remark(&text)?;
    if request.ladder.is_some() {
        session.terminal.remark(
            "steps are equal in k R n/F by the Hertz law (B.3); relative_indentation_model_law in the table is where the \
             contacts rest by the law of their class",
        )?;
    }
    if request.dry_run {
        let text = match request.is_large() {
            true => format!(
                "dry run: nothing written; more than 10,000 models need {}\n",
                YesQuestion::ManyModels.answer_option().spelled(session.words)
            ),
            false => "dry run: nothing written\n".to_owned(),
        };
        return report(&sweep.record(None), &text, request, session).map(|()| Exit::Done);
    }
    let end = make_variants(&sweep, request, session)?;
    if end.worse > 0 {
        let (worse, made) = (end.worse, end.made + end.earlier);
        session.terminal.remark(&format!(
            "{worse} of {made} models have errors or warnings that the original model does not have: see the column worse of the table"
        ))?;
    }
    session.terminal.print_to_stderr(&remarks_of_sweep(&end, &sweep))?;
    if end.not_begun > 0 {
        let (made, resume) = (end.made + end.earlier, session.words.input(Input::Resume, None));
        session.terminal.remark(&format!(
            "stopped: {made} of {count} models are made; to continue, repeat the command with {resume}"
        ))?;
    }
    report(&sweep.record(Some(&end)), &text_after_sweep(&sweep, request, &end), request, session)?;
    Ok(match (end.not_begun, end.failed) {
        (0, 0) => Exit::Done,
        (0, _) => Exit::Failed,
        _ => Exit::Interrupted,
    })
}

/// Remarks about variants and files that the table does not show, one line each.
fn remarks_of_sweep(end: &SweepEnd, sweep: &SweepRun<'_>) -> String {
    let mut remarks = String::new();
    if let Some((point, earlier)) = end.same.first {
        let (have, such) = if end.same.count > 1 { ("have", "such as ") } else { ("has", "") };
        remarks.push_str(&format!(
            "remark: {} of {} models {have} the same contacts as an earlier one: {such}{point} and {earlier}\n",
            end.same.count,
            end.made + end.earlier,
        ));
    }
    if let Some(first) = &end.others.first {
        let folder = sweep.folder.display();
        let (models, such) = match end.others.count {
            ..2 => ("a model".to_owned(), ""),
            count => (format!("{count} models"), "such as "),
        };
        remarks.push_str(&format!(
            "remark: {folder} has {models} of another sweep, which the table does not list: {such}{first}\n"
        ));
    }
    remarks
}

fn make_variants(sweep: &SweepRun<'_>, request: &SweepRequest, session: &mut Session) -> Result<SweepEnd> {
    exit::listen_for_stop_signals();
    let watch = Progress::begin(sweep.count(), request.quiet);
    let json = request.format == Format::Json;
    // What cannot be shown is no reason to leave the other variants undone.
    let mut not_printed = None;
    let report = |failure: Option<Failure>| {
        let reported = failure.map(|failure| watch.suspended(|| session.report_failure(&failure, json)));
        if let Some(Err(error)) = reported {
            not_printed.get_or_insert(error);
        }
    };
    let end = sweep.run(exit::stop_is_requested, |failed| watch.count_model(failed), report);
    watch.end();
    let end = end.map_err(|fault| session.file_error(&fault))?;
    not_printed.map_or(Ok(end), Err)
}

fn text_after_sweep(sweep: &SweepRun<'_>, request: &SweepRequest, end: &SweepEnd) -> String {
    let points = sweep.plan.count();
    let Some(manifest) = &end.manifest else {
        return match request.shard {
            Some(shard) if sweep.count() == 0 => format!("share {shard} has none of the {points} models\n"),
            _ => "no model was made\n".to_owned(),
        };
    };
    let manifest = manifest.display();
    if let (Some(point), Some(file)) = (request.point, sweep.point_file()) {
        let file = sweep.folder.join(file);
        let done = if end.earlier > 0 { "done before" } else { "written" };
        return format!("point {point} of {points}: {} {done}; its values: {manifest}\n", file.display());
    }
    let (made, count) = (end.made, sweep.count());
    let of = if made + end.earlier < count { format!(" of {count}") } else { String::new() };
    let before = if end.earlier > 0 { format!(", {} done before", end.earlier) } else { String::new() };
    let share = request.shard.map(|shard| format!(", share {shard} of {points}")).unwrap_or_default();
    format!("{made}{of} models written{before}{share}; their values: {manifest}\n")
}

fn report(record: &SweepRecord, text: &str, request: &SweepRequest, session: &mut Session) -> Result<()> {
    let json = request.format == Format::Json;
    let text = if json { line(record) } else { text.to_owned() };
    Ok(session.terminal.print_as(&text, json)?)
}
