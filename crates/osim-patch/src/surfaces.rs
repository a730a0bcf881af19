//! Surfaces with parameters of their own: what they make together, and how to make that a wanted value (A.3).

use contact_scaling::modulus;
use osim_model::{Fault, Force, ForceId, Model, Property, SetId, SphereId};

use crate::builder::{New, PlanBuilder};

/// Composites this close (relative) are one.
const SAME_COMPOSITE: f64 = 1e-6;

/// Parameter sets that hold moving spheres, with those spheres.
pub(crate) fn sphere_sets(model: &Model, force: &Force) -> Vec<(SetId, Vec<SphereId>)> {
    let moving = |sphere: &SphereId| model.sphere(*sphere).is_some_and(|sphere| !sphere.fixed);
    let sets = force.sets.iter();
    sets.map(|set| (set.id, set.spheres.iter().copied().filter(moving).collect::<Vec<_>>()))
        .filter(|(_, spheres)| !spheres.is_empty())
        .collect()
}

/// Modulus and dissipation of every parameter set of a force, and which of them the plane belongs to.
pub(crate) struct Surfaces {
    sets: Vec<(f64, f64)>,
    /// The set that the first plane belongs to.
    plane: Option<SetId>,
}

impl Surfaces {
    pub(crate) fn of(plan: &PlanBuilder<'_>, force: &Force) -> Result<Self, Fault> {
        let mut sets = Vec::new();
        for set in force.sets.iter().map(|set| set.id) {
            let modulus = plan.current(force.id, set, Property::Stiffness)?.unwrap_or(f64::NAN);
            let dissipation = plan.current(force.id, set, Property::Dissipation)?.unwrap_or(0.0);
            sets.push((modulus, dissipation));
        }
        Ok(Self { sets, plane: force.sets.iter().find(|set| set.half_spaces > 0).map(|set| set.id) })
    }

    /// E₁* of two equal surfaces that would touch as set `set` and the plane do, and the mixed α; (A.3), (A.4).
    pub(crate) fn with_plane(&self, set: SetId) -> Result<(f64, f64), Fault> {
        self.together(set, self.plane.unwrap_or(set))
    }

    /// The same for the sets `set` and `plane`.
    pub(crate) fn together(&self, set: SetId, plane: SetId) -> Result<(f64, f64), Fault> {
        let own = self.sets.get(set.index()).copied().unwrap_or((f64::NAN, 0.0));
        let plane = self.sets.get(plane.index()).copied().unwrap_or(own);
        if own == plane {
            return Ok(own);
        }
        let surface = |(plane_strain_modulus, dissipation)| modulus::SurfaceValues {
            plane_strain_modulus,
            dissipation,
        };
        let composite = modulus::composite_sherman(own.0, plane.0).map_err(Fault::new)?;
        let equal =
            modulus::of_equal_surfaces(composite, modulus::MixingRule::Sherman).map_err(Fault::new)?;
        let dissipation = modulus::mixed_dissipation(surface(own), surface(plane)).map_err(Fault::new)?;
        Ok((equal, dissipation))
    }
}

/// Plans the wanted value `to` of `property` (E₁* of two equal surfaces, α, or a parameter of the smoothed law).
///
/// Where the surfaces of a force have values of their own, all are multiplied by wanted over now; where α is 0 now,
/// every one gets the wanted α.
pub(crate) fn write_composite(
    plan: &mut PlanBuilder<'_>,
    id: ForceId,
    property: Property,
    to: f64,
    equation: &'static str,
) -> Result<(), Fault> {
    let Some(force) = plan.model.force(id) else { return Ok(()) };
    let sets: Vec<SetId> = force.sets.iter().map(|set| set.id).collect();
    let mixes = matches!(property, Property::Stiffness | Property::Dissipation);
    if sets.len() < 2 || !mixes {
        for set in sets {
            plan.parameter(id, set, property, New { to, factor: None, equation })?;
        }
        return Ok(());
    }
    let surfaces = Surfaces::of(plan, force)?;
    let now = composite_now(plan, force, &surfaces, property)?;
    for set in sets {
        let Some(from) = plan.current(id, set, property)? else { continue };
        let new = if now == 0.0 {
            New { to, factor: None, equation }
        } else {
            New::times(from, to / now, equation)
        };
        plan.parameter(id, set, property, new)?;
    }
    Ok(())
}

fn composite_now(
    plan: &PlanBuilder<'_>,
    force: &Force,
    surfaces: &Surfaces,
    property: Property,
) -> Result<f64, Fault> {
    let mut composites = Vec::new();
    for (set, _) in sphere_sets(plan.model, force) {
        let (modulus, dissipation) = surfaces.with_plane(set)?;
        composites.push(if property == Property::Stiffness { modulus } else { dissipation });
    }
    let first = composites.first().copied().unwrap_or(f64::NAN);
    if composites.iter().any(|other| (other - first).abs() > SAME_COMPOSITE * first.abs()) {
        return Err(Fault::refused(format!(
            "the spheres of {} have different {property} against the plane: one wanted value cannot serve all; \
             give each sphere a force of its own",
            force.path
        ))
        .of(force.path.clone()));
    }
    Ok(first)
}
