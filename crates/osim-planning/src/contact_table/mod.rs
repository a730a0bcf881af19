//! Contacts from a table: their names, bodies, places and radii.

mod place;

use std::collections::HashMap;
use std::fmt::Display;

use osim_model::refuse_name;

use crate::sheet::{Row, Sheet};
pub use place::{PlaceFault, PlaceOnBody, TablePlace};

/// A fault in a table of contacts, with the line in the table.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{}{message}", .line.map(|line| format!("line {line}: ")).unwrap_or_default())]
pub struct TableFault {
    /// Line in the file; `None` if the fault is not about one line.
    pub line: Option<u64>,
    /// Column, counted from 1; `None` if the fault is not about one column.
    pub column: Option<usize>,
    /// The message, with the name of the column and without the line.
    pub message: String,
}

impl TableFault {
    /// A fault in the header of one column.
    fn of_header(index: usize, message: String) -> Self {
        Self { line: Some(1), column: Some(index + 1), message }
    }
}

/// No coordinate and no radius may be larger than this, m.
const LARGEST_LENGTH_M: f64 = 1e9;
/// The text that MuSkeMo writes for the body of a contact that has no body.
const NO_BODY: &str = "not_assigned";

/// The contacts of a table with the columns `name`, `body`, `x`, `y`, `z` (in the body's frame) and optionally `radius`, all in metres; or
/// of a table that MuSkeMo exported.
///
/// ```
/// use osim_planning::contact_table::{ContactTable, TablePlace};
///
/// let table = ContactTable::read(b"body,name,x,y,z,radius [m]\ncalcn_r,heel_r,0.02,-0.01,0,0.03\n")?;
/// let heel = &table.rows[0];
/// assert_eq!((heel.name.as_str(), heel.body.as_str(), heel.radius_m), ("heel_r", "calcn_r", Some(0.03)));
/// assert_eq!(heel.place, TablePlace::OfBody([0.02, -0.01, 0.0]));
/// # Ok::<(), osim_planning::contact_table::TableFault>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct ContactTable {
    pub rows: Vec<ContactRow>,
    /// Whether the table has a column of radii. If it has, each row has a radius.
    pub has_radii: bool,
}

/// One contact in a table of contacts.
#[derive(Debug, Clone, PartialEq)]
pub struct ContactRow {
    /// Line in the file of the table; the header is line 1.
    pub line: u64,
    /// Name of the new sphere in this row of the table.
    pub name: String,
    /// Name of the body that carries the sphere.
    pub body: String,
    pub place: TablePlace,
    /// Radius of the sphere, m, if the table has radii.
    pub radius_m: Option<f64>,
}

impl ContactTable {
    /// Reads a whole table of contacts.
    ///
    /// # Errors
    /// The first thing that is wrong: a column that is missing or not known, a cell that is not what it should be, a name that
    /// OpenSim refuses or that appears twice, or no rows.
    pub fn read(bytes: &[u8]) -> Result<Self, TableFault> {
        let whole = |message| TableFault { line: None, column: None, message };
        let sheet = Sheet::read(bytes).map_err(whole)?;
        let columns = ContactColumns::from_header(&sheet)?;
        let mut lines: HashMap<String, u64> = HashMap::new();
        let mut rows = Vec::new();
        for row in &sheet.rows {
            let cells = ContactCells { sheet: &sheet, row };
            let row = cells.read_contact(&columns)?;
            if let Some(first) = lines.insert(row.name.clone(), row.line) {
                let message =
                    format!("the name '{}' is in line {first} already: each contact needs its own", row.name);
                return Err(cells.fault_at(columns.name, message));
            }
            rows.push(row);
        }
        if rows.is_empty() {
            return Err(whole("there are no rows below the first one: give each contact a row".to_owned()));
        }
        Ok(Self { rows, has_radii: columns.radius.is_some() })
    }
}

/// The cells of one row of a table of contacts.
struct ContactCells<'s> {
    sheet: &'s Sheet,
    row: &'s Row,
}

impl ContactCells<'_> {
    /// Reads the contact of this row.
    fn read_contact(&self, columns: &ContactColumns) -> Result<ContactRow, TableFault> {
        let name = self.cell_text(columns.name);
        refuse_name(name).map_err(|fault| self.fault_at(columns.name, fault.phrase()))?;
        let body = self.cell_text(columns.body);
        if body.is_empty() || body.eq_ignore_ascii_case(NO_BODY) {
            let message = match body {
                "" => format!("the cell is empty: name the body that carries {name}"),
                body => format!("'{body}' is not a body: name the body that carries {name}"),
            };
            return Err(self.fault_at(columns.body, message));
        }
        let place = match columns.of_body {
            Some(columns_of_body) => TablePlace::OfBody(self.read_place(columns_of_body)?),
            None => {
                let triple = |columns: Option<[usize; 3]>| {
                    columns.map_or(Ok(None), |columns_of_body| self.optional_place(columns_of_body))
                };
                TablePlace::Exported { global_m: triple(columns.global)?, local_m: triple(columns.local)? }
            }
        };
        if let TablePlace::Exported { global_m: None, local_m: None } = place {
            let first = columns.local.or(columns.global).map_or(columns.name, |[x, ..]| x);
            return Err(self.fault_at(first, format!("{name} has no position, neither global nor local")));
        }
        let radius_m = columns.radius.map(|column| self.read_radius(column)).transpose()?;
        Ok(ContactRow { line: self.row.line, name: name.to_owned(), body: body.to_owned(), place, radius_m })
    }

    fn read_radius(&self, column: usize) -> Result<f64, TableFault> {
        let radius = self.read_number(column)?;
        let why = format!("'{}' is not a radius, expected metres above 0", self.cell_text(column));
        if radius > 0.0 { Ok(radius) } else { Err(self.fault_at(column, why)) }
    }

    fn read_place(&self, [x, y, z]: [usize; 3]) -> Result<[f64; 3], TableFault> {
        Ok([self.read_number(x)?, self.read_number(y)?, self.read_number(z)?])
    }

    /// Three numbers from the cells of the `columns`; `None` if all three cells are empty or nan.
    fn optional_place(&self, columns: [usize; 3]) -> Result<Option<[f64; 3]>, TableFault> {
        let is_blank = |&column: &usize| {
            self.cell_text(column).is_empty() || self.cell_text(column).eq_ignore_ascii_case("nan")
        };
        if columns.iter().all(is_blank) { Ok(None) } else { self.read_place(columns).map(Some) }
    }

    fn read_number(&self, column: usize) -> Result<f64, TableFault> {
        let cell = self.cell_text(column);
        if cell.is_empty() {
            return Err(self.fault_at(column, "the cell is empty, expected a number"));
        }
        match self.sheet.number(cell) {
            Ok(value) if value.abs() <= LARGEST_LENGTH_M => Ok(value),
            Ok(_) => Err(self.fault_at(column, format!("'{cell}' is beyond 1e9, expected metres"))),
            Err(why) => Err(self.fault_at(column, format!("'{cell}' {why}"))),
        }
    }

    fn cell_text(&self, column: usize) -> &str {
        self.row.cells.get(column).map_or("", String::as_str)
    }

    fn fault_at(&self, column: usize, message: impl Display) -> TableFault {
        let line = self.row.line;
        let header = self.sheet.header.get(column).map_or("", String::as_str);
        let message = format!("column '{header}': {message}");
        TableFault { line: Some(line), column: Some(column + 1), message }
    }
}

/// The meaning of a column of the table.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum ColumnMeaning {
    Name,
    Body,
    Radius,
    /// A coordinate (0 for x, 1 for y, 2 for z) in the frame of the body.
    OfBody(usize),
    /// A coordinate in MuSkeMo's local frame. It is only a number if the contact has a local frame.
    Local(usize),
    /// A coordinate x, y or z in MuSkeMo's global frame.
    Global(usize),
    /// A column that is not used, for example because its name begins with #.
    Ignored,
}

/// Names of columns without their unit, in small letters: the names for users' own tables, then those in tables that MuSkeMo exports.
const COLUMN_MEANINGS: [(&str, ColumnMeaning); 15] = [
    ("name", ColumnMeaning::Name),
    ("body", ColumnMeaning::Body),
    ("x", ColumnMeaning::OfBody(0)),
    ("y", ColumnMeaning::OfBody(1)),
    ("z", ColumnMeaning::OfBody(2)),
    ("radius", ColumnMeaning::Radius),
    ("contact_name", ColumnMeaning::Name),
    ("parent_body", ColumnMeaning::Body),
    ("pos_x_in_global", ColumnMeaning::Global(0)),
    ("pos_y_in_global", ColumnMeaning::Global(1)),
    ("pos_z_in_global", ColumnMeaning::Global(2)),
    ("pos_x_in_local", ColumnMeaning::Local(0)),
    ("pos_y_in_local", ColumnMeaning::Local(1)),
    ("pos_z_in_local", ColumnMeaning::Local(2)),
    ("parent_frame_name", ColumnMeaning::Ignored),
];
/// The columns that a table of contacts may have, for error messages.
const EXPECTED_COLUMNS: &str =
    "name, body, x, y, z and radius (columns whose names begin with # are ignored), or MuSkeMo's own";

/// The indices of the columns that a table of contacts has.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct ContactColumns {
    name: usize,
    body: usize,
    radius: Option<usize>,
    of_body: Option<[usize; 3]>,
    local: Option<[usize; 3]>,
    global: Option<[usize; 3]>,
}

impl ContactColumns {
    /// Finds the columns in the header.
    ///
    /// # Errors
    ///
    /// A column that is missing, appears twice or is not known, or a column in another unit than metres.
    fn from_header(sheet: &Sheet) -> Result<Self, TableFault> {
        let mut used_columns: Vec<(ColumnMeaning, usize)> = Vec::new();
        for (index, header) in sheet.header.iter().enumerate() {
            let column_meaning =
                column_meaning(header).map_err(|message| TableFault::of_header(index, message))?;
            if column_meaning == ColumnMeaning::Ignored {
                continue;
            }
            if let Some((_, first)) = used_columns.iter().find(|(known, _)| *known == column_meaning) {
                let other = sheet.header.get(*first).map_or("", String::as_str);
                let message = format!("the columns '{other}' and '{header}' mean the same: leave one out");
                return Err(TableFault::of_header(index, message));
            }
            used_columns.push((column_meaning, index));
        }
        let at = |column_meaning: ColumnMeaning| {
            used_columns.iter().find(|(known, _)| *known == column_meaning).map(|(_, index)| *index)
        };
        let missing = |what: &str| {
            let known = sheet.listed_columns();
            TableFault::of_header(0, format!("no column '{what}' in the first row, which has {known}"))
        };
        let triple = |column_meaning: fn(usize) -> ColumnMeaning, name: fn(&str) -> String| match [0, 1, 2]
            .map(|axis| at(column_meaning(axis)))
        {
            [None, None, None] => Ok(None),
            [Some(x), Some(y), Some(z)] => Ok(Some([x, y, z])),
            [None, ..] => Err(missing(&name("x"))),
            [_, None, _] => Err(missing(&name("y"))),
            _ => Err(missing(&name("z"))),
        };
        let columns = Self {
            name: at(ColumnMeaning::Name).ok_or_else(|| missing("name"))?,
            body: at(ColumnMeaning::Body).ok_or_else(|| missing("body"))?,
            radius: at(ColumnMeaning::Radius),
            of_body: triple(ColumnMeaning::OfBody, str::to_owned)?,
            local: triple(ColumnMeaning::Local, |axis| format!("pos_{axis}_in_local"))?,
            global: triple(ColumnMeaning::Global, |axis| format!("pos_{axis}_in_global"))?,
        };
        match (columns.of_body, columns.local.or(columns.global)) {
            (None, None) => Err(missing("x")),
            (Some(_), Some([other, ..])) => {
                let message = "there are the columns x, y, z and those of MuSkeMo: leave one kind out";
                Err(TableFault::of_header(other, message.to_owned()))
            }
            _ => Ok(columns),
        }
    }
}

/// What the header of a column means; an error for an unknown header.
fn column_meaning(header: &str) -> Result<ColumnMeaning, String> {
    if header.is_empty() || header.starts_with('#') {
        return Ok(ColumnMeaning::Ignored);
    }
    let lower = header.to_ascii_lowercase();
    let (name, unit) = without_unit(&lower);
    let Some((_, column_meaning)) = COLUMN_MEANINGS.iter().find(|(known, _)| *known == name) else {
        return Err(format!("the column '{header}' is not known, expected {EXPECTED_COLUMNS}"));
    };
    match unit {
        None | Some("m") => Ok(*column_meaning),
        Some(_) => Err(format!(
            "the column '{header}' is not in metres: write its numbers in metres, and [m] or no unit"
        )),
    }
}

/// Splits the header of a column into name and unit: `radius [m]` and `radius(m)` into `radius` and `m`.
fn without_unit(header: &str) -> (&str, Option<&str>) {
    for (open, close) in [('(', ')'), ('[', ']')] {
        let parts = header.strip_suffix(close).and_then(|rest| rest.split_once(open));
        if let Some((name, unit)) = parts {
            return (name.trim_ascii_end(), Some(unit.trim_ascii()));
        }
    }
    (header, None)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn assert_refused(text: &str, line: Option<u64>, column: Option<usize>, says: &str) {
        let fault = ContactTable::read(text.as_bytes()).unwrap_err();
        assert_eq!((fault.line, fault.column), (line, column), "{fault}");
        assert!(fault.message.contains(says), "{fault}");
    }

    #[test]
    fn columns_may_be_in_any_order_and_separated_as_spreadsheets_do() {
        let commas = ContactTable::read(b"z,y,x,#who,name,body\n0.3,0.2,0.1,me,heel_r,calcn_r\n").unwrap();
        let semicolons =
            ContactTable::read(b"\xEF\xBB\xBFNAME;Body;X [m];y(m);z\r\nheel_r;calcn_r;0,1;0,2;0,3\r\n");
        let heel = &commas.rows[0];
        assert_eq!((heel.line, &heel.place), (2, &TablePlace::OfBody([0.1, 0.2, 0.3])));
        assert_eq!(commas, semicolons.unwrap());
        assert!(!commas.has_radii);
    }

    #[test]
    fn an_export_of_muskemo_is_read_unchanged() {
        let header = "CONTACT_name,pos_x_in_global(m),pos_y_in_global,pos_z_in_global,parent_body,parent_frame_name,\
                  pos_x_in_local(m),pos_y_in_local,pos_z_in_local\n";
        let table =
            format!("{header}a,1,2,3,foot,not_assigned,nan,nan,nan\nb,1,2,3,foot,frame,0.1,0.2,0.3\n");
        let table = ContactTable::read(table.as_bytes()).unwrap();
        let places: Vec<_> = table.rows.iter().map(|row| row.place.clone()).collect();
        let global_m = Some([1.0, 2.0, 3.0]);
        assert_eq!(places[0], TablePlace::Exported { global_m, local_m: None });
        assert_eq!(places[1], TablePlace::Exported { global_m, local_m: Some([0.1, 0.2, 0.3]) });
        assert_refused(
            &format!("{header}a,1,2,3,not_assigned,x,nan,nan,nan\n"),
            Some(2),
            Some(5),
            "is not a body",
        );
        assert_refused(
            &format!("{header}a,1,2,3,foot,x,0.1,nan,0.3\n"),
            Some(2),
            Some(8),
            "'nan' is not finite",
        );
        assert_refused(&format!("{header}a,nan,nan,nan,foot,x,,,\n"), Some(2), Some(7), "a has no position");
    }

    #[test]
    fn a_fault_names_its_line_and_column() {
        assert_refused("name,body,x,y\na,foot,1,2\n", Some(1), Some(1), "no column 'z'");
        assert_refused("name,body,x,y,z,radus\na,foot,1,2,3,4\n", Some(1), Some(6), "'radus' is not known");
        assert_refused("name,body,x,y,z,radius [mm]\na,foot,1,2,3,4\n", Some(1), Some(6), "not in metres");
        assert_refused("name,body,x,X,y,z\na,foot,1,1,2,3\n", Some(1), Some(4), "mean the same");
        assert_refused(
            "name,body,x,y,z,pos_x_in_local,pos_y_in_local,pos_z_in_local\n",
            Some(1),
            Some(6),
            "leave one kind out",
        );
        assert_refused(
            "name,body,x,y,z\na,foot,1,O,3\n",
            Some(2),
            Some(4),
            "column 'y': 'O' is not a number",
        );
        assert_refused(
            "name,body,x,y,z,radius\na,foot,1,2,3,0\n",
            Some(2),
            Some(6),
            "expected metres above 0",
        );
        assert_refused(
            "name,body,x,y,z,radius\na,foot,1,2,3,\n",
            Some(2),
            Some(6),
            "the cell is empty, expected",
        );
        assert_refused("name,body,x,y,z\na,,1,2,3\n", Some(2), Some(2), "the cell is empty: name the body");
        assert_refused(
            "name,body,x,y,z\nleft heel,foot,1,2,3\n",
            Some(2),
            Some(1),
            "with which OpenSim refuses",
        );
        for name in [".", ".."] {
            let table = format!("name,body,x,y,z\n{name},foot,1,2,3\n");
            assert_refused(&table, Some(2), Some(1), "is a step in OpenSim's paths");
        }
        // ESC, an override of direction, a no-break space, and a letter that is not there.
        for (letter, number) in
            [('\u{1b}', "U+001B"), ('\u{202e}', "U+202E"), ('\u{a0}', "U+00A0"), ('\u{200b}', "U+200B")]
        {
            assert_refused(&format!("name,body,x,y,z\nheel{letter}r,foot,1,2,3\n"), Some(2), Some(1), number);
        }
        for number in ["1e308", "-1.1e9"] {
            let table = format!("name,body,x,y,z,radius\na,foot,1,{number},3,0.1\n");
            assert_refused(&table, Some(2), Some(4), "is beyond 1e9, expected metres");
        }
        assert_refused("name,body,x,y,z,radius\na,foot,1,2,3,2e9\n", Some(2), Some(6), "is beyond 1e9");
        assert_refused(
            "name,body,x,y,z\na,foot,1,2,3\na,foot,1,2,4\n",
            Some(3),
            Some(1),
            "in line 2 already",
        );
        assert_refused("name,body,x,y,z\n", None, None, "no rows");
        assert_refused("name,body,x,y,z\n,,,,\n,,,,\n", None, None, "no rows");
        assert_refused("name,body,x,y,z\na,foot,1,2\n", None, None, "line 2: 4 cells");
    }
}
