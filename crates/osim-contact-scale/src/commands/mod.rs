//! Carries out each verb: read, plan, write, report. [`call`] finds the verb.

mod answers;
mod change;
mod completions;
mod plot;
mod survey;
mod sweep;

use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail};
use osim_library::Disk;
use osim_model::files::{CompanionPaths, Files};
use osim_requests::spell::{JsonRequest, Matlab};
use osim_requests::{DropTestRequest, PlotRequest, Request, SweepRequest};

use crate::args::{Call, OwnVerb};
use crate::exit::Exit;
use crate::one_call::{self, Language, Session};

/// Runs the verb of the call.
///
/// # Errors
/// Wrong usage, found before anything was written.
pub(crate) fn call(call: Call, session: &mut Session) -> Result<Exit> {
    match call {
        Call::WithoutVerb(Request::Rescale(request)) => change::rescale(*request, true, session),
        Call::WithoutVerb(request) | Call::Request(request) => answer_request(request, session),
        Call::Own(OwnVerb::Request { file, words }) => {
            answer_request(read_request(&file, words, session)?, session)
        }
        Call::Own(OwnVerb::Completions { shell }) => completions::run(shell, session),
        Call::Own(OwnVerb::Man { verb, output_dir: None, .. }) => {
            completions::manual(verb.as_deref(), session)
        }
        Call::Own(OwnVerb::Man { output_dir: Some(folder), force, .. }) => {
            completions::manuals(&folder, force, session)
        }
        // Answered by clap.
        Call::Own(OwnVerb::Help { .. } | OwnVerb::Version) => Ok(Exit::Done),
    }
}

fn answer_request(request: Request, session: &mut Session) -> Result<Exit> {
    let is_quiet = match &request {
        Request::Sweep(sweep) => sweep.quiet,
        request => request.run_options().is_some_and(|run| run.quiet),
    };
    if is_quiet {
        session.terminal.keep_quiet();
    }
    match request {
        Request::Rescale(request) => change::rescale(*request, false, session),
        Request::Design(request) if request.models.is_empty() => answers::design(&request, session),
        Request::Fit(request) if !request.is_of_motion() => answers::fit(&request, session),
        changing @ (Request::Transfer(_)
        | Request::Add(_)
        | Request::Convert(_)
        | Request::Remove(_)
        | Request::Design(_)
        | Request::Set(_)
        | Request::Fit(_)
        | Request::Note(_)) => change::change_models(changing, session),
        Request::Batch(request) => change::run_batch(&request, session),
        Request::Sweep(request) => {
            let exit = sweep::run(&request, session)?;
            let SweepRequest { model, choice, masses, .. } = &*request;
            one_call::remark_unmatched(model.as_deref(), CompanionPaths::default(), choice, masses, session)?;
            Ok(exit)
        }
        Request::Inspect(request) => survey::inspect(&request, false, session),
        Request::Check(request) => survey::check(&request, session),
        Request::DropTest(request) => {
            let exit = answers::drop_test(&request, session)?;
            let DropTestRequest { subject, compare, choice, masses, set_files, .. } = &*request;
            let models = subject.iter().chain(compare).map(PathBuf::as_path);
            one_call::remark_unmatched(models, set_files.companion_paths(), choice, masses, session)?;
            Ok(exit)
        }
        Request::Motion(request) => answers::motion(&request, session),
        Request::Plot(request) => {
            let exit = plot::run(&request, session)?;
            let PlotRequest { models, choice, masses, set_files, .. } = &*request;
            let models = models.iter().map(PathBuf::as_path);
            one_call::remark_unmatched(models, set_files.companion_paths(), choice, masses, session)?;
            Ok(exit)
        }
        Request::Reproduce(request) => answers::reproduce(&request, session),
        Request::Presets(request) => answers::presets(&request, session),
        Request::Explain(request) => answers::explain(&request, session),
    }
}

/// The name of standard input.
const NAME_OF_STDIN: &str = "-";

/// Reads a request from a file or standard input. From now on messages name options as the caller does: as fields of requests, or as
/// arguments of the function that made the request.
///
/// # Errors
/// The file cannot be read, or has no valid request.
fn read_request(file: &Path, words: Language, session: &mut Session) -> Result<Request> {
    session.words = match words {
        Language::Json => &JsonRequest,
        Language::Matlab => &Matlab,
    };
    session.terminal.never_break_lines();
    if file.to_str().is_some_and(|text| text.starts_with('{')) {
        bail!("this is a request itself: put it into a file, or give it on standard input (-)");
    }
    let is_stdin = file == Path::new(NAME_OF_STDIN);
    let shown = if is_stdin { "standard input".into() } else { file.to_string_lossy().into_owned() };
    let bytes = Disk.read(file).with_context(|| shown.clone())?;
    let request = Request::from_json(&bytes).map_err(|fault| session.usage_error(&fault));
    // Who called a function knows of no file.
    let request = if words == Language::Matlab { request? } else { request.with_context(|| shown)? };
    if is_stdin && let Some(field) = request.option_that_reads(file) {
        bail!("`{field}` is standard input, where the request itself was: put the request into a file");
    }
    Ok(request)
}
