//! What force plates measured, as files say it.

use std::path::{Path, PathBuf};

use osim_model::files::{Failure, Files};
use osim_model::messages::{readable, shown};
use osim_motion::{ExternalLoads, Gap, Plate};

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
    /// Where rows of the table are missing.
    pub gaps: Vec<Gap>,
}

impl PlatesRead {
    /// Those of the table `file`, as the ExternalLoads at `loads` name them.
    ///
    /// # Errors
    /// A file that cannot be read, or columns that are not there.
    pub(crate) fn read(file: &Path, loads: Option<&Path>, files: &dyn Files) -> Result<Self, Failure> {
        let table = table(file, files)?;
        let gaps = table.gaps();
        let Some(path) = loads else {
            let plates = Plate::all(&table).map_err(|fault| failure(file, &fault))?;
            return Ok(Self { file: file.to_owned(), loads: None, other_data_file: None, plates, gaps });
        };
        let loads = ExternalLoads::read(&read(path, files)?).map_err(|fault| failure(path, &fault))?;
        let plates = Plate::of_loads(&table, &loads).map_err(|fault| failure(file, &fault))?;
        let own = file.file_name().map(|name| name.to_string_lossy().into_owned());
        let other = loads.data_file_name().map(str::to_owned).filter(|named| Some(named) != own.as_ref());
        let (file, loads) = (file.to_owned(), Some(path.to_owned()));
        Ok(Self { file, loads, other_data_file: other, plates, gaps })
    }

    /// That rows are missing among those that a motion with these times needs, where they are.
    pub(crate) fn gaps_during(&self, time_s: &[f64]) -> Option<String> {
        let (first, last) = (time_s.first()?, time_s.last()?);
        let during = || self.gaps.iter().filter(|gap| gap.from_s < *last && gap.to_s > *first);
        let longest = during().max_by(|a, b| a.length_s().total_cmp(&b.length_s()))?;
        let count = match during().count() {
            1 => "1 gap".to_owned(),
            count => format!("{count} gaps, the longest"),
        };
        Some(format!(
            "{}: rows are missing in {count} from {} to {} s; the measured forces are taken along straight lines there",
            shown(&self.file.file_name().unwrap_or_default().to_string_lossy()),
            readable(longest.from_s),
            readable(longest.to_s)
        ))
    }

    /// The file's name, for sentences.
    #[must_use]
    pub fn name(&self) -> &Path {
        &self.file
    }
}
