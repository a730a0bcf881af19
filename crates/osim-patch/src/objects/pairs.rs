//! A force as pairs of one sphere and one half-space, with the values that such a pair alone would need.

use contact_scaling::modulus::SurfaceValues;
use osim_model::{Fault, Force, HalfSpace, Model, ParameterSet, Property, SetId, SphereId, Surfaces};

/// A sphere and a half-space of one force.
pub(crate) struct Pair {
    pub(crate) sphere: SphereId,
    pub(crate) plane: HalfSpace,
    /// Parameters of both surfaces, as one force for the two alone would have them; the transition velocity among them.
    pub(crate) values: Vec<(Property, f64)>,
    /// Whether sphere and half-space have parameters of their own that differ: then the values are composites (A.3).
    pub(crate) is_composite: bool,
}

/// The pairs of `force`, in its order; a sphere on the half-space's own body never meets it.
///
/// # Errors
/// A value that is not a plain number or outside its domain, with its place.
pub(crate) fn pairs(model: &Model, force: &Force) -> Result<Vec<Pair>, Fault> {
    let surfaces = Surfaces::of(force)?;
    let planes: Vec<(&ParameterSet, HalfSpace)> = force
        .sets
        .iter()
        .flat_map(|set| model.planes_of_set(set).into_iter().map(move |plane| (set, plane)))
        .collect();
    let mut pairs = Vec::new();
    for set in &force.sets {
        for &sphere in &set.spheres {
            let Some(own) = model.sphere(sphere).filter(|sphere| !sphere.fixed) else { continue };
            for (plane_set, plane) in &planes {
                if plane.body.is_some() && plane.body == own.body {
                    continue;
                }
                let of = |id| of_set(force, id);
                let (here, there) = (of(set.id)?, of(plane_set.id)?);
                let is_composite = here != there;
                let values = if is_composite {
                    composite(surfaces.together(set.id, plane_set.id)?, &here, &there)
                } else {
                    here
                };
                pairs.push(Pair { sphere, plane: plane.clone(), values, is_composite });
            }
        }
    }
    Ok(pairs)
}

fn of_set(force: &Force, set: SetId) -> Result<Vec<(Property, f64)>, Fault> {
    let mut values = Vec::new();
    for property in Property::ALL {
        if let Some(value) = force.checked(set, property)? {
            values.push((property, value));
        }
    }
    Ok(values)
}

/// Modulus and α by (A.3) and (A.4); of each friction the value that Simbody uses, 2ab/(a + b).
fn composite(
    together: SurfaceValues,
    here: &[(Property, f64)],
    there: &[(Property, f64)],
) -> Vec<(Property, f64)> {
    let both = here.iter().filter_map(|&(property, a)| {
        let (_, b) = there.iter().find(|(known, _)| *known == property)?;
        let value = match property {
            Property::Stiffness => together.plane_strain_modulus,
            Property::Dissipation => together.dissipation,
            Property::StaticFriction | Property::DynamicFriction | Property::ViscousFriction if a != *b => {
                2.0 * a * b / (a + b)
            }
            _ => a,
        };
        Some((property, value))
    });
    both.collect()
}
