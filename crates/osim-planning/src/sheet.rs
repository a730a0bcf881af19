//! Reads and writes CSV tables, with decimal points or commas. A cell is written in one line, without control characters, and so that no
//! spreadsheet takes it for a formula.

use std::borrow::Cow;

use osim_model::messages::{counted, is_visible};
use osim_requests::values::typed_numbers::trimmed;

/// The bytes that some programs write before a CSV file in UTF-8.
const BYTE_ORDER_MARK: &[u8] = b"\xEF\xBB\xBF";
/// The first bytes of .xlsx and .ods files.
const ZIP_SIGNATURE: &[u8] = b"PK\x03\x04";

/// A table with a header.
///
/// ```
/// use osim_planning::sheet::Sheet;
///
/// let sheet = Sheet::read(b"body;x\r\ncalcn_r;0,05\r\n")?;
/// assert_eq!((sheet.column("X")?, sheet.number("0,05")?), (1, 0.05));
/// # Ok::<(), String>(())
/// ```
#[derive(Debug, Clone)]
pub struct Sheet {
    pub header: Vec<String>,
    pub rows: Vec<Row>,
    delimiter: u8,
    /// Whether numbers have decimal commas: semicolons separate the cells, or a number has a comma.
    pub decimal_commas: bool,
}

/// A row of cells, as many as the header has.
#[derive(Debug, Clone)]
pub struct Row {
    /// Line in the file; the header is line 1.
    pub line: u64,
    /// The cells, in the order of the header.
    pub cells: Vec<String>,
}

impl Sheet {
    /// Reads a whole CSV table.
    ///
    /// # Errors
    /// It is not text in UTF-8, or a row has more or fewer cells than the header (with its line). Rows of empty cells are left out.
    pub fn read(bytes: &[u8]) -> Result<Self, String> {
        if bytes.starts_with(ZIP_SIGNATURE) {
            return Err(
                "the file is a ZIP archive, or a workbook that cannot be read here: unpack it, or save it as CSV in UTF-8".to_owned()
            );
        }
        if bytes.starts_with(b"\xFF\xFE") || bytes.starts_with(b"\xFE\xFF") || bytes.contains(&0) {
            return Err("the file is UTF-16 or binary: save it as CSV in UTF-8".to_owned());
        }
        let bytes = bytes.strip_prefix(BYTE_ORDER_MARK).unwrap_or(bytes);
        let delimiter = delimiter(bytes);
        if bytes.to_ascii_lowercase().starts_with(b"sep=") {
            return Err(
                "the first line is Excel's 'sep=': remove it, so that the first line names the columns"
                    .to_owned(),
            );
        }
        if bytes.starts_with(b"<") {
            return Err("this is XML, such as an OpenSim model, expected a table (.csv or .xlsx)".to_owned());
        }
        let mut reader = csv::ReaderBuilder::new();
        let mut reader = reader.delimiter(delimiter).trim(csv::Trim::All).flexible(true).from_reader(bytes);
        let not_text = |error: csv::Error| match error.kind() {
            csv::ErrorKind::Utf8 { pos: Some(place), .. } => {
                let line = LineCounter { bytes, at: 0, line: 1 }.line_at(place.byte());
                format!("line {line}: not UTF-8 text: save it as CSV in UTF-8")
            }
            _ => error.to_string(),
        };
        let header = reader.headers().map_err(not_text)?;
        let header: Vec<String> = header.iter().map(str::to_owned).collect();
        let mut lines = LineCounter { bytes, at: 0, line: 1 };
        let (mut rows, mut unequal) = (Vec::new(), Vec::new());
        for record in reader.records() {
            let record = record.map_err(not_text)?;
            let line = record.position().map_or(0, |position| lines.line_at(position.byte()));
            // Spreadsheets leave rows of empty cells at the end.
            if record.iter().all(str::is_empty) {
                continue;
            }
            if record.len() != header.len() {
                let is_comment = record.get(0).is_some_and(|cell| cell.starts_with('#'));
                unequal.push((line, record.len(), is_comment));
            }
            rows.push(Row { line, cells: record.iter().map(|cell| from_cell(cell).into_owned()).collect() });
        }
        if !unequal.is_empty() {
            return Err(message_of_unequal_rows(&unequal, &header, delimiter));
        }
        let decimal_commas =
            delimiter == b';' || rows.iter().flat_map(|row| &row.cells).any(|cell| has_decimal_comma(cell));
        Ok(Self { header, rows, delimiter, decimal_commas })
    }

    /// The text of a number with a decimal point instead of a comma.
    ///
    /// # Errors
    /// Commas separate the cells of this table, or thousands in this number.
    pub(crate) fn with_decimal_point<'c>(&self, cell: &'c str) -> Result<Cow<'c, str>, &'static str> {
        if is_broken_formula(cell) {
            return Err(BROKEN_FORMULA_MESSAGE);
        }
        match (cell.matches(',').count(), cell.contains('.')) {
            (0, _) => Ok(cell.into()),
            (1, false) if self.delimiter != b',' => Ok(cell.replace(',', ".").into()),
            (1, false) => Err("has a decimal comma: separate the columns by ; or write a decimal point"),
            _ => Err("has separators between thousands, expected a plain number"),
        }
    }

    /// Reads a cell with one plain finite number.
    ///
    /// # Errors
    /// What is wrong with the cell, as the end of a sentence that begins with it.
    pub fn number(&self, cell: &str) -> Result<f64, &'static str> {
        if cell.is_empty() {
            return Err("is empty, expected a number");
        }
        match self.with_decimal_point(cell)?.parse::<f64>() {
            Ok(value) if value.is_finite() => Ok(value),
            Ok(_) => Err("is not finite, expected a number"),
            Err(_) => Err("is not a number"),
        }
    }

    /// The index of the column called `name`, in capital or small letters.
    ///
    /// # Errors
    /// There is none, or there are two.
    pub fn column(&self, name: &str) -> Result<usize, String> {
        let mut columns_of_that_name =
            self.header.iter().enumerate().filter(|(_, cell)| cell.eq_ignore_ascii_case(name));
        match (columns_of_that_name.next(), columns_of_that_name.next()) {
            (Some((index, _)), None) => Ok(index),
            (Some(_), Some(_)) => Err(format!("the column '{name}' appears twice, expected one")),
            _ => Err(format!("no column '{name}' in the first row, which has {}", self.listed_columns())),
        }
    }

    /// The headers of all columns, for messages.
    pub(crate) fn listed_columns(&self) -> String {
        let known: Vec<_> = self.header.iter().map(|cell| format!("'{cell}'")).collect();
        if known.is_empty() { "nothing".to_owned() } else { known.join(", ") }
    }
}

/// Counts the lines before a record, because the CSV reader counts one line too few if lines end with CR and LF.
struct LineCounter<'b> {
    bytes: &'b [u8],
    at: usize,
    line: u64,
}

impl LineCounter<'_> {
    /// The line of the record that begins at byte `start`, or after the line ends at this byte.
    fn line_at(&mut self, start: u64) -> u64 {
        let start = usize::try_from(start).unwrap_or(self.bytes.len());
        let rest = self.bytes.get(start..).unwrap_or_default();
        let blank = rest.iter().position(|&byte| byte != b'\r' && byte != b'\n').unwrap_or(0);
        let passed = self.bytes.get(self.at..start + blank).unwrap_or_default();
        self.line += memchr::memchr_iter(b'\n', passed).count() as u64;
        self.at = start + blank;
        self.line
    }
}

/// The letter between cells: a semicolon or a tab if the first line has one, else the comma.
fn delimiter(bytes: &[u8]) -> u8 {
    let first = bytes.split(|&byte| byte == b'\n').next().unwrap_or_default();
    [b';', b'\t'].into_iter().find(|delimiter| first.contains(delimiter)).unwrap_or(b',')
}

/// Whether the cell is a number with a comma, such as `0,5`.
fn has_decimal_comma(cell: &str) -> bool {
    let digits = |text: &str| !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
    cell.split_once(',').is_some_and(|(head, tail)| digits(head) && digits(tail))
}

/// The message about a cell for which `is_broken_formula` is true, as the end of a sentence that begins with the cell.
pub const BROKEN_FORMULA_MESSAGE: &str =
    "is a broken formula of the spreadsheet: repair it there, and save the table again";

/// Whether the cell is the text that spreadsheets write for a formula without a value, such as `#REF!` and `#N/A`.
pub(crate) fn is_broken_formula(cell: &str) -> bool {
    const FORMULA_ERRORS: &str =
        "#REF! #N/A #VALUE! #NAME? #DIV/0! #NUM! #NULL! #SPILL! #CALC! #FIELD! #GETTING_DATA #ERROR!";
    let cell = trimmed(cell);
    // LibreOffice writes Err:502, for example.
    let numbered =
        cell.strip_prefix("Err:").is_some_and(|rest| rest.bytes().all(|byte| byte.is_ascii_digit()));
    numbered || FORMULA_ERRORS.split(' ').any(|known| known.eq_ignore_ascii_case(cell))
}

/// The largest number of rows of wrong length that a message lists.
const ROWS_LISTED: usize = 20;

/// Advice about rows with more or fewer cells than the header. `unequal` has the line of each row, the number of its cells, and whether it
/// begins with `#`.
fn message_of_unequal_rows(unequal: &[(u64, usize, bool)], header: &[String], delimiter: u8) -> String {
    let expected = header.len();
    let mut rows: Vec<String> = unequal
        .iter()
        .take(ROWS_LISTED)
        .map(|(line, cells, _)| format!("line {line}: {}", counted(cells, "cell")))
        .collect();
    if unequal.len() > ROWS_LISTED {
        rows.push(format!("{} more lines", unequal.len() - ROWS_LISTED));
    }
    let (rows, cause) = (rows.join(", "), probable_cause(unequal, header, delimiter));
    format!("{rows}, expected {expected} as in the first row: {cause}")
}

/// Why rows probably have more or fewer cells than the header.
fn probable_cause(unequal: &[(u64, usize, bool)], header: &[String], delimiter: u8) -> String {
    if header.first().is_some_and(|cell| cell.starts_with('#')) {
        return "the first row begins with #, and it names the columns: leave comments out".to_owned();
    }
    if let Some((line, ..)) = unequal.iter().find(|(_, _, is_comment)| *is_comment) {
        return format!(
            "line {line} begins with #, and comments are not left out: use a column whose name begins with #"
        );
    }
    let more = match delimiter {
        _ if header.len() == 1 => "the first row has to name all columns: remove it if it is a title",
        b',' => "a number with a decimal comma needs a point instead, or columns that are separated by ;",
        _ => "a cell that contains the column separator needs quotation marks",
    };
    if unequal.iter().any(|(_, cells, _)| *cells > header.len()) {
        return more.to_owned();
    }
    let mark = match delimiter {
        b',' => "comma",
        b';' => "semicolon",
        _ => "tab",
    };
    format!("a cell is missing there, write its {mark} also where it is empty")
}

/// The apostrophe before a cell that spreadsheets have to read as text.
const TEXT_MARK: char = '\'';
/// The beginning of an escape, which writes a letter as its number, such as `\u{1b}`.
const ESCAPE_BEGIN: &str = "\\u{";

/// The text as a cell of CSV; [`from_cell`] reads it back.
///
/// Control characters, line ends and marks that change the direction of writing become escapes such as `\u{1b}`, so that they have
/// no effect in a terminal, and each record is one line. A `\` before something that looks like an escape becomes `\u{5c}`. A text
/// that spreadsheets would run as a formula gets a mark, see [`with_text_mark`].
///
/// ```
/// use osim_planning::sheet::{cell, from_cell};
///
/// assert_eq!(cell("a\u{1b}[2J.osim"), r"a\u{1b}[2J.osim");
/// assert_eq!(from_cell(r"a\u{1b}[2J.osim"), "a\u{1b}[2J.osim");
/// assert_eq!(cell("=HYPERLINK(\"http://a.example\")"), "'=HYPERLINK(\"http://a.example\")");
/// assert_eq!(from_cell("'=HYPERLINK(\"http://a.example\")"), "=HYPERLINK(\"http://a.example\")");
/// assert_eq!(cell(r"C:\models\heel_r.osim"), r"C:\models\heel_r.osim");
/// ```
pub fn cell(text: &str) -> Cow<'_, str> {
    match with_escapes(text) {
        Cow::Borrowed(text) => with_text_mark(text),
        Cow::Owned(text) => with_text_mark(&text).into_owned().into(),
    }
}

/// A text without control characters as a cell of CSV. Spreadsheets run a text that begins with `=`, `+`, `-`, `@`, a tab or a line
/// end as a formula; such a text gets an apostrophe before it. Numbers stay as they are.
///
/// ```
/// use osim_planning::sheet::with_text_mark;
///
/// assert_eq!(with_text_mark("=1+1"), "'=1+1");
/// assert_eq!(with_text_mark("-0.05"), "-0.05");
/// ```
pub fn with_text_mark(text: &str) -> Cow<'_, str> {
    match is_formula(text) && text.parse::<f64>().is_err() {
        true => format!("{TEXT_MARK}{text}").into(),
        false => text.into(),
    }
}

/// The text of a cell that [`with_text_mark`] wrote.
pub fn without_text_mark(cell: &str) -> &str {
    cell.strip_prefix(TEXT_MARK).filter(|text| is_formula(text)).unwrap_or(cell)
}

/// The text of a cell that [`cell`] wrote.
pub fn from_cell(cell: &str) -> Cow<'_, str> {
    let text = without_text_mark(cell);
    let mut pieces = text.split(ESCAPE_BEGIN);
    let first = pieces.next().unwrap_or_default();
    if first.len() == text.len() {
        return text.into();
    }
    let mut out = first.to_owned();
    for piece in pieces {
        if let Some((letter, rest)) = letter_of_escape(piece) {
            out.push(letter);
            out.push_str(rest);
        } else {
            out.push_str(ESCAPE_BEGIN);
            out.push_str(piece);
        }
    }
    out.into()
}

/// Whether a spreadsheet would run the text as a formula if the apostrophes before the text were removed.
fn is_formula(text: &str) -> bool {
    text.trim_start_matches(TEXT_MARK).starts_with(['=', '+', '-', '@', '\t', '\r', '\n'])
}

/// The text with an escape for each letter that controls a terminal.
fn with_escapes(text: &str) -> Cow<'_, str> {
    if !text.contains(controls_terminal) && !text.contains(ESCAPE_BEGIN) {
        return text.into();
    }
    let mut out = String::with_capacity(text.len() + 8);
    for (at, letter) in text.char_indices() {
        let is_like_an_escape = || text.get(at..).is_some_and(|rest| rest.starts_with(ESCAPE_BEGIN));
        if controls_terminal(letter) || is_like_an_escape() {
            out.extend(letter.escape_unicode());
        } else {
            out.push(letter);
        }
    }
    out.into()
}

/// Whether a letter has an effect when it is printed, such as ending the line or changing the direction of writing. Invisible letters
/// without such an effect, for example no-break spaces, do not count, because names of files have them.
fn controls_terminal(letter: char) -> bool {
    letter.is_control() || matches!(letter, '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
}

/// The letter that the escape at the beginning of `text` means, and the text after the escape; `None` if this letter is never escaped.
fn letter_of_escape(text: &str) -> Option<(char, &str)> {
    let (digits, rest) = text.split_once('}')?;
    let letter = char::from_u32(u32::from_str_radix(digits, 16).ok()?)?;
    (letter == '\\' || !is_visible(letter)).then_some((letter, rest))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decimal_commas_are_read_if_semicolons_separate_the_cells() {
        let (semicolons, commas) = (Sheet::read(b"a;b\n").unwrap(), Sheet::read(b"a,b\n").unwrap());
        assert_eq!(semicolons.with_decimal_point("1,5").unwrap(), "1.5");
        assert_eq!(semicolons.with_decimal_point("1.5").unwrap(), "1.5");
        assert!(semicolons.with_decimal_point("1.234,5").is_err());
        assert!(commas.with_decimal_point("1,5").is_err());
    }

    #[test]
    fn a_cell_is_one_plain_finite_number() {
        let commas = Sheet::read(b"a,b\n").unwrap();
        let semicolons = Sheet::read(b"a;b\n").unwrap();
        assert_eq!(semicolons.number("1,5"), Ok(1.5));
        assert_eq!(commas.number("1.5"), Ok(1.5));
        for cell in ["nan", "", "5 N", "1,5"] {
            assert!(commas.number(cell).is_err(), "{cell}");
        }
    }

    #[test]
    fn the_delimiter_is_found_in_the_first_line() {
        assert_eq!(delimiter(b"a;b\n1,5;2"), b';');
        assert_eq!(delimiter(b"a\tb\n"), b'\t');
        assert_eq!(delimiter(b"a,b\n"), b',');
    }

    #[test]
    fn a_byte_order_mark_is_no_part_of_the_first_column() {
        let sheet = Sheet::read(b"\xEF\xBB\xBFmodel;target-mass\r\na.osim;0,02\r\n").unwrap();
        assert_eq!(sheet.header, ["model", "target-mass"]);
        assert_eq!((sheet.rows[0].line, sheet.rows[0].cells[1].as_str()), (2, "0,02"));
        assert!(Sheet::read(b"\xFF\xFEm\0").is_err());
        let ragged = Sheet::read(b"a,b\r\n1,2\r\n1\r\n1,2,3\r\n").err().unwrap();
        assert!(
            ragged.starts_with("line 3: 1 cell, line 4: 3 cells, expected 2 as in the first row: "),
            "{ragged}"
        );
        // The message is about what is wrong with them, not about what could be.
        for (text, cause) in [
            (
                "a,b,c\n1,2\n",
                "line 2: 2 cells, expected 3 as in the first row: a cell is missing there, write its comma",
            ),
            ("a;b;c\n1;2\n", "a cell is missing there, write its semicolon"),
            (
                "a,b\n1,5,2\n",
                "line 2: 3 cells, expected 2 as in the first row: a number with a decimal comma",
            ),
            ("a;b\n1;5;2\n", "needs quotation marks"),
            (
                "# mine, of today\na,b,c\n1,2,3\n",
                "the first row begins with #, and it names the columns: leave comments out",
            ),
            (
                "a,b\n# mine\n1,2\n",
                "line 2 begins with #, and comments are not left out: use a column whose name begins with #",
            ),
        ] {
            let message = Sheet::read(text.as_bytes()).err().unwrap();
            assert!(message.contains(cause), "{text}: {message}");
        }
        let empty = Sheet::read(b"a,b\r\n,\r\n\r\n1,2\r\n,,,,\r\n , \r\n").unwrap();
        assert_eq!((empty.rows.len(), empty.rows[0].line), (1, 4));
        let latin = Sheet::read(b"a,b\r\n1,\xe9\r\n").err().unwrap();
        assert!(latin.contains("line 2: not UTF-8"), "{latin}");
        assert!(Sheet::read(b"PK\x03\x04\0\0").err().unwrap().contains("save it as CSV"));
        assert!(Sheet::read(b"sep=;\r\na;b\r\n").is_err());
    }

    #[test]
    fn no_cell_is_a_formula_and_all_read_back() {
        for text in [
            "=1+1", "+1+1", "-a", "@SUM(A1)", "\t=1", "\r=1", "\n=1", "-", "'=1", "''=1", "'heel'", "", "a=b",
        ] {
            let written = cell(text);
            assert!(!written.starts_with(['=', '+', '-', '@', '\t', '\r', '\n']), "{written}");
            assert_eq!(from_cell(&written), text);
        }
        for number in ["-0.05", "+3", "1e-5", "-inf"] {
            assert_eq!(cell(number), number);
            assert_eq!(from_cell(number), number);
        }
    }

    #[test]
    fn no_cell_has_control_characters_and_all_read_back() {
        for text in [
            "a\u{1b}[2J",
            "=1\u{7}",
            "'\t=1",
            "two\nlines\r\n",
            "\u{9b}31m\u{7f}\0",
            "\u{202e}turned\u{2066}\u{2028}",
            // What looks like a letter of ours, whole and cut off.
            r"\u{1b}",
            r"\u{5c}u{1b}",
            r"\u{\u{1b}",
            r"\\u{1b",
            r"\u{41}",
            r"\u{}\u{zz}",
            "\\u{\u{1b}}",
        ] {
            let written = cell(text);
            assert!(
                !written.contains(|letter: char| letter.is_control() || letter == '\u{202e}'),
                "{written}"
            );
            assert_eq!(from_cell(&written), text, "{written}");
        }
        assert_eq!(cell("two\nlines\u{202e}"), r"two\u{a}lines\u{202e}");
        assert_eq!(cell(r"\u{1b}"), r"\u{5c}u{1b}");
    }

    #[test]
    fn names_without_control_characters_are_not_escaped() {
        for text in [
            r"C:\new\tab.osim",
            r"\\server\u\a.osim",
            "Füße\u{a0}5 kg",
            "ا\u{200c}ب",
            "左足",
            r"a\u{41}.osim",
        ] {
            let written = cell(text);
            assert!(written == text || text.contains("u{"), "{written}");
            assert_eq!(from_cell(&written), text);
        }
        // Nobody writes a letter that is seen by its number.
        assert_eq!(from_cell(r"a\u{41}.osim"), r"a\u{41}.osim");
        // A letter as messages show it.
        assert_eq!(from_cell(r"Ferse\u{a0}rechts"), "Ferse\u{a0}rechts");
    }
}
