//! Scaling of Hertz and Hunt–Crossley contact parameters with body size: the equations of P. A. van Bijlert (2026), "Scaling
//! contact force parameters across body size, limb count, and number of contact spheres", Journal of Biomechanics,
//! <https://doi.org/10.1016/j.jbiomech.2026.113420>.
//!
//! This crate only computes, with `f64` in SI units; it knows no files, no XML and no terminal. Numbers in brackets, as in (10)
//! or (C.5), are the paper's equation numbers.
//!
//! # One idea
//!
//! Contacts of two bodies are geometrically and dynamically similar when their *dimensionless* parameters are
//! equal ([`DimensionlessContact`]). Rescaling is therefore one multiplication per parameter, by a power of the
//! [`Ratios`] of mass, sphere count, radius and gravity:
//!
//! ```
//! use contact_scaling::{Ratios, Scale, ScaleValues, falisse2022};
//!
//! let human = falisse2022();
//! let mouse =
//!     Scale::new(ScaleValues { mass_kg: 0.0209, radius_m: 0.002, sphere_count: 2.0, gravity_m_s2: 9.80665 })?;
//! let contact = human.contact.scaled(&Ratios::between(&human.scale, &mouse)?);
//! assert!((contact.plane_strain_modulus() / 0.259e6 - 1.0).abs() < 2e-3); // Table 1 prints 0.259 MPa
//! assert!((contact.dissipation() - 8.0).abs() < 1e-12); // and 8.00 s/m
//! # Ok::<(), contact_scaling::DomainError>(())
//! ```
//!
//! # Limitations
//!
//! The Hertz law holds for small indentations (x̂ ≤ 0.16), the Hunt–Crossley law for a high restitution (c_r ≥ 0.8). Beyond these
//! limits a contact is only a damped non-linear spring and does not describe a material. Contacts of common gait models are
//! beyond both limits.

#![cfg_attr(not(test), deny(clippy::disallowed_methods))]
#![warn(missing_docs)]

mod contact;
pub mod continuation;
pub mod design;
mod dimensionless;
pub mod drop_test;
pub mod equations;
pub mod equilibrium;
mod error;
pub mod fit;
mod hertz;
mod law;
pub mod limits;
pub mod mixed_radii;
pub mod modulus;
pub mod patch;
pub mod restitution;
mod scale;
pub mod sizing;
mod smooth_sphere_law;
pub mod smoothing;
pub mod stiffness;
pub mod table1;

pub use contact::{
    Contact, ContactValues, Friction, FrictionValues, Preset, SURFACE_OVER_COMPOSITE_MODULUS, falisse2022,
    moco_3d_walking, osim_rl, preset, preset_names,
};
pub use dimensionless::DimensionlessContact;
pub use equations::Equation;
pub use error::{DomainError, Result};
pub use hertz::{Hertz, HertzValues, HuntCrossley};
pub use law::{Law, Spheres};
pub use scale::{RatioValues, Ratios, Scale, ScaleValues, SharedLoad};
pub use smooth_sphere_law::SmoothSphere;
pub use smoothing::SmoothingValues;
