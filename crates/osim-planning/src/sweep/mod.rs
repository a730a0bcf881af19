//! Makes variants of one model: the points of a grid, or the steps of a ladder, which lead from soft to stiff contacts.

mod grid;
mod ladder;
mod variant;

use std::borrow::Cow;
use std::iter::StepBy;
use std::ops::Range;
use std::path::Path;

use osim_inspect::{Figure, unexplained_mass};
use osim_model::files::{Failure, ModelFiles};
use osim_model::messages::shortest;
use osim_model::{MassRequest, PropertySet, YesQuestion};
use osim_requests::{AxisName, RequestError, RequestFault, Result, SweepRequest};

use grid::{point_at, points_along, points_at_ends, zero_padded};
use ladder::SweepLadder;
use variant::{StepChanges, Variant};

/// A sweep of one model that was checked, and makes its variants one by one.
pub struct SweepPlan<'s> {
    request: &'s SweepRequest,
    model: ModelFiles,
    original: Variant,
    ladder: Option<SweepLadder>,
    count: usize,
}

/// The changes that make one variant, and how its table and note name them.
struct VariantJob {
    /// The values of the grid point or ladder step, as cells of the table.
    asked: Vec<String>,
    operation: String,
    /// The mass that the contacts are made for, kg, if it is an axis of the grid.
    target_mass_kg: Option<f64>,
    stages: StepChanges,
}

/// A variant in memory, before it is written to a file.
pub struct MadeVariant {
    pub bytes: Vec<u8>,
    /// The operation that made the variant, in the words of its note.
    pub operation: String,
    number: usize,
    file: String,
    asked: Vec<String>,
    variant: Variant,
    /// Codes of errors and warnings that the variant has and the original model does not have.
    worse: Vec<&'static str>,
}

impl MadeVariant {
    /// The variant's row of the table, in the order of `header`.
    pub fn row(self, sha256: String) -> Vec<String> {
        let Self { number, file, asked, variant, worse, .. } = self;
        let cell = |value: Option<f64>| value.map(shortest).unwrap_or_default();
        let properties = PropertySet::SCALED.map(|property| cell(variant.common_value(property)));
        let follows = [
            variant.indentations(Figure::Indentation),
            variant.indentations(Figure::IndentationModelLaw),
            cell(variant.figure(Figure::DimensionlessStiffness)),
            cell(variant.figure(Figure::RestitutionExact)),
            worse.join(" "),
            sha256,
        ];
        [number.to_string(), file].into_iter().chain(asked).chain(properties).chain(follows).collect()
    }

    /// A digest that is equal for variants whose contacts have equal numbers.
    pub fn contact_digest(&self) -> &str {
        &self.variant.digest
    }

    /// Whether the variant has errors or warnings that the original model does not have.
    pub fn is_worse(&self) -> bool {
        !self.worse.is_empty()
    }
}

impl<'s> SweepPlan<'s> {
    /// Plans a sweep of the model in the files `model`.
    ///
    /// # Errors
    /// Those of [`SweepRequest::check`], or the model itself cannot be read, a ladder has no last step, or there is no such point.
    pub fn new(request: &'s SweepRequest, model: ModelFiles) -> Result<Self> {
        request.check()?;
        let count = request.count()?;
        // A model that is wrong itself is refused here, once for all variants.
        let original = Variant::unchanged(request, &model)?;
        let ladder =
            request.ladder.map(|steps| SweepLadder::new(request, &model, steps.get())).transpose()?;
        grid::check_point_exists(request, count)?;
        Ok(Self { request, model, original, ladder, count })
    }

    /// The number of all variants of the sweep, including variants that other calls make.
    pub fn count(&self) -> usize {
        self.count
    }

    /// Indices of the variants that this call makes.
    pub fn indices(&self) -> StepBy<Range<usize>> {
        grid::indices_of_call(self.request, self.count)
    }

    /// The model that the sweep varies.
    pub fn model(&self) -> &ModelFiles {
        &self.model
    }

    /// The name of the file of a variant.
    pub fn file_name(&self, index: usize) -> String {
        let part = match &self.ladder {
            Some(ladder) => ladder.file_part(index),
            None => {
                let point = point_at(&self.request.grid, index);
                format!("{}_{}", zero_padded(index + 1, self.count), point.joined("-", "_"))
            }
        };
        self.file_name_with(&part, "osim")
    }

    /// Name of the table of all variants.
    pub fn table_name(&self) -> String {
        self.file_name_with(self.table_kind(), "csv")
    }

    /// Name of the table with the variants that this call makes; `None` if it makes all variants.
    pub fn part_table_name(&self) -> Option<String> {
        let part = grid::part_name(self.request)?;
        Some(self.file_name_with(self.table_kind(), &format!("{part}.csv")))
    }

    /// Whether `name` is the name of a table with some variants of a sweep of the model: this sweep or another.
    pub fn is_part_table_name(&self, name: &str) -> bool {
        let part = name
            .strip_prefix(&self.file_name_with(self.table_kind(), ""))
            .and_then(|end| end.strip_suffix(".csv"));
        part.is_some_and(grid::is_part_name)
    }

    /// Whether `name` may be the name of the file of a variant of the model, from this sweep or another.
    pub fn is_like_file_name(&self, name: &str) -> bool {
        let own = || name.strip_prefix(&*self.model_name())?.strip_prefix('_')?.strip_suffix(".osim");
        own().is_some_and(|part| match self.ladder {
            Some(_) => part.starts_with("ladder-"),
            None => part.starts_with(|c: char| c.is_ascii_digit()) && part.contains('-'),
        })
    }

    /// The word in the name of the table: `ladder` or `sweep`.
    fn table_kind(&self) -> &'static str {
        if self.ladder.is_some() { "ladder" } else { "sweep" }
    }

    /// The name of a file of the sweep: `NAME_part.extension`.
    fn file_name_with(&self, part: &str, extension: &str) -> String {
        format!("{}_{part}.{extension}", self.model_name())
    }

    fn model_name(&self) -> Cow<'_, str> {
        self.request.model.as_deref().and_then(Path::file_stem).unwrap_or_default().to_string_lossy()
    }

    /// The names of the columns of the table of variants.
    pub fn table_header(&self) -> Vec<String> {
        header(match self.ladder {
            Some(_) => COLUMNS_OF_LADDER.map(str::to_owned).to_vec(),
            None => {
                self.request.grid.iter().map(|axis| format!("{GRID_PREFIX}{}", axis.name.as_str())).collect()
            }
        })
    }

    /// Whether `columns` are the columns of a sweep's table, of a grid or of a ladder.
    pub fn is_table_header<C: AsRef<str>>(columns: &[C]) -> bool {
        let others = header(Vec::new()).len();
        let Some(count) = columns.len().checked_sub(others) else { return false };
        let asked: Vec<&str> =
            columns.iter().skip(FIRST_COLUMNS_OF_SWEEP.len()).take(count).map(AsRef::as_ref).collect();
        let is_grid = asked.iter().all(|column| column.starts_with(GRID_PREFIX));
        let whole = header(asked.iter().map(|&column| column.to_owned()).collect());
        (is_grid || asked == COLUMNS_OF_LADDER) && columns.iter().map(AsRef::as_ref).eq(whole)
    }

    /// Plans the variants at the ends of the axes. Values outside their domain are so found before anything is written.
    ///
    /// # Errors
    /// What is wrong, with the point; or the model itself cannot be used, so that no variant could be.
    pub fn check_ends(&self) -> Result<()> {
        let points = match self.ladder {
            Some(_) => vec![0, self.count.saturating_sub(1)],
            None => {
                self.points_with_odd_mass()?.into_iter().chain(points_at_ends(&self.request.grid)).collect()
            }
        };
        for index in points {
            let job = self.job_of_variant(index)?;
            self.make_variant(&job).map_err(|failure| {
                // A question stays a failure, because its code answers it; so does a model that cannot be used whatever is asked.
                let is_of_model = failure.line.is_some() && self.original.unusable.is_some();
                match failure.code.parse::<YesQuestion>() {
                    Err(_) if !is_of_model => RequestFault::general(failure.message).into(),
                    _ => RequestError::Failure(failure),
                }
            })?;
        }
        self.original.unusable.clone().map_or(Ok(()), |failure| Err(RequestError::Failure(failure)))
    }

    /// Indices of the points whose mass looks like a typing mistake or another unit. These points can be anywhere on the axis.
    fn points_with_odd_mass(&self) -> Result<Vec<usize>> {
        let masses = points_along(&self.request.grid, AxisName::TargetMass);
        if masses.is_empty() {
            return Ok(Vec::new());
        }
        let open = self.model.clone().open().map_err(RequestError::Failure)?;
        let selection = self.request.choice.selection();
        let is_asked = |target_mass_kg: f64| {
            let target_mass_kg = Some(target_mass_kg);
            let said = MassRequest { target_mass_kg, ..self.request.masses.request() };
            unexplained_mass(&said, &open.model, &selection).is_some()
        };
        let odd = masses.into_iter().filter(|(_, target_mass_kg)| is_asked(*target_mass_kg));
        Ok(odd.map(|(index, _)| index).collect())
    }

    /// Makes the variant with this index.
    ///
    /// # Errors
    /// What is wrong, with the point.
    pub fn make(&self, index: usize) -> Result<MadeVariant, Failure> {
        let job = self
            .job_of_variant(index)
            .map_err(|fault| Failure::outside(self.model.name(), "refused", fault.phrase()))?;
        let mut variant = self.make_variant(&job)?;
        let bytes = std::mem::take(&mut variant.bytes);
        Ok(MadeVariant {
            bytes,
            operation: job.operation,
            number: index + 1,
            file: self.file_name(index),
            asked: job.asked,
            worse: variant.codes_not_in(&self.original),
            variant,
        })
    }

    /// Makes a variant in memory. A failure says at which point.
    fn make_variant(&self, job: &VariantJob) -> Result<Variant, Failure> {
        let VariantJob { operation, target_mass_kg, stages, .. } = job;
        let variant = Variant::of_stages(self.request, &self.model, stages, operation, *target_mass_kg);
        variant.map_err(|mut failure| {
            failure.message.push(format!(" ({operation})"));
            failure
        })
    }

    /// The changes that make the variant with this index.
    fn job_of_variant(&self, index: usize) -> Result<VariantJob, RequestFault> {
        let Some(ladder) = &self.ladder else {
            let point = point_at(&self.request.grid, index);
            return Ok(VariantJob {
                asked: point.values.iter().map(|(_, value)| value.exact()).collect(),
                operation: format!("sweep {}", point.joined("=", " ")),
                target_mass_kg: point.value_of_axis(AxisName::TargetMass),
                stages: variant::stages_at(self.request, &point)?,
            });
        };
        let (number, count) = (index + 1, ladder.len());
        let stiffness = ladder.dimensionless_stiffness(index).map(shortest).unwrap_or_default();
        Ok(VariantJob {
            asked: vec![stiffness],
            operation: format!("ladder step {number} of {count}"),
            target_mass_kg: None,
            stages: ladder.stages(self.request, index)?,
        })
    }
}

/// The beginning of the name of a column with the values of an axis.
const GRID_PREFIX: &str = "grid_";
/// The column with the stiffness that each step of a ladder aims at.
const COLUMNS_OF_LADDER: [&str; 1] = ["wanted_dimensionless_stiffness"];
/// The column with x̂ under the body weight by the Hertz law. The k̂ of a ladder's steps follows from it.
const HERTZ_INDENTATION: &str = "relative_indentation_hertz";
/// The column with x̂ under the body weight by the law of the force's class.
const MODEL_LAW_INDENTATION: &str = "relative_indentation_model_law";
/// The column with the codes of errors and warnings that the original model does not have.
const WORSE_FINDINGS_COLUMN: &str = "worse";
/// The columns with the number of the point or step, from 1, and with the file of the variant.
const FIRST_COLUMNS_OF_SWEEP: [&str; 2] = ["index", "file"];

/// Names of all columns: number and file, values of the grid or ladder (`asked`), parameters of the contacts, and figures.
fn header(asked: Vec<String>) -> Vec<String> {
    let properties = PropertySet::SCALED.map(|property| property.as_str().to_owned());
    let follows = [
        HERTZ_INDENTATION,
        MODEL_LAW_INDENTATION,
        "dimensionless_stiffness",
        "restitution",
        WORSE_FINDINGS_COLUMN,
        "sha256",
    ]
    .map(str::to_owned);
    let first = FIRST_COLUMNS_OF_SWEEP.map(str::to_owned).into_iter();
    first.chain(asked).chain(properties).chain(follows).collect()
}
