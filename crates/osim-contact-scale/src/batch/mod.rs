//! `batch MANIFEST.csv`: a verb per row.
//!
//! A row is turned into the words of a command line, and the command line's own parser reads it: a cell means exactly
//! what the option means. All rows are read before the first file is written, and all that is wrong is told at once.

mod columns;
mod words;

use std::collections::HashMap;
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use anyhow::{Context, Result, bail};
use clap::{CommandFactory, FromArgMatches};

use crate::args::{BatchArgs, Cli, OutputArgs, RunFormat, Verb, usage_parts};
use crate::failure::Failure;
use crate::load::read;
use crate::paths::folder_of;
use crate::run::{self, Order, Task, Work};
use crate::sources::Source;
use crate::spreadsheet::{Row, Sheet};
use crate::terminal::{Exit, Terminal};
use crate::verbs;

use columns::Columns;
use words::{Words, words};

/// Rows that are wrong are told one by one up to this number, then counted.
const TOLD: usize = 20;

/// Does all rows of the manifest.
///
/// # Errors
/// The manifest cannot be read, or is no table with a column `model`.
pub(crate) fn batch(args: &BatchArgs, terminal: &mut Terminal) -> Result<Exit> {
    let shown = args.manifest.display().to_string();
    if args.output.output.is_some() || args.output.geometry_output.is_some() {
        bail!("-o is for one model: give the rows a column 'output', or write all into a folder with -d DIR");
    }
    let bytes = read(&args.manifest).with_context(|| shown.clone())?;
    let sheet = Sheet::read(&bytes).with_context(|| shown.clone())?;
    let mut command = Cli::command();
    let columns = Columns::of(&sheet.header, &command).with_context(|| shown.clone())?;
    let from_stdin = args.manifest.as_os_str() == "-";
    let folder = if from_stdin { Path::new("") } else { folder_of(&args.manifest) };
    // `.` in front of every path would only be in the way.
    let folder = if folder == Path::new(".") { Path::new("") } else { folder };
    let mut reader =
        Reader { sheet: &sheet, columns, folder, args, command: &mut command, orders: HashMap::new() };
    let (mut tasks, mut wrong) = (Vec::new(), Vec::new());
    for row in sheet.rows.iter().filter(|row| row.cells.iter().any(|cell| !cell.is_empty())) {
        match reader.task(row) {
            Ok(task) => tasks.push(task),
            Err(fault) => wrong.push(fault.failure(&shown, row, &sheet)),
        }
    }
    if !wrong.is_empty() {
        return tell(&wrong, &shown, args, terminal);
    }
    if tasks.is_empty() {
        bail!("{shown}: no rows below the first one, which names the columns");
    }
    let reads = vec![args.manifest.clone()];
    let work = Work { verb: "batch", tasks, reads, force: args.output.force, ..Work::default() };
    run::run(work, &args.run, terminal)
}

fn tell(wrong: &[Failure], shown: &str, args: &BatchArgs, terminal: &mut Terminal) -> Result<Exit> {
    for failure in wrong {
        if args.run.format == Some(RunFormat::Json) {
            terminal.print(&failure.json())?;
        }
    }
    for failure in wrong.iter().take(TOLD) {
        terminal.error(&format!("error: {}: {}\n", failure.model, failure.message));
    }
    let more = wrong.len().saturating_sub(TOLD);
    let more = if more > 0 { format!(", {more} of them not shown") } else { String::new() };
    let rows = if wrong.len() == 1 { "1 row is".to_owned() } else { format!("{} rows are", wrong.len()) };
    terminal.error(&format!("error: {shown}: {rows} wrong{more}: nothing was written\n"));
    Ok(Exit::Usage)
}

/// What is wrong with a row, and in which column.
struct Fault {
    column: Option<String>,
    message: String,
}

impl Fault {
    fn of(column: &str, message: impl Into<String>) -> Self {
        Self { column: Some(column.to_owned()), message: message.into() }
    }

    fn failure(&self, shown: &str, row: &Row, sheet: &Sheet) -> Failure {
        let index = self.column.as_ref().and_then(|name| sheet.header.iter().position(|cell| cell == name));
        let place = match &self.column {
            Some(column) => format!("row {}, column '{column}'", row.line),
            None => format!("row {}", row.line),
        };
        Failure {
            model: shown.to_owned(),
            code: "manifest",
            message: format!("{place}: {}", self.message),
            line: usize::try_from(row.line).ok(),
            column: index.map(|index| index + 1),
            snippet: None,
        }
    }
}

struct Reader<'r> {
    sheet: &'r Sheet,
    columns: Columns,
    /// Paths of the manifest begin here.
    folder: &'r Path,
    args: &'r BatchArgs,
    command: &'r mut clap::Command,
    /// Rows that only differ in model and output share what is to be done.
    orders: HashMap<(&'static str, Vec<OsString>, String), Arc<Order>>,
}

impl Reader<'_> {
    fn task(&mut self, row: &Row) -> Result<Task, Fault> {
        let words = words(row, &self.columns, self.sheet, self.folder)?;
        self.check_model(&words)?;
        let output = self.output(&words)?;
        let source = Source::file(&words.model);
        let order = self.order(&words, &output)?;
        let mut task = Task::new(source, &output, order);
        task.row = usize::try_from(row.line).ok();
        Ok(task)
    }

    fn check_model(&self, words: &Words) -> Result<(), Fault> {
        let column = &self.columns.model;
        if words.model.is_dir() {
            return Err(Fault::of(column, "a folder, expected one model per row"));
        }
        if !words.model.is_file() {
            let message = format!("there is no such file: {}", words.model.display());
            return Err(Fault::of(column, message));
        }
        Ok(())
    }

    /// Where the row's result goes: as its cells say, else as the call says.
    fn output(&self, words: &Words) -> Result<OutputArgs, Fault> {
        let named = words.output.is_some() || words.output_dir.is_some();
        let call = &self.args.output;
        if words.output.as_deref() == Some(Path::new("-")) {
            return Err(Fault::of("output", "standard output takes one model: name a file"));
        }
        if words.output.is_some() && words.output_dir.is_some() {
            return Err(Fault::of("output-dir", "the row has an output already: leave one cell empty"));
        }
        if named && words.has("in-place") {
            return Err(Fault::of("in-place", "the row has an output already: leave one cell empty"));
        }
        Ok(OutputArgs {
            output: words.output.clone(),
            geometry_output: words.geometry_output.clone(),
            output_dir: if named { words.output_dir.clone() } else { call.output_dir.clone() },
            in_place: words.has("in-place") || (call.in_place && !named),
            no_backup: words.has("no-backup") || call.no_backup,
            force: words.has("force") || call.force,
            no_note: words.has("no-note") || call.no_note,
        })
    }

    fn order(&mut self, words: &Words, output: &OutputArgs) -> Result<Arc<Order>, Fault> {
        // What is shared must be alike in everything but the model and the names of its results.
        let of_output =
            OutputArgs { output: None, geometry_output: None, output_dir: None, ..output.clone() };
        let key = (words.verb, words.options.clone(), format!("{of_output:?}"));
        if let Some(order) = self.orders.get(&key) {
            return Ok(Arc::clone(order));
        }
        let mut call =
            vec![OsString::from("osim-contact-scale"), words.verb.into(), words.model.clone().into()];
        call.extend(words.options.iter().cloned());
        let matches = self.command.try_get_matches_from_mut(call);
        let cli = matches.and_then(|matches| Cli::from_arg_matches(&matches));
        let cli = cli.map_err(|error| self.fault_of(&error, words.verb))?;
        let verb = planned(cli.verb).map_err(|fault| self.placed(fault, words.verb))?;
        let order = Arc::new(Order::new(verb.planner, verb.parts, output));
        self.orders.insert(key, Arc::clone(&order));
        Ok(order)
    }

    /// A message that begins with an option is about its column; what `set` refuses is in the column `set`.
    fn placed(&self, fault: Fault, verb: &str) -> Fault {
        let option = fault.message.split([' ', ':']).next().filter(|word| word.starts_with("--"));
        let column = option.or((verb == "set").then_some("set"));
        let column = fault
            .column
            .clone()
            .or(column.and_then(|column| self.columns.header_of(column)).map(str::to_owned));
        Fault { column, ..fault }
    }

    /// The parser's complaint, with the column that it is about.
    fn fault_of(&self, error: &clap::Error, verb: &str) -> Fault {
        let (option, message) = usage_parts(error);
        let column = option.and_then(|option| self.columns.header_of(&option));
        match column {
            Some(column) if error.kind() == clap::error::ErrorKind::UnknownArgument => {
                Fault::of(column, format!("{verb} has no such option: leave the cell empty"))
            }
            Some(column) => Fault::of(column, message),
            None => Fault { column: None, message },
        }
    }
}

fn planned(verb: Option<Verb>) -> Result<run::Verb, Fault> {
    let plain = |error: anyhow::Error| Fault { column: None, message: format!("{error:#}") };
    match verb {
        Some(Verb::Rescale(args)) => verbs::rescale::verb(*args).map_err(plain),
        Some(Verb::Design(args)) => verbs::design::verb(*args).map_err(plain),
        Some(Verb::Set(args)) => verbs::set::verb(*args).map_err(plain),
        Some(Verb::Transfer(args)) => {
            let verb = verbs::transfer::verb(*args).map_err(plain)?;
            verb.map_err(|failure| Fault::of("from", format!("{}: {}", failure.model, failure.message)))
        }
        _ => Err(Fault::of("verb", "expected rescale, transfer, design or set")),
    }
}

/// A path of the manifest: below the manifest's own folder.
fn below(folder: &Path, path: &str) -> PathBuf {
    if path == "-" { PathBuf::from(path) } else { folder.join(path) }
}
