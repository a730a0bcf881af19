//! Many OpenSim models at once: found, read, changed and written without ever leaving a file half written.
//!
//! # What it will not do
//!
//! This crate writes nothing to a terminal: messages are data, which a front end ([`run::RunFrontEnd`]) spells and shows.

#![cfg_attr(not(test), deny(clippy::disallowed_methods))]

mod fault;
mod file_access;
mod motion_files;
mod partial;
mod paths;
pub mod report_page;
pub mod run;
mod source;
mod survey;
mod sweep;
mod workers;
mod write;

pub use fault::{FaultCause, LibraryFault, Result};
pub use file_access::{reason, sha256};
pub use motion_files::MotionFiles;
pub use paths::{folder_of, make_folder_of, require_folder_of, resolved};
pub use source::{
    Disk, LoadedModel, ModelOrigin, ModelSource, OrdinaryFiles, Sources, SplitName, workbook_as_csv,
};
pub use survey::{Survey, SurveyText, SurveyedModel};
pub use sweep::{OtherModels, SameContacts, SweepEnd, SweepRun};
pub use workers::work_in_order;
pub use write::{OutputFolders, PendingFile, WriteMode, write_files};
