//! The kinds of figures: what a contact does, from points somebody else computed.

mod drops;
mod force;
mod loops;
mod parts;
mod state;
mod units;

pub use drops::{DropCurve, DropEnd, DropFigure, drop_figure, drop_panel};
pub use force::{ForceCurves, ForceFigure, force_figure, force_panel};
pub use loops::{LoopCurve, LoopFigure, loop_figure};
pub use state::{StateCurve, StateFigure, state_figure, state_panel};
pub use units::{ForceAxis, IndentationAxis, TimeAxis};
