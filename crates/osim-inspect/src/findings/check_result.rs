//! The result of `check`: data for the table, CSV, JSON and reports.

use std::cmp::Reverse;
use std::collections::BTreeSet;

use osim_model::messages::{Phrase, counted};
use osim_model::{Finding, FindingCode, Model, Severity, VerdictTopic};
use osim_requests::Request;
use osim_requests::spell::FrontEnd;
use serde::Serialize;

use crate::findings::effects::without_effects;
#[cfg(feature = "schemas")]
use crate::serialized::FindingRecord;
use crate::serialized::{SCHEMA_VERSION, records};
use crate::verdicts::{self, Verdict};
use crate::{FindingWithRemedy, Inspection, SizeList};

/// Everything found in one model. Serialised it is the JSON contract of `check`; `docs/reference/json.md` describes it.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(deny_unknown_fields))]
pub struct CheckResult {
    /// Version of this JSON, which rises when a field changes its meaning or goes away.
    pub schema_version: u32,
    /// Name of the model's file, as the caller gave it.
    pub model: String,
    /// The bytes of that name, if it is not UTF-8.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub model_bytes: Option<Vec<u8>>,
    /// How many findings have each severity.
    pub counts: Counts,
    /// The verdicts on six topics, always in the same order; a seventh on a recording, if one is given.
    pub verdicts: Vec<Verdict>,
    /// From the worst to the least; equally bad ones in the order of the register.
    #[serde(serialize_with = "records")]
    #[cfg_attr(feature = "schemas", schemars(with = "Vec<FindingRecord>"))]
    pub findings: Vec<FindingWithRemedy>,
    /// The calls that correct what can be corrected, in the order in which they work: each changes what the one before wrote.
    pub commands: Vec<String>,
    /// The requests that [`commands`](Self::commands) spell.
    #[serde(skip)]
    pub steps: Vec<Request>,
    /// The codes of warnings and errors that were left out, because they follow from other findings.
    #[serde(skip)]
    pub left_out: BTreeSet<FindingCode>,
    /// The number of errors and warnings, minus that after all [`steps`](Self::steps).
    #[serde(skip)]
    pub corrected: usize,
    /// Sentences about the contacts beside measured feet.
    #[serde(skip)]
    pub beside_real_feet: Vec<String>,
    /// What else of the model follows its size, compared with the model that was scaled, if one is given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub similarity: Option<SizeList>,
    /// The file of the model that was scaled, if one is given.
    #[serde(skip)]
    pub scaled_from: Option<String>,
    /// Whether motion, contacts and plates agree, with a recording whose plates can be compared.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub consistency: Option<ConsistencyRecord>,
}

/// Whether a motion, contacts and plates agree: by the least correction of the motion that makes them agree.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(deny_unknown_fields))]
pub struct ConsistencyRecord {
    /// `agree`, `large-correction` or `disagree`.
    pub verdict: String,
    /// The verdict in words.
    pub why: String,
    /// Errors of the vertical force of each foot (rms), body weights.
    pub vertical_rms_bw: Vec<CorrectedErrorRecord>,
    /// Errors of the horizontal force of each foot (rms), body weights.
    pub horizontal_rms_bw: Vec<CorrectedErrorRecord>,
    /// Root mean square of the distance between both centres of pressure after the correction, of the worst foot, m.
    pub cop_rms_m: Option<f64>,
    /// How much higher the floor is than in the model, m.
    pub floor_up_m: Option<f64>,
    /// Velocity of the treadmill's belt, m/s.
    pub belt_m_per_s: Option<[f64; 3]>,
    /// Root mean square of the vertical moves of loaded spheres, without that of the floor, m.
    pub lift_rms_m: Option<f64>,
    /// The 95th percentile of the size of these moves, m.
    pub lift_p95_m: Option<f64>,
    /// The largest correction of an angle of a leg in stance (rms), without toes, rad.
    pub joint_rms_rad: Option<f64>,
    /// How much more the left foot is lifted than the right, m.
    pub left_minus_right_m: Option<f64>,
    /// Largest x/R after the correction.
    pub largest_relative_indentation: Option<f64>,
    /// The force and moment at the root that nothing explains, by inverse dynamics.
    pub root_residual: Option<RootResidualRecord>,
    /// How much the correction changes joint moments with the forces of the plates, N m.
    pub joint_moment_change_nm: Option<JointMomentsRecord>,
}

/// An error of one foot.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(deny_unknown_fields))]
pub struct CorrectedErrorRecord {
    /// The foot.
    pub foot: String,
    /// Before the correction.
    pub before: f64,
    /// After the correction.
    pub after: f64,
    /// Of a model that never touches.
    pub null: f64,
}

/// The force and moment at the root that nothing explains, by inverse dynamics.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(deny_unknown_fields))]
pub struct RootResidualRecord {
    /// Along the normal of the floor, body weights.
    pub vertical: ResidualRecord,
    /// Along the floor, body weights.
    pub horizontal: ResidualRecord,
    /// Moment, body weights times m.
    pub moment: ResidualRecord,
}

/// One part of a residual (rms).
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(deny_unknown_fields))]
pub struct ResidualRecord {
    /// With the contacts before the correction.
    pub before: Option<f64>,
    /// With the contacts after the correction.
    pub after: Option<f64>,
    /// With the plates after the correction; absent for a moment where their points are not known.
    pub with_plates: Option<f64>,
}

/// Changes of joint moments (rms), of the angle and side with the largest.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(deny_unknown_fields))]
pub struct JointMomentsRecord {
    /// Hip, N m.
    pub hip: Option<f64>,
    /// Knee, N m.
    pub knee: Option<f64>,
    /// Ankle, N m.
    pub ankle: Option<f64>,
}

/// Sorts findings from the most severe to the least severe; equally severe findings in the order of the register of rules.
pub fn sort_findings(mut findings: Vec<FindingWithRemedy>) -> Vec<FindingWithRemedy> {
    // Misplaced spheres come first: what such spheres do is a symptom.
    let is_symptom = |finding: &FindingWithRemedy| {
        !matches!(finding.code(), FindingCode::SpheresLeftBehind | FindingCode::SpheresMisplaced)
    };
    findings.sort_by_key(|finding| {
        (Reverse(finding.severity), is_symptom(finding), finding.code(), finding.position.map(|at| at.line))
    });
    findings
}

/// Numbers of findings by severity.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(deny_unknown_fields))]
pub struct Counts {
    /// OpenSim reads something else than is written, or the contacts cannot be right.
    pub error: usize,
    /// A value is outside a limit, or OpenSim does not compute what the file seems to say.
    pub warning: usize,
    /// Remarks.
    pub remark: usize,
}

impl Counts {
    /// Counts findings by severity.
    fn of(findings: &[FindingWithRemedy]) -> Self {
        let count = |severity| findings.iter().filter(|finding| finding.severity == severity).count();
        let [error, warning, remark] = [Severity::Error, Severity::Warning, Severity::Remark].map(count);
        Self { error, warning, remark }
    }

    /// Counts only the findings of the worst severity that occurs; the other counts are 0.
    pub const fn only_worst(self) -> Self {
        match (self.error, self.warning) {
            (0, 0) => self,
            (0, _) => Self { remark: 0, ..self },
            _ => Self { warning: 0, remark: 0, ..self },
        }
    }

    /// The counts in words, such as `1 error, 2 warnings`; `none` if all counts are 0.
    pub fn describe(self, none: &str) -> String {
        let all = [(self.error, "error"), (self.warning, "warning"), (self.remark, "remark")];
        let some = all.into_iter().filter(|(count, _)| *count > 0);
        let parts: Vec<String> = some.map(|(count, name)| counted(count, name)).collect();
        if parts.is_empty() { none.to_owned() } else { parts.join(", ") }
    }
}

impl CheckResult {
    /// The result of a check: the findings sorted, counted, and with a verdict for each topic.
    pub fn new(model: &Model, inspected: &Inspection, findings: Vec<FindingWithRemedy>) -> Self {
        let (findings, left_out) = without_effects(model, findings);
        let mut findings = sort_findings(findings);
        // A remark is no reason to change the model.
        for remark in findings.iter_mut().filter(|finding| finding.severity == Severity::Remark) {
            remark.remedy = None;
        }
        // Each remedy is a step. Nobody tried whether the steps work one after the other.
        let mut steps: Vec<Request> = Vec::new();
        for remedy in findings.iter().filter_map(|found| found.remedy.as_ref()) {
            if !steps.contains(remedy) {
                steps.push(remedy.clone());
            }
        }
        Self {
            schema_version: SCHEMA_VERSION,
            model: inspected.model.clone(),
            model_bytes: inspected.model_bytes.clone(),
            counts: Counts::of(&findings),
            verdicts: verdicts::answer_all(model, inspected, (&findings, &left_out)),
            findings,
            commands: Vec::new(),
            steps,
            left_out: left_out.into_keys().collect(),
            corrected: 0,
            beside_real_feet: inspected.beside_real_feet(),
            similarity: None,
            scaled_from: inspected.placement.as_ref().map(|placement| placement.from.display().to_string()),
            consistency: None,
        }
    }

    /// Adds the result of comparing the contacts with a recording: a sentence if they fit, a finding if they do not, or the reason why it
    /// is not known.
    pub fn add_recording(
        &mut self,
        answer: Result<Result<Phrase, Finding>, Phrase>,
        remark: Option<Finding>,
    ) {
        let verdict = match answer {
            Ok(Err(finding)) => {
                let finding = FindingWithRemedy::from(finding);
                let verdict = Verdict::from_findings(VerdictTopic::Recording, &finding, &[]);
                self.findings.push(finding);
                verdict
            }
            Ok(Ok(right)) => Verdict::without_findings(VerdictTopic::Recording, Ok(right)),
            Err(why) => Verdict::without_findings(VerdictTopic::Recording, Err(why)),
        };
        self.verdicts.push(verdict);
        self.findings.extend(remark.map(FindingWithRemedy::from));
        self.findings = sort_findings(std::mem::take(&mut self.findings));
        self.counts = Counts::of(&self.findings);
    }

    /// All steps up to the step that corrects the finding, this step included; empty if no step corrects it.
    pub fn steps_to(&self, finding: &FindingWithRemedy) -> &[Request] {
        let last = self.steps.iter().position(|step| finding.remedy.as_ref() == Some(step));
        last.and_then(|last| self.steps.get(..=last)).unwrap_or_default()
    }

    /// Writes all texts of the result in the words of a front end. Calls in texts about this model name its file.
    pub fn spell(&mut self, speller: &dyn FrontEnd) {
        let found = self.findings.iter_mut().map(|one| &mut one.finding);
        let texts = found.flat_map(|finding| [&mut finding.message, &mut finding.advice]);
        let texts = texts.chain(self.verdicts.iter_mut().map(|verdict| &mut verdict.text));
        // Standard input cannot be read again.
        let named = texts.filter(|_| self.model != "-");
        named.for_each(|text| text.name_files(&self.model, self.scaled_from.as_deref()));
        self.verdicts.iter_mut().for_each(|verdict| verdict.text.spell(speller));
        for found in &mut self.findings {
            found.finding.spell(speller);
            found.command = found.remedy.as_ref().map(|remedy| speller.request(remedy));
        }
        self.commands = self.steps.iter().map(|step| speller.request(step)).collect();
    }
}
