//! Under what a model is inspected: whose weight, by which forces, on how many spheres.

use std::path::PathBuf;

use osim_model::{MassRequest, Model, Selection};
use osim_requests::options::{InspectionOptions, StanceOptions};
use osim_requests::{Acceleration, Count, Positive};

/// Under which load, on how many spheres.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Stance {
    /// Spheres that share the body weight, all stance limbs together; `None`: as found on a limb.
    pub spheres: Option<f64>,
    /// Limbs that share the body weight; `None`: as the note in the model says, else one.
    pub limbs: Option<f64>,
    /// Speed before an impact, m/s; `None`: √(gR/2).
    pub impact_speed_m_s: Option<f64>,
    /// Gravity instead of the model's own, m/s².
    pub gravity_m_s2: Option<f64>,
}

impl Stance {
    /// Limbs that share the weight of `model`.
    #[must_use]
    pub fn limbs_of(&self, model: &Model) -> f64 {
        self.limbs.or(model.noted_stance_limbs()).unwrap_or(1.0)
    }
}

/// Whose weight, by which forces, on how many spheres.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct InspectOptions {
    /// What the caller says of masses.
    pub masses: MassRequest,
    /// Which forces.
    pub selection: Selection,
    /// Under which load.
    pub stance: Stance,
    /// The geometry set of a force set that stands alone; remedies name it again.
    pub geometry: Option<PathBuf>,
    /// The model of a force set that stands alone; remedies name it again.
    pub model: Option<PathBuf>,
}

impl From<&StanceOptions> for Stance {
    fn from(options: &StanceOptions) -> Self {
        Self {
            spheres: options.spheres.map(Count::get),
            limbs: options.stance_limbs.map(Count::get),
            impact_speed_m_s: options.impact_speed.map(Positive::get),
            gravity_m_s2: options.gravity.map(Acceleration::get),
        }
    }
}

impl From<&InspectionOptions> for InspectOptions {
    fn from(options: &InspectionOptions) -> Self {
        Self {
            masses: options.masses.request(),
            selection: options.choice.selection(),
            stance: Stance::from(&options.stance),
            geometry: options.set_files.geometry.clone(),
            model: options.set_files.model.clone(),
        }
    }
}
