//! What is said of a change beside its numbers.

use osim_model::wording::Phrase;
use osim_model::{ForceId, ForceKind, Property, Warning, WarningCode, readable};

use crate::builder::PlanBuilder;
use crate::property_set::PropertySet;
use crate::radii::Radii;

/// Said where contacts are scaled to a gravity that is not the model's own.
pub(crate) const GRAVITY_STAYS: &str = "the model's own <gravity> stays as it is: set it in OpenSim";

/// Says what is special about the chosen forces.
pub(crate) fn warn_forces(plan: &mut PlanBuilder<'_>, forces: &[ForceId], properties: &PropertySet) {
    let model = plan.model;
    for force in forces.iter().filter_map(|&id| model.force(id)) {
        if !force.applies {
            let text = format!("{} is switched off; it is changed with the others", force.path);
            plan.warnings.push(Warning::at(WarningCode::DisabledForce, force.line, text));
        }
    }
    let smooth =
        |&id: &ForceId| model.force(id).is_some_and(|force| force.kind == ForceKind::SmoothSphereHalfSpace);
    if properties.contains(Property::TransitionVelocity) && forces.iter().any(smooth) {
        let text = "friction of SmoothSphereHalfSpaceForce scales only as far as constant_contact_force is small \
                    against the squared slip speed";
        plan.warnings.push(Warning::new(WarningCode::FrictionNotSimilar, text));
    }
}

/// How far the soles move because radii change and centres do not.
pub(crate) fn bottoms_remark(radii: &Radii) -> Option<Phrase> {
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
    Some(format!("sphere bottoms move {moves}, because radii change and centres stay").into())
}
