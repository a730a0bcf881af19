//! `--report FILE.html`: one page about a run, for people and for the record.
//!
//! The page holds everything itself: no script, no font, no picture from elsewhere. Workers render the [`Entry`] of a
//! model; [`Page`] puts entries together in the order of the models. Rows and details wait in temporary files, so that
//! memory stays flat however many models there are, and the page takes its name only when it is whole.

mod change;
mod entry;
mod explained;
mod figures;
mod findings;
mod fragment;
mod look;
mod plots;
mod shell;
mod spool;
mod values;

use std::fs::File;
use std::io::Read;
use std::path::Path;

use anyhow::{Result, bail};

use crate::folders::{self, Folders};
use crate::look::Look;
use crate::place::Ledger;
use crate::run::interrupt;
use crate::sources::{Source, Sources};
use crate::terminal::{Exit, Terminal};
use crate::write::{Mode, Prepared};

pub(crate) use change::{Changed, Files, of_change};
pub(crate) use entry::{Columns, Entry};
use explained::Topics;
pub(crate) use fragment::Frame;
pub(crate) use look::entry_of_look;
use spool::Spool;

/// Models of a library that are shown in full; the others are rows of the table.
const IN_FULL: usize = 1000;
/// Models of a library that get plots, which are most of a page.
const WITH_PLOTS: usize = 10;
/// Closed details of more models than this stay closed on paper.
const OPEN_ON_PAPER: usize = 20;

/// What a page is about.
#[derive(Debug, Clone)]
pub(crate) struct About {
    /// The verb, as on the command line.
    pub verb: &'static str,
    /// The model, where it is one.
    pub model: Option<String>,
    pub columns: Columns,
}

impl About {
    fn title(&self, models: usize) -> String {
        let what = match self.verb {
            "rescale" => "Rescaled contacts",
            "transfer" => "Transferred contacts",
            "design" => "Designed contacts",
            "check" => "Check of contacts",
            "inspect" => "Contacts",
            _ => "Changed contacts",
        };
        match &self.model {
            Some(model) => format!("{what}: {}", file_name(model)),
            None => format!("{what}: {models} models"),
        }
    }
}

/// The last part of a path as it is shown.
fn file_name(shown: &str) -> &str {
    if shown == "-" {
        return "standard input";
    }
    Path::new(shown).file_name().and_then(std::ffi::OsStr::to_str).unwrap_or(shown)
}

/// What a page may take the place of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Replace {
    Never,
    /// Pages of this program: a run that goes on writes its page anew.
    Pages,
    /// Any file.
    Files,
}

/// A page that is being written.
pub(crate) struct Page {
    prepared: Prepared,
    about: About,
    rows: Spool,
    details: Spool,
    topics: Topics,
    /// Sections of the one model.
    sections: Vec<(&'static str, &'static str)>,
    models: usize,
    in_full: usize,
    /// Some model is shown in full and has no plots, because it is not among the first.
    without_plots: bool,
    /// The first thing that went wrong: a page that cannot be written is no reason to leave models undone.
    broken: Option<anyhow::Error>,
}

impl Page {
    /// Begins the page that `path` will hold.
    ///
    /// # Errors
    /// A name that is no page's, a file that is there already, or a folder that cannot be written.
    pub(crate) fn begin(path: &Path, replace: Replace, about: About) -> Result<Self> {
        check_name(path)?;
        let replaces = match replace {
            Replace::Never => false,
            Replace::Pages => is_page(path),
            Replace::Files => true,
        };
        if path.exists() && !replaces {
            bail!(
                "the report {} exists already: choose another name, or replace it with --force",
                path.display()
            );
        }
        folders::make(path)?;
        let mode = if replaces { Mode::Replace } else { Mode::New };
        let prepared = Prepared::begin(path, None, mode)?;
        let (rows, details) = (Spool::beside(path)?, Spool::beside(path)?);
        Ok(Self {
            prepared,
            about,
            rows,
            details,
            topics: Topics::default(),
            sections: Vec::new(),
            models: 0,
            in_full: 0,
            without_plots: false,
            broken: None,
        })
    }

    /// The page of `look`, if one is asked for; what could not even be listed is on it already.
    ///
    /// # Errors
    /// As [`begin`](Self::begin), or a file that is read has that name.
    pub(crate) fn of_looks(look: &Look<'_>, sources: &Sources) -> Result<Option<Self>> {
        let Some(path) = &look.report.report else { return Ok(None) };
        let mut ledger = Ledger::default();
        sources.models.iter().for_each(|source| ledger.read(&source.path));
        look.reads().for_each(|path| ledger.read(path));
        ledger.write(path, "--report")?;
        let shown = match (sources.models.as_slice(), sources.failures.as_slice()) {
            ([source], []) => Some(source.shown()),
            ([], [failure]) => Some(failure.model.clone()),
            _ => None,
        };
        let about = About { verb: look.verb, model: shown, columns: Columns::Looks };
        let replace = if look.report.force { Replace::Files } else { Replace::Never };
        interrupt::outlive_size_limit();
        Folders::look(std::iter::once(path.as_path()), true);
        let mut page = Self::begin(path, replace, about)?;
        sources.failures.iter().for_each(|failure| page.tell(Entry::lost(failure)));
        Ok(Some(page))
    }

    /// The next model.
    pub(crate) fn tell(&mut self, entry: Entry) {
        if self.broken.is_none() {
            self.broken = self.add(entry).err();
        }
    }

    fn add(&mut self, mut entry: Entry) -> Result<()> {
        self.models += 1;
        let alone = self.about.model.is_some();
        let fragment = entry.fragment.take().filter(|_| self.in_full < IN_FULL);
        if alone && fragment.is_none() {
            self.details.add(&entry::alone(&entry, &mut self.topics))?;
        }
        if !alone {
            let place = (self.models, fragment.is_some());
            self.rows.add(&entry::row(&entry, self.about.columns, place, &mut self.topics))?;
        }
        let Some(fragment) = fragment else { return Ok(()) };
        self.in_full += 1;
        self.without_plots |= !fragment.frame.plots;
        self.topics.add(&fragment.topics);
        if alone {
            self.sections = fragment.sections;
            self.details.add(&fragment.html)
        } else {
            self.details.add(&entry::details(&entry, self.models, &fragment.html))
        }
    }

    /// Ends the page, if there is one; what cannot be written is told.
    pub(crate) fn end(page: Option<Self>, terminal: &mut Terminal) -> Exit {
        match page.map_or(Ok(()), Self::finish) {
            Ok(()) => Exit::Done,
            Err(error) => {
                terminal.error(&format!("error: the report: {error:#}\n"));
                Exit::Failed
            }
        }
    }

    /// Writes the page under its name.
    fn finish(mut self) -> Result<()> {
        if let Some(error) = self.broken {
            return Err(error);
        }
        let paper = if self.models > OPEN_ON_PAPER { "closed-on-paper" } else { "open-on-paper" };
        let title = self.about.title(self.models);
        let sections = self.all_sections();
        self.prepared.add(shell::opening(&title, paper, &sections).as_bytes())?;
        self.prepared.add(shell::asked(self.about.verb).as_bytes())?;
        if self.about.model.is_none() {
            self.prepared.add(entry::table_opening(self.about.columns, &self.left_out()).as_bytes())?;
            self.rows.pour_into(&mut self.prepared)?;
            self.prepared.add(entry::TABLE_END.as_bytes())?;
            if self.in_full > 0 {
                self.prepared.add(entry::DETAILS_BEGIN.as_bytes())?;
            }
        }
        self.details.pour_into(&mut self.prepared)?;
        if self.about.model.is_none() && self.in_full > 0 {
            self.prepared.add(entry::DETAILS_END.as_bytes())?;
        }
        if !self.topics.is_empty() {
            self.prepared.add(explained::section(&self.topics).as_bytes())?;
        }
        self.prepared.add(shell::closing().as_bytes())?;
        self.prepared.commit()
    }

    fn all_sections(&self) -> Vec<(&'static str, &'static str)> {
        let mut sections = vec![shell::ASKED];
        match &self.about.model {
            Some(_) => sections.extend(&self.sections),
            None => {
                sections.push(entry::MODELS);
                sections.extend(Some(entry::IN_FULL).filter(|_| self.in_full > 0));
            }
        }
        sections.extend(Some(explained::SECTION).filter(|_| !self.topics.is_empty()));
        sections.push(shell::ORIGIN);
        sections
    }

    /// What a large library's page leaves out, and how to get it.
    fn left_out(&self) -> Vec<String> {
        let mut said = Vec::new();
        if self.models > IN_FULL {
            said.push(format!(
                "Only the first {IN_FULL} models are shown in full. For any other, ask for a page of its own: \
                 osim-contact-scale inspect MODEL --report FILE.html"
            ));
        }
        if self.without_plots {
            said.push(format!(
                "Only the first {WITH_PLOTS} models have plots. For any other, ask for a page of its own, or for a \
                 picture: osim-contact-scale plot force MODEL -o FILE.svg"
            ));
        }
        said
    }
}

/// `true` for a page that this program wrote, which says so in its head.
fn is_page(path: &Path) -> bool {
    let mut head = Vec::new();
    let read = File::open(path).and_then(|file| file.take(HEAD).read_to_end(&mut head));
    read.is_ok() && memchr::memmem::find(&head, shell::GENERATOR.as_bytes()).is_some()
}

/// Bytes in which a page says what wrote it.
const HEAD: u64 = 1024;

fn check_name(path: &Path) -> Result<()> {
    let ending = path.extension().map(|ending| ending.to_string_lossy().to_ascii_lowercase());
    match ending.as_deref() {
        Some("html" | "htm") => Ok(()),
        _ => bail!("--report '{}': expected the name of a page, such as report.html", path.display()),
    }
}

/// How the model at `item` of `items` is shown: alone, or as one of many, the first of which have plots.
pub(crate) fn frame<T>(items: &[T], item: &T, alone: bool) -> Frame {
    let among_first = || items.iter().take(WITH_PLOTS).any(|first| std::ptr::eq(first, item));
    Frame { alone, plots: alone || among_first() }
}

/// The same of a model that is looked at; none where no page is asked for.
pub(crate) fn frame_of_look(look: &Look<'_>, source: &Source, sources: &Sources) -> Option<Frame> {
    let alone = sources.models.len() + sources.failures.len() == 1;
    look.report.report.as_ref().map(|_| frame(&sources.models, source, alone))
}
