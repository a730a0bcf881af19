//! The command from outside: what it prints, what it writes and what it leaves alone.
//!
//! Layout and wording are snapshots in `tests/snapshots`; bytes and numbers are plain assertions. Each test works in a
//! folder of its own that holds copies of fixtures.

#![allow(clippy::disallowed_methods, reason = "tests cut their own texts")]
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::print_stderr,
    reason = "a test fails by panicking and says aloud what it skips"
)]

mod add_slips;
mod added;
mod advised;
mod afterwards;
mod bad_input;
mod batch;
mod bytes;
mod checked;
mod checked_sides;
mod contract;
mod converted;
mod corpus;
mod explained;
mod figures;
mod files;
mod floors;
mod followed_size;
mod html;
mod inspected;
mod json;
mod laid;
#[cfg(unix)]
mod lines;
mod masses;
mod meant;
mod never_lost;
mod outside_text;
mod pages;
mod placed;
mod received;
mod reproduced;
mod requested;
mod scaled_bodies;
mod schemas;
#[cfg(unix)]
mod screen;
mod shells;
mod shown;
mod slips;
mod summaries;
mod support;
mod sweep;
mod traced;
mod transfers;
mod workbooks;
mod zero_constant;
