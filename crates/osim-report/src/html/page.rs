//! The page, put together.

use std::io::{self, Write};

use osim_model::wording::{Input, Verb, harmless};

use super::about::About;
use super::deferred::DeferredText;
use super::detail_level::WITH_PLOTS;
use super::entry::Entry;
use super::explained::{self, Topics};
use super::models_table as models;
use super::shell;
use crate::dialect::FrontEnd;

/// Models of a library that are shown in full; the others are rows of the table.
const IN_FULL: usize = 1000;
/// Closed details of more models than this stay closed on paper.
const OPEN_ON_PAPER: usize = 20;

/// A page that is being made.
///
/// ```
/// use osim_model::wording::Verb;
/// use osim_report::dialect::CommandLine;
/// use osim_report::html::{About, Columns, Entry, InMemory, Page};
///
/// let about = About::new(Verb::Check, None, Columns::Inspections, "osim-contact-scale check models");
/// let mut page = Page::new(about, InMemory::default(), InMemory::default(), &CommandLine);
/// page.add(Entry::without_contacts("models/arm.osim"));
/// let mut bytes = Vec::new();
/// page.finish(&mut bytes)?;
/// assert!(bytes.starts_with(b"<!DOCTYPE html>"));
/// # Ok::<(), std::io::Error>(())
/// ```
pub struct Page<'d, S> {
    about: About,
    rows: S,
    details: S,
    dialect: &'d dyn FrontEnd,
    topics: Topics,
    /// Sections of the one model.
    sections: Vec<(&'static str, &'static str)>,
    models: usize,
    in_full: usize,
    /// Some model is shown in full and has no plots, because it is not among the first.
    without_plots: bool,
    /// The first thing that went wrong.
    broken: Option<io::Error>,
}

impl<'d, S: DeferredText> Page<'d, S> {
    /// A page without models; `rows` and `details` keep what has to wait.
    pub fn new(about: About, rows: S, details: S, dialect: &'d dyn FrontEnd) -> Self {
        Self {
            about,
            rows,
            details,
            dialect,
            topics: Topics::default(),
            sections: Vec::new(),
            models: 0,
            in_full: 0,
            without_plots: false,
            broken: None,
        }
    }

    /// The next model. A page that cannot be kept is no reason to leave models undone: [`Page::finish`] says what went wrong.
    pub fn add(&mut self, entry: Entry) {
        if self.broken.is_none() {
            self.broken = self.try_add(entry).err();
        }
    }

    fn try_add(&mut self, mut entry: Entry) -> io::Result<()> {
        self.models += 1;
        let alone = self.about.model.is_some();
        let fragment = entry.fragment.take().filter(|_| self.in_full < IN_FULL);
        if alone && fragment.is_none() {
            self.details.add(&harmless(&models::alone(&entry, &mut self.topics)))?;
        }
        if !alone {
            let place = (self.models, fragment.is_some());
            self.rows.add(&harmless(&models::row(&entry, self.about.columns, place, &mut self.topics)))?;
        }
        let Some(fragment) = fragment else { return Ok(()) };
        self.in_full += 1;
        self.without_plots |= !fragment.detail.has_plots();
        self.topics.add(&fragment.topics);
        if alone {
            self.sections = fragment.sections;
            self.details.add(&harmless(&fragment.html))
        } else {
            self.details.add(&harmless(&models::details(&entry, self.models, &fragment.html)))
        }
    }

    /// Writes the page.
    ///
    /// # Errors
    /// It cannot be written, or something could not be kept when it was added.
    pub fn finish(mut self, page: &mut dyn Write) -> io::Result<()> {
        if let Some(error) = self.broken {
            return Err(error);
        }
        let paper = if self.models > OPEN_ON_PAPER { "closed-on-paper" } else { "open-on-paper" };
        let title = self.about.title(self.models);
        let several = self.about.model.is_none();
        page.write_all(harmless(&shell::opening(&title, paper, &self.all_sections())).as_bytes())?;
        page.write_all(harmless(&shell::asked(self.about.verb, &self.about.asked)).as_bytes())?;
        if several {
            page.write_all(models::table_opening(self.about.columns, &self.left_out()).as_bytes())?;
            self.rows.pour_into(page)?;
            page.write_all(models::TABLE_END.as_bytes())?;
            if self.in_full > 0 {
                page.write_all(models::DETAILS_BEGIN.as_bytes())?;
            }
        }
        self.details.pour_into(page)?;
        if several && self.in_full > 0 {
            page.write_all(models::DETAILS_END.as_bytes())?;
        }
        if !self.topics.is_empty() {
            page.write_all(explained::section(&self.topics, self.dialect).as_bytes())?;
        }
        page.write_all(shell::closing().as_bytes())
    }

    fn all_sections(&self) -> Vec<(&'static str, &'static str)> {
        let mut sections = vec![shell::ASKED];
        match &self.about.model {
            Some(_) => sections.extend(&self.sections),
            None => {
                sections.push(models::MODELS);
                sections.extend(Some(models::IN_FULL).filter(|_| self.in_full > 0));
            }
        }
        sections.extend(Some(explained::SECTION).filter(|_| !self.topics.is_empty()));
        sections.push(shell::ORIGIN);
        sections
    }

    /// What a large library's page leaves out, and how to get it.
    fn left_out(&self) -> Vec<String> {
        let mut left_out = Vec::new();
        if self.models > IN_FULL {
            let call = Verb::Inspect.of_model().with(Input::Report, "FILE.html");
            left_out.push(format!(
                "Only the first {IN_FULL} models are shown in full. For any other, ask for a page of its own: {}",
                self.dialect.command(&call)
            ));
        }
        if self.without_plots {
            let plot = Verb::Plot.of_model().saying(Input::Kind, "force").with(Input::Output, "FILE.svg");
            left_out.push(format!(
                "Only the first {WITH_PLOTS} models have plots. For any other, ask for a page of its own, or for a \
                 picture: {}",
                self.dialect.command(&plot)
            ));
        }
        left_out
    }
}
