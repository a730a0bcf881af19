//! What contacts do along a motion.

use osim_model::files::{FileName, OpenModel};
use osim_motion::{Belt, ContactStates, Measured, OnSole, Recording, Summary};

use super::plates::PlatesRead;

/// What contacts do along a motion.
#[derive(Debug)]
#[non_exhaustive]
pub struct MotionResult {
    /// The model.
    pub opened: OpenModel,
    /// The motion, as it was named.
    pub motion: FileName,
    /// The coordinates of the model in each frame.
    pub recording: Recording,
    /// Each sphere on each plane in each frame.
    pub states: ContactStates,
    /// The plates, where the request names some.
    pub plates: Option<PlatesRead>,
    /// What they measured under each foot.
    pub measured: Option<Measured>,
    /// Each foot, and all together.
    pub summary: Summary,
    /// Where forces act on the sole of each foot; `None` where the default pose is not known.
    pub on_soles: Vec<Option<OnSole>>,
    /// What the model weighs, kg.
    pub mass_kg: f64,
    /// Gravity, m/s².
    pub gravity_m_s2: f64,
    /// How the belt moves, where there is one.
    pub belt: Option<Belt>,
}
