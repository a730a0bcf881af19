//! Requests for many models: from the rows of a table, and as variants of one model.

use std::path::PathBuf;

use osim_model::messages::{Input, Phrase, phrase};
use osim_model::{Property, YesQuestion};

use crate::fault::RequestFault;
use crate::options::{
    AnswerOptions, CountOptions, ForceOptions, Format, LoadOptions, MassOptions, OutputOptions, RunOptions,
    WantedOptions,
};
use crate::values::serial::{self, fields};
use crate::values::{Axis, AxisName, Jobs, Positive, Shard, Steps, grid, path, shard};

fields! {
    /// One row per model; columns are named like the long options of rescale, transfer, design and set.
    struct BatchRequest {
        manifest: Option<PathBuf> as "path::Optional",
        output: ..OutputOptions,
        allow_outside: bool,
        run: ..RunOptions,
        answers: ..AnswerOptions,
    } where Required("manifest");

    /// One file per point of a grid, or per step of a ladder, and a table that says what is in which.
    struct SweepRequest {
        model: Option<PathBuf> as "path::Optional",
        #[serde(deserialize_with = "grid::deserialize", serialize_with = "serial::Texts::serialize")]
        #[cfg_attr(feature = "schemas", schemars(schema_with = "grid::axes_schema"))]
        grid: Vec<Axis>,
        ladder: Option<Steps>,
        soft: Positive = Positive::SOFT_STIFFNESS,
        #[serde(deserialize_with = "shard::point_of_json")]
        point: Option<usize>,
        shard: Option<Shard>,
        output_dir: Option<PathBuf> as "path::Optional",
        force: bool,
        resume: bool,
        no_note: bool,
        dry_run: bool,
        format: Format,
        quiet: bool,
        jobs: Option<Jobs>,
        wanted: ..WantedOptions,
        load: ..LoadOptions,
        masses: ..MassOptions,
        counts: ..CountOptions,
        choice: ..ForceOptions,
        answers: ..AnswerOptions,
    } where
        Required("model"), RequiredUnless("grid", "ladder"), Excludes("ladder", "grid"),
        Needs("ladder", "indentation"), Needs("soft", "ladder"), Excludes("point", "shard"),
        Excludes("resume", "dry_run");
}

// How many models a sweep makes, and whether its axes go together: what can be known without the model.

/// The number of variants above which the caller has to confirm a sweep.
const MANY_VARIANTS: usize = 10_000;
/// The largest number of variants of a sweep.
const MOST_VARIANTS: usize = 1_000_000;

impl SweepRequest {
    /// Checks the conditions that do not depend on the model.
    ///
    /// # Errors
    /// Axes that contradict each other, or so many models that the caller has to confirm them.
    pub fn check(&self) -> Result<(), RequestFault> {
        self.check_axes()?;
        let count = self.count()?;
        if count > MOST_VARIANTS && self.point.is_none() && !self.dry_run {
            let message = format!(
                "{count} models are more than 1,000,000, the most that one sweep makes: give fewer values"
            );
            return Err(RequestFault::general(message));
        }
        // One point is one model. A share asks, too: all shares together, and the call that ends them, make as many.
        if self.is_large()
            && self.point.is_none()
            && !self.answers.confirms(YesQuestion::ManyModels)
            && !self.dry_run
        {
            let message = phrase![
                "{count} models would be made, more than 10,000: confirm it with {}, or give fewer values";
                &YesQuestion::ManyModels.answer_option()
            ];
            return Err(RequestFault::general(message));
        }
        Ok(())
    }

    /// Whether there are so many models that the caller has to confirm them.
    pub fn is_large(&self) -> bool {
        self.count().is_ok_and(|count| count > MANY_VARIANTS)
    }

    /// Checks that no two axes and options set the same quantity.
    ///
    /// # Errors
    /// Two axes or options that set the same quantity.
    pub fn check_axes(&self) -> Result<(), RequestFault> {
        let has = |name: AxisName| self.grid.iter().any(|axis| axis.name == name);
        let refused = |message: Phrase| Err(RequestFault::refused(Input::Grid, message));
        for (index, axis) in self.grid.iter().enumerate() {
            if self.grid.iter().take(index).any(|other| other.name == axis.name) {
                return refused(phrase![
                    Input::Grid,
                    format!(" {}: given twice, expected one list of values", axis.name.as_str()),
                ]);
            }
        }
        let wanted = &self.wanted;
        for (quantity, input, given, property) in [
            (AxisName::Indentation, Input::Indentation, wanted.indentation.is_some(), Property::Stiffness),
            (AxisName::Restitution, Input::Restitution, wanted.restitution.is_some(), Property::Dissipation),
        ] {
            if has(quantity) && given {
                return refused(phrase![
                    "{} and {} {} both say what it is: leave one out";
                    input, Input::Grid, quantity.as_str().to_string()
                ]);
            }
            if (has(quantity) || given) && has(AxisName::Property(property)) {
                let name = quantity.as_str();
                let message = format!("{name} and {property} both say what {property} is: leave one out");
                return refused(message.into());
            }
        }
        Ok(())
    }

    /// The number of models that the sweep makes.
    ///
    /// # Errors
    /// A number too large to count.
    pub fn count(&self) -> Result<usize, RequestFault> {
        let in_grid =
            || self.grid.iter().try_fold(1_usize, |count, axis| count.checked_mul(axis.values.len()));
        let made = self.ladder.map_or_else(in_grid, |steps| usize::try_from(steps.get()).ok());
        made.ok_or_else(|| RequestFault::general("more models than can be counted: give fewer values"))
    }
}
