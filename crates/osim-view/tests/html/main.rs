//! Tests of pages and figures, on models of the project's fixtures.

#![allow(clippy::disallowed_methods, reason = "tests cut their own texts")]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

mod figures;
mod pages;
#[path = "../report/support.rs"]
mod support;
