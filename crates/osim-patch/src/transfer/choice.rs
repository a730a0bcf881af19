//! Which contact of a reference each sphere of a model gets.

use contact_scaling::{DimensionlessContact, Scale, ScaleValues};
use osim_model::{Fault, FaultKind, Force, Model, Needed, Selected, SphereId};

use super::request::{Reference, ReferenceContact, Transfer};
use crate::radii::moving_spheres;
use crate::surfaces::sphere_sets;

/// Two dimensionless contacts this close (relative) are one.
const SAME_CONTACT: f64 = 1e-6;
/// Comparing contacts of one model needs some gravity, and any will do: it cancels.
const ANY_GRAVITY: f64 = 9.80665;

/// Which contact of the reference each sphere gets.
pub(crate) enum Choice<'t> {
    One(&'t ReferenceContact),
    /// The contact of one sphere, which says the radius too, m.
    Named {
        contact: &'t ReferenceContact,
        radius_m: f64,
    },
    /// By sphere name; every moving sphere of the chosen forces is in it.
    Paired {
        first: &'t ReferenceContact,
        all: &'t [ReferenceContact],
    },
}

impl<'t> Choice<'t> {
    pub(crate) fn make(model: &Model, selected: &Selected, wanted: &'t Transfer) -> Result<Self, Fault> {
        let contacts = &wanted.reference.contacts;
        let Some(first) = contacts.first() else {
            return Err(Fault::refused(format!(
                "the reference {} has no contacts to take",
                wanted.reference.name
            )));
        };
        if let Some(name) = &wanted.reference_sphere {
            let named = contacts.iter().find_map(|contact| {
                let radius_m = contact.radius_of(name)?;
                Some(Self::Named { contact, radius_m })
            });
            return named.ok_or_else(|| {
                let known = contacts.iter().flat_map(|contact| &contact.spheres).cloned().collect();
                let reference = wanted.reference.name.clone();
                Fault::new(FaultKind::UnknownReferenceSphere { sphere: name.clone(), reference, known })
            });
        }
        if wanted.follow.is_some() {
            // Following has matched every sphere by its name already.
            return Ok(Self::Paired { first, all: contacts });
        }
        let base = dimensionless(first)?;
        let mut same = true;
        for contact in contacts {
            same &= dimensionless(contact)?.agrees_with(&base, SAME_CONTACT);
        }
        if same {
            return Ok(Self::One(first));
        }
        let unmatched =
            spheres_without(model, selected, |sphere| find(contacts, name_of(model, sphere)).is_some());
        if unmatched.is_empty() {
            return Ok(Self::Paired { first, all: contacts });
        }
        let reference = wanted.reference.name.clone();
        Err(Fault::new(Needed::ReferenceContact { reference, unmatched }))
    }

    pub(crate) fn of_sphere(&self, model: &Model, sphere: SphereId) -> &'t ReferenceContact {
        match self {
            Self::One(contact) | Self::Named { contact, .. } => contact,
            Self::Paired { first, all } => {
                // `make` has seen that every name is there.
                find(all, name_of(model, sphere)).unwrap_or(first)
            }
        }
    }

    /// The reference radius that a sphere's follows from: that of the sphere whose contact all get, else of the sphere of its
    /// name, else the one radius all have there.
    pub(crate) fn radius_for(&self, model: &Model, sphere: SphereId, reference: &Reference) -> Option<f64> {
        if let Self::Named { radius_m, .. } = self {
            return Some(*radius_m);
        }
        let name = name_of(model, sphere);
        let named = reference.contacts.iter().find_map(|contact| contact.radius_of(name));
        let first = self.of_sphere(model, sphere).radius_m;
        let one =
            reference.contacts.iter().flat_map(|contact| &contact.radii_m).all(|radius| *radius == first);
        named.or(one.then_some(first))
    }

    /// Isometric radii need a sphere of the same name for each sphere, or one radius in the reference.
    pub(crate) fn refuse_unclear_radii(
        &self,
        model: &Model,
        selected: &Selected,
        reference: &Reference,
    ) -> Result<(), Fault> {
        let unmatched =
            spheres_without(model, selected, |sphere| self.radius_for(model, sphere, reference).is_some());
        if unmatched.is_empty() {
            return Ok(());
        }
        Err(Fault::new(Needed::ReferenceRadius { reference: reference.name.clone(), unmatched }))
    }

    pub(crate) fn of_force(&self, model: &Model, force: &Force) -> Result<&'t ReferenceContact, Fault> {
        let moving: Vec<SphereId> =
            sphere_sets(model, force).into_iter().flat_map(|(_, spheres)| spheres).collect();
        let mut contacts = moving.iter().map(|&sphere| self.of_sphere(model, sphere));
        let Some(first) = contacts.next() else {
            return Err(Fault::refused(format!("{} has no moving sphere", force.path)));
        };
        let base = dimensionless(first)?;
        for other in contacts {
            if !dimensionless(other)?.agrees_with(&base, SAME_CONTACT) {
                let needed = Needed::ReferenceContactOfForce { force: force.path.clone() };
                return Err(Fault::new(needed).of(force.path.clone()));
            }
        }
        Ok(first)
    }
}

fn name_of(model: &Model, sphere: SphereId) -> &str {
    model.sphere(sphere).map_or("", |sphere| sphere.name.as_str())
}

/// Names of the moving spheres of the chosen forces that are not `found`.
fn spheres_without(model: &Model, selected: &Selected, found: impl Fn(SphereId) -> bool) -> Vec<String> {
    let moving = moving_spheres(model, &selected.forces).into_iter();
    moving.filter(|&sphere| !found(sphere)).map(|sphere| name_of(model, sphere).to_owned()).collect()
}

fn find<'t>(contacts: &'t [ReferenceContact], name: &str) -> Option<&'t ReferenceContact> {
    contacts.iter().find(|contact| contact.spheres.iter().any(|sphere| sphere == name))
}

fn dimensionless(contact: &ReferenceContact) -> Result<DimensionlessContact, Fault> {
    let values = ScaleValues {
        mass_kg: 1.0,
        radius_m: contact.radius_m,
        sphere_count: 1.0,
        gravity_m_s2: ANY_GRAVITY,
    };
    Ok(DimensionlessContact::of(&contact.contact, &Scale::new(values).map_err(Fault::new)?))
}
