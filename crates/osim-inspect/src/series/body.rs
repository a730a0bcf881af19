//! Bodies whose contacts are drawn, names for their spheres, and the reference that is drawn beside them.

use std::fmt::Display;

use contact_scaling::{
    Contact, DimensionlessContact, DomainError, Law, Preset, Ratios, Scale, ScaleValues, Spheres,
};
use osim_model::files::{Failure, OpenModel};
use osim_model::messages::readable;
use osim_model::{
    CountedSpheres, Fault, ForceId, GravityFor, MassRequest, MissingFact, Model, Result, Selection,
    loaded_spheres, short_digest,
};

use crate::figures::Figures;
use crate::findings::{FindingWithRemedy, check_without_remedies};
use crate::load::{ContactsOrigin, InspectOptions, LoadSharing, MassMismatch, Stance};
use crate::plane_judgement::weight_share_on_floor;

/// The weight of a body, and the spheres that carry it.
#[derive(Debug, Clone)]
pub struct CarriedWeight {
    /// Mass M of the body whose weight presses on the spheres, kg.
    pub mass_kg: f64,
    /// Gravity g on the body, m/s².
    pub gravity_m_s2: f64,
    /// Number n of spheres that share the weight.
    pub sphere_count: f64,
    /// The spheres, each with the number of spheres that it represents. The sum of these numbers is n.
    pub spheres: Vec<Spheres>,
}

impl CarriedWeight {
    /// Weight of the body, M g, in N.
    pub fn body_weight_n(&self) -> f64 {
        self.mass_kg * self.gravity_m_s2
    }

    /// Weight that each sphere bears, M g / n, in N.
    pub(crate) fn share_n(&self) -> f64 {
        self.body_weight_n() / self.sphere_count
    }
}

/// All spheres of a body with the same radius and the same contact parameters.
#[derive(Debug, Clone)]
pub struct SphereKind {
    /// Names of the spheres in words; empty if all spheres of the body are of this kind.
    pub spheres: String,
    /// Radius R of the spheres, m.
    pub radius_m: f64,
    pub contact: Contact,
}

impl SphereKind {
    /// The kind of a body whose spheres are all alike.
    pub fn new(radius_m: f64, contact: Contact) -> Self {
        Self { spheres: String::new(), radius_m, contact }
    }
}

/// A body whose contacts are drawn: a model or a preset.
#[derive(Debug, Clone)]
pub struct ContactBody {
    pub name: String,
    /// Kinds of the body's spheres, in the order of the file.
    pub kinds: Vec<SphereKind>,
    /// Weight of the body, or the reason why it is not known.
    pub weight: Result<CarriedWeight, Failure>,
    /// The mass that the contacts are made for, kg, or the reason why it is not known.
    contacts_mass_kg: Result<f64, Failure>,
    /// The mass in the note and the mass of the bodies, if they disagree.
    pub mismatch: Option<MassMismatch>,
}

impl ContactBody {
    /// Reads the body from a model with the chosen `forces`. `failed` adds the name of the file to a fault.
    ///
    /// # Errors
    /// No chosen force applies, or a value is not a number. An unknown weight is an error only when it is needed.
    pub fn from_model(
        name: String,
        model: &Model,
        forces: &[ForceId],
        masses: &MassRequest,
        stance: &Stance,
        failed: &dyn Fn(Fault) -> Failure,
    ) -> Result<Self, Failure> {
        let kinds = sphere_kinds(model, forces).map_err(failed)?;
        let weight = weight(model, forces, masses, stance).map_err(failed);
        let contacts_mass = ContactsOrigin::find(model, forces, masses, stance).map(|origin| origin.mass);
        let mismatch = MassMismatch::find(model, masses, contacts_mass.as_ref().ok());
        let contacts_mass_kg = contacts_mass.map(|mass| mass.kg).map_err(failed);
        Ok(Self { name, kinds, weight, contacts_mass_kg, mismatch })
    }

    /// Reads the body from a model, with the options of an inspection.
    pub fn from_inspected_model(
        name: String,
        model: &Model,
        options: &InspectOptions,
        failed: &dyn Fn(Fault) -> Failure,
    ) -> Result<Self, Failure> {
        let selected = options.selection.apply(model).map_err(failed)?;
        Self::from_model(name, model, &selected.forces, &options.masses, &options.stance, failed)
    }

    /// Makes the body from a preset. Masses, spheres and gravity that the caller gives replace those of the preset. The body stands on the
    /// given number of limbs, else on one limb.
    pub fn from_preset(preset: &Preset, masses: &MassRequest, stance: &Stance) -> Result<Self, DomainError> {
        let scale = &preset.scale;
        let law = Law::of(&preset.contact, scale.radius_m())?;
        let on_limbs = scale.sphere_count() * stance.limbs.unwrap_or(1.0);
        let sphere_count = stance.spheres.unwrap_or(on_limbs);
        let weight = Ok(CarriedWeight {
            mass_kg: masses.model_kg.unwrap_or(scale.mass_kg()),
            gravity_m_s2: stance.gravity_m_s2.unwrap_or(scale.gravity_m_s2()),
            sphere_count,
            spheres: vec![Spheres::new(law, sphere_count)?],
        });
        let kinds = vec![SphereKind::new(scale.radius_m(), preset.contact)];
        let contacts_mass_kg = Ok(masses.contacts_mass_kg.unwrap_or(scale.mass_kg()));
        Ok(Self { name: preset.name.to_string(), kinds, weight, contacts_mass_kg, mismatch: None })
    }

    /// Contacts without a load, for plots that need none.
    pub fn without_weight(name: String, kinds: Vec<SphereKind>, why: &Failure) -> Self {
        Self { name, kinds, weight: Err(why.clone()), contacts_mass_kg: Err(why.clone()), mismatch: None }
    }

    /// The body scaled to another mass: radii isometric, every parameter by the equation for it.
    ///
    /// # Errors
    /// The mass its contacts are made for is not known, or the ratio leaves the range of numbers.
    pub fn scaled(&self, target_mass_kg: f64) -> Result<Self, Failure> {
        let contacts_mass_kg = *self.contacts_mass_kg.as_ref().map_err(Failure::clone)?;
        let failed = |error: DomainError| self.failure(&error);
        let ratios = Ratios::isometric(target_mass_kg / contacts_mass_kg).map_err(failed)?;
        let kinds = self.kinds.iter().map(|kind| SphereKind {
            spheres: kind.spheres.clone(),
            radius_m: kind.radius_m * ratios.radius(),
            contact: kind.contact.scaled(&ratios),
        });
        let kinds: Vec<SphereKind> = kinds.collect();
        let weight = match &self.weight {
            Err(failure) => Err(failure.clone()),
            Ok(weight) => Ok(CarriedWeight {
                mass_kg: target_mass_kg,
                spheres: scaled_spheres(&self.kinds, &kinds, &weight.spheres).map_err(failed)?,
                ..*weight
            }),
        };
        let name = format!("{}, scaled to {} kg", self.name, readable(target_mass_kg));
        Ok(Self { name, kinds, weight, contacts_mass_kg: Ok(target_mass_kg), mismatch: None })
    }

    /// The dimensionless contact of each kind of sphere.
    ///
    /// # Errors
    /// What it weighs is not known, or a quantity is outside its domain.
    pub fn dimensionless(&self) -> Result<Vec<(&SphereKind, DimensionlessContact)>, Failure> {
        let &CarriedWeight { mass_kg, gravity_m_s2, sphere_count, .. } = self.weight()?;
        let dimensionless = |kind| {
            let &SphereKind { radius_m, ref contact, .. } = kind;
            let scale = Scale::new(ScaleValues { mass_kg, radius_m, sphere_count, gravity_m_s2 });
            let scale = scale.map_err(|error| self.failure(&error))?;
            Ok((kind, DimensionlessContact::of(contact, &scale)))
        };
        self.kinds.iter().map(dimensionless).collect()
    }

    /// The weight of the body.
    ///
    /// # Errors
    /// Why the weight is not known.
    pub fn weight(&self) -> Result<&CarriedWeight, Failure> {
        self.weight.as_ref().map_err(Failure::clone)
    }

    /// Adds the name of the body to an error.
    pub(crate) fn failure(&self, error: &dyn Display) -> Failure {
        Failure::outside(&self.name, "plot", error.to_string())
    }
}

/// The spheres with the scaled contact laws instead of the old ones; the numbers of spheres stay.
fn scaled_spheres(
    before: &[SphereKind],
    after: &[SphereKind],
    spheres: &[Spheres],
) -> Result<Vec<Spheres>, DomainError> {
    let mut scaled = Vec::new();
    for one in spheres {
        for (old, new) in before.iter().zip(after) {
            if Law::of(&old.contact, old.radius_m)? == *one.law() {
                scaled.push(Spheres::new(Law::of(&new.contact, new.radius_m)?, one.count())?);
            }
        }
    }
    Ok(scaled)
}

/// The kinds of spheres that the forces press, in the order of the file.
fn sphere_kinds(model: &Model, forces: &[ForceId]) -> Result<Vec<SphereKind>> {
    let mut kinds: Vec<(SphereKind, Vec<String>)> = Vec::new();
    for loaded in loaded_spheres(model, forces)? {
        let name = model.sphere(loaded.sphere).map(|sphere| sphere.name.clone()).unwrap_or_default();
        let is_alike = |kind: &SphereKind| kind.radius_m == loaded.radius_m && kind.contact == loaded.contact;
        match kinds.iter_mut().find(|(kind, _)| is_alike(kind)) {
            Some((_, names)) => names.push(name),
            None => kinds.push((SphereKind::new(loaded.radius_m, loaded.contact), vec![name])),
        }
    }
    if kinds.is_empty() {
        return Err(fault_of_no_force());
    }
    let is_only_kind = kinds.len() == 1;
    let named = kinds.into_iter().map(|(kind, names)| {
        let spheres = if is_only_kind { String::new() } else { list_spheres(&names) };
        SphereKind { spheres, ..kind }
    });
    Ok(named.collect())
}

/// The fault that all chosen forces are switched off.
fn fault_of_no_force() -> Fault {
    Fault::refused("all chosen forces are switched off: there is no contact to work with")
}

/// The weight of a body on the spheres that share it.
fn weight(model: &Model, forces: &[ForceId], masses: &MassRequest, stance: &Stance) -> Result<CarriedWeight> {
    let mass_kg = masses.model_mass(model)?.kg;
    let sharing = LoadSharing::of(model, forces);
    let sphere_count = sharing.count(stance.spheres, stance.limb_count(model), CountedSpheres::Model)?;
    let gravity = stance.gravity_m_s2.or(model.gravity().filter(|&gravity| gravity > 0.0));
    let Some(gravity_m_s2) = gravity else {
        return Err(Fault::new(MissingFact::Gravity { purpose: GravityFor::Weight }));
    };
    let spheres = standing_spheres(model, forces, sphere_count)?;
    let gravity_m_s2 = gravity_m_s2 * weight_share_on_floor(model, &sharing.forces);
    Ok(CarriedWeight { mass_kg, gravity_m_s2, sphere_count, spheres })
}

/// The chosen spheres, each with the number of the `count` spheres that it represents: 1/2 if one of two limbs carries the body. If only
/// some spheres are chosen, all `count` spheres are assumed to be like these.
pub fn standing_spheres(model: &Model, forces: &[ForceId], count: f64) -> Result<Vec<Spheres>> {
    let loaded = loaded_spheres(model, forces)?;
    let chosen = model.loaded_spheres(forces).len() as f64;
    if loaded.is_empty() {
        return Err(fault_of_no_force());
    }
    let share = count / chosen;
    let spheres = loaded.iter().map(|one| Spheres::new(Law::of(&one.contact, one.radius_m)?, share));
    spheres.collect::<Result<_, DomainError>>().map_err(Fault::new)
}

// Names for spheres that are drawn as one curve.

/// If there are more names than this, only the first and the last are listed.
const MOST_NAMES_LISTED: usize = 4;
/// Endings of names on the right and on the left side.
const SIDE_ENDINGS: [(&str, &str); 4] = [("_r", "_l"), ("_R", "_L"), ("R", "L"), ("r", "l")];

/// The names of spheres in words. Names that occur on both sides are given once. Many names are shortened to the first, the last and the
/// number.
pub(super) fn list_spheres(names: &[String]) -> String {
    if let Some(common) = names_without_sides(names) {
        return format!("{}, both sides", first_to_last_name(&common));
    }
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    first_to_last_name(&names)
}

/// The names in words; of many names, the first and the last.
fn first_to_last_name(names: &[&str]) -> String {
    match names {
        [first, .., last] if names.len() > MOST_NAMES_LISTED => {
            format!("{first} to {last} ({} spheres)", names.len())
        }
        few => few.join(", "),
    }
}

/// The names without the ending of their side, if each name occurs on the right and on the left side.
fn names_without_sides(names: &[String]) -> Option<Vec<&str>> {
    SIDE_ENDINGS.iter().find_map(|&(right, left)| {
        let stems = |side: &str| -> Vec<&str> {
            names.iter().filter_map(|name| name.strip_suffix(side)).filter(|name| !name.is_empty()).collect()
        };
        let (right, left) = (stems(right), stems(left));
        let all_have_sides = right.len() + left.len() == names.len() && !right.is_empty();
        (all_have_sides && right.len() == left.len() && right.iter().all(|name| left.contains(name)))
            .then_some(right)
    })
}

/// A reference model or preset under the weight that its contacts are made for.
#[derive(Debug, Clone)]
pub struct ReferenceState {
    pub name: String,
    /// The first 16 digits of the SHA-256 of the reference's file; `None` for a preset.
    pub digest: Option<String>,
    /// The body to draw; `None` if it cannot be drawn.
    pub body: Option<ContactBody>,
    pub figures: Option<Figures>,
    /// The findings about the reference itself. Its contacts bring these faults into other models.
    pub findings: Vec<FindingWithRemedy>,
}

impl ReferenceState {
    /// Takes the reference from a preset, under the weight that its contacts are made for.
    pub fn from_preset(preset: &Preset, mass_kg: f64, spheres: f64, gravity_m_s2: Option<f64>) -> Self {
        let masses = MassRequest { model_kg: Some(mass_kg), ..MassRequest::default() };
        let stance = Stance { spheres: Some(spheres), gravity_m_s2, ..Stance::default() };
        let name = preset.name.to_string();
        let body = ContactBody::from_preset(preset, &masses, &stance).ok();
        Self { name, digest: None, body, figures: None, findings: Vec::new() }
    }

    /// Takes the reference from a model. The mass, number of spheres and gravity are those that the contacts are made for.
    pub fn from_model(
        name: String,
        open: &OpenModel,
        selection: Selection,
        (mass_kg, spheres, gravity_m_s2): (f64, Option<f64>, Option<f64>),
    ) -> Self {
        let options = InspectOptions {
            masses: MassRequest { model_kg: Some(mass_kg), ..MassRequest::default() },
            selection,
            stance: Stance { spheres, gravity_m_s2, ..Stance::default() },
            ..InspectOptions::default()
        };
        let failed = |fault| open.failure(fault);
        let body = ContactBody::from_inspected_model(name.clone(), &open.model, &options, &failed).ok();
        let inspected = options.inspect_for_rules(open.name(), &open.model);
        let findings = check_without_remedies(&options, &open.model, &inspected);
        let digest = Some(short_digest(open.model.document().bytes()));
        Self { name, digest, body, figures: Some(inspected.figures), findings }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn assert_listed(names: &[&str], expected: &str) {
        let names: Vec<String> = names.iter().map(|&name| name.to_owned()).collect();
        assert_eq!(list_spheres(&names), expected);
    }

    #[test]
    fn a_legend_names_few_spheres() {
        assert_listed(&["heel"], "heel");
        assert_listed(&["heel", "toe"], "heel, toe");
        assert_listed(&[], "");
    }

    #[test]
    fn spheres_of_both_sides_are_named_once() {
        assert_listed(&["heel_r", "toe_r", "heel_l", "toe_l"], "heel, toe, both sides");
        assert_listed(&["heel_r", "heel_l", "toe_r"], "heel_r, heel_l, toe_r");
        assert_listed(&["SmoothSphereHeelR", "SmoothSphereHeelL"], "SmoothSphereHeel, both sides");
        assert_listed(&["r", "l"], "r, l");
    }

    #[test]
    fn a_legend_counts_many_spheres() {
        let names: Vec<String> =
            ["r", "l"].iter().flat_map(|side| (1..=5).map(move |i| format!("s{i}_{side}"))).collect();
        assert_eq!(list_spheres(&names), "s1 to s5 (5 spheres), both sides");
        assert_listed(&["a", "b", "c", "d", "e"], "a to e (5 spheres)");
    }
}
