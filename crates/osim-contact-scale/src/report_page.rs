//! The page for browsers: its file, and what waits for it in files without names.

use std::fs::File;
use std::io::{BufWriter, Read, Seek, SeekFrom, Write};
use std::path::Path;

use anyhow::{Context, Result, anyhow, bail};
use osim_library::{Mode, Prepared, folder_of, head, make_folder_of, reason, resolved};
use osim_model::wording::Input;
use osim_report::html::{About, DeferredText, Entry, GENERATOR, Kept, Page};

use crate::session::Session;
use crate::terminal::Exit;
use crate::words::Words;

/// Bytes copied at once.
const CHUNK: usize = 1 << 16;

/// Bytes in which a page says what wrote it.
const HEAD: usize = 1024;

/// What a page may take the place of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Replace {
    Never,
    /// Pages of this program: a run that goes on writes its page again.
    Pages,
    /// Any file.
    Files,
}

/// A page that is being written. It takes its name only when it is whole.
pub(crate) struct ReportPage {
    prepared: Prepared,
    page: Page<'static, NamelessFile>,
}

impl ReportPage {
    /// Begins the page that `path` will hold.
    ///
    /// # Errors
    /// A name that is not a page's, a file that is there already, or a folder that cannot be written.
    pub(crate) fn begin(path: &Path, replace: Replace, about: About, session: &Session) -> Result<Self> {
        let words = session.words;
        check_name(path, words)?;
        let replaces = match replace {
            Replace::Never => false,
            Replace::Pages => is_page(path),
            Replace::Files => true,
        };
        if path.exists() && !replaces {
            bail!(
                "the report {} exists already: choose another name, or replace it with {}",
                path.display(),
                words.input(Input::Force, None)
            );
        }
        let refused = |fault| session.refused(&fault);
        make_folder_of(path).map_err(refused)?;
        let mode = if replaces { Mode::Replace } else { Mode::New };
        let prepared = Prepared::begin(path, None, mode).map_err(refused)?;
        let kept = Kept {
            failures: NamelessFile::beside(path)?,
            rows: NamelessFile::beside(path)?,
            details: NamelessFile::beside(path)?,
        };
        Ok(Self { prepared, page: Page::new(about, kept, words) })
    }

    /// The next model.
    pub(crate) fn add(&mut self, entry: Entry) {
        self.page.add(entry);
    }

    /// Ends the page, if there is one; what cannot be written is reported.
    pub(crate) fn end(page: Option<Self>, session: &mut Session) -> Exit {
        match page.map_or(Ok(()), |page| page.finish(session)) {
            Ok(()) => Exit::Done,
            Err(error) => {
                session.terminal.error_line(&format!("the report: {error:#}"));
                Exit::Failed
            }
        }
    }

    /// Writes the page under its name.
    fn finish(self, session: &Session) -> Result<()> {
        let Self { mut prepared, page } = self;
        page.finish(&mut prepared).context("cannot write the report")?;
        prepared.commit().map_err(|fault| session.refused(&fault))
    }
}

/// `true` for a page that this program wrote, which says so in its head.
fn is_page(path: &Path) -> bool {
    head(path, HEAD).is_ok_and(|head| memchr::memmem::find(&head, GENERATOR.as_bytes()).is_some())
}

fn check_name(path: &Path, words: Words) -> Result<()> {
    let ending = path.extension().map(|ending| ending.to_string_lossy().to_ascii_lowercase());
    match ending.as_deref() {
        Some("html" | "htm") => Ok(()),
        _ => bail!(
            "{} '{}': expected the name of a page, such as report.html",
            words.input(Input::Report, None),
            path.display()
        ),
    }
}

/// Text that waits in a nameless file until what is before it on the page is known.
struct NamelessFile(BufWriter<File>);

impl NamelessFile {
    /// On the disk that will hold `path`; the system removes the file, whatever happens.
    ///
    /// # Errors
    /// The folder cannot be written.
    fn beside(path: &Path) -> Result<Self> {
        let target = resolved(path);
        let folder = folder_of(&target);
        let file = tempfile::tempfile_in(folder)
            .map_err(|error| anyhow!(reason(&error)))
            .with_context(|| format!("cannot write into {}", folder.display()))?;
        Ok(Self(BufWriter::new(file)))
    }
}

impl DeferredText for NamelessFile {
    fn add(&mut self, text: &str) -> std::io::Result<()> {
        self.0.write_all(text.as_bytes())
    }

    fn pour_into(&mut self, page: &mut dyn Write) -> std::io::Result<()> {
        self.0.flush()?;
        let file = self.0.get_mut();
        file.seek(SeekFrom::Start(0))?;
        let mut chunk = vec![0; CHUNK];
        loop {
            let read = file.read(&mut chunk)?;
            match chunk.get(..read) {
                Some(bytes) if read > 0 => page.write_all(bytes)?,
                _ => return Ok(()),
            }
        }
    }
}
