//! Reads OpenSim models: from bytes to bodies, feet and contacts. Each value has its place in the file.
//!
//! The crate has three layers. Each uses only the layers before it:
//!
//! 1. [`xml`]: bytes as a tree of elements with exact places; [`messages`]: sentences in which inputs and calls are data.
//! 2. [`Model`]: bodies, joints, contact spheres and contact forces.
//! 3. [`feet`]: what stands where; [`compare`]: what differs between two models.
//!
//! ```
//! use osim_model::{MassRequest, Model, Property, Selection, SetId};
//!
//! # fn main() -> Result<(), osim_model::Fault> {
//! let model = Model::parse(include_bytes!("../tests/data/one_foot.osim").as_slice())?;
//! let weighs = MassRequest::default().model_mass(&model)?;
//! let selected = Selection::default().apply(&model)?;
//! let force = model.force(selected.forces[0]).unwrap();
//! let stiffness = force.value(SetId::FIRST, Property::Stiffness).unwrap();
//! assert_eq!((weighs.kg, stiffness.number), (10.0, 1e6));
//! # Ok(())
//! # }
//! ```

#![cfg_attr(not(test), deny(clippy::disallowed_methods))]

pub mod compare;
pub mod feet;
pub mod messages;
mod model;
pub mod xml;

pub use glam::{DVec2, DVec3};
pub use model::*;

/// Compiles the example in the README.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
