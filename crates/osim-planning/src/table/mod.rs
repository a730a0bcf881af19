//! A table of requests: each row changes one model. Reads a row as the fields of a request, and reports faults in the row.

mod columns;

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use osim_model::files::{Failure, Files};
use osim_model::messages::{Input, Phrase, Verb, phrase, shown};
use osim_model::{MassesOfOtherRows, YesQuestion};
use osim_requests::options::OutputOptions;
use osim_requests::values::path;
use osim_requests::values::typed_numbers::trimmed;
use osim_requests::{CHANGING, Request, RequestError, RequestFault};
use serde_json::{Map, Value, json};

use crate::opening::{find_preset, looks_like_file};
use crate::prepared_change::PreparedChange;
use crate::sheet::{BROKEN_FORMULA_MESSAGE, Row, Sheet, is_broken_formula};
use crate::table::columns::{CellKind, Column, Columns, VERBS_OF_COLUMNS, WAY_OUT, model_field};
use crate::verbs::{changing_verbs, prepare};

/// A table of models, each row of which is a request to change one model.
pub struct Table {
    sheet: Sheet,
    columns: Columns,
    masses: MassesOfTable,
    /// The folder at which relative paths in the table begin.
    folder: PathBuf,
    /// Questions that the call answers for all rows.
    pub yes: Vec<YesQuestion>,
}

/// The request of one row of a table.
#[derive(Debug, Clone, PartialEq)]
pub struct RowRequest {
    /// Line of the row in the table; the first row, which names the columns, is line 1.
    pub line: u64,
    pub verb: Verb,
    pub model: PathBuf,
    /// Output options of the row; options that the row does not have are those of the call.
    pub output: OutputOptions,
    /// The cells in the user's own columns: name of the column and text of the cell, which may be empty.
    pub user_columns: Vec<(String, String)>,
    fields: Map<String, Value>,
}

impl RowRequest {
    /// A text with all settings of the row. Rows with equal texts make the same plan for any model and write it in the same way.
    pub fn settings(&self) -> String {
        let mut output = self.output.clone();
        (output.output, output.geometry_output, output.output_dir) = (None, None, None);
        json!([self.verb.name(), self.fields, output]).to_string()
    }
}

impl Table {
    /// Reads a table. `folder` is the folder of the table. With `keeps_others`, columns that are not options are the user's own.
    ///
    /// # Errors
    /// It is not a table, or its first row does not name fields of changes.
    pub fn read(bytes: &[u8], folder: &Path, keeps_others: bool) -> Result<Self, Phrase> {
        let sheet = Sheet::read(bytes)?;
        let columns = Columns::from_header(&sheet.header, keeps_others)?;
        let masses = MassesOfTable::of(&sheet, &columns);
        Ok(Self { sheet, columns, masses, folder: folder.to_owned(), yes: Vec::new() })
    }

    /// Each row that is not empty as a request. `call` has the output options for rows without such options.
    pub fn requests<'t>(
        &'t self,
        call: &'t OutputOptions,
        files: &'t dyn Files,
    ) -> impl Iterator<Item = (u64, Result<RowRequest, RowFault>)> {
        let rows = self.sheet.rows.iter().filter(|row| row.cells.iter().any(|cell| !cell.is_empty()));
        rows.map(move |row| (row.line, self.request(row, call, files)))
    }

    /// The request of one row.
    fn request(&self, row: &Row, call: &OutputOptions, files: &dyn Files) -> Result<RowRequest, RowFault> {
        RowRequest::read(row, &self.columns, &self.sheet, &self.folder, files)?.with_output_options(call)
    }

    /// Checks the request of a row and prepares the change.
    ///
    /// # Errors
    /// What is wrong, with its column.
    pub fn prepare(&self, row: &RowRequest, files: &dyn Files) -> Result<PreparedChange, RowFault> {
        let mut fields = row.fields.clone();
        if row.verb == Verb::Fit && !fields.contains_key(Input::Motion.name()) {
            let column = self.columns.header_of(Input::Motion.name()).map(str::to_owned);
            let message =
                phrase!["a row of fit is about a recording: fill the columns 'motion' and 'plates'"];
            return Err(RowFault { column, message });
        }
        // A list may be given as its only item.
        let field = model_field(row.verb);
        fields.insert(field.to_owned(), path::to_value(&row.model));
        if !self.yes.is_empty() {
            let own = fields.get(Input::Yes.name()).and_then(Value::as_array).cloned().unwrap_or_default();
            let yes = self.yes.iter().map(|question| Value::from(question.as_str())).chain(own);
            fields.insert(Input::Yes.name().to_owned(), yes.collect());
        }
        let other_rows = self.masses.other_rows(&fields);
        let mut request =
            Request::read(row.verb, fields).map_err(|fault| self.row_fault(&fault, row.verb))?;
        if let Some(masses) = request.masses_mut() {
            masses.other_rows = other_rows;
        }
        let change = prepare(request, files).map_err(|error| match error {
            RequestError::Fault(fault) => self.row_fault(&fault, row.verb),
            RequestError::Failure(Failure { model, message, .. }) => {
                let mut text = Phrase::from(format!("{model}: "));
                text.push(&message);
                RowFault::of("from", text)
            }
        })?;
        Ok(PreparedChange { output: row.output.clone(), ..change })
    }

    /// The fault of a request as a fault of its row, with the column that it is about.
    fn row_fault(&self, fault: &RequestFault, verb: Verb) -> RowFault {
        let column = fault
            .field()
            .and_then(|field| self.columns.header_of(field))
            .or_else(|| (verb == Verb::Set).then(|| self.columns.header_of("set")).flatten())
            .map(str::to_owned);
        let message = match (fault, &column) {
            (RequestFault::UnknownField { .. }, Some(_)) => {
                format!("{} has no such option: leave the cell empty{WAY_OUT}", verb.name()).into()
            }
            // What is wrong with assignments names the one that it is about.
            (RequestFault::BadValue { field, reason, .. }, Some(_)) if field == "set" => {
                reason.clone().into()
            }
            (RequestFault::BadValue { value, reason, .. }, Some(_)) => {
                format!("'{}': {reason}", shown(value)).into()
            }
            _ => fault.phrase(),
        };
        RowFault { column, message }
    }

    /// The failure for a fault in a row of the table; messages call the table `shown`.
    pub fn failure(&self, shown: &str, line: u64, fault: &RowFault) -> Failure {
        let column = fault.column.as_ref().map(|column| format!(", column '{column}'")).unwrap_or_default();
        let message = phrase![format!("row {line}{column}: "), &fault.message];
        let mut failure = Failure::outside(shown, "manifest", message);
        failure.line = usize::try_from(line).ok();
        let index =
            fault.column.as_ref().and_then(|name| self.sheet.header.iter().position(|cell| cell == name));
        failure.column = index.map(|index| index + 1);
        failure
    }

    /// Headers of the user's own columns that are not marked by #.
    pub fn unmarked_user_columns(&self) -> Vec<String> {
        self.columns.unmarked_user_columns()
    }

    pub fn header_of(&self, input: Input) -> Option<&str> {
        self.columns.header_of(input.name())
    }

    pub fn model_column(&self) -> &str {
        &self.columns.model
    }
}

/// What is wrong with a row of a table of models.
#[derive(Debug, Clone, PartialEq)]
pub struct RowFault {
    /// Header of the column with the fault; `None` if the fault is not about one column.
    pub column: Option<String>,
    pub message: Phrase,
}

impl RowFault {
    /// A fault in the cell of one column.
    pub fn of(column: &str, message: impl Into<Phrase>) -> Self {
        Self { column: Some(column.to_owned()), message: message.into() }
    }

    /// A fault that is not about one column.
    pub fn general(message: impl Into<Phrase>) -> Self {
        Self { column: None, message: message.into() }
    }
}

// The cells of a row, as the fields of its request.

impl RowRequest {
    /// Reads the cells of `row`. `folder` is the folder of the table.
    ///
    /// # Errors
    /// A cell that is not clear, or a row without a model or a verb.
    fn read(
        row: &Row,
        columns: &Columns,
        sheet: &Sheet,
        folder: &Path,
        files: &dyn Files,
    ) -> Result<Self, RowFault> {
        let mut cells = Self {
            line: row.line,
            verb: verb_of_row(row, columns)?,
            model: PathBuf::new(),
            output: OutputOptions::default(),
            user_columns: columns.user_columns(&row.cells),
            fields: Map::new(),
        };
        for (column, cell) in filled_cells(row, columns) {
            if column.kind != CellKind::UserColumn && is_broken_formula(cell) {
                return Err(RowFault::of(&column.header, format!("'{cell}' {BROKEN_FORMULA_MESSAGE}")));
            }
            match column.kind {
                CellKind::Model => cells.model = path_below(folder, cell),
                CellKind::Path => cells.set_path(&column.field, path_below(folder, cell)),
                CellKind::From => {
                    let presets = filled_cells(row, columns).find(|(column, _)| column.field == "presets");
                    let presets = presets.map(|(_, cell)| path_below(folder, cell));
                    let from = preset_or_model_path(folder, cell, presets.as_deref(), files);
                    cells.set_field(&column.field, path::to_value(&from));
                }
                CellKind::Value => cells.set_field(&column.field, number_text(cell, sheet, column)?),
                CellKind::List => {
                    cells.set_field(&column.field, cell_items(cell, &[';']).collect::<Vec<_>>());
                }
                CellKind::ListWithCommas => {
                    cells.set_field(&column.field, cell_items(cell, &[';', ',']).collect::<Vec<_>>());
                }
                CellKind::Paths => {
                    let paths =
                        cell_items(cell, &[';']).map(|item| path::to_value(&path_below(folder, item)));
                    cells.set_field(&column.field, paths.collect::<Vec<Value>>());
                }
                CellKind::Flag if is_yes(cell, column)? => cells.set_field(&column.field, true),
                CellKind::Set => cells.set_field("set", cell),
                CellKind::Flag | CellKind::Verb | CellKind::UserColumn => {}
            }
        }
        if cells.model.as_os_str().is_empty() {
            return Err(RowFault::of(&columns.model, "empty, expected the model's file name"));
        }
        if cells.model.as_os_str() == "-" {
            let message = "standard input cannot be a model of a table: name a file";
            return Err(RowFault::of(&columns.model, message));
        }
        Ok(cells)
    }

    /// The request with all options for its output: those in the row's cells, else those of the call.
    fn with_output_options(mut self, call: &OutputOptions) -> Result<Self, RowFault> {
        let OutputOptions { output, output_dir, .. } = &self.output;
        let named = output.is_some() || output_dir.is_some();
        if output.as_deref() == Some(Path::new("-")) {
            return Err(RowFault::of("output", "standard output takes one model: name a file"));
        }
        if output.is_some() && output_dir.is_some() {
            return Err(RowFault::of("output-dir", "the row has an output already: leave one cell empty"));
        }
        if named && self.has_flag("in_place") {
            return Err(RowFault::of("in-place", "the row has an output already: leave one cell empty"));
        }
        if !named {
            self.output.output_dir.clone_from(&call.output_dir);
        }
        self.output.in_place = self.has_flag("in_place") || (call.in_place && !named);
        self.output.no_backup = self.has_flag("no_backup") || call.no_backup;
        self.output.force = self.has_flag("force") || call.force;
        self.output.no_note = self.has_flag("no_note") || call.no_note;
        Ok(self)
    }

    fn has_flag(&self, flag: &str) -> bool {
        self.fields.get(flag) == Some(&Value::Bool(true))
    }

    /// Sets a field of the row's request.
    fn set_field(&mut self, field: &str, value: impl Into<Value>) {
        self.fields.insert(field.to_owned(), value.into());
    }

    /// Sets a field of the row's request that is a path.
    fn set_path(&mut self, field: &str, path: PathBuf) {
        match field {
            "output" => self.output.output = Some(path),
            "output_dir" => self.output.output_dir = Some(path),
            "geometry_output" => self.output.geometry_output = Some(path),
            _ => self.set_field(field, path::to_value(&path)),
        }
    }
}

/// The items of a cell between these marks.
fn cell_items<'c>(cell: &'c str, marks: &[char]) -> impl Iterator<Item = &'c str> {
    cell.split(marks).map(trimmed).filter(|item| !item.is_empty())
}

/// The cells of a row that are not empty, with their columns.
fn filled_cells<'r>(row: &'r Row, columns: &'r Columns) -> impl Iterator<Item = (&'r Column, &'r str)> {
    let cells = row.cells.iter().map(String::as_str);
    columns.columns.iter().zip(cells).filter(|(_, cell)| !cell.is_empty())
}

/// The verb of a row: the text in its verb cell; else the verb that the other cells of the row show.
fn verb_of_row(row: &Row, columns: &Columns) -> Result<Verb, RowFault> {
    let filled = |field: &str| {
        filled_cells(row, columns)
            .find(|(column, _)| column.field == field && column.kind != CellKind::UserColumn)
    };
    if let Some((column, cell)) = filled("verb") {
        let known = CHANGING.iter().copied().find(|verb| verb.name().eq_ignore_ascii_case(cell));
        return known
            .ok_or_else(|| RowFault::of(&column.header, format!("'{cell}', expected {}", changing_verbs())));
    }
    let shown = VERBS_OF_COLUMNS.into_iter().find(|(field, _)| filled(field).is_some());
    let message = || {
        let is_mass = |name: &String| ["mass", "weight"].iter().any(|one| name.to_lowercase().contains(one));
        let mass = columns.unmarked_user_columns().into_iter().find(is_mass);
        let hint = mass.map(|name| format!("; is '{name}' that mass? Call it target-mass, in kg"));
        let hint = hint.unwrap_or_default();
        format!("what to do is missing: fill in a target mass (rescale), from (transfer), set, or verb{hint}")
    };
    shown.map(|(_, verb)| verb).ok_or_else(|| RowFault::general(message()))
}

/// A path in the table, which begins at the table's own folder.
fn path_below(folder: &Path, path: &str) -> PathBuf {
    if path == "-" { PathBuf::from(path) } else { folder.join(path) }
}

/// The name of a preset, or else the path of a model, which begins at the table's folder.
fn preset_or_model_path(folder: &Path, cell: &str, presets: Option<&Path>, files: &dyn Files) -> PathBuf {
    let path = path_below(folder, cell);
    let is_preset = || find_preset(Path::new(cell), presets, files).is_ok_and(|preset| preset.is_some());
    let is_file = !is_preset() && (files.exists(&path) || looks_like_file(Path::new(cell)));
    if is_file { path } else { cell.into() }
}

/// The text of a number with a decimal point. The cell may have a decimal comma if the meaning of the comma is clear.
fn number_text(cell: &str, sheet: &Sheet, column: &Column) -> Result<String, RowFault> {
    let refused = |message: String| RowFault::of(&column.header, Phrase::from(message));
    let digits = cell.strip_prefix(['x', 'X']).unwrap_or(cell);
    let numeric = digits.starts_with(|c: char| c.is_ascii_digit() || c == '-' || c == '+')
        && digits.bytes().all(|byte| byte.is_ascii_digit() || b"+-.,eE".contains(&byte));
    if !numeric {
        return Ok(cell.to_owned());
    }
    for mark in [',', '.'] {
        // A point separates thousands only where commas are decimal.
        if may_part_thousands(digits, mark) && (mark == ',' || sheet.decimal_commas) {
            let (plain, point) = (digits.replace(mark, ""), digits.replace(mark, "."));
            return Err(refused(format!("'{cell}' may be {plain} or {point}: write {plain} or {point}0")));
        }
    }
    sheet.with_decimal_point(cell).map(Into::into).map_err(|why| refused(format!("'{cell}' {why}")))
}

/// Whether `mark` may separate thousands in these digits. In some countries `1,190` is 1.19 and in others 1190, and likewise `1.190`;
/// `0,190` has only one meaning.
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

/// Whether a cell says yes; an error if it says neither yes nor no.
fn is_yes(cell: &str, column: &Column) -> Result<bool, RowFault> {
    match cell.to_ascii_lowercase().as_str() {
        "yes" | "true" | "1" | "x" => Ok(true),
        "no" | "false" | "0" => Ok(false),
        _ => Err(RowFault::of(&column.header, format!("'{cell}', expected yes or no"))),
    }
}

// Columns of masses: each row is judged by the others, because a mistake differs from the other rows.

/// Columns with masses, which may have typing mistakes or other units.
const MASS_COLUMNS: [Input; 3] = [Input::TargetMass, Input::ContactsMass, Input::Mass];

/// The masses in each of the [`MASS_COLUMNS`], kg, from the lightest to the heaviest.
#[derive(Debug, Default)]
struct MassesOfTable(BTreeMap<Input, Vec<f64>>);

impl MassesOfTable {
    /// Collects the masses from all rows of a table. A cell that is not a number is refused later, when its row is read.
    fn of(sheet: &Sheet, columns: &Columns) -> Self {
        let read = |input: Input| {
            let is_of = |field: &str, kind| kind == CellKind::Value && field == input.name();
            let at = columns.columns.iter().position(|column| is_of(&column.field, column.kind))?;
            let column = columns.columns.get(at)?;
            let cells = sheet.rows.iter().filter_map(|row| row.cells.get(at));
            let mut masses: Vec<f64> =
                cells.filter_map(|cell| number_text(cell, sheet, column).ok()?.parse().ok()).collect();
            masses.sort_by(f64::total_cmp);
            Some((input, masses))
        };
        Self(MASS_COLUMNS.into_iter().filter_map(read).collect())
    }

    /// The masses in the other rows of the table, for a row with the fields `fields`.
    fn other_rows(&self, fields: &Map<String, Value>) -> BTreeMap<Input, MassesOfOtherRows> {
        let found = self.0.iter().filter_map(|(&input, sorted)| {
            let own_kg = fields.get(input.name())?.as_str()?.parse().ok()?;
            Some((input, MassesOfOtherRows::without(sorted, own_kg)?))
        });
        found.collect()
    }
}
