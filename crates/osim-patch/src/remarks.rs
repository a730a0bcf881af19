//! Remarks about a change beside its numbers.

use osim_model::messages::{Input, Phrase, phrase, readable};
use osim_model::{ForceId, PropertySet};

use crate::builder::PlanBuilder;
use crate::radii::Radii;
use crate::rules;

/// What every change of plain numbers leaves as it is.
pub const PLACES_STAY: &str = "body masses and sphere locations stay as they are";

/// The remark if centres move because radii change.
pub(crate) const LEVEL: &str = "body masses stay as they are; sphere centres move, so that the lowest point of each sphere stays where it is";

/// The remark if contacts are scaled to a gravity that is not the model's.
pub(crate) const GRAVITY_STAYS: &str = "the model's own <gravity> stays as it is: set it in OpenSim";

/// The remark if spheres move because their feet are made level.
pub(crate) const LEVEL_FEET: &str = "spheres move down, along the normal of their floor, until all spheres of a foot are as low as its lowest one at the default pose";

/// Says what is special about the chosen forces.
pub(crate) fn warn_forces(plan: &mut PlanBuilder<'_>, forces: &[ForceId], properties: &PropertySet) {
    let model = plan.model;
    plan.warnings.extend(model.remarks_on(forces));
    let chosen = forces.iter().filter_map(|&id| model.force(id));
    plan.warnings.extend(rules::friction_not_similar(chosen, properties));
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
    Some(format!("the lowest points of spheres move {moves}, because radii change and centres stay").into())
}

/// The remark about bottoms where centres can move, too.
pub(crate) fn bottoms_remark_and_level(radii: &Radii) -> Option<Phrase> {
    Some(phrase![&bottoms_remark(radii)?, "; ", Input::Level, " keeps them where they are"])
}

/// Where the model's own smoothed law rests after a design: its x/R is not that of the Hertz law, which (11) is about.
pub(crate) fn rest_remark(rests: &[f64]) -> Option<Phrase> {
    let four = |x: f64| format!("{x:.4}");
    let least = rests.iter().copied().reduce(f64::min).map(four)?;
    let most = rests.iter().copied().reduce(f64::max).map(four)?;
    let range = if least == most { most } else { format!("{least} to {most}") };
    Some(
        format!("by the model's law, (C.9) at speed 0, spheres rest at x/R = {range} under this load").into(),
    )
}
