//! One page about a run, for people and for the record.
//!
//! The page holds everything itself: no script, no font, no picture from elsewhere. Workers make the [`Entry`] of a model;
//! [`Page`] puts entries together in the order of the models. Rows and details wait as [`DeferredText`], so that memory can
//! stay flat however many models there are.

#![cfg_attr(not(test), deny(clippy::disallowed_methods))]

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

/// The example of the README compiles.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
