//! Surfaces with parameters of their own: how to make what they are together a wanted value (A.3).

use contact_scaling::modulus::SurfaceValues;
use osim_model::{Fault, Force, ForceId, Property, SetId, Surfaces, sphere_sets};

use crate::builder::{New, PlanBuilder};

/// Composites this close (relative) are one.
const SAME_COMPOSITE: f64 = 1e-6;

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
    let surfaces = Surfaces::of(force)?;
    let now = composite_now(plan, force, &surfaces, property)?;
    for set in sets {
        let Some(from) = force.checked(set, property)? else { continue };
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
        let SurfaceValues { plane_strain_modulus, dissipation } = surfaces.with_plane(set)?;
        composites.push(if property == Property::Stiffness { plane_strain_modulus } else { dissipation });
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
