//! One row of the table that says what is in which variant.

use osim_planning::cell;

use crate::fault::LibraryFault;

/// The cells as one line of CSV; no cell is a formula.
pub(super) fn line(cells: &[String]) -> Result<Vec<u8>, LibraryFault> {
    let said = |error: String| LibraryFault::new(error);
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer
        .write_record(cells.iter().map(|text| cell(text).into_owned()))
        .map_err(|error| said(error.to_string()))?;
    writer.into_inner().map_err(|error| said(error.to_string()))
}
