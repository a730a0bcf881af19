//! What can be asked of the contacts of OpenSim models: values, options, and a request for each verb.
//!
//! A request is checked once, wherever its fields come from: the words of a command line (with the feature `clap`), a
//! dictionary (JSON, Python's keywords, a form on a page), or Rust.
//!
//! ```
//! use osim_requests::{Kilograms, Request};
//!
//! let request = Request::from_json(br#"{"verb": "rescale", "models": "human.osim", "target_mass": 80}"#)?;
//! let Request::Rescale(rescale) = request else { panic!("another verb") };
//! assert_eq!(rescale.target_mass.map(Kilograms::get), Some(80.0));
//! # Ok::<(), osim_requests::RequestFault>(())
//! ```
//!
//! # What it will not do
//!
//! It reads no model, plans nothing, and knows no disk and no terminal. What is wrong with a request is a [`RequestFault`], in
//! which fields are data that each front end spells.
#![cfg_attr(not(test), deny(clippy::disallowed_methods))]

#[cfg(feature = "clap")]
pub mod command_line;
mod dictionary;
mod fault;
pub mod options;
pub mod register;
mod request;
#[cfg(feature = "schemas")]
mod schema;
pub mod spell;
pub mod values;

pub use crate::fault::{Relation, RequestError, RequestFault};
pub use crate::request::*;
#[cfg(feature = "schemas")]
pub use crate::schema::schema_of;
pub use crate::values::{
    Acceleration, Assignments, Axis, AxisName, BodyMap, BodyScale, ConstantIndentation, ContactOnset, Count,
    Dpi, DropHeight, FigureWidth, FontSize, Grid, GridValue, Height, Jobs, Kilograms, Metres, NewRadius,
    NotNegative, PoissonRatio, Positive, Radius, RelativeIndentation, RestitutionCoefficient, Samples, Shard,
    Span, Speed, SpheresOfFoot, Steps, Threshold, assignment,
};

/// The example of the README compiles.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
