//! Options for the work of a run, for the places of its results, and for answers to its questions.

use std::path::{Path, PathBuf};

use osim_model::{FaultKind, Severity, Suspicion, YesQuestion};

use crate::values::serial::{self, choices, fields, meanings};
use crate::values::{Jobs, Shard, path};

choices! {
    /// How a change is shown.
    RunFormat {
        Table = "table", "Every number that changes";
        Lines = "lines", "One line per model";
        Json = "json", "One JSON object per model and line";
    }

    /// How results are shown.
    Format: Table {
        Table = "table", "For people";
        Json = "json", "One JSON object per model and line";
    }

    /// How models that were inspected are shown.
    SheetFormat: Table {
        Table = "table", "For people";
        Json = "json", "One JSON object per model and line";
        Csv = "csv", "One table for spreadsheets, one header for all models";
    }

    /// The severity from which on a finding is a failure.
    Deny: Error {
        Warning = "warning", "Limits of the paper and traps, too";
        Error = "error", "What OpenSim computes differently from what is written, or wrongly";
    }
}

meanings! {
    /// The least severity that is a failure.
    Deny.severity: Severity { Warning => Severity::Warning, Error => Severity::Error }
}

fields! {
    /// How a run works and what it reports.
    struct RunOptions {
        dry_run: bool,
        diff: bool,
        format: Option<RunFormat>,
        quiet: bool,
        deny: Option<Deny>,
        report: Option<PathBuf> as "path::Optional",
        jobs: Option<Jobs>,
        summary: Option<PathBuf> as "path::Optional",
        resume: bool,
        shard: Option<Shard>,
    } where Needs("resume", "summary"), Excludes("resume", "dry_run");

    /// The page that verbs write which change nothing.
    struct ReportOptions {
        report: Option<PathBuf> as "path::Optional",
        force: bool,
    }

    /// Options for the places of results.
    struct OutputOptions {
        output: Option<PathBuf> as "path::Optional",
        geometry_output: Option<PathBuf> as "path::Optional",
        output_dir: Option<PathBuf> as "path::Optional",
        in_place: bool,
        no_backup: bool,
        force: bool,
        no_note: bool,
    } where
        Excludes("output_dir", "output"), Excludes("in_place", "output"), Excludes("in_place", "output_dir"),
        Excludes("in_place", "geometry_output"), Needs("no_backup", "in_place");

    /// Options for answers to questions.
    struct AnswerOptions {
        #[cfg_attr(feature = "schemas", schemars(with = "Vec<QuestionSchema>"))]
        yes: Vec<YesQuestion> as "serial::Texts",
    }
}

impl RunOptions {
    pub fn is_json(&self) -> bool {
        self.format == Some(RunFormat::Json)
    }
}

impl OutputOptions {
    /// The default suffix of result names, before their extension.
    pub const RESULT_SUFFIX: &'static str = ".scaled";

    /// Whether a factor may be applied again to a model whose note says that it was applied already: true if the model itself
    /// is not overwritten, or with `force`.
    pub fn may_repeat(&self) -> bool {
        self.force || !self.in_place
    }

    /// The default file of a result: `NAME.scaled.osim` beside the model.
    pub fn result_beside(model: &Path) -> PathBuf {
        let mut name = model.file_stem().unwrap_or_default().to_owned();
        name.push(Self::RESULT_SUFFIX);
        if let Some(extension) = model.extension() {
            name.push(".");
            name.push(extension);
        }
        model.with_file_name(name)
    }

    /// The file for the changed geometry set of a standalone force set.
    pub fn of_geometry(&self, geometry: &Path) -> PathBuf {
        match (&self.geometry_output, &self.output_dir) {
            _ if self.in_place => geometry.to_owned(),
            (Some(path), _) => path.clone(),
            (None, Some(folder)) => folder.join(geometry.file_name().unwrap_or_default()),
            (None, None) => Self::result_beside(geometry),
        }
    }
}

impl AnswerOptions {
    /// Options that answer the questions `yes` and no others.
    pub fn new(yes: Vec<YesQuestion>) -> Self {
        Self { yes }
    }

    /// Whether the caller has answered `question` with yes.
    pub fn confirms(&self, question: YesQuestion) -> bool {
        self.yes.contains(&question)
    }

    /// Refuses what looks wrong, if there is such a `doubt` and the caller has not confirmed it with `yes`.
    pub fn require_yes(&self, doubt: Option<Suspicion>) -> Result<(), FaultKind> {
        match doubt {
            Some(doubt) if !self.confirms(doubt.question()) => Err(doubt.into()),
            _ => Ok(()),
        }
    }
}

/// The code of a question.
#[cfg(feature = "schemas")]
struct QuestionSchema;

#[cfg(feature = "schemas")]
impl schemars::JsonSchema for QuestionSchema {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Question".into()
    }

    fn json_schema(_generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
        let codes: Vec<&str> = YesQuestion::ALL.iter().map(|question| question.as_str()).collect();
        schemars::json_schema!({"type": "string", "enum": codes})
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_default_is_a_new_file_beside_the_model() {
        assert_eq!(OutputOptions::result_beside(Path::new("a/human.osim")), Path::new("a/human.scaled.osim"));
        assert_eq!(OutputOptions::result_beside(Path::new("set.xml")), Path::new("set.scaled.xml"));
    }
}
