//! Contact parameters from measured indentation and force.
//!
//! The model is (1) with (12) on n equal spheres: F = n 4/3 √R E* (x − x₀)^(3/2) (1 + 3/2 α ẋ), and F = 0 before
//! the onset x₀. Errors are taken to be in the force, independent and of equal size. Where the onset is known
//! the model is linear in E* and E* α and solved in closed form; where it is not, by Levenberg–Marquardt.
//!
//! ```
//! use contact_scaling::fit::{Branch, FitValues, Measurement, Onset, Rate, fit};
//! let indentation_m = [0.001, 0.002, 0.003, 0.004, 0.005];
//! let force_n = indentation_m.map(|x: f64| 6.0 * 4.0 / 3.0 * 0.032_f64.sqrt() * 4e5 * x.powf(1.5));
//! let measurement = Measurement { indentation_m: &indentation_m, force_n: &force_n, rate: Rate::Unknown };
//! let values =
//!     FitValues { radius_m: 0.032, sphere_count: 6.0, onset: Onset::At(0.0), branch: Branch::Both };
//! let result = fit(&measurement, &values)?;
//! assert!((result.composite_modulus.value / 4e5 - 1.0).abs() < 1e-12);
//! # Ok::<(), contact_scaling::fit::FitError>(())
//! ```

mod doubt;
mod error;
mod estimate;
mod linear;
mod measurement;
mod model;
mod onset;
mod parameter;
mod points;
mod result;
mod solve;

pub use doubt::Doubt;
pub use error::FitError;
pub use estimate::Estimate;
pub use measurement::{Branch, FitValues, Measurement, Onset, Rate};
pub use parameter::Parameter;
pub use result::Fit;
pub use solve::fit;
