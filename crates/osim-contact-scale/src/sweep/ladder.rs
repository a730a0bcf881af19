//! `--ladder N`: from a soft contact to the wanted one, in steps (section 4.3 of the paper).

use anyhow::{Context, Result, anyhow, bail};
use contact_scaling::{continuation, stiffness};
use osim_patch::{Property, shortest};

use super::stages::{Stages, design, set};
use super::variant::Variant;
use crate::args::SweepArgs;
use crate::failure::Failure;
use crate::load::Loaded;

/// What a ladder needs to know before its first step.
pub(super) struct Ladder {
    steps: Vec<continuation::Step>,
    /// α of the softest step where the last has none, s/m.
    dissipation_if_none: Option<f64>,
}

impl Ladder {
    /// Looks where the model stands and where the last step ends.
    ///
    /// # Errors
    /// The last step cannot be designed, or is softer than the first.
    pub(super) fn of(args: &SweepArgs, loaded: &Loaded, count: u32) -> Result<Self> {
        let indentation =
            args.wanted.indentation.context("--ladder needs --indentation X for its last step")?;
        let last = stiffness::dimensionless_hertz(indentation)?;
        let end = vec![design(args, None, None)?];
        let now = dissipation(&Variant::unchanged(args, loaded).map_err(|failure| failed(&failure))?);
        let then = dissipation(
            &Variant::of(args, loaded, &end, "ladder", None).map_err(|failure| failed(&failure))?,
        );
        let falls = now > then && then > 0.0;
        let ratio = if falls { now / then } else { 1.0 };
        if count < 2 {
            bail!("--ladder {count}: expected 2 steps or more");
        }
        let steps = continuation::steps(args.soft, last, ratio, count)
            .with_context(|| format!("--soft {}", shortest(args.soft)))?;
        Ok(Self { steps, dissipation_if_none: (then == 0.0 && now > 0.0).then_some(now) })
    }

    pub(super) fn len(&self) -> usize {
        self.steps.len()
    }

    /// Step `index` in a file's name, from 1.
    pub(super) fn file_part(&self, index: usize) -> String {
        let count = self.steps.len().to_string();
        format!("ladder-{:0width$}-of-{count}", index + 1, width = count.len())
    }

    /// k̂ of step `index`, at the load of the design.
    pub(super) fn dimensionless_stiffness(&self, index: usize) -> Option<f64> {
        self.steps.get(index).map(|step| step.dimensionless_stiffness)
    }

    /// What leads to step `index`, from 0: the last step, made softer.
    ///
    /// # Errors
    /// The last step cannot be designed.
    pub(super) fn stages(&self, args: &SweepArgs, index: usize) -> Result<Stages> {
        let mut stages = vec![design(args, None, None)?];
        let step = self.steps.get(index).context("no such step")?;
        if index + 1 < self.steps.len() {
            let mut assignments = vec![format!("stiffness=x{}", shortest(step.modulus_factor))];
            if let Some(dissipation) = self.dissipation_if_none {
                // No ratio leads to 0: α falls by equal amounts.
                #[expect(clippy::cast_precision_loss, reason = "ladders have few steps")]
                let remaining = 1.0 - index as f64 / (self.steps.len() - 1) as f64;
                assignments.push(format!("dissipation={}", shortest(dissipation * remaining)));
            } else if step.dissipation_factor != 1.0 {
                assignments.push(format!("dissipation=x{}", shortest(step.dissipation_factor)));
            }
            stages.push(set(args, &assignments)?);
        }
        Ok(stages)
    }
}

/// The largest α of the forces that are meant, s/m.
fn dissipation(variant: &Variant) -> f64 {
    variant.all(Property::Dissipation).fold(0.0, f64::max)
}

fn failed(failure: &Failure) -> anyhow::Error {
    anyhow!("{}: {}", failure.model, failure.message)
}
