//! Masses: what the model weighs, and what its contacts stand for.

use globset::GlobSet;

use crate::error::{Fault, FaultKind};
use crate::model::Model;
use crate::number::shortest;
use crate::warning::{Warning, WarningCode};

/// Masses closer than this (relative) count as one: a scale is not read better than to 0.1 %.
pub const SAME_MASS: f64 = 1e-3;

/// What the user says about masses.
#[derive(Debug, Clone, Default)]
pub struct MassRequest {
    /// `--contacts-mass`: what the contacts in the file stand for, kg.
    pub contacts_kg: Option<f64>,
    /// `--mass`: what the model weighs, kg.
    pub model_kg: Option<f64>,
    /// What the contacts shall stand for, kg: an explicit origin need not agree with a source that says this.
    pub target_kg: Option<f64>,
    /// `--exclude-body`: props that do not belong to the animal.
    pub exclude_bodies: GlobSet,
}

/// Who said how heavy.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum MassSource {
    /// `--contacts-mass` (or `--reference-mass`).
    Option,
    /// The note in the file.
    Note,
    /// `--mass`.
    Mass,
    /// The sum of the bodies.
    Bodies,
    /// A preset.
    Preset,
    /// `--reference-mass`.
    Reference,
}

impl MassSource {
    /// As in the JSON.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Option => "contacts-mass",
            Self::Note => "note",
            Self::Mass => "mass",
            Self::Bodies => "bodies",
            Self::Preset => "preset",
            Self::Reference => "reference-mass",
        }
    }
}

/// A mass and where it comes from.
#[derive(Debug, Clone, PartialEq)]
pub struct Mass {
    /// In kg.
    pub kg: f64,
    /// Who said so.
    pub source: MassSource,
    /// Who said so, in words: `sum of 21 bodies`.
    pub told_by: String,
}

impl MassRequest {
    /// What the model weighs: `--mass`, else the sum of its bodies, left to right in file order.
    ///
    /// # Errors
    /// A body without a mass, no body at all, or a sum that is not above 0.
    pub fn of_model(&self, model: &Model<'_, '_>) -> Result<Mass, Fault> {
        if let Some(kg) = self.model_kg {
            let kg = checked("--mass", kg)?;
            return Ok(Mass { kg, source: MassSource::Mass, told_by: "--mass".to_owned() });
        }
        let mut kg = 0.0;
        let mut count = 0;
        for body in model.bodies().iter().filter(|body| !self.exclude_bodies.is_match(&body.name)) {
            kg += body.mass_kg()?;
            count += 1;
        }
        if kg > 0.0 && kg.is_finite() {
            let bodies =
                if count == 1 { "mass of 1 body".to_owned() } else { format!("sum of {count} bodies") };
            return Ok(Mass { kg, source: MassSource::Bodies, told_by: bodies });
        }
        Err(Fault::new(FaultKind::NeedsAnswer {
            code: "no-mass",
            question: if count == 0 {
                "the mass is not in the file: no body is left to sum".to_owned()
            } else {
                format!("the {count} bodies weigh {} kg in all", shortest(kg))
            },
            way_out: "say what the model weighs with --mass KG, or what its contacts stand for with --contacts-mass KG"
                .to_owned(),
        }))
    }

    /// What the contacts stand for: `--contacts-mass`, else the note, else what the model weighs.
    ///
    /// # Errors
    /// A note that no longer fits the file, or any error of [`MassRequest::of_model`].
    pub fn of_contacts(&self, model: &Model<'_, '_>, warnings: &mut Vec<Warning>) -> Result<Mass, Fault> {
        let mass = if let Some(kg) = self.contacts_kg {
            let kg = checked("--contacts-mass", kg)?;
            Mass { kg, source: MassSource::Option, told_by: "--contacts-mass".to_owned() }
        } else if let Some(why) = model.doubt_about_note() {
            return Err(uncertain(model, why));
        } else if let Some(kg) = model.note.as_ref().and_then(|note| note.mass_kg) {
            Mass { kg, source: MassSource::Note, told_by: "note in the file".to_owned() }
        } else {
            self.of_model(model)?
        };
        self.compare(model, &mass, warnings);
        Ok(mass)
    }

    /// Says where the other sources disagree with the one that was taken.
    pub fn compare(&self, model: &Model<'_, '_>, taken: &Mass, warnings: &mut Vec<Warning>) {
        let mut others = Vec::new();
        if taken.source != MassSource::Note
            && let Some(kg) = model.note.as_ref().and_then(|note| note.mass_kg)
        {
            others.push((kg, "the note in the file".to_owned()));
        }
        if let (Some(kg), true) = (self.model_kg, taken.source != MassSource::Mass) {
            others.push((kg, "--mass".to_owned()));
        }
        let bodies = Self { model_kg: None, ..self.clone() };
        if let (Ok(mass), true) = (bodies.of_model(model), taken.source != MassSource::Bodies) {
            others.push((mass.kg, format!("the {}", mass.told_by)));
        }
        // The usual case: the body was scaled to the target already, and the user says what the contacts were made for.
        let expected = |kg: f64| {
            taken.source == MassSource::Option && self.target_kg.is_some_and(|target| same_mass(kg, target))
        };
        let differs = |kg: f64| !same_mass(kg, taken.kg) && !expected(kg);
        for (kg, told_by) in others.into_iter().filter(|(kg, _)| differs(*kg)) {
            warnings.push(Warning::new(
                WarningCode::MassSourcesDisagree,
                format!(
                    "contacts are taken to stand for {} kg ({}), but {told_by} says {} kg",
                    shortest(taken.kg),
                    taken.told_by,
                    shortest(kg)
                ),
            ));
        }
    }
}

/// `true` within [`SAME_MASS`].
#[must_use]
pub fn same_mass(a: f64, b: f64) -> bool {
    (a - b).abs() <= SAME_MASS * b.abs()
}

fn uncertain(model: &Model<'_, '_>, why: &str) -> Fault {
    let said = model.note.as_ref().and_then(|note| note.mass_kg);
    let said = said.map(|kg| format!(" (the note says {} kg)", shortest(kg))).unwrap_or_default();
    Fault::new(FaultKind::NeedsAnswer {
        code: "stale-note",
        question: format!("what the contacts stand for is not certain{said}: {why}"),
        way_out: "say it with --contacts-mass KG".to_owned(),
    })
}

pub(crate) fn checked(what: &str, kg: f64) -> Result<f64, Fault> {
    if kg.is_finite() && kg > 0.0 {
        return Ok(kg);
    }
    Err(Fault::refused(format!("{what} is {kg}, expected a mass in kg above 0")))
}
