//! Tries remedies before they are proposed: after each remedy, the changed model is checked, and the next remedy is chosen from that check.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use osim_inspect::{CheckResult, FindingIndex, FindingWithRemedy, InspectOptions, Inspection};
use osim_model::files::{FileName, Files, InMemory};
use osim_model::{Finding, FindingCode, Model, Pattern, Repair, Severity};
use osim_requests::options::OutputOptions;
use osim_requests::{ConstantIndentation, DesignRequest, Request};

use crate::{check_with_trials, prepare};

/// Checks a model that was inspected, and tries the remedies. The remedies name no other files. `beside` are findings about companion files
/// of the model.
pub fn check_with_remedies(
    options: &InspectOptions,
    model: &Model,
    inspected: &Inspection,
    beside: &[Finding],
) -> CheckResult {
    let inspect = |name: &FileName, model: &Model| options.inspect(name.clone(), model, None);
    let files = &InMemory::default();
    let trials = RemedyTrials { options, files, inspect: &inspect, of_reference: &NO_CODES, beside };
    trials.with_tried_remedies(model, check_with_trials(options, model, inspected, beside))
}

/// The largest number of steps that are proposed. A check after these steps finds what is still wrong.
const MOST_STEPS: usize = 8;

/// No codes, for a model that is compared with no other model.
pub(crate) static NO_CODES: BTreeSet<FindingCode> = BTreeSet::new();

/// Tries the remedies that a check proposes.
pub(crate) struct RemedyTrials<'t> {
    pub(crate) options: &'t InspectOptions,
    /// The files that remedies may name.
    pub(crate) files: &'t dyn Files,
    pub(crate) inspect: &'t dyn Fn(&FileName, &Model) -> Inspection,
    /// Codes of the findings about the model before scaling. Its contacts bring these faults along.
    pub(crate) of_reference: &'t BTreeSet<FindingCode>,
    /// Findings about companion files, which no remedy changes.
    pub(crate) beside: &'t [Finding],
}

/// A remedy that works, and the findings about the model after it.
struct TriedStep {
    request: Request,
    found: CheckResult,
}

impl RemedyTrials<'_> {
    /// The result `found` of checking `model`, with remedies that work one after the other. After each step its finding is gone, and no
    /// warning is new. Each finding gets the step after which it is gone.
    pub(crate) fn with_tried_remedies(&self, model: &Model, mut found: CheckResult) -> CheckResult {
        if found.steps.is_empty() {
            return found;
        }
        let mut steps = self.steps(model, &found);
        let path = model_path(&found);
        if let [only] = steps.as_mut_slice() {
            set_default_output(&mut only.request, &path, self.files);
        }
        let remaining: Vec<FindingIndex<'_>> =
            steps.iter().map(|step| FindingIndex::new(&step.found.findings)).collect();
        for one in &mut found.findings {
            let mut both = steps.iter().zip(&remaining);
            let step_without_it = both.find(|(_, remaining)| is_put_right(one, remaining));
            let may_have_command =
                one.severity >= Severity::Warning && matches!(one.rule.repair, Repair::Command(_));
            let step_without_it = step_without_it.filter(|_| may_have_command);
            one.remedy = step_without_it.map(|(step, _)| step.request.clone());
        }
        let left = steps.last().map_or(&found, |step| &step.found);
        found.corrected =
            warnings_and_errors(&found).count().saturating_sub(warnings_and_errors(left).count());
        found.steps = steps.into_iter().map(|step| step.request).collect();
        found
    }

    /// The remedies that work one after the other, at most [`MOST_STEPS`].
    fn steps(&self, model: &Model, found: &CheckResult) -> Vec<TriedStep> {
        let one_file = self.options.geometry.is_none() && self.options.model.is_none();
        // A standalone set is two files, which a step would have to name anew.
        let most = if one_file { MOST_STEPS } else { 1 };
        let mut steps: Vec<TriedStep> = Vec::new();
        let mut latest_model: Option<Model> = None;
        while steps.len() < most {
            let latest_findings = steps.last().map_or(found, |step| &step.found);
            let Some((request, (changed, found))) =
                self.next_step(latest_model.as_ref().unwrap_or(model), latest_findings)
            else {
                break;
            };
            steps.push(TriedStep { request, found });
            latest_model = Some(changed);
        }
        steps
    }

    /// The first remedy that works, and the model after it.
    fn next_step(&self, model: &Model, found: &CheckResult) -> Option<(Request, (Model, CheckResult))> {
        let from = model_path(found);
        remedy_candidates(found).into_iter().find_map(|RemedyCandidate { mut request, parts, .. }| {
            let is_proposed =
                |one: &&FindingWithRemedy| one.remedy.as_ref().is_some_and(|one| parts.contains(one));
            let its: Vec<&FindingWithRemedy> = found.findings.iter().filter(is_proposed).collect();
            let to = set_numbered_output(&mut request, &from, self.files)?;
            let (changed, after) = self.model_after(&request, model, &to)?;
            // If the mass that the contacts are made for becomes uncertain, the next step cannot be planned.
            let in_doubt = changed.doubt_about_note().is_some() && model.doubt_about_note().is_none();
            (!in_doubt && self.is_effective(&its, &request, found, &after))
                .then_some((request, (changed, after)))
        })
    }

    /// The model after the request, written as the file `to`; `None` if the request is refused or changes nothing.
    fn model_after(&self, request: &Request, model: &Model, to: &Path) -> Option<(Model, CheckResult)> {
        let change = prepare(request.clone(), self.files).ok()?;
        let plan = change.plan_alone(model).ok().filter(|plan| !plan.is_empty())?;
        let model = plan.changed_model(model).ok()?;
        let inspected = (self.inspect)(&FileName::from(to), &model);
        let found = check_with_trials(self.options, &model, &inspected, self.beside);
        Some((model, found))
    }

    /// Whether the findings `its`, for which the remedy was proposed, are gone after the remedy or about fewer elements, and no other warning
    /// is new.
    fn is_effective(
        &self,
        its: &[&FindingWithRemedy],
        request: &Request,
        before: &CheckResult,
        after: &CheckResult,
    ) -> bool {
        let (findings_after, findings_before) =
            (FindingIndex::new(&after.findings), FindingIndex::new(&before.findings));
        let is_gone = |one: &&FindingWithRemedy| {
            findings_after.find_same(one).is_none_or(|left| left.paths().count() < one.paths().count())
        };
        let are_gone = its.iter().all(is_gone);
        let makes_forces = matches!(request, Request::Convert(_));
        // What followed from a fault that is gone now may have been left out before.
        let mut unsaid = self.of_reference | &before.left_out;
        // A foot that is uneven in the model before scaling can be so by more than the limit at another height.
        unsaid.extend(unsaid.contains(&FindingCode::UnlevelFoot).then_some(FindingCode::UnevenBottoms));
        let has_new_warnings = warnings_and_errors(after)
            .filter(|one| findings_before.find_same(one).is_none() && !unsaid.contains(&one.code()))
            .any(|one| one.spheres.is_empty())
            && !makes_forces;
        let known = &codes_of_warnings(before) | &unsaid;
        are_gone && !has_new_warnings && codes_of_warnings(after).is_subset(&known)
    }
}

/// The path of the checked model.
fn model_path(found: &CheckResult) -> PathBuf {
    FileName::from_parts(found.model.clone(), found.model_bytes.clone()).to_path()
}

/// The remedies to try, in this order: remedies that make contacts right for their body, because the others depend on them; conversions of
/// forces; numbers of some forces; designs of all forces. Remedies that differ only in their forces are also joined to one command, and all
/// designs are merged to one.
fn remedy_candidates(found: &CheckResult) -> Vec<RemedyCandidate> {
    let rank = |one: &RemedyCandidate| match &one.request {
        Request::Rescale(_) | Request::Transfer(_) => 0,
        Request::Convert(_) => 1,
        // Bottoms depend on radii.
        Request::Set(set) if set.level => 3,
        Request::Set(_) => 2,
        // The load of a sphere at rest depends on its dissipation (C.9), and the smoothing on its indentation at rest.
        Request::Design(design) if design.wanted.restitution.is_some() => 4,
        Request::Design(design) if design.wanted.indentation.is_some() => 5,
        _ => 6,
    };
    // The smallest of several constant indentations also has the effect of the others.
    let constant = |one: &RemedyCandidate| match &one.request {
        Request::Design(design) => design.wanted.constant_indentation.map_or(1.0, ConstantIndentation::get),
        _ => 1.0,
    };
    let mut all = joined_over_forces(&found.steps);
    all.extend(found.steps.iter().cloned().map(RemedyCandidate::of_one));
    all.sort_by(|a, b| rank(a).cmp(&rank(b)).then(constant(a).total_cmp(&constant(b))));
    all.extend(merged_designs(&all));
    all
}

/// Whether a warning or an error is not among the `remaining` findings, or is only a remark there, as with published contacts.
fn is_put_right(one: &FindingWithRemedy, remaining: &FindingIndex<'_>) -> bool {
    remaining.find_same(one).is_none_or(|left| left.severity == Severity::Remark)
}

fn warnings_and_errors(found: &CheckResult) -> impl Iterator<Item = &FindingWithRemedy> {
    found.findings.iter().filter(|one| one.severity >= Severity::Warning)
}

/// The codes of all errors and warnings.
fn codes_of_warnings(found: &CheckResult) -> BTreeSet<FindingCode> {
    warnings_and_errors(found).map(|one| one.code()).collect()
}

/// A request to try, and the proposed remedies that it contains.
#[derive(Debug, Clone, PartialEq)]
struct RemedyCandidate {
    request: Request,
    parts: Vec<Request>,
}

impl RemedyCandidate {
    fn of_one(request: Request) -> Self {
        Self { parts: vec![request.clone()], request }
    }
}

/// One request for each group of remedies that differ only in the forces that they name.
fn joined_over_forces(remedies: &[Request]) -> Vec<RemedyCandidate> {
    let mut groups: Vec<RemedyCandidate> = Vec::new();
    for remedy in remedies {
        let joined_with = |group: &RemedyCandidate| request_for_forces_of_both(&group.request, remedy);
        match groups.iter_mut().find_map(|group| joined_with(group).map(|joined_with| (group, joined_with))) {
            Some((group, joined_with)) => {
                group.request = joined_with;
                group.parts.push(remedy.clone());
            }
            None => groups.push(RemedyCandidate::of_one(remedy.clone())),
        }
    }
    groups.retain(|group| group.parts.len() > 1);
    groups
}

/// The request `one`, extended to the forces of `other`. `None` if the requests differ in something else, or one of them is for all forces.
fn request_for_forces_of_both(one: &Request, other: &Request) -> Option<Request> {
    let (mut all, mut more) = (one.clone(), other.clone());
    let (before, added) =
        (std::mem::take(selected_forces(&mut all)?), std::mem::take(selected_forces(&mut more)?));
    let are_chosen = !added.is_empty() && !before.is_empty();
    if !are_chosen || all != more {
        return None;
    }
    selected_forces(&mut all)?.extend(before.into_iter().chain(added));
    Some(all)
}

/// The patterns by which a `set` or a `convert` chooses forces; `None` for other verbs.
fn selected_forces(request: &mut Request) -> Option<&mut Vec<Pattern>> {
    match request {
        Request::Set(request) => Some(&mut request.choice.select),
        Request::Convert(request) => Some(&mut request.choice.select),
        _ => None,
    }
}

/// One design that wants everything which the designs among the candidates want; `None` if there are fewer than two designs. If two designs
/// want different numbers of one quantity, the first counts.
fn merged_designs(candidates: &[RemedyCandidate]) -> Option<RemedyCandidate> {
    let designs: Vec<&DesignRequest> = candidates
        .iter()
        .filter_map(|candidate| match &candidate.request {
            Request::Design(design) => Some(&**design),
            _ => None,
        })
        .collect();
    let (first, others) = designs.split_first().filter(|(_, others)| !others.is_empty())?;
    let mut all: DesignRequest = (*first).clone();
    let wanted = &mut all.wanted;
    for DesignRequest { wanted: other, .. } in others.iter().copied() {
        wanted.indentation = wanted.indentation.or(other.indentation);
        wanted.restitution = wanted.restitution.or(other.restitution);
        wanted.impact_speed = wanted.impact_speed.or(other.impact_speed);
        wanted.constant_indentation = wanted.constant_indentation.or(other.constant_indentation);
        wanted.state_width = wanted.state_width.or(other.state_width);
    }
    let parts = designs.into_iter().map(|design| design.clone().into()).collect();
    Some(RemedyCandidate { request: all.into(), parts })
}

/// The text before the number in the names of files that steps write, such as `human.fixed-1.osim` and `human.fixed-2.osim`.
const STEP_INFIX: &str = ".fixed-";

/// Gives a step an output file with the next free number, and returns this file; `None` for a request that writes no file.
fn set_numbered_output(request: &mut Request, from: &Path, files: &dyn Files) -> Option<PathBuf> {
    let (stem, done) = split_step_number(from);
    let name = |number: u32| {
        let mut name = format!("{stem}{STEP_INFIX}{number}");
        if let Some(extension) = from.extension() {
            name = format!("{name}.{}", extension.to_string_lossy());
        }
        from.with_file_name(name)
    };
    let to = (done + 1..).map(name).find(|name| !files.exists(name))?;
    request.output_mut()?.output = Some(to.clone());
    Some(to)
}

/// If a remedy has only one step, gives it the default output file of a change, unless the file exists. If the model is itself the output
/// of a step, the output keeps its number.
fn set_default_output(request: &mut Request, from: &Path, files: &dyn Files) {
    if split_step_number(from).1 == 0
        && !files.exists(&OutputOptions::result_beside(from))
        && let Some(output) = request.output_mut()
    {
        output.output = None;
    }
}

/// Splits the name of a model into the name without extension and number, and the number; 0 if no step wrote the model.
fn split_step_number(model: &Path) -> (String, u32) {
    let stem = model.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let number =
        stem.rsplit_once(STEP_INFIX).and_then(|(stem, number)| Some((stem.to_owned(), number.parse().ok()?)));
    number.unwrap_or((stem, 0))
}

#[cfg(test)]
mod tests {
    use osim_model::files::InMemory;
    use osim_requests::DesignRequest;

    use super::*;
    use crate::rules;

    #[test]
    fn a_warning_that_is_a_remark_afterwards_is_put_right() {
        let rule = rules::with_code(|code| code == FindingCode::WideTransition).next().unwrap();
        let warning: FindingWithRemedy = Finding::new(rule, "wide").with_severity(Severity::Warning).into();
        let remark: FindingWithRemedy = Finding::new(rule, "wide").with_severity(Severity::Remark).into();
        for (remaining, is_right) in [(vec![], true), (vec![remark], true), (vec![warning.clone()], false)] {
            assert_eq!(is_put_right(&warning, &FindingIndex::new(&remaining)), is_right);
        }
    }

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
            assert_eq!(
                set_numbered_output(&mut request, Path::new(from), &files).as_deref(),
                Some(Path::new(to))
            );
            assert_eq!(request.output_mut().unwrap().output.as_deref(), Some(Path::new(to)));
        }
    }
}
