//! Models that weigh something else than their contacts stand for: scaled contacts under a body that is not scaled yet.

use osim_patch::{MassRequest, MassSource, Model, WarningCode, same_mass};

use crate::report::number;

/// The two masses, where the note in the file tells one and the bodies another, and nobody says which is meant.
#[derive(Debug)]
pub(crate) struct Weighed {
    body_kg: f64,
    contacts_kg: f64,
}

impl Weighed {
    /// `None` where they agree, or `--mass` decides.
    pub(crate) fn otherwise(model: &Model, masses: &MassRequest) -> Option<Self> {
        if masses.model_kg.is_some() {
            return None;
        }
        let body = masses.of_model(model).ok()?;
        let contacts = masses.of_contacts(model, &mut Vec::new()).ok()?;
        let noted = contacts.source == MassSource::Note && !same_mass(contacts.kg, body.kg);
        noted.then_some(Self { body_kg: body.kg, contacts_kg: contacts.kg })
    }

    /// A line for standard error: what `shown` does is computed under its own body.
    pub(crate) fn warning(&self, shown: &str) -> String {
        let (body, contacts) = (number(self.body_kg), number(self.contacts_kg));
        format!(
            "warning: {shown}: its contacts stand for {contacts} kg (note in the file) and carry its body of {body} kg \
             here: say --mass {contacts}, or scale the body first [{}]\n",
            WarningCode::MassSourcesDisagree
        )
    }

    /// The same behind a finding.
    pub(crate) fn aside(&self) -> String {
        let (body, contacts) = (number(self.body_kg), number(self.contacts_kg));
        format!("; figures are those under {body} kg: for the others say --mass {contacts}")
    }
}
