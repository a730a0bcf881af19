//! Any request that changes models, for one or for several.

use std::path::PathBuf;
use std::sync::Arc;

use osim_inspect::ReferenceState;
use osim_model::files::{Failure, Files, OpenModel};
use osim_model::messages::{Input, Verb, phrase, readable};
use osim_model::{Fault, Model, NeedsAnswer, Question};
use osim_patch::Plan;
use osim_requests::options::{AnswerOptions, InspectionOptions};
use osim_requests::{Request, RequestError, RequestFault};

use super::adding::prepare;
use super::{convert, design, fitting, note, remove, rescale, set, transfer};
use crate::motion::MotionResult;
use crate::motion_remarks::MotionRemark;
use crate::planner::{Change, Planner};

/// Verbs that change models.
pub(crate) const CHANGING: [Verb; 9] = [
    Verb::Rescale,
    Verb::Transfer,
    Verb::Add,
    Verb::Remove,
    Verb::Convert,
    Verb::Design,
    Verb::Set,
    Verb::Fit,
    Verb::Note,
];

/// The same in words: `rescale, transfer, design, set, fit or note`.
pub(crate) fn changing_verbs() -> String {
    let names = CHANGING.map(Verb::name);
    match names.split_last() {
        Some((last, others)) => format!("{} or {last}", others.join(", ")),
        None => String::new(),
    }
}

/// Checks a request that changes models, for all of them, and reads what it needs beside them. A design without models has none
/// to change: it is [calculated](crate::design_sheet).
///
/// # Errors
/// Options that have no effect, or contradict each other; a file that cannot be read; or a verb that changes nothing.
pub fn prepare(request: impl Into<Request>, files: &dyn Files) -> Result<Change, RequestError> {
    let request = request.into();
    let details = request.noted();
    Ok(Change { details, ..change(request, files)? })
}

fn change(request: Request, files: &dyn Files) -> Result<Change, RequestError> {
    match request {
        Request::Rescale(request) => rescale::prepare(*request, files),
        Request::Design(request) => Ok(design::prepare(*request)?),
        Request::Set(request) => Ok(set::prepare(*request)?),
        Request::Note(request) => Ok(note::prepare(*request)?),
        Request::Add(request) => prepare::prepare(*request, files),
        Request::Convert(request) => Ok(convert::prepare(*request)?),
        Request::Remove(request) => Ok(remove::prepare(*request)?),
        Request::Transfer(request) => transfer::prepare(*request, files),
        Request::Fit(request) if request.is_of_motion() => fitting::prepare(*request, files),
        Request::Fit(_) => Err(RequestFault::Missing { field: "motion" }.into()),
        other => {
            let message = format!("'{}', expected {}", other.verb().name(), changing_verbs());
            Err(RequestFault::general(message).into())
        }
    }
}

// Plans for several models, for which one mass was said.

/// The same change for several models: a mass that was said for all of them is not taken for one whose note says another without asking.
pub fn of_many(change: Change) -> Change {
    Change { planner: Arc::new(OfMany(change.planner)), ..change }
}

/// A planner for several models. Before a mass that was said for all of them is taken for one whose own note says another, it asks.
struct OfMany(Arc<dyn Planner>);

impl OfMany {
    fn ask(&self, model: &Model) -> Result<(), Fault> {
        let masses = self.0.inspection().masses.request();
        let (Some(said), Some(noted)) = (masses.contacts_mass_kg, masses.otherwise_noted_kg(model)) else {
            return Ok(());
        };
        let text = phrase![
            Input::ContactsMass.being(readable(said)),
            format!(
                " is for all models of this call, and the note in this one says {} kg: ",
                readable(noted)
            ),
            "do this model in a call of its own, or give each model its mass in a table (",
            Verb::Batch.call(),
            ")",
        ];
        let asks = NeedsAnswer::Other { question: Question::AgainstNote, text };
        let has_answer = self.0.answers().is_some_and(|answers| answers.has(Question::AgainstNote));
        if has_answer { Ok(()) } else { Err(Fault::new(asks)) }
    }
}

impl Planner for OfMany {
    fn plan(&self, model: &Model) -> Result<Plan, Fault> {
        self.ask(model)?;
        self.0.plan(model)
    }

    fn plan_beside(&self, opened: &OpenModel, files: &dyn Files) -> Result<Plan, Failure> {
        self.ask(&opened.model).map_err(|fault| opened.failure(fault))?;
        self.0.plan_beside(opened, files)
    }

    fn reads(&self) -> Vec<PathBuf> {
        self.0.reads()
    }

    fn name(&self) -> &'static str {
        self.0.name()
    }

    fn inspection(&self) -> InspectionOptions {
        self.0.inspection()
    }

    fn target_gravity_m_s2(&self) -> Option<f64> {
        self.0.target_gravity_m_s2()
    }

    fn reference(&self) -> Option<&ReferenceState> {
        self.0.reference()
    }

    fn answers(&self) -> Option<&AnswerOptions> {
        self.0.answers()
    }

    fn recording(&self, changed: OpenModel) -> Option<(MotionResult, Vec<MotionRemark>)> {
        self.0.recording(changed)
    }

    fn settings(&self) -> String {
        self.0.settings()
    }
}
