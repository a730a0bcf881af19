//! Runs `plot` and tests the written files, the content of figures, and refusals.
//!
//! Expected numbers come from `tests/plots/reference.py` (mpmath 1.3.0, and its own Runge–Kutta method).

#![allow(clippy::disallowed_methods, reason = "tests cut their own texts")]
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::print_stderr,
    reason = "a test fails by panicking and says aloud what it skips"
)]

#[path = "../crates/contact-plots/tests/plots/document/mod.rs"]
#[allow(dead_code, reason = "the tests of contact-plots have it, too")]
mod document;
#[path = "plots/documentation.rs"]
mod documentation;
#[path = "plots/exports.rs"]
mod exports;
#[path = "plots/feet.rs"]
mod feet;
#[path = "plots/figures.rs"]
mod figures;
#[path = "plots/files.rs"]
mod files;
#[path = "command/support.rs"]
#[allow(dead_code, reason = "shared with the tests of the command, which use all of it")]
mod support;
