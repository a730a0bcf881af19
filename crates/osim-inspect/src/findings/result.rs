//! What `check` found: data for the table, CSV, JSON and reports.

use std::cmp::Reverse;

use osim_model::messages::counted;
use osim_model::{FindingCode, Model, Severity};
use osim_requests::Request;
use osim_requests::spell::Speller;
#[cfg(feature = "schemas")]
use schemars::JsonSchema;
use serde::Serialize;

use crate::findings::finding::Found;
use crate::inspection::Inspection;
#[cfg(feature = "schemas")]
use crate::serialized::FindingRecord;
use crate::serialized::{SCHEMA_VERSION, found_records};
use crate::similarity::SizeList;
use crate::verdicts::{self, Verdict};

/// Everything found in one model. Serialised it is the JSON contract of `check`; `docs/reference/json.md` describes it.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema), schemars(deny_unknown_fields))]
pub struct CheckResult {
    /// Raised when a field changes its meaning or goes away.
    pub schema_version: u32,
    /// The model as it was named.
    pub model: String,
    /// Its name in bytes, if it is not UTF-8.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub model_bytes: Option<Vec<u8>>,
    /// How many of each severity.
    pub counts: Counts,
    /// Six questions answered, always in the same order; a seventh about a recording, where one is named.
    pub verdicts: Vec<Verdict>,
    /// From the worst to the least; equally bad ones in the order of the register.
    #[serde(serialize_with = "found_records")]
    #[cfg_attr(feature = "schemas", schemars(with = "Vec<FindingRecord>"))]
    pub findings: Vec<Found>,
    /// The calls that put right what can be put right, in the order in which they work: each changes what the one before wrote.
    pub commands: Vec<String>,
    /// The same as requests.
    #[serde(skip)]
    #[cfg_attr(feature = "schemas", schemars(skip))]
    pub steps: Vec<Request>,
    /// What else of the model follows its size, compared with the model that was scaled, where one is named.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub similarity: Option<SizeList>,
}

/// From the worst to the least; equally bad ones in the order of the register.
pub(crate) fn in_order(mut findings: Vec<Found>) -> Vec<Found> {
    // What spheres do where they should not be is a symptom.
    let is_symptom = |finding: &Found| {
        !matches!(finding.code(), FindingCode::SpheresLeftBehind | FindingCode::SpheresMisplaced)
    };
    findings.sort_by_key(|finding| {
        (Reverse(finding.severity), is_symptom(finding), finding.code(), finding.line)
    });
    findings
}

/// How many findings of each severity.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema), schemars(deny_unknown_fields))]
pub struct Counts {
    /// What OpenSim computes otherwise than it looks, or as nonsense.
    pub error: usize,
    /// Limits of the paper, and traps.
    pub warning: usize,
    /// Worth knowing.
    pub remark: usize,
}

impl Counts {
    /// Those of the worst severity that there is, without the others.
    pub const fn worst(self) -> Self {
        let Self { error, warning, remark } = self;
        match (error, warning) {
            (0, 0) => Self { error, warning, remark },
            (0, _) => Self { error, warning, remark: 0 },
            _ => Self { error, warning: 0, remark: 0 },
        }
    }

    /// "1 error, 2 warnings"; `none` where there is nothing.
    pub fn describe(self, none: &str) -> String {
        let all = [(self.error, "error"), (self.warning, "warning"), (self.remark, "remark")];
        let parts: Vec<String> = all
            .into_iter()
            .filter(|(count, _)| *count > 0)
            .map(|(count, name)| counted(count, name))
            .collect();
        if parts.is_empty() { none.to_owned() } else { parts.join(", ") }
    }
}

impl CheckResult {
    /// Everything found in a model, in any order.
    pub fn new(model: &Model, inspected: &Inspection, findings: Vec<Found>) -> Self {
        let mut findings = in_order(findings);
        // A remark is worth knowing, and no reason to change the model.
        for remark in findings.iter_mut().filter(|finding| finding.severity == Severity::Remark) {
            remark.remedy = None;
        }
        let count = |severity| findings.iter().filter(|finding| finding.severity == severity).count();
        let counts = Counts {
            error: count(Severity::Error),
            warning: count(Severity::Warning),
            remark: count(Severity::Remark),
        };
        Self {
            schema_version: SCHEMA_VERSION,
            model: inspected.model.clone(),
            model_bytes: inspected.model_bytes.clone(),
            counts,
            verdicts: verdicts::of(model, inspected, &findings),
            findings,
            commands: Vec::new(),
            steps: Vec::new(),
            similarity: None,
        }
        .with_steps_of_remedies()
    }

    /// Makes each remedy a step by itself, which nobody has tried.
    fn with_steps_of_remedies(mut self) -> Self {
        for remedy in self.findings.iter().filter_map(|found| found.remedy.as_ref()) {
            if !self.steps.contains(remedy) {
                self.steps.push(remedy.clone());
            }
        }
        self
    }

    /// The steps up to the one that puts a finding right, this one last; empty if no step does.
    pub fn steps_to(&self, finding: &Found) -> &[Request] {
        let last = self.steps.iter().position(|step| finding.remedy.as_ref() == Some(step));
        last.and_then(|last| self.steps.get(..=last)).unwrap_or_default()
    }

    /// Whether something is as bad as `severity`, or worse.
    pub fn reaches(&self, severity: Severity) -> bool {
        self.findings.iter().any(|finding| finding.severity >= severity)
    }

    /// Spells everything it says in the words of a front end.
    pub fn spell(&mut self, speller: &dyn Speller) {
        self.verdicts.iter_mut().for_each(|verdict| verdict.spell(speller));
        self.findings.iter_mut().for_each(|finding| finding.spell(speller));
        self.commands = self.steps.iter().map(|step| speller.request(step)).collect();
    }
}
