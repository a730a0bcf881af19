//! How large a model is, and what may follow its size.

use std::collections::BTreeMap;

use crate::model::{MassRequest, Model, SizedValues};

/// How large a model is, and its numbers that may follow size.
#[derive(Debug, Clone, PartialEq)]
pub struct ModelSize {
    /// What it weighs, kg; `None` where that is not known.
    pub mass_kg: Option<f64>,
    /// Its gravity, m/s²; `None` where that is not known.
    pub gravity_m_s2: Option<f64>,
    /// The longest distance between two joints of each body that has two, m.
    pub(super) joint_distances_m: BTreeMap<String, f64>,
    /// The numbers.
    pub(super) values: SizedValues,
}

impl ModelSize {
    /// That of `model`, which weighs what `masses` say.
    #[must_use]
    pub fn of(model: &Model, masses: &MassRequest) -> Self {
        let distances = model.joint_distances();
        let of_body = |name: &str| Some((name.to_owned(), distances.of_body(name)?));
        Self {
            mass_kg: masses.of_model(model).ok().map(|mass| mass.kg),
            gravity_m_s2: model.gravity().filter(|gravity| *gravity > 0.0),
            joint_distances_m: model.bodies().iter().filter_map(|body| of_body(&body.name)).collect(),
            values: SizedValues::of(model),
        }
    }

    /// The same with numbers of a file beside the model.
    #[must_use]
    pub fn with(mut self, more: SizedValues) -> Self {
        self.values.values.extend(more.values);
        self.values.not_read.extend(more.not_read);
        self
    }
}
