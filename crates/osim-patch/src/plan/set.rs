//! Plain changes: a property becomes a value, or is multiplied by a factor. Nothing else follows.

use super::draft::{Draft, New};
use super::radii::{Users, moving_spheres};
use super::{Masses, NoteFacts, Plan};
use crate::error::{Fault, FaultKind};
use crate::mass::Mass;
use crate::model::Model;
use crate::note::Scope;
use crate::number::{readable, shortest};
use crate::property::Property;
use crate::select::Selected;
use crate::warning::{Warning, WarningCode};

/// Between the operations that a note lists.
const AND: &str = " + ";

/// What becomes of a property.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Assignment {
    /// This value, in OpenSim's unit.
    Value(f64),
    /// Its value times this.
    Factor(f64),
}

impl Assignment {
    fn applied_to(self, from: f64) -> New {
        match self {
            Self::Value(to) => New { to, factor: None, equation: "given" },
            Self::Factor(factor) => New::times(from, factor, "given"),
        }
    }

    fn text(self) -> String {
        match self {
            Self::Value(value) => shortest(value),
            Self::Factor(factor) => format!("x{}", shortest(factor)),
        }
    }
}

/// What is wanted.
#[derive(Debug, Clone)]
pub struct Set {
    /// Properties and what becomes of them.
    pub assignments: Vec<(Property, Assignment)>,
    /// What the contacts stand for, where known; it stays.
    pub contacts_mass: Option<Mass>,
    /// Apply factors once more to a file whose note says they were applied already.
    pub again: bool,
}

impl Set {
    /// The operation as the note records it: `set stiffness=x2 dissipation=1`.
    #[must_use]
    pub fn operation(&self) -> String {
        let each: Vec<_> =
            self.assignments.iter().map(|(property, value)| format!("{property}={}", value.text())).collect();
        format!("set {}", each.join(" "))
    }
}

/// Plans plain changes of the forces `selected` of `model`.
///
/// # Errors
/// A value outside its domain, a property that none of the forces has, or a factor that was applied already.
pub fn set(model: &Model<'_, '_>, selected: &Selected, wanted: &Set) -> Result<Plan, Fault> {
    let operation = wanted.operation();
    let relative = wanted.assignments.iter().any(|(_, value)| matches!(value, Assignment::Factor(_)));
    let before =
        model.note.as_ref().map(|note| note.operation.as_str()).filter(|done| done.starts_with("set "));
    let done = before.is_some_and(|done| done.split(AND).any(|one| one == operation));
    if relative && !wanted.again && done {
        return Err(Fault::new(FaultKind::NeedsAnswer {
            code: "same-operation",
            question: format!("the note in the file says that '{operation}' was done already"),
            way_out: "apply it once more with --force".to_owned(),
        }));
    }
    let mut draft = Draft::new(model);
    for &(property, value) in &wanted.assignments {
        let mut found = false;
        if property == Property::Radius {
            let users = Users::outside(model, &selected.forces);
            for sphere in moving_spheres(model, &selected.forces) {
                let from = draft.current_radius(sphere)?;
                if value.applied_to(from).to != from {
                    users.refuse(model, &selected.forces, sphere)?;
                }
                draft.radius(sphere, value.applied_to(from))?;
                found = true;
            }
        } else {
            for &force in &selected.forces {
                let sets = model.forces.get(force).map_or(0, |force| force.sets.len());
                for set in 0..sets {
                    if let Some(from) = draft.current(force, set, property)? {
                        draft.parameter(force, set, property, value.applied_to(from))?;
                        found = true;
                    }
                }
            }
        }
        if !found {
            return Err(Fault::refused(format!("none of the chosen forces has a {property}")));
        }
    }
    let Draft { changes, moves, mut warnings, .. } = draft;
    if changes.is_empty() {
        warnings.push(Warning::new(WarningCode::NothingToChange, "every value is already as wanted"));
    }
    let mut taken = format!("{operation}; nothing else follows");
    if let Some(mass) = &wanted.contacts_mass {
        taken = format!("contacts stand for {} kg ({}); {taken}", readable(mass.kg), mass.told_by);
    }
    let masses = wanted.contacts_mass.clone().map(|from| Masses { to_kg: from.kg, from });
    let plan =
        Plan { changes, moves, masses, taken, warnings, remarks: vec![], note: None, note_anyway: false };
    Ok(plan.with_note(
        model,
        &NoteFacts {
            mass_kg: wanted.contacts_mass.as_ref().map(|mass| mass.kg),
            gravity_m_s2: model.contacts_gravity(),
            scope: Scope::Partial,
            // Every change since the last whole rescaling counts: none may be applied twice without a word.
            operation: &before.map_or(operation.clone(), |before| format!("{before}{AND}{operation}")),
        },
    ))
}
