//! The gravity of a model, and the gravity for which its contacts were made.

use crate::model::typed_model::Model;
use crate::xml::TextPosition;

impl Model {
    /// Gravity that OpenSim uses if a model gives none, m/s².
    pub(crate) const DEFAULT_GRAVITY: [f64; 3] = [0.0, -9.80665, 0.0];

    /// Place of `gravity` in its file; `None` if the file has no gravity and OpenSim's default is used, or if it has only sets.
    pub fn gravity_position(&self) -> Option<TextPosition> {
        let document = self.file(self.components.model_file()?);
        let gravity = document.property_element(document.data_root(), "gravity")?;
        Some(document.position_of(gravity))
    }

    /// Magnitude of gravity, m/s²; `None` if it is not a number. Without gravity, or with 0, forces cannot be given in body weights.
    pub fn gravity(&self) -> Option<f64> {
        self.gravity_m_s2.map(|[x, y, z]| (x * x + y * y + z * z).sqrt()).filter(|size| size.is_finite())
    }

    /// Gravity for which the contacts were made, m/s²: from the note, else that of the model.
    pub fn contacts_gravity(&self) -> Option<f64> {
        self.note.as_ref().and_then(|note| note.gravity_m_s2).or(self.gravity())
    }
}
