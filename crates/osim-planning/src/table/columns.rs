//! The columns of a table: which field of the changing verbs each column gives.

use std::collections::BTreeMap;

use osim_model::messages::{Input, Phrase, Verb, phrase};
use osim_requests::register::{Entry, List, OptionValue, option_named};
use osim_requests::{CHANGING, silent_fields, verb_entry};

use crate::verbs::changing_verbs;

/// Other headers of the column `model`, without blanks and marks.
const OTHER_HEADERS_OF_MODEL: [&str; 5] = ["file", "path", "filename", "modelfile", "modelpath"];

/// Columns that say what happens to the model of a row without its verb, each with that verb; the first that is filled counts.
pub(super) const VERBS_OF_COLUMNS: [(&str, Verb); 3] =
    [("from", Verb::Transfer), ("set", Verb::Set), ("target_mass", Verb::Rescale)];

/// The hint for a column that may be the user's own: which name lets the summary have it, too.
pub(super) const WAY_OUT: &str = " (a column whose name begins with # is carried along)";

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
    verb_entry(verb).positional.first().copied().unwrap_or_default()
}

/// A column of a table of models: the field that it gives, and how its cells are read.
#[derive(Debug)]
pub(super) struct Column {
    /// The text of the column in the first row of the table.
    pub header: String,
    pub field: String,
    pub kind: CellKind,
}

/// The columns of a table of models.
#[derive(Debug)]
pub(super) struct Columns {
    pub columns: Vec<Column>,
    /// Header of the column with the paths of the models.
    pub model: String,
}

impl Columns {
    /// Finds the meaning of each column. With `keeps_others`, a column that is not a field of a changing verb is the user's own.
    ///
    /// # Errors
    ///
    /// No column `model`, two columns of one meaning, a column whose name is nearly that of a field, or another unknown column without
    /// `keeps_others`.
    pub(super) fn from_header(header: &[String], keeps_others: bool) -> Result<Self, Phrase> {
        let known = fields();
        let has = |name: &str| header.iter().any(|cell| field_of_header(cell) == name);
        // Beside a column `model`, one of files is the user's own.
        let is_meaning = |name: &&str| *name != "model" || !has(name);
        let meaning = |cell| other_header(cell, &known).filter(is_meaning).unwrap_or(cell);
        let names: Vec<&str> = header.iter().map(|cell| meaning(cell)).collect();
        // In a table that says in no other column what happens to a model, `mass` can only be the target mass.
        let is_change =
            |name: &str| name == "verb" || VERBS_OF_COLUMNS.iter().any(|(column, _)| *column == name);
        let has_change = names.iter().any(|name| is_change(&field_of_header(name)));
        let mut columns: Vec<Column> = Vec::new();
        let mut wrong: Vec<Phrase> = Vec::new();
        for (cell, name) in header.iter().zip(names) {
            let is_target_mass = !has_change && field_of_header(name) == "mass";
            let name = if is_target_mass { Input::TargetMass.name() } else { name };
            let twice = |one: &Column, other: &Column| match one.kind {
                // Columns without a name are ignored.
                CellKind::UserColumn => !one.header.is_empty() && one.header == other.header,
                _ => (&one.field, one.kind) == (&other.field, other.kind),
            };
            match column(cell, name, &known, keeps_others) {
                Err(message) => wrong.push(message),
                Ok(one) => match columns.iter().find(|other| twice(&one, other)).map(|other| &other.header) {
                    Some(first) => wrong.push(
                        format!(
                            "the column '{cell}' appears twice, first as '{first}', expected one{WAY_OUT}"
                        )
                        .into(),
                    ),
                    None => columns.push(one),
                },
            }
        }
        if let Some(message) = Phrase::joined(wrong, "; ") {
            return Err(message);
        }
        let Some(model) = columns.iter().find(|column| column.kind == CellKind::Model) else {
            let cells: Vec<String> = header.iter().map(|cell| format!("'{cell}'")).collect();
            let has = if cells.is_empty() { "nothing".to_owned() } else { cells.join(", ") };
            let what = "it has to name the columns; call that of the files 'model' or 'file'";
            return Err(format!("no column 'model' in the first row, which has {has}: {what}").into());
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

    /// Headers of the columns that are neither fields nor marked by # as the user's own.
    pub(super) fn unmarked_user_columns(&self) -> Vec<String> {
        let own = self.columns.iter().filter(|column| column.kind == CellKind::UserColumn);
        own.map(|column| column.header.clone())
            .filter(|name| !name.is_empty() && !name.starts_with('#'))
            .collect()
    }

    /// The header of the column that gives a field.
    pub(super) fn header_of(&self, field: &str) -> Option<&str> {
        let column =
            self.columns.iter().find(|column| column.field == field && column.kind != CellKind::Model)?;
        Some(&column.header)
    }
}

/// The header as the name of a field: `target_mass` for `--Target-Mass`.
fn field_of_header(cell: &str) -> String {
    cell.strip_prefix("--").unwrap_or(cell).to_ascii_lowercase().replace('-', "_")
}

/// The field that a header means which is not its name: `target_mass` for `Target mass (kg)`, or the field's label on the page.
fn other_header<'k>(cell: &str, known: &'k BTreeMap<String, Option<CellKind>>) -> Option<&'k str> {
    if known.contains_key(&field_of_header(cell)) {
        return None;
    }
    let header = letters_of_header(cell);
    if OTHER_HEADERS_OF_MODEL.contains(&header.as_str()) {
        return Some("model");
    }
    let is_meant = |name: &str| spellings(name).contains(&header);
    known.iter().find(|(name, kind)| kind.is_some() && is_meant(name)).map(|(name, _)| name.as_str())
}

fn letters(text: &str) -> String {
    text.to_lowercase().replace([' ', '-', '_'], "")
}

/// The letters of a header without its unit.
fn letters_of_header(cell: &str) -> String {
    let header = letters(cell.split(['(', '[']).next().unwrap_or_default());
    header.strip_suffix("kg").unwrap_or(&header).to_owned()
}

/// The letters of a field's name, and of its label on the page.
fn spellings(name: &str) -> Vec<String> {
    [Some(name), Input::find(name).map(Input::label)].into_iter().flatten().map(letters).collect()
}

/// The column with the header `cell`, which means the header `name`.
fn column(
    cell: &str,
    name: &str,
    known: &BTreeMap<String, Option<CellKind>>,
    keeps_others: bool,
) -> Result<Column, Phrase> {
    // `model` is the model; the field of standalone sets, which has the same name, is written with two dashes before it.
    let dashes = name.starts_with("--");
    let field = field_of_header(name);
    let kind = match field.as_str() {
        _ if cell.is_empty() || cell.starts_with('#') => CellKind::UserColumn,
        "model" if !dashes => CellKind::Model,
        "verb" if !dashes => CellKind::Verb,
        "set" if !dashes => CellKind::Set,
        name => match known.get(name) {
            Some(Some(kind)) => {
                refuse_other_unit(cell, name)?;
                *kind
            }
            Some(None) => return Err(message_about_run_option(cell, name)),
            None => match did_you_mean(cell, known) {
                None if keeps_others => CellKind::UserColumn,
                hint => {
                    let (verbs, hint) = (changing_verbs(), hint.unwrap_or_default());
                    return Err(
                        format!("the column '{cell}' is not an option of {verbs}{WAY_OUT}{hint}").into()
                    );
                }
            },
        },
    };
    Ok(Column { header: cell.to_owned(), field, kind })
}

/// The spellings of the unit of options whose values the help calls `value_name`, the usual one first. Empty for numbers without a unit.
fn units_of(value_name: &str) -> &'static [&'static str] {
    match value_name {
        "KG" => &["kg", "kgs", "kilogram", "kilograms"],
        "METRES" | "RULE" => &["m", "metre", "metres", "meter", "meters"],
        "E" | "E1" | "N/M2" => &["N/m2", "Pa", "pascal", "pascals", "N m-2"],
        "N/M" => &["N/m", "N m-1"],
        "M/S" => &["m/s", "m s-1"],
        "G" => &["m/s2", "m s-2"],
        "S_PER_M" => &["s/m", "s m-1"],
        "PER_M" => &["1/m", "m-1", "/m"],
        "M2" => &["m2"],
        _ => &[],
    }
}

/// Refuses a header such as `Target mass (lb)`, with another unit than that of the option `field`.
fn refuse_other_unit(cell: &str, field: &str) -> Result<(), Phrase> {
    let Some((_, unit)) = cell.split_once(['(', '[']) else { return Ok(()) };
    let unit = unit.split([')', ']']).next().unwrap_or_default().trim_ascii();
    let spelled = |words: &str| words.to_lowercase().replace('²', "2").replace([' ', '^', '·'], "");
    // `in kg` is kg.
    let last = spelled(unit.split_ascii_whitespace().next_back().unwrap_or_default());
    let option = option_named(Verb::Rescale, field);
    let units = option.map(|option| units_of(option.value_name)).unwrap_or_default();
    let of_other = ["%", "percent", "mm", "cm", "in", "inch", "inches"].contains(&last.as_str());
    let is_of_option = units.iter().any(|one| [spelled(unit), last.clone()].contains(&spelled(one)));
    if is_of_option || (units.is_empty() && !of_other) {
        return Ok(());
    }
    let expected = units.first().copied().unwrap_or("a number without a unit");
    let what = format!("numbers are not converted, expected {expected}, not {unit}");
    Err(format!("the column '{cell}': {what}{WAY_OUT}").into())
}

/// The message that a column is an option of the whole run.
fn message_about_run_option(cell: &str, field: &str) -> Phrase {
    let about = format!("the column '{cell}' is about the whole run: write ");
    match Input::find(field) {
        Some(input) => phrase![about, input, " after the table's name", WAY_OUT],
        None => format!("{about}{field} after the table's name{WAY_OUT}").into(),
    }
}

/// The hint `: did you mean ...?` with the field that the user probably wanted to write as `cell`; `None` if no field is similar.
fn did_you_mean(cell: &str, known: &BTreeMap<String, Option<CellKind>>) -> Option<String> {
    // What is left of `body` and `bodies`.
    let stem = |word: &str| word.trim_end_matches(['y', 'i', 'e', 's']).to_owned();
    let header = letters_of_header(cell);
    // What a subject weighs is near to `body_map` and `body_right`.
    let is_option = ["bodymass", "bodyweight"].iter().all(|own| *own != header);
    // Short names are near to everything: `sex` to `yes`. Of four letters, all have to be in the option: `lvel`.
    let is_near = |spelling: &String| match strsim::osa_distance(spelling, &header) {
        1 if header.len() == 4 && header != "mode" => header.chars().all(|letter| spelling.contains(letter)),
        apart @ ..2 => apart + 3 < header.len(),
        apart => header.len() > 7 && (apart == 2 || stem(spelling) == stem(&header)),
    };
    let field = known.keys().find(|name| is_option && spellings(name).iter().any(is_near))?;
    // As an option of the command line, where the cell is spelled like one.
    let field = if cell.contains('-') { field.replace('_', "-") } else { field.clone() };
    Some(format!(": did you mean '{field}'?"))
}

/// The fields of all changing verbs, and how their cells are read. `None` marks fields of the whole run, which a row cannot set for itself.
fn fields() -> BTreeMap<String, Option<CellKind>> {
    let of_verb = |verb: Verb| {
        let names = silent_fields(verb).into_iter().map(|(name, _)| name);
        let named = names.filter(move |name| !["set", model_field(verb)].contains(&name.as_str()));
        named.filter_map(move |name| Some((name.clone(), kind_of_cells(&option_named(verb, &name)?))))
    };
    CHANGING.iter().copied().flat_map(of_verb).collect()
}

/// How cells give the value of an option; `None` for an option of the whole run.
fn kind_of_cells(option: &Entry) -> Option<CellKind> {
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

    fn columns_of(header: &[&str]) -> Result<Columns, Phrase> {
        Columns::from_header(&header.iter().map(|&cell| cell.to_owned()).collect::<Vec<_>>(), true)
    }

    #[test]
    fn a_column_that_is_misspelled_is_pointed_out() {
        let message = |header| columns_of(&["model", header]).unwrap_err().to_string();
        assert!(message("target-mas").contains("did you mean 'target-mass'?"));
        // As the reader writes names.
        assert!(message("target_mas").contains("did you mean 'target_mass'?"));
        assert!(message("stence_limbs").contains("did you mean 'stance_limbs'?"));
        // Also with a unit or blanks, with another ending, or like a label of the page.
        for header in ["Contact mass (kg)", "contact mass", "Contacts mas [kg]"] {
            assert!(message(header).contains("did you mean 'contacts_mass'?"), "{header}");
        }
        assert!(message("follow-body").contains("did you mean 'follow-bodies'?"));
        assert!(message("lvel").contains("did you mean 'level'?"));
        assert!(message("form").contains("did you mean 'from'?"));
        assert!(message("sphere follow their bodies").contains("did you mean 'follow_bodies'?"));
    }

    #[test]
    fn common_headers_are_understood() {
        let fields = |header: &[&str]| {
            let columns = columns_of(header).unwrap().columns;
            columns.into_iter().map(|column| column.field).collect::<Vec<_>>()
        };
        for model in ["file", "Path", "File name", "model_file"] {
            assert_eq!(fields(&[model, "Target mass (kg)"]), ["model", "target_mass"]);
        }
        for mass in ["TargetMass", "target mass", "target_mass_kg", "Target mass [kg]", "mass"] {
            assert_eq!(fields(&["model", mass]), ["model", "target_mass"], "{mass}");
        }
        // What the model weighs, where another column says what to do; and a file beside the model.
        assert_eq!(fields(&["model", "from", "mass", "file"]), ["model", "from", "mass", "file"]);
        assert_eq!(columns_of(&["model", "from", "file"]).unwrap().unmarked_user_columns(), ["file"]);
        assert_eq!(fields(&["model", "spheres follow their bodies"]), ["model", "follow_bodies"]);
    }

    #[test]
    fn a_column_in_another_unit_is_refused() {
        for (header, expected) in [
            ("mass (lb)", "kg"),
            ("mass [g]", "kg"),
            ("Contacts mass (stone)", "kg"),
            ("mass (N)", "kg"),
            ("radius (in mm)", "m"),
            ("stiffness (MPa)", "N/m2"),
            ("young [GPa]", "N/m2"),
            ("contact-stiffness (N/mm)", "N/m"),
            ("transition velocity (mm/s)", "m/s"),
            ("gravity (g)", "m/s2"),
            ("hertz_smoothing (1/mm)", "1/m"),
            ("static-friction (%)", "a number without a unit"),
        ] {
            let message = columns_of(&["model", header]).unwrap_err().to_string();
            let expected = format!("numbers are not converted, expected {expected}, not ");
            assert!(message.contains(&expected), "{header}: {message}");
        }
        let right = ["model", "stiffness (in Pa)", "young [N / m^2]", "gravity (m/s²)", "poisson (-)"];
        assert!(columns_of(&right).is_ok());
        assert!(columns_of(&["model", "Target mass (KG)", "radius [m]", "weight (lb)"]).is_ok());
        assert!(columns_of(&["model", "mass (in kg)", "Contacts mass [kilograms]", "radius (in m)"]).is_ok());
    }

    #[test]
    fn other_columns_are_the_users_own() {
        let header = ["model", "subject", "age", "sex", "height", "site", "#group", "target-mass"];
        let columns = columns_of(&header).unwrap();
        assert_eq!(columns.unmarked_user_columns(), ["subject", "age", "sex", "height", "site"]);
        for own in ["Body mass (kg)", "body_weight", "weight", "original mass", "mode", "name", "date"] {
            assert_eq!(columns_of(&["model", own]).unwrap().unmarked_user_columns(), [own]);
        }
        let header = header.map(str::to_owned);
        assert!(
            Columns::from_header(&header, false)
                .unwrap_err()
                .to_string()
                .contains("'age' is not an option of")
        );
    }

    #[test]
    fn two_columns_of_one_meaning_are_refused() {
        for (one, other) in [("target-mass", "Target mass (kg)"), ("mass", "Mass (kg)"), ("level", "Level")] {
            let message = columns_of(&["model", one, other]).unwrap_err().to_string();
            assert!(message.contains(&format!("'{other}' appears twice, first as '{one}'")), "{message}");
            assert!(message.contains("begins with # is carried along"), "{message}");
            assert!(columns_of(&["model", one, &format!("#{other}")]).is_ok());
        }
    }

    #[test]
    fn user_columns_of_one_name_are_refused_and_nameless_columns_are_not() {
        let message = columns_of(&["model", "#sex", "mass", "#sex"]).unwrap_err().to_string();
        assert!(message.contains("the column '#sex' appears twice"), "{message}");
        assert!(columns_of(&["model", "", "#sex", "", "#age"]).is_ok());
    }

    #[test]
    fn all_columns_that_are_wrong_are_named_at_once() {
        let header =
            ["subject", "model", "target-mas", "age", "mass", "mass", "jobs", "#sex"].map(str::to_owned);
        let message = Columns::from_header(&header, false).unwrap_err().to_string();
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
