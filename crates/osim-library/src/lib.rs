//! Many OpenSim models at once: found, read, changed and written without ever leaving a file half written.
//!
//! # What it will not do
//!
//! It knows no terminal: what is to be reported goes through [`run::FrontEnd`] and is data until then.

#![cfg_attr(not(test), deny(clippy::disallowed_methods))]

mod digest;
mod door;
mod fault;
mod folders;
pub mod page;
mod partial;
mod paths;
pub mod run;
mod source;
mod survey;
mod sweep;
mod workers;
mod write;

pub use digest::sha256;
pub use door::{head, reason};
pub use fault::{Cause, LibraryFault};
pub use folders::{Folders, make_folder_of};
pub use paths::{folder_of, resolved};
pub use source::{Disk, Loaded, OrdinaryFiles, Origin, Source, Sources, SplitName, Stamp};
pub use survey::{Survey, SurveyText, Surveyed};
pub use sweep::{OtherModels, SameContacts, SweepEnd, SweepFrontEnd, SweepRun};
pub use workers::{in_order, threads};
pub use write::{Mode, Prepared};
