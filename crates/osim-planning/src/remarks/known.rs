//! Published contacts that were made for another mass than that of the bodies over them.

use osim_inspect::KnownContacts;
use osim_model::messages::Input;
use osim_model::{Fault, Mass, Model, Needed, Selected, same_mass};

/// Refuses to take what the bodies weigh where the contacts are known ones that were made for another mass, which `input` can
/// give.
pub(crate) fn refuse_known(
    model: &Model,
    selected: &Selected,
    mass: &Mass,
    input: Input,
) -> Result<(), Fault> {
    if mass.source.is_of_contacts() {
        return Ok(());
    }
    let known = KnownContacts::find(model, &selected.forces, None, Some(mass.kg));
    match known.filter(|known| !same_mass(known.made_for_kg, mass.kg)) {
        Some(known) => Err(Fault::new(Needed::KnownContactsMass {
            title: known.title.to_owned(),
            made_for_kg: known.made_for_kg,
            bodies_kg: mass.kg,
            input,
        })),
        None => Ok(()),
    }
}
