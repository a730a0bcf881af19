//! Remarks about a transfer whose spheres follow their bodies: the spread of their factors, and figures to compare by.

use contact_scaling::{Contact, DimensionlessContact, RatioValues, Ratios, Scale, ScaleValues, restitution};
use osim_model::messages::Phrase;
use osim_model::{Fault, FaultKind, Model, Selected, SphereId};

use super::choice::Choice;
use super::request::{ScalingRule, Transfer};
use crate::builder::PlanBuilder;
use crate::radii::Radii;
use crate::rules::factor_spread;

/// Spheres of one modulus that follow bodies of different factors.
pub(crate) fn check_spread(
    plan: &mut PlanBuilder<'_>,
    selected: &Selected,
    wanted: &Transfer,
    chosen: &Choice<'_>,
    radii: &Radii,
) -> Result<(), Fault> {
    let model = plan.model;
    for force in selected.forces.iter().filter_map(|&id| model.force(id)) {
        // A reference force has one radius for all its spheres; what differs here is the bodies' factors.
        let old = |sphere: SphereId| match wanted.follow.as_ref().and_then(|follow| follow.old_radius(sphere))
        {
            Some(radius) => radius,
            None => chosen.of_sphere(model, sphere).radius_m,
        };
        let Some(text) = factor_spread::message(force, radii.spread(force, old)) else { continue };
        if wanted.strict {
            return Err(Fault::new(FaultKind::StrictlyRefused { text }).of(force.path.clone()));
        }
        plan.warnings.push(factor_spread::of_force(force, text));
    }
    Ok(())
}

/// x̂ at body weight and c_r of the reference and of the result, so that rules can be compared.
pub(crate) fn similarity(
    model: &Model,
    selected: &Selected,
    wanted: &Transfer,
    chosen: &Choice<'_>,
    radii: &Radii,
    gravity_ratio: f64,
) -> Option<Phrase> {
    // Without a count nothing is known of indentations.
    if wanted.counts_cancel {
        return None;
    }
    let force = selected.forces.iter().find_map(|&id| model.force(id))?;
    let from = chosen.of_force(model, force).ok()?;
    let gravity = wanted.reference.gravity_m_s2.or(model.gravity()).filter(|&gravity| gravity > 0.0)?;
    let here_gravity = wanted.target_gravity_m_s2.or(model.gravity()).filter(|&gravity| gravity > 0.0)?;
    let there = Scale::new(ScaleValues {
        mass_kg: wanted.reference.mass.kg,
        radius_m: from.radius_m,
        sphere_count: wanted.reference.sphere_count,
        gravity_m_s2: gravity,
    });
    let here = Scale::new(ScaleValues {
        mass_kg: wanted.target_mass.kg,
        radius_m: radii.mean_new(force),
        sphere_count: wanted.sphere_count,
        gravity_m_s2: here_gravity,
    });
    let (there, here) = (there.ok()?, here.ok()?);
    let contact = match wanted.rule {
        ScalingRule::Paper => {
            let values = RatioValues {
                mass: wanted.target_mass.kg / wanted.reference.mass.kg,
                sphere_count: wanted.sphere_count / wanted.reference.sphere_count,
                radius: radii.mean_new(force) / from.radius_m,
                gravity: gravity_ratio,
            };
            from.contact.scaled(&Ratios::new(values).ok()?)
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
    let text = format!(
        "relative indentation at body weight {x_there:.4} in the reference, {x_here:.4} here; \
         restitution (exact law) at sqrt(gR/2) {c_there:.4} and {c_here:.4}"
    );
    Some(text.into())
}
