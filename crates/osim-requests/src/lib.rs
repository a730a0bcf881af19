//! Requests about the contacts of OpenSim models: values, options, and a request type for each verb.
//!
//! A request is checked in the same way for all sources of its fields: the arguments of a command line (with the feature `clap`),
//! a dictionary (JSON, Python's keywords, a form on a page), or Rust.
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
//! This crate reads no model, plans no change, and uses no disk and no terminal. An error of a request is a [`RequestFault`]; its
//! fields are data that each front end spells in its own way.
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

pub use crate::fault::{Relation, RequestError, RequestFault, Result};
pub use crate::request::*;
#[cfg(feature = "schemas")]
pub use crate::schema::schema_of;
pub use crate::values::{
    Acceleration, Assignments, Axis, AxisName, BodyMap, BodyScale, ConstantIndentation, ContactOnset, Count,
    Dpi, DropHeight, FigureWidth, FontSize, Grid, GridValue, Jobs, Kilograms, Metres, NewRadius, NotNegative,
    PoissonRatio, Positive, Radius, RelativeIndentation, RestitutionCoefficient, Samples, Shard, Signed,
    Span, SpheresOfFoot, Steps, Threshold, UsualErrors, assignment,
};

/// The example of the README, which must compile.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
