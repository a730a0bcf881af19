//! Corrects a motion by the least that makes the contacts of a model give the forces of the plates.
//!
//! The unknowns are the height of the floor, the velocity of a belt, and splines in time: of the root's height, and of each
//! coordinate that moves the spheres of one foot. Contacts are soft at first, so that spheres above the floor feel it. After that,
//! the contacts are read again along the corrected motion.

mod dynamics;
mod figures;
mod flat_feet;
mod passes;
mod residuals;
mod slopes;
mod solve;
mod unknowns;
mod verdict;

pub use dynamics::{InverseDynamics, RootResidual};
pub use figures::{CorrectionFigures, FootErrors, ForceErrors};
pub use flat_feet::flat_feet;
pub use passes::{Correction, CorrectionError, correct};
pub use unknowns::CorrectionOptions;
pub use verdict::{Mismatch, MotionVerdict, mismatches};
