//! One renderer each for people and for scripts; all of them read the plan or the model and decide nothing.

pub(crate) mod changes;
pub(crate) mod diff;
pub(crate) mod inspect;
pub(crate) mod json;

pub(crate) use osim_patch::readable as number;

/// A table that fits a terminal of 80 columns, without lines that old consoles cannot draw.
pub(crate) fn table(header: &[&str]) -> comfy_table::Table {
    let mut table = comfy_table::Table::new();
    table.load_style(comfy_table::presets::NOTHING).set_header(header.to_vec());
    table
}

/// Aligns columns `columns` to the right.
pub(crate) fn right(table: &mut comfy_table::Table, columns: &[usize]) {
    for &index in columns {
        if let Some(column) = table.column_mut(index) {
            column.set_cell_alignment(comfy_table::CellAlignment::Right);
        }
    }
}
