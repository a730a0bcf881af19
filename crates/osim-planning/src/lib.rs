//! The way from a request and its models to a plan; sweeps, calculators, drop tests, fits and tables of rows.
//!
//! ```
//! use osim_model::Model;
//! use osim_model::files::InMemory;
//! use osim_planning::prepare;
//! use osim_requests::Request;
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let model = Model::parse(include_bytes!("../../osim-model/tests/data/one_foot.osim").as_slice())?;
//! let request = Request::from_json(br#"{"verb": "rescale", "models": "one_foot.osim", "target_mass": 80}"#)?;
//! let change = prepare(request, &InMemory::default()).map_err(|error| format!("{error:?}"))?;
//! let plan = change.plan_alone(&model)?;
//! assert_eq!(plan.changes[0].to, 2.0 * plan.changes[0].from);
//! # Ok(())
//! # }
//! ```
//!
//! # Where to begin
//!
//! - [`prepare`] checks a request that changes models; its [`PreparedChange`] makes a plan for each.
//! - [`Inspector`] inspects and checks models as a request says; [`BeforeAfter`] shows a change from both sides.
//! - [`design_sheet`], [`run_drop_test`], [`run_fit`] and [`SweepPlan`] answer what needs no plan.
//!
//! # What it will not do
//!
//! It knows no disk, only [`osim_model::files::Files`], and no terminal.
#![cfg_attr(not(test), deny(clippy::disallowed_methods))]

mod before_after;
mod calculator;
pub mod contact_table;
mod drop_test;
mod fit_curve;
mod inspector;
pub(crate) mod motion;
mod motion_consistency;
mod motion_remarks;
mod next_models;
mod opening;
mod plot;
mod prepared_change;
mod remarks;
mod remedies;
mod result_check;
pub mod rules;
pub mod scene;
pub mod sheet;
mod sweep;
mod table;
pub(crate) mod verbs;

pub use crate::before_after::{BeforeAfter, BeforeAndAfterPlan};
pub use crate::calculator::{DesignFigure, DesignLimit, DesignSheet, design_sheet};
pub use crate::drop_test::{ComparedDrop, DropResult, DropRow, run_drop_test};
pub use crate::fit_curve::{FitResult, run_fit};
pub use crate::inspector::Inspector;
pub use crate::motion::{MotionResult, PlatesRead, run_motion, unreadable_recording};
pub use crate::motion_consistency::{Consistency, MotionRemark};
pub use crate::next_models::{MocoStart, NextModels};
pub use crate::opening::{all_preset_names, find_presets, may_be_file, open_with, presets_of_unlike_spheres};
pub use crate::plot::{HeatTable, ModelFeet, TableColumn, plot_bodies, plot_feet, plot_motion};
pub use crate::prepared_change::{PreparedChange, check_with_trials, find_changeable_values};
pub use crate::remedies::check_with_remedies;
pub use crate::sheet::{cell, from_cell, with_text_mark, without_text_mark};
pub use crate::sweep::{MadeVariant, SweepPlan};
pub use crate::table::{RowFault, RowRequest, Table};
pub use crate::verbs::prepare;
pub use calculator::DesignQuantity;
pub use drop_test::{DropColumn, DropFigure};

/// Compiles the example in the README as a test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
