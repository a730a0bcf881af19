//! Questions that a remedy would be asked: what was found answers them, so that its command runs as it is printed.

use osim_model::{MassRequest, Model, NeedsAnswer, Question, Selection};
use osim_requests::options::{AnswerOptions, ForceOptions, MassOptions};
use osim_requests::{Kilograms, Request, RescaleRequest};

use crate::known::unexplained_slip;

/// Answers what `remedy` would be asked for `model`.
pub(super) fn answer(remedy: &mut Request, model: &Model, masses: &MassRequest) {
    let asked = match remedy {
        Request::Rescale(request) => of_rescale(request, model, masses),
        Request::Transfer(request) => asked_of(&said(&request.masses, masses), model, &request.choice),
        Request::Design(request) => asked_of(&said(&request.masses, masses), model, &request.choice),
        Request::Convert(request) => asked_of(&said(&MassOptions::default(), masses), model, &request.choice),
        Request::Set(request) => asked_of(&said(&request.masses, masses), model, &request.choice),
        _ => Vec::new(),
    };
    let is_asked = |question: &Question| asked.iter().any(|asks| asks.question() == *question);
    let yes = Question::ALL.into_iter().filter(is_asked).collect();
    if let Some(answers) = remedy.answers_mut() {
        *answers = AnswerOptions::new(yes);
    }
}

/// What a remedy says of masses.
fn said(own: &MassOptions, masses: &MassRequest) -> MassRequest {
    MassRequest {
        contacts_mass_kg: None,
        model_kg: own.mass.map(Kilograms::get),
        target_mass_kg: None,
        ..masses.clone()
    }
}

fn asked_of(said: &MassRequest, model: &Model, choice: &ForceOptions) -> Vec<NeedsAnswer> {
    let selection: Selection = choice.selection();
    unexplained_slip(said, model, &selection).into_iter().collect()
}

fn of_rescale(request: &RescaleRequest, model: &Model, masses: &MassRequest) -> Vec<NeedsAnswer> {
    let target_mass_kg = request.target_mass.map(Kilograms::get);
    let contacts_mass_kg = request.masses.contacts_mass.map(Kilograms::get);
    let said = MassRequest { contacts_mass_kg, target_mass_kg, ..said(&request.masses, masses) };
    let mut asked = asked_of(&said, model, &request.choice);
    if let (Some(contacts_mass_kg), Some(target_mass_kg)) = (contacts_mass_kg, target_mass_kg) {
        let distances = model.joint_distances();
        let ratio = (target_mass_kg / contacts_mass_kg).cbrt();
        asked.extend(model.spheres().iter().filter_map(|sphere| {
            let radius_m = sphere.radius_m().ok()?;
            distances.radius_slip(sphere, radius_m * ratio, false)
        }));
    }
    asked
}
