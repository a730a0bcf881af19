//! The file as text: a flat tree of exact byte spans over the untouched bytes.
//!
//! Nothing here knows what OpenSim is. [`scan`] cuts the bytes into gap-free [`Piece`]s, links them into
//! elements, and refuses what is not one well-formed document; [`value`] reads the text of a leaf.

mod plain;
mod position;
mod scan;
mod tree;
pub(crate) mod value;

pub use position::{LineIndex, Position};
pub use tree::{Children, Element, ElementId, Piece, PieceKind, Tree};

pub(crate) use scan::scan;
