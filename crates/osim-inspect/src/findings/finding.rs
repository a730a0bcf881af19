//! A finding with what puts it right, and which findings of two states of a model say the same.

use std::ops::Deref;

use foldhash::{HashMap, HashMapExt};
use osim_model::{Finding, FindingCode, Severity};
use osim_requests::Request;
use osim_requests::spell::Speller;

/// Something found in a model, and the request that puts it right. It reads like its [`Finding`], which says where it applies.
#[derive(Debug, Clone, PartialEq)]
pub struct Found {
    pub finding: Finding,
    /// What puts it right; `None` where only the user can know what to write, and for a remark. Where the result says
    /// [`steps`](crate::CheckResult::steps) it is one of them.
    pub remedy: Option<Request>,
    /// Whether known contacts were published with it.
    pub as_published: bool,
    /// The remedy as the reader types it, once [`spell`](Self::spell) was given the words of a front end.
    pub command: Option<String>,
}

impl Found {
    /// A finding, and what puts it right, where there is something.
    pub fn new(finding: Finding, remedy: Option<Request>) -> Self {
        Self { finding, remedy, as_published: false, command: None }
    }

    /// As bad as in the published state of known contacts: nothing has to be put right there.
    pub fn as_published(self, severity: Severity) -> Self {
        Self { finding: self.finding.with_severity(severity), remedy: None, as_published: true, ..self }
    }

    /// Spells what it says, and its remedy, in the words of a front end.
    pub fn spell(&mut self, speller: &dyn Speller) {
        self.finding.spell(speller);
        self.command = self.remedy.as_ref().map(|remedy| speller.request(remedy));
    }
}

impl From<Finding> for Found {
    fn from(finding: Finding) -> Self {
        Self::new(finding, None)
    }
}

impl Deref for Found {
    type Target = Finding;

    fn deref(&self) -> &Finding {
        &self.finding
    }
}

/// Findings that are steps of one ladder: one takes the place of the other as spheres sink in deeper.
const DEPTH: [FindingCode; 3] =
    [FindingCode::BeyondHertzAtTwo, FindingCode::BeyondHertz, FindingCode::SunkIn];

/// Findings to which others may be akin, the first of each kind.
#[derive(Debug)]
pub struct Kin<'f> {
    findings: &'f [Found],
    /// A finding about spheres is shown once for all of them, at the worst sphere, which may be another one after the change.
    of_spheres: HashMap<FindingCode, usize>,
    at_place: HashMap<(FindingCode, Option<&'f str>), usize>,
    of_code: HashMap<FindingCode, usize>,
}

impl<'f> Kin<'f> {
    pub fn of(findings: &'f [Found]) -> Self {
        let mut kin =
            Self { findings, of_spheres: HashMap::new(), at_place: HashMap::new(), of_code: HashMap::new() };
        for (at, one) in findings.iter().enumerate() {
            if !one.spheres.is_empty() {
                kin.of_spheres.entry(one.code()).or_insert(at);
            }
            kin.at_place.entry((one.code(), one.place.as_deref())).or_insert(at);
            kin.of_code.entry(one.code()).or_insert(at);
        }
        kin
    }

    /// The first finding that says the same as `one`: about spheres it is one for all, else one for each place.
    pub fn same(&self, one: &Found) -> Option<&'f Found> {
        let of_spheres = self.of_spheres.get(&one.code()).filter(|_| !one.spheres.is_empty());
        let at =
            of_spheres.into_iter().chain(self.at_place.get(&(one.code(), one.place.as_deref()))).min()?;
        self.findings.get(*at)
    }

    /// The first finding that says the same as `one`, else the first that is another step of the same ladder.
    pub fn nearest(&self, one: &Found) -> Option<&'f Found> {
        let steps = DEPTH.iter().filter(|code| **code != one.code() && DEPTH.contains(&one.code()));
        let first = || self.findings.get(*steps.filter_map(|code| self.of_code.get(code)).min()?);
        self.same(one).or_else(first)
    }
}
