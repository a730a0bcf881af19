//! Remedies that hold: each is tried, and the next is taken from a check of the result.

mod chain;
mod merged;
mod naming;

pub(crate) use chain::Trials;

use osim_inspect::{CheckResult, InspectOptions, Inspection};
use osim_model::files::{FileName, InMemory};
use osim_model::{Finding, Model};

use crate::trial::check_with_trials;

/// Checks a model that was inspected, with remedies that were tried, for a model by itself: they name no other files. `beside` is
/// what was found in files beside it.
#[must_use]
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
