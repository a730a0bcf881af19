//! One run of a changing verb over any number of models: compare all files, then load, plan, write and report each.
//!
//! A [`Task`] is one model with its `JobSettings`; tasks are independent of each other, so threads share them. What a task
//! did is an [`Outcome`], reported in the order in which the models were named.

mod model_job;
mod planned_model;
mod record;
mod request;
mod resume;
mod rows;
mod start;
mod summary;
mod summary_lines;
mod task;
mod writing;

pub use model_job::{Counts, Outcome};
pub use planned_model::PlannedModel;
pub use record::{JsonRecord, Record, Status};
pub use request::{ChangedModel, ModelDetail, RunFrontEnd, RunRequest};
pub use rows::{CheckedRows, RowReader};
pub use start::Run;
pub use task::{Destination, PathConflicts, PathOwner, Task};
pub use writing::{GeometryResult, ResultBytes, Written};
