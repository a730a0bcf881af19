//! A table of requests: each row changes one model.

mod cells;
mod columns;

use std::path::{Path, PathBuf};

use osim_model::YesQuestion;
use osim_model::files::{Failure, Files};
use osim_model::messages::{Input, Phrase, Verb, phrase, shown};
use osim_requests::options::OutputOptions;
use osim_requests::values::path;
use osim_requests::{Request, RequestError, RequestFault};
use serde_json::{Map, Value, json};

use crate::prepared_change::PreparedChange;
use crate::sheet::{Row, Sheet};
use crate::table::cells::{MassesOfTable, RowCells};
use crate::table::columns::{Columns, WAY_OUT, model_field};
use crate::verbs::prepare;
pub use cells::RowFault;

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
        let cells = RowCells::read(row, &self.columns, &self.sheet, &self.folder, files)?;
        let output = output_options_of_row(&cells, call)?;
        let RowCells { verb, model, fields, .. } = cells;
        let user_columns = self.columns.user_columns(&row.cells);
        Ok(RowRequest { line: row.line, verb, model, output, user_columns, fields })
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
        let place = match &fault.column {
            Some(column) => format!("row {line}, column '{column}': "),
            None => format!("row {line}: "),
        };
        let mut message = Phrase::from(place);
        message.push(&fault.message);
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

/// Output options of a row: the options in its cells, else the options of the call.
fn output_options_of_row(cells: &RowCells, call: &OutputOptions) -> Result<OutputOptions, RowFault> {
    let named = cells.output.is_some() || cells.output_dir.is_some();
    if cells.output.as_deref() == Some(Path::new("-")) {
        return Err(RowFault::of("output", "standard output takes one model: name a file"));
    }
    if cells.output.is_some() && cells.output_dir.is_some() {
        return Err(RowFault::of("output-dir", "the row has an output already: leave one cell empty"));
    }
    if named && cells.has_flag("in_place") {
        return Err(RowFault::of("in-place", "the row has an output already: leave one cell empty"));
    }
    let mut output = OutputOptions::default();
    output.output.clone_from(&cells.output);
    output.geometry_output.clone_from(&cells.geometry_output);
    output.output_dir.clone_from(if named { &cells.output_dir } else { &call.output_dir });
    output.in_place = cells.has_flag("in_place") || (call.in_place && !named);
    output.no_backup = cells.has_flag("no_backup") || call.no_backup;
    output.force = cells.has_flag("force") || call.force;
    output.no_note = cells.has_flag("no_note") || call.no_note;
    Ok(output)
}
