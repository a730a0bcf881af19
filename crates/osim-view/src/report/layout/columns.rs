//! Tables of text.

use std::fmt;

use comfy_table::{CellAlignment, ColumnConstraint, ContentArrangement, Table, presets};
use osim_model::messages::one_line;

use super::lines::WIDTH;

/// A table that fits a terminal of 80 columns, without lines that old consoles cannot draw. A cell is one line: what cannot
/// be seen in it is escaped.
#[derive(Debug)]
pub struct TextTable(Table);

/// A table with these headings.
#[must_use]
pub fn table(header: &[&str]) -> TextTable {
    let mut table = Table::new();
    table.load_style(presets::NOTHING).set_header(header.to_vec());
    TextTable(table)
}

impl TextTable {
    /// Adds a row.
    pub fn add_row(&mut self, cells: impl IntoIterator<Item = impl AsRef<str>>) {
        self.0.add_row(cells.into_iter().map(|text| one_line(text.as_ref().to_owned())));
    }

    /// Aligns these columns, counted from 0, to the right.
    pub fn right_aligned(&mut self, columns: &[usize]) {
        for &index in columns {
            if let Some(column) = self.0.column_mut(index) {
                column.set_cell_alignment(CellAlignment::Right);
            }
        }
    }

    /// Never breaks the texts of this column, counted from 0, into lines.
    pub fn unbroken(&mut self, index: usize) {
        if let Some(column) = self.0.column_mut(index) {
            column.set_constraint(ColumnConstraint::ContentWidth);
        }
    }

    /// The table in lines of at most [`WIDTH`] columns.
    #[must_use]
    pub fn fitted(mut self) -> String {
        self.0.set_content_arrangement(ContentArrangement::Dynamic).set_width(WIDTH as u16);
        self.0.trim_fmt()
    }

    /// The table without blanks at the ends of its lines.
    #[must_use]
    pub fn trim_fmt(&self) -> String {
        self.0.trim_fmt()
    }
}

impl fmt::Display for TextTable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}
