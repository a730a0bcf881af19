//! Rescaling a model's own contacts to another mass: every parameter times its ratio.

use contact_scaling::{RatioValues, Ratios};

use super::draft::{Draft, New, PropertySet};
use super::radii::{Radii, RadiusRule};
use super::{DissipationBy, Masses, NoteFacts, Plan};
use crate::error::{Fault, FaultKind};
use crate::follow::LevelAxis;
use crate::mass::{Mass, checked, same_mass};
use crate::model::{ForceKind, Model};
use crate::note::Scope;
use crate::number::{readable, shortest};
use crate::property::Property;
use crate::select::Selected;
use crate::warning::{Warning, WarningCode};

/// What is wanted of a rescaling.
#[derive(Debug, Clone)]
pub struct Rescale {
    /// The mass the contacts shall stand for, kg.
    pub target_mass_kg: f64,
    /// The mass they stand for now.
    pub contacts_mass: Mass,
    /// What becomes of the radii.
    pub radius: RadiusRule,
    /// What may change.
    pub properties: PropertySet,
    /// Which size α follows.
    pub dissipation_by: DissipationBy,
    /// Gravity afterwards, m/s², where it differs. What the contacts stand for now is the note's, else the model's.
    pub target_gravity_m_s2: Option<f64>,
    /// Gravity the contacts stand for now, m/s², where the note and the model do not say it rightly.
    pub contacts_gravity_m_s2: Option<f64>,
    /// Move sphere centres so that their bottoms stay where they are.
    pub level: Option<LevelAxis>,
}

/// Plans a rescaling of the forces `selected` of `model`.
///
/// # Errors
/// A value that cannot be scaled, a sphere another force needs as it is, or a quantity outside its domain.
pub fn rescale(model: &Model<'_, '_>, selected: &Selected, wanted: &Rescale) -> Result<Plan, Fault> {
    let target = checked("--target-mass", wanted.target_mass_kg)?;
    let origin = wanted.contacts_mass.kg;
    let mut draft = Draft::new(model);
    let gravity = gravity_now(model, wanted)?;
    let gravity = gravity_ratio(gravity, wanted.target_gravity_m_s2)?;
    let other_radius = matches!(wanted.radius, RadiusRule::Metres(_) | RadiusRule::Factor(_));
    if same_mass(target, origin) && gravity == 1.0 && !other_radius {
        draft.warnings.push(already_there(origin, &wanted.contacts_mass));
        return Ok(finish(draft, wanted, selected, None));
    }
    let mass = target / origin;
    let isometric = Ratios::isometric(mass).map_err(Fault::new)?.radius();
    let radii = Radii::plan(&mut draft, &selected.forces, |_| wanted.radius, isometric, &wanted.properties)?;
    if let Some(axis) = wanted.level {
        radii.level(&mut draft, axis)?;
    }
    radii.warn_mixed(&mut draft, &selected.forces);
    warn_forces(&mut draft, &selected.forces, &wanted.properties);
    for &index in &selected.forces {
        let Some(force) = model.forces.get(index) else { continue };
        let values = RatioValues { mass, sphere_count: 1.0, radius: radii.ratio(force), gravity };
        let ratios = Ratios::new(values).map_err(Fault::new)?;
        if force.sets.iter().filter(|set| !set.spheres.is_empty() || set.half_spaces > 0).count() > 1 {
            let text =
                format!("{} has {} ContactParameters: all get the same factor", force.path, force.sets.len());
            draft.warnings.push(Warning::at(WarningCode::SeveralParameterSets, force.line, text));
        }
        for set in 0..force.sets.len() {
            scale_set(&mut draft, (index, set), &ratios, wanted)?;
        }
    }
    if draft.changes.is_empty() {
        let text = "every factor is exactly 1: the radius stays, so what follows the radius stays too";
        draft.warnings.push(Warning::new(WarningCode::NothingToChange, text));
    }
    Ok(finish(draft, wanted, selected, Some(&radii)))
}

/// The factor and equation of each property.
pub(super) fn factor(property: Property, ratios: &Ratios, by: DissipationBy) -> Option<(f64, &'static str)> {
    Some(match property {
        Property::Stiffness => (ratios.plane_strain_modulus(), "10"),
        Property::Dissipation => match by {
            DissipationBy::Radius => (ratios.dissipation(), "14"),
            DissipationBy::Mass => (ratios.dissipation_by_mass(), "14"),
        },
        Property::ConstantContactForce => (ratios.constant_contact_force(), "C.2"),
        Property::HertzSmoothing => (ratios.hertz_smoothing(), "C.5"),
        Property::HuntCrossleySmoothing => (ratios.hunt_crossley_smoothing(), "C.10"),
        Property::TransitionVelocity => (ratios.transition_velocity(), "friction"),
        Property::ViscousFriction => (ratios.viscous_friction(), "friction"),
        _ => return None,
    })
}

fn scale_set(
    draft: &mut Draft<'_, '_, '_>,
    (force, set): (usize, usize),
    ratios: &Ratios,
    wanted: &Rescale,
) -> Result<(), Fault> {
    for property in Property::ALL.into_iter().filter(|&property| wanted.properties.contains(property)) {
        let Some((factor, equation)) = factor(property, ratios, wanted.dissipation_by) else { continue };
        if let Some(from) = draft.current(force, set, property)? {
            draft.parameter(force, set, property, New::times(from, factor, equation))?;
        }
    }
    Ok(())
}

/// Gravity that the contacts stand for; a doubtful note is not taken at its word where a factor depends on it.
fn gravity_now(model: &Model<'_, '_>, wanted: &Rescale) -> Result<Option<f64>, Fault> {
    let noted = model.note.as_ref().and_then(|note| note.gravity_m_s2);
    let differs = noted.is_some() && noted != model.gravity();
    match (wanted.contacts_gravity_m_s2, model.doubt_about_note()) {
        (Some(given), _) => Ok(Some(given)),
        (None, Some(why)) if wanted.target_gravity_m_s2.is_some() && differs => {
            Err(Fault::new(FaultKind::NeedsAnswer {
                code: "stale-note",
                question: format!("which gravity the contacts stand for is not certain: {why}"),
                way_out: "say it with --contacts-gravity G".to_owned(),
            }))
        }
        _ => Ok(model.contacts_gravity()),
    }
}

/// γ = g_b/g_a where a target is given, else 1.
pub(super) fn gravity_ratio(now: Option<f64>, target: Option<f64>) -> Result<f64, Fault> {
    let Some(target) = target else { return Ok(1.0) };
    if !(target.is_finite() && target > 0.0) {
        return Err(Fault::refused(format!(
            "--target-gravity is {target}, expected an acceleration in m/s2 above 0"
        )));
    }
    match now {
        Some(now) if now.is_finite() && now > 0.0 => Ok(target / now),
        _ => Err(Fault::refused(
            "--target-gravity needs the gravity that the contacts stand for now, and the model has none: say it with \
             --contacts-gravity G (in a transfer: --reference-gravity G)",
        )),
    }
}

fn already_there(origin: f64, mass: &Mass) -> Warning {
    let kg = shortest(origin);
    Warning::new(
        WarningCode::AlreadyAtTarget,
        format!(
            "contacts are taken to stand for {kg} kg already ({}); if they were made for another mass, \
             say --contacts-mass KG or transfer --from MODEL",
            mass.told_by
        ),
    )
}

fn finish(draft: Draft<'_, '_, '_>, wanted: &Rescale, selected: &Selected, radii: Option<&Radii>) -> Plan {
    let Draft { model, changes, moves, warnings, .. } = draft;
    let mut remarks = Vec::new();
    if !changes.is_empty() {
        if moves.is_empty() {
            remarks.push("body masses and sphere locations stay as they are".to_owned());
            remarks.extend(radii.and_then(bottoms_remark));
        } else {
            remarks.push("body masses stay as they are; sphere centres move so that bottoms stay".to_owned());
        }
        if wanted.target_gravity_m_s2.is_some() {
            remarks.push("the model's own <gravity> stays as it is: set it in OpenSim".to_owned());
        }
    }
    let to_mass_kg = if changes.is_empty() { wanted.contacts_mass.kg } else { wanted.target_mass_kg };
    let from_mass = wanted.contacts_mass.clone();
    let mut taken = format!("contacts stand for {} kg ({})", readable(from_mass.kg), from_mass.told_by);
    if !changes.is_empty() {
        let ratio = readable(to_mass_kg / from_mass.kg);
        taken.push_str(&format!("; scaled to {} kg (mass x{ratio})", readable(to_mass_kg)));
    }
    let masses = Some(Masses { from: from_mass, to_kg: to_mass_kg });
    let plan = Plan { changes, moves, masses, taken, warnings, remarks, note: None, note_anyway: false };
    let all = selected.complete && wanted.properties.is_complete();
    plan.with_note(
        model,
        &NoteFacts {
            mass_kg: Some(wanted.target_mass_kg),
            gravity_m_s2: wanted.target_gravity_m_s2.or(model.contacts_gravity()),
            scope: if all { Scope::All } else { Scope::Partial },
            operation: "rescale",
        },
    )
}

/// Says what is special about the chosen forces.
pub(super) fn warn_forces(draft: &mut Draft<'_, '_, '_>, forces: &[usize], properties: &PropertySet) {
    let model = draft.model;
    for force in forces.iter().filter_map(|&index| model.forces.get(index)) {
        if !force.applies {
            let text = format!("{} is switched off; it is changed with the others", force.path);
            draft.warnings.push(Warning::at(WarningCode::DisabledForce, force.line, text));
        }
    }
    let smooth = |&index: &usize| {
        model.forces.get(index).is_some_and(|force| force.kind == ForceKind::SmoothSphereHalfSpace)
    };
    if properties.contains(Property::TransitionVelocity) && forces.iter().any(smooth) {
        let text = "friction of SmoothSphereHalfSpaceForce scales only as far as constant_contact_force is small \
                    against the squared slip speed";
        draft.warnings.push(Warning::new(WarningCode::FrictionNotSimilar, text));
    }
}

/// How far the soles move because radii change and centres do not.
pub(super) fn bottoms_remark(radii: &Radii) -> Option<String> {
    let (least, most) = radii.bottoms()?;
    let mm = |metres: f64| {
        let millimetres = metres.abs() * 1e3;
        if millimetres < 1e6 { format!("{millimetres:.2}") } else { readable(millimetres) }
    };
    let way = |metres: f64| if metres > 0.0 { "down" } else { "up" };
    let moves = if mm(least) == mm(most) && way(least) == way(most) {
        format!("{} mm {}", mm(most), way(most))
    } else if least >= 0.0 || most <= 0.0 {
        let (small, large) = if most > 0.0 { (least, most) } else { (most, least) };
        format!("{} to {} mm {}", mm(small), mm(large), way(large))
    } else {
        format!("from {} mm up to {} mm down", mm(least), mm(most))
    };
    Some(format!("sphere bottoms move {moves}, because radii change and centres stay"))
}
