//! Questions that a remedy would be asked: what was found answers them, so that its command runs as it is printed.

use osim_model::wording::Input;
use osim_model::{
    JointDistances, MassRequest, Model, NeedsAnswer, Question, Remedy, RemedyChange, mass_slip,
};

/// Answers what `remedy` would be asked for `model`.
pub(super) fn answer(remedy: &mut Remedy, model: &Model, masses: &MassRequest) {
    let load = remedy.load.as_ref();
    let bodies_kg = masses.bodies_kg(model);
    let mass = |input, kg: Option<f64>| kg.and_then(|kg| mass_slip(input, kg, bodies_kg));
    let own = mass(Input::Mass, load.and_then(|load| load.mass_kg));
    let asked: Vec<NeedsAnswer> = match &remedy.change {
        RemedyChange::Rescale { contacts_mass_kg, target_mass_kg } => {
            let distances = JointDistances::of(model);
            let ratio = (target_mass_kg / contacts_mass_kg).cbrt();
            let said = [(Input::ContactsMass, *contacts_mass_kg), (Input::TargetMass, *target_mass_kg)];
            let of_masses = said.into_iter().filter_map(|(input, kg)| mass(input, Some(kg)));
            let of_radii = model.spheres().iter().filter_map(|sphere| {
                let radius_m = sphere.radius_m().ok()?;
                distances.radius_slip(sphere, radius_m * ratio, false)
            });
            of_masses.chain(of_radii).chain(own).collect()
        }
        _ => own.into_iter().collect(),
    };
    let is_asked = |question: &Question| asked.iter().any(|asks| asks.question() == *question);
    remedy.yes = Question::ALL.into_iter().filter(is_asked).collect();
}
