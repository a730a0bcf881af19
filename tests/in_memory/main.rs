//! Runs every verb without a disk and without a terminal, as a page in a browser does: with a request in JSON, files in a map, and the
//! libraries. The results must equal the output and files of the command.
//!
//! The tests use only `osim-model`, `osim-patch`, `osim-inspect`, `osim-requests`, `osim-view` and `contact-plots`. All expected values
//! come from the command, because both front ends use the same libraries.

#![allow(clippy::disallowed_methods, reason = "tests cut their own texts")]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

mod batch;
mod before_after;
mod calculations;
mod changes;
mod engine;
mod findings;
mod front_end;
mod inspections;
mod plots;
#[path = "../command/support.rs"]
#[allow(dead_code, reason = "shared with the tests of the command, which use all of it")]
mod support;
mod sweep;
