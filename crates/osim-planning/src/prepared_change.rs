//! A checked request, which makes a plan for each of its models; and trial plans, which show what can be changed in a model.

use std::path::{Path, PathBuf};

use osim_inspect::{
    ChangeableValues, CheckResult, InspectOptions, Inspection, ReferenceState, check_model,
    first_unexplained, unexplained_mass,
};
use osim_model::files::{Failure, Files, OpenModel};
use osim_model::messages::{Input, Phrase, Verb, phrase, readable};
use osim_model::{
    Assignment, Fault, FaultKind, FileId, Finding, MassRequest, MissingFact, Model, Property, Suspicion,
    YesQuestion,
};
use osim_patch::{ChangedBy, Plan, Set, set};
use osim_requests::options::{AnswerOptions, InspectionOptions, OutputOptions, SetFiles};
use osim_requests::values::path;
use osim_requests::{NoteDetails, verb_takes};
use serde_json::{Map, Value, json};

use crate::{MotionRemark, MotionResult, open_with};

/// Makes the plan for the change of a model; each verb has its planner. Several threads use a planner at the same time.
pub(crate) trait Planner: Send + Sync {
    /// Plans the change of a model.
    ///
    /// # Errors
    /// What only the caller can know, or what cannot be done with this model.
    fn plan(&self, model: &Model) -> Result<Plan, Fault>;

    /// Plans the change of a model that needs companion files, such as the meshes of its bones.
    ///
    /// # Errors
    /// Those of [`plan`](Self::plan), with the name of the file and the place; a file that is missing or broken.
    fn plan_with_companions(&self, opened: &OpenModel, files: &dyn Files) -> Result<Plan, Failure> {
        // Most plans follow from the model alone.
        let _ = files;
        self.plan(&opened.model).map_err(|fault| opened.failure(fault))
    }

    /// The contacts of the changed model along the recording that they were fitted to; `None` if they were not fitted to a recording.
    fn recording(&self, changed: OpenModel) -> Option<(MotionResult, Vec<MotionRemark>)> {
        let _ = changed;
        None
    }
}

/// A planner that needs the model alone.
impl<F: Fn(&Model) -> Result<Plan, Fault> + Send + Sync> Planner for F {
    fn plan(&self, model: &Model) -> Result<Plan, Fault> {
        self(model)
    }
}

/// A request that was checked once for all of its models: the paths of the models, the planner for their changes, and the options for the
/// results.
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
pub struct PreparedChange {
    pub verb: Verb,
    /// Files and folders with the models of the request.
    pub models: Vec<PathBuf>,
    pub output: OutputOptions,
    /// The geometry set and the model that belong to a force set which is a file by itself.
    pub set_files: SetFiles,
    /// The options with which a model is inspected before the change.
    pub options: InspectOptions,
    /// The model or preset that the contacts come from, if they come from another body.
    pub reference: Option<ReferenceState>,
    /// Gravity that the contacts are scaled to, m/s², if the caller gave it.
    pub target_gravity_m_s2: Option<f64>,
    /// Parts of the request that the notes in the models repeat.
    pub details: NoteDetails,
    /// Whether the request is for several models. Then the program asks before it uses a mass that was given for all models on a model
    /// whose note has another mass.
    pub is_for_several: bool,
    /// The mass that the contacts are scaled to, kg, if the caller gave it.
    pub(crate) target_mass_kg: Option<f64>,
    /// The answers that the caller gave beforehand to questions of the program.
    pub(crate) answers: AnswerOptions,
    /// Files that are read once, for all models.
    pub(crate) extra_files: Vec<PathBuf>,
    /// The fields of the request on which its results depend.
    pub(crate) settings: Map<String, Value>,
    pub(crate) planner: Box<dyn Planner>,
}

impl PreparedChange {
    /// Combines a `planner` with the `models` whose changes it plans. `inspection` are the options with which these models are inspected.
    pub(crate) fn new(
        verb: Verb,
        models: Vec<PathBuf>,
        output: OutputOptions,
        inspection: InspectionOptions,
        planner: impl Planner + 'static,
    ) -> Self {
        Self {
            verb,
            models,
            output,
            options: InspectOptions::from(&inspection),
            set_files: inspection.set_files,
            reference: None,
            target_gravity_m_s2: None,
            details: NoteDetails::default(),
            is_for_several: false,
            target_mass_kg: None,
            answers: inspection.answers,
            extra_files: Vec::new(),
            settings: Map::new(),
            planner: Box::new(planner),
        }
    }

    /// Opens one of the models, with the companion files of a force set that is a file by itself.
    ///
    /// # Errors
    /// It cannot be read.
    pub fn open(&self, path: &Path, files: &dyn Files) -> Result<OpenModel, Failure> {
        open_with(path, self.set_files.companion_paths(), files)
    }

    /// Plans the change of a model without files beside it. The plan has no note, and no findings about the model or the result.
    ///
    /// # Errors
    /// What only the caller can know, or what cannot be done with this model.
    pub fn plan_alone(&self, model: &Model) -> Result<Plan, Fault> {
        self.ask_about_masses(model)?;
        let plan = self.planner.plan(model)?;
        self.ask_about_numbers(model, plan)
    }

    /// Plans like [`plan_alone`](Self::plan_alone), with the files beside the model.
    ///
    /// # Errors
    /// Those of [`plan_alone`](Self::plan_alone), with the name of the file and the place; a file that is missing or broken.
    pub fn plan_with_companions(&self, opened: &OpenModel, files: &dyn Files) -> Result<Plan, Failure> {
        let failure = |fault| opened.failure(fault);
        self.ask_about_masses(&opened.model).map_err(failure)?;
        let plan = self.planner.plan_with_companions(opened, files)?;
        self.ask_about_numbers(&opened.model, plan).map_err(failure)
    }

    /// Asks a question if a mass that the caller gave looks like a typing mistake or another unit, or differs from the mass in the note of
    /// this model.
    fn ask_about_masses(&self, model: &Model) -> Result<(), Fault> {
        let doubt = self.is_for_several.then(|| question_against_note(&self.options.masses, model)).flatten();
        self.answers.require_yes(doubt).map_err(Fault::new)?;
        let suspicion = unexplained_mass(&self.masses(), model, &self.options.selection);
        if suspicion.is_some() && self.verb != Verb::Add {
            // No mass helps where there are no contacts.
            self.options.selection.apply(model)?;
        }
        self.answers.require_yes(suspicion).map_err(Fault::new)
    }

    /// Asks a question about radii and stiffnesses that look like a typing mistake or another unit, and adds a remark if a mass is perhaps
    /// in pounds.
    fn ask_about_numbers(&self, model: &Model, mut plan: Plan) -> Result<Plan, Fault> {
        self.answers.require_yes(question_about_stiffness(&plan, self.verb)).map_err(Fault::new)?;
        let masses = self.masses();
        let in_pounds = masses.masses_perhaps_in_pounds(model);
        let question = first_unexplained(in_pounds, &masses, model, &self.options.selection);
        let is_meant = self.answers.confirms(YesQuestion::MassInPounds);
        plan.remarks.extend(question.filter(|_| !is_meant).map(|question| question.doubt()));
        match plan.implausible_radius(model) {
            Some(fault) if !self.answers.confirms(YesQuestion::ImplausibleRadius) => Err(fault),
            _ => Ok(plan),
        }
    }

    /// The masses of model and contacts that the caller gave with this request.
    fn masses(&self) -> MassRequest {
        MassRequest { target_mass_kg: self.target_mass_kg, ..self.options.masses.clone() }
    }

    /// Removes advice from `message` that names options which this verb does not have.
    pub fn keep_ways_out(&self, message: &mut Phrase) {
        message.choose_alternatives(&|input| verb_takes(self.verb, input));
    }

    /// All files that are read in addition to the models.
    pub fn extra_files(&self) -> impl Iterator<Item = &PathBuf> {
        self.set_files.paths().chain(&self.extra_files)
    }

    /// A text with everything on which the results depend, except the bytes of the models and of the [`extra_files`](Self::extra_files).
    /// Equal texts mean equal results. A resumed run compares this text with that of the earlier run.
    pub fn settings(&self) -> String {
        // A note names files without their folders.
        let names: Vec<(Value, String)> =
            self.extra_files().map(|read| (path::to_value(read), file_name(read))).collect();
        let shorten = |value: &mut Value| {
            if let Some((_, name)) = names.iter().find(|(read, _)| read == value) {
                *value = name.as_str().into();
            }
        };
        let mut settings = self.settings.clone();
        for value in settings.values_mut() {
            match value {
                Value::Array(items) => items.iter_mut().for_each(shorten),
                value => shorten(value),
            }
        }
        json!([settings, self.output.no_note]).to_string()
    }
}

/// A stiffness below this, N/m², is hardly that of a contact.
const LEAST_STIFFNESS: f64 = 1e3;

/// The question about a stiffness that was given, if it is at most a thousandth of the present one: MPa were probably meant, or a factor,
/// which `design` does not take.
fn question_about_stiffness(plan: &Plan, verb: Verb) -> Option<Suspicion> {
    let odd = plan.changes.iter().find(|change| {
        let is_given = change.by == ChangedBy::Given && change.factor.is_none();
        let is_small = change.to < LEAST_STIFFNESS && change.to * 1e3 <= change.from;
        change.property == Property::Stiffness && is_given && is_small
    })?;
    let (to, from, from_mpa) = (readable(odd.to), readable(odd.from), readable(odd.to * 1e6));
    let times = if verb == Verb::Design { String::new() } else { format!("x{to} to multiply it, or ") };
    let text =
        format!("a stiffness would be {to} N/m2, and is {from} now: write {times}{from_mpa} if it is in MPa");
    Some(Suspicion::Other { question: YesQuestion::WrongAfterwards, text: text.into() })
}

/// The question whether a mass that was given for several models is right for this model, whose note has another mass.
fn question_against_note(given: &MassRequest, model: &Model) -> Option<Suspicion> {
    let (said_kg, noted_kg) = given.contacts_mass_kg.zip(given.disagreeing_note_kg(model))?;
    let text = phrase![
        "{} is for all models of this call, and the note in this one says {} kg: do this model in a call of its own, \
        or give each model its mass in a table ({})";
        Input::ContactsMass.with_value(readable(said_kg)), readable(noted_kg), Verb::Batch.call()
    ];
    Some(Suspicion::Other { question: YesQuestion::AgainstNote, text })
}

/// The file's name without its folders, for notes and messages.
pub(crate) fn file_name(path: &Path) -> String {
    path.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned())
}

/// Finds by trial plans what can be changed in a model, so that no remedy proposes a change that would be refused.
pub fn find_changeable_values(options: &InspectOptions, model: &Model) -> ChangeableValues {
    let numbers = numbers_may_change(options, model);
    ChangeableValues { numbers, radii: !numbers || radii_may_change(options, model) }
}

/// Whether a trial plan that changes radii is accepted. It is refused if a force that does not change uses the same sphere.
fn radii_may_change(options: &InspectOptions, model: &Model) -> bool {
    let mut trial = Set::new(vec![(Property::Radius, Assignment::Factor(2.0))]);
    trial.repeat = true;
    let plan = options.selection.apply(model).and_then(|selected| set(model, &selected, &trial));
    !plan.is_err_and(|fault| matches!(fault.kind, FaultKind::MissingFact(MissingFact::SharedSphere { .. })))
}

/// Whether a trial plan that changes dissipation and stiffness is accepted.
fn numbers_may_change(options: &InspectOptions, model: &Model) -> bool {
    let assignments =
        vec![(Property::Dissipation, Assignment::Value(0.0)), (Property::Stiffness, Assignment::Value(1.0))];
    let mut trial = Set::new(assignments);
    trial.repeat = true;
    let plan = options.selection.apply(model).and_then(|selected| set(model, &selected, &trial));
    plan.and_then(|plan| plan.patched(model, FileId::MAIN)).is_ok()
}

/// Checks a model that was inspected, and proposes only remedies that can be applied. `beside` are findings about companion files of the
/// model.
pub fn check_with_trials(
    options: &InspectOptions,
    model: &Model,
    inspected: &Inspection,
    beside: &[Finding],
) -> CheckResult {
    check_model(options, model, inspected, beside, find_changeable_values(options, model))
}

#[cfg(test)]
mod tests {
    use osim_model::files::InMemory;
    use osim_requests::Request;

    use crate::prepare;

    fn settings(request: &str) -> String {
        let foot = include_bytes!("../../osim-model/tests/data/one_foot.osim").as_slice();
        let files = InMemory::from_iter(
            ["here/foot.osim", "there/foot.osim", "there/leg.osim"].map(|name| (name, foot)),
        );
        prepare(Request::from_json(request.as_bytes()).unwrap(), &files).unwrap().settings()
    }

    #[test]
    fn settings_differ_only_if_results_differ() {
        let rescale = |more: &str| {
            settings(&format!(r#"{{"verb": "rescale", "models": "a.osim", "target_mass": 80{more}}}"#))
        };
        for same in [r#", "output": "b.osim""#, r#", "diff": true"#, r#", "yes": ["mass-in-pounds"]"#] {
            assert_eq!(rescale(same), rescale(""), "{same}");
        }
        for other in [r#", "radius": "x2""#, r#", "select": "a""#, r#", "mass": 70"#, r#", "no_note": true"#]
        {
            assert_ne!(rescale(other), rescale(""), "{other}");
        }
    }

    #[test]
    fn settings_have_the_names_of_files_that_are_read_without_their_folders() {
        let transfer = |from: &str| {
            settings(&format!(
                r#"{{"verb": "transfer", "models": "a.osim", "from": "{from}", "reference_mass": 70}}"#
            ))
        };
        assert_eq!(transfer("here/foot.osim"), transfer("there/foot.osim"));
        assert_ne!(transfer("there/foot.osim"), transfer("there/leg.osim"));
    }
}
