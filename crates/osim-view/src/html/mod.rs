//! One page about a run: readable for people, and a record of the run.
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
mod page;
mod page_frame;
mod plots;
mod reference;
mod sections;
mod special_models;
mod sphere_figures;

pub use change::{ChangedModelOnPage, entry_of_changed_model};
pub use entry::{EarlierRun, Entry, RowError, RunRow};
pub use fragment::{DetailLevel, Section};
pub use inspected::{InspectedModelOnPage, ListedFiles, NamedDigest, entry_of_inspected_model};
pub use models_table::Columns;
pub use page::{DeferredParts, DeferredText, Page, PageHead};
pub use page_frame::GENERATOR;
pub use plots::recording;
pub use sections::{Explained, Sections};
