//! Gravity where none is given.

/// OpenSim's default, m/s².
pub(crate) const STANDARD_GRAVITY_M_S2: f64 = 9.80665;
