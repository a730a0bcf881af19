//! The integration tests of `contact-plots`, as one program, because linking each program takes a second.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

#[allow(dead_code, reason = "tests/plots.rs of the project has it, too")]
mod document;
mod figures;
mod layout;
mod png_pdf;
mod scene;
