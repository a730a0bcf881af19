//! The tests of `contact-plots` from outside, in one program: each that is linked takes a second.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

#[allow(dead_code, reason = "tests/plots.rs of the project has it, too")]
mod document;
mod figures;
mod layout;
mod png_pdf;
mod scene;
