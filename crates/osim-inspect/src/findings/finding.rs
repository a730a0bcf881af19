//! A finding with the request that corrects it, and the search for the same finding in another state of a model.

use std::ops::Deref;

use foldhash::HashMap;
use osim_model::{Finding, FindingCode, Severity};
use osim_requests::Request;

/// A finding about a model, and the request that corrects the fault. It derefs to its [`Finding`].
#[derive(Debug, Clone, PartialEq)]
pub struct FindingWithRemedy {
    pub finding: Finding,
    /// The request that corrects the finding; `None` for a remark, and if only the user can know what to write. It is one of the
    /// [`steps`](crate::CheckResult::steps) of the result, if the result has steps.
    pub remedy: Option<Request>,
    /// The remedy as the command that the user types; `None` before [`CheckResult::spell`](crate::CheckResult::spell).
    pub command: Option<String>,
}

impl FindingWithRemedy {
    /// A finding with the request that corrects it, if there is one.
    pub fn new(finding: Finding, remedy: Option<Request>) -> Self {
        Self { finding, remedy, command: None }
    }

    /// The finding with the severity from the table of known contacts, and without a remedy, because the contacts were published like this.
    /// A finding that stays worth seeing says so.
    pub(crate) fn with_published_severity(self, severity: Severity) -> Self {
        let mut finding = Finding { is_published: true, ..self.finding.with_severity(severity) };
        if !finding.is_as_published() {
            finding.message.push(", as published");
        }
        Self { finding, remedy: None, ..self }
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

/// Codes of findings about the depth of spheres, the mildest first. As spheres sink in deeper, the next code replaces the one before.
const DEPTH_CODES: [FindingCode; 3] =
    [FindingCode::BeyondHertzAtTwo, FindingCode::BeyondHertz, FindingCode::SunkIn];

/// An index of the findings about one state of a model, to look up a finding about another state of the model. Of equal findings it has the
/// first.
#[derive(Default)]
pub struct FindingIndex<'f> {
    findings: &'f [FindingWithRemedy],
    /// Findings about spheres, by their code. Such a finding is about all spheres; its place is the worst sphere, which can be another
    /// sphere after a change.
    about_spheres: HashMap<FindingCode, usize>,
    by_place: HashMap<(FindingCode, Option<&'f str>), usize>,
    by_code: HashMap<FindingCode, usize>,
}

impl<'f> FindingIndex<'f> {
    /// An index of these findings.
    pub fn new(findings: &'f [FindingWithRemedy]) -> Self {
        let mut index = Self { findings, ..Self::default() };
        for (at, one) in findings.iter().enumerate() {
            if !one.spheres.is_empty() {
                index.about_spheres.entry(one.code()).or_insert(at);
            }
            for place in one.paths_or_none() {
                index.by_place.entry((one.code(), place)).or_insert(at);
            }
            index.by_code.entry(one.code()).or_insert(at);
        }
        index
    }

    /// The first finding with the code of `one` and, unless it is about spheres, also with a place of `one`.
    pub fn find_same(&self, one: &FindingWithRemedy) -> Option<&'f FindingWithRemedy> {
        let about_spheres = self.about_spheres.get(&one.code()).filter(|_| !one.spheres.is_empty());
        let about_places = one.paths_or_none().filter_map(|place| self.by_place.get(&(one.code(), place)));
        self.findings.get(*about_spheres.into_iter().chain(about_places).min()?)
    }

    /// Whether each place of `one` has a finding with its code. Findings about spheres have the place of the worst one, so they need none.
    pub fn has_all_places(&self, one: &FindingWithRemedy) -> bool {
        let is_known = |place| self.by_place.contains_key(&(one.code(), place));
        !one.spheres.is_empty() || one.paths_or_none().all(is_known)
    }

    /// The same finding as `one`; else, if `one` is about depth, the first finding with another code of depth.
    pub fn find_same_or_other_depth(&self, one: &FindingWithRemedy) -> Option<&'f FindingWithRemedy> {
        let depths =
            DEPTH_CODES.iter().filter(|code| **code != one.code() && DEPTH_CODES.contains(&one.code()));
        let first = || self.findings.get(*depths.filter_map(|code| self.by_code.get(code)).min()?);
        self.find_same(one).or_else(first)
    }
}
