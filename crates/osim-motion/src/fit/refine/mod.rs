//! Beyond stiffness, dissipation and one height: spheres that move in their bodies, the centre of pressure, and slack in the
//! kinematics. All unknowns together by Levenberg–Marquardt. Slack belongs to one stance of one foot each, so the work grows with
//! frames, not with their cube.

mod cholesky;
mod errors;
mod foot;
mod layout;
mod normal;
mod refining;
mod sureness;
mod window;

pub(super) use self::layout::Layout;
pub(super) use self::refining::{Refined, Refining};
pub(super) use self::sureness::Sureness;
