//! The integration tests of `osim-patch`, as one program, because linking each program takes a second.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

mod changed_since;
mod choices;
mod consequences;
mod convert;
mod dialect;
mod edits;
mod extreme_numbers;
mod given;
mod notes;
mod objects;
mod pairs;
mod plan;
mod refusals;
mod round_trip;
mod standing;
