//! Which contact of a reference each sphere of a model gets.

use contact_scaling::{DimensionlessContact, Scale, ScaleValues};

use super::surfaces::sphere_sets;
use super::transfer::{Reference, ReferenceContact, Transfer};
use crate::error::{Fault, FaultKind};
use crate::model::{Force, Model};
use crate::select::Selected;

/// Two dimensionless contacts this close (relative) are one.
const SAME_CONTACT: f64 = 1e-6;
/// Comparing contacts of one model needs some gravity, and any will do: it cancels.
const ANY_GRAVITY: f64 = 9.80665;

/// Which contact of the reference each sphere gets.
pub(super) enum Choice<'t> {
    One(&'t ReferenceContact),
    /// By sphere name; every moving sphere of the chosen forces is in it.
    Paired {
        first: &'t ReferenceContact,
        all: &'t [ReferenceContact],
    },
}

impl<'t> Choice<'t> {
    pub(super) fn make(
        model: &Model<'_, '_>,
        selected: &Selected,
        wanted: &'t Transfer,
    ) -> Result<Self, Fault> {
        let contacts = &wanted.reference.contacts;
        let Some(first) = contacts.first() else {
            return Err(Fault::refused(format!(
                "the reference {} has no contacts to take",
                wanted.reference.name
            )));
        };
        if let Some(name) = &wanted.reference_sphere {
            let named = contacts.iter().find(|contact| contact.spheres.contains(name));
            return named.map(Self::One).ok_or_else(|| {
                let known: Vec<_> = contacts.iter().flat_map(|contact| &contact.spheres).cloned().collect();
                Fault::refused(format!(
                    "--reference-sphere {name} is not in {}, which has {}",
                    wanted.reference.name,
                    known.join(", ")
                ))
            });
        }
        if wanted.follow.is_some() {
            // Following has matched every sphere with its namesake already.
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
        let unpaired: Vec<&str> = super::radii::moving_spheres(model, &selected.forces)
            .into_iter()
            .filter_map(|index| model.spheres.get(index))
            .map(|sphere| sphere.name.as_str())
            .filter(|name| find(contacts, name).is_none())
            .collect();
        if unpaired.is_empty() {
            return Ok(Self::Paired { first, all: contacts });
        }
        Err(Fault::new(FaultKind::NeedsAnswer {
            code: "which-reference",
            question: format!(
                "the contacts of {} differ from each other, and these spheres have no namesake there: {}",
                wanted.reference.name,
                unpaired.join(", ")
            ),
            way_out: "say whose contact to take with --reference-sphere NAME".to_owned(),
        }))
    }

    pub(super) fn of_sphere(&self, model: &Model<'_, '_>, sphere: usize) -> &'t ReferenceContact {
        match self {
            Self::One(contact) => contact,
            Self::Paired { first, all } => {
                let name = model.spheres.get(sphere).map_or("", |sphere| sphere.name.as_str());
                // `make` has seen that every name is there.
                find(all, name).unwrap_or(first)
            }
        }
    }

    /// The reference radius that a sphere's follows from: its namesake's, else the one radius all have there.
    pub(super) fn radius_for(
        &self,
        model: &Model<'_, '_>,
        sphere: usize,
        reference: &Reference,
    ) -> Option<f64> {
        let name = model.spheres.get(sphere).map_or("", |sphere| sphere.name.as_str());
        let named = reference.contacts.iter().find_map(|contact| {
            let at = contact.spheres.iter().position(|known| known == name)?;
            contact.radii_m.get(at).copied()
        });
        let first = self.of_sphere(model, sphere).radius_m;
        let one =
            reference.contacts.iter().flat_map(|contact| &contact.radii_m).all(|radius| *radius == first);
        named.or(one.then_some(first))
    }

    /// Isometric radii need a namesake for each sphere, or one radius in the reference.
    pub(super) fn refuse_unclear_radii(
        &self,
        model: &Model<'_, '_>,
        selected: &Selected,
        reference: &Reference,
    ) -> Result<(), Fault> {
        let unclear: Vec<&str> = super::radii::moving_spheres(model, &selected.forces)
            .into_iter()
            .filter(|&sphere| self.radius_for(model, sphere, reference).is_none())
            .filter_map(|sphere| model.spheres.get(sphere))
            .map(|sphere| sphere.name.as_str())
            .collect();
        if unclear.is_empty() {
            return Ok(());
        }
        Err(Fault::new(FaultKind::NeedsAnswer {
            code: "which-reference",
            question: format!(
                "radii differ in {}, and these spheres have no namesake there: {}",
                reference.name,
                unclear.join(", ")
            ),
            way_out: "say the radius with --radius METRES, or keep radii with --radius keep".to_owned(),
        }))
    }

    pub(super) fn of_force(
        &self,
        model: &Model<'_, '_>,
        force: &Force,
    ) -> Result<&'t ReferenceContact, Fault> {
        let moving: Vec<usize> =
            sphere_sets(model, force).into_iter().flat_map(|(_, spheres)| spheres).collect();
        let mut contacts = moving.iter().map(|&sphere| self.of_sphere(model, sphere));
        let Some(first) = contacts.next() else {
            return Err(Fault::refused(format!("{} has no moving sphere", force.path)));
        };
        let base = dimensionless(first)?;
        for other in contacts {
            if !dimensionless(other)?.agrees_with(&base, SAME_CONTACT) {
                return Err(Fault::new(FaultKind::NeedsAnswer {
                    code: "which-reference",
                    question: format!(
                        "the spheres of {} have different contacts in the reference",
                        force.path
                    ),
                    way_out: "say whose contact to take with --reference-sphere NAME".to_owned(),
                })
                .of(force.path.clone()));
            }
        }
        Ok(first)
    }
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
