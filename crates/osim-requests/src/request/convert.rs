//! Forces of one class as forces of the other.

use std::path::PathBuf;

#[cfg(feature = "schemas")]
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::options::{AnswerOptions, ClassChoice, ForceOptions, OutputOptions, RunOptions};
use crate::relation::Relation;
use crate::values::{Positive, path};

/// Makes forces of one class from those of the other, one for each sphere. Stiffness, dissipation, friction and transition velocity
/// stay as they are.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema))]
#[cfg_attr(feature = "clap", derive(clap::Args))]
#[serde(default)]
pub struct ConvertRequest {
    /// Models (.osim), folders, or - for standard input
    #[cfg_attr(feature = "clap", arg(value_name = "MODEL"))]
    #[serde(with = "path::list")]
    #[cfg_attr(feature = "schemas", schemars(with = "Vec<path::PathSchema>"))]
    pub models: Vec<PathBuf>,
    /// The class that forces get
    #[cfg_attr(feature = "clap", arg(long, value_enum))]
    pub to: Option<ClassChoice>,
    /// OpenSim's constant_contact_force of forces that had none [default: Falisse et al. (2022) at each radius (C.2)]
    #[cfg_attr(feature = "clap", arg(long, value_name = "M2"))]
    pub constant_contact_force: Option<Positive>,
    /// hertz_smoothing of forces that had none, 1/m [default: Falisse et al. (2022) at each radius (C.5)]
    #[cfg_attr(feature = "clap", arg(long, value_name = "PER_M"))]
    pub hertz_smoothing: Option<Positive>,
    /// hunt_crossley_smoothing of forces that had none, s/m [default: Falisse et al. (2022) at each radius (C.10)]
    #[cfg_attr(feature = "clap", arg(long, value_name = "S_PER_M"))]
    pub hunt_crossley_smoothing: Option<Positive>,
    /// Refuse where sphere and half-space have parameters of their own that differ
    #[cfg_attr(feature = "clap", arg(long, hide_short_help = true))]
    pub strict: bool,
    /// Which forces.
    #[cfg_attr(feature = "clap", command(flatten))]
    #[serde(flatten)]
    pub choice: ForceOptions,
    /// Where results go.
    #[cfg_attr(feature = "clap", command(flatten))]
    #[serde(flatten)]
    pub output: OutputOptions,
    /// How to go about the work.
    #[cfg_attr(feature = "clap", command(flatten))]
    #[serde(flatten)]
    pub run: RunOptions,
    /// Answers to questions.
    #[cfg_attr(feature = "clap", command(flatten))]
    #[serde(flatten)]
    pub answers: AnswerOptions,
}

impl ConvertRequest {
    pub(crate) const RELATIONS: &'static [&'static [Relation]] = &[
        &[Relation::Required("models"), Relation::Required("to")],
        OutputOptions::RELATIONS,
        RunOptions::RELATIONS,
    ];
}
