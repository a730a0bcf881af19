//! Groups of options that several requests share, what they need and exclude, and what can be wrong with a request.
//!
//! ```
//! use osim_options::options::MassOptions;
//!
//! let masses: MassOptions = serde_json::from_str(r#"{"mass": 20}"#).expect("a mass in kg");
//! assert_eq!(masses.request().model_kg, Some(20.0));
//! ```
//!
//! # What it will not do
//!
//! It plans nothing, and knows no verbs, no files and no terminal.

#![cfg_attr(not(test), deny(clippy::disallowed_methods))]

mod choice;
mod fault;
pub mod options;
mod relation;

pub use fault::{RequestError, RequestFault};
pub use relation::Relation;

/// The example of the README compiles.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
