//! Tests of the texts of the crate, on models of the project's fixtures.

#![allow(clippy::disallowed_methods, reason = "tests cut their own texts")]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

mod explained;
mod missing_facts;
mod records;
mod registers;
mod remedies;
mod support;
mod tables;
