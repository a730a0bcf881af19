//! The steps that put a model right, one after the other.

use osim_inspect::{CheckResult, Found, InspectOptions, Inspection, Kin};
use osim_model::files::{FileName, Files};
use osim_model::{FindingCode, Model, Repair, Severity};
use osim_requests::{ConstantIndentation, Request};
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use super::merged::{Candidate, joined, merged};
use super::naming::{output, unnumbered};
use crate::trial::check_with_trials;
use crate::verbs::any::prepare;

/// Steps at most. What is still wrong then is found by the next check.
const STEPS: usize = 8;

/// Tries the remedies of a model.
pub(crate) struct Trials<'t> {
    pub(crate) options: &'t InspectOptions,
    /// What requests name beside the model.
    pub(crate) files: &'t dyn Files,
    /// How a model of this name is inspected.
    pub(crate) inspect: &'t dyn Fn(&FileName, &Model) -> Inspection,
}

/// A model on the way, and what is found in it.
struct State {
    model: Model,
    found: CheckResult,
}

/// A remedy that held.
struct Step {
    request: Request,
    /// What is found afterwards.
    found: CheckResult,
}

impl Trials<'_> {
    /// `found` in `model` with the remedies that hold, as steps that work one after the other. Each succeeds, its finding is gone
    /// afterwards, and no warning is new. A finding has the step after which it is gone.
    pub(crate) fn tried(&self, model: &Model, mut found: CheckResult) -> CheckResult {
        if found.steps.is_empty() {
            return found;
        }
        let mut steps = self.steps(model, &found);
        let path = path_of(&found);
        if let [only] = steps.as_mut_slice() {
            unnumbered(&mut only.request, &path, self.files);
        }
        let left: Vec<Kin<'_>> = steps.iter().map(|step| Kin::of(&step.found.findings)).collect();
        for one in &mut found.findings {
            let gone =
                steps.iter().zip(&left).find(|(_, left)| left.same(one).is_none()).map(|(step, _)| step);
            one.remedy = gone.filter(|_| has_command(one)).map(|step| step.request.clone());
        }
        found.steps = steps.into_iter().map(|step| step.request).collect();
        found
    }

    fn steps(&self, model: &Model, found: &CheckResult) -> Vec<Step> {
        let one_file = self.options.geometry.is_none() && self.options.model.is_none();
        // A standalone set is two files, which a step would have to name anew.
        let most = if one_file { STEPS } else { 1 };
        let mut steps: Vec<Step> = Vec::new();
        let mut made: Option<Model> = None;
        while steps.len() < most {
            let now = steps.last().map_or(found, |step| &step.found);
            let Some((request, next)) = self.next(made.as_ref().unwrap_or(model), now) else { break };
            steps.push(Step { request, found: next.found });
            made = Some(next.model);
        }
        steps
    }

    /// The first remedy that holds, and the model that it makes.
    fn next(&self, model: &Model, found: &CheckResult) -> Option<(Request, State)> {
        let from = path_of(found);
        candidates(found).into_iter().find_map(|Candidate { mut request, parts, .. }| {
            let its: Vec<&Found> = found.findings.iter().filter(|one| is_for(&parts, one)).collect();
            let to = output(&mut request, &from, self.files)?;
            let next = self.after(&request, model, &to)?;
            // What makes it uncertain what the contacts are made for blocks the next step.
            let in_doubt = next.model.doubt_about_note().is_some() && model.doubt_about_note().is_none();
            (!in_doubt && holds(&its, &request, found, &next.found)).then_some((request, next))
        })
    }

    /// The model after a request, as the file `to`; `None` where it is refused or changes nothing.
    fn after(&self, request: &Request, model: &Model, to: &Path) -> Option<State> {
        let change = prepare(request.clone(), self.files).ok()?;
        let plan = change.planner.plan(model).ok().filter(|plan| !plan.is_empty())?;
        let model = plan.changed(model).ok()?;
        let inspected = (self.inspect)(&FileName::from(to), &model);
        let found = check_with_trials(self.options, &model, &inspected, &[]);
        Some(State { model, found })
    }
}

fn path_of(found: &CheckResult) -> PathBuf {
    FileName::from_parts(found.model.clone(), found.model_bytes.clone()).to_path()
}

/// What to try next: remedies that are one command together, each remedy by itself, and all designs at once. What makes contacts right
/// for their body comes first, because the others follow from it; then what makes other forces, then numbers of some, then those
/// of all.
fn candidates(found: &CheckResult) -> Vec<Candidate> {
    let rank = |one: &Candidate| match &one.request {
        Request::Rescale(_) | Request::Transfer(_) => 0,
        Request::Convert(_) => 1,
        Request::Set(_) => 2,
        // What a sphere carries at rest follows from the dissipation (C.9), and the smoothing from how deep it rests.
        Request::Design(design) if design.wanted.restitution.is_some() => 3,
        Request::Design(design) if design.wanted.indentation.is_some() => 4,
        _ => 5,
    };
    // Of several constant indentations the least does what the others do.
    let constant = |one: &Candidate| match &one.request {
        Request::Design(design) => design.wanted.constant_indentation.map_or(1.0, ConstantIndentation::get),
        _ => 1.0,
    };
    let mut all = joined(&found.steps);
    all.extend(found.steps.iter().cloned().map(Candidate::alone));
    all.sort_by(|a, b| rank(a).cmp(&rank(b)).then(constant(a).total_cmp(&constant(b))));
    all.extend(merged(&all));
    all
}

/// Whether one of these requests was proposed for the finding.
fn is_for(requests: &[Request], finding: &Found) -> bool {
    finding.remedy.as_ref().is_some_and(|remedy| requests.contains(remedy))
}

fn has_command(finding: &Found) -> bool {
    finding.severity >= Severity::Warn && matches!(finding.rule.repair, Repair::Command(_))
}

/// Whether a remedy did what it promises.
fn holds(its: &[&Found], request: &Request, before: &CheckResult, after: &CheckResult) -> bool {
    let (left, old) = (Kin::of(&after.findings), Kin::of(&before.findings));
    let gone = its.iter().all(|one| left.same(one).is_none());
    let makes_forces = matches!(request, Request::Convert(_));
    let moved =
        bad(after).filter(|one| old.same(one).is_none()).any(|one| one.spheres.is_empty()) && !makes_forces;
    gone && !moved && codes(after).is_subset(&codes(before))
}

fn bad(found: &CheckResult) -> impl Iterator<Item = &Found> {
    found.findings.iter().filter(|one| one.severity >= Severity::Warn)
}

fn codes(found: &CheckResult) -> BTreeSet<FindingCode> {
    bad(found).map(|one| one.code()).collect()
}
