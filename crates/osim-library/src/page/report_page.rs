//! The page for browsers: its file, which takes its name only when it is whole.

use std::path::Path;

use osim_model::messages::{Input, Verb, phrase};
use osim_requests::options::RunOptions;
use osim_view::html::{About, Columns, Entry, GENERATOR, Kept, Page};

use crate::page::nameless_file::NamelessFile;
use crate::page::words::Words;
use crate::run::Run;
use crate::{LibraryFault, Mode, Prepared, head, make_folder_of, reason};

/// Bytes in which a page says what wrote it.
const HEAD: usize = 1024;

/// What a page may take the place of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Replace {
    /// Nothing.
    Never,
    /// Pages of this program: a resumed run writes its page again.
    Pages,
    /// Any file.
    Files,
}

/// A page that is being written. It takes its name only when it is whole.
pub struct ReportPage {
    prepared: Prepared,
    page: Page<'static, NamelessFile>,
}

impl ReportPage {
    /// Begins the page that `path` will hold.
    ///
    /// # Errors
    /// A name that is not a page's, a file that is there already, or a folder that cannot be written.
    pub fn begin(path: &Path, replace: Replace, about: About, words: Words) -> Result<Self, LibraryFault> {
        check_name(path)?;
        let replaces = match replace {
            Replace::Never => false,
            Replace::Pages => is_page(path),
            Replace::Files => true,
        };
        if path.exists() && !replaces {
            return Err(LibraryFault::new(phrase![
                format!(
                    "the report {} exists already: choose another name, or replace it with ",
                    path.display()
                ),
                Input::Force,
            ]));
        }
        make_folder_of(path)?;
        let mode = if replaces { Mode::Replace } else { Mode::New };
        let prepared = Prepared::begin(path, None, mode)?;
        let kept = Kept {
            failures: NamelessFile::beside(path)?,
            rows: NamelessFile::beside(path)?,
            details: NamelessFile::beside(path)?,
        };
        Ok(Self { prepared, page: Page::new(about, kept, words) })
    }

    /// Begins the page about a run, the call `asked`; what could not even be listed is on it already. `None` if no page is asked
    /// for.
    ///
    /// # Errors
    /// Those of [`begin`](Self::begin).
    pub fn of_run(
        run: &Run<'_>,
        options: &RunOptions,
        asked: String,
        words: Words,
    ) -> Result<Option<Self>, LibraryFault> {
        let Some(path) = &options.report else { return Ok(None) };
        let request = run.request();
        let shown = || match (request.tasks.first(), request.failures.first()) {
            (Some(task), _) => task.source.shown(),
            (None, failure) => failure.map(|failure| failure.model.to_string()).unwrap_or_default(),
        };
        let verb = Verb::ALL.iter().copied().find(|verb| verb.name() == request.verb).unwrap_or(Verb::Set);
        let about = About::new(verb, request.is_one().then(shown), Columns::Changes, asked);
        let replace = match (request.force, run.goes_on()) {
            (true, _) => Replace::Files,
            // A resumed run writes its page again, as it does its summary.
            (false, true) => Replace::Pages,
            (false, false) => Replace::Never,
        };
        let mut page = Self::begin(path, replace, about, words)?;
        request.failures.iter().for_each(|failure| page.add(Entry::failed(failure, words)));
        Ok(Some(page))
    }

    /// The next model.
    pub fn add(&mut self, entry: Entry) {
        self.page.add(entry);
    }

    /// Writes the page under its name.
    ///
    /// # Errors
    /// The disk refuses: no page is there then, or the old one.
    pub fn finish(self) -> Result<(), LibraryFault> {
        let Self { mut prepared, page } = self;
        page.finish(&mut prepared)
            .map_err(|error| LibraryFault::new(reason(&error)).within("cannot write the report"))?;
        prepared.commit()
    }
}

/// Whether this program wrote the page, which says so in its head.
fn is_page(path: &Path) -> bool {
    head(path, HEAD).is_ok_and(|head| memchr::memmem::find(&head, GENERATOR.as_bytes()).is_some())
}

fn check_name(path: &Path) -> Result<(), LibraryFault> {
    let ending = path.extension().map(|ending| ending.to_string_lossy().to_ascii_lowercase());
    match ending.as_deref() {
        Some("html" | "htm") => Ok(()),
        _ => Err(LibraryFault::new(phrase![
            Input::Report,
            format!(" '{}': expected the name of a page, such as report.html", path.display()),
        ])),
    }
}
