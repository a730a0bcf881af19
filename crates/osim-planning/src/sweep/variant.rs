//! One variant of the model: its bytes, and what is in them.

use std::collections::BTreeSet;

use osim_inspect::{Figure, Figures, InspectOptions, LoadSharing, Stance};
use osim_model::files::{Failure, ModelFiles, OpenModel};
use osim_model::messages::shortest;
use osim_model::{
    Fault, FileId, FindingCode, Mass, MassRequest, MassSource, Model, Property, Selected, Severity,
};
use osim_requests::SweepRequest;

use super::stages::Stages;
use crate::afterwards::{is_due, unmended};

/// A variant, read again from its own bytes.
pub(super) struct Variant {
    pub bytes: Vec<u8>,
    values: Vec<(Property, f64)>,
    figures: Option<Figures>,
    /// The same for variants whose contacts have the same numbers.
    pub digest: String,
    /// Codes of its errors and warnings.
    wrong: BTreeSet<FindingCode>,
}

impl Variant {
    /// Does `stages` one after the other and reads the result. The contacts are then made for `target_mass_kg`, else for what
    /// the model weighs.
    ///
    /// # Errors
    /// A stage that cannot be planned, or that would change an included file.
    pub(super) fn of(
        request: &SweepRequest,
        model: &ModelFiles,
        stages: &Stages,
        operation: &str,
        target_mass_kg: Option<f64>,
    ) -> Result<Self, Failure> {
        let mut current = model.clone();
        for (number, planner) in stages.iter().enumerate() {
            let open = current.open()?;
            let mut plan = planner.plan(&open.model).map_err(|fault| open.failure(fault))?;
            plan.name_operation(operation);
            if number > 0 {
                plan.join_steps();
            }
            if request.no_note {
                plan.without_note();
            } else {
                plan.note_anyway();
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

    /// The model as it is.
    ///
    /// # Errors
    /// It cannot be read, or the choice of forces is not clear.
    pub(super) fn unchanged(request: &SweepRequest, model: &ModelFiles) -> Result<Self, Failure> {
        Self::read(request, model.clone(), None)
    }

    fn read(request: &SweepRequest, model: ModelFiles, target_mass_kg: Option<f64>) -> Result<Self, Failure> {
        let open = model.open()?;
        let model = &open.model;
        let selected = request.choice.selection().apply(model).map_err(|fault| open.failure(fault))?;
        let given = |kg| Mass { kg, source: MassSource::Grid };
        let mass = target_mass_kg.map(given).or_else(|| request.masses.request().of_model(model).ok());
        let stance = Stance::from(&request.counts.stance_options(request.wanted.impact_speed, None));
        let wrong = wrong(request, &open, mass.as_ref(), stance);
        let sharing = LoadSharing::of(model, &selected.forces);
        let figures = Figures::of(model, &selected, &sharing, mass.as_ref(), &stance, &[]).ok();
        let bytes = model.file(FileId::MAIN).bytes().to_vec();
        let digest = model.contact_digest(|_| None);
        Ok(Self { bytes, values: values(model, &selected), figures, digest, wrong })
    }

    /// Codes of the errors and warnings that `original` has not.
    pub(super) fn worse_than(&self, original: &Self) -> Vec<&'static str> {
        self.wrong.difference(&original.wrong).map(|code| code.as_str()).collect()
    }

    /// Every value of `property`.
    pub(super) fn all(&self, property: Property) -> impl Iterator<Item = f64> {
        self.values.iter().filter(move |(known, _)| *known == property).map(|(_, value)| *value)
    }

    /// The value of `property`, where it is the same everywhere.
    pub(super) fn common(&self, property: Property) -> Option<f64> {
        alike(self.all(property))
    }

    /// x̂ under one body weight: a number where all spheres have the same, else that of each kind, called by its first sphere, such as
    /// `heel_r=0.16 toe_r=0.12`. `figure` says by which law.
    pub(super) fn indentations(&self, figure: Figure) -> String {
        let spheres = self.figures.iter().flat_map(Figures::spheres);
        let known: Option<Vec<(&str, f64)>> =
            spheres.map(|sphere| Some((sphere.sphere.as_str(), sphere.value(figure)?))).collect();
        let mut kinds: Vec<(&str, f64)> = Vec::new();
        for (name, value) in known.unwrap_or_default() {
            if !kinds.iter().any(|(_, known)| is_alike(*known, value)) {
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

    /// k̂ under one body weight (B.3).
    pub(super) fn dimensionless_stiffness(&self) -> Option<f64> {
        self.figure(Figure::DimensionlessStiffness)
    }

    /// c_r at the impact speed, by the law of the file.
    pub(super) fn restitution(&self) -> Option<f64> {
        self.figure(Figure::RestitutionExact)
    }

    fn figure(&self, figure: Figure) -> Option<f64> {
        let figures = self.figures.as_ref()?;
        let all: Option<Vec<f64>> = figures.spheres().map(|sphere| sphere.value(figure)).collect();
        alike(all?.into_iter())
    }
}

/// Codes of the errors and warnings of a model that carries `mass`.
fn wrong(
    request: &SweepRequest,
    open: &OpenModel,
    mass: Option<&Mass>,
    stance: Stance,
) -> BTreeSet<FindingCode> {
    let masses = MassRequest { model_kg: mass.map(|mass| mass.kg), ..request.masses.request() };
    let options =
        InspectOptions { masses, selection: request.choice.selection(), stance, ..InspectOptions::default() };
    let found = unmended(&options, open, &open.model).into_iter();
    found.filter(|one| one.severity >= Severity::Warn && !is_due(one)).map(|one| one.code()).collect()
}

/// The common value; figures of like spheres may differ in their last digits.
fn alike(mut values: impl Iterator<Item = f64>) -> Option<f64> {
    let first = values.next()?;
    values.all(|value| is_alike(first, value)).then_some(first)
}

fn is_alike(first: f64, value: f64) -> bool {
    (value - first).abs() <= 1e-12 * first.abs()
}

/// Parameters of the selected forces, and radii of their spheres.
fn values(model: &Model, selected: &Selected) -> Vec<(Property, f64)> {
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
