//! Variants of one model: the points of a grid, or the steps of a ladder.

mod grid;
mod variant;

use std::borrow::Cow;
use std::iter::StepBy;
use std::ops::Range;
use std::path::Path;

use osim_inspect::{Figure, unexplained_mass_slip};
use osim_model::files::{Failure, ModelFiles};
use osim_model::messages::{Phrase, shortest};
use osim_model::{MassRequest, Property, Question};
use osim_requests::{AxisName, RequestError, RequestFault, SweepRequest};

use grid::{Point, along, ends, padded, point};
use variant::{Ladder, Stages, Variant};

pub struct SweepPlan<'s> {
    request: &'s SweepRequest,
    model: ModelFiles,
    original: Variant,
    ladder: Option<Ladder>,
    count: usize,
}

struct Job {
    /// What was asked, in the columns of the table.
    asked: Vec<String>,
    operation: String,
    /// The mass that the contacts are made for then, if it changes.
    target_mass_kg: Option<f64>,
    stages: Stages,
}

/// A variant that was made, in memory.
pub struct VariantMade {
    /// The model.
    pub bytes: Vec<u8>,
    /// What was done, in words.
    pub operation: String,
    number: usize,
    file: String,
    asked: Vec<String>,
    variant: Variant,
    /// Codes of errors and warnings that the model itself has not.
    worse: Vec<&'static str>,
}

impl VariantMade {
    pub fn row(self, sha256: String) -> Vec<String> {
        row(self.number, self.file, self.asked, &self.variant, (&self.worse, sha256))
    }

    /// A digest that is equal for variants whose contacts have the same numbers, however they were asked for.
    pub fn contact_digest(&self) -> &str {
        &self.variant.digest
    }

    /// Whether something is wrong with it that is not with the model itself.
    pub fn is_worse(&self) -> bool {
        !self.worse.is_empty()
    }
}

impl<'s> SweepPlan<'s> {
    /// A sweep of the model whose files are `model`.
    ///
    /// # Errors
    /// Those of [`SweepRequest::check`], or the model itself cannot be read, a ladder has no last step, or there is no such point.
    pub fn new(request: &'s SweepRequest, model: ModelFiles) -> Result<Self, RequestError> {
        request.check()?;
        let count = request.count()?;
        // What is wrong with the model itself is reported once, not for every variant.
        let original = Variant::unchanged(request, &model)?;
        let ladder = request.ladder.map(|steps| Ladder::of(request, &model, steps.get())).transpose()?;
        grid::check_part(request, count)?;
        Ok(Self { request, model, original, ladder, count })
    }

    /// How many variants, of all points or steps.
    pub fn count(&self) -> usize {
        self.count
    }

    /// Which of them this call makes, counted from 0.
    pub fn indices(&self) -> StepBy<Range<usize>> {
        grid::indices_of_part(self.request, self.count)
    }

    /// The model that they are made from.
    pub fn model(&self) -> &ModelFiles {
        &self.model
    }

    pub fn file_name(&self, index: usize) -> String {
        let part = match &self.ladder {
            Some(ladder) => ladder.file_part(index),
            None => {
                let point = point(&self.request.grid, index);
                format!("{}_{}", padded(index + 1, self.count), point.file_part())
            }
        };
        self.named(&part, "osim")
    }

    /// Name of the table that says what is in which file, of all.
    pub fn table_name(&self) -> String {
        self.named(self.kind(), "csv")
    }

    /// Name of the table of what this call makes, if it is a part of all.
    pub fn part_table_name(&self) -> Option<String> {
        let part = grid::part_name(self.request)?;
        Some(self.named(self.kind(), &format!("{part}.csv")))
    }

    /// Whether the table of some part of this sweep, or of one with other points, has this name.
    pub fn is_part_table_name(&self, name: &str) -> bool {
        let part = name.strip_prefix(&self.named(self.kind(), "")).and_then(|end| end.strip_suffix(".csv"));
        part.is_some_and(grid::is_part_name)
    }

    /// Whether a variant of this model could have this name, in this sweep or in one with other points.
    pub fn is_like_file_name(&self, name: &str) -> bool {
        let own = || name.strip_prefix(&*self.model_name())?.strip_prefix('_')?.strip_suffix(".osim");
        own().is_some_and(|part| match self.ladder {
            Some(_) => part.starts_with("ladder-"),
            None => part.starts_with(|c: char| c.is_ascii_digit()) && part.contains('-'),
        })
    }

    fn kind(&self) -> &'static str {
        if self.ladder.is_some() { "ladder" } else { "sweep" }
    }

    /// `NAME_part.extension`
    fn named(&self, part: &str, extension: &str) -> String {
        format!("{}_{part}.{extension}", self.model_name())
    }

    fn model_name(&self) -> Cow<'_, str> {
        self.request.model.as_deref().and_then(Path::file_stem).unwrap_or_default().to_string_lossy()
    }

    pub fn table_header(&self) -> Vec<String> {
        header(match self.ladder {
            Some(_) => LADDER.map(str::to_owned).to_vec(),
            None => self.request.grid.iter().map(|axis| format!("{GRID}{}", axis.name.as_str())).collect(),
        })
    }

    /// Whether these are the columns of a sweep's table, also of one that asked something else.
    pub fn is_table_header<C: AsRef<str>>(columns: &[C]) -> bool {
        is_header(columns)
    }

    /// What a variant asks for may make no sense: that shows before anything is written.
    ///
    /// # Errors
    /// What is wrong, with the point.
    pub fn check_ends(&self) -> Result<(), RequestError> {
        let points = match self.ladder {
            Some(_) => vec![0, self.count.saturating_sub(1)],
            None => self.asked_masses()?.into_iter().chain(ends(&self.request.grid)).collect(),
        };
        for index in points {
            let job = self.job(index)?;
            self.variant(&job).map_err(|mut failure| {
                failure.message = at(&failure, &job);
                // What is asked has a code, which answers it.
                match failure.code.parse::<Question>() {
                    Ok(_) => RequestError::Failure(failure),
                    Err(_) => RequestFault::general(failure.message).into(),
                }
            })?;
        }
        Ok(())
    }

    /// Points whose mass looks like a slip, which need not be at an end.
    fn asked_masses(&self) -> Result<Vec<usize>, RequestError> {
        let masses = along(&self.request.grid, AxisName::TargetMass);
        if masses.is_empty() {
            return Ok(Vec::new());
        }
        let open = self.model.clone().open().map_err(RequestError::Failure)?;
        let selection = self.request.choice.selection();
        let is_asked = |target_mass_kg: f64| {
            let target_mass_kg = Some(target_mass_kg);
            let said = MassRequest { target_mass_kg, ..self.request.masses.request() };
            unexplained_mass_slip(&said, &open.model, &selection).is_some()
        };
        Ok(masses
            .into_iter()
            .filter(|(_, target_mass_kg)| is_asked(*target_mass_kg))
            .map(|(index, _)| index)
            .collect())
    }

    /// Makes variant `index`.
    ///
    /// # Errors
    /// What is wrong, with the point.
    pub fn make(&self, index: usize) -> Result<VariantMade, Failure> {
        let job = self
            .job(index)
            .map_err(|fault| Failure::outside(self.model.name(), "refused", fault.phrase()))?;
        let mut variant = self.variant(&job).map_err(|failure| {
            let mut placed = failure.clone();
            placed.message = at(&failure, &job);
            placed
        })?;
        let bytes = std::mem::take(&mut variant.bytes);
        Ok(VariantMade {
            bytes,
            operation: job.operation,
            number: index + 1,
            file: self.file_name(index),
            asked: job.asked,
            worse: variant.worse_than(&self.original),
            variant,
        })
    }

    fn variant(&self, job: &Job) -> Result<Variant, Failure> {
        Variant::of(self.request, &self.model, &job.stages, &job.operation, job.target_mass_kg)
    }

    fn job(&self, index: usize) -> Result<Job, RequestFault> {
        match &self.ladder {
            Some(ladder) => self.step(ladder, index),
            None => self.point(&point(&self.request.grid, index)),
        }
    }

    fn point(&self, point: &Point<'_>) -> Result<Job, RequestFault> {
        Ok(Job {
            asked: point.values.iter().map(|(_, value)| value.exact()).collect(),
            operation: format!("sweep {point}"),
            target_mass_kg: point.number(AxisName::TargetMass),
            stages: variant::stages_at(self.request, point)?,
        })
    }

    fn step(&self, ladder: &Ladder, index: usize) -> Result<Job, RequestFault> {
        let (number, count) = (index + 1, ladder.len());
        let stiffness = ladder.dimensionless_stiffness(index).map(shortest).unwrap_or_default();
        Ok(Job {
            asked: vec![stiffness],
            operation: format!("ladder step {number} of {count}"),
            target_mass_kg: None,
            stages: ladder.stages(self.request, index)?,
        })
    }
}

/// A failure with the point that it is about.
fn at(failure: &Failure, job: &Job) -> Phrase {
    let mut message = failure.message.clone();
    message.push(format!(" ({})", job.operation));
    message
}

// The table that says what is in which file.

const PROPERTIES: [Property; 6] = [
    Property::Radius,
    Property::Stiffness,
    Property::Dissipation,
    Property::ConstantContactForce,
    Property::HertzSmoothing,
    Property::HuntCrossleySmoothing,
];

/// What is before the name of what was asked, in the name of a column.
const GRID: &str = "grid_";
/// What a ladder asks at each step.
const LADDER: [&str; 1] = ["wanted_dimensionless_stiffness"];
/// x̂ at rest by the Hertz law, in whose k̂ a ladder steps, and by the law of the class of the force.
const HERTZ: &str = "relative_indentation_hertz";
const MODEL_LAW: &str = "relative_indentation_model_law";
/// Codes of errors and warnings that the model itself has not.
const WORSE: &str = "worse";
/// The number of the point or step, from 1, and its file.
const FIRST: [&str; 2] = ["index", "file"];

/// Names of the columns: the number and the file, what was asked, what is in the file, what follows from it.
fn header(asked: Vec<String>) -> Vec<String> {
    let properties = PROPERTIES.map(|property| property.name().to_owned());
    let follows =
        [HERTZ, MODEL_LAW, "dimensionless_stiffness", "restitution", WORSE, "sha256"].map(str::to_owned);
    let first = FIRST.map(str::to_owned).into_iter();
    first.chain(asked).chain(properties).chain(follows).collect()
}

/// Whether these are the columns of some sweep's table, by grid or by ladder.
fn is_header<C: AsRef<str>>(columns: &[C]) -> bool {
    let others = header(Vec::new()).len();
    let Some(count) = columns.len().checked_sub(others) else { return false };
    let asked: Vec<&str> = columns.iter().skip(FIRST.len()).take(count).map(AsRef::as_ref).collect();
    let is_grid = asked.iter().all(|column| column.starts_with(GRID));
    let whole = header(asked.iter().map(|&column| column.to_owned()).collect());
    (is_grid || asked == LADDER) && columns.iter().map(AsRef::as_ref).eq(whole)
}

/// One variant, with its number from 1 and its file; `worse` are codes of what is wrong with it alone, `sha256` is that of its bytes.
fn row(
    number: usize,
    file: String,
    asked: Vec<String>,
    variant: &Variant,
    (worse, sha256): (&[&str], String),
) -> Vec<String> {
    let cell = |value: Option<f64>| value.map(shortest).unwrap_or_default();
    let properties = PROPERTIES.map(|property| cell(variant.common(property)));
    let follows = [
        variant.indentations(Figure::Indentation),
        variant.indentations(Figure::IndentationModelLaw),
        cell(variant.dimensionless_stiffness()),
        cell(variant.restitution()),
        worse.join(" "),
        sha256,
    ];
    [number.to_string(), file].into_iter().chain(asked).chain(properties).chain(follows).collect()
}
