//! One variant of the model: its bytes, and what stands in them.

use osim_patch::{Fault, FaultKind, Mass, MassSource, Model, Property, Selected};

use super::stages::Stages;
use crate::args::SweepArgs;
use crate::failure::Failure;
use crate::load::Loaded;
use crate::look::figures::{Figures, SphereFigures, Stance};

/// The load at which variants are compared, in body weights.
const ONE_BODY_WEIGHT: f64 = 1.0;

/// A variant, read again from its own bytes.
pub(super) struct Variant {
    pub bytes: Vec<u8>,
    values: Vec<(Property, f64)>,
    figures: Option<Figures>,
}

impl Variant {
    /// Does `stages` one after the other and reads what came out. The contacts then stand for `mass_kg`, else for what
    /// the model weighs.
    ///
    /// # Errors
    /// A stage that cannot be planned, or that would change an included file.
    pub(super) fn of(
        args: &SweepArgs,
        loaded: &Loaded,
        stages: &Stages,
        operation: &str,
        mass_kg: Option<f64>,
    ) -> Result<Self, Failure> {
        let mut bytes = loaded.bytes.clone();
        for planner in stages {
            let current = loaded.with_bytes(bytes);
            bytes = current.with_model(|model| {
                let mut plan = planner.plan(model).map_err(|fault| current.failure(fault))?;
                plan.name_operation(operation);
                if args.no_note {
                    plan.without_note();
                } else {
                    plan.note_anyway();
                }
                let included = (1..=current.parts.len()).any(|file| !plan.edits(model, file).is_empty());
                if included {
                    let message = "its contacts stand in a file that it includes: make variants of that file";
                    return Err(current.failure(Fault::new(FaultKind::Refused(message.to_owned()))));
                }
                plan.patched(model, 0).map_err(|fault| current.failure(fault))
            })?;
        }
        Self::read(args, &loaded.with_bytes(bytes), mass_kg)
    }

    /// The model as it is.
    ///
    /// # Errors
    /// It cannot be read, or `--select` and the like leave open what is meant.
    pub(super) fn unchanged(args: &SweepArgs, loaded: &Loaded) -> Result<Self, Failure> {
        Self::read(args, loaded, None)
    }

    fn read(args: &SweepArgs, loaded: &Loaded, mass_kg: Option<f64>) -> Result<Self, Failure> {
        let outside = |error: anyhow::Error| Failure::outside(&loaded.shown, "refused", &error);
        let selection = args.choice.selection().map_err(outside)?;
        let masses = args.masses.request().map_err(outside)?;
        loaded.with_model(|model| {
            let selected = selection.apply(model).map_err(|fault| loaded.failure(fault))?;
            let given = |kg| Mass { kg, source: MassSource::Reference, told_by: "--grid".to_owned() };
            let mass = mass_kg.map(given).or_else(|| masses.of_model(model).ok());
            let stance = Stance {
                spheres: args.counts.spheres,
                limbs: args.counts.stance_limbs,
                impact_speed_m_s: args.wanted.impact_speed,
                gravity_m_s2: None,
            };
            let limbs = model.limbs(&selected.forces);
            let figures = Figures::of(model, &selected, &limbs, mass.as_ref(), &stance).ok();
            Ok(Self { bytes: loaded.bytes.clone(), values: values(model, &selected), figures })
        })
    }

    /// Every value of `property`.
    pub(super) fn all(&self, property: Property) -> impl Iterator<Item = f64> {
        self.values.iter().filter(move |(known, _)| *known == property).map(|(_, value)| *value)
    }

    /// The value of `property`, where it is the same everywhere.
    pub(super) fn common(&self, property: Property) -> Option<f64> {
        alike(self.all(property))
    }

    /// x̂ under one body weight by the Hertz law (11).
    pub(super) fn indentation(&self) -> Option<f64> {
        self.figure(|sphere| sphere.load(ONE_BODY_WEIGHT)?.hertz)
    }

    /// k̂ under one body weight (B.3).
    pub(super) fn dimensionless_stiffness(&self) -> Option<f64> {
        self.figure(|sphere| sphere.dimensionless_stiffness)
    }

    /// c_r at the impact speed, by the law of the file.
    pub(super) fn restitution(&self) -> Option<f64> {
        self.figure(|sphere| sphere.restitution_exact)
    }

    fn figure(&self, of: impl Fn(&SphereFigures) -> Option<f64>) -> Option<f64> {
        let figures = self.figures.as_ref()?;
        let all: Option<Vec<f64>> = figures.spheres().map(of).collect();
        alike(all?.into_iter())
    }
}

/// The common value; figures of like spheres may differ in their last digits.
fn alike(mut values: impl Iterator<Item = f64>) -> Option<f64> {
    let first = values.next()?;
    values.all(|value| (value - first).abs() <= 1e-12 * first.abs()).then_some(first)
}

/// Parameters of the selected forces, and radii of their spheres.
fn values(model: &Model, selected: &Selected) -> Vec<(Property, f64)> {
    let mut values = Vec::new();
    for force in selected.forces.iter().filter_map(|&index| model.forces.get(index)) {
        for set in &force.sets {
            values.extend(set.values.iter().map(|value| (value.property, value.number)));
            let spheres = set.spheres.iter().filter_map(|&index| model.spheres.get(index));
            values.extend(spheres.map(|sphere| (Property::Radius, sphere.radius.number)));
        }
    }
    values
}
