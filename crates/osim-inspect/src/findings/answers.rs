//! Questions that a remedy would be asked: what was found answers them, so that its command runs as it is printed.

use osim_model::{JointDistances, MassRequest, Model, NeedsAnswer, Question, Remedy, RemedyChange};

use crate::known::unexplained_slip;

/// Answers what `remedy` would be asked for `model`.
pub(super) fn answer(remedy: &mut Remedy, model: &Model, masses: &MassRequest) {
    let load = remedy.load.as_ref();
    let said = MassRequest {
        contacts_kg: None,
        model_kg: load.and_then(|load| load.mass_kg),
        target_mass_kg: None,
        ..masses.clone()
    };
    let asked_of = |said: &MassRequest| unexplained_slip(said, model, &remedy.selection);
    let asked: Vec<NeedsAnswer> = match &remedy.change {
        RemedyChange::Rescale { contacts_mass_kg, target_mass_kg } => {
            let distances = JointDistances::of(model);
            let ratio = (target_mass_kg / contacts_mass_kg).cbrt();
            let of_masses = asked_of(&MassRequest {
                contacts_kg: Some(*contacts_mass_kg),
                target_mass_kg: Some(*target_mass_kg),
                ..said
            });
            let of_radii = model.spheres().iter().filter_map(|sphere| {
                let radius_m = sphere.radius_m().ok()?;
                distances.radius_slip(sphere, radius_m * ratio, false)
            });
            of_masses.into_iter().chain(of_radii).collect()
        }
        RemedyChange::FollowNote { target_mass_kg, .. } => {
            asked_of(&MassRequest { target_mass_kg: Some(*target_mass_kg), ..said }).into_iter().collect()
        }
        _ => asked_of(&said).into_iter().collect(),
    };
    let is_asked = |question: &Question| asked.iter().any(|asks| asks.question() == *question);
    remedy.yes = Question::ALL.into_iter().filter(is_asked).collect();
}
