//! Tables over time, through whatever holds the files.

use std::path::Path;

use osim_model::files::{Failure, Files};
use osim_model::messages::{Input, Phrase, phrase};
use osim_motion::{AngleUnit, Belt, MotionFault, RecordingOptions, Table};
use osim_requests::{AngleChoice, Positive, Speed};

use crate::opening::read;

/// Reads a table.
///
/// # Errors
/// It cannot be read, with the line.
pub(crate) fn table(path: &Path, files: &dyn Files) -> Result<Table, Failure> {
    Table::read(&read(path, files)?).map_err(|fault| failure(path, &fault))
}

/// What `fault` says of the file at `path`.
pub(crate) fn failure(path: &Path, fault: &MotionFault) -> Failure {
    let place = fault.line.map(|line| format!("line {line}: ")).unwrap_or_default();
    let mut message = Phrase::from(format!("{place}{}", fault.message));
    if fault.needs_angles {
        message.push(&phrase![
            ": say ",
            Input::Angles.being("degrees"),
            " or ",
            Input::Angles.being("radians")
        ]);
    }
    let mut failure = Failure::outside(path, "motion", message);
    (failure.line, failure.needs_answer) = (fault.line, fault.needs_angles);
    failure
}

/// The belt under the feet of the motion at `path`, where one is named: by its speed, or by a column of `table`.
///
/// # Errors
/// No such column.
pub(crate) fn belt(
    path: &Path,
    table: &Table,
    speed: Option<Speed>,
    column: Option<&str>,
) -> Result<Option<Belt>, Failure> {
    match (speed, column) {
        (Some(speed), _) => Ok(Some(Belt::against_x(speed.get()))),
        (None, Some(name)) => Belt::of_column(table, name).map(Some).map_err(|fault| failure(path, &fault)),
        (None, None) => Ok(None),
    }
}

/// How the motion at `path` is taken.
pub(crate) fn recording_options(
    path: &Path,
    angles: Option<AngleChoice>,
    low_pass: Option<Positive>,
) -> RecordingOptions {
    RecordingOptions {
        angles: angles.map(|choice| match choice {
            AngleChoice::Degrees => AngleUnit::Degrees,
            _ => AngleUnit::Radians,
        }),
        undeclared: undeclared(path),
        low_pass_hz: low_pass.map(Positive::get),
    }
}

/// What OpenSim takes the angles of a file of this name for where its header has neither unit nor version.
fn undeclared(path: &Path) -> Option<AngleUnit> {
    let ending = path.extension()?.to_string_lossy().to_ascii_lowercase();
    match ending.as_str() {
        "mot" => Some(AngleUnit::Degrees),
        "sto" => Some(AngleUnit::Radians),
        _ => None,
    }
}
