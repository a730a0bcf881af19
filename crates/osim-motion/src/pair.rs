//! Contact pairs: a sphere, and the plane or other sphere that it can touch in one force.

use contact_scaling::{Friction, FrictionValues, Law};
use osim_model::{
    DVec3, Fault, Force, ForceId, ForceKind, HalfSpace, Model, Property, Result, SetId, Sphere, SphereId,
    Surfaces, contact_of_pair,
};

/// The surface that a sphere can touch: a plane or another sphere.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TouchedSurface {
    /// A plane; its index among all planes of the forces.
    Plane(usize),
    /// Another sphere of the same force.
    Sphere(SphereId),
}

/// A sphere, and the plane or other sphere that it can touch in one force.
#[derive(Debug, Clone)]
pub struct ContactPair {
    pub force: ForceId,
    pub sphere: SphereId,
    pub set: SetId,
    pub touched: TouchedSurface,
    /// Whether the touched surface belongs to the ground: a plane, or a sphere that cannot move.
    pub is_ground: bool,
    /// Whether OpenSim computes the force (`appliesForce`).
    pub applies: bool,
    pub radius_m: f64,
    pub law: Law,
    pub friction: Friction,
    /// `constant_contact_force`, which a `SmoothSphereHalfSpaceForce` adds to the squared slip speed; `None` for a
    /// `HuntCrossleyForce`.
    pub smoothing: Option<f64>,
    /// Depth of the point where the force acts below the touched surface, divided by the indentation: 1/2 for equal surfaces.
    pub depth_share: f64,
    /// The body to which the sphere is attached.
    pub body: String,
    /// Centre of the sphere in the frame of its body, m.
    pub(crate) centre_m: DVec3,
}

/// All contact pairs of moving spheres in `forces`, and the planes, each once. Two moving spheres that can touch are two pairs.
pub(crate) fn contact_pairs(model: &Model, forces: &[ForceId]) -> Result<(Vec<ContactPair>, Vec<HalfSpace>)> {
    let (mut pairs, mut planes): (Vec<ContactPair>, Vec<HalfSpace>) = (Vec::new(), Vec::new());
    for force in forces.iter().filter_map(|&id| model.force(id)) {
        let surfaces = Surfaces::of(force)?;
        for (set, spheres) in osim_model::sphere_sets(model, force) {
            for other in &force.sets {
                let builder = PairBuilder { model, force, surfaces: &surfaces, set, other_set: other.id };
                for plane in model.planes_of_set(other) {
                    let number = planes.iter().position(|known| *known == plane).unwrap_or_else(|| {
                        planes.push(plane.clone());
                        planes.len() - 1
                    });
                    // Surfaces of one body never touch.
                    let moving = spheres.iter().filter_map(|&id| model.sphere(id));
                    for sphere in moving.filter(|sphere| sphere.body.is_some() && sphere.body != plane.body) {
                        pairs.push(builder.build(sphere, TouchedSurface::Plane(number))?);
                    }
                }
                for touched in other.spheres.iter().filter_map(|&id| model.sphere(id)) {
                    let moving = spheres.iter().filter_map(|&id| model.sphere(id));
                    for sphere in moving.filter(|sphere| sphere.body.is_some() && sphere.body != touched.body)
                    {
                        pairs.push(builder.build(sphere, TouchedSurface::Sphere(touched.id))?);
                    }
                }
            }
        }
    }
    Ok((pairs, planes))
}

/// Makes the contact pairs of two parameter sets of a force.
struct PairBuilder<'m> {
    model: &'m Model,
    force: &'m Force,
    surfaces: &'m Surfaces,
    set: SetId,
    other_set: SetId,
}

impl PairBuilder<'_> {
    /// The contact pair of a sphere and what it touches.
    fn build(&self, sphere: &Sphere, touched: TouchedSurface) -> Result<ContactPair> {
        let Self { model, force, set, .. } = *self;
        let at_force = |error: contact_scaling::DomainError| Fault::new(error).at_element(force.path.clone());
        let contact = contact_of_pair(force, self.surfaces, set, self.other_set)?;
        let radius_m = sphere.round_radius_m()?;
        let other = match touched {
            TouchedSurface::Sphere(id) => model.sphere(id),
            TouchedSurface::Plane(_) => None,
        };
        // Of two spheres, the curvatures add up.
        let curved_m = match other {
            Some(other) => 1.0 / (1.0 / radius_m + 1.0 / other.round_radius_m()?),
            None => radius_m,
        };
        let unread = || Fault::refused(format!("the place of sphere {} cannot be read", sphere.path));
        Ok(ContactPair {
            force: force.id,
            sphere: sphere.id,
            set,
            touched,
            is_ground: other.is_none_or(|other| other.fixed),
            applies: force.applies,
            radius_m,
            law: Law::of(&contact, curved_m).map_err(at_force)?,
            friction: Friction::new(self.friction()?).map_err(at_force)?,
            smoothing: contact.smoothing().map(|smoothing| smoothing.constant_contact_force),
            depth_share: self.depth_share()?,
            body: sphere.body.clone().unwrap_or_default(),
            centre_m: model.centre_m(sphere.id).ok_or_else(unread)?,
        })
    }

    /// Friction coefficients of the sphere and the plane together.
    fn friction(&self) -> Result<FrictionValues> {
        let value = |set, property| Ok::<f64, Fault>(self.force.checked(set, property)?.unwrap_or(0.0));
        let mixed = |property| {
            let (own, other) = (value(self.set, property)?, value(self.other_set, property)?);
            Ok::<f64, Fault>(Friction::mixed(own, other))
        };
        Ok(FrictionValues {
            static_friction: mixed(Property::StaticFriction)?,
            dynamic_friction: mixed(Property::DynamicFriction)?,
            viscous_friction: mixed(Property::ViscousFriction)?,
            transition_velocity: value(self.set, Property::TransitionVelocity)?,
        })
    }

    /// Depth of the point where the force acts, divided by the indentation. In Simbody this point is nearer to the stiffer
    /// surface: k^(2/3) of the sphere divided by the sum for both surfaces.
    fn depth_share(&self) -> Result<f64> {
        if self.force.kind != ForceKind::HuntCrossley || self.set == self.other_set {
            return Ok(0.5);
        }
        let stiffness = |set| Ok::<f64, Fault>(self.force.checked(set, Property::Stiffness)?.unwrap_or(0.0));
        let two_thirds = |value: f64| libm::cbrt(value * value);
        let (own, plane) = (two_thirds(stiffness(self.set)?), two_thirds(stiffness(self.other_set)?));
        Ok(own / (own + plane))
    }
}
