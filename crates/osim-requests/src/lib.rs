//! What can be asked of the contacts of OpenSim models: a typed request for each verb, from words or a dictionary to a plan.
//!
//! A request is checked once, wherever its fields come from: the words of a command line (with the feature `clap`), a
//! dictionary (JSON, Python's keywords, a form on a page), or Rust.
//!
//! ```
//! use osim_model::files::InMemory;
//! use osim_model::Model;
//! use osim_requests::{Request, RequestError};
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let model = Model::parse(include_bytes!("../../osim-model/tests/data/one_foot.osim").as_slice())?;
//! let request = Request::from_json(br#"{"verb": "rescale", "models": "one_foot.osim", "target_mass": 80}"#)?;
//! let Request::Rescale(rescale) = request else { return Ok(()) };
//! let plan = rescale.prepare(&InMemory::default()).map_err(|error| format!("{error:?}"))?.planner.plan(&model)?;
//! assert_eq!(plan.changes[0].to, 2.0 * plan.changes[0].from);
//! # Ok(())
//! # }
//! ```
//!
//! # What it will not do
//!
//! It knows no disk, only [`osim_model::files::Files`], and no terminal. What is wrong with a request is a [`RequestFault`],
//! in which fields are data that each front end spells.

#![cfg_attr(not(test), deny(clippy::disallowed_methods))]

mod calculator;
#[cfg(feature = "clap")]
pub mod command_line;
mod dictionary;
mod drop_test;
mod feet;
mod fig1;
mod fit;
mod gravity;
mod heat_table;
mod inspector;
mod json;
mod opening;
mod planner;
mod planning;
mod plot;
mod presets;
mod remedy;
mod request;
mod schema;
mod subject;
mod sweep;
mod table;
mod unique;

pub use calculator::{DesignFigure, DesignLimit, DesignQuantity, DesignSheet};
pub use drop_test::{ComparedDrop, DropColumn, DropFigure, DropResult, DropRow};
pub use feet::ModelFeet;
pub use fig1::fig1;
pub use fit::FitResult;
pub use heat_table::{HeatTable, TableColumn};
pub use inspector::Inspector;
pub use opening::{open_with, scale_file};
pub use osim_options::{RequestError, RequestFault, options};
pub use osim_values::sheet::{cell, from_cell, marked, unmarked};
pub use osim_values::{
    Acceleration, Assignments, Axis, AxisName, BodyMap, BodyScale, ConstantIndentation, ContactOnset, Count,
    Dpi, FigureWidth, FontSize, Grid, GridValue, Height, Kilograms, Metres, NewRadius, NotNegative,
    PoissonRatio, Positive, Radius, RelativeIndentation, RestitutionCoefficient, Samples, Shard, Span,
    SpheresOfFoot, Threshold, assignment,
};
pub use planner::{Change, Planner};
pub use presets::presets;
pub use request::{
    AddRequest, AxesChoice, BatchRequest, BranchChoice, CheckRequest, ConvertRequest, Deny, DesignRequest,
    DropTestRequest, ExplainRequest, FigureOptions, FitRequest, HeatOptions, InspectRequest, NoteRequest,
    PlotKind, PlotRequest, PresetsRequest, QuantityChoice, RemoveRequest, ReproduceRequest, Request,
    RescaleRequest, SeriesFormat, SetRequest, SweepRequest, TransferRequest, schema_of,
};
pub use subject::may_be_file;
pub use sweep::{SweepPlan, VariantMade};
pub use table::{RowFault, RowRequest, Table};
