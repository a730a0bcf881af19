//! Surfaces with parameters of their own: what they make together, and how to make that a wanted value (A.3).

use contact_scaling::modulus;

use super::draft::{Draft, New};
use crate::error::Fault;
use crate::model::{Force, Model};
use crate::property::Property;

/// Composites this close (relative) are one.
const SAME_COMPOSITE: f64 = 1e-6;

/// Parameter sets that hold moving spheres, with those spheres.
pub(super) fn sphere_sets(model: &Model<'_, '_>, force: &Force) -> Vec<(usize, Vec<usize>)> {
    let moving = |sphere: &usize| model.spheres.get(*sphere).is_some_and(|sphere| !sphere.fixed);
    let sets = force.sets.iter().enumerate();
    sets.map(|(index, set)| (index, set.spheres.iter().copied().filter(moving).collect::<Vec<_>>()))
        .filter(|(_, spheres)| !spheres.is_empty())
        .collect()
}

/// Modulus and dissipation of every parameter set of a force, and which of them the plane belongs to.
pub(super) struct Surfaces {
    sets: Vec<(f64, f64)>,
    plane: Option<usize>,
}

impl Surfaces {
    pub(super) fn of(draft: &Draft<'_, '_, '_>, index: usize, force: &Force) -> Result<Self, Fault> {
        let mut sets = Vec::new();
        for set in 0..force.sets.len() {
            let modulus = draft.current(index, set, Property::Stiffness)?.unwrap_or(f64::NAN);
            let dissipation = draft.current(index, set, Property::Dissipation)?.unwrap_or(0.0);
            sets.push((modulus, dissipation));
        }
        Ok(Self { sets, plane: force.sets.iter().position(|set| set.half_spaces > 0) })
    }

    /// E₁* of two equal surfaces that would touch as set `set` and the plane do, and the mixed α; (A.3), (A.4).
    pub(super) fn with_plane(&self, set: usize) -> Result<(f64, f64), Fault> {
        let own = self.sets.get(set).copied().unwrap_or((f64::NAN, 0.0));
        let plane = self.plane.and_then(|plane| self.sets.get(plane)).copied().unwrap_or(own);
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
pub(super) fn write_composite(
    draft: &mut Draft<'_, '_, '_>,
    index: usize,
    property: Property,
    to: f64,
    equation: &'static str,
) -> Result<(), Fault> {
    let Some(force) = draft.model.forces.get(index) else { return Ok(()) };
    let sets = force.sets.len();
    let mixes = matches!(property, Property::Stiffness | Property::Dissipation);
    if sets < 2 || !mixes {
        for set in 0..sets {
            draft.parameter(index, set, property, New { to, factor: None, equation })?;
        }
        return Ok(());
    }
    let surfaces = Surfaces::of(draft, index, force)?;
    let now = composite_now(draft, force, &surfaces, property)?;
    for set in 0..sets {
        let Some(from) = draft.current(index, set, property)? else { continue };
        let new = if now == 0.0 {
            New { to, factor: None, equation }
        } else {
            New::times(from, to / now, equation)
        };
        draft.parameter(index, set, property, new)?;
    }
    Ok(())
}

fn composite_now(
    draft: &Draft<'_, '_, '_>,
    force: &Force,
    surfaces: &Surfaces,
    property: Property,
) -> Result<f64, Fault> {
    let mut composites = Vec::new();
    for (set, _) in sphere_sets(draft.model, force) {
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
