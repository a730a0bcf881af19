//! Tables as CSV.

use std::io;

use csv::{IntoInnerError, WriterBuilder};
use osim_model::messages::shown_whole;
use osim_planning::marked;

/// The records as CSV, quoted where they have to be.
///
/// # Errors
/// None in practice: the records are written into memory, and all of one table are equally long.
pub(crate) fn csv_text(records: impl IntoIterator<Item = Vec<String>>) -> Result<String, csv::Error> {
    let mut writer = WriterBuilder::new().from_writer(Vec::new());
    for record in records {
        // One line for each record, whatever names hold.
        writer.write_record(record.iter().map(|text| marked(&shown_whole(text).to_string()).into_owned()))?;
    }
    let bytes = writer.into_inner().map_err(IntoInnerError::into_error)?;
    String::from_utf8(bytes).map_err(|error| io::Error::new(io::ErrorKind::InvalidData, error).into())
}
