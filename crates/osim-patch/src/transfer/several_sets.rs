//! A force whose spheres have materials of their own and follow their bodies: one factor multiplies them all.

use contact_scaling::{RatioValues, Ratios};
use osim_model::{Fault, Force, Property, SphereId, Surfaces, sphere_sets};

use super::choice::Choice;
use super::predsim::predsim;
use super::request::{ScalingRule, Transfer};
use crate::builder::{New, PlanBuilder};
use crate::radii::Radii;
use crate::scaling::factor;

/// Factors this close (relative) are one.
const SAME_FACTOR: f64 = 1e-6;

/// Whether the spheres of `force` have several ContactParameters, each matched by name with the reference.
pub(crate) fn has_several(plan: &PlanBuilder<'_>, force: &Force, wanted: &Transfer) -> bool {
    let paired = wanted.follow.is_some() && wanted.reference_sphere.is_none();
    paired && sphere_sets(plan.model, force).len() > 1
}

/// Plans the parameters of such a force: each sphere's own contact in the reference, scaled by the mean of R² over all.
///
/// # Errors
/// Materials that would need different factors.
pub(crate) fn plan(
    plan: &mut PlanBuilder<'_>,
    force: &Force,
    wanted: &Transfer,
    chosen: &Choice<'_>,
    radii: &Radii,
    gravity: f64,
) -> Result<(), Fault> {
    let ratios = Ratios::new(RatioValues {
        mass: wanted.target_mass.kg / wanted.reference.mass.kg,
        sphere_count: wanted.sphere_count / wanted.reference.sphere_count,
        radius: radius_ratio(plan, force, wanted, radii),
        gravity,
    })
    .map_err(Fault::new)?;
    for property in Property::ALL.into_iter().filter(|&property| wanted.properties.contains(property)) {
        let scaled = match wanted.rule {
            ScalingRule::Paper => factor(property, &ratios, wanted.dissipation_by),
            ScalingRule::PredSim { height_ratio } => predsim(property, &ratios, height_ratio),
        };
        let Some((factor, equation)) = scaled else { continue };
        let factor = factor * against_reference(plan, force, chosen, property)?;
        for set in &force.sets {
            if let Some(from) = force.checked(set.id, property)? {
                plan.parameter(force.id, set.id, property, New::times(from, factor, equation))?;
            }
        }
    }
    Ok(())
}

/// Root of the mean R² over all spheres of the force, here and in the reference.
fn radius_ratio(plan: &PlanBuilder<'_>, force: &Force, wanted: &Transfer, radii: &Radii) -> f64 {
    let spheres: Vec<SphereId> =
        sphere_sets(plan.model, force).into_iter().flat_map(|(_, set)| set).collect();
    let old: Vec<f64> = spheres
        .iter()
        .filter_map(|&sphere| wanted.follow.as_ref().and_then(|follow| follow.old_radius(sphere)))
        .collect();
    #[expect(clippy::cast_precision_loss, reason = "sphere counts are small")]
    let mean = old.iter().map(|radius| radius * radius).sum::<f64>() / old.len() as f64;
    radii.mean_new(force) / mean.sqrt()
}

/// The reference's E₁* or α over this model's, as spheres and plane make it together; 1 where they are the same.
fn against_reference(
    plan: &PlanBuilder<'_>,
    force: &Force,
    chosen: &Choice<'_>,
    property: Property,
) -> Result<f64, Fault> {
    let surfaces = Surfaces::of(force)?;
    let mut common: Option<f64> = None;
    for (set, spheres) in sphere_sets(plan.model, force) {
        let Some(&sphere) = spheres.first() else { continue };
        let contact = chosen.of_sphere(plan.model, sphere).contact;
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
        if common.is_some_and(|other| (other - ratio).abs() > SAME_FACTOR * other) || !ratio.is_finite() {
            return Err(different(force, property));
        }
        common.get_or_insert(ratio);
    }
    Ok(common.unwrap_or(1.0))
}

fn different(force: &Force, property: Property) -> Fault {
    Fault::refused(format!(
        "the materials of {} were changed since the reference, each in its own way: one factor of {property} cannot \
         serve all; give each sphere a force of its own",
        force.path
    ))
    .of(force.path.clone())
}
