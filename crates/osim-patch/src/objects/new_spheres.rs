//! Where the spheres are that a plan adds, once it was carried out.

use foldhash::HashMap;
use osim_model::{Property, SphereId};

use super::rebuilt::Deed;
use crate::plan::Plan;

/// A sphere that a plan adds.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct NewSphere<'p> {
    /// Its name.
    pub name: &'p str,
    /// Its component path.
    pub path: &'p str,
    /// Name of the body that carries it.
    pub body: &'p str,
    /// Its centre in the frame of that body, m.
    pub centre_m: [f64; 3],
    /// Its radius, m.
    pub radius_m: f64,
}

impl Plan {
    /// The spheres that are added, with the places and radii that are written.
    #[must_use]
    pub fn new_spheres(&self) -> Vec<NewSphere<'_>> {
        let Some(rebuilt) = &self.rebuilt else { return Vec::new() };
        let built = rebuilt.model();
        let ids: HashMap<&str, SphereId> =
            built.spheres().iter().map(|sphere| (sphere.path.as_str(), sphere.id)).collect();
        let moved: HashMap<&str, [f64; 3]> =
            self.moves.iter().map(|place| (place.path.as_str(), place.to)).collect();
        let radii = self.changes.iter().filter(|change| change.property == Property::Radius);
        let radii: HashMap<&str, f64> = radii.map(|change| (change.path.as_str(), change.to)).collect();
        let added = rebuilt.objects.iter().filter(|object| object.deed == Deed::Added);
        let spheres = added.filter_map(|object| {
            let id = *ids.get(object.path.as_str())?;
            let path = object.path.as_str();
            Some(NewSphere {
                name: &object.name,
                path,
                body: object.body.as_deref()?,
                // New spheres are placed in the frames of bodies.
                centre_m: moved.get(path).copied().or_else(|| built.centre_m(id))?,
                radius_m: radii.get(path).copied().or_else(|| built.sphere(id)?.radius_m().ok())?,
            })
        });
        spheres.collect()
    }
}
