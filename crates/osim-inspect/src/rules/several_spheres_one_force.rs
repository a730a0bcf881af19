//! The remedy of a rule about models: a force for each sphere.

use std::collections::HashSet;

use osim_feet::{DefaultPose, sphere_pairs};
use osim_model::{FileId, Finding, Force, ForceId, ForceKind, Model, Selection, Sphere};
use osim_requests::options::{ClassChoice, ForceOptions};
use osim_requests::{ConvertRequest, Request};

use crate::findings::{Remedies, exactly};

/// One force for each sphere of the force that `finding` is about; of all forces, where all can be divided and nobody chose among
/// them.
pub(crate) fn remedy(remedies: &Remedies<'_>, model: &Model, finding: &Finding) -> Option<Request> {
    let path = finding.place.as_deref()?;
    let force = model.forces().iter().find(|force| force.path == path)?;
    let models = remedies.models(false)?;
    let divisible = remedies.divisible.get_or_init(|| divisible(model));
    if !divisible.contains(&force.id) {
        return None;
    }
    let all = remedies.options.selection == Selection::default() && divisible.len() == model.forces().len();
    let select = if all { Vec::new() } else { vec![exactly(&force.name)?] };
    let choice = ForceOptions { select, ..ForceOptions::default() };
    let to = ClassChoice::of(ForceKind::HuntCrossley);
    Some(ConvertRequest { models, to, choice, ..ConvertRequest::default() }.into())
}

/// Spheres of one force that are compared with each other to propose a conversion.
const COMPARED: usize = 100;

/// The HuntCrossleyForces that `convert` makes one for each sphere of: in the model's own file, with one half-space, no sphere that
/// never meets it, and no spheres that touch each other.
fn divisible(model: &Model) -> HashSet<ForceId> {
    let document = model.document();
    if document.tree().name(document.data_root()) != "Model" {
        return HashSet::new();
    }
    let pose = DefaultPose::of(model);
    let can_be = |force: &&Force| {
        let planes: Vec<_> = force.sets.iter().flat_map(|set| model.half_spaces_of(set)).collect();
        let [plane] = planes.as_slice() else { return false };
        let mut spheres = force.spheres().into_iter().map(|id| model.sphere(id));
        let meets = |sphere: Option<&Sphere>| sphere.is_some_and(|one| !one.fixed && one.body != plane.body);
        force.kind == ForceKind::HuntCrossley
            && force.spheres().len() <= COMPARED
            && force.file == FileId::MAIN
            && spheres.all(meets)
            && sphere_pairs(model, &pose, force)
                .iter()
                .all(|pair| pair.gap_m.as_ref().is_ok_and(|gap| *gap > 0.0))
    };
    model.forces().iter().filter(can_be).map(|force| force.id).collect()
}
