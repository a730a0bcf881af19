//! What can be wrong with a table of contacts.

use std::fmt;

/// What is wrong with a table, and where.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct TableFault {
    /// Line in the file, where it is about one.
    pub line: Option<u64>,
    /// Column, from 1, where it is about one.
    pub column: Option<usize>,
    /// What is wrong, with the name of the column, without its line.
    pub message: String,
}

impl TableFault {
    pub(super) fn of_header(index: usize, message: String) -> Self {
        Self { line: Some(1), column: Some(index + 1), message }
    }
}

impl fmt::Display for TableFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.line {
            Some(line) => write!(f, "line {line}: {}", self.message),
            None => f.write_str(&self.message),
        }
    }
}

impl std::error::Error for TableFault {}
