//! Contacts of a reference, given the dimensions of another body: (10), (14), (C.2), (C.5), (C.10).

use contact_scaling::{Contact, Preset, RatioValues, Ratios};

use super::choice::Choice;
use super::draft::{Draft, New, PropertySet};
use super::loaded::contact_of_set;
use super::radii::{Radii, RadiusRule, root_mean_square};
use super::rescale::{bottoms_remark, factor, gravity_ratio, warn_forces};
use super::similarity::{check_spread, predsim, similarity};
use super::surfaces::{Surfaces, sphere_sets, write_composite};
use super::{DissipationBy, Masses, NoteFacts, Plan, several_sets};
use crate::error::Fault;
use crate::follow::Follow;
use crate::mass::{Mass, MassSource};
use crate::model::{Force, ForceKind, Model};
use crate::note::Scope;
use crate::number::readable;
use crate::property::Property;
use crate::select::Selected;
use crate::warning::{Warning, WarningCode};

/// One contact of a reference.
#[derive(Debug, Clone, PartialEq)]
pub struct ReferenceContact {
    /// Names of the spheres that have it, and their radii, m.
    pub spheres: Vec<String>,
    /// Radius of each of `spheres`, m.
    pub radii_m: Vec<f64>,
    /// Their radius (the root of the mean R² where they differ), m.
    pub radius_m: f64,
    /// E₁* of two equal surfaces, α, and the smoothing where the class has it.
    pub contact: Contact,
    /// `transition_velocity` in m/s and `viscous_friction` in s/m.
    pub friction: Option<(f64, f64)>,
}

/// Where contacts are taken from.
#[derive(Debug, Clone, PartialEq)]
pub struct Reference {
    /// File or preset, for the note.
    pub name: String,
    /// Mass its contacts stand for.
    pub mass: Mass,
    /// Spheres that share the body weight.
    pub sphere_count: f64,
    /// Gravity, m/s², where known.
    pub gravity_m_s2: Option<f64>,
    /// Its contacts.
    pub contacts: Vec<ReferenceContact>,
}

impl From<&Preset> for Reference {
    fn from(preset: &Preset) -> Self {
        let mass = Mass {
            kg: preset.scale.mass_kg(),
            source: MassSource::Preset,
            told_by: format!("preset {}", preset.name),
        };
        Self {
            name: preset.name.to_string(),
            mass,
            sphere_count: preset.scale.sphere_count(),
            gravity_m_s2: Some(preset.scale.gravity_m_s2()),
            contacts: vec![ReferenceContact {
                spheres: vec![],
                radii_m: vec![],
                radius_m: preset.scale.radius_m(),
                contact: preset.contact,
                friction: None,
            }],
        }
    }
}

/// Reads the contacts of the forces `selected` of a reference model.
///
/// # Errors
/// A value that is outside its domain.
pub fn reference_of_model(
    model: &Model<'_, '_>,
    selected: &Selected,
    mass: Mass,
    sphere_count: f64,
) -> Result<Reference, Fault> {
    let draft = Draft::new(model);
    let mut contacts = Vec::new();
    for &index in &selected.forces {
        let Some(force) = model.forces.get(index) else { continue };
        let surfaces = Surfaces::of(&draft, index, force)?;
        for (set, spheres) in sphere_sets(model, force) {
            let mut radii_m = Vec::new();
            for &sphere in &spheres {
                radii_m.push(draft.current_radius(sphere)?);
            }
            let radius_m = root_mean_square(radii_m.iter().copied());
            let contact = contact_of_set(&draft, (index, force), &surfaces, set)?;
            let get = |property| draft.current(index, set, property);
            let friction = get(Property::TransitionVelocity)?.zip(get(Property::ViscousFriction)?);
            let names =
                spheres.iter().filter_map(|&s| model.spheres.get(s)).map(|s| s.name.clone()).collect();
            contacts.push(ReferenceContact { spheres: names, radii_m, radius_m, contact, friction });
        }
    }
    let name = model.name.clone();
    Ok(Reference {
        name,
        mass,
        sphere_count,
        gravity_m_s2: model.contacts_gravity().filter(|&g| g > 0.0),
        contacts,
    })
}

/// What is wanted of a transfer.
#[derive(Debug, Clone)]
pub struct Transfer {
    /// Where the contacts come from.
    pub reference: Reference,
    /// `--reference-sphere`: take the contact of this sphere for all.
    pub reference_sphere: Option<String>,
    /// What this model weighs.
    pub mass: Mass,
    /// Spheres that share this model's weight.
    pub sphere_count: f64,
    /// What becomes of the radii.
    pub radius: RadiusRule,
    /// What may change.
    pub properties: PropertySet,
    /// Which size α follows.
    pub dissipation_by: DissipationBy,
    /// Gravity of this model, m/s², where contacts shall follow it.
    pub target_gravity_m_s2: Option<f64>,
    /// New places and radii of the spheres, where they follow their bodies.
    pub follow: Option<Follow>,
    /// Whose scaling.
    pub rule: ScalingRule,
    /// Refuse instead of warning where spheres of one force follow bodies with different factors.
    pub strict: bool,
}

/// How E₁* and α follow from the reference.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum ScalingRule {
    /// (10) and (14).
    #[default]
    Paper,
    /// PredSim's: stiffness by mass over height squared, dissipation by one over height; smoothing stays.
    PredSim {
        /// Height of this model over that of the reference.
        height_ratio: f64,
    },
}

/// Plans a transfer onto the forces `selected` of `model`.
///
/// # Errors
/// As [`super::rescale`]; also when it is not clear which contact of the reference is meant.
pub fn transfer(model: &Model<'_, '_>, selected: &Selected, wanted: &Transfer) -> Result<Plan, Fault> {
    let mut draft = Draft::new(model);
    let chosen = Choice::make(model, selected, wanted)?;
    let reference = &wanted.reference;
    let mass = wanted.mass.kg / reference.mass.kg;
    let isometric = Ratios::isometric(mass).map_err(Fault::new)?.radius();
    let gravity = gravity_ratio(reference.gravity_m_s2, wanted.target_gravity_m_s2)?;
    let followed = |sphere: usize| wanted.follow.as_ref().and_then(|follow| follow.spheres.get(&sphere));
    let rule_of = |sphere: usize| match wanted.radius {
        _ if followed(sphere).is_some() => {
            RadiusRule::Followed(followed(sphere).map_or(f64::NAN, |followed| followed.radius_m))
        }
        // As large against the body as the reference's.
        RadiusRule::Isometric => {
            let radius = chosen.radius_for(model, sphere, &wanted.reference);
            RadiusRule::Like(radius.map_or(f64::NAN, |radius| radius * isometric))
        }
        other => other,
    };
    if wanted.radius == RadiusRule::Isometric && wanted.follow.is_none() {
        chosen.refuse_unclear_radii(model, selected, &wanted.reference)?;
    }
    let radii = Radii::plan(&mut draft, &selected.forces, rule_of, isometric, &wanted.properties)?;
    for (&sphere, place) in wanted.follow.iter().flat_map(|follow| &follow.spheres) {
        draft.location(sphere, place.location_m, "follow")?;
    }
    if wanted.follow.is_some() {
        check_spread(&mut draft, selected, wanted, &chosen, &radii)?;
    }
    radii.warn_mixed(&mut draft, &selected.forces);
    warn_forces(&mut draft, &selected.forces, &wanted.properties);
    let mut without_smoothing = false;
    for &index in &selected.forces {
        let Some(force) = model.forces.get(index) else { continue };
        if several_sets::has_several(&draft, force, wanted) {
            several_sets::plan(&mut draft, (index, force), wanted, &chosen, &radii, gravity)?;
            continue;
        }
        let from = chosen.of_force(model, force)?;
        let radius = radii.mean_new(force) / from.radius_m;
        let values =
            RatioValues { mass, sphere_count: wanted.sphere_count / reference.sphere_count, radius, gravity };
        let target = Target {
            index,
            force,
            from,
            ratios: Ratios::new(values).map_err(Fault::new)?,
            own: Ratios::new(RatioValues {
                mass: 1.0,
                sphere_count: 1.0,
                radius: radii.ratio(force),
                gravity: 1.0,
            })
            .map_err(Fault::new)?,
        };
        without_smoothing |=
            force.kind == ForceKind::SmoothSphereHalfSpace && from.contact.smoothing().is_none();
        target.plan(&mut draft, wanted)?;
    }
    if wanted.follow.is_some() || wanted.rule != ScalingRule::Paper {
        draft.remarks.extend(similarity(model, selected, wanted, &chosen, &radii));
    }
    let whole = !without_smoothing;
    if without_smoothing {
        let text = format!("{} has no smoothing parameters: the model's own stay", reference.name);
        draft.warnings.push(Warning::new(WarningCode::ReferenceWithoutSmoothing, text));
    }
    Ok(finish(draft, wanted, selected.complete && whole, &radii))
}

struct Target<'t> {
    index: usize,
    force: &'t Force,
    from: &'t ReferenceContact,
    ratios: Ratios,
    /// Ratios of this model's own radii, new to old, for what the reference does not give.
    own: Ratios,
}

impl Target<'_> {
    fn plan(&self, draft: &mut Draft<'_, '_, '_>, wanted: &Transfer) -> Result<(), Fault> {
        for property in Property::ALL.into_iter().filter(|&property| wanted.properties.contains(property)) {
            let scaled = match wanted.rule {
                ScalingRule::Paper => factor(property, &self.ratios, wanted.dissipation_by),
                ScalingRule::PredSim { height_ratio } => predsim(property, &self.ratios, height_ratio),
            };
            let Some((factor, equation)) = scaled else { continue };
            match self.of_reference(property) {
                Some(value) => {
                    let to = if factor == 1.0 { value } else { value * factor };
                    write_composite(draft, self.index, property, to, equation)?;
                }
                None => self.carry(draft, property, wanted.dissipation_by)?,
            }
        }
        Ok(())
    }

    fn of_reference(&self, property: Property) -> Option<f64> {
        let smoothing = self.from.contact.smoothing();
        match property {
            Property::Stiffness => Some(self.from.contact.plane_strain_modulus()),
            Property::Dissipation => Some(self.from.contact.dissipation()),
            Property::ConstantContactForce => smoothing.map(|s| s.constant_contact_force),
            Property::HertzSmoothing => smoothing.map(|s| s.hertz_smoothing),
            Property::HuntCrossleySmoothing => smoothing.map(|s| s.hunt_crossley_smoothing),
            Property::TransitionVelocity => self.from.friction.map(|(velocity, _)| velocity),
            Property::ViscousFriction => self.from.friction.map(|(_, viscous)| viscous),
            _ => None,
        }
    }

    /// A changed radius carries along what the reference does not give.
    fn carry(
        &self,
        draft: &mut Draft<'_, '_, '_>,
        property: Property,
        by: DissipationBy,
    ) -> Result<(), Fault> {
        let Some((factor, equation)) = factor(property, &self.own, by) else { return Ok(()) };
        for set in 0..self.force.sets.len() {
            if let Some(from) = draft.current(self.index, set, property)? {
                draft.parameter(self.index, set, property, New::times(from, factor, equation))?;
            }
        }
        Ok(())
    }
}

fn finish(draft: Draft<'_, '_, '_>, wanted: &Transfer, complete: bool, radii: &Radii) -> Plan {
    let Draft { model, changes, moves, mut warnings, remarks, .. } = draft;
    let mut remarks = remarks;
    if changes.is_empty() {
        let text = "every value is already as the reference wants it";
        warnings.push(Warning::new(WarningCode::NothingToChange, text));
    } else {
        if wanted.follow.is_some() {
            remarks.push("body masses stay as they are; spheres follow their bodies".to_owned());
        } else {
            remarks.push("body masses and sphere locations stay as they are".to_owned());
            remarks.extend(bottoms_remark(radii));
        }
    }
    let reference = &wanted.reference;
    let taken = format!(
        "contacts of {} ({} kg, {}; n = {}) for {} kg ({}; n = {})",
        reference.name,
        readable(reference.mass.kg),
        reference.mass.told_by,
        reference.sphere_count,
        readable(wanted.mass.kg),
        wanted.mass.told_by,
        wanted.sphere_count
    );
    let plan = Plan {
        changes,
        moves,
        masses: Some(Masses { from: reference.mass.clone(), to_kg: wanted.mass.kg }),
        taken,
        warnings,
        remarks,
        note: None,
        note_anyway: false,
    };
    let all = complete && wanted.properties.is_complete();
    plan.with_note(
        model,
        &NoteFacts {
            mass_kg: Some(wanted.mass.kg),
            // Without a target, what the reference's contacts stand for.
            gravity_m_s2: wanted.target_gravity_m_s2.or(wanted.reference.gravity_m_s2).or(model.gravity()),
            scope: if all { Scope::All } else { Scope::Partial },
            operation: "transfer",
        },
    )
}
