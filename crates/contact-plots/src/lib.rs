//! Figures of contact forces: from series of points to SVG text, and from this to PDF and PNG; or to letters for a terminal
//! ([`text()`]).
//!
//! This crate computes no physics and reads no file. The caller puts points into [`Panel`]s, a [`HeatMap`] or a [`Scene`], and
//! these into a [`Drawing`]. The curves of a drawing can be renamed and its axes limited. The result is one SVG document as a
//! `String`.
//!
//! ```
//! use contact_plots::{Axis, Curve, Drawing, Figure, Limit, Look, Panel, Paper};
//!
//! let hertz = (0..=40).map(|i| f64::from(i) / 100.0).map(|x| (x, 482.7 * x * x.sqrt())).collect();
//! let mut panel = Panel::new("", Axis::new("relative indentation x/R (–)"), Axis::new("force (N)"));
//! panel.curves.push(Curve::new("Hertz", hertz, Look::HERTZ));
//! panel.limits.push(Limit::vertical("x/R = 0.16", 0.16));
//! let description = "Force against indentation of one sphere.".to_owned();
//! let figure = Figure::in_column("Contact force of one sphere", description, vec![panel]);
//! let svg = Drawing::Panels(figure).svg(Paper::default())?;
//! assert!(svg.starts_with("<svg") && svg.contains("<title>Contact force of one sphere</title>"));
//! # Ok::<(), contact_plots::PlotError>(())
//! ```
//!
//! # What a figure promises
//!
//! - The SVG has a size on paper: 90 mm wide (one column) or 190 mm (the page), with text of 7 and 8 pt in Arial or a font of the
//!   same metrics, unless [`Paper`] gives another size. The size is in `width` and `height` of the SVG; a page may override it,
//!   and the `viewBox` scales.
//! - Curves differ in dash as well as in colour. Their colours are those of Okabe and Ito, and heat maps have the colours
//!   viridis: figures are readable without colour vision and in grey. The background is white.
//! - The SVG has `role="img"`, a `<title>` and a `<desc>`, and no `id`: several figures can be inline in one page without a
//!   conflict.
//! - Points that are not finite are refused ([`PlotError`]).
//!
//! # Limitations
//!
//! Texts are placed by the widths of Arial's letters. If a viewer has neither Arial nor a font of the same widths, and its own
//! font is more than 6 % wider, names may touch. PDF and PNG contain their font.

#![cfg_attr(not(test), deny(clippy::disallowed_methods))]
#![warn(missing_docs)]

mod axis;
mod document;
mod drawing;
mod error;
mod figure;
mod heat_map;
mod legend;
mod panels_svg;
#[cfg(any(feature = "pdf", feature = "png"))]
mod png_pdf;
mod scene;
mod style;
mod terminal_text;
mod text_width;

pub use axis::Axis;
pub use document::Paper;
pub use drawing::{Datum, Drawing};
pub use error::PlotError;
pub use figure::{Area, Curve, Direction, Figure, Limit, Mark, Panel, Point, Width};
pub use heat_map::{HeatLimit, HeatMap, heat_map};
pub use panels_svg::figure;
#[cfg(feature = "pdf")]
pub use png_pdf::pdf;
#[cfg(feature = "png")]
pub use png_pdf::png;
pub use scene::{Ball, Block, Level, LevelKind, Outline, Scene, SceneNames, Spot, State, View, scene};
pub use style::{Dash, Look};
pub use terminal_text::text;
