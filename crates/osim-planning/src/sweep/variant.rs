//! A variant of a model: the changes that make it, its bytes and its figures.

use std::collections::BTreeSet;

use osim_inspect::{Figure, Figures, FindingWithRemedy, InspectOptions, LoadSharing, Stance};
use osim_model::files::{Failure, ModelFiles, OpenModel};
use osim_model::messages::{Input, phrase, shortest};
use osim_model::{
    Assignment, Fault, FileId, FindingCode, Mass, MassRequest, MassSource, Model, Property, Selected,
    Severity,
};
use osim_requests::{
    AxisName, DesignRequest, Kilograms, RelativeIndentation, RequestFault, RescaleRequest,
    RestitutionCoefficient, SetRequest, SweepRequest,
};

use super::grid::GridPoint;
use crate::prepared_change::PreparedChange;
use crate::result_check::findings_without_remedies;
use crate::verbs::{design, rescale, set};

/// A variant whose bytes were made and read again.
pub(super) struct Variant {
    pub bytes: Vec<u8>,
    values: Vec<(Property, f64)>,
    figures: Option<Figures>,
    /// A digest that is equal for variants whose contacts have equal numbers.
    pub digest: String,
    /// Codes of the variant's errors and warnings.
    wrong: BTreeSet<FindingCode>,
    /// Why the model cannot be used: OpenSim refuses it, or the first number that it reads as another one or cannot compute with.
    pub unusable: Option<Failure>,
}

impl Variant {
    /// Applies the changes `stages` one after the other and reads the result. The figures are for the mass `target_mass_kg`, else for the
    /// mass of the model.
    ///
    /// # Errors
    /// A stage that cannot be planned, or that would change an included file.
    pub(super) fn of_stages(
        request: &SweepRequest,
        model: &ModelFiles,
        stages: &StepChanges,
        operation: &str,
        target_mass_kg: Option<f64>,
    ) -> Result<Self, Failure> {
        let mut current = model.clone();
        for (number, stage) in stages.iter().enumerate() {
            let open = current.open()?;
            let mut plan = stage.plan_alone(&open.model).map_err(|fault| open.failure(fault))?;
            plan.name_operation(operation);
            if number > 0 {
                plan.join_steps();
            }
            if request.no_note {
                plan.drop_note();
            } else {
                plan.requires_note = true;
            }
            if plan.files(&open.model).any(|file| file != FileId::MAIN) {
                let message = "its contacts are in a file that it includes: make variants of that file";
                return Err(open.failure(Fault::refused(message)));
            }
            let patched = plan.patched(&open.model, FileId::MAIN).map_err(|fault| open.failure(fault))?;
            current = model.with_bytes(patched);
        }
        Self::read(request, current, target_mass_kg)
    }

    /// The original model as a variant without changes.
    pub(super) fn unchanged(request: &SweepRequest, model: &ModelFiles) -> Result<Self, Failure> {
        Self::read(request, model.clone(), None)
    }

    /// Reads a changed model, and computes its figures under `target_mass_kg`, else under its own mass.
    fn read(request: &SweepRequest, model: ModelFiles, target_mass_kg: Option<f64>) -> Result<Self, Failure> {
        let open = model.open()?;
        let model = &open.model;
        let selected = request.choice.selection().apply(model).map_err(|fault| open.failure(fault))?;
        let given = |kg| Mass { kg, source: MassSource::Grid };
        let mass = target_mass_kg.map(given).or_else(|| request.masses.request().model_mass(model).ok());
        let stance = Stance::from(&request.counts.stance_options(request.wanted.impact_speed, None));
        let findings = find_warnings(request, &open, mass.as_ref(), stance);
        let unusable = findings.iter().find_map(|finding| failure_of_model(&open, finding));
        let wrong = findings.iter().map(|finding| finding.code()).collect();
        let sharing = LoadSharing::of(model, &selected.forces);
        let figures = Figures::compute(model, &selected, &sharing, mass.as_ref(), &stance, &[]).ok();
        let bytes = model.file(FileId::MAIN).bytes().to_vec();
        let digest = model.contact_digest(|_| None);
        Ok(Self { bytes, values: contact_values(model, &selected), figures, digest, wrong, unusable })
    }

    /// Codes of the errors and warnings of this variant that `original` does not have.
    pub(super) fn codes_not_in(&self, original: &Self) -> Vec<&'static str> {
        self.wrong.difference(&original.wrong).map(|code| code.as_str()).collect()
    }

    /// The values of `property` in all contacts.
    pub(super) fn values_of(&self, property: Property) -> impl Iterator<Item = f64> {
        self.values.iter().filter(move |(known, _)| *known == property).map(|(_, value)| *value)
    }

    /// The value of `property`, if all contacts have the same value.
    pub(super) fn common_value(&self, property: Property) -> Option<f64> {
        common_number(self.values_of(property))
    }

    /// x̂ under one body weight by the law of `figure`. It is one number if all spheres have the same x̂; else each different number has
    /// the name of the first sphere with it, such as `heel_r=0.16 toe_r=0.12`.
    pub(super) fn indentations(&self, figure: Figure) -> String {
        let spheres = self.figures.iter().flat_map(Figures::spheres);
        let known: Option<Vec<(&str, f64)>> =
            spheres.map(|sphere| Some((sphere.sphere.as_str(), sphere.value(figure)?))).collect();
        let mut kinds: Vec<(&str, f64)> = Vec::new();
        for (name, value) in known.unwrap_or_default() {
            if !kinds.iter().any(|(_, known)| is_nearly_equal(*known, value)) {
                kinds.push((name, value));
            }
        }
        match kinds.as_slice() {
            [(_, value)] => shortest(*value),
            _ => kinds
                .iter()
                .map(|(name, value)| format!("{name}={}", shortest(*value)))
                .collect::<Vec<_>>()
                .join(" "),
        }
    }

    /// The largest √cf/R of the spheres; 0 without smoothing.
    pub(super) fn largest_constant_indentation(&self) -> f64 {
        let spheres = self.figures.iter().flat_map(Figures::spheres);
        spheres.filter_map(|sphere| sphere.value(Figure::ConstantIndentation)).fold(0.0, f64::max)
    }

    /// A figure under one body weight and at the impact speed, if all spheres have the same value.
    pub(super) fn figure(&self, figure: Figure) -> Option<f64> {
        let figures = self.figures.as_ref()?;
        let all: Option<Vec<f64>> = figures.spheres().map(|sphere| sphere.value(figure)).collect();
        common_number(all?.into_iter())
    }
}

/// The errors and warnings of a model whose contacts carry `mass`.
fn find_warnings(
    request: &SweepRequest,
    open: &OpenModel,
    mass: Option<&Mass>,
    stance: Stance,
) -> Vec<FindingWithRemedy> {
    let masses = MassRequest { model_kg: mass.map(|mass| mass.kg), ..request.masses.request() };
    let options =
        InspectOptions { masses, selection: request.choice.selection(), stance, ..InspectOptions::default() };
    let mut findings = findings_without_remedies(&options, open, &open.model);
    // The contacts of a variant are often scaled before its bodies.
    findings
        .retain(|one| one.severity >= Severity::Warning && one.code() != FindingCode::MassSourcesDisagree);
    findings
}

/// The failure of a model with this finding, if OpenSim refuses the model or a number cannot be read or computed with.
fn failure_of_model(open: &OpenModel, finding: &FindingWithRemedy) -> Option<Failure> {
    let code = match finding.code() {
        FindingCode::OddNumber | FindingCode::NotFinite => "not-a-number",
        FindingCode::OutOfDomain => "out-of-domain",
        FindingCode::OtherVersion
        | FindingCode::ConnecteeByName
        | FindingCode::SocketNowhere
        | FindingCode::BodyWithoutJoint
        | FindingCode::MisplacedObject
        | FindingCode::UnknownName => "refused",
        _ => return None,
    };
    Some(Failure {
        line: finding.position.map(|at| at.line),
        column: finding.position.map(|at| at.column),
        ..Failure::outside(open.name().clone(), code, finding.message.clone())
    })
}

/// The first value, if all others are nearly equal. Figures of equal spheres may differ in their last digits.
fn common_number(mut values: impl Iterator<Item = f64>) -> Option<f64> {
    let first = values.next()?;
    values.all(|value| is_nearly_equal(first, value)).then_some(first)
}

fn is_nearly_equal(first: f64, value: f64) -> bool {
    (value - first).abs() <= 1e-12 * first.abs()
}

/// Parameters of the selected forces, and radii of their spheres.
fn contact_values(model: &Model, selected: &Selected) -> Vec<(Property, f64)> {
    let mut values = Vec::new();
    for force in selected.forces.iter().filter_map(|&id| model.force(id)) {
        for set in &force.sets {
            values.extend(set.values.iter().map(|value| (value.property, value.number)));
            let spheres = set.spheres.iter().filter_map(|&id| model.sphere(id));
            values.extend(spheres.map(|sphere| (Property::Radius, sphere.radius.number)));
        }
    }
    values
}

/// The changes that make one variant, one after the other: rescale, set and design, as far as the point needs them.
pub(super) type StepChanges = Vec<PreparedChange>;

/// The changes that make the variant at a grid point.
///
/// # Errors
/// Values that do not go together.
pub(super) fn stages_at(request: &SweepRequest, point: &GridPoint<'_>) -> Result<StepChanges, RequestFault> {
    let (indentation, restitution) =
        (point.value_of_axis(AxisName::Indentation), point.value_of_axis(AxisName::Restitution));
    let wanted = &request.wanted;
    let designs = indentation.is_some()
        || restitution.is_some()
        || wanted.has_design()
        || wanted.contact_stiffness.is_some();
    let mut stages = StepChanges::new();
    if let Some(target_mass_kg) = point.value_of_axis(AxisName::TargetMass) {
        if designs {
            return Err(RequestFault::general(
                "target_mass and a design (indentation, restitution, ...) contradict each other in one sweep",
            ));
        }
        stages.push(prepare_rescale(request, target_mass_kg)?);
    }
    let assignments: Vec<(Property, Assignment)> = point
        .values
        .iter()
        .filter_map(|(name, value)| match name {
            AxisName::Property(property) if value.is_factor => {
                Some((*property, Assignment::Factor(value.number)))
            }
            AxisName::Property(property) => Some((*property, Assignment::Value(value.number))),
            _ => None,
        })
        .collect();
    if !assignments.is_empty() {
        stages.push(prepare_set(request, assignments)?);
    }
    if designs {
        stages.push(prepare_design(request, indentation, restitution)?);
    }
    Ok(stages)
}

/// Prepares the design that gives a variant this indentation and restitution.
pub(super) fn prepare_design(
    request: &SweepRequest,
    indentation: Option<f64>,
    restitution: Option<f64>,
) -> Result<PreparedChange, RequestFault> {
    let refused = |name: AxisName, number: f64| {
        move |why: String| {
            let value = format!(" {}={}: {why}", name.as_str(), shortest(number));
            RequestFault::refused(Input::Grid, phrase![Input::Grid, value])
        }
    };
    let mut wanted = request.wanted.clone();
    if let Some(x) = indentation {
        wanted.indentation = Some(RelativeIndentation::new(x).map_err(refused(AxisName::Indentation, x))?);
    }
    if let Some(restitution) = restitution {
        wanted.restitution = Some(
            RestitutionCoefficient::new(restitution).map_err(refused(AxisName::Restitution, restitution))?,
        );
    }
    let design = DesignRequest {
        wanted,
        load: request.load.clone(),
        masses: request.masses.clone(),
        counts: request.counts.clone(),
        choice: request.choice.clone(),
        answers: request.answers.clone(),
        ..DesignRequest::default()
    };
    design::prepare(design)
}

/// Prepares new values of properties for a variant.
pub(super) fn prepare_set(
    request: &SweepRequest,
    assignments: Vec<(Property, Assignment)>,
) -> Result<PreparedChange, RequestFault> {
    let set = SetRequest {
        models: request.model.iter().cloned().collect(),
        set: assignments.into_iter().collect(),
        masses: request.masses.clone(),
        choice: request.choice.clone(),
        answers: request.answers.clone(),
        ..SetRequest::default()
    };
    set::prepare(set)
}

/// Prepares the rescaling of a variant to this mass.
fn prepare_rescale(request: &SweepRequest, target_mass_kg: f64) -> Result<PreparedChange, RequestFault> {
    let target_mass =
        Kilograms::new(target_mass_kg).map_err(|why| RequestFault::refused(Input::TargetMass, why))?;
    let request = RescaleRequest {
        target_mass: Some(target_mass),
        masses: request.masses.clone(),
        choice: request.choice.clone(),
        answers: request.answers.clone(),
        ..RescaleRequest::default()
    };
    rescale::prepare_with_factors(request, None)
}
