//! Plans that ask before they do what looks like a slip, and what is refused because it does nothing or was done already.

use std::path::PathBuf;

use osim_inspect::{ReferenceState, perhaps_in_pounds, unexplained_slip};
use osim_model::files::{Failure, Files, OpenModel};
use osim_model::messages::{Input, phrase, shortest};
use osim_model::{Fault, MassRequest, Model, Needed, Question, RadiusRule};
use osim_patch::Plan;
use osim_requests::RequestFault;
use osim_requests::options::{AnswerOptions, InspectionOptions, OutputOptions};

use crate::motion::MotionResult;
use crate::motion_remarks::MotionRemark;
use crate::planner::Planner;

/// A planner that asks if a mass that the caller gave, or a radius that it would write, looks like a slip.
pub(crate) struct Asking<P> {
    pub(crate) planner: P,
    /// The masses that the caller gave for the model.
    pub(crate) masses: MassRequest,
    pub(crate) answers: AnswerOptions,
}

impl<P: Planner> Asking<P> {
    fn ask_about_masses(&self, model: &Model) -> Result<(), Fault> {
        let selection = self.planner.inspection().choice.selection();
        let slip = unexplained_slip(&self.masses, model, &selection);
        self.answers.ask(slip).map_err(Fault::new)
    }

    /// Asks about radii, and says what is odd and no reason to ask.
    fn looked_at(&self, model: &Model, mut plan: Plan) -> Result<Plan, Fault> {
        let selection = self.planner.inspection().choice.selection();
        let odd = perhaps_in_pounds(&self.masses, model, &selection);
        let is_meant = self.answers.has(Question::MassInPounds);
        plan.remarks.extend(odd.filter(|_| !is_meant).map(|odd| odd.doubt()));
        match plan.radius_slip(model) {
            Some(fault) if !self.answers.has(Question::ImplausibleRadius) => Err(fault),
            _ => Ok(plan),
        }
    }
}

impl<P: Planner> Planner for Asking<P> {
    fn plan(&self, model: &Model) -> Result<Plan, Fault> {
        self.ask_about_masses(model)?;
        let plan = self.planner.plan(model)?;
        self.looked_at(model, plan)
    }

    fn plan_beside(&self, opened: &OpenModel, files: &dyn Files) -> Result<Plan, Failure> {
        let model = &opened.model;
        let failure = |fault| opened.failure(fault);
        self.ask_about_masses(model).map_err(failure)?;
        let plan = self.planner.plan_beside(opened, files)?;
        self.looked_at(model, plan).map_err(failure)
    }

    fn reads(&self) -> Vec<PathBuf> {
        self.planner.reads()
    }

    fn name(&self) -> &'static str {
        self.planner.name()
    }

    fn inspection(&self) -> InspectionOptions {
        self.planner.inspection()
    }

    fn target_gravity_m_s2(&self) -> Option<f64> {
        self.planner.target_gravity_m_s2()
    }

    fn reference(&self) -> Option<&ReferenceState> {
        self.planner.reference()
    }

    fn answers(&self) -> Option<&AnswerOptions> {
        Some(&self.answers)
    }

    fn recording(&self, changed: OpenModel) -> Option<(MotionResult, Vec<MotionRemark>)> {
        self.planner.recording(changed)
    }

    fn settings(&self) -> String {
        self.planner.settings()
    }
}

/// A factor that the note says was applied already is not applied once more in place, unless that is wanted.
///
/// # Errors
/// The question whether it is.
pub(super) fn refuse_again(model: &Model, operation: &str, may_repeat: bool) -> Result<(), Fault> {
    let done = model.note.as_ref().is_some_and(|note| note.operation() == operation);
    if !done || may_repeat {
        return Ok(());
    }
    Err(Fault::new(Needed::Repetition { operation: operation.to_owned() }))
}

/// The verb, and the factor of the radius where one is given.
pub(super) fn operation(verb: &str, radius: Option<RadiusRule>) -> String {
    match radius {
        Some(RadiusRule::Factor(factor)) => format!("{verb} radius=x{}", shortest(factor)),
        _ => verb.to_owned(),
    }
}

/// Verbs that change whole objects do so in models: no geometry set is written beside them.
///
/// # Errors
/// A file for one is named.
pub(super) fn refuse_geometry_output(output: &OutputOptions) -> Result<(), RequestFault> {
    if output.geometry_output.is_none() {
        return Ok(());
    }
    let why = phrase![
        Input::GeometryOutput,
        " is for force sets that stand alone: whole objects are changed in whole models, whose geometry is in the same file"
    ];
    Err(RequestFault::refused(Input::GeometryOutput, why))
}
