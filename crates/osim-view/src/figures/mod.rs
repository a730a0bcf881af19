//! Figures about contacts. The crate `contact_plots` draws them.
//!
//! [`osim_inspect::series`] computes the points; here they get titles, labels and limits.
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
mod curves;
mod draw;
mod feet;
mod heat;
mod motion;
pub mod paper;

pub use axes::{units_for, weights_in_words};
pub(crate) use curves::count_above_axis;
pub use curves::{contact_force, contact_state, drops, impact_loops, indentations, loops};
pub use draw::{data_csv, draw, draw_request, failure_of_plot, paper_of, svg};
pub use feet::feet;
pub(crate) use feet::names_of_missing_meshes;
pub use heat::heat;
pub(crate) use motion::motion;
