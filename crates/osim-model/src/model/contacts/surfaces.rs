//! Surfaces with parameters of their own, and what they make together (A.3).

use contact_scaling::modulus::{self, SurfaceValues};

use super::{Force, SetId, SphereId};
use crate::model::{Fault, Model, Property};

/// Parameter sets that hold moving spheres, with those spheres.
#[must_use]
pub fn sphere_sets(model: &Model, force: &Force) -> Vec<(SetId, Vec<SphereId>)> {
    let moving = |sphere: &SphereId| model.sphere(*sphere).is_some_and(|sphere| !sphere.fixed);
    let sets = force.sets.iter();
    sets.map(|set| (set.id, set.spheres.iter().copied().filter(moving).collect::<Vec<_>>()))
        .filter(|(_, spheres)| !spheres.is_empty())
        .collect()
}

/// Modulus and dissipation of every parameter set of a force, and which of them the plane belongs to.
pub struct Surfaces {
    sets: Vec<SurfaceValues>,
    /// The set that the first plane belongs to.
    plane: Option<SetId>,
}

impl Surfaces {
    /// Reads them.
    ///
    /// # Errors
    /// A value that is not a plain number or outside its domain.
    pub fn of(force: &Force) -> Result<Self, Fault> {
        let mut sets = Vec::new();
        for set in force.sets.iter().map(|set| set.id) {
            let plane_strain_modulus = force.checked(set, Property::Stiffness)?.unwrap_or(f64::NAN);
            let dissipation = force.checked(set, Property::Dissipation)?.unwrap_or(0.0);
            sets.push(SurfaceValues { plane_strain_modulus, dissipation });
        }
        Ok(Self { sets, plane: force.sets.iter().find(|set| set.half_spaces > 0).map(|set| set.id) })
    }

    /// E₁* of two equal surfaces that would touch as set `set` and the plane do, and the mixed α; (A.3), (A.4).
    ///
    /// # Errors
    /// A modulus that no material has.
    pub fn with_plane(&self, set: SetId) -> Result<SurfaceValues, Fault> {
        self.together(set, self.plane.unwrap_or(set))
    }

    /// The same for the sets `set` and `plane`.
    ///
    /// # Errors
    /// A modulus that no material has.
    pub fn together(&self, set: SetId, plane: SetId) -> Result<SurfaceValues, Fault> {
        const NONE: SurfaceValues = SurfaceValues { plane_strain_modulus: f64::NAN, dissipation: 0.0 };
        let own = self.sets.get(set.index()).copied().unwrap_or(NONE);
        let plane = self.sets.get(plane.index()).copied().unwrap_or(own);
        if own == plane {
            return Ok(own);
        }
        let composite = modulus::composite_sherman(own.plane_strain_modulus, plane.plane_strain_modulus)
            .map_err(Fault::new)?;
        let plane_strain_modulus =
            modulus::of_equal_surfaces(composite, modulus::MixingRule::Sherman).map_err(Fault::new)?;
        let dissipation = modulus::mixed_dissipation(own, plane).map_err(Fault::new)?;
        Ok(SurfaceValues { plane_strain_modulus, dissipation })
    }
}
