//! The remedy of a rule about models: spheres and planes out of the forces that keep them inside.

use osim_model::{Finding, Force, ForceKind, Model, Selection, Sphere};
use osim_requests::options::{ClassChoice, ForceOptions};
use osim_requests::{ConvertRequest, Request};

use crate::findings::{Remedies, exactly};

/// The force that `finding` is about as OpenSim reads it today; all forces, where all are such and nobody chose among them.
pub(crate) fn remedy(remedies: &Remedies<'_>, model: &Model, finding: &Finding) -> Option<Request> {
    let models = remedies.models(false)?;
    let keeps_inside = |force: &Force| {
        force.spheres().into_iter().any(|id| model.sphere(id).is_some_and(Sphere::is_inside_force))
    };
    let all = remedies.options.selection == Selection::default() && model.forces().iter().all(keeps_inside);
    let force = model.forces().iter().find(|force| Some(force.path.as_str()) == finding.place.as_deref())?;
    let select = if all { Vec::new() } else { vec![exactly(&force.name)?] };
    let choice = ForceOptions { select, ..ForceOptions::default() };
    let to = ClassChoice::of(ForceKind::SmoothSphereHalfSpace);
    Some(ConvertRequest { models, to, choice, ..ConvertRequest::default() }.into())
}
