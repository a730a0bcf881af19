//! Many models in one run: nothing is torn, nothing is lost, nothing is done twice.
//!
//! `killed.rs` ends runs at any moment; the others meet full disks, odd files, Ctrl-C, leftovers and earlier runs.

#![cfg(unix)]
#![allow(clippy::disallowed_methods, reason = "tests cut their own texts")]
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::print_stderr,
    reason = "a test fails by panicking and says aloud what it skips"
)]

mod file_access;
mod full;
mod killed;
mod left_over;
mod library;
mod memory;
mod odd_files;
mod resumed;
mod saved_and_killed;
mod shares;
mod stopped;
#[path = "../command/support.rs"]
#[allow(dead_code, reason = "shared with the tests of the command, which use all of it")]
mod support;
mod sweeps;
mod sweeps_in_parts;
