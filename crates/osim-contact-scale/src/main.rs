//! The command `osim-contact-scale`: arguments, files and reports around the library `osim-patch`.
//!
//! Exit status: 0 all done, 1 a model failed or needs an answer, 2 wrong usage.

mod args;
mod batch;
mod calculator;
mod check;
mod completions;
mod digest;
mod drop;
mod explain;
mod failure;
mod fitting;
mod folders;
mod load;
mod look;
mod manual;
mod measured;
mod page;
mod paths;
mod place;
mod plotting;
mod presets;
mod report;
mod run;
mod sources;
mod spreadsheet;
mod sweep;
mod temporary;
mod terminal;
mod verbs;
mod weighed;
mod window;
mod workers;
mod write;

use std::process::ExitCode;

use anyhow::{Result, bail};
use clap::Parser;
use clap::error::ErrorKind;

use args::{Cli, Format, ReportArgs, RescaleArgs, RunArgs, Verb, ViewArgs};
use look::{Look, View};
use run::tasks_of;
use terminal::{Exit, Terminal};

fn main() -> ExitCode {
    let mut terminal = Terminal::default();
    let exit = match Cli::try_parse() {
        Ok(cli) => run(cli, &mut terminal).unwrap_or_else(|error| {
            terminal.error(&format!("error: {error:#}\n"));
            Exit::Usage
        }),
        Err(error) => usage(&error, &mut terminal),
    };
    window::keep_open(&mut terminal);
    ExitCode::from(exit.code())
}

/// Help and version go to standard output; anything else is one line.
fn usage(error: &clap::Error, terminal: &mut Terminal) -> Exit {
    match error.kind() {
        ErrorKind::DisplayHelp | ErrorKind::DisplayVersion => {
            // Nobody is left to tell if this fails.
            let _ = error.print();
            Exit::Done
        }
        ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand => {
            let _ = error.print();
            Exit::Usage
        }
        _ => {
            terminal.error(&format!("error: {} (see --help)\n", args::usage_line(error)));
            Exit::Usage
        }
    }
}

/// Runs the verb; an `Err` is wrong usage, found before anything was written.
fn run(cli: Cli, terminal: &mut Terminal) -> Result<Exit> {
    match cli.verb {
        None => rescale(cli.rescale, true, terminal),
        Some(Verb::Rescale(args)) => rescale(*args, false, terminal),
        Some(Verb::Transfer(args)) => {
            let run = args.run.clone();
            match verbs::transfer::verb(*args)? {
                Ok(verb) => change(verb, &run, terminal),
                Err(failure) => {
                    if run.is_json() {
                        terminal.print(&failure.json())?;
                    }
                    terminal.error(&failure.text());
                    Ok(Exit::Failed)
                }
            }
        }
        Some(Verb::Design(args)) if args.models.is_empty() => calculator::run(&args, terminal),
        Some(Verb::Design(args)) => {
            let run = args.run.clone();
            change(verbs::design::verb(*args)?, &run, terminal)
        }
        Some(Verb::Set(args)) => {
            let run = args.run.clone();
            change(verbs::set::verb(*args)?, &run, terminal)
        }
        Some(Verb::Batch(args)) => batch::batch(&args, terminal),
        Some(Verb::Sweep(args)) => sweep::sweep(&args, terminal),
        Some(Verb::DropTest(args)) => drop::run(&args, terminal),
        Some(Verb::Plot(args)) => plotting::run(&args, terminal),
        Some(Verb::Fit(args)) => fitting::run(&args, terminal),
        Some(Verb::Presets(args)) => presets::run(&args, terminal).map(|()| Exit::Done),
        Some(Verb::Inspect(args)) => Look::new(&args)?.run(terminal),
        Some(Verb::Check(args)) => check::run(&args, terminal),
        Some(Verb::Explain(args)) => explain::run(&args, terminal).map(|()| Exit::Done),
        Some(Verb::Completions(args)) => completions::run(&args, terminal).map(|()| Exit::Done),
        Some(Verb::Man(args)) => manual::run(&args, terminal),
    }
}

/// A changing verb over its models.
fn change(verb: run::Verb, args: &RunArgs, terminal: &mut Terminal) -> Result<Exit> {
    run::run(tasks_of(verb, args)?, args, terminal)
}

fn rescale(args: RescaleArgs, may_look: bool, terminal: &mut Terminal) -> Result<Exit> {
    if args.models.is_empty() {
        bail!("no model given, expected one or more .osim files or folders (see --help)");
    }
    if let Some(word) = args.models.iter().find(|path| verbs::looks_like_verb(path)).filter(|_| may_look) {
        bail!("'{}' is neither a verb nor a file (see --help)", word.display());
    }
    if args.target_mass.is_some() || !may_look || args.asks_for_change() {
        let run = args.run.clone();
        return change(verbs::rescale::verb(args)?, &run, terminal);
    }
    // A model alone, perhaps dropped on the program: show something useful.
    let view = ViewArgs {
        masses: args.masses.clone(),
        choice: args.choice.clone(),
        parts: args.parts.clone(),
        ..ViewArgs::default()
    };
    let look = Look {
        verb: "inspect",
        models: &args.models,
        view: View::new(&view)?,
        args: view,
        format: if args.run.is_json() { Format::Json.into() } else { Format::Table.into() },
        report: ReportArgs { report: args.run.report.clone(), force: args.output.force },
        hint: true,
        from: None,
        body_scale_file: None,
    };
    look.run(terminal)
}
