//! XML as a flat tree of elements. Each element knows its exact bytes in the file, which are never changed.
//!
//! This module knows nothing about models. [`Tree::scan`] cuts the bytes into [`Piece`]s without gaps, connects these into elements, and
//! refuses bytes that are not one well-formed document. [`RawText`] is the text of an element without child elements, and [`opensim_text`]
//! reads values from such texts as OpenSim does.
//!
//! ```
//! use osim_model::xml::{ElementId, Tree};
//!
//! fn main() {
//!     let tree = Tree::scan("<a><b>  1e6 </b></a>").expect("it is well formed");
//!     let b = tree.child(ElementId::ROOT, "b").expect("there is a <b>");
//!     let text = tree.raw_text(b);
//!     assert_eq!((&*text.text, text.span), ("1e6", 8..11));
//! }
//! ```
//!
//! # What it will not do
//!
//! This module decodes and encodes no document as a whole, supports no namespaces and no DTD, and reads no other file.

mod line_index;
pub mod opensim_text;
mod plain_scan;
mod raw_text;
mod scan;
mod tree;

pub use line_index::{LineIndex, TextPosition};
pub use raw_text::RawText;
pub use scan::{SyntaxError, SyntaxFault};
pub use tree::{Children, ElementId, Piece, PieceKind, Tree};
