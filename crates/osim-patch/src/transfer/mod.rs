//! Transfers the contacts of a reference to a model of another size: (10), (14), (C.2), (C.5), (C.10).

mod contact_choice;
mod reference;

use contact_scaling::{Contact, DimensionlessContact, Ratios, Scale, ScaleValues, restitution};
use osim_model::compare::Follow;
use osim_model::messages::{Phrase, four_significant, phrase};
use osim_model::{
    Fault, FaultKind, Finding, Force, ForceKind, GravityFor, Mass, Model, Property, RadiusRule, Result,
    Selected, SphereId,
};

use crate::builder::{PlanBuilder, change_composite, scale_with_radius};
use crate::change::{ChangedBy, GravityChange};
use crate::new_radii::{Radii, SphereRadiusRule};
use crate::note_edits::NotedMass;
use crate::objects::keeps_sphere_inside;
use crate::plan::{Masses, NoteFacts, Plan, TRANSFER_OPERATION};
use crate::rules::{self, REMARK_PLACES_STAY, warn_forces};
use crate::transfer::contact_choice::{ContactChoice, ReferenceRadii};

pub use reference::{
    Reference, ReferenceContact, ScalingRule, Transfer, reference_of_layout, reference_of_model,
};

/// Plans a transfer onto the forces `selected` of `model`, by (10), (14), (C.2), (C.5) and (C.10): see [`Transfer`] for an
/// example.
///
/// # Errors
/// - The errors of [`rescale`](crate::rescale).
/// - It is not clear which contact of the reference a sphere gets, or which radius
///   ([`MissingFact::ReferenceContact`](osim_model::MissingFact::ReferenceContact),
///   [`MissingFact::ReferenceContactOfForce`](osim_model::MissingFact::ReferenceContactOfForce),
///   [`MissingFact::ReferenceRadius`](osim_model::MissingFact::ReferenceRadius)), or the reference has no such sphere
///   ([`FaultKind::UnknownReferenceSphere`]).
/// - A force that keeps its sphere inside itself, as in Moco 0.1 to 0.3 ([`FaultKind::SphereInsideForce`]).
/// - Spheres of one force move with bodies of different scale factors, and [`Transfer::strict`] is set
///   ([`FaultKind::StrictlyRefused`]).
pub fn transfer(model: &Model, selected: &Selected, wanted: &Transfer) -> Result<Plan> {
    let mut forces = selected.forces.iter().filter_map(|&id| model.force(id));
    if let Some(force) = forces.find(|force| keeps_sphere_inside(model, force)) {
        // OpenSim could not read the result.
        let kind = FaultKind::SphereInsideForce { force: force.path.clone() };
        return Err(Fault::new(kind).at_element(force.path.clone()).in_file(force.file));
    }
    let mut plan = PlanBuilder::new(model);
    let chosen = ContactChoice::new(model, selected, wanted)?;
    let reference = &wanted.reference;
    let mass = wanted.target_mass.kg / reference.mass.kg;
    let isometric = Ratios::isometric(mass).map_err(Fault::new)?.radius();
    let change =
        GravityChange::new(reference.gravity_m_s2, wanted.target_gravity_m_s2, GravityFor::Reference)?;
    let gravity = change.ratio;
    let followed = |sphere: SphereId| wanted.follow.as_ref().and_then(|follow| follow.sphere(sphere));
    let reference_radii = ReferenceRadii::of(&wanted.reference);
    let rule_of = |sphere: SphereId| match (followed(sphere), wanted.radius) {
        (Some(followed), RadiusRule::Isometric) => SphereRadiusRule::Like(followed.radius_m),
        (Some(followed), RadiusRule::Metres(_)) => {
            SphereRadiusRule::Rule(RadiusRule::Metres(followed.radius_m))
        }
        (Some(followed), _) => SphereRadiusRule::Followed(followed.radius_m),
        // As large against the body as the reference's.
        (None, RadiusRule::Isometric) => {
            let radius = chosen.radius_for(model, sphere, &reference_radii);
            SphereRadiusRule::Like(radius.map_or(f64::NAN, |radius| radius * isometric))
        }
        (None, other) => SphereRadiusRule::Rule(other),
    };
    if wanted.radius == RadiusRule::Isometric && wanted.follow.is_none() {
        chosen.refuse_unclear_radii(model, selected, &wanted.reference)?;
    }
    let radii = Radii::plan(&mut plan, &selected.forces, rule_of, isometric, &wanted.properties)?;
    for (sphere, place) in wanted.follow.iter().flat_map(Follow::spheres) {
        plan.move_sphere(sphere, place.location_m, ChangedBy::Follow)?;
    }
    if let Some(axis) = wanted.level.filter(|_| wanted.follow.is_none()) {
        radii.keep_bottoms(&mut plan, axis)?;
    }
    if wanted.follow.is_some() {
        check_factor_spread(&mut plan, selected, wanted, &chosen, &radii)?;
    }
    warn_forces(&mut plan, &selected.forces, &wanted.properties);
    let mut without_smoothing = false;
    for force in selected.forces.iter().filter_map(|&id| model.force(id)) {
        if contact_choice::has_several_sets(&plan, force, wanted) {
            contact_choice::plan_several_sets(&mut plan, force, wanted, &chosen, &radii, gravity)?;
            continue;
        }
        let from = chosen.contact_for_force(model, force)?;
        let radius = radii.rms_new_radius(force) / from.radius_m;
        let (ratios, own) = (wanted.ratios(radius, gravity)?, radii.own_ratios(model, force)?);
        let target = TargetForce { force, from, ratios, own };
        without_smoothing |=
            force.kind == ForceKind::SmoothSphereHalfSpace && from.contact.smoothing().is_none();
        target.plan(&mut plan, wanted)?;
    }
    if let Some(follow) = &wanted.follow
        && wanted.rule == ScalingRule::Paper
        && wanted.properties.contains(Property::Radius)
    {
        plan.remarks.extend(rules::remark_on_radii(follow, wanted.radius, isometric));
    }
    if wanted.follow.is_some() || wanted.rule != ScalingRule::Paper {
        plan.remarks.extend(compare_with_reference(model, selected, wanted, &chosen, &radii, gravity));
    }
    let whole = !without_smoothing;
    if without_smoothing {
        let text = format!("{} has no smoothing parameters: the model's own stay", reference.name);
        plan.findings.push(Finding::new(&rules::REFERENCE_WITHOUT_SMOOTHING, text));
    }
    Ok(plan_with_note_and_remarks(plan, wanted, selected.complete && whole, &radii, change))
}

/// A force of the model, with the contact of the reference that it gets and the ratios to it.
struct TargetForce<'t> {
    force: &'t Force,
    from: &'t ReferenceContact,
    ratios: Ratios,
    /// Ratios of new to old radii of this model, for properties that the reference does not have.
    own: Ratios,
}

impl TargetForce<'_> {
    /// Plans the parameters of this force.
    fn plan(&self, plan: &mut PlanBuilder<'_>, wanted: &Transfer) -> Result<()> {
        for property in Property::changeable().filter(|&property| wanted.properties.contains(property)) {
            let Some((factor, by)) = wanted.factor(property, &self.ratios) else { continue };
            match self.reference_value(property) {
                Some(value) => {
                    if property == Property::Dissipation && wanted.rule == ScalingRule::Paper {
                        let lengths = wanted.length_ratio;
                        rules::remark_on_dissipation(&mut plan.remarks, &self.ratios, value, lengths);
                    }
                    let to = if factor == 1.0 { value } else { value * factor };
                    change_composite(plan, self.force.id, property, to, by)?;
                }
                None => scale_with_radius(plan, self.force, property, &self.own, wanted.dissipation_by)?,
            }
        }
        Ok(())
    }

    /// The value of a property in the reference; `None` if it has none.
    fn reference_value(&self, property: Property) -> Option<f64> {
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
}

/// The plan of a transfer, with its note and its remarks.
fn plan_with_note_and_remarks(
    plan: PlanBuilder<'_>,
    wanted: &Transfer,
    complete: bool,
    radii: &Radii,
    gravity: GravityChange,
) -> Plan {
    let PlanBuilder { model, changes, moves, mut findings, mut remarks, .. } = plan;
    if changes.is_empty() && moves.is_empty() {
        findings.push(rules::nothing_to_change("every value is already as the reference wants it"));
    } else if wanted.follow.is_some() {
        remarks.push("body masses stay as they are; spheres follow their bodies".into());
    } else if !moves.is_empty() {
        remarks.push(rules::REMARK_LEVEL.into());
    } else {
        remarks.push(REMARK_PLACES_STAY.into());
        rules::remark_on_bottoms(&mut remarks, Some(radii));
    }
    if !changes.is_empty() {
        remarks.extend(rules::remark_on_gravity(model, wanted.target_gravity_m_s2));
    }
    let reference = &wanted.reference;
    let count = |count: f64| match wanted.counts_cancel {
        true if count == 1.0 => "spheres one to one".to_owned(),
        true => format!("spheres one to one, on {count} times as many limbs"),
        false => format!("n = {count}"),
    };
    let mut taken = phrase![
        "contacts of {} ({} kg, {}; {}) for {} kg ({}; {})";
        reference.name.to_string(), four_significant(reference.mass.kg), &reference.mass.source.describe(),
        count(reference.sphere_count).to_string(), four_significant(wanted.target_mass.kg),
        &wanted.target_mass.source.describe(), count(wanted.sphere_count).to_string()
    ];
    if wanted.rule == ScalingRule::Paper {
        taken.push(gravity.words);
    }
    let masses =
        Some(Masses { contacts_mass: reference.mass.clone(), target_mass_kg: wanted.target_mass.kg });
    let all = complete && wanted.properties.is_complete();
    Plan::new(
        model,
        Plan { changes, moves, masses, taken, findings, remarks, ..Plan::default() },
        &NoteFacts {
            followed: wanted.follow.as_ref().map(|_| radii.spheres()).as_ref(),
            made: NotedMass::new(Some(wanted.target_mass.kg), all),
            // Without a target, the gravity that the reference's contacts were made for.
            gravity_m_s2: wanted.target_gravity_m_s2.or(wanted.reference.gravity_m_s2).or(model.gravity()),
            operation: TRANSFER_OPERATION,
        },
    )
}

// Remarks about a transfer whose spheres follow their bodies: the spread of their factors, and figures to compare by.

/// Warns of a force with one modulus whose spheres follow bodies with different factors, or refuses it if strict.
fn check_factor_spread(
    plan: &mut PlanBuilder<'_>,
    selected: &Selected,
    wanted: &Transfer,
    chosen: &ContactChoice<'_>,
    radii: &Radii,
) -> Result<()> {
    let model = plan.model;
    for force in selected.forces.iter().filter_map(|&id| model.force(id)) {
        // A reference force has one radius for all its spheres; what differs here is the bodies' factors.
        let followed = |sphere| wanted.follow.as_ref().and_then(|follow| follow.old_radius(sphere));
        let of_reference = |sphere| chosen.contact_for_sphere(model, sphere).radius_m;
        let old = |sphere: SphereId| followed(sphere).unwrap_or_else(|| of_reference(sphere));
        let Some(text) = rules::factor_spread_message(force, radii.ratio_spread(force, old)) else {
            continue;
        };
        if wanted.strict {
            return Err(Fault::new(FaultKind::StrictlyRefused { text }).at_element(force.path.clone()));
        }
        plan.findings.push(Finding::at(&rules::FACTOR_SPREAD, force.position, text));
    }
    Ok(())
}

/// Numbers with a smaller relative difference than this look equal to a reader.
const LOOKS_EQUAL_TOLERANCE: f64 = 1e-3;

/// A remark that compares x̂ under body weight and c_r between the reference and the result.
fn compare_with_reference(
    model: &Model,
    selected: &Selected,
    wanted: &Transfer,
    chosen: &ContactChoice<'_>,
    radii: &Radii,
    gravity_ratio: f64,
) -> Option<Phrase> {
    // Without a count nothing is known of indentations.
    if wanted.counts_cancel {
        return None;
    }
    let force = selected.forces.iter().find_map(|&id| model.force(id))?;
    let from = chosen.contact_for_force(model, force).ok()?;
    let gravity = wanted.reference.gravity_m_s2.or(model.gravity()).filter(|&gravity| gravity > 0.0)?;
    let here_gravity = wanted.target_gravity_m_s2.or(model.gravity()).filter(|&gravity| gravity > 0.0)?;
    let scale = |mass: &Mass, radius_m: f64, sphere_count: f64, gravity_m_s2: f64| {
        Scale::new(ScaleValues { mass_kg: mass.kg, radius_m, sphere_count, gravity_m_s2 }).ok()
    };
    let (reference, new_radius_m) = (&wanted.reference, radii.rms_new_radius(force));
    let there = scale(&reference.mass, from.radius_m, reference.sphere_count, gravity)?;
    let here = scale(&wanted.target_mass, new_radius_m, wanted.sphere_count, here_gravity)?;
    let contact = match wanted.rule {
        ScalingRule::Paper => {
            from.contact.scaled(&wanted.ratios(new_radius_m / from.radius_m, gravity_ratio).ok()?)
        }
        ScalingRule::PredSim { height_ratio } => {
            let mut values = from.contact.values();
            values.plane_strain_modulus *=
                wanted.target_mass.kg / wanted.reference.mass.kg / (height_ratio * height_ratio);
            values.dissipation /= height_ratio;
            Contact::new(values).ok()?
        }
    };
    let describe = |contact: &Contact, scale: &Scale| {
        let x = DimensionlessContact::of(contact, scale).relative_indentation();
        let speed = restitution::drop_speed(scale.gravity_m_s2(), scale.radius_m()).ok()?;
        restitution::exact(contact.dissipation(), speed).map(|restitution| (x, restitution)).ok()
    };
    let (x_there, c_there) = describe(&from.contact, &there)?;
    let (x_here, c_here) = describe(&contact, &here)?;
    let as_much = |here: f64, there: f64| (here / there - 1.0).abs() < LOOKS_EQUAL_TOLERANCE;
    let text = if as_much(x_here, x_there) && as_much(c_here, c_there) {
        format!(
            "the contacts sink in as deep ({x_here:.3} R) and bounce as much ({c_here:.3}) as in the reference"
        )
    } else {
        format!(
            "the contacts sink in {x_here:.3} R (in the reference {x_there:.3} R), and their restitution is {c_here:.3} \
             (there {c_there:.3})"
        )
    };
    Some(text.into())
}
