//! What a note says of the changes that made the contacts what they are.

use osim_model::messages::readable;
use osim_model::{Model, NoteDoubt, Source, Step};

/// More steps than this help nobody: of a longer story the first and the latest are kept.
const MOST_STEPS: usize = 8;
/// Who changed values without leaving a note.
pub(crate) const OTHERS: &str = "others";

/// What only the caller knows of a change, for its step in the note.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct StepDetails {
    /// Options that mattered, as `name=value`.
    pub options: String,
    /// What the contacts were taken from.
    pub reference: Option<Source>,
    /// Limbs that share the body weight, where the caller said so.
    pub stance_limbs: Option<f64>,
    /// The date, as `2026-11-25`, where it is known.
    pub date: Option<String>,
}

/// The steps of the note that is in `model`, and `step`; `is_new` where its contacts are, and what was done before is about others.
pub(crate) fn continued(model: &Model, step: Step, is_new: bool) -> Vec<Step> {
    after(if is_new { Vec::new() } else { earlier(model) }, step)
}

/// The steps of the note that is in `model`, and that somebody changed values since, where that is so.
pub(crate) fn earlier(model: &Model) -> Vec<Step> {
    let Some(note) = &model.note else { return Vec::new() };
    match model.doubt_about_note() {
        // What does not change the values leaves them in doubt, and that they were changed is said once.
        Some(NoteDoubt::ValuesChanged) if note.steps.iter().all(|step| step.operation != OTHERS) => {
            after(note.steps.clone(), Step::new(OTHERS))
        }
        _ => note.steps.clone(),
    }
}

/// `steps` and `step`; one that says the same as the one before is that one.
pub(crate) fn after(mut steps: Vec<Step>, step: Step) -> Vec<Step> {
    if steps.last() != Some(&step) {
        steps.push(step);
    }
    if steps.len() > MOST_STEPS {
        steps.drain(1..=steps.len() - MOST_STEPS);
    }
    steps
}

/// `2 stance limbs`.
pub(crate) fn limbs(stance_limbs: f64) -> String {
    format!("{} stance limb{}", readable(stance_limbs), if stance_limbs == 1.0 { "" } else { "s" })
}
