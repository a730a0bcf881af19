//! Collecting changes: each number is checked, changed once, and only if it really changes.

use std::collections::HashSet;

use super::{Change, Move, Target};
use crate::document::Value;
use crate::error::{Fault, FaultKind};
use crate::model::Model;
use crate::note::Key;
use crate::property::Property;
use crate::warning::Warning;

/// The properties a run may change.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PropertySet(Vec<Property>);

impl Default for PropertySet {
    /// Everything the paper scales: radius, E₁*, α and the three smoothing parameters.
    fn default() -> Self {
        Self(vec![
            Property::Radius,
            Property::Stiffness,
            Property::Dissipation,
            Property::ConstantContactForce,
            Property::HertzSmoothing,
            Property::HuntCrossleySmoothing,
        ])
    }
}

impl PropertySet {
    /// Friction speeds too: `transition_velocity` and `viscous_friction`.
    #[must_use]
    pub fn with_friction(mut self) -> Self {
        self.0.extend([Property::TransitionVelocity, Property::ViscousFriction]);
        self
    }

    /// Only those of `only` (all, where that is empty) and none of `keep`.
    #[must_use]
    pub fn restricted(mut self, only: &[Property], keep: &[Property]) -> Self {
        self.0.retain(|property| (only.is_empty() || only.contains(property)) && !keep.contains(property));
        self
    }

    /// Whether `property` may change.
    #[must_use]
    pub fn contains(&self, property: Property) -> bool {
        self.0.contains(&property)
    }

    /// `true` when nothing the paper scales is left behind (a radius may stay: the others then follow from that).
    #[must_use]
    pub fn is_complete(&self) -> bool {
        Self::default().0.iter().all(|&property| property == Property::Radius || self.contains(property))
    }
}

/// Rounding of a few multiplications (relative).
const SAME_VALUE: f64 = 1e-14;

fn in_defaults(force: &crate::model::Force) -> Fault {
    Fault::new(FaultKind::NeedsAnswer {
        code: "parameters-in-defaults",
        question: format!(
            "{} takes its ContactParameters from <defaults>, which may serve other forces too",
            force.path
        ),
        way_out: "write a contact_parameters set into the force itself, then change that".to_owned(),
    })
    .of(force.path.clone())
}

/// A new value and why.
#[derive(Debug, Clone, Copy)]
pub(super) struct New {
    pub to: f64,
    pub factor: Option<f64>,
    pub equation: &'static str,
}

impl New {
    /// `from` times `factor`: multiplied once, and not at all where the factor is exactly 1.
    pub(super) fn times(from: f64, factor: f64, equation: &'static str) -> Self {
        Self { to: if factor == 1.0 { from } else { from * factor }, factor: Some(factor), equation }
    }
}

pub(super) struct Draft<'m, 'd, 'a> {
    pub model: &'m Model<'d, 'a>,
    pub changes: Vec<Change>,
    pub warnings: Vec<Warning>,
    planned: HashSet<Key>,
    pub moves: Vec<Move>,
    pub remarks: Vec<String>,
}

impl<'m, 'd, 'a> Draft<'m, 'd, 'a> {
    pub(super) fn new(model: &'m Model<'d, 'a>) -> Self {
        Self {
            model,
            changes: Vec::new(),
            warnings: Vec::new(),
            planned: HashSet::new(),
            moves: Vec::new(),
            remarks: Vec::new(),
        }
    }

    /// The effective value of a force's property, if it can be scaled.
    pub(super) fn current(&self, force: usize, set: usize, property: Property) -> Result<Option<f64>, Fault> {
        let Some(force) = self.model.forces.get(force) else { return Ok(None) };
        let Some(value) = force.value(set, property) else { return Ok(None) };
        value.checked().map(Some).map_err(|fault| fault.of(force.path.clone()).in_file(force.file))
    }

    /// The effective radius of a sphere, if it can be scaled.
    pub(super) fn current_radius(&self, sphere: usize) -> Result<f64, Fault> {
        let Some(sphere) = self.model.spheres.get(sphere) else {
            return Err(Fault::refused(format!("there is no sphere number {sphere}")));
        };
        sphere.radius.checked().map_err(|fault| fault.of(sphere.path.clone()).in_file(sphere.file))
    }

    /// Plans a change of a force's property in parameter set `set`.
    pub(super) fn parameter(
        &mut self,
        force: usize,
        set: usize,
        property: Property,
        new: New,
    ) -> Result<(), Fault> {
        let Some(force) = self.model.forces.get(force) else { return Ok(()) };
        let own = force.sets.get(set).and_then(|set| set.value(property).map(|value| (set, value)));
        let (value, element, class, index) = match own {
            Some((set, _)) if set.inherited => return Err(in_defaults(force)),
            Some((set, value)) => (value, set.element, set.class, set.index),
            None if force.transition_velocity.property == property => {
                (&force.transition_velocity, force.element, crate::property::Class::HuntCrossleyForce, None)
            }
            None => return Ok(()),
        };
        let change = Change {
            force: Some(force.name.clone()),
            path: force.path.clone(),
            set: index,
            sphere: None,
            property,
            from: value.checked().map_err(|fault| fault.of(force.path.clone()).in_file(force.file))?,
            to: new.to,
            factor: new.factor,
            equation: new.equation,
            line: self.model.file(force.file).line(value.offset),
            inserted: value.span.is_none(),
            file: force.file,
            target: Target { element, class, tag: property.name(), span: value.span.clone() },
        };
        self.push(change, value)
    }

    /// Plans a change of a sphere's radius.
    pub(super) fn radius(&mut self, sphere: usize, new: New) -> Result<(), Fault> {
        let from = self.current_radius(sphere)?;
        let Some(sphere) = self.model.spheres.get(sphere) else { return Ok(()) };
        let value = &sphere.radius;
        let change = Change {
            force: None,
            path: sphere.path.clone(),
            set: None,
            sphere: Some(sphere.name.clone()),
            property: Property::Radius,
            from,
            to: new.to,
            factor: new.factor,
            equation: new.equation,
            line: self.model.file(sphere.file).line(value.offset),
            inserted: value.span.is_none(),
            file: sphere.file,
            target: Target {
                element: sphere.element,
                class: sphere.dialect.class(),
                tag: sphere.dialect.radius_tag(),
                span: value.span.clone(),
            },
        };
        self.push(change, value)
    }

    /// Plans a new location of a sphere's centre.
    pub(super) fn location(
        &mut self,
        sphere: usize,
        to: [f64; 3],
        equation: &'static str,
    ) -> Result<(), Fault> {
        let Some(sphere) = self.model.spheres.get(sphere) else { return Ok(()) };
        let from = sphere.location_m;
        let close = |(a, b): (f64, f64)| (a - b).abs() <= SAME_VALUE * a.abs().max(b.abs());
        if from.into_iter().zip(to).all(close) {
            return Ok(());
        }
        if to.iter().any(|value| !value.is_finite()) {
            return Err(Fault::refused(format!("the new location of {} is not finite", sphere.path)));
        }
        self.refuse_included(sphere.file, &sphere.path)?;
        let document = self.model.file(sphere.file);
        let offset = document.tree().span(sphere.element).start;
        let offset = sphere.location_span.as_ref().map_or(offset, |span| span.start);
        self.moves.push(Move {
            sphere: sphere.name.clone(),
            path: sphere.path.clone(),
            from,
            to,
            equation,
            line: document.line(offset),
            inserted: sphere.location_span.is_none(),
            file: sphere.file,
            target: Target {
                element: sphere.element,
                class: sphere.dialect.class(),
                tag: sphere.dialect.location_tag(),
                span: sphere.location_span.clone(),
            },
        });
        Ok(())
    }

    fn refuse_included(&self, file: usize, path: &str) -> Result<(), Fault> {
        let Some(included) = self.model.included_file(file) else { return Ok(()) };
        Err(Fault::new(FaultKind::NeedsAnswer {
            code: "included-file",
            question: format!("{path} stands in the file '{included}' that the model includes"),
            way_out: "open the model in OpenSim and save it as one file, then change that".to_owned(),
        })
        .of(path))
    }

    fn push(&mut self, change: Change, value: &Value) -> Result<(), Fault> {
        if !change.property.allows(change.to) {
            let kind = FaultKind::Domain {
                property: format!("the new {}", change.property),
                value: change.to,
                expected: change.property.domain(),
            };
            return Err(Fault::at(kind, value.offset).of(change.path).in_file(change.file));
        }
        // A value that is computed anew may differ in its last bits and mean the same; a given one is taken exactly.
        let computed = change.factor.is_none() && change.equation != "given";
        let same = computed && (change.to - change.from).abs() <= SAME_VALUE * change.from.abs();
        if same || change.to.to_bits() == change.from.to_bits() {
            return Ok(());
        }
        self.refuse_included(change.file, &change.path)?;
        if self.planned.insert((change.file, change.target.element, change.property)) {
            self.changes.push(change);
        }
        Ok(())
    }
}
