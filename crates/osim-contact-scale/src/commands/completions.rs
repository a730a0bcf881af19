//! `completions` prints scripts for shells; `man` prints or writes the manual pages.

use std::fmt::Write;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, anyhow, bail};
use clap::builder::{PossibleValue, PossibleValuesParser};
use clap::{Arg, Command};
use clap_complete::Shell;
use clap_mangen::Man;
use osim_library::report_page::Words;
use osim_library::{Disk, WriteMode, write_files};
use osim_model::Property;
use osim_view::report::explain::Topic;

use crate::args::whole_command;
use crate::exit::Exit;
use crate::session::Session;

/// Prints the script for a shell.
///
/// # Errors
/// Standard output cannot be written.
pub(crate) fn run(shell: Shell, session: &mut Session) -> Result<Exit> {
    let mut command = with_known_words(whole_command(), shell);
    let name = command.get_name().to_owned();
    let mut script = Vec::new();
    clap_complete::generate(shell, &mut command, name.as_str(), &mut script);
    match shell {
        Shell::Bash => script = with_files(&with_one_name(&String::from_utf8(script)?, &name)).into_bytes(),
        Shell::Fish => script = with_missing_completions(&String::from_utf8(script)?, &command).into_bytes(),
        _ => {}
    }
    session.terminal.write_bytes(&script)?;
    Ok(Exit::Done)
}

/// The command with the words that arguments without a name may have: presets, topics of `explain`, and properties for `set`.
fn with_known_words(command: Command, shell: Shell) -> Command {
    let names = osim_planning::all_preset_names(None, &Disk);
    let topics: Vec<&str> = Topic::all().into_iter().map(Topic::name).collect();
    let properties: Vec<String> =
        Property::ALL.iter().map(|property| format!("{}=", property.name())).collect();
    let values = |argument: Arg, words: Vec<String>| argument.value_parser(PossibleValuesParser::new(words));
    let command = command
        .mut_subcommand("presets", |verb| verb.mut_arg("name", |name| values(name, names)))
        .mut_subcommand("explain", |verb| {
            let topics = topics.into_iter().map(str::to_owned).collect();
            verb.mut_arg("topics", |topic| values(topic, topics))
        });
    // The other shells would complete no files there.
    if shell != Shell::Bash {
        return command;
    }
    command.mut_subcommand("set", |verb| verb.mut_arg("items", |items| values(items, properties)))
}

/// The script for bash with files after a verb, where clap_complete 4.6 lists options (which begin with -), and with presets after `--from`.
fn with_files(script: &str) -> String {
    let (mut completed, mut words, mut before) = (String::new(), String::new(), "");
    let presets = osim_planning::all_preset_names(None, &Disk).join(" ");
    for line in script.split_inclusive('\n') {
        if let Some(all) = line.trim_ascii().strip_prefix("opts=\"") {
            let is_value = |word: &&str| !word.starts_with('-') && !all.contains("--version");
            let values: Vec<&str> = all.trim_end_matches('"').split(' ').filter(is_value).collect();
            words = values.join(" ");
            if words.contains('=') {
                // Models come first.
                words = format!("${{cur:+{words}}}");
            }
        }
        completed.push_str(&match before {
            "esac" => line.replace("${opts}", &words),
            "--from)" => line.replace("\"))", &format!("\") $(compgen -W \"{presets}\" -- \"${{cur}}\"))")),
            _ => line.replace(" || ${COMP_CWORD} -eq 2 ]]", " ]]"),
        });
        before = line.trim_ascii();
    }
    completed
}

/// clap_complete 4.6 spells a command with hyphens in two ways, so that bash completes nothing after a verb
/// (<https://github.com/clap-rs/clap/issues/6421>). Both become one; without the second this changes nothing.
fn with_one_name(script: &str, name: &str) -> String {
    script.replace(&name.replace('-', "__subcmd__"), &name.replace('-', "__"))
}

// What clap_complete 4.6 leaves out for fish: options after a model where no verb is typed, and values of arguments without a name,
// such as the kind of a figure.

/// The fish script with completions that clap_complete leaves out: options after a model, and values of arguments without a name.
fn with_missing_completions(script: &str, command: &Command) -> String {
    let functions = format!("__fish_{}", command.get_name().replace('-', "_"));
    let (needs_verb, without_verb) =
        (format!("{functions}_needs_command"), format!("{functions}_without_verb"));
    let verbs: Vec<&str> = command.get_subcommands().map(Command::get_name).collect();
    let mut completed = String::new();
    for line in script.split_inclusive('\n') {
        let is_option = line.contains(" -l ") && line.starts_with("complete ");
        let condition = |name: &str| format!(" -n \"{name}\"");
        completed.push_str(&match is_option {
            true => line.replacen(&condition(&needs_verb), &condition(&without_verb), 1),
            false => line.to_owned(),
        });
    }
    let name = command.get_name();
    // Writing to a text cannot fail.
    let _ = writeln!(
        completed,
        "\n# Options of a call without a verb come after its models, too.\n\
         function {without_verb}\n    set -l word ({needs_verb})\n    or not contains -- \"$word\" {}\nend\n",
        verbs.join(" ")
    );
    for verb in command.get_subcommands() {
        let files = if takes_files(verb) { "" } else { " -f" };
        for values in verb.get_positionals().map(possible_values).filter(|values| !values.is_empty()) {
            let _ = writeln!(
                completed,
                "complete -c {name} -n \"{functions}_using_subcommand {}\"{files} -a \"{}\"",
                verb.get_name(),
                values.iter().map(fish_completion).collect::<Vec<_>>().join("\n")
            );
        }
    }
    completed
}

/// Whether the verb has an argument without a name that may be a file, not only one of a few words.
fn takes_files(verb: &Command) -> bool {
    verb.get_positionals().any(|argument| possible_values(argument).is_empty())
}

fn possible_values(argument: &Arg) -> Vec<PossibleValue> {
    argument.get_value_parser().possible_values().into_iter().flatten().collect()
}

/// A value and its description, as fish reads them between double quotation marks.
fn fish_completion(value: &PossibleValue) -> String {
    let help = value.get_help().map(ToString::to_string).unwrap_or_default();
    let help = help.replace('\\', "\\\\").replace('\'', "\\'").replace(['"', '$', '\n'], " ");
    format!("{}\\t'{help}'", value.get_name())
}

// `man`: the manual pages, one for the command and one for each verb.

const PROGRAM_NAME: &str = env!("CARGO_PKG_NAME");

/// Writes all manual pages into a folder.
pub(crate) fn manuals(folder: &Path, force: bool, session: &mut Session) -> Exit {
    let mode = if force { WriteMode::Replace } else { WriteMode::New };
    match write(&manual_pages(), folder, mode, session.words) {
        Ok(()) => Exit::Done,
        Err(error) => {
            session.terminal.error_line(&format!("{error:#}"));
            Exit::Failed
        }
    }
}

/// Prints the manual page of a verb, or of the command.
///
/// # Errors
/// An unknown verb.
pub(crate) fn manual(verb: Option<&str>, session: &mut Session) -> Result<Exit> {
    let pages = manual_pages();
    let page = match verb {
        None => pages.last(),
        Some(verb) => pages.iter().find(|page| page.get_filename() == format!("{PROGRAM_NAME}-{verb}.1")),
    };
    let Some(page) = page else {
        bail!("there is no such page");
    };
    session.terminal.write_bytes(&page_bytes(page)?)?;
    Ok(Exit::Done)
}

/// All manual pages: one for each verb, then the page of the command.
fn manual_pages() -> Vec<Man> {
    // A page has room for what the short help leaves out; clap_mangen would leave it out too.
    let in_full = |command: Command| command.mut_args(|argument| argument.hide_short_help(false));
    let mut command = whole_command();
    // Gives verbs their full names, and their options.
    command.build();
    let command = in_full(command).mut_subcommands(in_full);
    let verbs: Vec<Man> = command.get_subcommands().cloned().map(Man::new).collect();
    verbs.into_iter().chain([Man::new(command)]).map(with_title_of_manual).collect()
}

fn with_title_of_manual(page: Man) -> Man {
    page.manual("OpenSim contacts").source(concat!("osim-contact-scale ", env!("CARGO_PKG_VERSION")))
}

fn page_bytes(page: &Man) -> Result<Vec<u8>> {
    let mut bytes = Vec::new();
    page.render(&mut bytes)?;
    Ok(bytes)
}

/// Writes all manual pages. If a file exists and may not be replaced, writes none.
fn write(pages: &[Man], folder: &Path, mode: WriteMode, words: Words) -> Result<()> {
    std::fs::create_dir_all(folder).map_err(|error| anyhow!(error)).context(folder.display().to_string())?;
    let file = |page: &Man| Ok((folder.join(page.get_filename()), page_bytes(page)?));
    let files: Vec<(PathBuf, Vec<u8>)> = pages.iter().map(file).collect::<Result<_>>()?;
    write_files(files.iter().map(|(path, bytes)| (path.as_path(), bytes.as_slice())), mode)
        .map_err(|fault| anyhow!(fault.spelled(words)))
}
