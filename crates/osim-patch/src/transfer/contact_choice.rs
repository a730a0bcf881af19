//! Chooses the contact of the reference for each sphere of a model, also if the spheres of one force have different materials.

use contact_scaling::{DimensionlessContact, Scale, ScaleValues};
use foldhash::{HashMap, HashMapExt};
use osim_model::{
    Fault, Force, MissingFact, Model, Property, Result, Selected, SphereId, Surfaces, moving_spheres,
    sphere_sets,
};

use crate::builder::{NewNumber, PlanBuilder};
use crate::new_radii::Radii;
use crate::transfer::reference::{Reference, ReferenceContact, Transfer};

/// Two dimensionless contacts with at most this relative difference are equal.
const SAME_CONTACT_TOLERANCE: f64 = 1e-6;
/// Gravity, m/s², for the comparison of contacts of one model. Its value does not matter, because it cancels.
const ARBITRARY_GRAVITY: f64 = 9.80665;

/// The contact of the reference that each sphere of the model gets.
pub(crate) enum ContactChoice<'t> {
    /// All spheres of the model get this one contact of the reference.
    One(&'t ReferenceContact),
    /// All spheres get the contact of one named sphere of the reference; the radius of that sphere (m) is also used.
    Named { contact: &'t ReferenceContact, radius_m: f64 },
    /// Each sphere gets the contact of the sphere with the same name in the reference. All moving spheres of the chosen
    /// forces have such a sphere.
    Paired { first: &'t ReferenceContact, by_name: HashMap<&'t str, &'t ReferenceContact> },
}

/// The radii of a reference's spheres, by name, and their common radius.
pub(crate) struct ReferenceRadii<'t> {
    /// Radii by sphere name; if several spheres have the same name, the first one counts.
    by_name: HashMap<&'t str, f64>,
    /// The common radius of all spheres; `None` inside if they differ.
    one: Option<Option<f64>>,
}

impl<'t> ReferenceRadii<'t> {
    /// Collects the radii of all spheres of `reference`.
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
}

impl<'t> ContactChoice<'t> {
    /// Chooses the contact for each sphere: that of the sphere which the caller named, the common one, or that of the same name.
    pub(crate) fn new(model: &Model, selected: &Selected, wanted: &'t Transfer) -> Result<Self> {
        let contacts = &wanted.reference.contacts;
        let first = contacts.first().ok_or_else(|| wanted.reference.without_contacts())?;
        if let Some(name) = &wanted.reference_sphere {
            let named = contacts.iter().find_map(|contact| {
                let at = contact.spheres.iter().position(|known| known == name)?;
                Some(Self::Named { contact, radius_m: *contact.radii_m.get(at)? })
            });
            return named.ok_or_else(|| wanted.reference.without_sphere(name));
        }
        if wanted.follow.is_some() {
            // Following has matched every sphere by its name already.
            return Ok(Self::Paired { first, by_name: contacts_by_sphere_name(contacts) });
        }
        let base = dimensionless_contact(first)?;
        let mut same = true;
        for contact in contacts {
            same &= dimensionless_contact(contact)?.agrees_with(&base, SAME_CONTACT_TOLERANCE);
        }
        if same {
            return Ok(Self::One(first));
        }
        let by_name = contacts_by_sphere_name(contacts);
        let unmatched =
            names_of_unmatched(model, selected, |sphere| by_name.contains_key(sphere_name(model, sphere)));
        if unmatched.is_empty() {
            return Ok(Self::Paired { first, by_name });
        }
        let reference = wanted.reference.name.clone();
        Err(Fault::new(MissingFact::ReferenceContact { reference, unmatched }))
    }

    /// The contact of the reference that a sphere gets.
    pub(crate) fn contact_for_sphere(&self, model: &Model, sphere: SphereId) -> &'t ReferenceContact {
        match self {
            Self::One(contact) | Self::Named { contact, .. } => contact,
            // `new` has checked that every name is there.
            Self::Paired { first, by_name } => by_name.get(sphere_name(model, sphere)).unwrap_or(first),
        }
    }

    /// The reference radius from which the radius of `sphere` follows: that of the named sphere if all spheres get its
    /// contact, else that of the sphere with the same name, else the common radius of the reference.
    pub(crate) fn radius_for(
        &self,
        model: &Model,
        sphere: SphereId,
        reference: &ReferenceRadii<'_>,
    ) -> Option<f64> {
        if let Self::Named { radius_m, .. } = self {
            return Some(*radius_m);
        }
        let named = reference.by_name.get(sphere_name(model, sphere)).copied();
        let first = self.contact_for_sphere(model, sphere).radius_m;
        named.or_else(|| reference.one?.is_none_or(|one| one == first).then_some(first))
    }

    /// Refuses isometric radii unless each sphere has a sphere of the same name in the reference, or all spheres of the
    /// reference have one radius.
    pub(crate) fn refuse_unclear_radii(
        &self,
        model: &Model,
        selected: &Selected,
        reference: &Reference,
    ) -> Result<()> {
        let radii = ReferenceRadii::of(reference);
        let unmatched =
            names_of_unmatched(model, selected, |sphere| self.radius_for(model, sphere, &radii).is_some());
        if unmatched.is_empty() {
            return Ok(());
        }
        Err(Fault::new(MissingFact::ReferenceRadius { reference: reference.name.clone(), unmatched }))
    }

    /// The contact of the reference that all spheres of a force get; an error if they get different ones.
    pub(crate) fn contact_for_force(&self, model: &Model, force: &Force) -> Result<&'t ReferenceContact> {
        let moving: Vec<SphereId> =
            sphere_sets(model, force).into_iter().flat_map(|(_, spheres)| spheres).collect();
        let mut contacts = moving.iter().map(|&sphere| self.contact_for_sphere(model, sphere));
        let none = || Fault::refused(format!("{} has no moving sphere", force.path));
        let first = contacts.next().ok_or_else(none)?;
        let base = dimensionless_contact(first)?;
        for other in contacts {
            if !dimensionless_contact(other)?.agrees_with(&base, SAME_CONTACT_TOLERANCE) {
                let fact = MissingFact::ReferenceContactOfForce { force: force.path.clone() };
                return Err(Fault::new(fact).at_element(force.path.clone()));
            }
        }
        Ok(first)
    }
}

fn sphere_name(model: &Model, sphere: SphereId) -> &str {
    model.sphere(sphere).map_or("", |sphere| sphere.name.as_str())
}

/// Names of the moving spheres of the chosen forces that are not `matched`.
fn names_of_unmatched(model: &Model, selected: &Selected, matched: impl Fn(SphereId) -> bool) -> Vec<String> {
    let moving = moving_spheres(model, &selected.forces).into_iter();
    moving.filter(|&sphere| !matched(sphere)).map(|sphere| sphere_name(model, sphere).to_owned()).collect()
}

/// The first contact of each sphere name.
fn contacts_by_sphere_name(contacts: &[ReferenceContact]) -> HashMap<&str, &ReferenceContact> {
    let mut found = HashMap::new();
    for contact in contacts {
        for name in &contact.spheres {
            found.entry(name.as_str()).or_insert(contact);
        }
    }
    found
}

/// The contact without dimension, for comparing contacts of one reference.
fn dimensionless_contact(contact: &ReferenceContact) -> Result<DimensionlessContact> {
    let (radius_m, gravity_m_s2) = (contact.radius_m, ARBITRARY_GRAVITY);
    let values = ScaleValues { mass_kg: 1.0, radius_m, sphere_count: 1.0, gravity_m_s2 };
    Ok(DimensionlessContact::of(&contact.contact, &Scale::new(values).map_err(Fault::new)?))
}

/// Factors with at most this relative difference are equal.
const EQUAL_FACTORS_TOLERANCE: f64 = 1e-6;

/// Whether the spheres of `force` have several ContactParameters, each matched by name with the reference.
pub(crate) fn has_several_sets(plan: &PlanBuilder<'_>, force: &Force, wanted: &Transfer) -> bool {
    let paired = wanted.follow.is_some() && wanted.reference_sphere.is_none();
    paired && sphere_sets(plan.model, force).len() > 1
}

/// Plans the parameters of a force with several `ContactParameters`: each sphere gets its own contact of the reference, scaled by
/// the mean of R² over all spheres.
///
/// # Errors
/// The spheres would need different factors for one material.
pub(crate) fn plan_several_sets(
    plan: &mut PlanBuilder<'_>,
    force: &Force,
    wanted: &Transfer,
    chosen: &ContactChoice<'_>,
    radii: &Radii,
    gravity: f64,
) -> Result<()> {
    let ratios = wanted.ratios(radius_ratio(plan, force, wanted, radii), gravity)?;
    for property in Property::changeable().filter(|&property| wanted.properties.contains(property)) {
        let Some((factor, by)) = wanted.factor(property, &ratios) else { continue };
        let factor = factor * composite_ratio(plan, force, chosen, property)?;
        plan.change_in_all_sets(force, property, |from| NewNumber::multiplied(from, factor, by))?;
    }
    Ok(())
}

/// Root mean square of all radii of the force, new model over reference.
fn radius_ratio(plan: &PlanBuilder<'_>, force: &Force, wanted: &Transfer, radii: &Radii) -> f64 {
    let spheres: Vec<SphereId> =
        sphere_sets(plan.model, force).into_iter().flat_map(|(_, set)| set).collect();
    let old: Vec<f64> = spheres
        .iter()
        .filter_map(|&sphere| wanted.follow.as_ref().and_then(|follow| follow.old_radius(sphere)))
        .collect();
    let mean = old.iter().map(|radius| radius * radius).sum::<f64>() / old.len() as f64;
    radii.rms_new_radius(force) / mean.sqrt()
}

/// E₁* or α of the reference divided by that of this model, for sphere and plane together; 1 if they are equal.
fn composite_ratio(
    plan: &PlanBuilder<'_>,
    force: &Force,
    chosen: &ContactChoice<'_>,
    property: Property,
) -> Result<f64> {
    let surfaces = Surfaces::of(force)?;
    let mut common: Option<f64> = None;
    for (set, spheres) in sphere_sets(plan.model, force) {
        let Some(&sphere) = spheres.first() else { continue };
        let contact = chosen.contact_for_sphere(plan.model, sphere).contact;
        let together = surfaces.with_plane(set)?;
        let (there, here) = match property {
            Property::Stiffness => (contact.plane_strain_modulus(), together.plane_strain_modulus),
            Property::Dissipation => (contact.dissipation(), together.dissipation),
            _ => return Ok(1.0),
        };
        if there == 0.0 && here == 0.0 {
            continue;
        }
        let ratio = if there == here { 1.0 } else { there / here };
        if common.is_some_and(|other| (other - ratio).abs() > EQUAL_FACTORS_TOLERANCE * other)
            || !ratio.is_finite()
        {
            let text = format!(
                "the materials of {} were changed since the reference, each in its own way: one factor of {property} \
                 cannot serve all; give each sphere a force of its own",
                force.path
            );
            return Err(Fault::refused(text).at_element(force.path.clone()));
        }
        common.get_or_insert(ratio);
    }
    Ok(common.unwrap_or(1.0))
}
