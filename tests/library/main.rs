//! Many models in one run: no file is incomplete or lost, and no change is applied twice.
//!
//! `killed.rs` kills runs at any moment; the other files test full disks, odd files, Ctrl-C, leftover files and earlier runs.

#![cfg(unix)]
#![allow(clippy::disallowed_methods, reason = "tests cut their own texts")]
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::print_stderr,
    reason = "a test fails by panicking and says aloud what it skips"
)]

mod concurrent_saves;
mod file_access;
mod full_disk;
mod interrupted;
mod killed;
mod leftover_files;
mod memory;
mod model_folder;
mod odd_files;
mod resume;
mod shares;
#[path = "../command/support.rs"]
#[allow(dead_code, reason = "shared with the tests of the command, which use all of it")]
mod support;
mod sweep_parts;
mod sweep_resume;
mod two_runs;
