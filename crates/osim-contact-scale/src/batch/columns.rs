//! What the columns of a manifest are: options of the changing verbs, by their long names.

use std::any::TypeId;
use std::collections::HashMap;
use std::path::PathBuf;

use anyhow::{Result, bail};
use clap::ArgAction;

/// Verbs that a row may be about.
pub(super) const VERBS: [&str; 4] = ["rescale", "transfer", "design", "set"];
/// Options of the whole run: a row cannot have its own.
const OF_THE_RUN: [&str; 9] =
    ["dry-run", "diff", "format", "quiet", "jobs", "summary", "resume", "shard", "report"];

/// How a cell becomes the words of a command line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    /// The model itself.
    Model,
    /// The verb, where the row's options do not tell.
    Verb,
    /// Assignments of `set`.
    Set,
    /// An option with one value.
    Value,
    /// An option with one path.
    Path,
    /// A model or the name of a preset.
    From,
    /// An option that may be repeated.
    List,
    /// yes or no.
    Flag,
    /// A remark of the user.
    Remark,
}

/// One column.
#[derive(Debug)]
pub(super) struct Column {
    /// As in the header.
    pub header: String,
    /// Long name of the option.
    pub option: String,
    pub kind: Kind,
}

/// All columns of a manifest, in its order.
#[derive(Debug)]
pub(super) struct Columns {
    pub columns: Vec<Column>,
    /// Header of the column that names the model.
    pub model: String,
}

impl Columns {
    /// # Errors
    /// No column `model`, one that is there twice, or one that is no option of a changing verb.
    pub(super) fn of(header: &[String], command: &clap::Command) -> Result<Self> {
        let known = options(command);
        let mut columns: Vec<Column> = Vec::new();
        for cell in header {
            let column = column(cell, &known)?;
            let twice = |other: &Column| (&other.option, other.kind) == (&column.option, column.kind);
            if column.kind != Kind::Remark && columns.iter().any(twice) {
                bail!("the column '{cell}' is there twice, expected one");
            }
            columns.push(column);
        }
        let Some(model) = columns.iter().find(|column| column.kind == Kind::Model) else {
            bail!("no column 'model' in the first row, which has {}", listed(header));
        };
        let model = model.header.clone();
        Ok(Self { columns, model })
    }

    /// The column of an option such as `--target-mass <KG>`.
    pub(super) fn header_of(&self, option: &str) -> Option<&str> {
        let name = option.trim_start_matches('-').split([' ', '=']).next()?;
        let column =
            self.columns.iter().find(|column| column.option == name && column.kind != Kind::Model)?;
        Some(&column.header)
    }
}

fn listed(header: &[String]) -> String {
    let cells: Vec<String> = header.iter().map(|cell| format!("'{cell}'")).collect();
    if cells.is_empty() { "nothing".to_owned() } else { cells.join(", ") }
}

fn column(cell: &str, known: &HashMap<String, Kind>) -> Result<Column> {
    // `model` is MODEL; the option of standalone sets, which has the same name, is written with its dashes.
    let (option, dashes) = match cell.strip_prefix("--") {
        Some(option) => (option, true),
        None => (cell, false),
    };
    let option = option.to_ascii_lowercase().replace('_', "-");
    let kind = match option.as_str() {
        _ if cell.is_empty() || cell.starts_with('#') => Kind::Remark,
        "model" if !dashes => Kind::Model,
        "verb" if !dashes => Kind::Verb,
        "set" if !dashes => Kind::Set,
        name if OF_THE_RUN.contains(&name) => {
            bail!("the column '{cell}' is about the whole run: write --{name} behind the manifest's name")
        }
        name => match known.get(name) {
            Some(kind) => *kind,
            None => bail!(
                "the column '{cell}' is no option of rescale, transfer, design or set (remarks begin with #){}",
                nearest(name, known)
            ),
        },
    };
    Ok(Column { header: cell.to_owned(), option, kind })
}

/// The option that was probably meant.
fn nearest(name: &str, known: &HashMap<String, Kind>) -> String {
    let flat = |text: &str| text.replace('-', "");
    let mut close: Vec<&String> = known
        .keys()
        .filter(|option| {
            let (a, b) = (flat(option), flat(name));
            a.starts_with(&b) || b.starts_with(&a) || strsim::osa_distance(&a, &b) <= 2
        })
        .collect();
    close.sort();
    match close.first() {
        Some(option) => format!(": did you mean '{option}'?"),
        None => String::new(),
    }
}

/// Long options of all changing verbs, and how their cells are read.
fn options(command: &clap::Command) -> HashMap<String, Kind> {
    let verbs = command.get_subcommands().filter(|verb| VERBS.contains(&verb.get_name()));
    let arguments = verbs.flat_map(clap::Command::get_arguments);
    let named = arguments.filter_map(|argument| Some((argument.get_long()?.to_owned(), kind(argument))));
    named.collect()
}

fn kind(argument: &clap::Arg) -> Kind {
    let is_path = argument.get_value_parser().type_id() == TypeId::of::<PathBuf>();
    match argument.get_action() {
        _ if argument.get_long() == Some("from") => Kind::From,
        ArgAction::SetTrue => Kind::Flag,
        // A list parted by commas is one value for the parser.
        ArgAction::Append if argument.get_value_delimiter().is_none() => Kind::List,
        _ if is_path => Kind::Path,
        _ => Kind::Value,
    }
}
