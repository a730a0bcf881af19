//! How a run goes about its work, where results go, and answers to what it asks.

use std::path::{Path, PathBuf};

use osim_model::{FaultKind, NeedsAnswer, Question};
#[cfg(feature = "schemas")]
use schemars::JsonSchema;
#[cfg(feature = "schemas")]
use schemars::Schema;
#[cfg(feature = "schemas")]
use schemars::SchemaGenerator;
#[cfg(feature = "schemas")]
use schemars::json_schema;
use serde::{Deserialize, Serialize};

use crate::dictionary;
use crate::fault::Relation;
use crate::values::serial::{self, choices};
use crate::values::{Jobs, Shard, path};

choices! {
    /// How a change is shown.
    RunFormat {
        /// Every number that changes.
        Table = "table", "Every number that changes";
        /// One line per model.
        Lines = "lines", "One line per model";
        /// One JSON object per model and line.
        Json = "json", "One JSON object per model and line";
    }
}

choices! {
    /// How results are shown.
    Format: Table {
        /// For people.
        Table = "table", "For people";
        /// One JSON object per model and line.
        Json = "json", "One JSON object per model and line";
    }
}

choices! {
    /// How models that were inspected are shown.
    SheetFormat: Table {
        /// For people.
        Table = "table", "For people";
        /// One JSON object per model and line.
        Json = "json", "One JSON object per model and line";
        /// One table for spreadsheets, one header for all models.
        Csv = "csv", "One table for spreadsheets, one header for all models";
    }
}

impl From<Format> for SheetFormat {
    fn from(format: Format) -> Self {
        match format {
            Format::Table => Self::Table,
            Format::Json => Self::Json,
        }
    }
}

/// How a run works and what it reports.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema))]
#[cfg_attr(feature = "clap", derive(clap::Args), command(next_help_heading = "Output"))]
#[serde(default)]
pub struct RunOptions {
    /// Write nothing, only say what would change
    #[cfg_attr(feature = "clap", arg(long))]
    pub dry_run: bool,
    /// Show the changes as a unified diff too
    #[cfg_attr(feature = "clap", arg(long))]
    pub diff: bool,
    /// How to print [default: table; lines if more than 10 models]
    #[cfg_attr(feature = "clap", arg(long, value_enum))]
    pub format: Option<RunFormat>,
    /// Print errors only
    #[cfg_attr(feature = "clap", arg(long, hide_short_help = true))]
    pub quiet: bool,
    /// Write a page for browsers too (.html): tables, plots, findings
    #[cfg_attr(feature = "clap", arg(long, value_name = "FILE"))]
    #[serde(with = "path::optional")]
    #[cfg_attr(feature = "schemas", schemars(with = "Option<path::PathSchema>"))]
    pub report: Option<PathBuf>,
    /// Models to work on at once [default: one per processor]
    #[cfg_attr(feature = "clap", arg(long, value_name = "N", hide_short_help = true))]
    pub jobs: Option<Jobs>,
    /// Keep a line per model in this file (.csv or .ndjson)
    #[cfg_attr(feature = "clap", arg(long, value_name = "FILE", hide_short_help = true))]
    #[serde(with = "path::optional")]
    #[cfg_attr(feature = "schemas", schemars(with = "Option<path::PathSchema>"))]
    pub summary: Option<PathBuf>,
    /// Skip models that `summary` says are done, if nothing has changed since
    #[cfg_attr(feature = "clap", arg(long, hide_short_help = true))]
    pub resume: bool,
    /// Only share I of N of the models, for job arrays
    #[cfg_attr(feature = "clap", arg(long, value_name = "I/N", hide_short_help = true))]
    pub shard: Option<Shard>,
}

impl RunOptions {
    /// Which of its fields need or exclude others.
    pub(crate) const RELATIONS: &'static [Relation] =
        &[Relation::Needs("resume", "summary"), Relation::Excludes("resume", "dry_run")];

    /// The fields that are about many models at once.
    pub(crate) const OF_MANY: [&'static str; 4] = ["jobs", "summary", "resume", "shard"];

    /// Whether results are shown as JSON.
    pub fn is_json(&self) -> bool {
        self.format == Some(RunFormat::Json)
    }
}

/// The page that verbs write which change nothing.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema))]
#[cfg_attr(feature = "clap", derive(clap::Args), command(next_help_heading = "Output"))]
#[serde(default)]
pub struct ReportOptions {
    /// Write a page for browsers too (.html): tables, plots, findings
    #[cfg_attr(feature = "clap", arg(long, value_name = "FILE"))]
    #[serde(with = "path::optional")]
    #[cfg_attr(feature = "schemas", schemars(with = "Option<path::PathSchema>"))]
    pub report: Option<PathBuf>,
    /// Replace an existing report
    #[cfg_attr(feature = "clap", arg(long))]
    pub force: bool,
}

impl ReportOptions {
    /// Which of its fields need or exclude others.
    pub(crate) const RELATIONS: &'static [Relation] = &[Relation::Needs("force", "report")];
}

/// Where results go.
#[derive(Debug, Clone, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema))]
#[cfg_attr(feature = "clap", derive(clap::Args), command(next_help_heading = "Output"))]
#[serde(default)]
pub struct OutputOptions {
    /// Write to this file, or - [default: NAME.scaled.osim beside it]
    #[cfg_attr(feature = "clap", arg(short, long, value_name = "FILE"))]
    #[serde(with = "path::optional")]
    #[cfg_attr(feature = "schemas", schemars(with = "Option<path::PathSchema>"))]
    pub output: Option<PathBuf>,
    /// Write the changed ContactGeometrySet of a standalone ForceSet to this file
    #[cfg_attr(feature = "clap", arg(long, value_name = "FILE", hide_short_help = true))]
    #[serde(with = "path::optional")]
    #[cfg_attr(feature = "schemas", schemars(with = "Option<path::PathSchema>"))]
    pub geometry_output: Option<PathBuf>,
    /// Write into this folder
    #[cfg_attr(feature = "clap", arg(short = 'd', long, value_name = "DIR"))]
    #[serde(with = "path::optional")]
    #[cfg_attr(feature = "schemas", schemars(with = "Option<path::PathSchema>"))]
    pub output_dir: Option<PathBuf>,
    /// Change the model itself and keep the old one as NAME.osim.bak
    #[cfg_attr(feature = "clap", arg(long))]
    pub in_place: bool,
    /// With `in_place`: keep no backup
    #[cfg_attr(feature = "clap", arg(long, hide_short_help = true))]
    pub no_backup: bool,
    /// Replace existing files
    #[cfg_attr(feature = "clap", arg(long))]
    pub force: bool,
    /// Leave no note (in the credits) in the model
    #[cfg_attr(feature = "clap", arg(long, hide_short_help = true))]
    pub no_note: bool,
}

impl OutputOptions {
    /// What the names of results end in by default, before their extension.
    pub const MARK: &'static str = ".scaled";

    /// Which of its fields need or exclude others.
    pub(crate) const RELATIONS: &'static [Relation] = &[
        Relation::Excludes("output_dir", "output"),
        Relation::Excludes("in_place", "output"),
        Relation::Excludes("in_place", "output_dir"),
        Relation::Excludes("in_place", "geometry_output"),
        Relation::Needs("no_backup", "in_place"),
    ];

    /// Whether a field of this name says which files results are written to. All of its fields do, but for the one that is about
    /// what is in them.
    pub(crate) fn is_about_files(field: &str) -> bool {
        field != "no_note" && dictionary::map(&Self::default()).contains_key(field)
    }

    /// Whether a factor may be applied to a model whose note says that it was applied already: a new file is no mistake.
    pub fn may_repeat(&self) -> bool {
        self.force || !self.in_place
    }

    /// Where a result goes by default: `NAME.scaled.osim` beside the model.
    pub fn beside(model: &Path) -> PathBuf {
        let mut name = model.file_stem().unwrap_or_default().to_owned();
        name.push(Self::MARK);
        if let Some(extension) = model.extension() {
            name.push(".");
            name.push(extension);
        }
        model.with_file_name(name)
    }

    /// Where the changed geometry set of a standalone force set goes.
    pub fn of_geometry(&self, geometry: &Path) -> PathBuf {
        match (&self.geometry_output, &self.output_dir) {
            _ if self.in_place => geometry.to_owned(),
            (Some(path), _) => path.clone(),
            (None, Some(folder)) => folder.join(geometry.file_name().unwrap_or_default()),
            (None, None) => Self::beside(geometry),
        }
    }
}

/// Answers to questions.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema))]
#[cfg_attr(feature = "clap", derive(clap::Args), command(next_help_heading = "Output"))]
#[serde(default)]
pub struct AnswerOptions {
    /// Go on where a number looks like a slip: the code of the error that asks; may be repeated
    #[cfg_attr(feature = "clap", arg(long, value_name = "CODE", hide_short_help = true))]
    #[serde(deserialize_with = "serial::from_texts", serialize_with = "serial::as_texts")]
    #[cfg_attr(feature = "schemas", schemars(with = "Vec<QuestionSchema>"))]
    pub yes: Vec<Question>,
}

impl AnswerOptions {
    /// These answers.
    pub fn new(yes: Vec<Question>) -> Self {
        Self { yes }
    }

    /// Whether this question is answered.
    pub fn has(&self, question: Question) -> bool {
        self.yes.contains(&question)
    }

    /// Asks, unless it is answered or there is nothing to ask.
    ///
    /// # Errors
    /// The question.
    pub fn ask(&self, asks: Option<NeedsAnswer>) -> Result<(), FaultKind> {
        match asks {
            Some(asks) if !self.has(asks.question()) => Err(asks.into()),
            _ => Ok(()),
        }
    }
}

/// The code of a question.
#[cfg(feature = "schemas")]
struct QuestionSchema;

#[cfg(feature = "schemas")]
impl JsonSchema for QuestionSchema {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Question".into()
    }

    fn json_schema(_generator: &mut SchemaGenerator) -> Schema {
        json_schema!({"type": "string", "enum": Question::ALL.map(|question| question.code())})
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_default_is_a_new_file_beside_the_model() {
        assert_eq!(OutputOptions::beside(Path::new("a/human.osim")), Path::new("a/human.scaled.osim"));
        assert_eq!(OutputOptions::beside(Path::new("set.xml")), Path::new("set.scaled.xml"));
    }
}
