//! Contacts as they are to be made: which sphere, on which body, where, with which values.

use osim_model::{Anatomy, AnatomySphere, Fault, FaultKind, ForceKind, Model, Property, Rotation, Selected};

use super::pairs::{Pair, pairs};

/// One contact that a model is to get: a sphere, and the force that presses it on the floor.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct NewContact {
    /// Name of the force.
    pub force: String,
    /// Name of the sphere.
    pub sphere: String,
    /// Name of the body that carries it.
    pub body: String,
    /// Its centre in the frame of that body, m.
    pub location_m: [f64; 3],
    /// Its radius, m.
    pub radius_m: f64,
    /// Class of the force.
    pub kind: ForceKind,
    /// Parameters of the force in their own units; what is missing is OpenSim's default.
    pub values: Vec<(Property, f64)>,
}

impl NewContact {
    /// A contact with a force of `kind`, with OpenSim's defaults for all parameters.
    pub fn new(kind: ForceKind, force: impl Into<String>, sphere: impl Into<String>) -> Self {
        Self {
            force: force.into(),
            sphere: sphere.into(),
            body: String::new(),
            location_m: [0.0; 3],
            radius_m: 0.0,
            kind,
            values: Vec::new(),
        }
    }
}

/// Contacts that a model is to get.
#[derive(Debug, Clone, PartialEq, Default)]
#[non_exhaustive]
pub struct Layout {
    /// The contacts, in the order in which they are written.
    pub contacts: Vec<NewContact>,
    /// Name of the floor where one has to be made; `floor` where it is empty.
    pub floor: String,
}

impl Layout {
    /// The contacts of the forces `selected` of `model`: one for each sphere that meets a half-space, with places in the frames of
    /// bodies.
    ///
    /// # Errors
    /// A value that is not a plain number, or a sphere whose place cannot be read.
    pub fn of(model: &Model, selected: &Selected) -> Result<Self, Fault> {
        let mut layout = Self::default();
        for force in selected.forces.iter().filter_map(|&id| model.force(id)) {
            let pairs = pairs(model, force)?;
            let several = pairs.len() > 1;
            for Pair { sphere, plane, values, .. } in pairs {
                let Some(own) = model.sphere(sphere) else { continue };
                let Some(body) = own.body.clone() else { continue };
                let place = model.centre_m(sphere).ok_or_else(|| {
                    Fault::refused(format!("the place of {} on its body cannot be read", own.path))
                        .of(own.path.clone())
                })?;
                if layout.floor.is_empty() {
                    layout.floor = plane.name.clone();
                }
                layout.contacts.push(NewContact {
                    force: if several { format!("{}_{}", force.name, own.name) } else { force.name.clone() },
                    sphere: own.name.clone(),
                    body,
                    location_m: place,
                    radius_m: own.radius_m()?,
                    kind: force.kind,
                    values,
                });
            }
        }
        Ok(layout)
    }

    /// Refuses values that must not be written again.
    ///
    /// # Errors
    /// A `constant_contact_force` of 0 ([`FaultKind::ZeroConstantContactForce`]), with the name of its force.
    pub fn check(&self) -> Result<(), Fault> {
        let zero = |contact: &&NewContact| contact.values.contains(&(Property::ConstantContactForce, 0.0));
        match self.contacts.iter().find(zero) {
            Some(contact) => Err(Fault::new(FaultKind::ZeroConstantContactForce).of(contact.force.clone())),
            None => Ok(()),
        }
    }

    /// `anatomy` with the spheres of this layout in the place of its own.
    #[must_use]
    pub fn anatomy(&self, anatomy: Anatomy) -> Anatomy {
        let spheres = self.contacts.iter().map(|contact| {
            AnatomySphere::new(
                contact.sphere.clone(),
                Some(contact.body.clone()),
                (contact.location_m, contact.radius_m),
                Rotation::IDENTITY,
            )
        });
        anatomy.with_spheres(spheres.collect())
    }
}
