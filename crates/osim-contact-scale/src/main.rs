//! The command `osim-contact-scale`: arguments, files and reports around the library `osim-patch`.
//!
//! Exit status: 0 all done, 1 a model failed or needs an answer, 2 wrong usage.

mod args;
mod calculator;
mod change;
mod completions;
mod drop;
mod explain;
mod failure;
mod fitting;
mod load;
mod look;
mod manual;
mod measured;
mod paths;
mod place;
mod presets;
mod report;
mod sources;
mod terminal;
mod verbs;
#[allow(dead_code, reason = "the verbs that work on many models begin to use it next")]
mod workers;
mod write;

use std::process::ExitCode;

use anyhow::{Result, bail};
use clap::Parser;
use clap::error::ErrorKind;

use args::{Cli, Format, RescaleArgs, Verb};
use look::Look;
use terminal::{Exit, Terminal};
use verbs::{DesignVerb, RescaleVerb, SetVerb, TransferVerb};

fn main() -> ExitCode {
    let mut terminal = Terminal::default();
    let exit = match Cli::try_parse() {
        Ok(cli) => run(&cli, &mut terminal).unwrap_or_else(|error| {
            terminal.error(&format!("error: {error:#}\n"));
            Exit::Usage
        }),
        Err(error) => usage(&error, &mut terminal),
    };
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
fn run(cli: &Cli, terminal: &mut Terminal) -> Result<Exit> {
    match &cli.verb {
        None => rescale(&cli.rescale, true, terminal),
        Some(Verb::Rescale(args)) => rescale(args, false, terminal),
        Some(Verb::Transfer(args)) => match TransferVerb::new(args)? {
            Ok(planner) => change::run(&args.models, &args.parts, &args.output, &planner, terminal),
            Err(failure) => {
                if args.output.format == Format::Json {
                    terminal.print(&failure.json())?;
                }
                terminal.error(&failure.text());
                Ok(Exit::Failed)
            }
        },
        Some(Verb::Design(args)) if args.models.is_empty() => calculator::run(args, terminal),
        Some(Verb::Design(args)) => {
            let planner = DesignVerb::new(args)?;
            change::run(&args.models, &args.parts, &args.output, &planner, terminal)
        }
        Some(Verb::Set(args)) => {
            let planner = SetVerb::new(args)?;
            change::run(&planner.models, &args.parts, &args.output, &planner, terminal)
        }
        Some(Verb::DropTest(args)) => drop::run(args, terminal),
        Some(Verb::Fit(args)) => fitting::run(args, terminal),
        Some(Verb::Presets(args)) => presets::run(args, terminal).map(|()| Exit::Done),
        Some(Verb::Inspect(args)) => Look::new(args)?.run(terminal),
        Some(Verb::Explain(args)) => explain::run(args, terminal).map(|()| Exit::Done),
        Some(Verb::Completions(args)) => completions::run(args, terminal).map(|()| Exit::Done),
        Some(Verb::Man(args)) => manual::run(args, terminal),
    }
}

fn rescale(args: &RescaleArgs, may_look: bool, terminal: &mut Terminal) -> Result<Exit> {
    if args.models.is_empty() {
        bail!("no model given, expected one or more .osim files or folders (see --help)");
    }
    if let Some(word) = args.models.iter().find(|path| verbs::looks_like_verb(path)).filter(|_| may_look) {
        bail!("'{}' is neither a verb nor a file (see --help)", word.display());
    }
    if let Some(target) = args.target_mass {
        let planner = RescaleVerb::new(args, target)?;
        return change::run(&args.models, &args.parts, &args.output, &planner, terminal);
    }
    if !may_look || args.asks_for_change() {
        bail!(
            "the target is missing: say what the contacts shall stand for with --target-mass KG (see --help)"
        );
    }
    // A model alone, perhaps dropped on the program: show something useful.
    let look = Look {
        models: &args.models,
        parts: &args.parts,
        format: args.output.format,
        masses: args.masses.request()?,
        selection: args.choice.selection()?,
        hint: true,
        from: None,
        body_scale_file: None,
    };
    look.run(terminal)
}
