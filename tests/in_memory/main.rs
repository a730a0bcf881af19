//! Every verb without a disk and without a terminal, as a page in a browser does it: a request in JSON, files in a map, and
//! the libraries. What comes of it is what the command prints and writes for the same files.
//!
//! Only `osim-model`, `osim-patch`, `osim-inspect`, `osim-requests`, `osim-view` and `contact-plots` are used here. Each
//! expected value is the command's: both are to be one logic behind two front ends.

#![allow(clippy::disallowed_methods, reason = "tests cut their own texts")]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

mod before_after;
mod changes;
mod engine;
mod findings;
mod front_end;
mod inspections;
mod pages;
mod pictures;
mod results;
mod rows;
#[path = "../command/support.rs"]
#[allow(dead_code, reason = "shared with the tests of the command, which use all of it")]
mod support;
mod variants;
