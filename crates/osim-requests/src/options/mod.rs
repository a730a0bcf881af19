//! Groups of options that several verbs share; the help has a heading for each group.

mod contacts;
mod inspection;
mod run;
mod scaling;

pub use contacts::{ContactNumbers, FallOptions, NumberOptions, WantedOptions};
pub use inspection::{
    CountOptions, ForceOptions, InspectionOptions, LoadOptions, MassOptions, SetFiles, StanceOptions,
};
pub use run::{
    AnswerOptions, Deny, Format, OutputOptions, ReportOptions, RunFormat, RunOptions, SheetFormat,
};
pub use scaling::{
    AxisChoice, ClassChoice, DissipationChoice, FollowOptions, MirrorChoice, MovedChoice, RadiusAxisChoice,
    ReferenceOptions, RuleChoice, ScalingOptions,
};
