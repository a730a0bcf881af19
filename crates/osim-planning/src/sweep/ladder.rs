//! From a soft contact to the wanted one, in steps (section 4.3 of the paper).

use contact_scaling::{continuation, stiffness};
use osim_model::files::{Failure, ModelFiles};
use osim_model::messages::{Input, Phrase, phrase, shortest};
use osim_model::{Assignment, Property};
use osim_requests::{RequestFault, SweepRequest};

use super::part::padded;
use super::stages::{Stages, design, set};
use super::variant::Variant;

/// What a ladder needs to know before its first step.
pub(super) struct Ladder {
    steps: Vec<continuation::Step>,
    /// α of the softest step where the last has none, s/m.
    dissipation_if_none: Option<f64>,
}

impl Ladder {
    /// Finds where the model begins and where the last step ends.
    ///
    /// # Errors
    /// The last step cannot be designed, or is softer than the first.
    pub(super) fn of(request: &SweepRequest, model: &ModelFiles, count: u32) -> Result<Self, RequestFault> {
        let Some(indentation) = request.wanted.indentation else {
            let message =
                phrase![Input::Ladder, " needs ", Input::Indentation.like("X"), " for its last step"];
            return Err(RequestFault::refused(Input::Ladder, message));
        };
        let last = stiffness::dimensionless_hertz(indentation.get())
            .map_err(|error| RequestFault::general(error.to_string()))?;
        let end = vec![design(request, None, None)?];
        let now = dissipation(&Variant::unchanged(request, model).map_err(|failure| of_model(&failure))?);
        let then = dissipation(
            &Variant::of(request, model, &end, "ladder", None).map_err(|failure| of_model(&failure))?,
        );
        let falls = now > then && then > 0.0;
        let ratio = if falls { now / then } else { 1.0 };
        let soft = request.soft.get();
        let steps = continuation::steps(soft, last, ratio, count).map_err(|error| {
            let message = phrase![Input::Soft, format!(" {}: {error}", shortest(soft))];
            RequestFault::refused(Input::Soft, message)
        })?;
        Ok(Self { steps, dissipation_if_none: (then == 0.0 && now > 0.0).then_some(now) })
    }

    pub(super) fn len(&self) -> usize {
        self.steps.len()
    }

    /// Step `index` in a file's name, from 1.
    pub(super) fn file_part(&self, index: usize) -> String {
        let count = self.steps.len();
        format!("ladder-{}-of-{count}", padded(index + 1, count))
    }

    /// k̂ of step `index`, at the load of the design.
    pub(super) fn dimensionless_stiffness(&self, index: usize) -> Option<f64> {
        self.steps.get(index).map(|step| step.dimensionless_stiffness)
    }

    /// What leads to step `index`, from 0: the last step, made softer.
    ///
    /// # Errors
    /// The last step cannot be designed.
    pub(super) fn stages(&self, request: &SweepRequest, index: usize) -> Result<Stages, RequestFault> {
        let mut stages = vec![design(request, None, None)?];
        let Some(step) = self.steps.get(index) else { return Err(RequestFault::general("no such step")) };
        if index + 1 < self.steps.len() {
            let mut assignments = vec![(Property::Stiffness, Assignment::Factor(step.modulus_factor))];
            if let Some(dissipation) = self.dissipation_if_none {
                // No ratio leads to 0: α falls by equal amounts.
                #[expect(clippy::cast_precision_loss, reason = "ladders have few steps")]
                let remaining = 1.0 - index as f64 / (self.steps.len() - 1) as f64;
                assignments.push((Property::Dissipation, Assignment::Value(dissipation * remaining)));
            } else if step.dissipation_factor != 1.0 {
                assignments.push((Property::Dissipation, Assignment::Factor(step.dissipation_factor)));
            }
            stages.push(set(request, assignments)?);
        }
        Ok(stages)
    }
}

/// The largest α of the selected forces, s/m.
fn dissipation(variant: &Variant) -> f64 {
    variant.all(Property::Dissipation).fold(0.0, f64::max)
}

fn of_model(failure: &Failure) -> RequestFault {
    let mut message = Phrase::from(format!("{}: ", failure.model));
    message.push(&failure.message);
    RequestFault::general(message)
}
