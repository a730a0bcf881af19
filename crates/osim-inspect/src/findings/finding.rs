//! A finding with the request that corrects it, and the search for the same finding in another state of a model.

use std::ops::Deref;

use foldhash::{HashMap, HashMapExt};
use osim_model::{Finding, FindingCode, Severity};
use osim_requests::Request;
use osim_requests::spell::Speller;

/// A finding about a model, and the request that corrects it. It derefs to its [`Finding`].
#[derive(Debug, Clone, PartialEq)]
pub struct FindingWithRemedy {
    pub finding: Finding,
    /// What corrects it; `None` if only the user can know what to write, and for a remark. It is one of the
    /// [`steps`](crate::CheckResult::steps) of the result, if the result has these.
    pub remedy: Option<Request>,
    /// Whether the known contacts of the model were published with this finding.
    pub is_published: bool,
    /// The remedy as the user types it; `None` before [`spell`](Self::spell).
    pub command: Option<String>,
}

impl FindingWithRemedy {
    pub fn new(finding: Finding, remedy: Option<Request>) -> Self {
        Self { finding, remedy, is_published: false, command: None }
    }

    /// With the severity that the table of known contacts gives, and without a remedy: the contacts were published so.
    pub(crate) fn with_published_severity(self, severity: Severity) -> Self {
        Self { finding: self.finding.with_severity(severity), remedy: None, is_published: true, ..self }
    }

    /// Puts its texts and its remedy into the words of a front end.
    pub fn spell(&mut self, speller: &dyn Speller) {
        self.finding.spell(speller);
        self.command = self.remedy.as_ref().map(|remedy| speller.request(remedy));
    }
}

impl From<Finding> for FindingWithRemedy {
    fn from(finding: Finding) -> Self {
        Self::new(finding, None)
    }
}

impl Deref for FindingWithRemedy {
    type Target = Finding;

    fn deref(&self) -> &Finding {
        &self.finding
    }
}

/// Findings about depth, the least bad first: as spheres sink in deeper, the next takes the place of the one before.
const DEPTHS: [FindingCode; 3] =
    [FindingCode::BeyondHertzAtTwo, FindingCode::BeyondHertz, FindingCode::SunkIn];

/// The findings of one state of a model, to find those of another state again; of equal ones the first.
#[derive(Debug)]
pub struct FindingIndex<'f> {
    findings: &'f [FindingWithRemedy],
    /// Findings about spheres. One is about all of them, and its place is the worst sphere, which can be another one after a change.
    about_spheres: HashMap<FindingCode, usize>,
    by_place: HashMap<(FindingCode, Option<&'f str>), usize>,
    by_code: HashMap<FindingCode, usize>,
}

impl<'f> FindingIndex<'f> {
    pub fn new(findings: &'f [FindingWithRemedy]) -> Self {
        let mut index = Self {
            findings,
            about_spheres: HashMap::new(),
            by_place: HashMap::new(),
            by_code: HashMap::new(),
        };
        for (at, one) in findings.iter().enumerate() {
            if !one.spheres.is_empty() {
                index.about_spheres.entry(one.code()).or_insert(at);
            }
            index.by_place.entry((one.code(), one.place.as_deref())).or_insert(at);
            index.by_code.entry(one.code()).or_insert(at);
        }
        index
    }

    /// The first finding with the code and, unless it is about spheres, the place of `one`.
    pub fn find_same(&self, one: &FindingWithRemedy) -> Option<&'f FindingWithRemedy> {
        let about_spheres = self.about_spheres.get(&one.code()).filter(|_| !one.spheres.is_empty());
        let at =
            about_spheres.into_iter().chain(self.by_place.get(&(one.code(), one.place.as_deref()))).min()?;
        self.findings.get(*at)
    }

    /// The finding that says what `one` says, else, if `one` is about depth, the first finding about another depth.
    pub fn find_same_or_other_depth(&self, one: &FindingWithRemedy) -> Option<&'f FindingWithRemedy> {
        let depths = DEPTHS.iter().filter(|code| **code != one.code() && DEPTHS.contains(&one.code()));
        let first = || self.findings.get(*depths.filter_map(|code| self.by_code.get(code)).min()?);
        self.find_same(one).or_else(first)
    }
}
