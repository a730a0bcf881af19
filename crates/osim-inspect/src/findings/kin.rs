//! Which findings of two states of a model say the same.

use foldhash::{HashMap, HashMapExt};
use osim_model::FindingCode;

use super::found::Found;

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
    /// Those of one state.
    #[must_use]
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
    #[must_use]
    pub fn same(&self, one: &Found) -> Option<&'f Found> {
        let of_spheres = self.of_spheres.get(&one.code()).filter(|_| !one.spheres.is_empty());
        let at =
            of_spheres.into_iter().chain(self.at_place.get(&(one.code(), one.place.as_deref()))).min()?;
        self.findings.get(*at)
    }

    /// The first finding that says the same as `one`, else the first that is another step of the same ladder.
    #[must_use]
    pub fn nearest(&self, one: &Found) -> Option<&'f Found> {
        let steps = DEPTH.iter().filter(|code| **code != one.code() && DEPTH.contains(&one.code()));
        let first = || self.findings.get(*steps.filter_map(|code| self.of_code.get(code)).min()?);
        self.same(one).or_else(first)
    }
}
