//! Figures of what contacts do, for `contact_plots` to draw.
//!
//! [`osim_inspect::series`] computes the points; here they get titles, labels and limits. What goes wrong is a
//! [`Failure`](osim_model::files::Failure), whose message is not spelled yet.

#![cfg_attr(not(test), deny(clippy::disallowed_methods))]

mod axes;
mod data;
mod draw;
mod drops;
mod feet;
mod force;
mod heat;
mod indentations;
mod limits;
mod loops;
mod motion;
mod names;
pub mod paper;
mod state;
mod table;
mod weights;

pub use axes::{Axes, units};
pub use data::data_csv;
pub use draw::{draw, draw_feet, draw_motion, not_drawn, paper, svg};
pub use drops::drops;
pub use feet::{feet, feet_notes, feet_svg, missing_meshes};
pub use force::force;
pub use heat::heat;
pub use indentations::{State as Indentations, above_the_axis, indentations};
pub use loops::{impact_loops, loops};
pub use state::state;
pub use weights::weights;

/// The example of the README compiles.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
