//! Converts Excel's .xlsx to CSV: the first sheet, whose first row names the columns.

use std::collections::BTreeMap;
use std::io::{BufReader, Cursor};

use calamine::{CellErrorType, Data, Reader, Xlsx};
use osim_model::files::FileError;
use osim_model::messages::{shortest, shown};
use quick_xml::events::Event;
use zip::ZipArchive;

/// The first bytes of an .xlsx file, as of every ZIP archive.
const ZIP_SIGNATURE: &[u8] = b"PK\x03\x04";

/// Most rows of a sheet in Excel.
const MOST_ROWS: u32 = 1_048_576;
/// Most columns of a sheet in Excel.
const MOST_COLUMNS: u32 = 16_384;
/// Most digits of the row in the reference of a cell.
const MOST_ROW_DIGITS: usize = 7;
/// Most letters of the column in the reference of a cell.
const MOST_COLUMN_LETTERS: usize = 3;
/// Most cells in the smallest rectangle around all filled cells of a sheet.
const MOST_CELLS: usize = 10_000_000;

/// The first sheet of a workbook as CSV; other bytes are returned unchanged.
///
/// # Errors
/// A cell is neither a number nor a text, or is a broken formula.
pub fn workbook_as_csv(bytes: Vec<u8>) -> Result<Vec<u8>, FileError> {
    if !bytes.starts_with(ZIP_SIGNATURE) {
        return Ok(bytes);
    }
    // Bytes that are not a workbook are refused later, by the reader of the table.
    let Ok(mut book) = Xlsx::new(Cursor::new(bytes.as_slice())) else { return Ok(bytes) };
    refuse_overflowing_references(&bytes)?;
    csv_of_rows(&rows_of_first_sheet(&mut book)?)
}

/// Refuses references of rows and cells with more letters or digits than any sheet has: calamine computes them modulo 2^32, so that a
/// cell would count as another one.
fn refuse_overflowing_references(bytes: &[u8]) -> Result<(), FileError> {
    let Ok(mut archive) = ZipArchive::new(Cursor::new(bytes)) else { return Ok(()) };
    for index in 0..archive.len() {
        let Ok(file) = archive.by_index(index) else { continue };
        // A workbook may have its sheets in any folder.
        if !file.name().is_ok_and(|name| name.ends_with(".xml")) {
            continue;
        }
        let (mut reader, mut buffer) = (quick_xml::Reader::from_reader(BufReader::new(file)), Vec::new());
        // A sheet that is not XML is refused where its cells are read.
        while let Ok(event) = reader.read_event_into(&mut buffer) {
            match event {
                Event::Start(tag) | Event::Empty(tag)
                    if ["c", "row"].contains(&tag.local_name().as_ref()) =>
                {
                    let reference = tag.try_get_attribute("r").ok().flatten();
                    let reference = reference.map(|found| found.value).unwrap_or_default();
                    let digits = reference.bytes().filter(u8::is_ascii_digit).count();
                    if digits > MOST_ROW_DIGITS || reference.len() - digits > MOST_COLUMN_LETTERS {
                        return Err(FileError::new(format!(
                            "a sheet of this workbook has a cell or row '{}', and the last cell of a sheet is XFD1048576: save it \
                             again in a spreadsheet program",
                            shown(&reference)
                        )));
                    }
                }
                Event::Eof => break,
                _ => {}
            }
            buffer.clear();
        }
    }
    Ok(())
}

/// The texts of each row by the numbers of their columns. Cells are read one by one, because a broken file may claim any size.
type CellTextsByRow = BTreeMap<u32, BTreeMap<u32, String>>;

/// The cells of the first sheet as text, row by row.
fn rows_of_first_sheet(book: &mut Xlsx<Cursor<&[u8]>>) -> Result<CellTextsByRow, FileError> {
    let broken =
        || FileError::new("the first sheet of this workbook cannot be read: save it as CSV in UTF-8");
    let name = book.sheet_names().into_iter().next().ok_or_else(broken)?;
    let mut cells = book.worksheet_cells_reader(&name).map_err(|_| broken())?;
    let mut rows = CellTextsByRow::new();
    while let Some(cell) = cells.next_cell().map_err(|_| broken())? {
        let (row, column) = cell.get_position();
        if row >= MOST_ROWS || column >= MOST_COLUMNS {
            return Err(broken());
        }
        let text = text_of_cell(&Data::from(cell.get_value().clone()))
            .map_err(|why| FileError::new(format!("cell {}{} {why}", column_letters(column), row + 1)))?;
        if !text.is_empty() {
            rows.entry(row).or_default().insert(column, text);
        }
    }
    Ok(rows)
}

/// The rows as CSV. Empty rows stay, so that each line has the number of its row.
fn csv_of_rows(rows: &CellTextsByRow) -> Result<Vec<u8>, FileError> {
    let failed = |error: &dyn std::fmt::Display| FileError::new(error.to_string());
    let columns = || rows.values().flat_map(BTreeMap::keys).copied();
    let (Some(first), Some(last)) = (columns().min(), columns().max()) else { return Ok(Vec::new()) };
    if rows.len().saturating_mul((last - first) as usize) > MOST_CELLS {
        return Err(FileError::new(
            "the first sheet of this workbook has more than ten million cells: keep only the table in it",
        ));
    }
    let mut writer = csv::Writer::from_writer(Vec::new());
    let mut line = 0;
    for (at, (&row, texts)) in rows.iter().enumerate() {
        if row > line {
            let mut out = writer.into_inner().map_err(|error| failed(&error))?;
            out.extend(std::iter::repeat_n(b'\n', (row - line) as usize));
            writer = csv::Writer::from_writer(out);
        }
        line = row + 1;
        let cells = (first..=last).map(|column| texts.get(&column).map_or("", String::as_str));
        let written = match at {
            // These characters in a heading would be taken for the mark between cells.
            0 => writer.write_record(cells.map(|heading| heading.replace([';', '\t'], " "))),
            _ => writer.write_record(cells),
        };
        written.map_err(|error| failed(&error))?;
    }
    writer.into_inner().map_err(|error| failed(&error))
}

/// The value of a cell as text.
///
/// # Errors
/// The fault of the cell, as the end of a sentence that begins with the name of the cell.
fn text_of_cell(cell: &Data) -> Result<String, String> {
    match cell {
        Data::Empty => Ok(String::new()),
        // A line end would begin another line of the table.
        Data::String(text) => Ok(text.replace(['\r', '\n'], " ")),
        Data::Float(number) => Ok(shortest(*number)),
        Data::Int(number) => Ok(number.to_string()),
        Data::Error(error) => {
            Err(format!("({}) {}", name_of_error(error), osim_planning::sheet::BROKEN_FORMULA_MESSAGE))
        }
        Data::Bool(_) => Err("is true or false, expected a number or a text, such as yes".to_owned()),
        _ => {
            Err("is a date or a time, expected a number or a text: give its column the format Text or Number"
                .to_owned())
        }
    }
}

/// What a spreadsheet shows for a formula without a value.
fn name_of_error(error: &CellErrorType) -> &'static str {
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

/// A column as letters: A to Z, then AA and so on.
fn column_letters(column: u32) -> String {
    let last = char::from(b'A' + u8::try_from(column % 26).unwrap_or_default());
    let before = (column / 26).checked_sub(1).map(column_letters).unwrap_or_default();
    format!("{before}{last}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_have_the_letters_of_spreadsheets() {
        let named = [0, 25, 26, 51, 52, 701, 702].map(column_letters);
        assert_eq!(named, ["A", "Z", "AA", "AZ", "BA", "ZZ", "AAA"]);
    }

    #[test]
    fn rows_keep_their_numbers_and_cells_their_columns() {
        let cells = |row: u32, texts: &[(u32, &str)]| {
            (row, texts.iter().map(|&(column, text)| (column, text.to_owned())).collect())
        };
        let rows = CellTextsByRow::from([cells(1, &[(2, "a;b"), (3, "c")]), cells(4, &[(3, "d;e")])]);
        assert_eq!(String::from_utf8(csv_of_rows(&rows).unwrap()).unwrap(), "\na b,c\n\n\n,d;e\n");
        assert_eq!(csv_of_rows(&CellTextsByRow::new()).unwrap(), b"");
        let far = CellTextsByRow::from_iter((0..=MOST_ROWS / 2).map(|row| cells(row, &[(row % 100, "a")])));
        assert!(csv_of_rows(&far).unwrap_err().to_string().contains("ten million cells"));
    }

    #[test]
    fn bytes_that_are_not_a_workbook_are_unchanged() {
        for bytes in [b"a,b\n1,2\n".as_slice(), b"PK\x03\x04", b"PK\x03\x04 and more"] {
            assert_eq!(workbook_as_csv(bytes.to_vec()).unwrap(), bytes);
        }
    }
}
