//! Tables, CSV, JSON records and explanations, for people and for scripts.
//!
//! Data goes in, text comes out: [`inspection`], [`check`] and [`plan`] make tables, [`json`] records, and [`explain`] what an equation
//! or a code means. What the reader can say or do is
//! spelled by a [front end](osim_requests::spell::FrontEnd).
//!
//! ```
//! use osim_inspect::InspectOptions;
//! use osim_model::Model;
//! use osim_requests::spell::CommandLine;
//! use osim_view::report::extent::Layout;
//! use osim_view::report::inspection;
//!
//! # fn main() -> Result<(), osim_model::Fault> {
//! let model = Model::parse(include_bytes!("../../../osim-model/tests/data/one_foot.osim").as_slice())?;
//! let mut inspected = InspectOptions::default().inspect("one_foot.osim", &model, None);
//! inspected.spell(&CommandLine);
//! let text = inspection::text(&inspected, &CommandLine, Layout::default());
//! assert!(text.contains("model weighs 10 kg (mass of 1 body)"));
//! # Ok(())
//! # }
//! ```
//!
//! # What it will not do
//!
//! It knows no files, no arguments and no terminal, computes nothing of its own, and decides nothing: plans, inspections and
//! checks are shown as they are.

pub mod check;
pub mod explain;
pub mod extent;
pub mod inspection;
pub mod json;
pub mod layout;
pub mod messages;
pub mod plan;
pub mod reproduce;
pub mod results;
pub mod similarity;

pub use messages::ExitStatus;
