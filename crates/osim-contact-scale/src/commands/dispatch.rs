//! Which verb is called.

use std::path::PathBuf;

use anyhow::Result;
use osim_model::files::CompanionPaths;
use osim_requests::{DropTestRequest, PlotRequest, Request, SweepRequest};

use crate::args::{Call, OwnVerb};
use crate::commands::{calculators, change, completions, lookups, motion, plot, survey, sweep};
use crate::exit::Exit;
use crate::session::{self, Session};

/// Runs the verb.
///
/// # Errors
/// Wrong usage, found before anything was written.
pub(crate) fn call(call: Call, session: &mut Session) -> Result<Exit> {
    match call {
        Call::WithoutVerb(Request::Rescale(request)) => change::rescale(*request, true, session),
        Call::WithoutVerb(request) | Call::Request(request) => ask(request, session),
        Call::Own(OwnVerb::Request(args)) => ask(lookups::read_request(&args, session)?, session),
        Call::Own(OwnVerb::Completions(args)) => completions::run(&args, session),
        Call::Own(OwnVerb::Man(args)) => completions::manual(&args, session),
        // Answered by clap.
        Call::Own(OwnVerb::Help(_) | OwnVerb::Version) => Ok(Exit::Done),
    }
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
