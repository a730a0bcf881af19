//! The steps of a ladder, which lead from soft to stiff contacts (section 4.3 of the paper).

use contact_scaling::{continuation, stiffness};
use osim_model::files::{Failure, ModelFiles};
use osim_model::messages::{Input, four_significant, phrase, shortest};
use osim_model::{Assignment, Property};
use osim_requests::{RequestFault, SweepRequest};

use super::grid::zero_padded;
use super::variant::{StepChanges, Variant, prepare_design, prepare_set};

/// The steps from a soft contact to the wanted contact.
pub(super) struct SweepLadder {
    steps: Vec<continuation::Step>,
    /// The dissipation α of the softest step, s/m, if the last step has no dissipation.
    dissipation_if_none: Option<f64>,
    /// The largest √cf/R of the designed contact; 0 without smoothing, or if the caller wants this one.
    constant_indentation: f64,
}

/// The largest √cf/R of a step over its x̂. A sphere that just touches then carries 0.082 of its load: half of this to the power of 3/2.
const MOST_CONSTANT_INDENTATION: f64 = 0.3;

impl SweepLadder {
    /// Computes the steps from the contacts of the model and the wanted design.
    ///
    /// # Errors
    /// The last step cannot be designed, or is softer than the first.
    pub(super) fn new(request: &SweepRequest, model: &ModelFiles, count: u32) -> Result<Self, RequestFault> {
        let Some(indentation) = request.wanted.indentation else {
            let needed = Input::Indentation.with_placeholder("X");
            let message = phrase!["{} needs {} for its last step"; Input::Ladder, needed];
            return Err(RequestFault::refused(Input::Ladder, message));
        };
        let last = stiffness::dimensionless_hertz(indentation.get())
            .map_err(|error| RequestFault::general(error.to_string()))?;
        let end = vec![prepare_design(request, None, None)?];
        let fault = |failure: Failure| {
            RequestFault::general(phrase![failure.model.to_string(), ": ", &failure.message])
        };
        let designed = Variant::of_stages(request, model, &end, "ladder", None).map_err(fault)?;
        let first_s_m = largest_dissipation(&Variant::unchanged(request, model).map_err(fault)?);
        let last_s_m = largest_dissipation(&designed);
        let ratio = if first_s_m > last_s_m && last_s_m > 0.0 { first_s_m / last_s_m } else { 1.0 };
        let soft = request.soft.get();
        let steps = continuation::steps(soft, last, ratio, count).map_err(|error| {
            let last = four_significant(last);
            let text = format!(" {}: {error}; the last step has {last}", shortest(soft));
            let message = phrase![Input::Soft, text];
            RequestFault::refused(Input::Soft, message)
        })?;
        let dissipation_if_none = (last_s_m == 0.0 && first_s_m > 0.0).then_some(first_s_m);
        let is_kept = request.wanted.constant_indentation.is_some();
        let constant_indentation = if is_kept { 0.0 } else { designed.largest_constant_indentation() };
        Ok(Self { steps, dissipation_if_none, constant_indentation })
    }

    pub(super) fn len(&self) -> usize {
        self.steps.len()
    }

    /// The number of the step with this index in the name of a file, counted from 1.
    pub(super) fn file_part(&self, index: usize) -> String {
        let count = self.steps.len();
        format!("ladder-{}-of-{count}", zero_padded(index + 1, count))
    }

    /// The dimensionless stiffness k̂ of the step with this index, at the load of the design.
    pub(super) fn dimensionless_stiffness(&self, index: usize) -> Option<f64> {
        self.steps.get(index).map(|step| step.dimensionless_stiffness)
    }

    /// The changes that make the step with this index, counted from 0: the wanted design with a softer contact, and with a constant force
    /// and a smoothing that are small against its x̂.
    ///
    /// # Errors
    /// The last step cannot be designed.
    pub(super) fn stages(&self, request: &SweepRequest, index: usize) -> Result<StepChanges, RequestFault> {
        let mut stages = vec![prepare_design(request, None, None)?];
        let Some(step) = self.steps.get(index) else { return Err(RequestFault::general("no such step")) };
        let mut assignments = Vec::new();
        if index + 1 < self.steps.len() {
            assignments.push((Property::Stiffness, Assignment::Factor(step.modulus_factor)));
            if let Some(dissipation) = self.dissipation_if_none {
                // No ratio leads to 0: α falls by equal amounts.
                let remaining = 1.0 - index as f64 / (self.steps.len() - 1) as f64;
                assignments.push((Property::Dissipation, Assignment::Value(dissipation * remaining)));
            } else if step.dissipation_factor != 1.0 {
                assignments.push((Property::Dissipation, Assignment::Factor(step.dissipation_factor)));
            }
        }
        // x̂ is 3/(2 k̂) (B.3).
        let most = MOST_CONSTANT_INDENTATION * 1.5 / step.dimensionless_stiffness;
        if self.constant_indentation > most {
            let factor = most / self.constant_indentation;
            assignments.push((Property::ConstantContactForce, Assignment::Factor(factor * factor)));
            if request.wanted.state_width.is_none() {
                assignments.push((Property::HertzSmoothing, Assignment::Factor(1.0 / factor)));
            }
        }
        if !assignments.is_empty() {
            stages.push(prepare_set(request, assignments)?);
        }
        Ok(stages)
    }
}

/// The largest dissipation α of the selected forces of a variant, s/m.
fn largest_dissipation(variant: &Variant) -> f64 {
    variant.values_of(Property::Dissipation).fold(0.0, f64::max)
}
