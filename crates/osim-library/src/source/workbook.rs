//! Excel's own .xlsx as the CSV that every table is read from: the first sheet, whose first row names the columns.

use std::io::Cursor;

use calamine::{CellErrorType, Data, Range, Reader, Xlsx};
use osim_messages::shortest;
use osim_model::files::FileError;

/// How .xlsx begins, as every packed file does.
const PACKED: &[u8] = b"PK\x03\x04";

/// What a file holds: the first sheet of a workbook as CSV, anything else as it is.
///
/// # Errors
/// A cell that is neither a number nor a text, or a broken formula: which.
pub(super) fn as_table(bytes: Vec<u8>) -> Result<Vec<u8>, FileError> {
    if !bytes.starts_with(PACKED) {
        return Ok(bytes);
    }
    // What is no workbook is refused by those who read it, in their words.
    let Ok(mut book) = Xlsx::new(Cursor::new(bytes.as_slice())) else { return Ok(bytes) };
    let Some(Ok(sheet)) = book.worksheet_range_at(0) else {
        return Err(FileError::new(
            "the first sheet of this workbook cannot be read: save it as CSV in UTF-8",
        ));
    };
    csv_of(&sheet)
}

fn csv_of(sheet: &Range<Data>) -> Result<Vec<u8>, FileError> {
    let failed = |error: &dyn std::fmt::Display| FileError::new(error.to_string());
    let (first_row, first_column) = sheet.start().unwrap_or_default();
    let mut writer = csv::Writer::from_writer(Vec::new());
    for (row, cells) in (first_row..).zip(sheet.rows()) {
        let text = |(column, cell)| text_of(cell).map_err(|why| refused(row, column, &why));
        let mut texts = (first_column..).zip(cells).map(text).collect::<Result<Vec<String>, FileError>>()?;
        if row == first_row {
            // Otherwise they would be taken for what separates the cells.
            texts.iter_mut().for_each(|heading| *heading = heading.replace([';', '\t'], " "));
        }
        writer.write_record(texts).map_err(|error| failed(&error))?;
    }
    writer.into_inner().map_err(|error| failed(&error))
}

/// A cell as its value reads as text.
///
/// # Errors
/// What is wrong with it, to be read after its name.
fn text_of(cell: &Data) -> Result<String, String> {
    match cell {
        Data::Empty => Ok(String::new()),
        // A line end would begin another line of the table.
        Data::String(text) => Ok(text.replace(['\r', '\n'], " ")),
        Data::Float(number) => Ok(shortest(*number)),
        Data::Int(number) => Ok(number.to_string()),
        Data::Error(error) => Err(format!("({}) {}", name_of(error), osim_planning::sheet::BROKEN_FORMULA)),
        Data::Bool(_) => Err("is true or false, expected a number or a text".to_owned()),
        _ => {
            Err("is a date or a time, expected a number or a text: give its column the format Text or Number"
                .to_owned())
        }
    }
}

fn name_of(error: &CellErrorType) -> &'static str {
    match error {
        CellErrorType::Div0 => "#DIV/0!",
        CellErrorType::NA => "#N/A",
        CellErrorType::Name => "#NAME?",
        CellErrorType::Null => "#NULL!",
        CellErrorType::Num => "#NUM!",
        CellErrorType::Ref => "#REF!",
        CellErrorType::Value => "#VALUE!",
        _ => "an error",
    }
}

/// The cell by the name that spreadsheets give it, such as `B3`.
fn refused(row: u32, column: u32, why: &str) -> FileError {
    FileError::new(format!("cell {}{} {why}", letters(column), row + 1))
}

/// A column as letters: A to Z, then AA and so on.
fn letters(column: u32) -> String {
    let last = char::from(b'A' + u8::try_from(column % 26).unwrap_or_default());
    match (column / 26).checked_sub(1) {
        Some(before) => format!("{}{last}", letters(before)),
        None => last.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_have_the_letters_of_spreadsheets() {
        let named = [0, 25, 26, 51, 52, 701, 702].map(letters);
        assert_eq!(named, ["A", "Z", "AA", "AZ", "BA", "ZZ", "AAA"]);
    }

    #[test]
    fn what_is_no_workbook_stays_as_it_is() {
        for bytes in [b"a,b\n1,2\n".as_slice(), b"PK\x03\x04", b"PK\x03\x04 and more"] {
            assert_eq!(as_table(bytes.to_vec()).unwrap(), bytes);
        }
    }
}
