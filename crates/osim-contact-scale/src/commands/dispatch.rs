//! Which verb is called.

use std::path::PathBuf;

use anyhow::Result;
use osim_model::files::CompanionPaths;
use osim_requests::{DropTestRequest, PlotRequest, Request, SweepRequest};

use crate::args::{Cli, VerbArgs};
use crate::commands::{calculators, change, completions, lookups, motion, plot, survey, sweep};
use crate::exit::Exit;
use crate::session::{self, Session};

/// Runs the verb.
///
/// # Errors
/// Wrong usage, found before anything was written.
pub(crate) fn call(cli: Cli, session: &mut Session) -> Result<Exit> {
    let request: Request = match cli.verb {
        None => return change::rescale(cli.rescale, true, session),
        Some(VerbArgs::Set(args)) => args.0.request()?.into(),
        Some(VerbArgs::Request(args)) => lookups::read_request(&args.0, session)?,
        Some(VerbArgs::Completions(args)) => {
            return completions::run(&args.0, &mut session.terminal).map(|()| Exit::Done);
        }
        // Answered by clap.
        Some(VerbArgs::Help(_) | VerbArgs::Version) => return Ok(Exit::Done),
        Some(VerbArgs::Man(args)) => return completions::manual(&args.0, session),
        Some(VerbArgs::Rescale(request)) => Request::Rescale(request.0),
        Some(VerbArgs::Transfer(request)) => Request::Transfer(request.0),
        Some(VerbArgs::Add(request)) => Request::Add(request.0),
        Some(VerbArgs::Convert(request)) => Request::Convert(request.0),
        Some(VerbArgs::Remove(request)) => Request::Remove(request.0),
        Some(VerbArgs::Design(request)) => Request::Design(request.0),
        Some(VerbArgs::Note(request)) => Request::Note(request.0),
        Some(VerbArgs::Batch(request)) => Request::Batch(request.0),
        Some(VerbArgs::Sweep(request)) => Request::Sweep(request.0),
        Some(VerbArgs::Inspect(request)) => Request::Inspect(request.0),
        Some(VerbArgs::Check(request)) => Request::Check(request.0),
        Some(VerbArgs::DropTest(request)) => Request::DropTest(request.0),
        Some(VerbArgs::Motion(request)) => Request::Motion(request.0),
        Some(VerbArgs::Plot(request)) => Request::Plot(request.0),
        Some(VerbArgs::Fit(request)) => Request::Fit(request.0),
        Some(VerbArgs::Reproduce(request)) => (*request.0).into(),
        Some(VerbArgs::Presets(request)) => (*request.0).into(),
        Some(VerbArgs::Explain(request)) => (*request.0).into(),
    };
    ask(request, session)
}

fn ask(request: Request, session: &mut Session) -> Result<Exit> {
    match request {
        Request::Rescale(request) => change::rescale(*request, false, session),
        Request::Design(request) if request.models.is_empty() => calculators::design(&request, session),
        Request::Fit(request) if !request.is_of_motion() => calculators::fit(&request, session),
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
            if !request.quiet {
                let SweepRequest { model, choice, masses, .. } = &*request;
                session::remark_unmatched(
                    model.as_deref(),
                    CompanionPaths::default(),
                    choice,
                    masses,
                    session,
                )?;
            }
            Ok(exit)
        }
        Request::Inspect(request) => survey::inspect(&request, false, session),
        Request::Check(request) => survey::check(&request, session),
        Request::DropTest(request) => {
            let exit = calculators::drop_test(&request, session)?;
            let DropTestRequest { subject, compare, choice, masses, set_files, .. } = &*request;
            let models = subject.iter().chain(compare).map(PathBuf::as_path);
            session::remark_unmatched(models, set_files.companion_paths(), choice, masses, session)?;
            Ok(exit)
        }
        Request::Motion(request) => motion::run(&request, session),
        Request::Plot(request) => {
            let exit = plot::run(&request, session)?;
            let PlotRequest { models, choice, masses, set_files, .. } = &*request;
            let models = models.iter().map(PathBuf::as_path);
            session::remark_unmatched(models, set_files.companion_paths(), choice, masses, session)?;
            Ok(exit)
        }
        Request::Reproduce(request) => calculators::run(&request, session),
        Request::Presets(request) => lookups::presets(&request, session),
        Request::Explain(request) => lookups::explain(&request, session),
    }
}
