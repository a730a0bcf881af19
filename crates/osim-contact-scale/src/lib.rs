//! The command `osim-contact-scale`: its arguments, its output on the terminal and its exit status.
//!
//! [`osim_view::report::ExitStatus`] has the meanings of the exit status.
#![cfg_attr(not(test), deny(clippy::disallowed_methods))]

mod args;
mod commands;
mod exit;
mod one_call;
mod suggestions;
mod terminal;

use std::path::PathBuf;
use std::process::ExitCode;
use std::time::SystemTime;

use clap::error::ErrorKind;
use osim_model::messages::Verb;
use osim_requests::{PlotKind, RequestFault};

use crate::args::{
    Call, bare_command, command, is_quiet, message_about_dashes, typed_call, usage_line, verb_names,
};
use crate::exit::{Exit, exit_of, text_of};
use crate::one_call::{COMMAND_LINE_WORDS, Session};
use crate::suggestions::{suggest, suggested_axis, suggested_figure, suggested_list, suggested_plates};
use crate::terminal::{Terminal, without_closed_pipe};

/// Runs the command with the arguments of the command line.
pub fn main() -> ExitCode {
    exit::outlive_size_limit();
    let mut session =
        Session { terminal: Terminal::new(), words: COMMAND_LINE_WORDS, start: SystemTime::now() };
    let exit = match call_of_arguments(session.terminal.columns()) {
        Ok((call, is_quiet)) => {
            if is_quiet {
                session.terminal.keep_quiet();
            }
            let done = match call {
                Ok(call) => commands::call(call, &mut session),
                Err(fault) => Err(session.usage_error(&fault)),
            };
            done.unwrap_or_else(|error| {
                let text = text_of(&error);
                if !text.is_empty() {
                    session.terminal.error_line(&text);
                }
                exit_of(&error)
            })
        }
        Err(error) => print_clap_error(&error, &mut session.terminal),
    };
    terminal::keep_open(&mut session.terminal);
    ExitCode::from(exit.code())
}

/// The call that the arguments of the command line make, and whether only errors are printed. The inner error is about options that do
/// not go together; the outer error is clap's, which also returns its help and version as errors.
fn call_of_arguments(columns: Option<usize>) -> Result<(Result<Call, RequestFault>, bool), clap::Error> {
    let mut words = std::env::args_os().skip(1).peekable();
    let first = words.peek().cloned();
    let typed: Vec<String> = std::env::args_os().skip(1).filter_map(|word| word.into_string().ok()).collect();
    let dashes = typed.iter().take_while(|word| *word != "--").find_map(|word| message_about_dashes(word));
    if let Some(text) = dashes.or_else(|| suggested_list(&typed)) {
        return Ok((Err(RequestFault::general(text)), false));
    }
    // To put the help together takes longer than to read the words, so it is done where something is to be shown. If `-h` is only the
    // value of an option, that costs time but changes no output.
    let asks_for_help = first.is_none() || words.any(|word| word == "-h" || word == "--help");
    let first = first.as_deref().and_then(|word| word.to_str());
    let bare = (!asks_for_help).then(|| bare_command(first).try_get_matches());
    let matches = match bare {
        Some(Ok(matches)) => matches,
        Some(Err(version)) if version.kind() == ErrorKind::DisplayVersion => return Err(version),
        _ => command(columns, first).try_get_matches()?,
    };
    let call = typed_call(&matches)?;
    if let Ok(Call::Own(own)) = &call
        && let Some(words) = own.as_call_that_clap_answers()
    {
        command(columns, words.get(1).copied()).try_get_matches_from(&words)?;
    }
    Ok((call, is_quiet(&matches)))
}

/// A suggestion for a call whose arguments beside the options caused an unknown argument.
fn suggestion_for_call() -> Option<String> {
    let words: Vec<PathBuf> = std::env::args_os().skip(1).map(PathBuf::from).collect();
    let is_option = |word: &PathBuf| word.as_os_str().as_encoded_bytes().starts_with(b"-");
    let is_verb = |word: &PathBuf| verb_names().any(|name| word.as_os_str() == name);
    let after_verb = usize::from(words.first().is_some_and(is_verb));
    // These verbs take no models.
    let takes_verb = |word: &PathBuf| word.as_os_str() == "help" || word.as_os_str() == "man";
    if words.first().is_some_and(takes_verb) {
        return None;
    }
    // The kind of a figure is no file, although one has the name of a verb.
    let is_plot = words.first().is_some_and(|word| word.as_os_str() == Verb::Plot.name());
    let is_kind = |word: &PathBuf| word.to_str().is_some_and(|word| word.parse::<PlotKind>().is_ok());
    let after_kind = after_verb + usize::from(is_plot && words.get(1).is_some_and(is_kind));
    let words = words.get(after_kind..)?;
    let plain = words.iter().position(is_option).unwrap_or(words.len());
    suggest(words.get(..plain)?, false, COMMAND_LINE_WORDS)
        .filter(|_| plain > 0 && (after_verb == 0 || plain > 1))
}

/// Prints help and version on standard output; prints all other errors of clap as one line on standard error.
fn print_clap_error(error: &clap::Error, terminal: &mut Terminal) -> Exit {
    match error.kind() {
        ErrorKind::DisplayHelp
        | ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand
        | ErrorKind::DisplayVersion => {
            // A reader that has seen enough is no failure.
            match without_closed_pipe(error.print()).map_err(anyhow::Error::from) {
                Ok(()) if !error.use_stderr() => Exit::Done,
                Ok(()) => Exit::Usage,
                Err(why) => {
                    terminal.error_line(&text_of(&why));
                    exit_of(&why)
                }
            }
        }
        kind => {
            let words: Vec<String> =
                std::env::args_os().skip(1).map(|word| word.to_string_lossy().into_owned()).collect();
            let of_words = || (kind == ErrorKind::UnknownArgument).then(suggestion_for_call).flatten();
            let of_verb = [suggested_axis, suggested_figure, suggested_plates];
            let meant = of_verb.iter().find_map(|suggested| suggested(&words, COMMAND_LINE_WORDS));
            let text = meant.or_else(of_words).unwrap_or_else(|| usage_line(error, &words));
            terminal.error_line(&format!("{text} (see --help)"));
            Exit::Usage
        }
    }
}
