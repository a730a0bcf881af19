//! The tests of `osim_model::feet` from outside, in one program: each that is linked takes a second.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    missing_docs,
    reason = "a test fails by panicking, and has a name that says what it is about"
)]

mod bones;
mod given;
mod levelled;
mod meshes;
mod planes;
mod pose;
mod scene;
mod soles;
mod standing;
