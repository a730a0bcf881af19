//! Groups of options that several verbs share, as the help shows them.

mod answers;
mod class;
mod columns;
mod drop;
mod follow;
mod forces;
mod inspection;
mod load;
mod masses;
mod numbers;
mod output;
mod reference;
mod run;
mod scaling;
mod set_files;
mod wanted;

pub use answers::AnswerOptions;
pub use class::{ClassChoice, MirrorChoice};
pub use columns::{ColumnOptions, ForceUnit, LengthUnit, SpeedUnit, TimeUnit};
pub use drop::{ContactNumbers, FallOptions};
pub use follow::{FollowOptions, MovedChoice, RadiusAxisChoice, RuleChoice};
pub use forces::ForceOptions;
pub use inspection::InspectionOptions;
pub use load::{CountOptions, LoadOptions, StanceOptions};
pub use masses::MassOptions;
pub use numbers::NumberOptions;
pub use output::OutputOptions;
pub use reference::ReferenceOptions;
pub use run::{Format, ReportOptions, RunFormat, RunOptions, SheetFormat};
pub use scaling::{AxisChoice, DissipationChoice, ScalingOptions};
pub use set_files::SetFiles;
pub use wanted::WantedOptions;
