//! Which contact of a reference each sphere of a model gets.

use contact_scaling::{DimensionlessContact, Scale, ScaleValues};
use foldhash::{HashMap, HashMapExt};
use osim_model::{Fault, FaultKind, Force, Model, Needed, Selected, SphereId, moving_spheres, sphere_sets};

use super::request::{Reference, ReferenceContact, Transfer};

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
        by_name: HashMap<&'t str, &'t ReferenceContact>,
    },
}

/// The radii of a reference.
pub(crate) struct ReferenceRadii<'t> {
    /// By sphere name; of several spheres of one name the first counts.
    by_name: HashMap<&'t str, f64>,
    /// The one that all spheres have; `None` where they differ.
    one: Option<Option<f64>>,
}

impl<'t> ReferenceRadii<'t> {
    pub(crate) fn of(reference: &'t Reference) -> Self {
        let mut by_name = HashMap::new();
        for contact in &reference.contacts {
            for (name, &radius) in contact.spheres.iter().zip(&contact.radii_m) {
                by_name.entry(name.as_str()).or_insert(radius);
            }
        }
        let mut radii = reference.contacts.iter().flat_map(|contact| &contact.radii_m);
        let first = radii.next().copied();
        let one = radii.all(|&radius| Some(radius) == first).then_some(first);
        Self { by_name, one }
    }

    /// Whether no sphere has another radius than `radius_m`.
    fn are_all(&self, radius_m: f64) -> bool {
        self.one.is_some_and(|one| one.is_none_or(|one| one == radius_m))
    }
}

impl<'t> Choice<'t> {
    pub(crate) fn make(model: &Model, selected: &Selected, wanted: &'t Transfer) -> Result<Self, Fault> {
        let contacts = &wanted.reference.contacts;
        let Some(first) = contacts.first() else {
            return Err(wanted.reference.without_contacts());
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
            return Ok(Self::Paired { first, by_name: by_name(contacts) });
        }
        let base = dimensionless(first)?;
        let mut same = true;
        for contact in contacts {
            same &= dimensionless(contact)?.agrees_with(&base, SAME_CONTACT);
        }
        if same {
            return Ok(Self::One(first));
        }
        let by_name = by_name(contacts);
        let unmatched =
            spheres_without(model, selected, |sphere| by_name.contains_key(name_of(model, sphere)));
        if unmatched.is_empty() {
            return Ok(Self::Paired { first, by_name });
        }
        let reference = wanted.reference.name.clone();
        Err(Fault::new(Needed::ReferenceContact { reference, unmatched }))
    }

    pub(crate) fn of_sphere(&self, model: &Model, sphere: SphereId) -> &'t ReferenceContact {
        match self {
            Self::One(contact) | Self::Named { contact, .. } => contact,
            // `make` has checked that every name is there.
            Self::Paired { first, by_name } => by_name.get(name_of(model, sphere)).unwrap_or(first),
        }
    }

    /// The reference radius that a sphere's follows from: that of the sphere whose contact all get, else of the sphere of its
    /// name, else the one radius all have there.
    pub(crate) fn radius_for(
        &self,
        model: &Model,
        sphere: SphereId,
        reference: &ReferenceRadii<'_>,
    ) -> Option<f64> {
        if let Self::Named { radius_m, .. } = self {
            return Some(*radius_m);
        }
        let named = reference.by_name.get(name_of(model, sphere)).copied();
        let first = self.of_sphere(model, sphere).radius_m;
        named.or(reference.are_all(first).then_some(first))
    }

    /// Isometric radii need a sphere of the same name for each sphere, or one radius in the reference.
    pub(crate) fn refuse_unclear_radii(
        &self,
        model: &Model,
        selected: &Selected,
        reference: &Reference,
    ) -> Result<(), Fault> {
        let radii = ReferenceRadii::of(reference);
        let unmatched =
            spheres_without(model, selected, |sphere| self.radius_for(model, sphere, &radii).is_some());
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

/// The first contact of each sphere name.
fn by_name(contacts: &[ReferenceContact]) -> HashMap<&str, &ReferenceContact> {
    let mut found = HashMap::new();
    for contact in contacts {
        for name in &contact.spheres {
            found.entry(name.as_str()).or_insert(contact);
        }
    }
    found
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
