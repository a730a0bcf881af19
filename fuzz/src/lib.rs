//! What must hold for every file, as functions that panic where it does not.
//!
//! Each target of cargo-fuzz calls one of them. Files that are refused are fine: a refusal is a [`Fault`], and its text
//! is rendered here too. Only panics, endless loops and broken promises are findings.

mod checks;
mod mesh;
mod mutate;
mod page;
mod request;

pub use checks::{edits, inspect, no_edit, roundtrip, scan};
pub use mesh::mesh;
pub use mutate::mutate;
pub use page::{files, verbs};

use osim_model::Fault;

/// A fault has to be printable; nothing more is asked of it.
fn accept(fault: &Fault) {
    let text = fault.to_string();
    assert!(!text.is_empty() && !fault.code().is_empty());
}
