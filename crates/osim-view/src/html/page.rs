//! The page, put together.

use std::io::{self, Write};

use osim_model::messages::{Input, Verb, terminal_safe};
use osim_requests::spell::FrontEnd;

use crate::html::entry::Entry;
use crate::html::explained::{self, Topics, file_name};
use crate::html::fragment::Fragment;
use crate::html::glance::{self, Tally};
use crate::html::models_table::{self, Columns};
use crate::html::shell;
use crate::html::special::{Chosen, MOST};

/// Models of a library that are shown in full; the others are rows of the table.
const IN_FULL: usize = 1000;
/// Closed details of more models than this stay closed on paper.
const OPEN_ON_PAPER: usize = 20;

/// A page that is being made.
///
/// ```
/// use osim_model::messages::Verb;
/// use osim_requests::spell::CommandLine;
/// use osim_view::html::{About, Columns, Entry, InMemory, Kept, Page};
///
/// let about = About::new(Verb::Check, None, Columns::Inspections, "osim-contact-scale check models");
/// let mut page = Page::new(about, Kept::<InMemory>::default(), &CommandLine);
/// page.add(Entry::without_contacts("models/arm.osim"));
/// let mut bytes = Vec::new();
/// page.finish(&mut bytes)?;
/// assert!(bytes.starts_with(b"<!DOCTYPE html>"));
/// # Ok::<(), std::io::Error>(())
/// ```
pub struct Page<'d, S> {
    about: About,
    kept: Kept<S>,
    dialect: &'d dyn FrontEnd,
    topics: Topics,
    /// Sections of the one model.
    sections: Vec<(&'static str, &'static str)>,
    tally: Tally,
    chosen: Chosen,
    in_full: usize,
    /// Whether some model is a row only, because it is not among the first.
    rows_only: bool,
    /// The first thing that went wrong.
    broken: Option<io::Error>,
}

/// Where text waits until what is before it on the page is known.
#[derive(Debug, Default)]
pub struct Kept<S> {
    /// Rows of models that failed.
    pub failures: S,
    /// Rows of the others.
    pub rows: S,
    /// Everything else about each model.
    pub details: S,
}

impl<'d, S: DeferredText> Page<'d, S> {
    /// A page without models; `kept` holds what has to wait.
    pub fn new(about: About, kept: Kept<S>, dialect: &'d dyn FrontEnd) -> Self {
        Self {
            about,
            kept,
            dialect,
            topics: Topics::default(),
            sections: Vec::new(),
            tally: Tally::default(),
            chosen: Chosen::default(),
            in_full: 0,
            rows_only: false,
            broken: None,
        }
    }

    /// Adds the next model. If the page cannot be kept, models are still done: [`Page::finish`] says what went wrong.
    pub fn add(&mut self, entry: Entry) {
        if self.broken.is_none() {
            self.broken = self.try_add(entry).err();
        }
    }

    fn try_add(&mut self, mut entry: Entry) -> io::Result<()> {
        self.tally.add(&entry);
        let fragment = entry.fragment.take();
        if self.about.model.is_some() {
            return self.add_alone(&entry, fragment.map(|fragment| *fragment));
        }
        if entry.failed {
            return self.kept.failures.add(&terminal_safe(&models_table::failure(&entry, &mut self.topics)));
        }
        let number = self.tally.models();
        if let (Some(facts), Some(drawn)) = (&entry.facts, entry.drawn.take()) {
            self.chosen.offer(number, &entry.model, facts, drawn);
        }
        self.rows_only |= fragment.is_some() && self.in_full >= IN_FULL;
        let fragment = fragment.filter(|_| self.in_full < IN_FULL);
        let details = fragment.is_some().then_some(number);
        self.kept.rows.add(&terminal_safe(&models_table::row(
            &entry,
            self.about.columns,
            details,
            &mut self.topics,
        )))?;
        let Some(fragment) = fragment else { return Ok(()) };
        self.in_full += 1;
        self.topics.add(&fragment.topics);
        self.kept.details.add(&terminal_safe(&models_table::details(&entry, number, &fragment.html())))
    }

    fn add_alone(&mut self, entry: &Entry, fragment: Option<Fragment>) -> io::Result<()> {
        let glance = glance::of_one(entry, &models_table::code(entry, &mut self.topics));
        self.kept.rows.add(&terminal_safe(&glance.0))?;
        let Some(fragment) = fragment else { return Ok(()) };
        self.topics.add(&fragment.topics);
        self.sections = fragment.sections.iter().map(|section| (section.id, section.title)).collect();
        self.kept.details.add(&terminal_safe(&fragment.html()))
    }

    /// Writes the page.
    ///
    /// # Errors
    /// It cannot be written, or something could not be kept when it was added.
    pub fn finish(mut self, page: &mut dyn Write) -> io::Result<()> {
        if let Some(error) = self.broken {
            return Err(error);
        }
        let several = self.about.model.is_none();
        let title = self.about.title(self.tally.models());
        // Codes that are counted are explained.
        let findings = if several { self.tally.findings(&mut self.topics).0 } else { String::new() };
        let sections = self.all_sections();
        page.write_all(terminal_safe(&shell::opening(&title, self.class(), &sections)).as_bytes())?;
        if several {
            self.write_library(&findings, page)?;
        } else {
            self.kept.rows.pour_into(page)?;
            self.write_asked(page)?;
            self.kept.details.pour_into(page)?;
        }
        if !self.topics.is_empty() {
            page.write_all(explained::section(&self.topics, self.dialect).as_bytes())?;
        }
        page.write_all(shell::closing().as_bytes())
    }

    fn write_library(&mut self, findings: &str, page: &mut dyn Write) -> io::Result<()> {
        let left_out = self.left_out();
        page.write_all(models_table::glance_opening(&self.tally.counts()).as_bytes())?;
        if self.tally.has_failures() {
            page.write_all(models_table::failures_opening(self.about.columns).as_bytes())?;
            self.kept.failures.pour_into(page)?;
            page.write_all(models_table::FAILURES_END.as_bytes())?;
        }
        page.write_all(findings.as_bytes())?;
        page.write_all(models_table::SECTION_END.as_bytes())?;
        self.write_asked(page)?;
        page.write_all(terminal_safe(&self.tally.chart().0).as_bytes())?;
        page.write_all(models_table::table_opening(self.about.columns, &left_out).as_bytes())?;
        self.kept.rows.pour_into(page)?;
        page.write_all(models_table::TABLE_END.as_bytes())?;
        if !self.chosen.is_empty() {
            page.write_all(terminal_safe(&models_table::section(&self.chosen, self.dialect).0).as_bytes())?;
        }
        if self.in_full > 0 {
            page.write_all(models_table::DETAILS_BEGIN.as_bytes())?;
            self.kept.details.pour_into(page)?;
            page.write_all(models_table::SECTION_END.as_bytes())?;
        }
        Ok(())
    }

    fn write_asked(&self, page: &mut dyn Write) -> io::Result<()> {
        page.write_all(terminal_safe(&shell::asked(self.about.verb, &self.about.asked)).as_bytes())
    }

    /// The class of the page in the style sheet.
    fn class(&self) -> &'static str {
        match (self.about.model.is_none(), self.tally.models() > OPEN_ON_PAPER) {
            (false, _) => "one open-on-paper",
            (true, false) => "library open-on-paper",
            (true, true) => "library closed-on-paper",
        }
    }

    fn all_sections(&self) -> Vec<(&'static str, &'static str)> {
        let mut sections = vec![glance::SECTION, shell::ASKED];
        match &self.about.model {
            Some(_) => sections.extend(&self.sections),
            None => {
                sections.extend(Some(glance::CHART).filter(|_| self.tally.has_chart()));
                sections.push(models_table::MODELS);
                sections.extend(Some(models_table::SECTION).filter(|_| !self.chosen.is_empty()));
                sections.extend(Some(models_table::IN_FULL).filter(|_| self.in_full > 0));
            }
        }
        sections.extend(Some(explained::SECTION).filter(|_| !self.topics.is_empty()));
        sections.push(shell::ORIGIN);
        sections
    }

    /// What a large library's page leaves out, and how to get it.
    fn left_out(&self) -> Vec<String> {
        let mut left_out = Vec::new();
        if self.rows_only {
            let call = Verb::Inspect.call_with_model().with_placeholder(Input::Report, "FILE.html");
            left_out.push(format!(
                "Only the first {IN_FULL} models are shown in full. For any other, ask for a page of its own: {}",
                self.dialect.command(&call)
            ));
        }
        if self.chosen.models() > MOST {
            let plot = Verb::Plot
                .call_with_model()
                .with_value(Input::Kind, "force")
                .with_placeholder(Input::Output, "FILE.svg");
            left_out.push(format!(
                "At most {} models have plots; “{}” says why each was chosen. For any other, ask for a page of its own, or \
                 for a picture: {}",
                MOST,
                models_table::SECTION.1,
                self.dialect.command(&plot)
            ));
        }
        left_out
    }
}

#[derive(Debug, Clone)]
pub struct About {
    pub verb: Verb,
    pub model: Option<String>,
    /// Which table the models are in, where they are several.
    pub columns: Columns,
    /// What was asked, as the reader would ask for it again.
    pub asked: String,
}

impl About {
    /// A page about models to which `verb` was done; about one where `model` names it.
    pub fn new(verb: Verb, model: Option<String>, columns: Columns, asked: impl Into<String>) -> Self {
        Self { verb, model, columns, asked: asked.into() }
    }

    pub(super) fn title(&self, models: usize) -> String {
        let what = match self.verb {
            Verb::Rescale => "Rescaled contacts",
            Verb::Transfer => "Transferred contacts",
            Verb::Add => "Added contacts",
            Verb::Convert => "Converted contacts",
            Verb::Remove => "Removed contacts",
            Verb::Design => "Designed contacts",
            Verb::Note => "Noted contacts",
            Verb::Check => "Check of contacts",
            Verb::Inspect => "Contacts",
            _ => "Changed contacts",
        };
        match &self.model {
            Some(model) => format!("{what}: {}", file_name(model)),
            None => format!("{what}: {models} models"),
        }
    }
}

// Text that waits until what is before it on the page is known.

/// Text that waits: in memory, or in a file that has no name.
pub trait DeferredText {
    /// Adds a piece.
    ///
    /// # Errors
    /// It cannot be kept: the disk is full.
    fn add(&mut self, text: &str) -> io::Result<()>;

    /// Writes everything that was added, in its order.
    ///
    /// # Errors
    /// It cannot be read back, or the page cannot be written.
    fn pour_into(&mut self, page: &mut dyn Write) -> io::Result<()>;
}

/// Text that waits in memory.
#[derive(Debug, Clone, Default)]
pub struct InMemory(String);

impl DeferredText for InMemory {
    fn add(&mut self, text: &str) -> io::Result<()> {
        self.0.push_str(text);
        Ok(())
    }

    fn pour_into(&mut self, page: &mut dyn Write) -> io::Result<()> {
        page.write_all(self.0.as_bytes())
    }
}
