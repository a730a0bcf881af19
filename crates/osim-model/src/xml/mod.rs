//! XML as a flat tree of exact byte spans over the untouched bytes.
//!
//! Nothing here knows what is in a model. [`Tree::scan`] cuts the bytes into gap-free [`Piece`]s, links them into elements, and
//! refuses what is not one well-formed document; [`RawText`] is the text of a leaf, and [`opensim_text`] knows what OpenSim reads
//! from it.
//!
//! ```
//! use osim_model::xml::{ElementId, Tree};
//!
//! fn main() {
//!     let tree = Tree::scan("<a><b>  1e6 </b></a>").expect("it is well formed");
//!     let b = tree.child(ElementId::ROOT, "b").expect("there is a <b>");
//!     let text = tree.raw_text(b);
//!     assert_eq!((text.text.as_str(), text.span), ("1e6", 8..11));
//! }
//! ```
//!
//! # What it will not do
//!
//! It decodes and encodes nothing as a whole, knows no namespaces and no DTD, and reads no other file.

pub mod opensim_text;
mod plain_scan;
mod position;
mod raw_text;
mod scan;
mod tree;

pub use position::{LineIndex, Position};
pub use raw_text::RawText;
pub use scan::{SyntaxError, SyntaxFault};
pub use tree::{Children, ElementId, Piece, PieceKind, Tree};
