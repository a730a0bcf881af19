//! One row as the words of a command line.

use std::ffi::OsString;
use std::path::{Path, PathBuf};

use super::columns::{Column, Columns, Kind, VERBS};
use super::{Fault, below};
use crate::spreadsheet::{Row, Sheet};

/// What a row says.
#[derive(Debug)]
pub(super) struct Words {
    pub verb: &'static str,
    pub model: PathBuf,
    pub output: Option<PathBuf>,
    pub output_dir: Option<PathBuf>,
    pub geometry_output: Option<PathBuf>,
    /// Everything else.
    pub options: Vec<OsString>,
}

/// Reads the cells of `row`.
pub(super) fn words(row: &Row, columns: &Columns, sheet: &Sheet, folder: &Path) -> Result<Words, Fault> {
    let mut words = Words {
        verb: verb(row, columns)?,
        model: PathBuf::new(),
        output: None,
        output_dir: None,
        geometry_output: None,
        options: Vec::new(),
    };
    for (column, cell) in filled(row, columns) {
        match column.kind {
            Kind::Model => words.model = below(folder, cell),
            Kind::Path => words.path(&column.option, below(folder, cell)),
            Kind::From => words.option(&column.option, from(folder, cell)),
            Kind::Value => words.option(&column.option, number(cell, sheet, column)?),
            Kind::List => cell
                .split(';')
                .map(str::trim)
                .filter(|item| !item.is_empty())
                .for_each(|item| words.option(&column.option, item)),
            Kind::Flag if is_yes(cell, column)? => words.options.push(format!("--{}", column.option).into()),
            Kind::Set => words.options.extend(assignments(cell)),
            Kind::Flag | Kind::Verb | Kind::Remark => {}
        }
    }
    if words.model.as_os_str().is_empty() {
        return Err(Fault::of(&columns.model, "empty, expected the model's file name"));
    }
    if words.model.as_os_str() == "-" {
        return Err(Fault::of(&columns.model, "standard input is no model of a manifest: name a file"));
    }
    Ok(words)
}

impl Words {
    /// Whether the row has the flag.
    pub(super) fn has(&self, flag: &str) -> bool {
        self.options.iter().any(|word| word.to_str().and_then(|word| word.strip_prefix("--")) == Some(flag))
    }

    fn option(&mut self, name: &str, value: impl Into<OsString>) {
        let mut word = OsString::from(format!("--{name}="));
        word.push(value.into());
        self.options.push(word);
    }

    fn path(&mut self, name: &str, path: PathBuf) {
        match name {
            "output" => self.output = Some(path),
            "output-dir" => self.output_dir = Some(path),
            "geometry-output" => self.geometry_output = Some(path),
            _ => self.option(name, path),
        }
    }
}

/// The cells that say something.
fn filled<'r>(row: &'r Row, columns: &'r Columns) -> impl Iterator<Item = (&'r Column, &'r str)> {
    let cells = row.cells.iter().map(String::as_str);
    columns.columns.iter().zip(cells).filter(|(_, cell)| !cell.is_empty())
}

/// The verb of a row: as its cell says, else what only one verb can mean.
fn verb(row: &Row, columns: &Columns) -> Result<&'static str, Fault> {
    let has = |kind: Kind, option: &str| {
        filled(row, columns)
            .find(|(column, _)| column.kind == kind && (option.is_empty() || column.option == option))
    };
    if let Some((column, cell)) = has(Kind::Verb, "") {
        let known = VERBS.into_iter().find(|verb| verb.eq_ignore_ascii_case(cell));
        return known.ok_or_else(|| {
            Fault::of(&column.header, format!("'{cell}', expected rescale, transfer, design or set"))
        });
    }
    if has(Kind::From, "").is_some() {
        return Ok("transfer");
    }
    if has(Kind::Set, "").is_some() {
        return Ok("set");
    }
    if has(Kind::Value, "target-mass").is_some() {
        return Ok("rescale");
    }
    let message = "what to do is missing: fill in target-mass (rescale), from (transfer), set, or verb";
    Err(Fault { column: None, message: message.to_owned() })
}

/// A model below the manifest's folder; what is no file there may be a preset.
fn from(folder: &Path, cell: &str) -> OsString {
    let path = below(folder, cell);
    if path.exists() { path.into() } else { cell.into() }
}

/// A number may have a decimal comma where that is clear.
fn number(cell: &str, sheet: &Sheet, column: &Column) -> Result<String, Fault> {
    let digits = cell.strip_prefix(['x', 'X']).unwrap_or(cell);
    let numeric = digits.starts_with(|c: char| c.is_ascii_digit() || c == '-' || c == '+')
        && digits.bytes().all(|byte| byte.is_ascii_digit() || b"+-.,eE".contains(&byte));
    if !numeric {
        return Ok(cell.to_owned());
    }
    for mark in [',', '.'] {
        // A point parts thousands only where commas are decimal.
        if may_part_thousands(digits, mark) && (mark == ',' || sheet.decimal_commas) {
            let (plain, point) = (digits.replace(mark, ""), digits.replace(mark, "."));
            let message = format!("'{cell}' may be {plain} or {point}: write {plain} or {point}0");
            return Err(Fault::of(&column.header, message));
        }
    }
    let text = sheet.with_point(cell);
    text.map(Into::into).map_err(|why| Fault::of(&column.header, format!("'{cell}' {why}")))
}

/// `1,190` is one thing here and another there, and so is `1.190`; `0,190` is not.
fn may_part_thousands(digits: &str, mark: char) -> bool {
    let all_digits = |text: &str| text.bytes().all(|byte| byte.is_ascii_digit());
    digits.split_once(mark).is_some_and(|(head, tail)| {
        (1..=3).contains(&head.len())
            && all_digits(head)
            && !head.starts_with('0')
            && tail.len() == 3
            && all_digits(tail)
    })
}

fn is_yes(cell: &str, column: &Column) -> Result<bool, Fault> {
    match cell.to_ascii_lowercase().as_str() {
        "yes" | "true" | "1" | "x" => Ok(true),
        "no" | "false" | "0" => Ok(false),
        _ => Err(Fault::of(&column.header, format!("'{cell}', expected yes or no"))),
    }
}

/// `stiffness=x2 dissipation=1`, parted by blanks or semicolons.
fn assignments(cell: &str) -> impl Iterator<Item = OsString> {
    cell.split([' ', ';']).filter(|item| !item.is_empty()).map(OsString::from)
}
