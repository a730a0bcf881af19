//! Opens, inspects and checks one model for the web page.

use std::path::{Path, PathBuf};

use osim_inspect::series::ContactBody;
use osim_inspect::{CheckResult, FindingRecord, FindingWithRemedy, Inspection, Verdict};
use osim_model::files::{Failure, Files, ModelFiles, OpenModel};
use osim_model::messages::Verb;
use osim_planning::scene::{BodyFall, Scene};
use osim_planning::{Inspector, ModelFeet};
use osim_requests::Request;
use osim_requests::options::SetFiles;
use osim_requests::spell::{FrontEnd, Page};
use osim_view::html::{DetailLevel, Entry, Explained, InspectedModelOnPage, NamedDigest, Section, Sections};
use serde::Serialize;
use serde_json::{Value, json};
use sha2::{Digest, Sha256};

use crate::given_files::GivenFiles;
use crate::knowledge::Fields;
use crate::problem::{Problem, Result};

/// An opened model, with the files of a standalone force set or geometry set.
pub(crate) struct OpenedModel {
    pub(crate) path: PathBuf,
    pub(crate) set_files: SetFiles,
    pub(crate) model: OpenModel,
    /// The files that belong to the model, without the bytes of the model itself.
    pub(crate) files: ModelFiles,
}

impl OpenedModel {
    /// Opens the model at `path`.
    ///
    /// # Errors
    /// The model cannot be read.
    pub(crate) fn read(path: &Path, set_files: &SetFiles, given_files: &GivenFiles) -> Result<Self, Failure> {
        let failed =
            |error: osim_model::files::FileError| Failure::outside(path, "unreadable", error.to_string());
        let bytes = given_files.read(path).map_err(failed)?;
        let all = ModelFiles::read(path, bytes, set_files.companion_paths(), given_files)?;
        let files = all.with_bytes(Vec::new());
        Ok(Self { path: path.to_owned(), set_files: set_files.clone(), model: all.open()?, files })
    }

    /// Files of the model with their digests.
    pub(crate) fn digests(&self) -> Vec<NamedDigest> {
        let digest =
            |(name, bytes): (&str, &[u8])| NamedDigest { name: name.to_owned(), sha256: sha256(bytes) };
        self.model.files().map(digest).collect()
    }
}

/// The SHA-256 of `bytes`, in hexadecimal digits.
pub(crate) fn sha256(bytes: &[u8]) -> String {
    Sha256::digest(bytes).iter().map(|byte| format!("{byte:02x}")).collect()
}

// What is in a model, and what is wrong with it.

/// What the page shows of an inspected and checked model.
#[derive(Debug, Serialize)]
pub(crate) struct InspectedModel {
    inspection: Inspection,
    findings: Vec<FindingShown>,
    sections: Vec<Section>,
    explained: Vec<Explained>,
    /// Files that the model was read from, its own file first.
    files: Vec<String>,
    /// Verdicts of the check.
    verdicts: Vec<VerdictWithQuestion>,
    /// The model in space, where it was asked for.
    scene: Option<Scene>,
    /// How the model falls on its contacts, where that was asked for.
    falls: Vec<BodyFall>,
}

/// A finding, with the request that corrects the fault.
#[derive(Debug, Serialize)]
pub(crate) struct FindingShown {
    #[serde(flatten)]
    finding: Value,
    /// A change that puts the finding right, in words and as a request.
    remedy: Option<Value>,
}

impl FindingShown {
    /// A finding as the page shows it. Its remedy is shown only if it is the `first` change to make, because later changes are made in
    /// the result of the first.
    fn of(finding: &FindingWithRemedy, first: Option<&Request>) -> Self {
        let request = finding.remedy.as_ref().filter(|remedy| first == Some(remedy));
        let remedy = request
            .zip(finding.command.clone())
            .map(|(request, text)| json!({ "text": text, "request": request.to_map() }));
        let finding = serde_json::to_value(FindingRecord::from(finding)).unwrap_or_default();
        Self { finding, remedy }
    }

    /// Every finding of a check.
    pub(crate) fn all(found: &CheckResult) -> Vec<Self> {
        found.findings.iter().map(|finding| Self::of(finding, found.steps.first())).collect()
    }
}

/// The inspector for a model. If `from` names the model that it was scaled from, the inspector compares both.
pub(crate) fn inspector(model: &str, mut fields: Fields, given_files: &GivenFiles) -> Result<Inspector> {
    let verb = if fields.contains_key("from") { Verb::Check } else { Verb::Inspect };
    fields.insert("models".to_owned(), model.into());
    match Request::read(verb, fields)? {
        Request::Inspect(request) => Ok(Inspector::for_inspect(&request, given_files)),
        Request::Check(request) => Ok(Inspector::for_check(&request, given_files)),
        other => Err(Problem::defect(format!("a request for {}", other.verb().name()))),
    }
}

/// The inspection and the check of the model. The front end `words` spells messages.
fn inspect_and_check(
    inspector: &Inspector,
    opened: &OpenedModel,
    given_files: &GivenFiles,
    words: &dyn FrontEnd,
) -> Result<(Inspection, CheckResult)> {
    let mut inspection = inspector.inspect(&opened.model)?;
    let mut found = inspector.check(&opened.model.model, &inspection, None, given_files);
    inspection.spell(words);
    found.spell(words);
    Ok((inspection, found))
}

/// The feet of the model with its bones; `None` if the page cannot show them.
fn feet(inspector: &Inspector, opened: &OpenedModel, given_files: &GivenFiles) -> Option<ModelFeet> {
    let mut feet = ModelFeet::for_page(opened.model.name(), &opened.model, &inspector.options.selection)?;
    feet.add_bones(&opened.model.model, &opened.path, None, given_files);
    Some(feet)
}

/// Inspects and checks a model; `wanted` are the sections to make, `None` for all.
pub(crate) fn inspect_for_page(
    inspector: &Inspector,
    opened: &OpenedModel,
    wanted: Option<&[String]>,
    given_files: &GivenFiles,
) -> Result<InspectedModel> {
    let (inspection, found) = inspect_and_check(inspector, opened, given_files, &Page)?;
    let wants = |id: &str| wanted.is_none_or(|wanted| wanted.iter().any(|one| one == id));
    let feet = wants("feet").then(|| feet(inspector, opened, given_files)).flatten();
    let digests = if wants("model") { opened.digests() } else { Vec::new() };
    let shown = InspectedModelOnPage {
        options: &inspector.options,
        model: &opened.model,
        examined: (&inspection, &found),
        files: &digests,
        feet,
        recording: None,
    };
    let Sections { sections, explained, .. } = Sections::of_model(shown, wanted, &Page);
    let findings = FindingShown::all(&found);
    let verdicts = VerdictWithQuestion::all(&found.verdicts);
    let scene = wants("scene").then(|| Scene::of(&opened.model.model, &inspector.options));
    let falls = if wants("falls") { falls(inspector, opened) } else { Vec::new() };
    Ok(InspectedModel {
        findings,
        inspection,
        sections,
        explained,
        files: opened.model.files().map(|(name, _)| name.to_owned()).collect(),
        verdicts,
        scene,
        falls,
    })
}

/// Falls of the model on its contacts; empty if its contacts or its weight are unknown.
fn falls(inspector: &Inspector, opened: &OpenedModel) -> Vec<BodyFall> {
    let failed = |fault| opened.model.failure(fault);
    let body =
        ContactBody::from_inspected_model("now".to_owned(), &opened.model.model, &inspector.options, &failed);
    body.map(|body| BodyFall::all(&[body])).unwrap_or_default()
}

/// An inspected model as an entry of a report.
pub(crate) fn entry(
    inspector: &Inspector,
    opened: &OpenedModel,
    given_files: &GivenFiles,
    words: &dyn FrontEnd,
) -> Result<Entry> {
    let (inspection, found) = inspect_and_check(inspector, opened, given_files, words)?;
    let shown = InspectedModelOnPage {
        options: &inspector.options,
        model: &opened.model,
        examined: (&inspection, &found),
        files: &opened.digests(),
        feet: feet(inspector, opened, given_files),
        recording: None,
    };
    Ok(osim_view::html::entry_of_inspected_model(shown, DetailLevel::Alone, words))
}

// A verdict with its question.

/// A verdict as the page shows it.
#[derive(Debug, Serialize)]
pub(crate) struct VerdictWithQuestion {
    question: &'static str,
    #[serde(flatten)]
    verdict: Verdict,
}

impl VerdictWithQuestion {
    /// Every verdict of a check.
    pub(crate) fn all(verdicts: &[Verdict]) -> Vec<Self> {
        let shown = |verdict: &Verdict| Self { question: verdict.on.as_question(), verdict: verdict.clone() };
        verdicts.iter().map(shown).collect()
    }
}
