//! The folder that the rows of a table may write into.

use std::path::{Path, PathBuf};

use osim_model::messages::{Input, Phrase, phrase, shown_path};
use osim_requests::options::OutputOptions;

use super::destination::Destination;
use super::task::Task;
use crate::paths::resolved;

/// The folder that the rows of a table may write into. A table comes from somebody else more often than a call does, and its cells
/// must not reach every file of the reader's.
#[derive(Debug)]
pub(super) struct Inside {
    folder: PathBuf,
    /// Without links, `.` and `..`.
    real: PathBuf,
}

impl Inside {
    /// Everything below `folder`.
    pub(super) fn of(folder: &Path) -> Self {
        Self { folder: folder.to_owned(), real: resolved(folder) }
    }

    /// Checks the files that a task writes: `row` is what its row says of them, with what `call` says for all rows. A new result
    /// beside its model, under a name of its own, is always fine; one that replaces a file is where the call allows that.
    ///
    /// # Errors
    /// The first that lies elsewhere, by its column.
    pub(super) fn check(
        &self,
        task: &Task,
        row: &OutputOptions,
        call: &OutputOptions,
    ) -> Result<(), (Input, Phrase)> {
        let changes_model = matches!(task.destination, Destination::Itself);
        let replaces = row.force && !call.force;
        if !(task.asked || changes_model || replaces) {
            return Ok(());
        }
        let column = |own: Input, is_named: bool| match () {
            () if changes_model => Input::InPlace,
            () if is_named => own,
            () if task.asked => Input::OutputDir,
            () => Input::Force,
        };
        let output = task.output().map(|path| (column(Input::Output, row.output.is_some()), path));
        let is_named = row.geometry_output.is_some();
        let geometry =
            task.geometry_output.as_deref().map(|path| (column(Input::GeometryOutput, is_named), path));
        output.into_iter().chain(geometry).try_for_each(|(column, path)| match self.holds(path) {
            true => Ok(()),
            false => Err((column, self.outside(path, column == Input::Force))),
        })
    }

    fn holds(&self, path: &Path) -> bool {
        resolved(path).starts_with(&self.real)
    }

    fn outside(&self, path: &Path, replaces: bool) -> Phrase {
        let folder = if self.folder == Path::new("") { Path::new(".") } else { &self.folder };
        let does = if replaces { "replace files" } else { "write" };
        let where_it_is = format!("{} is outside the folder {}", shown_path(path), shown_path(folder));
        phrase![format!("{where_it_is}: if rows may {does} there, say "), Input::AllowOutside]
    }
}
