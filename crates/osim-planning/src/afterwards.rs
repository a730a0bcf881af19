//! The model as a change leaves it: how it is inspected, and what is worse in it than before.

use osim_inspect::{Changeable, Found, InspectOptions, Kin, check_model, check_numbers};
use osim_model::files::{Failure, OpenModel};
use osim_model::messages::{Phrase, phrase};
use osim_model::{Fault, Finding, FindingCode, Model, NeedsAnswer, Question, Severity, same_mass};
use osim_patch::Plan;
use osim_requests::options::AnswerOptions;

use crate::moved_bottoms::moved_bottoms;

/// No remedy is asked for: what can be changed does not matter.
const NO_REMEDIES: Changeable = Changeable { numbers: false, radii: false };

/// The model that a plan makes.
#[derive(Debug)]
pub(crate) enum Changed {
    /// Nothing but numbers of contacts is other: most of it is what it was, and nobody has read a file.
    InNumbers(Model),
    /// It was read from its new bytes.
    Read(Model),
}

impl Changed {
    /// That of `plan`, which was made for `opened`, without its bytes if that can be.
    ///
    /// # Errors
    /// Those of [`Plan::changed`].
    pub(crate) fn of(plan: &Plan, opened: &OpenModel) -> Result<Self, Failure> {
        plan.renumbered(&opened.model)
            .map_or_else(|| Self::read(plan, opened), |model| Ok(Self::InNumbers(model)))
    }

    /// The same from its bytes.
    ///
    /// # Errors
    /// Those of [`Plan::changed`].
    pub(crate) fn read(plan: &Plan, opened: &OpenModel) -> Result<Self, Failure> {
        plan.changed(&opened.model).map(Self::Read).map_err(|fault| opened.failure(fault))
    }

    pub(crate) fn into_model(self) -> Model {
        let (Self::InNumbers(model) | Self::Read(model)) = self;
        model
    }

    fn model(&self) -> &Model {
        let (Self::InNumbers(model) | Self::Read(model)) = self;
        model
    }

    /// What is found in `model`, which is this one or the one that was changed, as far as the change decides it, without remedies.
    fn unmended(&self, options: &InspectOptions, opened: &OpenModel, model: &Model) -> Vec<Found> {
        match self {
            Self::InNumbers(_) => {
                let inspected = options.inspect_for_rules(opened.name(), model);
                check_numbers(options, model, &inspected)
            }
            Self::Read(_) => unmended(options, opened, model),
        }
    }
}

/// What a change aims at, apart from its numbers.
#[derive(Debug, Clone, Copy)]
#[non_exhaustive]
pub struct Aims {
    /// The contacts are to carry the mass that they are scaled to, whatever the bodies weigh.
    pub carries_target: bool,
    /// Gravity that the contacts are scaled to, m/s².
    pub gravity_m_s2: Option<f64>,
    /// The caller gave the numbers themselves, and not what they follow from: a model that is wrong with them is not refused.
    pub as_given: bool,
}

/// How the new model is inspected: its contacts carry the body that they were scaled for.
pub(crate) fn options_after(
    aims: Aims,
    before: &InspectOptions,
    plan: &Plan,
    weighs_kg: Option<f64>,
) -> InspectOptions {
    let mut options = before.clone();
    let target_mass_kg = plan.masses.as_ref().map(|masses| masses.target_mass_kg);
    // The note has it; without one the caller has to give it.
    options.masses.contacts_mass_kg = target_mass_kg.filter(|_| plan.note().is_none());
    if let Some(target_mass_kg) = target_mass_kg.filter(|_| aims.carries_target)
        && weighs_kg.is_none_or(|weighs| !same_mass(weighs, target_mass_kg))
    {
        options.masses.model_kg = Some(target_mass_kg);
    }
    // A gravity that figures are asked for (as in a design) is that of both states.
    options.stance.gravity_m_s2 = aims.gravity_m_s2.or(options.stance.gravity_m_s2);
    options
}

/// How the old model is inspected, to be compared with the new one: its contacts carry the body that they were made for, where the new
/// ones carry theirs.
fn options_before(aims: Aims, before: &InspectOptions, plan: &Plan) -> InspectOptions {
    let mut options = before.clone();
    if let Some(masses) = plan.masses.as_ref().filter(|_| aims.carries_target) {
        options.masses.model_kg = Some(masses.contacts_mass.kg);
    }
    options
}

/// Whether the contacts are for a body that the bodies of the model still have to become: contacts are often scaled before the body is.
/// What its default pose is then nobody knows yet, so that every isometric rescaling to another mass would warn of the pose that is.
fn is_to_be_scaled(aims: Aims, plan: &Plan, weighs_kg: Option<f64>) -> bool {
    let target_mass_kg = plan.masses.as_ref().map(|masses| masses.target_mass_kg);
    let is_other = |target| weighs_kg.is_none_or(|weighs| !same_mass(weighs, target));
    aims.carries_target && target_mass_kg.is_some_and(is_other)
}

/// Warnings and errors of the model as `changed` by `plan` that the model without it does not have, or has as less bad; and what the
/// plan does to bottoms that stood.
///
/// # Errors
/// An error among them, unless the caller means it.
pub(crate) fn worse_findings(
    aims: Aims,
    before: &InspectOptions,
    opened: &OpenModel,
    (plan, changed): (&Plan, &Changed),
    answers: Option<&AnswerOptions>,
) -> Result<Vec<Finding>, Failure> {
    let failure = |fault| opened.failure(fault);
    let weighs = before.masses.of_model(&opened.model).ok();
    let weighs = weighs.or_else(|| Some(before.masses.of_contacts(&opened.model).ok()?.0));
    let weighs_kg = weighs.map(|mass| mass.kg);
    let after = options_after(aims, before, plan, weighs_kg);
    // The model was so before, and nobody has to be asked whether that was meant.
    let is_as_before = plan.takes_back();
    let is_meant = aims.as_given
        || is_as_before
        || answers.is_some_and(|answers| answers.has(Question::WrongAfterwards));
    let worse = worse_than(&options_before(aims, before, plan), &after, opened, plan, changed);
    let mut said: Vec<Finding> = match worse.iter().find(|one| one.severity == Severity::Error) {
        Some(wrong) if !is_meant => return Err(failure(Fault::new(asks(wrong)))),
        _ => worse.iter().map(of_new_model).collect(),
    };
    if !is_to_be_scaled(aims, plan, weighs_kg) {
        said.extend(moved_bottoms(plan, &opened.model, changed.model(), &said));
    }
    Ok(said)
}

/// What is wrong with the model `changed` by `plan`, and was not, or less.
fn worse_than(
    before: &InspectOptions,
    after: &InspectOptions,
    opened: &OpenModel,
    plan: &Plan,
    changed: &Changed,
) -> Vec<Found> {
    let found = changed.unmended(after, opened, changed.model());
    let is_bad = |one: &&Found| one.severity >= Severity::Warn && !is_due(one) && !is_known(plan, one);
    let bad: Vec<&Found> = found.iter().filter(is_bad).collect();
    if bad.is_empty() {
        return Vec::new();
    }
    let old = changed.unmended(before, opened, &opened.model);
    let kin = Kin::of(&old);
    // Contacts that are no longer those of a published model are not worse for it.
    let is_worse = |one: &&Found| {
        let was = kin.nearest(one);
        was.is_none_or(|was| was.code() != one.code() && was.rule.severity < one.rule.severity)
    };
    bad.into_iter().filter(is_worse).cloned().collect()
}

/// Whether it only says that the bodies are not scaled yet: contacts are often scaled before them.
pub(crate) fn is_due(one: &Found) -> bool {
    one.code() == FindingCode::MassSourcesDisagree
}

/// What is found in `model`, without remedies.
pub(crate) fn unmended(options: &InspectOptions, opened: &OpenModel, model: &Model) -> Vec<Found> {
    let inspected = options.inspect_for_rules(opened.name(), model);
    check_model(options, model, &inspected, &[], NO_REMEDIES).findings
}

/// Whether the verb says it itself, with a way out of its own: then it is neither repeated nor refused, such as what the smoothing of
/// `convert` does on stiff spheres.
fn is_known(plan: &Plan, one: &Found) -> bool {
    plan.warnings.iter().any(|known| known.code() == one.code() && known.place == one.place)
}

/// Lines are those of a file that nobody has yet: they are left out.
fn of_new_model(found: &Found) -> Finding {
    let message = phrase!["in the new model: ", &found.message];
    found.finding.clone().with_message(message).on_line(None)
}

fn asks(wrong: &Found) -> NeedsAnswer {
    let text: Phrase = phrase![
        "the model would be wrong afterwards [",
        wrong.code().as_str(),
        "]: ",
        &wrong.message,
        ". ",
        &wrong.advice
    ];
    NeedsAnswer::Other { question: Question::WrongAfterwards, text }
}
