//! The command `osim-contact-scale`: words, terminal and exit status around the libraries.
//!
//! Exit status: 0 all done, 1 a model failed or needs an answer, 2 wrong usage, 130 stopped by Ctrl-C.

mod args;
mod commands;
mod failure;
mod interrupt;
mod progress;
mod report_page;
mod session;
mod terminal;
mod window;
mod words;

use std::process::ExitCode;

use clap::FromArgMatches;
use clap::error::ErrorKind;

use args::{Cli, check_typed, command, usage_line};
use session::Session;
use terminal::{Exit, Terminal};
use words::WORDS;

fn main() -> ExitCode {
    let mut session = Session { terminal: Terminal::default(), words: WORDS };
    let parsed = command()
        .try_get_matches()
        .and_then(|matches| Cli::from_arg_matches(&matches).map(|cli| (cli, check_typed(&matches))));
    let exit = match parsed {
        Ok((cli, typed)) => {
            let done = match typed {
                Ok(()) => commands::call(cli, &mut session),
                Err(fault) => Err(session.usage(&fault)),
            };
            done.unwrap_or_else(|error| {
                session.terminal.error(&format!("error: {error:#}\n"));
                Exit::Usage
            })
        }
        Err(error) => usage(&error, &mut session.terminal),
    };
    window::keep_open(&mut session.terminal);
    ExitCode::from(exit.code())
}

/// Help and version go to standard output; anything else is one line.
fn usage(error: &clap::Error, terminal: &mut Terminal) -> Exit {
    match error.kind() {
        ErrorKind::DisplayHelp
        | ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand
        | ErrorKind::DisplayVersion => {
            // Nobody is left to tell if this fails.
            let _ = error.print();
            if error.use_stderr() { Exit::Usage } else { Exit::Done }
        }
        _ => {
            terminal.error(&format!("error: {} (see --help)\n", usage_line(error)));
            Exit::Usage
        }
    }
}
