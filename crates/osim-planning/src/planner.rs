//! What a request plans for each of its models, and trial plans: which changes would be refused.

use std::collections::HashSet;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use osim_inspect::{
    Changeable, CheckResult, InspectOptions, Inspection, ReferenceState, check_model, model_findings,
    unmatched_patterns,
};
use osim_model::files::{Failure, Files, OpenModel};
use osim_model::messages::{Phrase, Verb};
use osim_model::{Assignment, Fault, FaultKind, FileId, Finding, Model, Needed, Property, Source};
use osim_patch::{Plan, Set, StepDetails, set};
use osim_requests::options::{AnswerOptions, InspectionOptions, OutputOptions, SetFiles};
use osim_requests::{NoteDetails, takes};

use crate::afterwards::{Aims, Changed, worse_findings};
use crate::motion::MotionResult;
use crate::motion_remarks::MotionRemark;
use crate::opening::open_with;

/// Plans the change of one model after the other, on any thread.
pub trait Planner: Send + Sync {
    /// Plans the change of a model.
    ///
    /// # Errors
    /// What only the caller can know, or what cannot be done with this model.
    fn plan(&self, model: &Model) -> Result<Plan, Fault>;

    /// The plan where files beside the model say something, such as the meshes of its bones.
    fn plan_beside(&self, opened: &OpenModel, files: &dyn Files) -> Result<Plan, Failure> {
        // Most plans follow from the model alone.
        let _ = files;
        self.plan(&opened.model).map_err(|fault| opened.failure(fault))
    }

    /// The plan for a model that was opened: what is odd about the model itself is among the warnings, and what the change makes worse.
    /// Without `details` it gets no note.
    fn plan_opened(
        &self,
        opened: &OpenModel,
        details: Option<&NoteDetails>,
        files: &dyn Files,
    ) -> Result<Plan, Failure> {
        let mut plan = unjudged(self, opened, details, files)?;
        if !plan.is_empty() {
            let changed = Changed::of(&plan, opened)?;
            judge(self, opened, &mut plan, &changed)?;
        }
        Ok(plan)
    }

    /// The plan with the model as it will be, which was read from its new bytes; `None` where nothing changes.
    fn plan_with_result(
        &self,
        opened: &OpenModel,
        details: Option<&NoteDetails>,
        files: &dyn Files,
    ) -> Result<(Plan, Option<Model>), Failure> {
        let mut plan = unjudged(self, opened, details, files)?;
        if plan.is_empty() {
            return Ok((plan, None));
        }
        let changed = Changed::read(&plan, opened)?;
        judge(self, opened, &mut plan, &changed)?;
        Ok((plan, Some(changed.into_model())))
    }

    /// Files that were read beside the models.
    fn reads(&self) -> Vec<PathBuf> {
        Vec::new()
    }

    fn name(&self) -> &'static str;

    /// How a model would be inspected with the same options.
    fn inspection(&self) -> InspectionOptions;

    /// Gravity that the contacts are scaled to, m/s², if it is asked for.
    fn target_gravity_m_s2(&self) -> Option<f64> {
        None
    }

    /// `message` with the ways out that its verb has.
    fn keep_ways_out(&self, message: &mut Phrase) {
        if let Some(verb) = Verb::ALL.iter().find(|verb| verb.name() == self.name()) {
            message.keep_for(&|input| takes(*verb, input));
        }
    }

    /// What the change aims at, apart from its numbers.
    fn aims(&self) -> Aims {
        Aims {
            carries_target: self.name() == "rescale",
            gravity_m_s2: self.target_gravity_m_s2(),
            as_given: matches!(self.name(), "set" | "design" | "fit"),
        }
    }

    /// What the contacts are taken from, where they are another body's.
    fn reference(&self) -> Option<&ReferenceState> {
        None
    }

    /// What the caller has answered before it was asked.
    fn answers(&self) -> Option<&AnswerOptions> {
        None
    }

    /// What the contacts of the changed model do along the recording that the change follows, where it follows one.
    fn recording(&self, changed: OpenModel) -> Option<(MotionResult, Vec<MotionRemark>)> {
        let _ = changed;
        None
    }

    /// Everything its plans follow from except the files: equal texts, equal plans.
    fn settings(&self) -> String;
}

/// What `planner` plans, with its note and with what is odd about the model itself.
fn unjudged<P: Planner + ?Sized>(
    planner: &P,
    opened: &OpenModel,
    details: Option<&NoteDetails>,
    files: &dyn Files,
) -> Result<Plan, Failure> {
    let model = &opened.model;
    let mut plan = planner.plan_beside(opened, files)?;
    match details {
        Some(details) => {
            let reference = planner
                .reference()
                .map(|reference| Source { name: reference.name.clone(), digest: reference.digest.clone() });
            let (options, stance_limbs) = (details.options.clone(), details.stance_limbs);
            plan.add_details(StepDetails { options, reference, stance_limbs, date: files.today() });
        }
        None => {
            plan.without_note();
            if model.note.is_some() && !plan.is_empty() {
                let text = "the note is removed: the next run cannot know what the contacts are made for";
                plan.remarks.push(text.into());
            }
        }
    }
    if plan.adds_credits(model) {
        let text = "the model has no <credits>: they are added for the note, because OpenSim drops comments when it saves";
        plan.remarks.push(text.into());
    }
    let standing = standing_findings(&plan, model);
    plan.warnings.splice(0..0, standing);
    let InspectOptions { selection, masses, .. } = InspectOptions::from(&planner.inspection());
    plan.remarks.extend(unmatched_patterns(&selection, &masses, model));
    Ok(plan)
}

/// What is odd about `model` itself and stays so: a finding about an object that goes, or that becomes another one, is no longer one.
fn standing_findings(plan: &Plan, model: &Model) -> Vec<Finding> {
    let key = |finding: &Finding| (finding.code(), finding.place.clone());
    let still: HashSet<_> = model_findings(plan.ground(model)).iter().map(key).collect();
    model_findings(model).iter().filter(|finding| still.contains(&key(finding))).cloned().collect()
}

/// Adds to `plan` what it makes worse.
fn judge<P: Planner + ?Sized>(
    planner: &P,
    opened: &OpenModel,
    plan: &mut Plan,
    changed: &Changed,
) -> Result<(), Failure> {
    let before = InspectOptions::from(&planner.inspection());
    let worse = worse_findings(planner.aims(), &before, opened, (plan, changed), planner.answers())?;
    for mut finding in worse {
        planner.keep_ways_out(&mut finding.message);
        plan.warnings.push(finding);
    }
    Ok(())
}

/// A request that was checked: where its models are, what it plans, and where results go.
///
/// ```
/// use osim_model::FileId;
/// use osim_model::files::InMemory;
/// use osim_planning::prepare;
/// use osim_requests::{Request, RequestError};
///
/// let bytes = include_bytes!("../../osim-model/tests/data/one_foot.osim");
/// let files = InMemory::from_iter([("one_foot.osim", bytes.as_slice())]);
/// let json = br#"{"verb": "rescale", "models": "one_foot.osim", "target_mass": 80}"#;
///
/// let change = prepare(Request::from_json(json)?, &files)?;
/// for path in &change.models {
///     let opened = change.open(path, &files)?;
///     let plan = change.plan(&opened, &files)?;
///     let changed = plan.patched(&opened.model, FileId::MAIN).map_err(|fault| opened.failure(fault))?;
///     assert!(String::from_utf8_lossy(&changed).contains("<radius>0.06</radius>"));
/// }
/// # Ok::<(), RequestError>(())
/// ```
pub struct Change {
    pub models: Vec<PathBuf>,
    pub output: OutputOptions,
    /// Files of a standalone set.
    pub set_files: SetFiles,
    /// What is planned for each model.
    pub planner: Arc<dyn Planner>,
    pub details: NoteDetails,
}

impl Change {
    pub(crate) fn new(
        models: Vec<PathBuf>,
        output: OutputOptions,
        set_files: SetFiles,
        planner: impl Planner + 'static,
    ) -> Self {
        Self { models, output, set_files, planner: Arc::new(planner), details: NoteDetails::default() }
    }

    /// Opens one of its models, with the files of a standalone set.
    ///
    /// # Errors
    /// It cannot be read.
    pub fn open(&self, path: &Path, files: &dyn Files) -> Result<OpenModel, Failure> {
        open_with(path, self.set_files.beside(), files)
    }

    pub fn plan(&self, opened: &OpenModel, files: &dyn Files) -> Result<Plan, Failure> {
        let details = Some(&self.details).filter(|_| !self.output.no_note);
        self.planner.plan_opened(opened, details, files)
    }

    /// The plan with the model as it will be; `None` where nothing changes.
    pub fn plan_with_result(
        &self,
        opened: &OpenModel,
        files: &dyn Files,
    ) -> Result<(Plan, Option<Model>), Failure> {
        let details = Some(&self.details).filter(|_| !self.output.no_note);
        self.planner.plan_with_result(opened, details, files)
    }
}

/// The file's name without its folders, for notes and messages.
pub(crate) fn file_name(path: &Path) -> String {
    path.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned())
}

// Trial plans: which changes of a model would be refused, so that no remedy proposes them.

/// Tries what can be changed in a model.
pub fn changeable(options: &InspectOptions, model: &Model) -> Changeable {
    with_numbers(options, model, can_be_changed(options, model))
}

/// Tries the rest where it is known whether the numbers can be changed.
pub(crate) fn with_numbers(options: &InspectOptions, model: &Model, numbers: bool) -> Changeable {
    Changeable { numbers, radii: !numbers || radii_may_change(options, model) }
}

/// Whether radii may change: no sphere is used by a force that would not change with it. This is tried.
fn radii_may_change(options: &InspectOptions, model: &Model) -> bool {
    let mut trial = Set::new(vec![(Property::Radius, Assignment::Factor(2.0))]);
    trial.again = true;
    let plan = options.selection.apply(model).and_then(|selected| set(model, &selected, &trial));
    !plan.is_err_and(|fault| matches!(fault.kind, FaultKind::Needed(Needed::SharedSphere { .. })))
}

/// Whether the numbers of `model` can be changed. This is tried: a remedy that would be refused does not help.
fn can_be_changed(options: &InspectOptions, model: &Model) -> bool {
    let assignments =
        vec![(Property::Dissipation, Assignment::Value(0.0)), (Property::Stiffness, Assignment::Value(1.0))];
    let mut trial = Set::new(assignments);
    trial.again = true;
    let plan = options.selection.apply(model).and_then(|selected| set(model, &selected, &trial));
    plan.and_then(|plan| plan.patched(model, FileId::MAIN)).is_ok()
}

/// Checks a model that was inspected, after it was tried what can be changed; `beside` is what was found in files beside it.
pub fn check_with_trials(
    options: &InspectOptions,
    model: &Model,
    inspected: &Inspection,
    beside: &[Finding],
) -> CheckResult {
    check_model(options, model, inspected, beside, changeable(options, model))
}
