//! Models that weigh something else than their contacts are made for: scaled contacts under a body that is not scaled yet.

use osim_model::messages::{Input, Phrase, phrase, readable};
use osim_model::{MassRequest, MassSource, Model, mass_slip, same_mass};

/// The two masses, where the note in the file says one and the bodies another, and no option says which is meant.
#[derive(Debug, Clone, PartialEq)]
pub struct MassMismatch {
    body_kg: f64,
    contacts_mass_kg: f64,
}

impl MassMismatch {
    /// `None` where they agree, or the caller says what the model weighs.
    #[must_use]
    pub fn find(model: &Model, masses: &MassRequest) -> Option<Self> {
        if masses.model_kg.is_some() {
            return None;
        }
        let body = masses.of_model(model).ok()?;
        let (contacts, _) = masses.of_contacts(model).ok()?;
        let noted = contacts.source == MassSource::Note && !same_mass(contacts.kg, body.kg);
        noted.then_some(Self { body_kg: body.kg, contacts_mass_kg: contacts.kg })
    }

    /// What the contacts do is computed under their own body.
    #[must_use]
    pub fn message(&self) -> Phrase {
        let (body, contacts) = (readable(self.body_kg), readable(self.contacts_mass_kg));
        phrase![
            format!(
                "its contacts are made for {contacts} kg (note in the file) and carry its body of {body} kg here: say "
            ),
            Input::Mass.being(contacts),
            &self.answer(),
            ", or scale the body first",
        ]
    }

    /// The same after a finding.
    pub(crate) fn aside(&self) -> Phrase {
        let (body, contacts) = (readable(self.body_kg), readable(self.contacts_mass_kg));
        phrase![
            format!("; figures are those under {body} kg: for the others say "),
            Input::Mass.being(contacts),
            &self.answer(),
        ]
    }

    /// The answer to give with the mass of the contacts, if it would be asked about.
    fn answer(&self) -> Phrase {
        match mass_slip(Input::Mass, self.contacts_mass_kg, Some(self.body_kg)) {
            Some(asks) => phrase![" with ", &asks.question().answer()],
            None => Phrase::default(),
        }
    }
}
