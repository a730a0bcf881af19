//! Tables of text.

use comfy_table::{CellAlignment, Table, presets};

/// A table that fits a terminal of 80 columns, without lines that old consoles cannot draw.
#[must_use]
pub fn table(header: &[&str]) -> Table {
    let mut table = Table::new();
    table.load_style(presets::NOTHING).set_header(header.to_vec());
    table
}

/// Aligns these columns, counted from 0, to the right.
pub fn right_aligned(table: &mut Table, columns: &[usize]) {
    for &index in columns {
        if let Some(column) = table.column_mut(index) {
            column.set_cell_alignment(CellAlignment::Right);
        }
    }
}
