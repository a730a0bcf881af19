//! Figures of contact forces: series of points in, SVG text out, and PDF and PNG from that; or letters for a terminal
//! ([`text()`]).
//!
//! It computes no physics and reads no file. Callers bring the points ([`ForceCurves`], [`DropCurve`],
//! [`HeatMap`], …) and get a [`Drawing`], whose curves can be renamed and axes limited; what it draws is one SVG document as a
//! `String`.
//!
//! ```
//! use contact_plots::{Drawing, ForceAxis, ForceCurves, ForceFigure, IndentationAxis, Paper, force_figure};
//!
//! let hertz = (0..=40).map(|i| f64::from(i) / 100.0).map(|x| (x, 482.7 * x * x.sqrt())).collect();
//! let figure = force_figure(&ForceFigure {
//!     title: "Contact force of one sphere".to_owned(),
//!     indentation: IndentationAxis::Relative,
//!     force: ForceAxis::Newton,
//!     top: None,
//!     bodies: vec![ForceCurves { name: "human".to_owned(), hertz, with_constant: vec![], own: vec![], rest: None, remark: String::new() }],
//!     limits: vec![],
//! })?;
//! let svg = Drawing::Panels(figure).svg(Paper::default())?;
//! assert!(svg.starts_with("<svg") && svg.contains("<title>Contact force of one sphere</title>"));
//! # Ok::<(), contact_plots::PlotError>(())
//! ```
//!
//! # What a figure promises
//!
//! - It is drawn for a paper: 90 mm wide (one column) or 190 mm (the page), text of 7 and 8 pt in Arial or a font of the
//!   same metrics, unless [`Paper`] says otherwise. The size is in its `width` and `height`; a page may override it, the
//!   `viewBox` scales.
//! - Curves differ in dash as well as in colour, colours are those of Okabe and Ito, heat maps are viridis: readable
//!   without colour vision and in grey. The background is white.
//! - It has `role="img"`, a `<title>` and a `<desc>`, and no `id`: several stand inline in one page without a clash.
//! - Points that are not finite are refused ([`PlotError`]), never drawn somewhere.
//!
//! # Limitations
//!
//! Texts are placed by the widths of Arial's letters; where a viewer has neither Arial nor a font of the same widths, and its
//! own is more than 6 % wider, names may come closer to each other than they should. PDF and PNG bring their font along.

#![cfg_attr(not(test), deny(clippy::disallowed_methods))]
#![warn(missing_docs)]

mod axis;
mod document;
mod draw;
mod drawing;
mod error;
mod figure;
mod heat_map;
mod kinds;
mod legend;
mod letters;
#[cfg(any(feature = "pdf", feature = "png"))]
mod pictures;
mod scene;
mod style;
mod text;

pub use axis::Axis;
pub use document::Paper;
pub use draw::figure;
pub use drawing::{Datum, Drawing};
pub use error::PlotError;
pub use figure::{Area, Curve, Direction, Figure, Limit, Mark, Panel, Point, Width};
pub use heat_map::{HeatLimit, HeatMap, heat_map};
pub use kinds::{
    DropCurve, DropEnd, DropFigure, ForceAxis, ForceCurves, ForceFigure, IndentationAxis, LoopCurve,
    LoopFigure, StateCurve, StateFigure, TimeAxis, drop_figure, drop_panel, force_figure, force_panel,
    loop_figure, state_figure, state_panel,
};
#[cfg(feature = "pdf")]
pub use pictures::pdf;
#[cfg(feature = "png")]
pub use pictures::png;
pub use scene::{Ball, Block, Level, LevelKind, Outline, Scene, SceneNames, Spot, State, View, scene};
pub use style::{Dash, Look};
pub use text::text;
