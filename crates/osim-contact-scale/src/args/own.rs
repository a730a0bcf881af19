//! Arguments of the command alone.

use std::ffi::OsString;
use std::path::{Path, PathBuf};

use anyhow::{Result, anyhow, bail};
use clap::Args;
use osim_requests::{SetRequest, assignment};

use crate::args::help;
use crate::session::Language;

/// Models and assignments in one list of words.
#[derive(Debug, Args)]
pub(crate) struct SetArgs {
    /// Models, and what to set: PROPERTY=VALUE or PROPERTY=xFACTOR
    #[arg(value_name = "MODEL|PROPERTY=VALUE|PROPERTY=xFACTOR", required = true)]
    pub items: Vec<OsString>,
    #[command(flatten)]
    pub request: SetRequest,
}

impl SetArgs {
    /// The request, with the words sorted.
    ///
    /// # Errors
    /// No model, nothing to set, an unknown property or a value that is not a number.
    pub(crate) fn request(self) -> Result<SetRequest> {
        let Self { items, mut request } = self;
        for item in items {
            // A name that is not UTF-8 is no assignment.
            match item.to_str().and_then(|item| item.split_once('=')) {
                Some((name, value)) if !Path::new(&item).exists() => {
                    let new = assignment(name, value).map_err(|why| anyhow!(why))?;
                    request.set.add(new).map_err(|why| anyhow!(why))?;
                }
                _ => request.models.push(PathBuf::from(item)),
            }
        }
        if request.models.is_empty() {
            bail!("no model given, expected one or more .osim files or folders (see set --help)");
        }
        Ok(request)
    }
}

/// Runs one request: the same verbs and options as on the command line, by their names with underscores.
///
/// For programs that would have to quote file names for a shell: {"verb": "rescale", "models": ["my model.osim"],
/// "target_mass": 70}. `schemas/requests` has the schema of each verb's requests.
#[derive(Debug, Args)]
pub(crate) struct RequestArgs {
    /// A JSON object; - is standard input
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// Whose names messages have for options: those of requests, or of the functions for MATLAB and GNU Octave
    #[arg(long, value_name = "LANGUAGE", default_value = "json")]
    pub words: Language,
}

/// Prints a script for the shell that completes verbs, options and file names.
#[derive(Debug, Args)]
#[command(after_help = "\
Where to put it (NAME is osim-contact-scale):
  bash        NAME completions bash > ~/.local/share/bash-completion/completions/NAME
              (the folder must be there: mkdir -p; needs the package bash-completion)
  zsh         NAME completions zsh > FOLDER/_NAME, with FOLDER a folder of $fpath
  fish        NAME completions fish > ~/.config/fish/completions/NAME.fish
  PowerShell  add this line to the file that $PROFILE names:
              NAME completions powershell | Out-String | Invoke-Expression
  elvish      NAME completions elvish > ~/.config/elvish/lib/NAME.elv,
              and the line 'use NAME' in ~/.config/elvish/rc.elv
Then open a new terminal.")]
pub(crate) struct CompletionsArgs {
    /// The shell
    pub shell: clap_complete::Shell,
}

/// Prints the help of the program, or of one verb.
#[derive(Debug, Args)]
pub(crate) struct HelpArgs {
    /// The verb [default: the help of the program]
    #[arg(value_parser = help::names(), hide_possible_values = true)]
    pub verb: Option<String>,
}

/// Prints the manual page of the command or of one verb, or writes all pages into a folder.
#[derive(Debug, Args)]
#[command(after_help = "\
On macOS and Linux (NAME is osim-contact-scale):
  to read one   NAME man transfer > page.1; man ./page.1
  to keep all   NAME man -d ~/.local/share/man/man1, then: man NAME-transfer")]
pub(crate) struct ManArgs {
    /// The verb [default: the page of the command]
    #[arg(value_parser = help::names(), hide_possible_values = true)]
    pub verb: Option<String>,
    /// Write all pages into this folder
    #[arg(short = 'd', long, value_name = "DIR", conflicts_with = "verb")]
    pub output_dir: Option<PathBuf>,
    /// Replace existing files
    #[arg(long, requires = "output_dir")]
    pub force: bool,
}
