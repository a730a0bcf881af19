//! Remedies that hold: each is tried, and the next is taken from a check of the result.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use osim_inspect::{CheckResult, FindingIndex, FindingWithRemedy, InspectOptions, Inspection};
use osim_model::files::{FileName, Files, InMemory};
use osim_model::{Finding, FindingCode, Model, Pattern, Repair, Severity};
use osim_requests::options::{OutputOptions, WantedOptions};
use osim_requests::{ConstantIndentation, DesignRequest, Request};

use crate::planner::check_with_trials;
use crate::verbs::prepare;

/// Checks a model that was inspected, with remedies that were tried, for a model by itself: they name no other files. `beside` is
/// what was found in files beside it.
pub fn check_with_remedies(
    options: &InspectOptions,
    model: &Model,
    inspected: &Inspection,
    beside: &[Finding],
) -> CheckResult {
    let inspect = |name: &FileName, model: &Model| options.inspect(name.clone(), model, None);
    let trials = Trials { options, files: &InMemory::default(), inspect: &inspect };
    trials.tried(model, check_with_trials(options, model, inspected, beside))
}

// The steps that put a model right, one after the other.

/// Steps at most. What is still wrong then is found by the next check.
const STEPS: usize = 8;

/// Tries the remedies of a model.
pub(crate) struct Trials<'t> {
    pub(crate) options: &'t InspectOptions,
    /// What requests name beside the model.
    pub(crate) files: &'t dyn Files,
    pub(crate) inspect: &'t dyn Fn(&FileName, &Model) -> Inspection,
}

/// A model on the way, and what is found in it.
struct State {
    model: Model,
    found: CheckResult,
}

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
        let left: Vec<FindingIndex<'_>> =
            steps.iter().map(|step| FindingIndex::new(&step.found.findings)).collect();
        for one in &mut found.findings {
            let gone =
                steps.iter().zip(&left).find(|(_, left)| left.find_same(one).is_none()).map(|(step, _)| step);
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
            let its: Vec<&FindingWithRemedy> =
                found.findings.iter().filter(|one| is_for(&parts, one)).collect();
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
        let plan = change.plan_alone(model).ok().filter(|plan| !plan.is_empty())?;
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
fn is_for(requests: &[Request], finding: &FindingWithRemedy) -> bool {
    finding.remedy.as_ref().is_some_and(|remedy| requests.contains(remedy))
}

fn has_command(finding: &FindingWithRemedy) -> bool {
    finding.severity >= Severity::Warning && matches!(finding.rule.repair, Repair::Command(_))
}

/// Whether a remedy did what it promises.
fn holds(its: &[&FindingWithRemedy], request: &Request, before: &CheckResult, after: &CheckResult) -> bool {
    let (left, old) = (FindingIndex::new(&after.findings), FindingIndex::new(&before.findings));
    let gone = its.iter().all(|one| left.find_same(one).is_none());
    let makes_forces = matches!(request, Request::Convert(_));
    let moved = bad(after).filter(|one| old.find_same(one).is_none()).any(|one| one.spheres.is_empty())
        && !makes_forces;
    gone && !moved && codes(after).is_subset(&codes(before))
}

fn bad(found: &CheckResult) -> impl Iterator<Item = &FindingWithRemedy> {
    found.findings.iter().filter(|one| one.severity >= Severity::Warning)
}

fn codes(found: &CheckResult) -> BTreeSet<FindingCode> {
    bad(found).map(|one| one.code()).collect()
}

// Several remedies as one command.

/// A request to try, and the remedies that it does.
#[derive(Debug, Clone, PartialEq)]
struct Candidate {
    request: Request,
    parts: Vec<Request>,
}

impl Candidate {
    fn alone(request: Request) -> Self {
        Self { parts: vec![request.clone()], request }
    }
}

/// Remedies that do the same to other forces, each group as one that names all of them.
fn joined(remedies: &[Request]) -> Vec<Candidate> {
    let mut groups: Vec<Candidate> = Vec::new();
    for remedy in remedies {
        let both = |group: &Candidate| with_forces(&group.request, remedy);
        match groups.iter_mut().find_map(|group| both(group).map(|both| (group, both))) {
            Some((group, both)) => {
                group.request = both;
                group.parts.push(remedy.clone());
            }
            None => groups.push(Candidate::alone(remedy.clone())),
        }
    }
    groups.retain(|group| group.parts.len() > 1);
    groups
}

/// `one` for the forces of `other`, too; `None` where they differ in anything else, or one is for all forces.
fn with_forces(one: &Request, other: &Request) -> Option<Request> {
    let (mut all, mut more) = (one.clone(), other.clone());
    let (before, added) = (std::mem::take(forces(&mut all)?), std::mem::take(forces(&mut more)?));
    let are_chosen = !added.is_empty() && !before.is_empty();
    if !are_chosen || all != more {
        return None;
    }
    forces(&mut all)?.extend(before.into_iter().chain(added));
    Some(all)
}

fn forces(request: &mut Request) -> Option<&mut Vec<Pattern>> {
    match request {
        Request::Set(request) => Some(&mut request.choice.select),
        Request::Convert(request) => Some(&mut request.choice.select),
        _ => None,
    }
}

/// Everything that the designs want, in one; `None` where there are not several. Where two want other numbers of the same, the first
/// counts.
fn merged(candidates: &[Candidate]) -> Option<Candidate> {
    let designs: Vec<&DesignRequest> = candidates
        .iter()
        .filter_map(|candidate| match &candidate.request {
            Request::Design(design) => Some(&**design),
            _ => None,
        })
        .collect();
    let (first, others) = designs.split_first().filter(|(_, others)| !others.is_empty())?;
    let mut all: DesignRequest = (*first).clone();
    for other in others {
        add(&mut all.wanted, &other.wanted);
    }
    let parts = designs.into_iter().map(|design| design.clone().into()).collect();
    Some(Candidate { request: all.into(), parts })
}

/// Wants what `other` wants, too, where nothing is wanted of that yet.
fn add(wanted: &mut WantedOptions, other: &WantedOptions) {
    wanted.indentation = wanted.indentation.or(other.indentation);
    wanted.restitution = wanted.restitution.or(other.restitution);
    wanted.impact_speed = wanted.impact_speed.or(other.impact_speed);
    wanted.constant_indentation = wanted.constant_indentation.or(other.constant_indentation);
    wanted.state_width = wanted.state_width.or(other.state_width);
}

// The files that steps write: `human.fixed-1.osim`, `human.fixed-2.osim`.

/// What the names of results of steps end in, before their number.
const MARK: &str = ".fixed-";

/// Lets a step write the next file that is not there yet, and says which; `None` of a request that writes none.
fn output(request: &mut Request, from: &Path, files: &dyn Files) -> Option<PathBuf> {
    let (stem, done) = numbered(from);
    let name = |number: u32| {
        let mut name = format!("{stem}{MARK}{number}");
        if let Some(extension) = from.extension() {
            name = format!("{name}.{}", extension.to_string_lossy());
        }
        from.with_file_name(name)
    };
    let to = (done + 1..).map(name).find(|name| !files.exists(name))?;
    request.output_mut()?.output = Some(to.clone());
    Some(to)
}

/// Lets a step that is the only one write the file that every change writes, if that is not there yet. A model that is the result
/// of a step stays in its series.
fn unnumbered(request: &mut Request, from: &Path, files: &dyn Files) {
    if numbered(from).1 == 0
        && !files.exists(&OutputOptions::beside(from))
        && let Some(output) = request.output_mut()
    {
        output.output = None;
    }
}

/// The name without extension and number, and the number; 0 of a model that no step wrote.
fn numbered(model: &Path) -> (String, u32) {
    let stem = model.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let number =
        stem.rsplit_once(MARK).and_then(|(stem, number)| Some((stem.to_owned(), number.parse().ok()?)));
    number.unwrap_or((stem, 0))
}

#[cfg(test)]
mod tests {
    use osim_model::files::InMemory;
    use osim_requests::DesignRequest;

    use super::*;

    #[test]
    fn each_step_has_the_next_free_number() {
        let files = InMemory::from_iter([("a/human.fixed-2.osim", "")]);
        for (from, to) in [
            ("a/human.osim", "a/human.fixed-1.osim"),
            ("a/human.fixed-1.osim", "a/human.fixed-3.osim"),
            ("human.scaled.osim", "human.scaled.fixed-1.osim"),
            ("forces.xml", "forces.fixed-1.xml"),
            ("human.fixed-x.osim", "human.fixed-x.fixed-1.osim"),
        ] {
            let mut request = Request::from(DesignRequest::default());
            assert_eq!(output(&mut request, Path::new(from), &files).as_deref(), Some(Path::new(to)));
            assert_eq!(request.output_mut().unwrap().output.as_deref(), Some(Path::new(to)));
        }
    }
}
