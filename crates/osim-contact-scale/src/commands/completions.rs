//! `completions` prints scripts for shells; `man` prints or writes the manual pages.

use std::fmt::Write;
use std::path::{Path, PathBuf};

use anyhow::{Result, bail};
use clap::builder::{PossibleValue, PossibleValuesParser};
use clap::{Arg, Command};
use clap_complete::Shell;
use clap_mangen::Man;
use osim_library::Disk;
use osim_model::{Property, YesQuestion};
use osim_view::report::explain::Topic;

use crate::args::{PROGRAM_NAME, whole_command};
use crate::commands::answers::write_into_folder;
use crate::exit::Exit;
use crate::one_call::Session;

/// Prints the script for a shell.
///
/// # Errors
/// Standard output cannot be written.
pub(crate) fn run(shell: Shell, session: &mut Session) -> Result<Exit> {
    let mut command = with_known_words(whole_command(), shell);
    let name = command.get_name().to_owned();
    let mut script = Vec::new();
    clap_complete::generate(shell, &mut command, name.as_str(), &mut script);
    let (script, one_name) = (String::from_utf8(script)?, |joint| name.replace('-', joint));
    let script = match shell {
        // clap_complete 4.6 spells a command with hyphens in two ways, so that bash completes nothing after a verb
        // (<https://github.com/clap-rs/clap/issues/6421>). Both become one; without the second this changes nothing.
        Shell::Bash => with_files(&script.replace(&one_name("__subcmd__"), &one_name("__"))),
        Shell::Zsh => with_models(&script),
        Shell::Fish => with_missing_completions(&script, &command),
        _ => script,
    };
    session.terminal.write_bytes(script.as_bytes())?;
    Ok(Exit::Done)
}

/// The command with the words that its arguments may have: presets, topics of `explain`, properties, and codes of questions.
fn with_known_words(command: Command, shell: Shell) -> Command {
    let topics = Topic::all().into_iter().map(Topic::name);
    let properties = |end: &str| Property::changeable().map(|one| format!("{}{end}", one.as_str())).collect();
    let with_words = |argument: Arg| {
        let words: Vec<String> = match argument.get_id().as_str() {
            "name" => osim_planning::all_preset_names(None, &Disk),
            // Shells read a name with blanks as several words.
            "topics" => topics.clone().filter(|name| !name.contains(' ')).map(str::to_owned).collect(),
            "only" | "keep" => properties(""),
            "yes" => YesQuestion::ALL.iter().map(|question| question.as_str().to_owned()).collect(),
            "grid" => properties("="),
            // The other shells would complete no files there.
            "items" if shell == Shell::Bash => properties("="),
            _ => return argument,
        };
        argument.value_parser(PossibleValuesParser::new(words))
    };
    command.mut_args(with_words).mut_subcommands(|verb| verb.mut_args(with_words))
}

/// The script for bash with files after a verb, where clap_complete 4.6 lists options (which begin with -), with presets beside files, and
/// with bash's own completion of files, which knows folders and blanks.
fn with_files(script: &str) -> String {
    let (mut completed, mut words, mut before) = (String::new(), String::new(), "");
    let files = "$(compgen -f \"${cur}\")";
    let presets = format!("$(compgen -W \"${{cur:+{}}}\" -- \"${{cur}}\")", presets());
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
            "--from)" | "--compare)" => line.replace(files, &presets),
            _ => line.replace(" || ${COMP_CWORD} -eq 2 ]]", " ]]").replace(files, ""),
        });
        before = line.trim_ascii();
    }
    completed
}

/// The script for zsh with files, and options after files: clap_complete 4.6 counts the models of a call without a verb as a word before the
/// verb, and ends options at the first model. Also with presets beside files.
fn with_models(script: &str) -> String {
    let (name, presets) = ("_osim-contact-scale", presets());
    let functions = format!(
        "autoload -U is-at-least\n\n\
         {name}_presets() {{ _alternative 'files:file:_files' 'presets:preset:({presets})' }}\n\
         {name}_verbs() {{ _alternative 'verbs:verb:{name}_commands' 'files:model:_files' }}\n"
    );
    let rest = format!(
        " state line\n    local -a rest=(\":: :{name}_verbs\" \"*::: :->osim-contact-scale\")\n    \
         (( CURRENT < 3 || $+functions[{name}__subcmd__${{words[2]}}_commands] )) || rest=(\"*:model:_files\")\n"
    );
    let is_kept = |line: &&str| !line.starts_with("'::models -- ") && !line.starts_with("\"*::: ");
    let script: String = script.split_inclusive('\n').filter(is_kept).collect();
    let script = script.replacen("autoload -U is-at-least\n", &functions, 1).replace(" state line\n", &rest);
    let script = script.replace("line[2]", "line[1]").replace("'*::", "'*:");
    let script = script.replace(&format!("\":: :{name}_commands\""), "\"${rest[@]}\"");
    // The placeholders of `--from` and `--compare`.
    let files = |script: &str, of| script.replace(&format!("{of}:_files'"), &format!("{of}:{name}_presets'"));
    files(&files(&script, "PRESET"), "OTHER")
}

/// The names of the presets, as words of a script.
fn presets() -> String {
    osim_planning::all_preset_names(None, &Disk).join(" ")
}

// What clap_complete 4.6 leaves out for fish: options after a model where no verb is typed, and values of arguments without a name,
// such as the kind of a figure.

/// The fish script with completions that clap_complete leaves out: options after a model, and values of arguments without a name.
fn with_missing_completions(script: &str, command: &Command) -> String {
    let functions = format!("__fish_{}", command.get_name().replace('-', "_"));
    let (needs_verb, without_verb) =
        (format!("{functions}_needs_command"), format!("{functions}_without_verb"));
    let verbs: Vec<&str> = command.get_subcommands().map(Command::get_name).collect();
    let (mut completed, with_presets) = (String::new(), format!("-r -F -a \"{}\"", presets()));
    for line in script.split_inclusive('\n') {
        let condition = |name: &str| format!(" -n \"{name}\"");
        let line = match line.starts_with("complete ") && line.contains(" -l ") {
            true => line.replacen(&condition(&needs_verb), &condition(&without_verb), 1),
            false => line.to_owned(),
        };
        let has_presets = line.contains("preset");
        completed.push_str(&if has_presets { line.replace("-r -F", &with_presets) } else { line });
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
        // A verb may have an argument that is a file, and not only one of a few words.
        let may_be_file = |argument: &Arg| possible_values(argument).is_empty();
        let files = if verb.get_positionals().any(may_be_file) { "" } else { " -f" };
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

/// Writes all manual pages into a folder.
pub(crate) fn manuals(folder: &Path, force: bool, session: &Session) -> Result<Exit> {
    let file = |page: &Man| Ok((folder.join(page.get_filename()), page_bytes(page)?));
    let files: Vec<(PathBuf, Vec<u8>)> = manual_pages().iter().map(file).collect::<Result<_>>()?;
    write_into_folder(&files, force, session)?;
    Ok(Exit::Done)
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
    let source = concat!("osim-contact-scale ", env!("CARGO_PKG_VERSION"));
    let pages = verbs.into_iter().chain([Man::new(command)]);
    pages.map(|page| page.manual("OpenSim contacts").source(source)).collect()
}

fn page_bytes(page: &Man) -> Result<Vec<u8>> {
    let mut bytes = Vec::new();
    page.render(&mut bytes)?;
    Ok(bytes)
}
