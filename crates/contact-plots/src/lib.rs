//! Figures of contact forces: series of points in, SVG text out, and PDF and PNG from that; or letters for a terminal
//! ([`text()`]).
//!
//! It computes no physics and reads no file. Callers bring the points, in [`Panel`]s, a [`HeatMap`] or a [`Scene`], and get a
//! [`Drawing`], whose curves can be renamed and axes limited; what it draws is one SVG document as a `String`.
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
