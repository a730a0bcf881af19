//! Inspects a model: collects all data that `inspect` shows and that the rules need.

use std::collections::BTreeMap;

use contact_scaling::{
    DimensionlessContact, SURFACE_OVER_COMPOSITE_MODULUS, Scale, ScaleValues, mixed_radii,
};
use foldhash::{HashMap, HashMapExt, HashSet};
use osim_model::compare::Factors;
use osim_model::feet::Standing;
use osim_model::files::FileName;
use osim_model::{
    CountedSpheres, Finding, Force, ForceId, Limb, Limbs, Mass, Model, Property, Selected, SetId, SphereId,
    Value, loaded_round_spheres,
};

use crate::inspection::inspected::names_of_spheres;
use crate::inspection::standing::{InspectedFor, StandingBody};
use crate::real_feet::spheres_under_heels;
use crate::rules::{contacts, findings_as_in, model_findings};
use crate::{
    ContactsMass, ContactsOrigin, Dimensionless, Figures, FindingWithRemedy, InspectOptions, InspectedBody,
    InspectedFactors, InspectedForce, InspectedLimb, InspectedSphere, Inspection, KnownContacts, LoadSharing,
    NoteSummary, SCHEMA_VERSION,
};

impl InspectOptions {
    /// Inspects a model. This never fails: a value that is not known is `None`. `name` is the name of the file.
    pub fn inspect(&self, name: impl Into<FileName>, model: &Model, factors: Option<&Factors>) -> Inspection {
        let (note, heel_spheres) = (NoteSummary::of(model), spheres_under_heels(model));
        let findings = model_findings(model).to_vec();
        let inspected = self.inspect_with(name, model, factors, findings, InspectedFor::Readers);
        Inspection { note, heel_spheres, ..inspected }
    }

    /// Inspects a model for the rules only: without what no rule needs, such as the summary of the note, the bodies, the sources of
    /// parameters, and the equilibrium of bodies that stand as they should.
    pub fn inspect_for_rules(&self, name: impl Into<FileName>, model: &Model) -> Inspection {
        self.inspect_with(name, model, None, model_findings(model).to_vec(), InspectedFor::Rules)
    }

    /// Inspects a model as [`inspect_for_rules`](Self::inspect_for_rules) does, to see which of the findings `other` of another model it has,
    /// too: rules about numbers of contacts that found nothing there are not applied.
    pub fn inspect_to_compare(
        &self,
        name: impl Into<FileName>,
        model: &Model,
        other: &[FindingWithRemedy],
    ) -> Inspection {
        let findings = findings_as_in(model, other);
        self.inspect_with(name, model, None, findings, InspectedFor::Rules)
    }

    /// Inspects a model for readers, or for the rules alone. `findings` are those about the model itself.
    fn inspect_with(
        &self,
        name: impl Into<FileName>,
        model: &Model,
        factors: Option<&Factors>,
        mut findings: Vec<Finding>,
        inspected_for: InspectedFor,
    ) -> Inspection {
        let mass = self.masses.model_mass(model);
        let (selected, no_choice) = match self.selection.apply(model) {
            Ok(selected) => (selected, None),
            Err(fault) => (Selected::default(), Some(fault)),
        };
        let sharing = match &no_choice {
            Some(fault) => LoadSharing::unknown(fault.phrase()),
            None => LoadSharing::of(model, &selected.forces),
        };
        let stance_limbs = self.stance.limb_count(model);
        let count = sharing.count(self.stance.spheres, stance_limbs, CountedSpheres::Model).ok();
        let known_contacts =
            KnownContacts::find(model, &selected.forces, count, mass.as_ref().ok().map(|mass| mass.kg));
        let origin = ContactsOrigin::with_known(model, &self.masses, known_contacts);
        let contacts_mass = origin.map(|origin| {
            findings.extend(origin.findings);
            origin.mass
        });
        findings.extend(factors.iter().flat_map(|factors| factors.findings.iter().cloned()));
        for fault in [mass.as_ref().err(), contacts_mass.as_ref().err()].into_iter().flatten() {
            let mut finding = contacts::mass_unknown(fault);
            finding.position = fault.offset.map(|offset| model.file(fault.file).position(offset));
            if !findings.contains(&finding) {
                findings.push(finding);
            }
        }
        findings.extend(contacts::find_unmatched_patterns(&self.selection, &self.masses, model));
        let (mass, contacts_mass) = (mass.ok(), contacts_mass.ok());
        let weight = mass.as_ref().or(contacts_mass.as_ref());
        // If nobody chose among the forces of several bodies, all bodies count.
        let chosen = if no_choice.is_some() { model.force_ids() } else { sharing.forces.to_vec() };
        let standing = Standing::all(model, &chosen);
        let trees = standing.as_deref().unwrap_or_default();
        let is_for_readers = inspected_for == InspectedFor::Readers;
        let figures = Figures::compute(model, &selected, &sharing, weight, &self.stance, trees);
        let standing_bodies =
            StandingBody::with_rests(model, trees, &sharing.limbs, stance_limbs, inspected_for);
        let contacts =
            is_for_readers.then(|| contacts_of_sets(model, &selected, contacts_mass.as_ref(), count));
        let bodies = if is_for_readers { model.bodies() } else { &[] };
        let (name, model_bytes) = Into::<FileName>::into(name).into_parts();
        let limbs = &sharing.limbs;
        let inspected_limbs =
            |limbs: &[Limb]| limbs.iter().map(|limb| InspectedLimb::from((model, limb))).collect();
        Inspection {
            schema_version: SCHEMA_VERSION,
            model: name,
            model_bytes,
            document_version: model.document().version(),
            name: model.name.clone(),
            mass_kg: mass.as_ref().map(|mass| mass.kg),
            mass_source: mass.as_ref().map(|mass| mass.source.describe()).unwrap_or_default(),
            gravity_m_s2: model.gravity(),
            contacts_mass_kg: contacts_mass.as_ref().map(ContactsMass::from),
            note: None,
            limbs: limbs.if_known().map(inspected_limbs),
            stance_limbs,
            carriers: self.stance.carriers(stance_limbs),
            spheres_per_limb: limbs.spheres_per_limb().ok(),
            limbs_unknown: limbs.spheres_per_limb().err(),
            spheres: inspected_spheres(model, limbs),
            forces: inspected_forces(model, &selected, contacts.as_ref()),
            findings,
            bodies: bodies.iter().map(InspectedBody::from).collect(),
            body_factors: factors.map(|factors| factors.bodies.iter().map(InspectedFactors::from).collect()),
            known_contacts,
            placement: None,
            similarity: None,
            reference_contacts: None,
            figures: figures.unwrap_or_else(|fault| Figures::absent(fault.phrase())),
            heel_spheres: Vec::new(),
            standing: standing_bodies,
            why_no_standing: standing.err().map(|fault| fault.to_string()),
        }
    }
}

/// The dimensionless contact of each parameter set of the selected forces, for the mass that the contacts are made for and `count` spheres.
/// Spheres of several radii count with the mean of R².
fn contacts_of_sets(
    model: &Model,
    selected: &Selected,
    mass: Option<&Mass>,
    count: Option<f64>,
) -> ContactsOfSets {
    let mut contacts = ContactsOfSets::new();
    let Ok(loaded) = loaded_round_spheres(model, &selected.forces) else { return contacts };
    // The spheres of a set follow each other.
    for spheres in loaded.chunk_by(|a, b| (a.force, a.set) == (b.force, b.set)) {
        let Some(sphere) = spheres.first() else { continue };
        let scale = || {
            let radii: Vec<f64> = spheres.iter().map(|one| one.radius_m).collect();
            let alike = radii.iter().all(|&radius| radius == sphere.radius_m);
            let radius_m =
                if alike { sphere.radius_m } else { mixed_radii::mean_square(&radii).ok()?.sqrt() };
            let (mass_kg, sphere_count, gravity_m_s2) = (mass?.kg, count?, model.contacts_gravity()?);
            Scale::new(ScaleValues { mass_kg, radius_m, sphere_count, gravity_m_s2 }).ok()
        };
        let contact = ContactOfSet {
            composite_modulus_n_m2: sphere.contact.composite_modulus(),
            dimensionless: scale().map(|scale| DimensionlessContact::of(&sphere.contact, &scale)),
        };
        contacts.entry((sphere.force, sphere.set)).or_insert(contact);
    }
    contacts
}

/// The computed contact of each parameter set of each force.
type ContactsOfSets = HashMap<(ForceId, SetId), ContactOfSet>;

/// The contact of one parameter set of a force: E* of sphere and plane, and the contact without dimension.
struct ContactOfSet {
    composite_modulus_n_m2: f64,
    /// The dimensionless contact of the parameter set; `None` if mass, limbs or gravity are not known.
    dimensionless: Option<DimensionlessContact>,
}

fn inspected_spheres(model: &Model, limbs: &Limbs) -> Vec<InspectedSphere> {
    let known = limbs.if_known().unwrap_or_default().iter();
    let limbs: HashMap<SphereId, &str> =
        known.flat_map(|limb| limb.spheres.iter().map(|&sphere| (sphere, limb.name.as_str()))).collect();
    let limb_of = |id| limbs.get(&id).copied();
    model.spheres().iter().map(|sphere| InspectedSphere::from((model, sphere, limb_of(sphere.id)))).collect()
}

/// The forces of a model; without the sources of their parameters if `contacts` is `None`.
fn inspected_forces(
    model: &Model,
    selected: &Selected,
    contacts: Option<&ContactsOfSets>,
) -> Vec<InspectedForce> {
    let mut inspected = Vec::new();
    let selected: HashSet<ForceId> = selected.forces.iter().copied().collect();
    for force in model.forces() {
        for set in &force.sets {
            let contact = contacts.and_then(|contacts| contacts.get(&(force.id, set.id)));
            let parameters = parameters_of_set(force, set.id, |value| value.number);
            let origin = contacts.map(|_| parameters_of_set(force, set.id, |value| value.origin.as_str()));
            let modulus_of_stiffness = || {
                let stiffness = parameters.get(Property::Stiffness.as_str())?;
                Some(stiffness / SURFACE_OVER_COMPOSITE_MODULUS).filter(|modulus| modulus.is_finite())
            };
            inspected.push(InspectedForce {
                name: force.name.clone(),
                path: force.path.clone(),
                kind: force.kind.as_str(),
                set: set.number,
                spheres: names_of_spheres(model, &set.spheres),
                applies: force.applies,
                selected: selected.contains(&force.id),
                composite_modulus_n_m2: contact
                    .map(|contact| contact.composite_modulus_n_m2)
                    .or_else(modulus_of_stiffness),
                parameters,
                origin: origin.unwrap_or_default(),
                dimensionless: contact.and_then(|contact| Dimensionless::of(contact.dimensionless.as_ref()?)),
                position: set.position,
            });
        }
    }
    inspected
}

/// A `part` of each property of a parameter set, such as its number, by OpenSim's name of the property.
fn parameters_of_set<T>(force: &Force, set: SetId, part: impl Fn(&Value) -> T) -> BTreeMap<&'static str, T> {
    let properties = Property::changeable();
    properties.filter_map(|property| Some((property.as_str(), part(force.value(set, property)?)))).collect()
}
