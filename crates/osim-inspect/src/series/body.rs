//! Bodies whose contacts are drawn, what their spheres are called, and the reference beside them.

use std::fmt::Display;

use contact_scaling::{
    Contact, DimensionlessContact, DomainError, Law, Preset, Ratios, Scale, ScaleValues, Spheres,
};
use osim_model::files::{Failure, OpenModel};
use osim_model::messages::readable;
use osim_model::{
    CountedSpheres, Fault, ForceId, GravityFor, MassRequest, Model, Needed, Selection, loaded_spheres,
    short_digest,
};

use crate::figures::Figures;
use crate::floors::weight_share;
use crate::load::{InspectOptions, LoadSharing, MassMismatch, Stance};

/// What a body weighs and on how many spheres it stands.
#[derive(Debug, Clone)]
pub struct Weight {
    /// M, kg.
    pub mass_kg: f64,
    /// g, m/s².
    pub gravity_m_s2: f64,
    /// n, spheres that share the weight.
    pub sphere_count: f64,
    /// The spheres, each with its share of those that stand.
    pub spheres: Vec<Spheres>,
}

impl Weight {
    /// M g, in N.
    pub fn body_weight_n(&self) -> f64 {
        self.mass_kg * self.gravity_m_s2
    }

    /// M g / n, in N.
    pub(crate) fn share_n(&self) -> f64 {
        self.body_weight_n() / self.sphere_count
    }
}

/// Spheres of one radius with one contact.
#[derive(Debug, Clone)]
pub struct SphereKind {
    /// Names of its spheres; empty where all spheres of the body are of this kind.
    pub spheres: String,
    /// R, m.
    pub radius_m: f64,
    pub contact: Contact,
}

impl SphereKind {
    /// The only kind of a body.
    pub fn new(radius_m: f64, contact: Contact) -> Self {
        Self { spheres: String::new(), radius_m, contact }
    }
}

#[derive(Debug, Clone)]
pub struct Body {
    pub name: String,
    /// Its kinds of spheres, in the order of the file.
    pub kinds: Vec<SphereKind>,
    pub weight: Result<Weight, Failure>,
    /// The mass its contacts are made for, likewise.
    contacts_mass_kg: Result<f64, Failure>,
    /// The two masses, where they disagree.
    pub mismatch: Option<MassMismatch>,
}

impl Body {
    /// A model's chosen forces; `failed` names the file a fault is in.
    ///
    /// # Errors
    /// No chosen force applies, or a value is not a number. What is not known of the weight is no error until it is needed.
    pub fn of_model(
        name: String,
        model: &Model,
        forces: &[ForceId],
        masses: &MassRequest,
        stance: &Stance,
        failed: &dyn Fn(Fault) -> Failure,
    ) -> Result<Self, Failure> {
        let kinds = kinds(model, forces).map_err(failed)?;
        let weight = weight(model, forces, masses, stance).map_err(failed);
        let contacts_mass_kg = masses.contacts_mass(model).map(|(mass, _)| mass.kg).map_err(failed);
        let mismatch = MassMismatch::find(model, masses);
        Ok(Self { name, kinds, weight, contacts_mass_kg, mismatch })
    }

    /// A model as it is inspected.
    pub fn inspected(
        name: String,
        model: &Model,
        options: &InspectOptions,
        failed: &dyn Fn(Fault) -> Failure,
    ) -> Result<Self, Failure> {
        let selected = options.selection.apply(model).map_err(failed)?;
        Self::of_model(name, model, &selected.forces, &options.masses, &options.stance, failed)
    }

    /// A preset; masses, spheres and gravity that are given count instead of its own. It stands on as many limbs as are given, else on one.
    pub fn of_preset(preset: &Preset, masses: &MassRequest, stance: &Stance) -> Result<Self, DomainError> {
        let scale = &preset.scale;
        let law = Law::of(&preset.contact, scale.radius_m())?;
        let on_limbs = scale.sphere_count() * stance.limbs.unwrap_or(1.0);
        let sphere_count = stance.spheres.unwrap_or(on_limbs);
        let weight = Weight {
            mass_kg: masses.model_kg.unwrap_or(scale.mass_kg()),
            gravity_m_s2: stance.gravity_m_s2.unwrap_or(scale.gravity_m_s2()),
            sphere_count,
            spheres: vec![Spheres::new(law, sphere_count)?],
        };
        let kind = SphereKind::new(scale.radius_m(), preset.contact);
        let contacts_mass_kg = Ok(masses.contacts_mass_kg.unwrap_or(scale.mass_kg()));
        Ok(Self {
            name: preset.name.to_string(),
            kinds: vec![kind],
            weight: Ok(weight),
            contacts_mass_kg,
            mismatch: None,
        })
    }

    /// Contacts without a load, for plots that need none.
    pub fn without_weight(name: String, kinds: Vec<SphereKind>, why: &Failure) -> Self {
        Self { name, kinds, weight: Err(why.clone()), contacts_mass_kg: Err(why.clone()), mismatch: None }
    }

    /// The body scaled to another mass: radii isometric, every parameter by its equation.
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
            Ok(weight) => Ok(Weight {
                mass_kg: target_mass_kg,
                spheres: scaled_spheres(&self.kinds, &kinds, &weight.spheres).map_err(failed)?,
                ..*weight
            }),
        };
        let name = format!("{}, scaled to {} kg", self.name, readable(target_mass_kg));
        Ok(Self { name, kinds, weight, contacts_mass_kg: Ok(target_mass_kg), mismatch: None })
    }

    /// The contact of each of its kinds of spheres, without dimensions.
    ///
    /// # Errors
    /// What it weighs is not known, or a quantity is outside its domain.
    pub fn dimensionless(&self) -> Result<Vec<(&SphereKind, DimensionlessContact)>, Failure> {
        let weight = self.weight()?;
        let of = |kind| {
            let &SphereKind { radius_m, ref contact, .. } = kind;
            let scale = Scale::new(ScaleValues {
                mass_kg: weight.mass_kg,
                radius_m,
                sphere_count: weight.sphere_count,
                gravity_m_s2: weight.gravity_m_s2,
            });
            let scale = scale.map_err(|error| self.failure(&error))?;
            Ok((kind, DimensionlessContact::of(contact, &scale)))
        };
        self.kinds.iter().map(of).collect()
    }

    /// What it weighs, where it must be known.
    ///
    /// # Errors
    /// What is missing, if it is not known.
    pub fn weight(&self) -> Result<&Weight, Failure> {
        self.weight.as_ref().map_err(Failure::clone)
    }

    /// Something that went wrong with it.
    pub(crate) fn failure(&self, error: &dyn Display) -> Failure {
        Failure::outside(&self.name, "plot", error.to_string())
    }
}

/// The spheres with each law replaced by its scaled one; their counts stay.
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

/// The kinds of spheres among the forces, in the order of the file.
fn kinds(model: &Model, forces: &[ForceId]) -> Result<Vec<SphereKind>, Fault> {
    let mut kinds: Vec<(SphereKind, Vec<String>)> = Vec::new();
    for loaded in loaded_spheres(model, forces)? {
        let name = model.sphere(loaded.sphere).map(|sphere| sphere.name.clone()).unwrap_or_default();
        let same = |kind: &SphereKind| kind.radius_m == loaded.radius_m && kind.contact == loaded.contact;
        match kinds.iter_mut().find(|(kind, _)| same(kind)) {
            Some((_, names)) => names.push(name),
            None => kinds.push((SphereKind::new(loaded.radius_m, loaded.contact), vec![name])),
        }
    }
    if kinds.is_empty() {
        return Err(none_applies());
    }
    let single = kinds.len() == 1;
    let named = kinds.into_iter().map(|(kind, names)| {
        let spheres = if single { String::new() } else { spheres(&names) };
        SphereKind { spheres, ..kind }
    });
    Ok(named.collect())
}

fn none_applies() -> Fault {
    Fault::refused("none of the chosen forces applies: there is no contact to work with")
}

fn weight(model: &Model, forces: &[ForceId], masses: &MassRequest, stance: &Stance) -> Result<Weight, Fault> {
    let mass_kg = masses.model_mass(model)?.kg;
    let sharing = LoadSharing::of(model, forces);
    let sphere_count = sharing.count(stance.spheres, stance.limbs_of(model), CountedSpheres::Model)?;
    let gravity = stance.gravity_m_s2.or(model.gravity().filter(|&gravity| gravity > 0.0));
    let Some(gravity_m_s2) = gravity else {
        return Err(Fault::new(Needed::Gravity { purpose: GravityFor::Weight }));
    };
    let spheres = standing_spheres(model, forces, sphere_count)?;
    let gravity_m_s2 = gravity_m_s2 * weight_share(model, sharing.forces());
    Ok(Weight { mass_kg, gravity_m_s2, sphere_count, spheres })
}

/// The chosen spheres, each with its share of the n that stand: 1/2 where one of two limbs does. Where only some are chosen,
/// the n that stand are all like these.
pub fn standing_spheres(model: &Model, forces: &[ForceId], count: f64) -> Result<Vec<Spheres>, Fault> {
    let loaded = loaded_spheres(model, forces)?;
    #[expect(clippy::cast_precision_loss, reason = "sphere counts are small")]
    let found = model.loaded_spheres(forces).len() as f64;
    if loaded.is_empty() {
        return Err(none_applies());
    }
    let mut spheres = Vec::new();
    for one in loaded {
        let law = Law::of(&one.contact, one.radius_m).map_err(Fault::new)?;
        spheres.push(Spheres::new(law, count / found).map_err(Fault::new)?);
    }
    Ok(spheres)
}

// What spheres that are drawn as one curve are called.

/// Of more names than this, the first and the last are given.
const LISTED: usize = 4;
/// Endings by which models part the sides, and what they mean.
const SIDES: [(&str, &str); 4] = [("_r", "_l"), ("_R", "_L"), ("R", "L"), ("r", "l")];

/// Spheres by their names: all of them where they are few, those of both sides together; else how many they are, with the first
/// and the last.
pub(super) fn spheres(names: &[String]) -> String {
    if let Some(of_both) = of_both_sides(names) {
        return format!("{}, both sides", listed(&of_both));
    }
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    listed(&names)
}

fn listed(names: &[&str]) -> String {
    match names {
        [first, .., last] if names.len() > LISTED => format!("{first} to {last} ({} spheres)", names.len()),
        few => few.join(", "),
    }
}

/// Names without their sides, where each stands there for the right and for the left.
fn of_both_sides(names: &[String]) -> Option<Vec<&str>> {
    SIDES.iter().find_map(|&(right, left)| {
        let of = |side: &str| -> Vec<&str> {
            names.iter().filter_map(|name| name.strip_suffix(side)).filter(|name| !name.is_empty()).collect()
        };
        let (of_right, of_left) = (of(right), of(left));
        let all = of_right.len() + of_left.len() == names.len() && !of_right.is_empty();
        (all && of_right.len() == of_left.len() && of_right.iter().all(|name| of_left.contains(name)))
            .then_some(of_right)
    })
}

/// A reference: what its spheres do, under its own weight.
#[derive(Debug, Clone)]
pub struct ReferenceState {
    pub name: String,
    /// The first 16 digits of the SHA-256 of its file; `None` of a preset.
    pub digest: Option<String>,
    /// It, to be drawn; `None` if it cannot be.
    pub body: Option<Body>,
    pub figures: Option<Figures>,
}

impl ReferenceState {
    /// A preset, with what the caller says of it.
    pub fn of_preset(preset: &Preset, mass_kg: f64, spheres: f64, gravity_m_s2: Option<f64>) -> Self {
        let masses = MassRequest { model_kg: Some(mass_kg), ..MassRequest::default() };
        let stance = Stance { spheres: Some(spheres), gravity_m_s2, ..Stance::default() };
        let name = preset.name.to_string();
        Self { name, digest: None, body: Body::of_preset(preset, &masses, &stance).ok(), figures: None }
    }

    /// A model, under the weight that its contacts were made for.
    pub fn of_model(
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
        let body = Body::inspected(name.clone(), &open.model, &options, &|fault| open.failure(fault)).ok();
        let figures = options.inspect(open.name(), &open.model, None).figures;
        let digest = Some(short_digest(open.model.document().bytes()));
        Self { name, digest, body, figures: Some(figures) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn called(names: &[&str], expected: &str) {
        let names: Vec<String> = names.iter().map(|&name| name.to_owned()).collect();
        assert_eq!(spheres(&names), expected);
    }

    #[test]
    fn few_spheres_are_named() {
        called(&["heel"], "heel");
        called(&["heel", "toe"], "heel, toe");
        called(&[], "");
    }

    #[test]
    fn spheres_of_both_sides_are_named_once() {
        called(&["heel_r", "toe_r", "heel_l", "toe_l"], "heel, toe, both sides");
        called(&["heel_r", "heel_l", "toe_r"], "heel_r, heel_l, toe_r");
        called(&["SmoothSphereHeelR", "SmoothSphereHeelL"], "SmoothSphereHeel, both sides");
        called(&["r", "l"], "r, l");
    }

    #[test]
    fn many_spheres_are_counted() {
        let names: Vec<String> =
            ["r", "l"].iter().flat_map(|side| (1..=5).map(move |i| format!("s{i}_{side}"))).collect();
        assert_eq!(spheres(&names), "s1 to s5 (5 spheres), both sides");
        called(&["a", "b", "c", "d", "e"], "a to e (5 spheres)");
    }
}
