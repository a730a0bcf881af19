//! What a transfer does beside the paper's rule: PredSim's, the spread of factors, and figures to compare them by.

use contact_scaling::{Contact, DimensionlessContact, Ratios, Scale, ScaleValues, restitution};

use super::choice::Choice;
use super::draft::Draft;
use super::radii::Radii;
use super::transfer::{ScalingRule, Transfer};
use crate::error::Fault;
use crate::model::Model;
use crate::property::Property;
use crate::select::Selected;
use crate::warning::{Warning, WarningCode};

/// More than this between the factors of one force's spheres is said (relative).
const SPREAD: f64 = 0.01;

/// PredSim's rule, for users who compare; what it does not scale is the reference's.
pub(super) fn predsim(property: Property, ratios: &Ratios, height_ratio: f64) -> Option<(f64, &'static str)> {
    Some(match property {
        Property::Stiffness => (ratios.mass() / (height_ratio * height_ratio), "predsim"),
        Property::Dissipation => (1.0 / height_ratio, "predsim"),
        Property::ConstantContactForce | Property::HertzSmoothing | Property::HuntCrossleySmoothing => {
            (1.0, "predsim")
        }
        _ => return None,
    })
}

/// Spheres of one modulus that follow bodies of different factors.
pub(super) fn check_spread(
    draft: &mut Draft<'_, '_, '_>,
    selected: &Selected,
    wanted: &Transfer,
    chosen: &Choice<'_>,
    radii: &Radii,
) -> Result<(), Fault> {
    let model = draft.model;
    for force in selected.forces.iter().filter_map(|&index| model.forces.get(index)) {
        // Radii of a reference force stand for all its spheres; what differs here is the bodies' factors.
        let old = |sphere: usize| match wanted.follow.as_ref().and_then(|follow| follow.old_radius(sphere)) {
            Some(radius) => radius,
            None => chosen.of_sphere(model, sphere).radius_m,
        };
        let spread = radii.spread(force, old);
        if spread <= 1.0 + SPREAD {
            continue;
        }
        let text = format!(
            "{}: its spheres grow by factors that differ by {:.1} %; the mean of R squared is used",
            force.path,
            (spread - 1.0) * 100.0
        );
        if wanted.strict {
            return Err(
                Fault::refused(format!("{text} (refused because of --strict)")).of(force.path.clone())
            );
        }
        draft.warnings.push(Warning::at(WarningCode::FactorSpread, force.line, text));
    }
    Ok(())
}

/// x̂ at body weight and c_r of the reference and of the result, so that rules can be compared.
pub(super) fn similarity(
    model: &Model<'_, '_>,
    selected: &Selected,
    wanted: &Transfer,
    chosen: &Choice<'_>,
    radii: &Radii,
) -> Option<String> {
    let force = selected.forces.iter().find_map(|&index| model.forces.get(index))?;
    let from = chosen.of_force(model, force).ok()?;
    let gravity = wanted.reference.gravity_m_s2.or(model.gravity()).filter(|&gravity| gravity > 0.0)?;
    let here_gravity = model.gravity().filter(|&gravity| gravity > 0.0)?;
    let there = Scale::new(ScaleValues {
        mass_kg: wanted.reference.mass.kg,
        radius_m: from.radius_m,
        sphere_count: wanted.reference.sphere_count,
        gravity_m_s2: gravity,
    });
    let here = Scale::new(ScaleValues {
        mass_kg: wanted.mass.kg,
        radius_m: radii.mean_new(force),
        sphere_count: wanted.sphere_count,
        gravity_m_s2: here_gravity,
    });
    let (there, here) = (there.ok()?, here.ok()?);
    let contact = match wanted.rule {
        ScalingRule::Paper => from.contact.scaled(&Ratios::between(&there, &here).ok()?),
        ScalingRule::PredSim { height_ratio } => {
            let mut values = from.contact.values();
            values.plane_strain_modulus *=
                wanted.mass.kg / wanted.reference.mass.kg / (height_ratio * height_ratio);
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
    Some(format!(
        "relative indentation at body weight {x_there:.4} in the reference, {x_here:.4} here; \
         restitution (exact law) at sqrt(gR/2) {c_there:.4} and {c_here:.4}"
    ))
}
