//! Records for scripts: one JSON object for each model and line. `docs/reference/json.md` describes every field.

mod failure_record;
mod line;
mod plan_record;

pub use failure_record::{ErrorRecord, FailureRecord};
pub use line::line;
pub use plan_record::{Amount, ChangeRecord, ObjectRecord, PlanRecord, RecordingErrorsRecord};
