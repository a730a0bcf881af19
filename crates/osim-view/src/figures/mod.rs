//! Figures of what contacts do, for `contact_plots` to draw.
//!
//! [`osim_inspect::series`] computes the points; here they get titles, labels and limits. What goes wrong is a
//! [`Failure`](osim_model::files::Failure), whose message is not spelled yet.
//!
//! ```
//! use contact_plots::{Drawing, Paper};
//!
//! // The paper's Fig. 4 in one column of a journal.
//! let figure = Drawing::Panels(osim_view::figures::paper::fig4(None).expect("Table 1 is complete"));
//! let svg = figure.svg(Paper { width_mm: Some(85.0), ..Paper::default() })?;
//! assert!(svg.starts_with("<svg") && svg.contains("width=\"85mm\""));
//! # Ok::<(), contact_plots::PlotError>(())
//! ```

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
