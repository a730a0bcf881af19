//! The folder that the rows of a table may write into.

use std::path::{Path, PathBuf};

use osim_model::wording::{Input, Phrase, phrase, shown_path};

use super::destination::Destination;
use super::task::Task;
use crate::paths::resolved;

/// The folder that the rows of a table may write into. A table comes from somebody else more often than a call does, and its cells
/// must not reach every file of the reader's.
#[derive(Debug)]
pub struct Inside {
    folder: PathBuf,
    /// Without links, `.` and `..`.
    real: PathBuf,
}

impl Inside {
    /// Everything below `folder`.
    #[must_use]
    pub fn of(folder: &Path) -> Self {
        Self { folder: folder.to_owned(), real: resolved(folder) }
    }

    /// Checks the files that a task names to write. A result beside its model, under a name of its own, is always fine.
    ///
    /// # Errors
    /// The first that lies elsewhere, by its column.
    pub fn check(&self, task: &Task) -> Result<(), (Input, Phrase)> {
        let changes_model = matches!(task.destination, Destination::Itself);
        let column = if changes_model { Input::InPlace } else { Input::Output };
        let output = task.output().filter(|_| task.asked || changes_model).map(|path| (column, path));
        let geometry = task.geometry_output.as_deref().filter(|_| task.asked || changes_model);
        let geometry = geometry.map(|path| (Input::GeometryOutput, path));
        output.into_iter().chain(geometry).try_for_each(|(column, path)| {
            if resolved(path).starts_with(&self.real) {
                return Ok(());
            }
            let folder = if self.folder == Path::new("") { Path::new(".") } else { &self.folder };
            Err((
                column,
                phrase![
                    format!(
                        "{} is outside the folder {}: if rows may write there, say ",
                        shown_path(path),
                        shown_path(folder)
                    ),
                    Input::AllowOutside,
                ],
            ))
        })
    }
}
