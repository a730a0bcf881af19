//! A column of a table over one or two others, such as a result over the grid of a sweep.

use std::path::Path;

use osim_model::files::{Failure, Files};
use osim_requests::HeatOptions;

use crate::sheet::Sheet;

/// Columns that say what a sweep was asked for begin with this.
const GRID: &str = "grid_";

/// A column of numbers.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct TableColumn {
    /// Its name, as the table has it.
    pub name: String,
    /// A number for each row; `None` for an empty cell.
    pub values: Vec<Option<f64>>,
}

/// What is drawn of a table.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct HeatTable {
    /// The file's name without its folders.
    pub name: String,
    /// Along the horizontal axis.
    pub x: TableColumn,
    /// Along the vertical axis; `None` where the table varies one thing only.
    pub y: Option<TableColumn>,
    /// As a colour, or as the height of a curve.
    pub value: TableColumn,
}

impl HeatTable {
    /// Reads the columns that `options` name from the table at `path`.
    ///
    /// # Errors
    /// The table cannot be read, a column is missing (with those that are there) or is not clear, or a cell is not a number.
    pub fn read(path: &Path, options: &HeatOptions, files: &dyn Files) -> Result<Self, Failure> {
        let failed = |why: String| Failure::outside(path.display().to_string(), "table", why);
        let bytes = files.read(path).map_err(|error| failed(error.to_string()))?;
        let sheet = Sheet::read(&bytes).map_err(failed)?;
        let name = path.file_stem().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
        Self::of_sheet(name, &sheet, options).map_err(failed)
    }

    fn of_sheet(name: String, sheet: &Sheet, options: &HeatOptions) -> Result<Self, String> {
        let grid: Vec<&str> =
            sheet.header.iter().map(String::as_str).filter(|name| name.starts_with(GRID)).collect();
        let (x, y) = match (options.x_column.as_deref(), options.y_column.as_deref()) {
            (Some(x), y) => (x, y),
            (None, y) => match (grid.as_slice(), y) {
                ([x], y) => (*x, y),
                ([x, y], None) => (*x, Some(*y)),
                _ => {
                    return Err(format!(
                        "the table has {} columns that begin with '{GRID}', expected one or two: say which columns are \
                         the axes; there are {}",
                        grid.len(),
                        sheet.columns()
                    ));
                }
            },
        };
        let value = options.value_column.as_deref().unwrap_or_default();
        let column = |name: &str| column(sheet, name);
        Ok(Self { name, x: column(x)?, y: y.map(column).transpose()?, value: column(value)? })
    }
}

fn column(sheet: &Sheet, name: &str) -> Result<TableColumn, String> {
    let index = sheet.column(name)?;
    let value = |row: &crate::sheet::Row| match row.cells.get(index).map(String::as_str) {
        None | Some("") => Ok(None),
        Some(cell) => sheet
            .number(cell)
            .map(Some)
            .map_err(|why| format!("line {}, column '{name}': '{cell}' {why}", row.line)),
    };
    let values = sheet.rows.iter().map(value).collect::<Result<_, _>>()?;
    Ok(TableColumn { name: sheet.header.get(index).cloned().unwrap_or_default(), values })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(table: &str, x: Option<&str>, y: Option<&str>) -> Result<HeatTable, String> {
        let options = HeatOptions {
            value_column: Some("speed".to_owned()),
            x_column: x.map(str::to_owned),
            y_column: y.map(str::to_owned),
            ..HeatOptions::default()
        };
        HeatTable::of_sheet("t".to_owned(), &Sheet::read(table.as_bytes()).unwrap(), &options)
    }

    #[test]
    fn the_columns_of_the_grid_are_the_axes() {
        let table =
            read("file,grid_stiffness,grid_dissipation,speed\na,1,2,3\nb,1,4,\n", None, None).unwrap();
        assert_eq!(
            (table.x.name.as_str(), table.x.values.as_slice()),
            ("grid_stiffness", &[Some(1.0), Some(1.0)][..])
        );
        assert_eq!(table.y.unwrap().values, [Some(2.0), Some(4.0)]);
        assert_eq!(table.value.values, [Some(3.0), None]);
        assert!(read("grid_stiffness,speed\n1,2\n", None, None).unwrap().y.is_none());
    }

    #[test]
    fn what_is_not_clear_is_asked_for() {
        let refused = |table: &str, x, words: &str| {
            let message = read(table, x, None).unwrap_err();
            assert!(message.contains(words), "{message}");
        };
        refused("a,speed\n1,2\n", None, "0 columns that begin with 'grid_'");
        refused("grid_a,grid_b,grid_c,speed\n1,2,3,4\n", None, "say which columns");
        refused("a,speed\n1,2\n", Some("b"), "no column 'b'");
        refused("a,speed\n1,fast\n", Some("a"), "line 2, column 'speed': 'fast' is not a number");
    }
}
