//! What force plates measured, as files say it.

use std::path::{Path, PathBuf};

use osim_model::files::{Failure, Files};
use osim_motion::{ExternalLoads, Plate};

use super::opened::{failure, table};
use crate::opening::read;

/// The plates of a recording.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct PlatesRead {
    /// The table that they were read from.
    pub file: PathBuf,
    /// The ExternalLoads that say what its columns are.
    pub loads: Option<PathBuf>,
    /// What the ExternalLoads name as their table, where its last part is another name than that of the table.
    pub other_data_file: Option<String>,
    /// The plates.
    pub plates: Vec<Plate>,
}

impl PlatesRead {
    /// Those of the table `file`, as the ExternalLoads at `loads` name them.
    ///
    /// # Errors
    /// A file that cannot be read, or columns that are not there.
    pub(crate) fn read(file: &Path, loads: Option<&Path>, files: &dyn Files) -> Result<Self, Failure> {
        let table = table(file, files)?;
        let Some(path) = loads else {
            let plates = Plate::all(&table).map_err(|fault| failure(file, &fault))?;
            return Ok(Self { file: file.to_owned(), loads: None, other_data_file: None, plates });
        };
        let loads = ExternalLoads::read(&read(path, files)?).map_err(|fault| failure(path, &fault))?;
        let plates = Plate::of_loads(&table, &loads).map_err(|fault| failure(file, &fault))?;
        let own = file.file_name().map(|name| name.to_string_lossy().into_owned());
        let other = loads.data_file_name().map(str::to_owned).filter(|named| Some(named) != own.as_ref());
        Ok(Self { file: file.to_owned(), loads: Some(path.to_owned()), other_data_file: other, plates })
    }

    /// The file's name, for sentences.
    #[must_use]
    pub fn name(&self) -> &Path {
        &self.file
    }
}
