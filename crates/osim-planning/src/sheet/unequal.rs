//! Rows that have more or fewer cells than the first one.

use csv::StringRecord;

/// Rows that are named at most.
const NAMED: usize = 20;

/// What is known of such rows.
#[derive(Debug, Default)]
pub(super) struct Unequal {
    /// Line, cells, and whether the row begins as a comment would.
    rows: Vec<(u64, usize, bool)>,
}

impl Unequal {
    pub(super) fn add(&mut self, record: &StringRecord, line: u64) {
        let is_comment = record.get(0).is_some_and(|cell| cell.starts_with('#'));
        self.rows.push((line, record.len(), is_comment));
    }

    /// What is wrong, and what to do about it; `None` where all rows are like the first one.
    pub(super) fn message(&self, header: &[String], delimiter: u8) -> Option<String> {
        if self.rows.is_empty() {
            return None;
        }
        let expected = header.len();
        let mut rows: Vec<String> = self
            .rows
            .iter()
            .take(NAMED)
            .map(|(line, cells, _)| format!("line {line}: {cells} cells"))
            .collect();
        if self.rows.len() > NAMED {
            rows.push(format!("{} more lines", self.rows.len() - NAMED));
        }
        let rows = rows.join(", ");
        Some(format!("{rows}, expected {expected} as in the first row: {}", self.cause(header, delimiter)))
    }

    fn cause(&self, header: &[String], delimiter: u8) -> String {
        if header.first().is_some_and(|cell| cell.starts_with('#')) {
            return "the first row begins with #, and it names the columns: leave comments out".to_owned();
        }
        if let Some((line, ..)) = self.rows.iter().find(|(_, _, is_comment)| *is_comment) {
            return format!(
                "line {line} begins with #, and comments are not left out: use a column whose name begins with #"
            );
        }
        let more = match delimiter {
            b',' => "a number with a decimal comma needs a point instead, or columns that are separated by ;",
            _ => "a cell that holds the mark between columns needs quotation marks",
        };
        if self.rows.iter().any(|(_, cells, _)| *cells > header.len()) {
            return more.to_owned();
        }
        let mark = match delimiter {
            b',' => "comma",
            b';' => "semicolon",
            _ => "tab",
        };
        format!("a cell is missing there, write its {mark} also where it is empty")
    }
}
