//! One page about a run, for people and for the record.
//!
//! The page holds everything itself: no script, no font, no picture from elsewhere. Workers make the [`Entry`] of a model;
//! [`Page`] puts entries together in the order of the models. Rows and details wait as [`DeferredText`], so that memory can
//! stay flat however many models there are.
//!
//! ```
//! use osim_view::html::{About, Columns, InMemory, Kept, Page};
//! use osim_model::messages::Verb;
//! use osim_requests::spell::CommandLine;
//!
//! let about = About::new(Verb::Check, None, Columns::Inspections, "osim-contact-scale check models");
//! let page = Page::new(about, Kept::<InMemory>::default(), &CommandLine);
//! let mut bytes = Vec::new();
//! page.finish(&mut bytes)?;
//! let text = String::from_utf8_lossy(&bytes);
//! assert!(text.starts_with("<!DOCTYPE html>") && text.contains("The command of this page") && !text.contains("<script"));
//! # Ok::<(), std::io::Error>(())
//! ```

mod about;
mod cell;
mod change;
mod chosen;
mod deferred;
mod detail_level;
mod entry;
mod examined;
mod explained;
mod feet;
mod files;
mod findings;
mod fragment;
mod glance;
mod inspected;
mod models_table;
mod page;
mod plots;
mod recording;
mod reference;
mod run_row;
mod section;
mod sections;
mod shell;
mod similarity;
mod special;
mod sphere_figures;
mod values;
mod verdicts;

pub use about::About;
pub use change::{Changed, changed};
pub use deferred::{DeferredText, InMemory};
pub use detail_level::DetailLevel;
pub use entry::Entry;
pub use examined::Examined;
pub use files::{Files, NamedDigest};
pub use inspected::{Inspected, inspected};
pub use models_table::Columns;
pub use page::{Kept, Page};
pub use recording::recording;
pub use run_row::{EarlierRun, RowError, RunRow};
pub use section::Section;
pub use sections::{Explained, Sections};
pub use shell::GENERATOR;
