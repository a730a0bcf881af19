//! The file as text: a flat tree of exact byte spans over the untouched bytes.
//!
//! Nothing here knows what OpenSim is. [`scan`] cuts the bytes into gap-free [`Piece`]s, links them into elements, and
//! refuses what is not one well-formed document; [`RawText`] is the text of a leaf.

mod decode;
mod file_text;
mod plain;
mod position;
mod raw_text;
mod scan;
mod syntax;
mod tree;

pub use position::{LineIndex, Position};
pub use raw_text::RawText;
pub use syntax::SyntaxFault;
pub use tree::{Children, ElementId, Piece, PieceKind, Tree};

pub(crate) use scan::scan;
pub(crate) use syntax::SyntaxError;
