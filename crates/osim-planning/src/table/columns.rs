//! The columns of a table: which field of the changing verbs each column gives.

use std::collections::BTreeMap;

use osim_model::messages::{Input, Phrase, Verb, phrase};
use osim_requests::register::{Entry, List, OptionValue, option_named};
use osim_requests::{CHANGING, silent_fields};

use crate::verbs::changing_verbs;

/// The field of `fit` with the file of the model.
const FIT_MODEL: &str = "file";

/// The way in which a cell of a column becomes a value of a request.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum CellKind {
    Model,
    /// The name of the verb. It is needed only if the fields of the row do not show the verb.
    Verb,
    /// Assignments such as the verb `set` takes.
    Set,
    Value,
    Path,
    /// The path of a model or the name of a preset.
    From,
    List,
    ListWithCommas,
    Paths,
    Flag,
    UserColumn,
}

/// The field of a verb that has the path of the model.
pub(super) fn model_field(verb: Verb) -> &'static str {
    if verb == Verb::Fit { FIT_MODEL } else { "models" }
}

#[derive(Debug)]
pub(super) struct Column {
    /// The text of the column in the first row of the table.
    pub header: String,
    pub field: String,
    pub kind: CellKind,
}

#[derive(Debug)]
pub(super) struct Columns {
    pub columns: Vec<Column>,
    /// Header of the column with the paths of the models.
    pub model: String,
}

impl Columns {
    /// Finds the meaning of each column.
    ///
    /// # Errors
    ///
    /// No column `model`, a column that appears twice, or a column that is not a field of a changing verb.
    pub(super) fn of(header: &[String]) -> Result<Self, Phrase> {
        let known = fields();
        let mut columns: Vec<Column> = Vec::new();
        let mut wrong: Vec<Phrase> = Vec::new();
        for cell in header {
            let twice = |one: &Column, other: &Column| match one.kind {
                // Columns without a name are ignored.
                CellKind::UserColumn => !one.header.is_empty() && one.header == other.header,
                _ => (&one.field, one.kind) == (&other.field, other.kind),
            };
            match column(cell, &known) {
                Err(message) => wrong.push(message),
                Ok(one) if columns.iter().any(|other| twice(&one, other)) => {
                    wrong.push(format!("the column '{cell}' appears twice, expected one").into());
                }
                Ok(column) => columns.push(column),
            }
        }
        if let Some(message) = Phrase::joined(wrong, "; ") {
            return Err(message);
        }
        let Some(model) = columns.iter().find(|column| column.kind == CellKind::Model) else {
            return Err(format!("no column 'model' in the first row, which has {}", listed(header)).into());
        };
        let model = model.header.clone();
        Ok(Self { columns, model })
    }

    /// The cells in the user's own columns of a row: name of the column and text of the cell. Columns without a name are ignored.
    pub(super) fn user_columns(&self, cells: &[String]) -> Vec<(String, String)> {
        let own = self.columns.iter().enumerate();
        let own = own.filter(|(_, column)| column.kind == CellKind::UserColumn && !column.header.is_empty());
        own.map(|(at, column)| (column.header.clone(), cells.get(at).cloned().unwrap_or_default())).collect()
    }

    pub(super) fn header_of(&self, field: &str) -> Option<&str> {
        let column =
            self.columns.iter().find(|column| column.field == field && column.kind != CellKind::Model)?;
        Some(&column.header)
    }
}

fn listed(header: &[String]) -> String {
    let cells: Vec<String> = header.iter().map(|cell| format!("'{cell}'")).collect();
    if cells.is_empty() { "nothing".to_owned() } else { cells.join(", ") }
}

fn column(cell: &str, known: &BTreeMap<String, Option<CellKind>>) -> Result<Column, Phrase> {
    // `model` is the model; the field of standalone sets, which has the same name, is written with two dashes before it.
    let (name, dashes) = match cell.strip_prefix("--") {
        Some(name) => (name, true),
        None => (cell, false),
    };
    let field = name.to_ascii_lowercase().replace('-', "_");
    let kind = match field.as_str() {
        _ if cell.is_empty() || cell.starts_with('#') => CellKind::UserColumn,
        "model" if !dashes => CellKind::Model,
        "verb" if !dashes => CellKind::Verb,
        "set" if !dashes => CellKind::Set,
        name => match known.get(name) {
            Some(Some(kind)) => *kind,
            Some(None) => return Err(of_the_run(cell, name)),
            None => {
                return Err(format!(
                    "the column '{cell}' is not an option of {} (a column whose name begins with # is carried along){}",
                    changing_verbs(),
                    nearest(cell, name, known)
                )
                .into());
            }
        },
    };
    Ok(Column { header: cell.to_owned(), field, kind })
}

fn of_the_run(cell: &str, field: &str) -> Phrase {
    let about = format!("the column '{cell}' is about the whole run: write ");
    match Input::named(field) {
        Some(input) => phrase![about, input, " after the manifest's name"],
        None => format!("{about}{field} after the manifest's name").into(),
    }
}

/// The hint `: did you mean ...?` with the field that the user probably wanted to write as `cell`; empty if no field is similar.
fn nearest(cell: &str, name: &str, known: &BTreeMap<String, Option<CellKind>>) -> String {
    let flat = |text: &str| text.replace('_', "");
    let close = known.keys().find(|field| {
        let (a, b) = (flat(field), flat(name));
        a.starts_with(&b) || b.starts_with(&a) || strsim::osa_distance(&a, &b) <= 2
    });
    match close {
        // As an option of the command line, where the cell is spelled like one.
        Some(field) if cell.contains('-') => format!(": did you mean '{}'?", field.replace('_', "-")),
        Some(field) => format!(": did you mean '{field}'?"),
        None => String::new(),
    }
}

/// The fields of all changing verbs, and how their cells are read. `None` marks fields of the whole run, which a row cannot set for itself.
fn fields() -> BTreeMap<String, Option<CellKind>> {
    let of_verb = |verb: Verb| {
        let names = silent_fields(verb).into_iter().map(|(name, _)| name);
        let named = names.filter(|name| !["models", "set", FIT_MODEL].contains(&name.as_str()));
        named.filter_map(move |name| Some((name.clone(), kind(&option_named(verb, &name)?))))
    };
    CHANGING.iter().copied().flat_map(of_verb).collect()
}

fn kind(option: &Entry) -> Option<CellKind> {
    if option.is_of_run {
        return None;
    }
    Some(match (option.takes, option.list) {
        _ if option.name == Input::From.name() => CellKind::From,
        (OptionValue::Flag, _) => CellKind::Flag,
        (_, List::Commas) => CellKind::ListWithCommas,
        (_, List::One) if option.is_path() => CellKind::Path,
        (_, List::Repeated) if option.is_path() => CellKind::Paths,
        (_, List::One) => CellKind::Value,
        (_, List::Repeated) => CellKind::List,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_column_that_is_misspelled_is_pointed_out() {
        let columns = Columns::of(&["model".to_owned(), "target-mas".to_owned()]);
        assert!(columns.unwrap_err().to_string().contains("did you mean 'target-mass'?"));
        // As the reader writes names.
        let columns = Columns::of(&["model".to_owned(), "target_mas".to_owned()]);
        assert!(columns.unwrap_err().to_string().contains("did you mean 'target_mass'?"));
        let columns = Columns::of(&["model".to_owned(), "TargetMass".to_owned()]);
        assert!(columns.unwrap_err().to_string().contains("did you mean 'target_mass'?"));
    }

    #[test]
    fn user_columns_of_one_name_are_refused_and_nameless_columns_are_not() {
        let columns =
            |header: &[&str]| Columns::of(&header.iter().map(|&cell| cell.to_owned()).collect::<Vec<_>>());
        let message = columns(&["model", "#sex", "mass", "#sex"]).unwrap_err().to_string();
        assert!(message.contains("the column '#sex' appears twice"), "{message}");
        assert!(columns(&["model", "", "#sex", "", "#age"]).is_ok());
    }

    #[test]
    fn all_columns_that_are_wrong_are_named_at_once() {
        let header =
            ["subject", "model", "target-mas", "age", "mass", "mass", "jobs", "#sex"].map(str::to_owned);
        let message = Columns::of(&header).unwrap_err().to_string();
        for column in ["subject", "target-mas", "age"] {
            let wrong = format!("the column '{column}' is not an option of");
            assert!(message.contains(&wrong), "{message}");
        }
        for wrong in ["'mass' appears twice", "'jobs' is about the whole run"] {
            assert!(message.contains(wrong), "{message}");
        }
        assert!(!message.contains("#sex"), "{message}");
    }
}
