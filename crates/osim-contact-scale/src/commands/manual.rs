//! `man`: the manual pages, one for the command and one for each verb.

use std::path::Path;

use anyhow::{Context, Result, anyhow, bail};
use clap::Command;
use clap_mangen::Man;
use osim_library::{Mode, Prepared};

use crate::args::{ManArgs, plain_command};
use crate::exit::Exit;
use crate::session::Session;
use crate::words::Words;

const NAME: &str = env!("CARGO_PKG_NAME");

/// Prints one page, or writes all of them.
///
/// # Errors
/// An unknown verb.
pub(super) fn run(args: &ManArgs, session: &mut Session) -> Result<Exit> {
    let pages = pages();
    if let Some(folder) = &args.output_dir {
        let mode = if args.force { Mode::Replace } else { Mode::New };
        return Ok(match write(&pages, folder, mode, session.words) {
            Ok(()) => Exit::Done,
            Err(error) => {
                session.terminal.error_line(&format!("{error:#}"));
                Exit::Failed
            }
        });
    }
    let page = match &args.verb {
        None => pages.last(),
        Some(verb) => pages.iter().find(|page| page.get_filename() == format!("{NAME}-{verb}.1")),
    };
    let Some(page) = page else {
        bail!("there is no such page");
    };
    session.terminal.write_bytes(&rendered(page)?)?;
    Ok(Exit::Done)
}

/// One page for each verb, then that of the command.
fn pages() -> Vec<Man> {
    // A page has room for what the short help leaves out; clap_mangen would leave it out too.
    let in_full = |command: Command| command.mut_args(|argument| argument.hide_short_help(false));
    let mut command = plain_command();
    // Gives verbs their full names, and their options.
    command.build();
    let command = in_full(command).mut_subcommands(in_full);
    let verbs: Vec<Man> = command.get_subcommands().cloned().map(Man::new).collect();
    verbs.into_iter().chain([Man::new(command)]).map(titled).collect()
}

fn titled(page: Man) -> Man {
    page.manual("OpenSim contacts").source(concat!("osim-contact-scale ", env!("CARGO_PKG_VERSION")))
}

fn rendered(page: &Man) -> Result<Vec<u8>> {
    let mut bytes = Vec::new();
    page.render(&mut bytes)?;
    Ok(bytes)
}

/// All pages, or none.
fn write(pages: &[Man], folder: &Path, mode: Mode, words: Words) -> Result<()> {
    let refused = |fault: osim_library::LibraryFault| anyhow!(fault.spelled(words));
    std::fs::create_dir_all(folder).map_err(|error| anyhow!(error)).context(folder.display().to_string())?;
    let mut prepared = Vec::new();
    for page in pages {
        let path = folder.join(page.get_filename());
        prepared.push(Prepared::new(&path, &rendered(page)?, None, mode).map_err(refused)?);
    }
    prepared.into_iter().try_for_each(Prepared::commit).map_err(refused)
}
