//! One run of a changing verb over any number of models: compare all files, then load, plan, write and report each.
//!
//! A [`Task`] is one model with its `JobSettings`; tasks are independent of each other, so threads share them. What a task
//! did is an [`Outcome`], reported in the order in which the models were named.

mod changed;
mod conflicts;
mod context;
mod destination;
mod form;
mod front_end;
mod inside;
mod journal;
mod model_job;
mod outcome;
mod planned;
mod previous_lines;
mod record;
mod request;
mod resume;
mod rows;
mod settings;
mod start;
mod task;
mod writing;

pub use conflicts::{PathConflicts, PathOwner};
pub use destination::Destination;
pub use front_end::{ChangedModel, Detail, FrontEnd};
pub use outcome::{Counts, Outcome};
pub use planned::PlannedModel;
pub use record::{JsonRecord, Record, Status};
pub use request::{RunRequest, run_options};
pub use rows::{RowReader, Rows};
pub use start::Run;
pub use task::Task;
pub use writing::{GeometryResult, Results, Written};
