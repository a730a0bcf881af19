//! Figures of contact forces: series of points in, SVG text out, and PNG from that; or letters for a terminal ([`text()`]).
//!
//! It computes no physics and reads no file. Callers bring the points ([`ForceCurves`], [`DropCurve`],
//! [`HeatMap`], …); what comes back is one SVG document as a `String`.
//!
//! ```
//! use contact_plots::{ForceAxis, ForceCurves, ForceFigure, IndentationAxis, force_figure};
//!
//! let hertz = (0..=40).map(|i| f64::from(i) / 100.0).map(|x| (x, 482.7 * x * x.sqrt())).collect();
//! let svg = force_figure(&ForceFigure {
//!     title: "Contact force of one sphere".to_owned(),
//!     indentation: IndentationAxis::Relative,
//!     force: ForceAxis::Newton,
//!     bodies: vec![ForceCurves { name: "human".to_owned(), hertz, with_constant: vec![], own: vec![], rest: None }],
//!     limits: vec![],
//! })?;
//! assert!(svg.starts_with("<svg") && svg.contains("<title>Contact force of one sphere</title>"));
//! # Ok::<(), contact_plots::PlotError>(())
//! ```
//!
//! # What a figure promises
//!
//! - It is drawn for a paper: 90 mm wide (one column) or 190 mm (the page), text of 7 and 8 pt in Arial or a font of the
//!   same metrics. The size is in its `width` and `height`; a page may override it, the `viewBox` scales.
//! - Curves differ in dash as well as in colour, colours are those of Okabe and Ito, heat maps are viridis: readable
//!   without colour vision and in grey. The background is white.
//! - It has `role="img"`, a `<title>` and a `<desc>`, and no `id`: several stand inline in one page without a clash.
//! - Points that are not finite are refused ([`PlotError`]), never drawn somewhere.
//!
//! # Limitations
//!
//! The plotting library places text by estimated widths; very long names are cut with an ellipsis.

#![cfg_attr(not(test), deny(clippy::disallowed_methods))]

mod axis;
mod draw;
mod error;
mod figure;
mod heat_map;
mod kinds;
mod legend;
#[cfg(feature = "png")]
mod raster;
mod scene;
mod style;
mod svg;
mod text;

pub use axis::Axis;
pub use draw::figure;
pub use error::PlotError;
pub use figure::{Area, Curve, Direction, Figure, Limit, Mark, Panel, Point, Width};
pub use heat_map::{HeatLimit, HeatMap, heat_map};
pub use kinds::{
    DropCurve, DropFigure, ForceAxis, ForceCurves, ForceFigure, IndentationAxis, LoopCurve, LoopFigure,
    StateCurve, StateFigure, TimeAxis, drop_figure, drop_panel, force_figure, force_panel, loop_figure,
    state_figure, state_panel,
};
#[cfg(feature = "png")]
pub use raster::png;
pub use scene::{Ball, Block, Level, LevelKind, Outline, Scene, SceneNames, Spot, State, View, scene};
pub use style::{Dash, Look};
pub use text::text;
