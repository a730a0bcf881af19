//! The page of `--report` about a run, made of the entries of models: readable for people, and a record of the run.
//!
//! The page holds everything itself: no script, no font, no picture from elsewhere. Workers make the [`Entry`] of a model;
//! [`Page`] puts entries together in the order of the models. Rows and details wait as [`DeferredText`], so that memory can
//! stay flat however many models there are.
//!
//! ```
//! use osim_view::html::{PageHead, Columns, DeferredParts, Page};
//! use osim_model::messages::Verb;
//! use osim_requests::spell::CommandLine;
//!
//! let call = "osim-contact-scale check models".to_owned();
//! let head = PageHead { verb: Verb::Check, model: None, columns: Columns::Inspections, call };
//! let page = Page::new(head, DeferredParts::<String>::default(), &CommandLine);
//! let mut bytes = Vec::new();
//! page.finish(&mut bytes)?;
//! let text = String::from_utf8_lossy(&bytes);
//! assert!(text.starts_with("<!DOCTYPE html>") && text.contains("The command of this page") && !text.contains("<script"));
//! # Ok::<(), std::io::Error>(())
//! ```

mod change;
mod entry;
mod explained;
mod findings;
mod fragment;
mod inspected;
mod models_table;
mod overview;
mod page_frame;
mod plots;
mod reference;
mod sections;
mod special_models;
mod sphere_figures;

use std::io::{self, Write};

use osim_model::messages::{Input, Verb, terminal_safe};
use osim_requests::spell::FrontEnd;
use osim_requests::verb_entry;

use crate::html::explained::{Topics, file_name};
use crate::html::fragment::Fragment;
use crate::html::overview::PageCounts;
use crate::html::special_models::{ChosenModels, MOST_DRAWN_MODELS};

pub use change::{ChangedModelOnPage, entry_of_changed_model};
pub use entry::{Entry, RunRow};
pub use fragment::{DetailLevel, Section};
pub use inspected::{InspectedModelOnPage, ListedFiles, NamedDigest, entry_of_inspected_model};
pub use models_table::Columns;
pub use page_frame::GENERATOR;
pub use plots::recording;
pub use sections::{Explained, Sections};

/// The largest number of models with details. Other models only have a row in the table.
const MOST_MODELS_IN_FULL: usize = 1000;
/// The largest number of models whose folded details are printed open.
const MOST_OPEN_ON_PAPER: usize = 20;

/// A page, to which entries of models are added one after the other.
///
/// ```
/// use osim_model::messages::Verb;
/// use osim_requests::spell::CommandLine;
/// use osim_view::html::{PageHead, Columns, Entry, DeferredParts, Page};
///
/// let call = "osim-contact-scale check models".to_owned();
/// let head = PageHead { verb: Verb::Check, model: None, columns: Columns::Inspections, call };
/// let mut page = Page::new(head, DeferredParts::<String>::default(), &CommandLine);
/// page.add(Entry::without_contacts("models/arm.osim"));
/// let mut bytes = Vec::new();
/// page.finish(&mut bytes)?;
/// assert!(bytes.starts_with(b"<!DOCTYPE html>"));
/// # Ok::<(), std::io::Error>(())
/// ```
pub struct Page<'d, S> {
    head: PageHead,
    parts: DeferredParts<S>,
    dialect: &'d dyn FrontEnd,
    topics: Topics,
    /// Ids and titles of the sections, if the page is about one model.
    sections: Vec<(&'static str, &'static str)>,
    counts: PageCounts,
    chosen: ChosenModels,
    shown_in_full: usize,
    /// Whether some models have no details because there are too many models.
    rows_only: bool,
    /// The first error that occurred while entries were added.
    first_error: Option<io::Error>,
}

/// Parts of the page that can only be written after the parts before them are complete.
#[derive(Debug, Default)]
pub struct DeferredParts<S> {
    /// Rows of the table for models that failed.
    pub failures: S,
    /// Rows of the table for the models that did not fail.
    pub rows: S,
    /// The sections with details about each model.
    pub details: S,
}

impl<'d, S: DeferredText> Page<'d, S> {
    /// A page without models. `parts` stores the texts of the page until it is written.
    pub fn new(head: PageHead, parts: DeferredParts<S>, dialect: &'d dyn FrontEnd) -> Self {
        Self {
            head,
            parts,
            dialect,
            topics: Topics::default(),
            sections: Vec::new(),
            counts: PageCounts::default(),
            chosen: ChosenModels::default(),
            shown_in_full: 0,
            rows_only: false,
            first_error: None,
        }
    }

    /// Adds the entry of the next model. An error is only returned by [`Page::finish`], so that the other models are still added.
    pub fn add(&mut self, entry: Entry) {
        if self.first_error.is_none() {
            self.first_error = self.add_entry(entry).err();
        }
    }

    fn add_entry(&mut self, mut entry: Entry) -> io::Result<()> {
        self.counts.add(&entry);
        let fragment = entry.fragment.take();
        if self.head.model.is_some() {
            return self.add_alone(&entry, fragment.map(|fragment| *fragment));
        }
        if entry.failed {
            return self.parts.failures.add(&terminal_safe(&models_table::failure(&entry, &mut self.topics)));
        }
        let number = self.counts.models;
        if let (Some(facts), Some(drawn)) = (&entry.facts, entry.drawn.take()) {
            self.chosen.consider(number, &entry.model, facts, drawn);
        }
        self.rows_only |= fragment.is_some() && self.shown_in_full >= MOST_MODELS_IN_FULL;
        let fragment = fragment.filter(|_| self.shown_in_full < MOST_MODELS_IN_FULL);
        let details = fragment.is_some().then_some(number);
        self.parts.rows.add(&terminal_safe(&models_table::row(
            &entry,
            self.head.columns,
            details,
            &mut self.topics,
        )))?;
        let Some(fragment) = fragment else { return Ok(()) };
        self.shown_in_full += 1;
        self.topics.add(&fragment.topics);
        self.parts.details.add(&terminal_safe(&models_table::details(&entry, number, &fragment.html())))
    }

    fn add_alone(&mut self, entry: &Entry, fragment: Option<Fragment>) -> io::Result<()> {
        let overview = overview::overview_of_one_model(entry, &models_table::code(entry, &mut self.topics));
        self.parts.rows.add(&terminal_safe(&overview.0))?;
        let Some(fragment) = fragment else { return Ok(()) };
        self.topics.add(&fragment.topics);
        self.sections = fragment.sections.iter().map(|section| (section.id, section.title)).collect();
        self.parts.details.add(&terminal_safe(&fragment.html()))
    }

    /// Writes the page with the entries of all models.
    ///
    /// # Errors
    /// The page cannot be written, or an entry could not be added.
    pub fn finish(mut self, page: &mut dyn Write) -> io::Result<()> {
        if let Some(error) = self.first_error {
            return Err(error);
        }
        let several = self.head.model.is_none();
        let title = self.head.title(self.counts.models);
        // This table adds codes, which are explained later.
        let findings = if several { self.counts.findings(&mut self.topics).0 } else { String::new() };
        let sections = self.all_sections();
        page.write_all(terminal_safe(&page_frame::opening(&title, self.page_class(), &sections)).as_bytes())?;
        if several {
            self.write_library(&findings, page)?;
        } else {
            self.parts.rows.write_to(page)?;
            self.write_call(page)?;
            self.parts.details.write_to(page)?;
        }
        if !self.topics.is_empty() {
            page.write_all(explained::explained_section(&self.topics, self.dialect).as_bytes())?;
        }
        page.write_all(page_frame::origin_and_closing().as_bytes())
    }

    fn write_library(&mut self, findings: &str, page: &mut dyn Write) -> io::Result<()> {
        let remarks_on_omissions = self.remarks_on_omissions();
        writeln!(page, "{}{}", page_frame::section_opening(overview::SECTION_HEAD), self.counts.counts().0)?;
        if self.counts.failed > 0 {
            page.write_all(models_table::failures_opening(self.head.columns).as_bytes())?;
            self.parts.failures.write_to(page)?;
            page.write_all(models_table::END_OF_FAILURES.as_bytes())?;
        }
        page.write_all(findings.as_bytes())?;
        page.write_all(models_table::END_OF_SECTION.as_bytes())?;
        self.write_call(page)?;
        page.write_all(terminal_safe(&self.counts.chart().0).as_bytes())?;
        page.write_all(models_table::table_opening(self.head.columns, &remarks_on_omissions).as_bytes())?;
        self.parts.rows.write_to(page)?;
        page.write_all(models_table::END_OF_TABLE.as_bytes())?;
        if !self.chosen.is_empty() {
            page.write_all(terminal_safe(&models_table::section(&self.chosen, self.dialect).0).as_bytes())?;
        }
        if self.shown_in_full > 0 {
            writeln!(page, "{}", page_frame::section_opening(models_table::MODELS_IN_FULL_SECTION))?;
            self.parts.details.write_to(page)?;
            page.write_all(models_table::END_OF_SECTION.as_bytes())?;
        }
        Ok(())
    }

    fn write_call(&self, page: &mut dyn Write) -> io::Result<()> {
        page.write_all(terminal_safe(&page_frame::purpose(self.head.verb, &self.head.call)).as_bytes())
    }

    /// The classes of the page in the style sheet: one model or a library, and whether its sections are open on paper.
    fn page_class(&self) -> &'static str {
        match (self.head.model.is_none(), self.counts.models > MOST_OPEN_ON_PAPER) {
            (false, _) => "one open-on-paper",
            (true, false) => "library open-on-paper",
            (true, true) => "library closed-on-paper",
        }
    }

    fn all_sections(&self) -> Vec<(&'static str, &'static str)> {
        let mut sections = vec![overview::SECTION_HEAD, page_frame::COMMAND_SECTION];
        match &self.head.model {
            Some(_) => sections.extend(&self.sections),
            None => {
                sections.extend(Some(overview::CHART_OF_INDENTATIONS).filter(|_| self.counts.now.len() > 1));
                sections.push(models_table::MODELS_SECTION);
                sections.extend(Some(models_table::SECTION_HEAD).filter(|_| !self.chosen.is_empty()));
                sections
                    .extend(Some(models_table::MODELS_IN_FULL_SECTION).filter(|_| self.shown_in_full > 0));
            }
        }
        sections.extend(Some(explained::SECTION_HEAD).filter(|_| !self.topics.is_empty()));
        sections.push(page_frame::ORIGIN_SECTION);
        sections
    }

    /// Remarks about the parts that the page of a large library leaves out, with the commands that show them.
    fn remarks_on_omissions(&self) -> Vec<String> {
        let mut remarks_on_omissions = Vec::new();
        if self.rows_only {
            let call = Verb::Inspect.call_with_model().with_placeholder(Input::Report, "FILE.html");
            remarks_on_omissions.push(format!(
                "Only the first {MOST_MODELS_IN_FULL} models are shown in full. For any other, ask for a page of its own: {}",
                self.dialect.command(&call)
            ));
        }
        if self.chosen.models > MOST_DRAWN_MODELS {
            let plot = Verb::Plot
                .call_with_model()
                .with_value(Input::Kind, "force")
                .with_placeholder(Input::Output, "FILE.svg");
            remarks_on_omissions.push(format!(
                "At most {} models have plots; “{}” says why each was chosen. For any other, ask for a page of its own, or \
                 for a picture: {}",
                MOST_DRAWN_MODELS,
                models_table::SECTION_HEAD.1,
                self.dialect.command(&plot)
            ));
        }
        remarks_on_omissions
    }
}

/// What a report page is about: its verb, its model and the command that made it.
#[derive(Debug, Clone)]
pub struct PageHead {
    pub verb: Verb,
    pub model: Option<String>,
    /// The columns of the table, if the page is about several models.
    pub columns: Columns,
    /// The command that made the page, as the user would type it.
    pub call: String,
}

impl PageHead {
    fn title(&self, models: usize) -> String {
        let what = verb_entry(self.verb).contacts;
        match &self.model {
            Some(model) => format!("{what}: {}", file_name(model)),
            None => format!("{what}: {models} models"),
        }
    }
}

/// A text that is stored, in memory or in a file without a name, until the page is written.
pub trait DeferredText {
    /// Adds a piece to the text.
    ///
    /// # Errors
    /// The disk is full.
    fn add(&mut self, text: &str) -> io::Result<()>;

    /// Writes the whole text to the page.
    ///
    /// # Errors
    /// The text cannot be read back, or the page cannot be written.
    fn write_to(&mut self, page: &mut dyn Write) -> io::Result<()>;
}

/// A text that is kept in memory.
impl DeferredText for String {
    fn add(&mut self, text: &str) -> io::Result<()> {
        self.push_str(text);
        Ok(())
    }

    fn write_to(&mut self, page: &mut dyn Write) -> io::Result<()> {
        page.write_all(self.as_bytes())
    }
}
