//! The numbers of a figure as a table.

use contact_plots::{Datum, Drawing};
use osim_model::messages::shortest;
use osim_planning::cell;

/// What the columns are called: they say themselves what is in them.
const COLUMNS: [&str; 9] = ["panel", "kind", "name", "x_axis", "x", "y_axis", "y", "value_name", "value"];

/// All numbers of a figure as CSV: a row for each point of a curve, each mark, limit and cell; what one does not have is empty.
///
/// # Errors
/// The library that writes CSV did not get through, which it says.
pub fn data_csv(drawing: &Drawing) -> Result<Vec<u8>, csv::Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(COLUMNS)?;
    for datum in drawing.data() {
        let Datum { panel, kind, name, x_axis, x, y_axis, y, value_name, value, .. } = datum;
        let number = |value: Option<f64>| value.map(shortest).unwrap_or_default();
        writer.write_record([
            cell(&panel).into_owned(),
            kind.to_owned(),
            cell(&name).into_owned(),
            x_axis,
            number(x),
            y_axis,
            number(y),
            value_name,
            number(value),
        ])?;
    }
    writer.into_inner().map_err(|error| error.into_error().into())
}
