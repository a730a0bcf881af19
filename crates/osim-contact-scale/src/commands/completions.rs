//! `completions`: scripts that let a shell complete verbs and options.

mod fish;

use anyhow::Result;
use clap_complete::Shell;

use crate::args::{CompletionsArgs, plain_command};
use crate::terminal::Terminal;

/// Prints the script for the shell that `args` names.
///
/// # Errors
/// Standard output cannot be written.
pub(super) fn run(args: &CompletionsArgs, terminal: &mut Terminal) -> Result<()> {
    let mut command = plain_command();
    let name = command.get_name().to_owned();
    let mut script = Vec::new();
    clap_complete::generate(args.shell, &mut command, name.as_str(), &mut script);
    match args.shell {
        Shell::Bash => script = with_one_name(&String::from_utf8(script)?, &name).into_bytes(),
        Shell::Fish => script = fish::completed(&String::from_utf8(script)?, &command).into_bytes(),
        _ => {}
    }
    terminal.write_bytes(&script)?;
    Ok(())
}

/// clap_complete 4.6 spells a command with hyphens in two ways, so that bash completes nothing after a verb
/// (<https://github.com/clap-rs/clap/issues/6421>). Both become one; without the second this changes nothing.
fn with_one_name(script: &str, name: &str) -> String {
    script.replace(&name.replace('-', "__subcmd__"), &name.replace('-', "__"))
}
