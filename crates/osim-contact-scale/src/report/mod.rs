//! One renderer each for people and for scripts; all of them read the plan or the model and decide nothing.

pub(crate) mod changes;
pub(crate) mod diff;
pub(crate) mod inspect;
pub(crate) mod json;

use osim_patch::shortest;

/// A number for people: exact where that is short, else eight significant digits.
pub(crate) fn number(value: f64) -> String {
    const SHORT: usize = 10;
    let exact = shortest(value);
    if exact.len() <= SHORT || !value.is_finite() {
        return exact;
    }
    let rounded: f64 = format!("{value:.7e}").parse().unwrap_or(value);
    shortest(rounded)
}

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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_for_people_are_short() {
        assert_eq!(number(0.032), "0.032");
        assert_eq!(number(2_005_361.956_123), "2005362");
        assert_eq!(number(0.064_171_582_614_44), "0.064171583");
        assert_eq!(number(4.021_476_612_3e-6), "4.0214766e-6");
        assert_eq!(number(f64::NAN), "NaN");
    }
}
