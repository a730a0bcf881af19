//! Sets properties to values, or multiplies them by factors. No other property changes.

use foldhash::HashMap;
use osim_model::messages::{Verb, phrase};
use osim_model::{
    Assignment, Fault, HalfSpace, Mass, MissingFact, Model, Property, RadiusChangeReason, Result, Selected,
    SphereId, moving_spheres,
};

use crate::builder::{NewNumber, PlanBuilder};
use crate::change::{ChangedBy, PlaceChange};
use crate::new_radii::ForcesOutsideChange;
use crate::note_edits::NotedMass;
use crate::plan::{Masses, NoteFacts, Plan};
use crate::rules::{self, REMARK_LEVEL_FEET};

/// The last word in the note's operation if feet were also made level.
const LEVEL_SUFFIX: &str = " level";

impl NewNumber {
    /// The result of applying `assignment` to a value.
    fn assigned(assignment: Assignment, from: f64, by: ChangedBy) -> Self {
        match assignment {
            Assignment::Value(to) => Self { to, factor: None, by },
            Assignment::Factor(factor) => Self::multiplied(from, factor, by),
        }
    }
}

/// The values and factors to set.
///
/// ```
/// use osim_model::{Assignment, Model, Property, Selection};
/// use osim_patch::{Set, set};
///
/// # let bytes: &[u8] = include_bytes!("../../osim-model/tests/data/one_foot.osim");
/// let model = Model::parse(bytes)?;
/// let selected = Selection::default().apply(&model)?;
/// // <stiffness>1000000</stiffness> twice as large; <dissipation> becomes 1 s/m.
/// let wanted = Set::new(vec![
///     (Property::Stiffness, Assignment::Factor(2.0)),
///     (Property::Dissipation, Assignment::Value(1.0)),
/// ]);
/// assert_eq!(wanted.operation(), "set stiffness=x2 dissipation=1");
/// let plan = set(&model, &selected, &wanted)?;
/// let changes: Vec<_> = plan.changes.iter().map(|change| (change.from, change.to, change.by.as_str())).collect();
/// assert_eq!(changes, [(1e6, 2e6, "given"), (2.0, 1.0, "given")]);
/// # Ok::<(), osim_model::Fault>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Set {
    pub assignments: Vec<(Property, Assignment)>,
    /// New centres of spheres for level feet, in their own frames, m; `None` if they stay.
    pub level: Option<Vec<(SphereId, [f64; 3])>>,
    /// Fitted centres of spheres, in their own frames, m.
    pub centres: Vec<(SphereId, [f64; 3])>,
    /// Half-spaces with their new places in their frames, m.
    pub planes: Vec<(HalfSpace, [f64; 3])>,
    /// Text of the note about the recordings, if the values were fitted to recordings; `None` if the caller gave the values.
    pub fitted: Option<String>,
    /// The mass that the contacts are made for after the change, kg; `None` if it stays.
    pub made_for_kg: Option<f64>,
    /// The mass that the contacts were made for, if known; it stays unless `made_for_kg` differs.
    pub contacts_mass: Option<Mass>,
    /// Whether to apply factors again to a file whose note records that they were applied already.
    pub repeat: bool,
}

impl Set {
    /// A change by `assignments`, without a known mass.
    pub fn new(assignments: Vec<(Property, Assignment)>) -> Self {
        Self { assignments, ..Self::default() }
    }

    /// The operation in the note: `set stiffness=x2 dissipation=1`, with `level` at the end if feet are made level.
    pub fn operation(&self) -> String {
        if let Some(fitted) = &self.fitted {
            return format!("fit {fitted}");
        }
        let level = self.level.as_ref().map_or("", |_| LEVEL_SUFFIX);
        format!("{}{level}", self.assigned())
    }

    /// The operation in the note, without `level`.
    fn assigned(&self) -> String {
        let each = self.assignments.iter().map(|(property, value)| format!(" {property}={value}"));
        format!("set{}", each.collect::<String>())
    }
}

/// Whether the note records that the same values were assigned already. All changes since the last whole rescaling count, because
/// none may be applied twice without a question. Level feet stay level if the operation is repeated.
fn is_assigned_already(model: &Model, wanted: &Set) -> bool {
    let steps = model.note.iter().flat_map(|note| note.steps.iter().rev());
    let mut of_set = steps.take_while(|step| step.verb() == Some(Verb::Set)).map(|step| &*step.operation);
    of_set.any(|one| one.strip_suffix(LEVEL_SUFFIX).unwrap_or(one) == wanted.assigned())
}

/// Plans the assignments to the forces `selected` of `model`; no other property changes with them: see [`Set`] for an example.
///
/// # Errors
/// - A value outside the domain of its property, a property that none of the forces has, and the errors of
///   [`rescale`](crate::rescale) that are about values and shared spheres.
/// - A factor that was applied already, by the note in the file ([`MissingFact::Repetition`]).
pub fn set(model: &Model, selected: &Selected, wanted: &Set) -> Result<Plan> {
    let operation = wanted.operation();
    let relative = wanted.assignments.iter().any(|(_, value)| matches!(value, Assignment::Factor(_)));
    if relative && !wanted.repeat && is_assigned_already(model, wanted) {
        return Err(Fault::new(MissingFact::Repetition { operation }));
    }
    let users = ForcesOutsideChange::find(model, &selected.forces);
    let mut plan = PlanBuilder::new(model);
    let by = if wanted.fitted.is_some() { ChangedBy::Fit } else { ChangedBy::Given };
    for &(property, value) in &wanted.assignments {
        let mut found = false;
        if property == Property::Radius {
            for sphere in moving_spheres(model, &selected.forces) {
                let from = match value {
                    Assignment::Value(_) => model.round_radius_m(sphere)?,
                    Assignment::Factor(_) => model.radius_m(sphere)?,
                };
                if NewNumber::assigned(value, from, by).to != from {
                    users.refuse_change(model, &selected.forces, sphere, RadiusChangeReason::Assignment)?;
                }
                plan.change_radius(sphere, NewNumber::assigned(value, from, by))?;
                found = true;
            }
        } else {
            for force in selected.forces.iter().filter_map(|&id| model.force(id)) {
                found |=
                    plan.change_in_all_sets(force, property, |from| NewNumber::assigned(value, from, by))?;
            }
        }
        if !found {
            return Err(Fault::refused(format!("none of the chosen forces has a {property}")));
        }
    }
    for &(sphere, location_m) in wanted.level.iter().flatten() {
        users.refuse_change(model, &selected.forces, sphere, RadiusChangeReason::Level)?;
        plan.move_sphere(sphere, location_m, ChangedBy::Level)?;
    }
    let is_level = !plan.moves.is_empty();
    for &(sphere, location_m) in &wanted.centres {
        users.refuse_change(model, &selected.forces, sphere, RadiusChangeReason::Fit)?;
        plan.move_sphere(sphere, location_m, ChangedBy::Fit)?;
    }
    for (plane, location_m) in &wanted.planes {
        plan.move_half_space(plane, *location_m, ChangedBy::Fit)?;
    }
    let PlanBuilder { changes, moves, mut findings, .. } = plan;
    if changes.is_empty() && moves.is_empty() {
        findings.push(rules::nothing_to_change("every value is already as wanted"));
    }
    let mut taken = phrase![];
    if let Some(mass) = &wanted.contacts_mass {
        taken.push(&mass.contacts_made_for());
        taken.push("; ");
    }
    taken.push(format!("{operation}; no other property changes"));
    let remarks = if is_level { vec![REMARK_LEVEL_FEET.into()] } else { vec![] };
    let mut masses = wanted.contacts_mass.clone().map(Masses::unchanged);
    if let Some((masses, kg)) = masses.as_mut().zip(wanted.made_for_kg) {
        masses.target_mass_kg = kg;
    }
    let kept = NotedMass::of(model, wanted.contacts_mass.as_ref());
    let made = NotedMass { kg: wanted.made_for_kg.or(kept.kg), ..kept };
    let gravity_m_s2 = model.contacts_gravity();
    Ok(Plan::new(
        model,
        Plan { changes, moves, masses, taken, findings, remarks, ..Plan::default() },
        &NoteFacts { made, gravity_m_s2, operation: &operation, followed: None },
    ))
}

impl Plan {
    /// Moves the centres of spheres to `places` in their own frames, m, instead of the planned locations. `model` is the
    /// model for which the plan was made.
    ///
    /// # Errors
    /// A place that is not finite, or a sphere of an included file.
    pub fn level(&mut self, model: &Model, places: &[(SphereId, [f64; 3])]) -> Result<()> {
        if places.is_empty() {
            return Ok(());
        }
        let ground = self.base_model(model);
        let path = |sphere: SphereId| ground.sphere(sphere).map(|sphere| sphere.path.clone());
        let paths: Vec<String> = places.iter().filter_map(|&(sphere, _)| path(sphere)).collect();
        let mut builder = PlanBuilder::new(ground);
        for &(sphere, location_m) in places {
            builder.move_sphere(sphere, location_m, ChangedBy::Level)?;
        }
        let old = self.moves.iter().filter(|old| !paths.contains(&old.path)).cloned();
        let mut moves: Vec<PlaceChange> = old.chain(builder.moves).collect();
        moves.sort_by_key(|one| (one.slot.file, one.slot.offset));
        let moved: HashMap<&str, [f64; 3]> = moves.iter().map(|one| (one.path.as_str(), one.to)).collect();
        let places = ground.places_digest(|sphere| moved.get(sphere.path.as_str()).copied());
        self.moves = moves;
        if let Some(note) = &mut self.note {
            note.places = Some(places);
        }
        self.remarks.push(REMARK_LEVEL_FEET.into());
        Ok(())
    }
}
