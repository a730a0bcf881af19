//! Collects the changes of a plan. Each number is checked, and changed at most once; the three radii of an ellipsoid get one factor.

use contact_scaling::Ratios;
use contact_scaling::modulus::SurfaceValues;
use foldhash::{HashSet, HashSetExt};
use osim_model::messages::Phrase;
use osim_model::{
    DissipationBy, Fault, FaultKind, FileId, Finding, Force, ForceId, HalfSpace, Model, Property, Result,
    SetId, Slot, Sphere, SphereId, Surfaces, ValueKey, radius_of_equal_volume, sphere_sets,
};

use crate::change::{ChangedBy, NumberChange, PlaceChange, property_factor};

/// Relative rounding error of a product of a few numbers.
const ROUNDING_OF_FACTORS: f64 = 1e-14;

/// A new value, with its factor and the rule that gives it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct NewNumber {
    pub(crate) to: f64,
    pub(crate) factor: Option<f64>,
    pub(crate) by: ChangedBy,
}

impl NewNumber {
    /// `from` times `factor`; exactly `from` if the factor is 1.
    pub(crate) fn multiplied(from: f64, factor: f64, by: ChangedBy) -> Self {
        Self { to: if factor == 1.0 { from } else { from * factor }, factor: Some(factor), by }
    }
}

/// Collects the changes of a model's numbers and places for a plan.
pub(crate) struct PlanBuilder<'m> {
    pub(crate) model: &'m Model,
    pub(crate) changes: Vec<NumberChange>,
    pub(crate) findings: Vec<Finding>,
    planned: HashSet<ValueKey>,
    pub(crate) moves: Vec<PlaceChange>,
    pub(crate) remarks: Vec<Phrase>,
}

impl<'m> PlanBuilder<'m> {
    /// No changes yet.
    pub(crate) fn new(model: &'m Model) -> Self {
        Self {
            model,
            changes: Vec::new(),
            findings: Vec::new(),
            planned: HashSet::new(),
            moves: Vec::new(),
            remarks: Vec::new(),
        }
    }

    /// Plans a change of a force's property in parameter set `set`.
    pub(crate) fn change_parameter(
        &mut self,
        force: ForceId,
        set: SetId,
        property: Property,
        new: NewNumber,
    ) -> Result<()> {
        let Some(force) = self.model.force(force) else { return Ok(()) };
        let of_set = force.set(set).filter(|set| set.value(property).is_some());
        if of_set.is_some_and(|set| set.inherited) {
            let kind = FaultKind::ParametersInDefaults { force: force.path.clone() };
            return Err(Fault::new(kind).at_element(force.path.clone()));
        }
        let (Some(slot), Some(from)) = (force.slot_of_property(set, property), force.checked(set, property)?)
        else {
            return Ok(());
        };
        self.push(NumberChange {
            force: Some(force.name.clone()),
            path: force.path.clone(),
            set: of_set.and_then(|set| set.number),
            sphere: None,
            radii_m: None,
            property,
            from,
            to: new.to,
            factor: new.factor,
            by: new.by,
            line: self.model.file(force.file).position(slot.offset).line,
            inserted: slot.span.is_none(),
            slot,
        })
    }

    /// Plans a change of a sphere's radius.
    pub(crate) fn change_radius(&mut self, sphere: SphereId, new: NewNumber) -> Result<()> {
        let from = self.model.radius_m(sphere)?;
        let Some(sphere) = self.model.sphere(sphere) else { return Ok(()) };
        let slot = sphere.radius_slot();
        let factor = new.factor.unwrap_or(new.to / from);
        let radii_m = sphere.radii_m.map(|radii| [radii, radii.map(|radius| radius * factor)]);
        // As it is read again.
        let to = radii_m.map_or(new.to, |[_, radii]| radius_of_equal_volume(radii));
        self.push(NumberChange {
            force: None,
            path: sphere.path.clone(),
            set: None,
            sphere: Some(sphere.name.clone()),
            radii_m,
            property: Property::Radius,
            from,
            to,
            factor: new.factor,
            by: new.by,
            line: self.line_of_slot(&slot),
            inserted: slot.span.is_none(),
            slot,
        })
    }

    /// Plans a new location of a sphere's centre.
    pub(crate) fn move_sphere(&mut self, sphere: SphereId, to: [f64; 3], by: ChangedBy) -> Result<()> {
        let Some(sphere) = self.model.sphere(sphere) else { return Ok(()) };
        let from = sphere.location_m;
        let close = |(a, b): (f64, f64)| (a - b).abs() <= ROUNDING_OF_FACTORS * a.abs().max(b.abs());
        if from.into_iter().zip(to).all(close) {
            return Ok(());
        }
        let slot = sphere.location_slot();
        self.add_move((sphere.name.clone(), sphere.path.clone()), (from, to), by, slot)
    }

    /// Plans a new location of a half-space in its own frame, m.
    pub(crate) fn move_half_space(&mut self, plane: &HalfSpace, to: [f64; 3], by: ChangedBy) -> Result<()> {
        let from = plane.location_m.unwrap_or_default();
        if from == to {
            return Ok(());
        }
        let slot = plane.location_slot.clone();
        self.add_move((plane.name.clone(), plane.path.clone()), (from, to), by, slot)
    }

    /// Adds a new place of a sphere or half-space.
    fn add_move(
        &mut self,
        (geometry, path): (String, String),
        (from, to): ([f64; 3], [f64; 3]),
        by: ChangedBy,
        slot: Slot,
    ) -> Result<()> {
        refuse_included(self.model, slot.file, &path)?;
        let (line, inserted) = (self.line_of_slot(&slot), slot.span.is_none());
        let planned = PlaceChange { geometry, path, from, to, by, line, inserted, slot };
        planned.text()?;
        self.moves.push(planned);
        Ok(())
    }

    fn line_of_slot(&self, slot: &Slot) -> usize {
        self.model.file(slot.file).position(slot.offset).line
    }

    /// Adds a change, unless the number stays.
    fn push(&mut self, change: NumberChange) -> Result<()> {
        change.check()?;
        // A value that is computed again may differ in its last bits and mean the same; a given one is taken exactly.
        let computed = change.factor.is_none() && change.by != ChangedBy::Given;
        let same = computed && (change.to - change.from).abs() <= ROUNDING_OF_FACTORS * change.from.abs();
        if same || change.to.to_bits() == change.from.to_bits() {
            return Ok(());
        }
        if change.property == Property::ConstantContactForce && change.to == 0.0 {
            return Err(change.at(Fault::new(FaultKind::ZeroConstantContactForce)));
        }
        refuse_included(self.model, change.slot.file, &change.path)?;
        if self.planned.insert(ValueKey::from((&change.slot, change.property))) {
            self.changes.push(change);
        }
        Ok(())
    }

    /// Changes `property` in each set of `force` that has it, and says whether one has it.
    pub(crate) fn change_in_all_sets(
        &mut self,
        force: &Force,
        property: Property,
        new: impl Fn(f64) -> NewNumber,
    ) -> Result<bool> {
        let mut found = false;
        for set in &force.sets {
            if let Some(from) = force.checked(set.id, property)? {
                self.change_parameter(force.id, set.id, property, new(from))?;
                found = true;
            }
        }
        Ok(found)
    }
}

/// Refuses a change of the element `path` if it is in a file that the model includes.
pub(crate) fn refuse_included(model: &Model, file: FileId, path: &str) -> Result<()> {
    let Some(included) = model.included_file(file) else { return Ok(()) };
    let kind = FaultKind::IncludedFile { path: path.to_owned(), file: included.to_owned() };
    Err(Fault::new(kind).at_element(path))
}

/// Changes a property that has no value of its own by the factor that follows from the new radius; `own` has the ratios of this model's new
/// radii to its old ones.
pub(crate) fn scale_with_radius(
    plan: &mut PlanBuilder<'_>,
    force: &Force,
    property: Property,
    own: &Ratios,
    by: DissipationBy,
) -> Result<()> {
    let Some((factor, by)) = property_factor(property, own, by) else { return Ok(()) };
    plan.change_in_all_sets(force, property, |from| NewNumber::multiplied(from, factor, by)).map(drop)
}

/// Two composite values are equal if their relative difference is at most this.
const SAME_COMPOSITE_TOLERANCE: f64 = 1e-6;

/// Plans the value `to` of `property`: E₁* of two equal surfaces, α, or a parameter of the smoothed law.
///
/// If the surfaces of a force have different values, each is multiplied by the wanted composite value divided by the present one.
/// If the present α is 0, all surfaces get the wanted α.
pub(crate) fn change_composite(
    plan: &mut PlanBuilder<'_>,
    id: ForceId,
    property: Property,
    to: f64,
    by: ChangedBy,
) -> Result<()> {
    let Some(force) = plan.model.force(id) else { return Ok(()) };
    let sets: Vec<SetId> = force.sets.iter().map(|set| set.id).collect();
    let mixes = matches!(property, Property::Stiffness | Property::Dissipation);
    if sets.len() < 2 || !mixes {
        for set in sets {
            plan.change_parameter(id, set, property, NewNumber { to, factor: None, by })?;
        }
        return Ok(());
    }
    let surfaces = Surfaces::of(force)?;
    let now = present_composite(plan.model, force, &surfaces, property)?;
    for set in sets {
        let Some(from) = force.checked(set, property)? else { continue };
        let new = if now == 0.0 {
            NewNumber { to, factor: None, by }
        } else {
            NewNumber::multiplied(from, to / now, by)
        };
        plan.change_parameter(id, set, property, new)?;
    }
    Ok(())
}

/// The present parameter that a force reads for both surfaces together: E₁* of two equal surfaces, or α.
fn present_composite(model: &Model, force: &Force, surfaces: &Surfaces, property: Property) -> Result<f64> {
    let pairs = model.sphere_pairs(force);
    let contacts: Result<Vec<SurfaceValues>> = if pairs.is_empty() {
        sphere_sets(model, force).into_iter().map(|(set, _)| surfaces.with_plane(set)).collect()
    } else {
        let set_with = |sphere: &Sphere| {
            force.sets.iter().find(|set| set.spheres.contains(&sphere.id)).map(|set| set.id)
        };
        let sets = pairs.into_iter().filter_map(|[one, other]| set_with(one).zip(set_with(other)));
        sets.map(|(one, other)| surfaces.mixed(one, other)).collect()
    };
    let mut composites = Vec::new();
    for SurfaceValues { plane_strain_modulus, dissipation } in contacts? {
        composites.push(if property == Property::Stiffness { plane_strain_modulus } else { dissipation });
    }
    let first = composites.first().copied().unwrap_or(f64::NAN);
    if composites.iter().any(|other| (other - first).abs() > SAME_COMPOSITE_TOLERANCE * first.abs()) {
        return Err(Fault::refused(format!(
            "the spheres of {} have different {property} against their other surface: one wanted value cannot serve all; \
             give each sphere a force of its own",
            force.path
        ))
        .at_element(force.path.clone()));
    }
    Ok(first)
}
