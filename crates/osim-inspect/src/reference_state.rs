//! What a transfer takes its contacts from, as reports show it beside the model.

use contact_scaling::Preset;
use osim_model::files::OpenModel;
use osim_model::{MassRequest, Selection, short_digest};

use crate::figures::Figures;
use crate::options::{InspectOptions, Stance};
use crate::series::Body;

/// A reference: what its spheres do, under its own weight.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct ReferenceState {
    /// Its name.
    pub name: String,
    /// The first 16 digits of the SHA-256 of its file; `None` of a preset.
    pub digest: Option<String>,
    /// It, to be drawn; `None` if it cannot be.
    pub body: Option<Body>,
    /// Figures of its spheres, where it is a model.
    pub figures: Option<Figures>,
}

impl ReferenceState {
    /// A preset, with what the caller says of it.
    #[must_use]
    pub fn of_preset(preset: &Preset, mass_kg: f64, spheres: f64, gravity_m_s2: Option<f64>) -> Self {
        let masses = MassRequest { model_kg: Some(mass_kg), ..MassRequest::default() };
        let stance = Stance { spheres: Some(spheres), gravity_m_s2, ..Stance::default() };
        let name = preset.name.to_string();
        Self { name, digest: None, body: Body::of_preset(preset, &masses, &stance).ok(), figures: None }
    }

    /// A model, under the weight that its contacts were made for.
    #[must_use]
    pub fn of_model(
        name: String,
        open: &OpenModel,
        selection: Selection,
        (mass_kg, spheres, gravity_m_s2): (f64, Option<f64>, Option<f64>),
    ) -> Self {
        let options = InspectOptions {
            masses: MassRequest { model_kg: Some(mass_kg), ..MassRequest::default() },
            selection,
            stance: Stance { spheres, gravity_m_s2, ..Stance::default() },
            ..InspectOptions::default()
        };
        let body = Body::inspected(name.clone(), &open.model, &options, &|fault| open.failure(fault)).ok();
        let figures = options.inspect(open.name(), &open.model, None).figures;
        let digest = Some(short_digest(open.model.document().bytes()));
        Self { name, digest, body, figures: Some(figures) }
    }
}
