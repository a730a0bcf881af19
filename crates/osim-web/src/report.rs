//! Reports, as the command writes them: in its words, because a report says by which command it is made again.

use std::path::Path;

use osim_model::messages::Verb;
use osim_requests::spell::CommandLine;
use osim_view::html::{About, Columns, Entry, InMemory, Kept, Page};
use serde::Serialize;

use crate::problem::Problem;

/// A report.
#[derive(Debug, Serialize)]
pub(crate) struct Report {
    name: String,
    html: String,
}

/// The name of a report about the model `path`.
pub(crate) fn name_of(path: &Path) -> String {
    path.with_extension("report.html").display().to_string()
}

impl Report {
    /// The report about one model; `asked` is the call that would write it.
    pub(crate) fn of(verb: Verb, model: &Path, asked: String, entry: Entry) -> Result<Self, Problem> {
        let columns = if verb == Verb::Inspect { Columns::Inspections } else { Columns::Changes };
        let about = About::new(verb, Some(model.display().to_string()), columns, asked);
        let mut page = Page::new(about, Kept::<InMemory>::default(), &CommandLine);
        page.add(entry);
        let mut bytes = Vec::new();
        page.finish(&mut bytes).map_err(Problem::defect)?;
        let html = String::from_utf8(bytes).map_err(Problem::defect)?;
        Ok(Self { name: name_of(model), html })
    }
}
